#include "render/gpu_scene.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "bvh/box.h"
#include "bvh/decode_record.h"
#include "shared/bindings.h"
#include "shared/material_layout.h"

namespace vernier {
namespace {

// Share of the distance between a ray's origin and a box by which its sides are moved outwards for a driver's test, of
// whose roundings nobody tells: 32 half ulps, where our own box and triangle tests have 20 (intersect_box.glsl).
constexpr float kDriverPadding = 0x1p-19f;

template <typename Elements>
Buffer uploaded(const Device& device, const Elements& elements, BufferUse use) {
  const auto bytes = std::as_bytes(std::span(elements));
  Buffer buffer(device, bytes.size(), use);
  if (!bytes.empty()) buffer.upload(device, bytes);
  return buffer;
}

/// How far from the origin of the traced space rays start, along any axis, as a power of two, so that a camera that
/// moves seldom asks for another tree.
float ray_reach(const RenderConstants& constants, const SteeringConstants& steering) {
  glm::vec3 reach = glm::abs(constants.camera_origin);
  if (steering.orthographic != 0) reach += glm::abs(constants.camera_right) + glm::abs(constants.camera_up);
  // Rays that go on start on the scene, which lies in [-1, 1].
  const float farthest = std::max({reach.x, reach.y, reach.z, 1.0f});
  return std::exp2(std::ceil(std::log2(farthest)));
}

}  // namespace

DriverTree driver_tree(const Device& device, std::span<const BvhRecord> records, float reach) {
  std::vector<DeviceBox> boxes;
  boxes.reserve(records.size());
  glm::vec3 extent(0.0f);
  for (const BvhRecord& record : records) {
    const Box box = triangle_bounds(decode_triangle(record));
    extent = glm::max(extent, glm::max(glm::abs(box.lo), glm::abs(box.hi)));
    boxes.push_back({box.lo, box.hi});
  }
  const float padding = kDriverPadding * (reach + std::max({extent.x, extent.y, extent.z}));
  for (DeviceBox& box : boxes) box = {box.lo - padding, box.hi + padding};
  return DriverTree(device, boxes);
}

GpuScene::GpuScene(const Device& device, const PackedScene& packed, SceneLoads loads) : loads_(loads) {
  const bool texels = loads == SceneLoads::texels;
  const BufferUse wide = texels ? BufferUse::texels_rgba32ui : BufferUse::storage;
  const BufferUse narrow = texels ? BufferUse::texels_r32ui : BufferUse::storage;
  constants_ = Buffer(device, sizeof(RenderConstants), BufferUse::uniform);
  records_ = uploaded(device, packed.bvh.records, wide);
  vertices_ = uploaded(device, packed.vertices, wide);
  materials_ = uploaded(device, packed.materials, wide);
  lights_ = uploaded(device, packed.lights, wide);
  textures_ = uploaded(device, packed.textures, wide);
  texels_ = uploaded(device, packed.texels, wide);
  const std::size_t curve_words =
      std::min<std::size_t>(packed.texels.size(), SRGB_CURVE_WORDS);  // none: nothing is shaded
  if (texels) srgb_curve_ = uploaded(device, std::span(packed.texels).first(curve_words), narrow);
  first_triangles_ = uploaded(device, packed.first_triangles, narrow);
  instances_ = uploaded(device, packed.instances, wide);
}

std::vector<Binding> GpuScene::bindings() const {
  std::vector<Binding> bindings = {
      {BINDING_RENDER, &constants_},  {BINDING_RECORDS, &records_},     {BINDING_INSTANCES, &instances_},
      {BINDING_VERTICES, &vertices_}, {BINDING_MATERIALS, &materials_}, {BINDING_LIGHTS, &lights_},
      {BINDING_TEXTURES, &textures_}, {BINDING_TEXELS, &texels_},       {BINDING_FIRST_TRIANGLES, &first_triangles_}};
  if (loads_ == SceneLoads::texels) bindings.push_back({BINDING_SRGB_CURVE, &srgb_curve_});
  if (tree_) bindings.push_back({.binding = BINDING_BOX_TREE, .tree = &*tree_});
  return bindings;
}

std::uint64_t GpuScene::size_bytes() const {
  std::uint64_t sum = 0;
  for (const Binding& binding : bindings()) {
    sum += binding.tree != nullptr ? binding.tree->size_bytes() : binding.buffer->size_bytes();
  }
  return sum;
}

void GpuScene::set_textures(const Device& device, const std::vector<std::uint32_t>& words) {
  textures_.upload(device, std::as_bytes(std::span(words)));
}

void GpuScene::set_constants(const Device& device, const RenderConstants& constants,
                             const SteeringConstants& steering) {
  steering_ = steering;
  constants_.upload(device, std::as_bytes(std::span(&constants, 1)));
  if (loads_ != SceneLoads::queries) return;
  const float reach = ray_reach(constants, steering);
  if (!tree_ || reach > tree_reach_) build_tree(device, reach);
}

void GpuScene::build_tree(const Device& device, float reach) {
  std::vector<BvhRecord> records(steering_.triangle_count);
  records_.download(device, std::as_writable_bytes(std::span(records)));
  tree_.reset();  // its memory is needed
  tree_.emplace(driver_tree(device, records, reach));
  tree_reach_ = reach;
}

void GpuScene::set_lights(const Device& device, const std::vector<std::uint32_t>& lights) {
  lights_.upload(device, std::as_bytes(std::span(lights)));
}

}  // namespace vernier
