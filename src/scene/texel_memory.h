#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace vernier {

/// Throws MemoryError where the image `name` needs so many bytes decoded, and fewer are `there` beside `others`, those
/// of images that are being decoded.
void check_texel_memory(const std::string& name, std::uint64_t bytes, std::uint64_t others,
                        std::optional<std::uint64_t> there);

/// Memory for the texels of an image that is being decoded: what the system calls free lessens only as they are
/// written, so images that are decoded at once have to know of each other.
class TexelClaim {
 public:
  TexelClaim() = default;
  ~TexelClaim();
  TexelClaim(const TexelClaim&) = delete;
  TexelClaim& operator=(const TexelClaim&) = delete;
  /// Claims, once, what the image `name` needs. Throws MemoryError where it is not there.
  void take(const std::string& name, std::uint64_t bytes);

 private:
  std::uint64_t bytes_ = 0;
};

}  // namespace vernier
