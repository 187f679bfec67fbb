#pragma once

#include <string>

namespace vernier {

/// The bytes of the file at `path`. Throws Error(refused) with `path` where it is no regular file, cannot be read or is
/// larger than 16 GiB.
std::string read_text(const std::string& path);

}  // namespace vernier
