#include "render/gpu_scene.h"

#include <span>

#include "shared/bindings.h"

namespace vernier {
namespace {

template <typename Elements>
Buffer uploaded(const Device& device, const Elements& elements, BufferUse use) {
  const auto bytes = std::as_bytes(std::span(elements));
  Buffer buffer(device, bytes.size(), use);
  if (!bytes.empty()) buffer.upload(device, bytes);
  return buffer;
}

}  // namespace

GpuScene::GpuScene(const Device& device, const PackedScene& packed, SceneLoads loads) {
  const bool texels = loads == SceneLoads::texels;
  const BufferUse wide = texels ? BufferUse::texels_rgba32ui : BufferUse::storage;
  const BufferUse narrow = texels ? BufferUse::texels_r32ui : BufferUse::storage;
  constants_ = Buffer(device, sizeof(RenderConstants), BufferUse::uniform);
  records_ = uploaded(device, packed.bvh.records, wide);
  vertices_ = uploaded(device, packed.vertices, wide);
  materials_ = uploaded(device, packed.materials, wide);
  lights_ = uploaded(device, packed.lights, wide);
  textures_ = uploaded(device, packed.textures, wide);
  texels_ = uploaded(device, packed.texels, narrow);
  first_triangles_ = uploaded(device, packed.first_triangles, narrow);
  instances_ = uploaded(device, packed.instances, wide);
}

std::vector<Binding> GpuScene::bindings() const {
  return {
      {BINDING_RENDER, &constants_},  {BINDING_RECORDS, &records_},     {BINDING_INSTANCES, &instances_},
      {BINDING_VERTICES, &vertices_}, {BINDING_MATERIALS, &materials_}, {BINDING_LIGHTS, &lights_},
      {BINDING_TEXTURES, &textures_}, {BINDING_TEXELS, &texels_},       {BINDING_FIRST_TRIANGLES, &first_triangles_}};
}

std::uint64_t GpuScene::size_bytes() const {
  std::uint64_t sum = 0;
  for (const Binding& binding : bindings()) sum += binding.buffer->size_bytes();
  return sum;
}

void GpuScene::set_textures(const Device& device, const std::vector<std::uint32_t>& words) {
  textures_.upload(device, std::as_bytes(std::span(words)));
}

void GpuScene::set_constants(const Device& device, const RenderConstants& constants,
                             const SteeringConstants& steering) {
  steering_ = steering;
  constants_.upload(device, std::as_bytes(std::span(&constants, 1)));
}

void GpuScene::set_lights(const Device& device, const std::vector<std::uint32_t>& lights) {
  lights_.upload(device, std::as_bytes(std::span(lights)));
}

}  // namespace vernier
