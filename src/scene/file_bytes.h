#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace vernier {

/// Looks at the first bytes of a file, 512 or all of them, and throws where they show that it is none of its kind.
using StartCheck = std::function<void(std::string_view start)>;

/// All bytes of the file at `path`. Throws Error(refused) "`place`: ..." where it does not exist, cannot be read, is no
/// regular file or is longer than `max_bytes` or than the memory that is there, and what `check_start` throws, before
/// any memory is taken for it.
std::vector<std::byte> read_file_bytes(const std::string& path, const std::string& place, std::uint64_t max_bytes,
                                       const StartCheck& check_start = {});

/// The same of a text of up to 16 GiB. One with a zero byte in its first 512 is none: UTF-16, or a binary file.
std::string read_text(const std::string& path);

}  // namespace vernier
