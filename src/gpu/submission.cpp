#include "gpu/submission.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>

#include "error.h"
#include "gpu/vk_check.h"
#include "math/elapsed.h"

namespace vernier {
namespace {

using Access = vk::AccessFlagBits;
using Stage = vk::PipelineStageFlagBits;

// What the caller frees next must not be in use any more. A GPU's driver notices a hang by itself within seconds; a
// driver on the CPU is never lost, only slow, and freeing what it still writes to would crash.
constexpr double kGraceSeconds = 10.0;
constexpr double kNoLimit = std::numeric_limits<double>::infinity();
constexpr double kTransferTimeoutSeconds = 120.0;
constexpr std::uint32_t kTimestampCount = 2;

void memory_barrier(const vk::raii::CommandBuffer& commands, vk::PipelineStageFlags from, vk::AccessFlags written,
                    vk::PipelineStageFlags to, vk::AccessFlags used) {
  commands.pipelineBarrier(from, to, {}, vk::MemoryBarrier(written, used), nullptr, nullptr);
}

/// What earlier submissions wrote, by shaders or by copies, is seen by this one.
void barrier_from_before(const vk::raii::CommandBuffer& commands) {
  memory_barrier(commands, Stage::eComputeShader | Stage::eTransfer, Access::eShaderWrite | Access::eTransferWrite,
                 Stage::eComputeShader | Stage::eTransfer,
                 Access::eShaderRead | Access::eShaderWrite | Access::eUniformRead | Access::eTransferRead |
                     Access::eTransferWrite);
}

void barrier_between_dispatches(const vk::raii::CommandBuffer& commands) {
  memory_barrier(commands, Stage::eComputeShader, Access::eShaderWrite, Stage::eComputeShader,
                 Access::eShaderRead | Access::eShaderWrite | Access::eUniformRead);
}

void barrier_to_host(const vk::raii::CommandBuffer& commands) {
  memory_barrier(commands, Stage::eComputeShader | Stage::eTransfer, Access::eShaderWrite | Access::eTransferWrite,
                 Stage::eHost, Access::eHostRead | Access::eHostWrite);
}

/// What was written so far, by whatever, is seen by all that follows and by the host.
void barrier_to_all(const vk::raii::CommandBuffer& commands) {
  memory_barrier(commands, Stage::eAllCommands, Access::eMemoryWrite, Stage::eAllCommands | Stage::eHost,
                 Access::eMemoryRead | Access::eMemoryWrite | Access::eHostRead | Access::eHostWrite);
}

void record(const vk::raii::CommandBuffer& commands, const Dispatch& dispatch) {
  commands.bindPipeline(vk::PipelineBindPoint::eCompute, *dispatch.pipeline->vk());
  const vk::PipelineLayout layout = *dispatch.pipeline->layout();
  if (dispatch.bindings != nullptr && dispatch.bindings->vk()) {
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, layout, 0, dispatch.bindings->vk(), nullptr);
  }
  if (!dispatch.push_constants.empty()) {
    commands.pushConstants<std::byte>(layout, vk::ShaderStageFlagBits::eCompute, 0, dispatch.push_constants);
  }
  commands.dispatch(dispatch.group_count_x, dispatch.group_count_y, dispatch.group_count_z);
}

void record(const vk::raii::CommandBuffer& commands, const std::vector<Upload>& uploads) {
  for (const Upload& upload : uploads) {
    commands.updateBuffer<std::byte>(*upload.buffer->vk(), 0, upload.bytes);
  }
  if (uploads.empty()) return;
  memory_barrier(commands, Stage::eTransfer, Access::eTransferWrite, Stage::eComputeShader,
                 Access::eShaderRead | Access::eShaderWrite | Access::eUniformRead);
}

void record(const vk::raii::CommandBuffer& commands, const std::vector<Download>& downloads, const Buffer& target) {
  if (downloads.empty()) return;
  memory_barrier(commands, Stage::eComputeShader, Access::eShaderWrite, Stage::eTransfer, Access::eTransferRead);
  std::uint64_t offset = 0;
  for (const Download& download : downloads) {
    commands.copyBuffer(*download.buffer->vk(), *target.vk(), vk::BufferCopy(0, offset, download.bytes.size()));
    offset += download.bytes.size();
  }
}

/// The same once it is there.
void take(const std::vector<Download>& downloads, const Buffer& source) {
  std::uint64_t offset = 0;
  for (const Download& download : downloads) {
    std::memcpy(download.bytes.data(), source.mapped().data() + offset, download.bytes.size());
    offset += download.bytes.size();
  }
}

std::uint64_t size_of(const std::vector<Download>& downloads) {
  std::uint64_t bytes = 0;
  for (const Download& download : downloads) bytes += download.bytes.size();
  return bytes;
}

bool wait(const Device& device, const vk::raii::Fence& fence, double seconds) {
  const double limit_ns = std::max(seconds, 0.0) * 1e9;
  const std::uint64_t wait_ns =
      limit_ns < 1e18 ? static_cast<std::uint64_t>(limit_ns) : std::numeric_limits<std::uint64_t>::max();
  return device.vk().waitForFences(*fence, VK_TRUE, wait_ns) == vk::Result::eSuccess;
}

[[noreturn]] void throw_lost(const Device& device, double seconds) {
  throw Error(ErrorKind::device_lost, "device " + device.description().name + ": no answer within " +
                                          std::to_string(std::lround(seconds)) + " s, taken as lost");
}

/// Between the two timestamps, whose upper bits need not count.
double measured_ms(const Device& device, const vk::raii::QueryPool& queries) {
  const auto [result, ticks] = queries.getResults<std::uint64_t>(
      0, kTimestampCount, kTimestampCount * sizeof(std::uint64_t), sizeof(std::uint64_t),
      vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait);
  const std::uint32_t valid_bits = device.description().timestamp_bits;
  const std::uint64_t mask = valid_bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << valid_bits) - 1;
  constexpr double kMsPerNs = 1e-6;
  return static_cast<double>((ticks[1] - ticks[0]) & mask) * device.description().timestamp_period_ns * kMsPerNs;
}

