#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "gpu/buffer.h"
#include "gpu/compute_pipeline.h"

namespace vernier {

/// One dispatch of a submission.
struct Dispatch {
  const ComputePipeline* pipeline = nullptr;
  const BindingSet* bindings = nullptr;
  std::vector<std::byte> push_constants;
  std::uint32_t group_count_x = 1;
  std::uint32_t group_count_y = 1;
  std::uint32_t group_count_z = 1;
};

/// What the host puts into a buffer on the device before the dispatches of a submission: from its start on, a multiple
/// of 4 and at most 65536 bytes.
struct Upload {
  const Buffer* buffer = nullptr;
  std::span<const std::byte> bytes;
};

/// What it takes from the start of one behind them: a multiple of 4 bytes.
struct Download {
  const Buffer* buffer = nullptr;
  std::span<std::byte> bytes;
};

/// What goes with the dispatches of a submission. Kernels read and count in the device's own memory that way: over the
/// bus of a graphics card each addition to a counter would take longer than a ray.
struct Exchange {
  std::vector<Upload> uploads;
  std::vector<Download> downloads;
};

/// What a finished submission took.
struct SubmissionTime {
  double device_ms = 0.0;  ///< by timestamps; the wall time where the device has none
  double wall_ms = 0.0;
};

/// Records and submits dispatches one after the other and waits for them. Owns command pool, fence and queries.
/// `device` outlives it and stays where it is.
class Submitter {
 public:
  /// Ready to run on `device`'s queue.
  explicit Submitter(const Device& device);
  const Device& device() const { return *device_; }
  Submitter(Submitter&&) = default;
  Submitter& operator=(Submitter&&) = delete;

  /// Runs `dispatches` in order, each seeing what the one before wrote, and the host what all wrote; the exchange is
  /// not in device_ms. Waits with a limit of `timeout_s` (0 asks once); a device that does not answer by then counts as
  /// lost. Throws Error(device_lost) on loss and from then on; a device on the CPU is first awaited to its end, for its
  /// threads still write to the buffers. Nothing to dispatch is allowed and takes almost no time.
  SubmissionTime run(std::span<const Dispatch> dispatches, const Exchange& exchange = {}, double timeout_s = 120.0);

 private:
  const Device* device_ = nullptr;
  vk::raii::CommandPool pool_{nullptr};
  vk::raii::CommandBuffer commands_{nullptr};
  vk::raii::Fence fence_{nullptr};
  vk::raii::QueryPool queries_{nullptr};
  Buffer downloaded_;  ///< for the host, as large as the largest exchange so far
  bool lost_ = false;
};

/// Records copies, fills and builds of trees by `record_work`, between barriers to everything before and after, submits
/// them on their own and waits. For work outside the render loop. Throws Error(device_lost) on loss.
void run_transfer(const Device& device, const std::function<void(const vk::raii::CommandBuffer&)>& record_work);

}  // namespace vernier
