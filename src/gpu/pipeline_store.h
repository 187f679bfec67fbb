#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

namespace vernier {

/// A compiled pipeline with the layouts it was made for.
struct CompiledPipeline {
  vk::raii::DescriptorSetLayout set_layout{nullptr};
  vk::raii::PipelineLayout layout{nullptr};
  vk::raii::Pipeline pipeline{nullptr};
};

/// The pipelines that a device compiled last, by what they are made of: an effect that is turned on again, or the next
/// case with the same kernel, finds its machine code. llvmpipe and SwiftShader keep theirs with the pipeline alone.
class PipelineStore {
 public:
  /// SPIR-V, bindings and constants as words; equal keys, equal pipelines.
  using Key = std::vector<std::uint64_t>;

  /// The pipeline of `key`: that of before, or what `make` returns. Those asked for least lately are let go beyond
  /// kMostPipelines. Any thread may call.
  std::shared_ptr<const CompiledPipeline> find_or_make(const Key& key, const std::function<CompiledPipeline()>& make);

  /// More than a window's switches or a sweep come back to; each holds the machine code of a kernel.
  static constexpr std::size_t kMostPipelines = 64;

 private:
  std::mutex mutex_;
  std::list<std::pair<Key, std::shared_ptr<const CompiledPipeline>>> pipelines_;  // the last asked for first
};

}  // namespace vernier
