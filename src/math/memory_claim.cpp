#include "math/memory_claim.h"

#include <condition_variable>
#include <limits>
#include <mutex>

#include "math/host_memory.h"

namespace vernier {
namespace {

std::mutex mutex;
std::condition_variable has_changed;
std::uint64_t claimed_bytes = 0;

}  // namespace

MemoryClaim::~MemoryClaim() {
  if (bytes_ == 0) return;
  {
    const std::scoped_lock lock(mutex);
    claimed_bytes -= bytes_;
  }
  has_changed.notify_all();
}

std::uint64_t MemoryClaim::take(std::uint64_t bytes) {
  std::uint64_t there = 0;
  std::unique_lock lock(mutex);
  has_changed.wait(lock, [&] {
    there = host_memory_there().value_or(std::numeric_limits<std::uint64_t>::max());
    return claimed_bytes == 0 || (claimed_bytes <= there && bytes <= there - claimed_bytes);
  });
  if (bytes <= there) claimed_bytes += bytes_ = bytes;
  return there;
}

}  // namespace vernier
