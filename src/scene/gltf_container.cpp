#include "scene/gltf_container.h"

#include <cstdint>

#include "error.h"
#include "math/little_endian.h"

namespace vernier {
namespace {

constexpr std::string_view kMagicText = "glTF";
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinChunk = 0x004E4942;
constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;

/// The bytes of the whole that the header of the GLB `file` promises, all of which are there.
std::size_t glb_length(std::span<const std::byte> file, const std::string& path) {
  if (file.size() < kHeaderBytes + kChunkHeaderBytes) refuse(path, "the file ends within the GLB header");
  if (little_endian(file, 4) != 2)
    refuse(path, "GLB version " + std::to_string(little_endian(file, 4)) + " is not supported, only 2");
  const std::size_t length = little_endian(file, 8);
  if (length > file.size()) {
    refuse(path,
           "the GLB header promises " + std::to_string(length) + " bytes, the file has " + std::to_string(file.size()));
  }
  return length;
}

}  // namespace

void check_gltf_start(std::string_view start, const std::string& path, bool binary_expected) {
  if (start.starts_with(kMagicText)) return;
  if (binary_expected) refuse(path, "not a binary glTF file: it does not begin with glTF");
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (start.starts_with(kByteOrderMark)) start.remove_prefix(kByteOrderMark.size());
  const std::size_t first = start.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && start[first] != '{' && start[first] != '[')
    refuse(path, "not a glTF file: it begins neither as JSON nor with glTF");
}

GltfContainer split_gltf_container(std::span<const std::byte> file, const std::string& path) {
  const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  if (!text.starts_with(kMagicText)) return {.json = file, .bin = {}, .has_bin = false};
  const std::size_t length = glb_length(file, path);
  GltfContainer container;
  std::size_t offset = kHeaderBytes;
  for (int chunk = 0; length >= offset && length - offset >= kChunkHeaderBytes; ++chunk) {
    const std::size_t chunk_bytes = little_endian(file, offset);
    const std::uint32_t type = little_endian(file, offset + 4);
    offset += kChunkHeaderBytes;
    if (chunk_bytes > length - offset) {
      refuse(path,
             "chunk " + std::to_string(chunk) + " of " + std::to_string(chunk_bytes) + " bytes goes beyond the end");
    }
    if ((chunk == 0) != (type == kJsonChunk)) refuse(path, "the first chunk and no other must be JSON");
    if (chunk == 0) container.json = file.subspan(offset, chunk_bytes);
    if (chunk == 1 && type == kBinChunk) {
      container.bin = file.subspan(offset, chunk_bytes);
      container.has_bin = true;
    }
    offset += chunk_bytes;
  }
  if (container.json.empty()) refuse(path, "the JSON chunk is empty");
  return container;
}

}  // namespace vernier
