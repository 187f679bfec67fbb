#include "gpu/compute_pipeline.h"

#include <chrono>

#include "gpu/vk_check.h"
#include "math/elapsed.h"

namespace vernier {
namespace {

vk::DescriptorType descriptor_type(const Binding& binding) {
  if (binding.tree != nullptr) return vk::DescriptorType::eAccelerationStructureKHR;
  switch (binding.buffer->use()) {
    case BufferUse::uniform:
      return vk::DescriptorType::eUniformBuffer;
    case BufferUse::texels_rgba32ui:
    case BufferUse::texels_r32ui:
      return vk::DescriptorType::eStorageTexelBuffer;
    case BufferUse::storage_and_texels:
      if (binding.as_texels) return vk::DescriptorType::eStorageTexelBuffer;
      break;
    case BufferUse::storage:
    case BufferUse::storage_host_visible:
    case BufferUse::tree_input:
    case BufferUse::tree_storage:
    case BufferUse::tree_scratch:
      break;
  }
  return vk::DescriptorType::eStorageBuffer;
}

vk::raii::DescriptorSetLayout create_set_layout(const Device& device, std::span<const Binding> bindings) {
  std::vector<vk::DescriptorSetLayoutBinding> slots;
  for (const Binding& binding : bindings) {
    slots.emplace_back(binding.binding, descriptor_type(binding), 1, vk::ShaderStageFlagBits::eCompute);
  }
  return device.vk().createDescriptorSetLayout(vk::DescriptorSetLayoutCreateInfo({}, slots));
}

vk::raii::PipelineLayout create_layout(const Device& device, const vk::DescriptorSetLayout& set_layout,
                                       std::uint32_t push_constant_bytes) {
  const vk::PushConstantRange push_constants(vk::ShaderStageFlagBits::eCompute, 0, push_constant_bytes);
  vk::PipelineLayoutCreateInfo create({}, set_layout);
  if (push_constant_bytes != 0) create.setPushConstantRanges(push_constants);
  return device.vk().createPipelineLayout(create);
}

void write_binding(const Device& device, vk::DescriptorSet set, const Binding& binding) {
  vk::WriteDescriptorSet write(set, binding.binding, 0, 1, descriptor_type(binding));
  if (binding.tree != nullptr) {
    const vk::WriteDescriptorSetAccelerationStructureKHR tree(*binding.tree->vk());
    write.pNext = &tree;
    device.vk().updateDescriptorSets(write, nullptr);
    return;
  }
  const vk::DescriptorBufferInfo whole(*binding.buffer->vk(), 0, VK_WHOLE_SIZE);
  const vk::BufferView view = *binding.buffer->view();
  write.pBufferInfo = &whole;
  write.pTexelBufferView = &view;
  device.vk().updateDescriptorSets(write, nullptr);
}

PipelineStore::Key key_of(std::span<const std::uint32_t> spirv, std::span<const Binding> bindings,
                          std::uint32_t push_constant_bytes, std::span<const SpecializationValue> specialization) {
  PipelineStore::Key key = {reinterpret_cast<std::uintptr_t>(spirv.data()), spirv.size(), push_constant_bytes,
                            bindings.size()};
  for (const Binding& binding : bindings) {
    key.insert(key.end(), {binding.binding, static_cast<std::uint64_t>(descriptor_type(binding))});
  }
  for (const SpecializationValue& constant : specialization) {
    key.insert(key.end(), {constant.constant_id, constant.value});
  }
  return key;
}

CompiledPipeline compile(const Device& device, std::span<const std::uint32_t> spirv, std::span<const Binding> bindings,
                         std::uint32_t push_constant_bytes, std::span<const SpecializationValue> specialization) {
  CompiledPipeline compiled;
  compiled.set_layout = create_set_layout(device, bindings);
  compiled.layout = create_layout(device, *compiled.set_layout, push_constant_bytes);
  const vk::raii::ShaderModule module =
      device.vk().createShaderModule(vk::ShaderModuleCreateInfo({}, spirv.size_bytes(), spirv.data()));
  std::vector<vk::SpecializationMapEntry> entries;
  std::vector<std::uint32_t> values;
  for (const SpecializationValue& constant : specialization) {
    entries.emplace_back(constant.constant_id, static_cast<std::uint32_t>(values.size() * sizeof(std::uint32_t)),
                         sizeof(std::uint32_t));
    values.push_back(constant.value);
  }
  const vk::SpecializationInfo special(static_cast<std::uint32_t>(entries.size()), entries.data(),
                                       values.size() * sizeof(std::uint32_t), values.data());
  const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module, "main", &special);
  compiled.pipeline = device.vk().createComputePipeline(device.pipeline_cache(),
                                                        vk::ComputePipelineCreateInfo({}, stage, *compiled.layout));
  return compiled;
}

}  // namespace

ComputePipeline::ComputePipeline(const Device& device, std::span<const std::uint32_t> spirv,
                                 std::span<const Binding> bindings, std::uint32_t push_constant_bytes,
                                 std::span<const SpecializationValue> specialization) {
  const auto start = std::chrono::steady_clock::now();
  compiled_ = device.pipelines().find_or_make(key_of(spirv, bindings, push_constant_bytes, specialization), [&] {
    return vk_check("compiling a shader",
                    [&] { return compile(device, spirv, bindings, push_constant_bytes, specialization); });
  });
  compile_ms_ = ms_since(start);
}

BindingSet::BindingSet(const Device& device, const ComputePipeline& pipeline, std::span<const Binding> bindings) {
  if (bindings.empty()) return;
  std::vector<vk::DescriptorPoolSize> sizes;
  for (const Binding& binding : bindings) sizes.emplace_back(descriptor_type(binding), 1);
  vk_check("binding buffers", [&] {
    pool_ = device.vk().createDescriptorPool(vk::DescriptorPoolCreateInfo({}, 1, sizes));
    const vk::DescriptorSetLayout layout = *pipeline.set_layout();
    const vk::DescriptorSetAllocateInfo allocate(*pool_, layout);
    set_ = (*device.vk()).allocateDescriptorSets(allocate, *device.vk().getDispatcher()).front();
    for (const Binding& binding : bindings) write_binding(device, set_, binding);
  });
}

}  // namespace vernier
