#pragma once

#include <cstdint>

namespace vernier {

/// Memory of the host that is being taken: what the system calls free lessens only as it is written, so threads that
/// take much of it at once have to know of each other.
class MemoryClaim {
 public:
  MemoryClaim() = default;
  ~MemoryClaim();
  MemoryClaim(const MemoryClaim&) = delete;
  MemoryClaim& operator=(const MemoryClaim&) = delete;

  /// Claims `bytes`, once, until the claim ends. Waits while they are not there beside what others claim. Returns what
  /// is there (host_memory_there, the largest number where that is not known): less than `bytes` where they are not,
  /// and then nothing is claimed.
  std::uint64_t take(std::uint64_t bytes);

 private:
  std::uint64_t bytes_ = 0;
};

}  // namespace vernier
