#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

namespace vernier {

/// The JSON of a glTF file, made fit for tinygltf (see parse_gltf_json).
struct GltfJson {
  nlohmann::json root;
  std::map<std::string, std::string> extension_places;  ///< each extension's name and the first object that has it
};

/// Parses `text` and checks that it is an object with `asset.version` 2.x. Takes out every `extras`, writes whole
/// numbers as integers (JSON knows no difference, tinygltf does: `1.0` is no index to it) and numbers beyond 32 bits as
/// floating point but for counts, offsets and lengths (tinygltf would wrap them around). Throws Error(refused) for
/// anything else, and for brackets nested deeper than 64: whoever recurses here or later may rely on it.
GltfJson parse_gltf_json(std::span<const std::byte> text, const std::string& path);

}  // namespace vernier
