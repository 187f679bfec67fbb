#include "ray_query_tracer.h"

#include <cstring>
#include <ctime>

#include "render/traversal_form.h"
#include "spirv/ray_queries_storage.h"
#include "spirv/ray_queries_texels.h"

namespace vernier {
namespace {

using Usage = vk::BufferUsageFlagBits;

vk::DescriptorType ray_descriptor(bool texels) {
  return texels ? vk::DescriptorType::eStorageTexelBuffer : vk::DescriptorType::eStorageBuffer;
}

}  // namespace

RayQueryTracer::RayQueryTracer(const Device& device, const RawMesh& mesh, const RaySets& rays)
    : texels_(choose_scene_loads(device.description()) == SceneLoads::texels), device_(device) {
  build_bottom(mesh);
  build_top();
  const Usage usage = texels_ ? Usage::eStorageTexelBuffer : Usage::eStorageBuffer;
  answers_ = device_.make_buffer(kRayCount * sizeof(RatedAnswer), usage);
  for (const std::vector<RatedRay>& kind : rays) {
    rays_.push_back(device_.make_filled(std::as_bytes(std::span(kind)), usage));
  }
  make_layouts();
  closest_ = make_pipeline(false);
  any_ = make_pipeline(true);
  for (std::size_t kind = 0; kind < rays_.size(); ++kind) bind(kind);
}

RayQueryTracer::Structure RayQueryTracer::build(vk::AccelerationStructureTypeKHR type,
                                                const vk::AccelerationStructureGeometryKHR& geometry,
                                                std::uint32_t count) const {
  vk::AccelerationStructureBuildGeometryInfoKHR work(type, vk::BuildAccelerationStructureFlagBitsKHR::ePreferFastTrace);
  work.setGeometries(geometry);
  const vk::AccelerationStructureBuildSizesInfoKHR sizes =
      device_.vk().getAccelerationStructureBuildSizesKHR(vk::AccelerationStructureBuildTypeKHR::eDevice, work, count);
  Structure made;
  made.memory = device_.make_buffer(sizes.accelerationStructureSize, Usage::eAccelerationStructureStorageKHR);
  made.built = device_.vk().createAccelerationStructureKHR(
      vk::AccelerationStructureCreateInfoKHR({}, *made.memory.buffer, 0, sizes.accelerationStructureSize, type));
  // Scratch memory begins at a multiple of some 2^k, at most 256, that the driver asks for.
  constexpr std::size_t kMostAlignment = 256;
  const AddressedBuffer scratch = device_.make_buffer(sizes.buildScratchSize + kMostAlignment, Usage::eStorageBuffer);
  work.dstAccelerationStructure = *made.built;
  work.scratchData.deviceAddress = (scratch.address + kMostAlignment - 1) / kMostAlignment * kMostAlignment;
  const vk::AccelerationStructureBuildRangeInfoKHR range(count);
  device_.run([&](const vk::raii::CommandBuffer& commands) { commands.buildAccelerationStructuresKHR(work, &range); });
  return made;
}

void RayQueryTracer::build_bottom(const RawMesh& mesh) {
  const vk::BufferUsageFlags input = Usage::eAccelerationStructureBuildInputReadOnlyKHR;
  const AddressedBuffer positions = device_.make_filled(std::as_bytes(std::span(mesh.positions)), input);
  const AddressedBuffer corners = device_.make_filled(std::as_bytes(std::span(mesh.corners)), input);
  const vk::AccelerationStructureGeometryTrianglesDataKHR triangles(
      vk::Format::eR32G32B32Sfloat, positions.address, sizeof(glm::vec3),
      static_cast<std::uint32_t>(mesh.positions.size()) - 1, vk::IndexType::eUint32, corners.address);
  const vk::AccelerationStructureGeometryKHR geometry(vk::GeometryTypeKHR::eTriangles, triangles,
                                                      vk::GeometryFlagBitsKHR::eOpaque);
  bottom_ =
      build(vk::AccelerationStructureTypeKHR::eBottomLevel, geometry, static_cast<std::uint32_t>(mesh.corners.size()));
}

void RayQueryTracer::build_top() {
  constexpr std::uint32_t kAllRays = 0xff;
  vk::AccelerationStructureInstanceKHR instance;
  for (std::size_t axis = 0; axis < 3; ++axis) instance.transform.matrix[axis][axis] = 1.0f;
  instance.mask = kAllRays;
  instance.accelerationStructureReference = device_.vk().getAccelerationStructureAddressKHR(*bottom_.built);
  const AddressedBuffer instances =
      device_.make_filled(std::as_bytes(std::span(&instance, 1)), Usage::eAccelerationStructureBuildInputReadOnlyKHR);
  const vk::AccelerationStructureGeometryInstancesDataKHR placed(VK_FALSE, instances.address);
  const vk::AccelerationStructureGeometryKHR geometry(vk::GeometryTypeKHR::eInstances, placed,
                                                      vk::GeometryFlagBitsKHR::eOpaque);
  top_ = build(vk::AccelerationStructureTypeKHR::eTopLevel, geometry, 1);
}

void RayQueryTracer::make_layouts() {
  const auto stage = vk::ShaderStageFlagBits::eCompute;
  const std::array slots = {
      vk::DescriptorSetLayoutBinding(BINDING_RATED_RAYS, ray_descriptor(texels_), 1, stage),
      vk::DescriptorSetLayoutBinding(BINDING_RATED_ANSWERS, ray_descriptor(texels_), 1, stage),
      vk::DescriptorSetLayoutBinding(BINDING_RATED_SCENE, vk::DescriptorType::eAccelerationStructureKHR, 1, stage)};
  set_layout_ = device_.vk().createDescriptorSetLayout(vk::DescriptorSetLayoutCreateInfo({}, slots));
  layout_ = device_.vk().createPipelineLayout(vk::PipelineLayoutCreateInfo({}, *set_layout_));
  const auto sets = static_cast<std::uint32_t>(rays_.size());
  const std::array sizes = {vk::DescriptorPoolSize(ray_descriptor(texels_), 2 * sets),
                            vk::DescriptorPoolSize(vk::DescriptorType::eAccelerationStructureKHR, sets)};
  pool_ = device_.vk().createDescriptorPool(vk::DescriptorPoolCreateInfo({}, sets, sizes));
}

vk::raii::Pipeline RayQueryTracer::make_pipeline(bool any_hit) const {
  const std::span<const std::uint32_t> spirv = texels_ ? kRayQueriesTexelsSpirv : kRayQueriesStorageSpirv;
  const vk::raii::ShaderModule module =
      device_.vk().createShaderModule(vk::ShaderModuleCreateInfo({}, spirv.size_bytes(), spirv.data()));
  const vk::SpecializationMapEntry entry(RATED_ANY_HIT, 0, sizeof(vk::Bool32));
  const vk::Bool32 value = any_hit ? VK_TRUE : VK_FALSE;
  const vk::SpecializationInfo special(1, &entry, sizeof value, &value);
  const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module, "main", &special);
  return device_.vk().createComputePipeline(nullptr, vk::ComputePipelineCreateInfo({}, stage, *layout_));
}

