#include "scene/texture_from_image.h"

#include <filesystem>
#include <fstream>
#include <vector>

#include "error.h"
#include "image/codec_module.h"
#include "image/essential_png.h"
#include "math/memory_claim.h"
#include "scene/encoded_format.h"
#include "scene/texel_codec.h"
#include "scene/texel_memory.h"

namespace vernier {
std::shared_ptr<const Texels> decode_texels(std::span<const std::byte> encoded, const std::string& name,
                                            TexelEncoding encoding) {
  if (encoded.empty()) refuse(name, "the image is empty");
  const std::string format = encoded_format(encoded, name);
  std::vector<std::byte> png;
  if (format == "png") encoded = png = essential_png(encoded, name, kMaxTexels);
  auto texels = std::make_shared<Texels>();
  MemoryClaim claim;
  codec<decltype(read_texels)>("read_texels")(
      encoded, format, name, encoding, [&](std::uint64_t bytes) { claim_texel_memory(claim, name, bytes); }, *texels);
  return texels;
}

void check_image_file(const std::string& path) {
  std::error_code failure;
  if (!std::filesystem::exists(path, failure)) refuse(path, "the file cannot be opened");
  // A pipe would be waited for.
  if (!std::filesystem::is_regular_file(path, failure)) refuse(path, "not a regular file");
}

std::shared_ptr<const Texels> decode_texels_from_file(const std::string& path, TexelEncoding encoding) {
  check_image_file(path);
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) refuse(path, "the file cannot be opened");
  const std::streamoff size = file.tellg();
  // A directory opens as a stream of nonsense size; a true image file is far below what is checked here.
  if (size < 0 || std::uint64_t(size) > kMaxTexels * 16) refuse(path, "not a readable image file");
  std::vector<std::byte> bytes;
  {
    MemoryClaim claim;
    claim_texel_memory(claim, path, static_cast<std::uint64_t>(size));
    bytes.resize(static_cast<std::size_t>(size));
    file.seekg(0);
    if (!file.read(reinterpret_cast<char*>(bytes.data()), size)) refuse(path, "the file cannot be read");
  }
  return decode_texels(bytes, path, encoding);
}

}  // namespace vernier
