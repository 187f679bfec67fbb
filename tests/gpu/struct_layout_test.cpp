#include "spirv/struct_layout.h"

#include <array>
#include <bit>
#include <cstring>
#include <numeric>
#include <set>

#include "device_test.h"
#include "gpu/buffer.h"
#include "gpu/compute_pipeline.h"
#include "gpu/submission.h"
#include "shared/instance_layout.h"
#include "shared/material_layout.h"
#include "shared/render_constants.h"

namespace vernier {
namespace {

using StructLayoutTest = DeviceTest;

struct Scene {
  DispatchConstants dispatch;
  DeviceMaterial material;
  DeviceTextureUse use;
  DeviceLight light;
  DeviceInstance instance;
};

/// A struct each of whose words is a float of its own, from `first` on.
template <typename Struct>
Struct numbered(std::uint32_t first) {
  std::array<float, sizeof(Struct) / 4> words;
  std::iota(words.begin(), words.end(), static_cast<float>(first));
  return std::bit_cast<Struct>(words);
}

/// What struct_layout.comp writes, by the same names.
std::vector<std::uint32_t> fields_on_host(const RenderConstants& render, const Scene& scene) {
  const auto& [dispatch, material, use, light, instance] = scene;
  std::vector<std::uint32_t> words;
#define WORD(field) words.push_back(field);
#define NUMBER(field) words.push_back(std::bit_cast<std::uint32_t>(field));
#define VEC(field) NUMBER(field.x) NUMBER(field.y) NUMBER(field.z)
#include "layout_fields.h"
#undef WORD
#undef NUMBER
#undef VEC
  return words;
}

TEST_F(StructLayoutTest, host_and_device_see_every_field_in_the_same_place) {
  const auto render = numbered<RenderConstants>(1000);
  const auto scene = numbered<Scene>(2000);
  const std::vector<std::uint32_t> expected = fields_on_host(render, scene);
  // No word of any struct is missing from the list, none stands twice.
  ASSERT_EQ(expected.size(), (sizeof(render) + sizeof(scene)) / 4);
  ASSERT_EQ(std::set(expected.begin(), expected.end()).size(), expected.size());

  Buffer uniform(device(), sizeof(render), BufferUse::uniform);
  uniform.upload(device(), std::as_bytes(std::span(&render, 1)));
  Buffer storage(device(), sizeof(scene), BufferUse::storage);
  storage.upload(device(), std::as_bytes(std::span(&scene, 1)));
  const Buffer words(device(), expected.size() * 4, BufferUse::storage);
  const std::array<Binding, 3> bindings{Binding{0, &uniform}, Binding{1, &storage}, Binding{2, &words}};
  const ComputePipeline pipeline(device(), kStructLayoutSpirv, bindings, 0, {});
  const BindingSet set(device(), pipeline, bindings);
  const Dispatch dispatch{&pipeline, &set, {}, 1, 1, 1};
  Submitter(device()).run({&dispatch, 1});
  std::vector<std::uint32_t> found(expected.size());
  words.download(device(), std::as_writable_bytes(std::span(found)));
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace vernier
