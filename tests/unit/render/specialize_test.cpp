#include <gtest/gtest.h>

#include "render/trace_pipeline.h"
#include "shader/tiny_scene.h"
#include "shared/effects.h"

namespace vernier {
namespace {

DeviceDescription llvmpipe() {
  DeviceDescription device;
  device.is_llvmpipe = true;
  return device;
}

TEST(Specialize, the_path_stack_holds_what_can_wait) {
  const auto stack = [](std::uint32_t effects, std::uint32_t bounces) {
    return specialize(effects, {5}, bounces, false, {}).path_stack;
  };
  constexpr std::uint32_t kBoth = EFFECT_REFLECTION | EFFECT_REFRACTION;
  EXPECT_EQ(stack(0, 8), 0u);
  EXPECT_EQ(stack(EFFECT_REFLECTION, 8), 0u) << "one ray follows another";
  EXPECT_EQ(stack(kBoth, 8), 8u);
  EXPECT_EQ(stack(EFFECT_REFLECTION | EFFECT_ALPHA_BLEND, 8), 8u);
  EXPECT_EQ(stack(kBoth | EFFECT_ALPHA_MASK, 8), 16u);
  EXPECT_EQ(stack(kBoth, 0), 0u);
  EXPECT_EQ(stack(kBoth, 0xffffffffu), 64u);
}

TEST(Specialize, a_shifted_traversal_stack_has_the_depth_and_an_array_the_next_multiple_of_16) {
  EXPECT_EQ(specialize(0, {17}, 8, false, llvmpipe()).traversal_stack, 17u);
  EXPECT_EQ(specialize(0, {0}, 8, false, llvmpipe()).traversal_stack, 1u);
  EXPECT_EQ(specialize(0, {0}, 8, false, {}).traversal_stack, 16u);
  EXPECT_EQ(specialize(0, {16}, 8, false, {}).traversal_stack, 16u);
  EXPECT_EQ(specialize(0, {17}, 8, false, {}).traversal_stack, 32u);
}

TEST(Specialize, llvmpipe_shifts_shallow_stacks) {
  EXPECT_FALSE(specialize(0, {10}, 8, false, {}).shift_stack);
  EXPECT_TRUE(specialize(0, {10}, 8, false, llvmpipe()).shift_stack);
  EXPECT_FALSE(specialize(0, {60}, 8, false, llvmpipe()).shift_stack);
}

TEST(Specialize, a_form_that_is_asked_for_is_taken) {
  const auto shifts = [](TraversalForm form, std::uint32_t depth) {
    return specialize(0, {depth}, 8, false, llvmpipe(), form).shift_stack;
  };
  EXPECT_FALSE(shifts(TraversalForm::texels_array, 10));
  EXPECT_TRUE(shifts(TraversalForm::storage_shifted, 10));
  EXPECT_FALSE(shifts(TraversalForm::storage_shifted, 60)) << "more than there are variables";
  EXPECT_EQ(choose_scene_loads(llvmpipe()), SceneLoads::texels);
  EXPECT_EQ(choose_scene_loads({}), SceneLoads::storage);
  EXPECT_EQ(choose_scene_loads(llvmpipe(), TraversalForm::storage_array), SceneLoads::storage);
  EXPECT_EQ(choose_scene_loads({}, TraversalForm::texels_shifted), SceneLoads::texels);
}

TEST(Specialize, texel_forms_are_refused_where_lanes_cannot_vote_or_texel_buffers_are_few) {
  DeviceDescription device;
  device.name = "a small one";
  require_loads(device, SceneLoads::storage);
  const auto refusal = [&]() -> std::string {
    try {
      require_loads(device, SceneLoads::texels);
      return "";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::refused);
      return error.what();
    }
  };
  device.max_storage_texel_buffers = 9;
  EXPECT_NE(refusal().find("a small one: no ballots"), std::string::npos) << refusal();
  device.subgroup_ballot = true;
  EXPECT_EQ(refusal(), "");
  device.max_storage_texel_buffers = 8;
  EXPECT_NE(refusal().find("a small one: 8 storage texel buffers"), std::string::npos) << refusal();
}

TEST(Specialize, ray_queries_are_refused_where_the_driver_has_none) {
  DeviceDescription device;
  device.name = "a small one";
  EXPECT_EQ(choose_scene_loads(device, TraversalForm::ray_query), SceneLoads::queries);
  EXPECT_EQ(choose_scene_loads(llvmpipe(), TraversalForm::ray_query), SceneLoads::queries);
  EXPECT_THROW(require_loads(device, SceneLoads::queries), Error);
  device.ray_query = true;
  require_loads(device, SceneLoads::queries);
}

TEST(Specialize, what_the_scene_s_materials_are_is_known) {
  Scene scene = test::tiny_scene();
  const auto workflows = [&] { return shape_of(pack_scene(scene, 1)).workflows; };
  for (Material& material : scene.materials) material.workflow = Workflow::blinn;
  EXPECT_EQ(workflows(), 1u << WORKFLOW_BLINN);
  scene.materials.back().workflow = Workflow::specular_glossiness;
  EXPECT_EQ(workflows(), 1u << WORKFLOW_BLINN | 1u << WORKFLOW_SPECULAR_GLOSSINESS);
  EXPECT_EQ(specialize(0, {3, false, false, 5u}, 1, false, {}).workflows, 5u);
  EXPECT_EQ(specialize(0, {3}, 1, false, {}).workflows, ALL_WORKFLOWS);
}

TEST(Specialize, a_coarse_scene_is_known) {
  EXPECT_TRUE(shape_of(pack_scene(test::tiny_scene(), 1)).coarse);
  EXPECT_TRUE(specialize(0, {3, false, true}, 1, false, {}).coarse);
  EXPECT_FALSE(specialize(0, {3}, 1, false, {}).coarse);
}

TEST(Specialize, effects_and_cost_pass_through) {
  const TraceSpecialization values = specialize(0x1234u, {3}, 1, true, {});
  EXPECT_EQ(values.effects, 0x1234u);
  EXPECT_TRUE(values.count_cost);
}

}  // namespace
}  // namespace vernier
