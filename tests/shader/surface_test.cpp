#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "shader/corner_attributes.h"
#include "shader/random_values.h"
#include "shader/shader.h"

namespace vernier::shader {
namespace {

DeviceMaterial with_normal_texture(float scale) {
  DeviceMaterial material{};
  material.textured_slots = 1u << TEXTURE_SLOT_NORMAL;
  material.normal_scale = scale;
  return material;
}

SlotTexels normal_texel(const vec3& rgb) {
  SlotTexels texels = no_slot_texels();
  texels.normal = vec4(rgb, 1);
  return texels;
}

/// The unit triangle's normal bent by a texel of value `rgb`.
vec3 bent(const Corners& corners, const vec3& rgb, float scale = 1.0f, std::uint32_t uv_set = 0) {
  Memory scene = memory_with(corners, plain_use(uv_set));
  const BoundMemory bound(scene);
  return bent_normal(unit_triangle_point(0.25f, 0.25f), with_normal_texture(scale), normal_texel(rgb), kUp);
}

vec4 frame_of(const Corners& corners, const DeviceTextureUse& use = plain_use(0)) {
  Memory scene = memory_with(corners);
  const BoundMemory bound(scene);
  return tangent_frame(unit_triangle_point(0.25f, 0.5f), kUp, use);
}

TEST(Surface, normals_turn_to_the_viewer_and_front_remembers_the_side) {
  Memory scene = memory_with({});
  const BoundMemory bound(scene);
  const TrianglePoint point = unit_triangle_point(0.25f, 0.25f);
  const auto seen_along = [&](const vec3& direction) {
    return surface_point(point, DeviceMaterial{}, no_slot_texels(), direction);
  };
  const SurfacePoint front = seen_along(vec3(0, 0, -1)), back = seen_along(vec3(0.6f, 0, 0.8f));
  EXPECT_TRUE(front.front);
  EXPECT_EQ(front.geometric_normal, kUp);
  EXPECT_EQ(front.normal, kUp);
  EXPECT_FALSE(back.front);
  EXPECT_EQ(back.geometric_normal, -kUp);
  EXPECT_EQ(back.normal, -kUp);
  EXPECT_TRUE(seen_along(vec3(1, 0, 0)).front) << "edge-on is no back";
  EXPECT_EQ(front.position, vec3(0.25f, 0.25f, 0));
  EXPECT_EQ(front.material, 7u);
}

TEST(Surface, the_geometric_normal_needs_no_size) {
  Memory scene = memory_with({});
  const BoundMemory bound(scene);
  for (const float size : {1e-30f, 1e-12f, 1.0f, 1e18f}) {
    TrianglePoint point = unit_triangle_point(0.25f, 0.25f);
    point.e1 *= size, point.e2 /= size;  // the product is 1: needles of any length
    const SurfacePoint surface = surface_point(point, DeviceMaterial{}, no_slot_texels(), vec3(0, 0, -1));
    expect_unit_near(surface.geometric_normal, kUp);
  }
}

TEST(Surface, a_mesh_s_tangents_are_made_square_to_the_normal) {
  Corners corners;
  corners.tangents = {vec4(1, 0, 0.5f, -1), vec4(1, 0, 0.5f, 1), vec4(1, 0, 0.5f, 1)};
  EXPECT_EQ(frame_of(corners), vec4(1, 0, 0, -1)) << "the handedness is corner 0's";
  corners.tangents[2].w = 0.0f;  // a corner without tangent: the frame comes from the UV set
  corners.uvs = {vec2(0, 0), vec2(0, 1), vec2(1, 0)};
  EXPECT_EQ(frame_of(corners), vec4(0, 1, 0, 1));
  corners.tangents.fill(vec4(0, 0, 1, 1));  // along the normal: none
  EXPECT_EQ(vec3(frame_of(corners)), vec3(0));
}

TEST(Surface, along_the_tangent_of_a_uv_set_u_grows_and_v_stays) {
  RandomValues random(6);
  for (int i = 0; i < 5000; ++i) {
    Corners corners;
    for (vec2& uv : corners.uvs) uv = vec2(random.in(-2, 2), random.in(-2, 2));
    const vec2 d1 = corners.uvs[1] - corners.uvs[0], d2 = corners.uvs[2] - corners.uvs[0];
    const double area = double(d1.x) * d2.y - double(d1.y) * d2.x;
    if (std::abs(area) < 0.01) continue;  // the direction is not determined well
    const vec4 frame = frame_of(corners);
    const glm::dvec3 t(frame);
    // t = (d2.v, -d1.v) made unit: three roundings of t, products with slopes of at most 4.
    ASSERT_NEAR(t.x * d1.y + t.y * d2.y, 0.0, 8 * 4 * 0x1p-24);
    ASSERT_GT(t.x * d1.x + t.y * d2.x, 0.0);
    ASSERT_EQ(frame.w, area > 0 ? -1.0f : 1.0f);
    // The bitangent cross(N, T) w points where v falls.
    const glm::dvec3 b = glm::cross(glm::dvec3(kUp), t) * double(frame.w);
    ASSERT_LT(b.x * d1.y + b.y * d2.y, 0.0);
  }
}

TEST(Surface, the_frame_takes_the_slot_s_own_uv_set) {
  Corners corners;
  corners.second_uvs = {vec2(0, 0), vec2(0, 1), vec2(1, 0)};
  EXPECT_EQ(frame_of(corners, plain_use(0)), vec4(1, 0, 0, -1));
  EXPECT_EQ(frame_of(corners, plain_use(1)), vec4(0, 1, 0, 1));
}

TEST(Surface, the_frame_is_that_of_the_image_as_it_is_looked_up) {
  DeviceTextureUse mirrored = plain_use(0);
  mirrored.m00 = -1;
  EXPECT_EQ(frame_of({}, mirrored), vec4(-1, 0, 0, 1));
  const DeviceTextureUse turned = {
      .texture = 0, .uv_set = 0, .m00 = 0, .m10 = -1, .m01 = 1, .m11 = 0, .m02 = 0, .m12 = 0};
  EXPECT_EQ(frame_of({}, turned), vec4(0, 1, 0, -1));
}

TEST(Surface, a_uv_set_without_area_or_that_is_not_there_gives_no_frame) {
  Corners corners;
  EXPECT_EQ(frame_of(corners, plain_use(2)), vec4(0));
  corners.uvs[2] = vec2(3, 0);
  EXPECT_EQ(frame_of(corners), vec4(0));
  for (const float odd : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    corners.uvs[2] = vec2(0, odd);
    EXPECT_EQ(frame_of(corners), vec4(0)) << odd;
  }
}

TEST(Surface, a_normal_texel_bends_towards_tangent_and_bitangent) {
  // T = +X; v points down in the picture, so B = -Y.
  EXPECT_EQ(bent({}, vec3(0.5f, 0.5f, 1)), kUp);
  EXPECT_EQ(bent({}, vec3(1, 0.5f, 0.5f)), vec3(1, 0, 0));
  EXPECT_EQ(bent({}, vec3(0.5f, 1, 0.5f)), vec3(0, -1, 0));
  expect_unit_near(bent({}, vec3(1, 0.5f, 1)), vec3(kHalfRoot, 0, kHalfRoot));
  expect_unit_near(bent({}, vec3(1, 1, 1)), vec3(1, -1, 1) / std::numbers::sqrt3_v<float>);
  EXPECT_EQ(bent({}, vec3(0.5f, 0.5f, 0)), -kUp) << "texels below the surface are taken as they are";
  EXPECT_EQ(bent({}, vec3(0.5f)), kUp) << "a zero vector is ignored";
}

TEST(Surface, the_normal_scale_tilts_and_spares_z) {
  expect_unit_near(bent({}, vec3(1, 0.5f, 1), 2.0f), vec3(2, 0, 1) / std::sqrt(5.0f));
  expect_unit_near(bent({}, vec3(1, 0.5f, 1), -1.0f), vec3(-kHalfRoot, 0, kHalfRoot));
  EXPECT_EQ(bent({}, vec3(1, 1, 1), 0.0f), kUp);
}

TEST(Surface, mirrored_uvs_mirror_the_slope) {
  Corners mirrored;
  mirrored.uvs[1] = vec2(-1, 0);
  expect_unit_near(bent(mirrored, vec3(1, 0.5f, 1)), vec3(-kHalfRoot, 0, kHalfRoot));
  expect_unit_near(bent(mirrored, vec3(0.5f, 1, 1)), vec3(0, -kHalfRoot, kHalfRoot));
}

TEST(Surface, without_texture_or_frame_the_normal_stays) {
  Memory scene = memory_with({});
  const BoundMemory bound(scene);
  const TrianglePoint point = unit_triangle_point(0.25f, 0.25f);
  EXPECT_EQ(bent_normal(point, DeviceMaterial{}, normal_texel(vec3(1, 0.5f, 0.5f)), kUp), kUp);
  EXPECT_EQ(bent({}, vec3(1, 0.5f, 0.5f), 1.0f, 2), kUp) << "UV set 2 is not there";
}

TEST(Surface, a_bent_normal_turns_to_the_viewer_with_the_side) {
  Memory scene = memory_with({});
  const BoundMemory bound(scene);
  const TrianglePoint point = unit_triangle_point(0.25f, 0.25f);
  const SlotTexels texels = normal_texel(vec3(1, 0.5f, 1));
  const auto normal_along = [&](const vec3& direction) {
    return surface_point(point, with_normal_texture(1), texels, direction).normal;
  };
  expect_unit_near(normal_along(vec3(0, 0, -1)), vec3(kHalfRoot, 0, kHalfRoot));
  EXPECT_EQ(normal_along(vec3(0, 0, 1)), -normal_along(vec3(0, 0, -1)));
  EFFECTS = ~EFFECT_NORMAL_TEXTURE;
  EXPECT_EQ(normal_along(vec3(0, 0, -1)), kUp);
  EFFECTS = 0xffffffffu;
}

/// Opacity of a material with base_color.a 0.5, a texel of `base_alpha` (ALPHA slot: `alpha`) and a vertex colour.
float alpha_of(std::uint32_t mode, std::uint32_t workflow, float base_alpha, float alpha, float color) {
  DeviceMaterial material{};
  material.base_color = vec4(1, 1, 1, 0.5f);
  material.alpha_cutoff = 0.25f;
  material.flags = workflow | mode << MATERIAL_ALPHA_SHIFT;
  SlotTexels texels = no_slot_texels();
  texels.base_color.w = base_alpha;
  texels.alpha.x = alpha;
  return surface_alpha(material, texels, vec4(1, 1, 1, color));
}

TEST(Surface, alpha_by_mode_and_workflow) {
  constexpr auto kMetal = WORKFLOW_METALLIC_ROUGHNESS, kBlinn = WORKFLOW_BLINN;
  EXPECT_EQ(alpha_of(ALPHA_OPAQUE, kMetal, 0, 0, 0), 1.0f);
  EXPECT_EQ(alpha_of(ALPHA_BLEND, kMetal, 0.5f, 0.125f, 1), 0.25f);
  EXPECT_EQ(alpha_of(ALPHA_BLEND, kBlinn, 0.5f, 0.125f, 1), 0.0625f) << "blinn reads map_d";
  EXPECT_EQ(alpha_of(ALPHA_BLEND, kMetal, 0.5f, 1, 0.5f), 0.125f) << "the vertex colour's alpha";
  EXPECT_EQ(alpha_of(ALPHA_BLEND, kMetal, 1, 1, 4), 1.0f);
  EXPECT_EQ(alpha_of(ALPHA_BLEND, kMetal, 1, 1, -1), 0.0f);
  EXPECT_EQ(alpha_of(ALPHA_MASK, kMetal, 0.5f, 1, 1), 1.0f) << "the cutoff itself is seen";
  EXPECT_EQ(alpha_of(ALPHA_MASK, kMetal, std::nextafter(0.5f, 0.0f), 1, 1), 0.0f);
}

}  // namespace
}  // namespace vernier::shader
