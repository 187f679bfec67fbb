#include "scene/gltf_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>

#include "error.h"

namespace vernier {
namespace {

using nlohmann::json;

constexpr int kMaxNesting = 64;

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
  throw Error(ErrorKind::refused, path + ": " + what);
}

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
  }
}

/// Members that are indices, sizes or enumerators: whole numbers from 0.
constexpr std::array<std::string_view, 24> kWholeNumbers = {
    "buffer",
    "bufferView",
    "byteLength",
    "byteOffset",
    "byteStride",
    "camera",
    "count",
    "index",
    "indices",
    "material",
    "mesh",
    "mode",
    "scene",
    "skeleton",
    "skin",
    "source",
    "sampler",
    "texCoord",
    "magFilter",
    "minFilter",
    "wrapS",
    "wrapT",
    "inverseBindMatrices",
    "componentType",
};

/// Lists of them, by the member that holds the object they are in.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kWholeNumberLists = {
    {{"scenes", "nodes"}, {"nodes", "children"}, {"skins", "joints"}}};

constexpr std::array<std::string_view, 14> kObjectLists = {
    "accessors", "buffers",  "bufferViews", "cameras", "images",  "materials", "meshes",
    "nodes",     "samplers", "scenes",      "skins",   "targets", "textures",  "primitives",
};

constexpr std::array<std::string_view, 8> kObjects = {
    "attributes",    "baseColorTexture", "emissiveTexture",      "metallicRoughnessTexture",
    "normalTexture", "occlusionTexture", "pbrMetallicRoughness", "sparse",
};

/// Members that are a number. (Bounds of accessors are not looked at: exporters write null for NaN.)
constexpr std::array<std::string_view, 11> kNumbers = {
    "alphaCutoff", "aspectRatio", "metallicFactor", "roughnessFactor", "scale", "strength", "xmag",
    "yfov",        "ymag",        "zfar",           "znear",
};

/// Lists of numbers, by the member that holds the object they are in. (How many is looked at later.)
constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kNumberLists = {
    {{"nodes", "matrix"},
     {"nodes", "rotation"},
     {"nodes", "scale"},
     {"nodes", "translation"},
     {"nodes", "weights"},
     {"meshes", "weights"},
     {"materials", "emissiveFactor"},
     {"pbrMetallicRoughness", "baseColorFactor"}}};

/// "material 3" for element 3 of `materials`.
std::string element_name(const std::string& array, std::size_t index) {
  std::string singular = array == "meshes" ? "mesh" : array;
  if (singular.ends_with('s')) singular.pop_back();
  return singular + " " + std::to_string(index);
}

void normalise(json& value, const std::string& key, const std::string& place, GltfJson& result) {
  if (value.is_number()) normalise_number(value, key);
  if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      normalise(value[i], key, place.empty() ? element_name(key, i) : place, result);
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

bool is_one_of(std::string_view name, std::span<const std::string_view> names) {
  return std::ranges::find(names, name) != names.end();
}

bool is_list_of(const json& member, bool (*holds)(const json&)) {
  return member.is_array() && std::ranges::all_of(member, holds);
}

bool is_whole(const json& member) {
  return member.is_number_unsigned();
}
bool is_number(const json& member) {
  return member.is_number();
}
bool is_object(const json& member) {
  return member.is_object();
}

bool is_one_of(const std::string& key, const std::string& name,
               std::span<const std::pair<std::string_view, std::string_view>> members) {
  return std::ranges::find(members, std::pair<std::string_view, std::string_view>(key, name)) != members.end();
}

/// What member `name` of an object that is called `key` is not, or empty.
std::string missed_type(const std::string& key, const std::string& name, const json& member) {
  const bool is_attribute = key == "attributes" || key == "targets";
  if (is_attribute || (is_one_of(name, kWholeNumbers) && !(key == "sparse" && name == "indices"))) {
    if (!is_whole(member)) return "a whole number from 0";
  }
  constexpr double kIntMax = std::numeric_limits<std::int32_t>::max();
  if (key == "sparse" && name == "count" && member.get<double>() > kIntMax) return "a number below 2^31";
  if (is_one_of(key, name, kWholeNumberLists)) {
    return is_list_of(member, is_whole) ? "" : "a list of whole numbers from 0";
  }
  if (is_one_of(name, kObjectLists) && (key.empty() || key == "meshes" || key == "primitives")) {
    return is_list_of(member, is_object) ? "" : "a list of objects";
  }
  if (member.is_null()) return "";  // what some exporters write for what they do not know
  if (is_one_of(name, kObjects)) return member.is_object() ? "" : "an object";
  if (is_one_of(key, name, kNumberLists)) return is_list_of(member, is_number) ? "" : "a list of numbers";
  return is_one_of(name, kNumbers) && !member.is_number() ? "a number" : "";
}

// A parser further down takes what is below 0 or no number for not given. Extensions have members of their own.
void check_numbers(const json& value, const std::string& key, const std::string& place, const std::string& path) {
  if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      check_numbers(value[i], key, place.empty() ? element_name(key, i) : place, path);
    }
    return;
  }
  if (value.is_object()) {
    for (const auto& [name, member] : value.items()) {
      if (name == "extensions" || name == "animations") continue;
      const std::string missed = missed_type(key, name, member);
      if (!missed.empty()) {
        refuse(path,
               (place.empty() ? "" : place + ": ") + name + " is " + member.dump().substr(0, 40) + ", not " + missed);
      }
      check_numbers(member, name, place, path);
    }
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
  check_numbers(result.root, "", "", path);
  return result;
}

}  // namespace vernier
