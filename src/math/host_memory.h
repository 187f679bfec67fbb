#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace vernier {

/// Bytes that this process may still take without swapping, as the system calls it available, or less where a control
/// group (a container) allows less. Empty: not known.
std::optional<std::uint64_t> host_memory_there();

/// So many bytes that are needed in GB, rounded up, so that a refusal never names the same number twice.
std::string needed_memory_text(std::uint64_t bytes);
/// So many bytes that are there in GB, rounded down.
std::string memory_there_text(std::uint64_t bytes);

}  // namespace vernier
