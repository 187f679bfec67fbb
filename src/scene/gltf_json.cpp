#include "scene/gltf_json.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

#include "error.h"
#include "scene/gltf_required.h"
#include "scene/gltf_types.h"

namespace vernier {
namespace {

using nlohmann::json;

constexpr int kMaxNesting = 64;

// Done on the text: parsers and destructors further down recurse once per level.
void check_nesting(std::string_view text, const std::string& path) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
      continue;
    }
    if (c == '"') in_string = true;
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') --depth;
    if (depth > kMaxNesting) refuse(path, "the JSON is nested deeper than " + std::to_string(kMaxNesting) + " levels");
  }
}

json parse(std::string_view text, const std::string& path) {
  try {
    return json::parse(text);
  } catch (const json::exception& failure) {
    std::string line = failure.what();
    line.erase(0, line.find("] ") == std::string::npos ? 0 : line.find("] ") + 2);  // the library's name for it
    for (char& c : line) {
      if (static_cast<unsigned char>(c) < ' ') c = ' ';
    }
    refuse(path, "not valid JSON: " + line);
  }
}

/// Versions are "major.minor".
void check_version(const json& root, const std::string& path) {
  if (!root.is_object()) refuse(path, "not a glTF file: the JSON is not an object");
  const auto asset = root.find("asset");
  if (asset == root.end() || !asset->is_object()) refuse(path, "not a glTF 2.0 file: it has no asset object");
  const auto version = asset->find("version");
  if (version == asset->end() || !version->is_string()) refuse(path, "asset: version is missing");
  const std::string text = version->get<std::string>();
  if (!text.starts_with("2.")) refuse(path, "asset: glTF version " + text + " is not supported, only 2.x");
  const auto minimum = asset->find("minVersion");
  if (minimum != asset->end() && *minimum != "2.0") refuse(path, "asset: the file asks for glTF " + minimum->dump());
}

bool may_be_large(const std::string& key) {
  return key == "byteLength" || key == "byteOffset" || key == "byteStride" || key == "count";
}

void normalise_number(json& number, const std::string& key) {
  constexpr double kIntMax = std::numeric_limits<std::int32_t>::max();
  const double value = number.get<double>();
  if (number.is_number_float()) {
    if (value == std::floor(value) && std::abs(value) <= kIntMax) {
      if (value >= 0) {
        number = static_cast<std::uint64_t>(value);
      } else {
        number = static_cast<std::int64_t>(value);
      }
    }
  } else if (std::abs(value) > kIntMax && !may_be_large(key)) {
    number = value;
  } else if (value == 0.0) {
    number = 0u;  // JSON has a -0
  }
}

void normalise(json& value, const std::string& key, const std::string& place, GltfJson& result) {
  if (value.is_number()) normalise_number(value, key);
  if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      normalise(value[i], key, place.empty() ? gltf_element_name(key, i) : place, result);
    }
  }
  if (!value.is_object()) return;
  value.erase("extras");
  for (auto& [name, member] : value.items()) {
    if (name == "extensions" && member.is_object()) {
      for (const auto& extension : member.items()) result.extension_places.try_emplace(extension.key(), place);
    }
    normalise(member, name, place, result);
  }
}

}  // namespace

GltfJson parse_gltf_json(std::span<const std::byte> text, const std::string& path) {
  const std::string_view characters(reinterpret_cast<const char*>(text.data()), text.size());
  check_nesting(characters, path);
  GltfJson result;
  result.root = parse(characters, path);
  check_version(result.root, path);
  normalise(result.root, "", "", result);
  check_gltf_types(result.root, path);
  check_gltf_required(result.root, path);
  return result;
}

}  // namespace vernier
