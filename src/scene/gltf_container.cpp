#include "scene/gltf_container.h"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "error.h"

namespace vernier {
namespace {

constexpr std::uint32_t kGlbMagic = 0x46546C67;  // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinChunk = 0x004E4942;
constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;

[[noreturn]] void refuse(const std::string& place, const std::string& what) {
  throw Error(ErrorKind::refused, place + ": " + what);
}

std::uint32_t word_at(std::span<const std::byte> bytes, std::size_t offset) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word |= std::uint32_t(bytes[offset + i]) << (8 * i);
  return word;
}

/// The bytes of the whole that the header of the GLB `file` promises, all of which are there.
std::size_t glb_length(std::span<const std::byte> file, const std::string& path) {
  if (file.size() < kHeaderBytes + kChunkHeaderBytes) refuse(path, "the file ends within the GLB header");
  if (word_at(file, 4) != 2)
    refuse(path, "GLB version " + std::to_string(word_at(file, 4)) + " is not supported, only 2");
  const std::size_t length = word_at(file, 8);
  if (length > file.size()) {
    refuse(path,
           "the GLB header promises " + std::to_string(length) + " bytes, the file has " + std::to_string(file.size()));
  }
  return length;
}

}  // namespace

std::vector<std::byte> read_file_bytes(const std::string& path, const std::string& place, std::uint64_t max_bytes) {
  std::error_code failure;
  // Opening a pipe would wait for its writer, a directory has no size: both are refused unopened.
  const auto status = std::filesystem::status(path, failure);
  if (!std::filesystem::exists(status)) refuse(place, "the file does not exist");
  if (!std::filesystem::is_regular_file(status)) refuse(place, "not a regular file");
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) refuse(place, "the file cannot be opened");
  const std::streamoff size = file.tellg();
  if (size < 0) refuse(place, "the file cannot be read");
  if (std::uint64_t(size) > max_bytes) {
    refuse(place, "the file has " + std::to_string(size) + " bytes, more than " + std::to_string(max_bytes));
  }
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  file.seekg(0);
  if (!file.read(reinterpret_cast<char*>(bytes.data()), size)) refuse(place, "the file cannot be read");
  return bytes;
}

GltfContainer split_gltf_container(std::span<const std::byte> file, const std::string& path, bool binary_expected) {
  const bool is_binary = file.size() >= 4 && word_at(file, 0) == kGlbMagic;
  if (!is_binary) {
    if (binary_expected) refuse(path, "not a binary glTF file: it does not begin with glTF");
    return {.json = file, .bin = {}, .has_bin = false};
  }
  const std::size_t length = glb_length(file, path);
  GltfContainer container;
  std::size_t offset = kHeaderBytes;
  for (int chunk = 0; length >= offset && length - offset >= kChunkHeaderBytes; ++chunk) {
    const std::size_t chunk_bytes = word_at(file, offset);
    const std::uint32_t type = word_at(file, offset + 4);
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
