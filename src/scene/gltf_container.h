#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace vernier {

/// The parts of a glTF file: its JSON text and, in a binary file, the BIN chunk (empty where there is none).
/// Both point into the bytes the file was read to.
struct GltfContainer {
  std::span<const std::byte> json;
  std::span<const std::byte> bin;
  bool has_bin = false;
};

/// All bytes of the file at `path`. Throws Error(refused) "`place`: ..." where it does not exist, cannot be read, is no
/// regular file or is longer than `max_bytes`.
std::vector<std::byte> read_file_bytes(const std::string& path, const std::string& place, std::uint64_t max_bytes);

/// Splits `file` (glTF 2.0, section 4, GLB) by its chunks; a file without the GLB magic is JSON as a whole.
/// `binary_expected` refuses such a file. Chunks of other types are skipped.
/// Throws Error(refused) for a GLB of another version, a chunk beyond the end or a first chunk that is not JSON.
GltfContainer split_gltf_container(std::span<const std::byte> file, const std::string& path, bool binary_expected);

}  // namespace vernier
