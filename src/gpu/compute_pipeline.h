#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "gpu/buffer.h"
#include "gpu/device.h"
#include "gpu/driver_tree.h"

namespace vernier {

/// A buffer or a tree at a binding number of set 0. The descriptor type follows from the buffer's use.
struct Binding {
  std::uint32_t binding = 0;
  const Buffer* buffer = nullptr;
  bool as_texels = false;            ///< of a buffer with both uses: its texel view is bound
  const DriverTree* tree = nullptr;  ///< instead of a buffer
};

/// Value of a specialization constant; floats and bools travel as their bits.
struct SpecializationValue {
  std::uint32_t constant_id = 0;
  std::uint32_t value = 0;
};

/// A compute pipeline with its layout: set 0 and one push-constant block. Shares them with the device's store; movable.
class ComputePipeline {
 public:
  ComputePipeline() = default;
  /// Compiles `spirv` (entry point main; told apart by its address, so it stays where it is while the device is open),
  /// or takes what `device` compiled for the same before. `bindings` give set 0's numbers and types (the buffers bound
  /// later must have the same uses). Time spent is in compile_ms().
  ComputePipeline(const Device& device, std::span<const std::uint32_t> spirv, std::span<const Binding> bindings,
                  std::uint32_t push_constant_bytes, std::span<const SpecializationValue> specialization);

  double compile_ms() const { return compile_ms_; }
  /// The pipeline.
  const vk::raii::Pipeline& vk() const { return compiled_->pipeline; }
  /// Its layout.
  const vk::raii::PipelineLayout& layout() const { return compiled_->layout; }
  /// That of set 0.
  const vk::raii::DescriptorSetLayout& set_layout() const { return compiled_->set_layout; }

 private:
  std::shared_ptr<const CompiledPipeline> compiled_;
  double compile_ms_ = 0.0;
};

/// Buffers bound to a pipeline's set 0. Owns pool and set; the buffers outlive it.
class BindingSet {
 public:
  BindingSet() = default;
  /// Binds `bindings`, whose numbers and uses are those the pipeline was made with.
  BindingSet(const Device& device, const ComputePipeline& pipeline, std::span<const Binding> bindings);
  /// The descriptor set.
  vk::DescriptorSet vk() const { return set_; }

 private:
  vk::raii::DescriptorPool pool_{nullptr};
  vk::DescriptorSet set_;  // freed with its pool
};

}  // namespace vernier