void RayQueryTracer::bind(std::size_t kind) {
  const vk::DescriptorSetLayout layout = *set_layout_;
  const vk::Device device = *device_.vk();
  const auto& calls = *device_.vk().getDispatcher();
  sets_.push_back(device.allocateDescriptorSets(vk::DescriptorSetAllocateInfo(*pool_, layout), calls).front());
  const auto write_buffer = [&](std::uint32_t binding, const AddressedBuffer& buffer) {
    const vk::DescriptorBufferInfo whole(*buffer.buffer, 0, VK_WHOLE_SIZE);
    const vk::BufferView view = *buffer.view;
    vk::WriteDescriptorSet write(sets_.back(), binding, 0, 1, ray_descriptor(texels_));
    write.pBufferInfo = &whole;
    write.pTexelBufferView = &view;
    device_.vk().updateDescriptorSets(write, nullptr);
  };
  write_buffer(BINDING_RATED_RAYS, rays_[kind]);
  write_buffer(BINDING_RATED_ANSWERS, answers_);
  const vk::WriteDescriptorSetAccelerationStructureKHR scene(*top_.built);
  vk::WriteDescriptorSet write(sets_.back(), BINDING_RATED_SCENE, 0, 1, vk::DescriptorType::eAccelerationStructureKHR);
  write.pNext = &scene;
  device_.vk().updateDescriptorSets(write, nullptr);
}

PassTime RayQueryTracer::trace(RayKind kind) {
  const std::clock_t cpu_start = std::clock();
  const double seconds = device_.run([&](const vk::raii::CommandBuffer& commands) {
    commands.bindPipeline(vk::PipelineBindPoint::eCompute, *(kind == kShadow ? any_ : closest_));
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *layout_, 0, sets_[kind], nullptr);
    commands.dispatch(kRayCount / RATED_GROUP, 1, 1);
  });
  return {seconds, static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC};
}

std::vector<RatedAnswer> RayQueryTracer::answers(RayKind kind) {
  trace(kind);
  std::vector<RatedAnswer> found(kRayCount);
  std::memcpy(found.data(), answers_.mapped.data(), answers_.mapped.size());
  return found;
}

}  // namespace vernier
