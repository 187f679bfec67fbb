#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scene/load_scene.h"

namespace vernier {

/// Most bytes one buffer, accessor or decoded part of a file may ask for.
inline constexpr std::uint64_t kMaxGltfBytes = std::uint64_t{1} << 31;

/// Where the encoded bytes of an image are: a URI or, with an empty one, a bufferView.
struct GltfImage {
  std::string name;
  std::string uri;
  int buffer_view = -1;
};

/// Bytes of one buffer. A fallback buffer of EXT_meshopt_compression has none: nothing may read it.
struct GltfBuffer {
  std::vector<std::byte> bytes;
  bool is_fallback = false;
};

/// A parsed glTF file. `model` holds everything but `buffers` and `images`, which are ours: tinygltf reads beyond
/// the end of a GLB with a wrong chunk length, wants external files to have the exact size and knows no fallback
/// buffers.
struct GltfDocument {
  std::string path;       ///< as the user named it
  std::string directory;  ///< of the file: relative URIs start here
  bool strict = false;
  tinygltf::Model model;
  std::vector<std::shared_ptr<const GltfBuffer>> buffers;  ///< images that wait to be decoded keep theirs
  std::vector<GltfImage> images;
  std::vector<std::string> files;  ///< read so far, as Scene::files
  std::vector<std::string> warnings;
  mutable std::uint64_t zero_bytes = 0;  ///< made so far for accessors without bufferView (gltf_accessors.h)
};

/// Throws Error(refused) `path: place: what`; an empty place is left out.
[[noreturn]] void refuse_gltf(const GltfDocument& document, const std::string& place, const std::string& what);

/// Adds the warning `place: what`; the same line is added once, and after a hundred no more.
void warn_gltf(GltfDocument& document, const std::string& place, const std::string& what);

/// A feature the renderer leaves out: a warning, or in a strict document Error(refused).
void unsupported_gltf(GltfDocument& document, const std::string& place, const std::string& what);

/// Reads and parses the file at `path`, loads its buffers, and checks version, extensions, every reference and the node
/// tree: afterwards each index in `model` is -1 (none) or in range, each node has at most one parent and no cycle
/// exists. Compressed geometry is not yet expanded. JSON deeper than 64 levels is refused. Throws Error(refused) with
/// file and place.
GltfDocument read_gltf_document(const std::string& path, const LoadOptions& options);

/// The same for the bytes `file` of a file that `path` names; relative URIs start in its folder.
GltfDocument parse_gltf_document(std::span<const std::byte> file, const std::string& path, const LoadOptions& options);

/// The bytes of a bufferView, checked against its buffer. `place` names who asks.
std::span<const std::byte> gltf_view_bytes(const GltfDocument& document, int view, const std::string& place);

}  // namespace vernier