vk::raii::CommandBuffer create_commands(const Device& device, const vk::raii::CommandPool& pool) {
  vk::raii::CommandBuffers all(device.vk(), vk::CommandBufferAllocateInfo(*pool, vk::CommandBufferLevel::ePrimary, 1));
  return std::move(all.front());
}

}  // namespace

Submitter::Submitter(const Device& device) : device_(&device) {
  vk_check("preparing submissions", [&] {
    pool_ = device.vk().createCommandPool({vk::CommandPoolCreateFlagBits::eResetCommandBuffer, device.queue_family()});
    commands_ = create_commands(device, pool_);
    fence_ = device.vk().createFence({});
    if (device.description().timestamp_bits > 0) {
      queries_ = device.vk().createQueryPool({{}, vk::QueryType::eTimestamp, kTimestampCount});
    }
  });
}

SubmissionTime Submitter::run(std::span<const Dispatch> dispatches, const Exchange& exchange, double timeout_s) {
  if (lost_) throw_lost(*device_, timeout_s);
  const std::uint64_t downloaded_bytes = size_of(exchange.downloads);
  if (downloaded_bytes > downloaded_.size_bytes()) {
    downloaded_ = Buffer(*device_, downloaded_bytes, BufferUse::storage_host_visible);
  }
  const bool timed = device_->description().timestamp_bits > 0;
  const auto start = std::chrono::steady_clock::now();
  vk_check("running shaders", [&] {
    commands_.reset();
    commands_.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    if (timed) commands_.resetQueryPool(*queries_, 0, kTimestampCount);
    barrier_from_before(commands_);
    record(commands_, exchange.uploads);
    if (timed) commands_.writeTimestamp(Stage::eTopOfPipe, *queries_, 0);
    for (const Dispatch& dispatch : dispatches) {
      if (&dispatch != dispatches.data()) barrier_between_dispatches(commands_);
      record(commands_, dispatch);
    }
    if (timed) commands_.writeTimestamp(Stage::eBottomOfPipe, *queries_, 1);
    record(commands_, exchange.downloads, downloaded_);
    barrier_to_host(commands_);
    commands_.end();
    device_->vk().resetFences(*fence_);
    const vk::CommandBuffer submitted = *commands_;
    device_->queue().submit(vk::SubmitInfo(nullptr, nullptr, submitted), *fence_);
    if (!wait(*device_, fence_, timeout_s)) {
      lost_ = true;
      wait(*device_, fence_, device_->description().is_cpu ? kNoLimit : kGraceSeconds);
      throw_lost(*device_, timeout_s);
    }
  });
  take(exchange.downloads, downloaded_);
  const double wall_ms = ms_since(start);
  return {timed ? vk_check("reading timestamps", [&] { return measured_ms(*device_, queries_); }) : wall_ms, wall_ms};
}

void run_transfer(const Device& device, const std::function<void(const vk::raii::CommandBuffer&)>& record_work) {
  vk_check("copying buffers", [&] {
    const vk::raii::CommandPool pool =
        device.vk().createCommandPool({vk::CommandPoolCreateFlagBits::eTransient, device.queue_family()});
    const vk::raii::CommandBuffer commands = create_commands(device, pool);
    const vk::raii::Fence fence = device.vk().createFence({});
    commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    barrier_to_all(commands);
    record_work(commands);
    barrier_to_all(commands);
    commands.end();
    const vk::CommandBuffer submitted = *commands;
    device.queue().submit(vk::SubmitInfo(nullptr, nullptr, submitted), *fence);
    if (!wait(device, fence, device.description().is_cpu ? kNoLimit : kTransferTimeoutSeconds)) {
      wait(device, fence, kGraceSeconds);
      throw_lost(device, kTransferTimeoutSeconds);
    }
  });
}

}  // namespace vernier
