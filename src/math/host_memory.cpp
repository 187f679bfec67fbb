#include "math/host_memory.h"

#include <algorithm>
#include <fstream>
#include <limits>

namespace vernier {
namespace {

/// A number of bytes from the file at `path` that holds one by itself or behind `label`.
std::optional<std::uint64_t> read_bytes(const std::string& path, const std::string& label, std::uint64_t unit) {
  std::ifstream file(path);
  std::string word;
  while (!label.empty() && file >> word && word != label) {
  }
  std::uint64_t value = 0;
  if (!(file >> value)) return std::nullopt;
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  return value <= kMost / unit ? value * unit : kMost;
}

std::string text_of_tenths(std::uint64_t gigabyte_tenths) {
  return std::to_string(gigabyte_tenths / 10) + "." + std::to_string(gigabyte_tenths % 10) + " GB";
}

}  // namespace

std::optional<std::uint64_t> host_memory_there() {
  std::optional<std::uint64_t> there = read_bytes("/proc/meminfo", "MemAvailable:", 1024);
  const auto most = read_bytes("/sys/fs/cgroup/memory.max", "", 1);
  const auto used = read_bytes("/sys/fs/cgroup/memory.current", "", 1);
  if (most && used) {
    // What the group holds of files is given back when it is needed.
    const std::string statistics = "/sys/fs/cgroup/memory.stat";
    const std::uint64_t files =
        read_bytes(statistics, "inactive_file", 1).value_or(0) + read_bytes(statistics, "active_file", 1).value_or(0);
    const std::uint64_t kept = *used - std::min(*used, files);
    const std::uint64_t left = *most - std::min(*most, kept);
    there = std::min(there.value_or(left), left);
  }
  return there;
}

std::string needed_memory_text(std::uint64_t bytes) {
  return text_of_tenths((bytes + 99'999'999) / 100'000'000);
}

std::string memory_there_text(std::uint64_t bytes) {
  return text_of_tenths(bytes / 100'000'000);
}

}  // namespace vernier
