#include "bvh/build_progress.h"

#include <algorithm>
#include <utility>

namespace vernier {
namespace {

constexpr double kTreeShare = 0.75;

}  // namespace

BuildProgress::BuildProgress(std::function<void(double share)> tell, std::size_t triangle_count)
    : tell_(std::move(tell)), share_per_triangle_(1.0 / std::max<double>(1.0, static_cast<double>(triangle_count))) {}

CountDone BuildProgress::tree_stage() {
  return stage(kTreeShare);
}

CountDone BuildProgress::record_stage() {
  return stage(1.0 - kTreeShare);
}

CountDone BuildProgress::stage(double share) {
  if (!tell_) return {};
  return [this, share](std::size_t count) {
    const std::scoped_lock lock(mutex_);
    done_ = std::min(1.0, done_ + share * share_per_triangle_ * static_cast<double>(count));
    tell_(done_);
  };
}

}  // namespace vernier
