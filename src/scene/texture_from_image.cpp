#include "scene/texture_from_image.h"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

#include "error.h"
#include "image/codec_module.h"
#include "math/memory_claim.h"
#include "scene/essential_png.h"
#include "scene/texel_codec.h"
#include "scene/texel_memory.h"

namespace vernier {
namespace {

constexpr std::string_view kPngSignature("\x89PNG\r\n\x1a\n", 8);

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw Error(ErrorKind::refused, name + ": " + what);
}

bool begins_with(std::span<const std::byte> encoded, std::string_view bytes, std::size_t offset = 0) {
  return encoded.size() >= offset + bytes.size() &&
         std::memcmp(encoded.data() + offset, bytes.data(), bytes.size()) == 0;
}

// OpenImageIO picks the reader of an image in memory by a file name, so the content is looked at here.
// TGA has no signature at its start: it is recognised by the extension of its name alone.
std::string extension_of(std::span<const std::byte> encoded, const std::string& name) {
  using namespace std::string_view_literals;
  if (begins_with(encoded, kPngSignature)) return "png";
  if (begins_with(encoded, "\xff\xd8\xff"sv)) return "jpg";
  if (begins_with(encoded, "RIFF"sv) && begins_with(encoded, "WEBP"sv, 8)) return "webp";
  if (begins_with(encoded, "BM"sv)) return "bmp";
  if (begins_with(encoded, "#?"sv)) return "hdr";
  if (begins_with(encoded, "\x76\x2f\x31\x01"sv)) return "exr";
  if (begins_with(encoded, "II*\0"sv) || begins_with(encoded, "MM\0*"sv)) return "tif";
  if (begins_with(encoded, "GIF8"sv)) return "gif";
  if (begins_with(encoded, "8BPS"sv)) return "psd";
  if (begins_with(encoded, "DDS "sv)) return "dds";
  const std::size_t dot = name.find_last_of("./");
  return dot != std::string::npos && name[dot] == '.' ? name.substr(dot + 1) : "tga";
}

}  // namespace

std::shared_ptr<const Texels> decode_texels(std::span<const std::byte> encoded, const std::string& name,
                                            TexelEncoding encoding) {
  if (encoded.empty()) refuse(name, "the image is empty");
  const std::string extension = extension_of(encoded, name);
  std::vector<std::byte> png;
  if (extension == "png" && begins_with(encoded, kPngSignature)) encoded = png = essential_png(encoded, name);
  auto texels = std::make_shared<Texels>();
  MemoryClaim claim;
  codec<decltype(read_texels)>("read_texels")(
      encoded, extension, name, encoding, [&](std::uint64_t bytes) { claim_texel_memory(claim, name, bytes); },
      *texels);
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
