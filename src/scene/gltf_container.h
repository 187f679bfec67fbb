#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace vernier {

/// The parts of a glTF file: its JSON text and, in a binary file, the BIN chunk (empty where there is none).
/// Both point into the bytes the file was read to.
struct GltfContainer {
  std::span<const std::byte> json;
  std::span<const std::byte> bin;
  bool has_bin = false;
};

/// Refuses (Error) a file that its first bytes, `start`, show to be neither JSON nor GLB; with `binary_expected` also
/// JSON.
void check_gltf_start(std::string_view start, const std::string& path, bool binary_expected);

/// Splits `file` (glTF 2.0, section 4, GLB) by its chunks; a file without the GLB magic is JSON as a whole. Chunks of
/// other types are skipped.
/// Throws Error(refused) for a GLB of another version, a chunk beyond the end or a first chunk that is not JSON.
GltfContainer split_gltf_container(std::span<const std::byte> file, const std::string& path);

}  // namespace vernier
