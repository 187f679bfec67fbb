#include "scene/gltf_types.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <utility>

#include "error.h"

namespace vernier {
namespace {

using nlohmann::json;

/// Members that are indices, sizes or enumerators: whole numbers from 0.
constexpr std::array<std::string_view, 25> kWholeNumbers = {
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
    "light",
};

/// Lists of them, by the member that holds the object they are in.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kWholeNumberLists = {
    {{"scenes", "nodes"}, {"nodes", "children"}, {"skins", "joints"}}};

constexpr std::array<std::string_view, 14> kObjectLists = {
    "accessors", "buffers",  "bufferViews", "cameras", "images",  "materials", "meshes",
    "nodes",     "samplers", "scenes",      "skins",   "targets", "textures",  "primitives",
};

constexpr std::array<std::string_view, 15> kObjects = {
    "attributes",
    "baseColorTexture",
    "diffuseTexture",
    "emissiveTexture",
    "metallicRoughnessTexture",
    "normalTexture",
    "occlusionTexture",
    "pbrMetallicRoughness",
    "sparse",
    "specularColorTexture",
    "specularGlossinessTexture",
    "specularTexture",
    "spot",
    "thicknessTexture",
    "transmissionTexture",
};

/// Members that are a number. (Bounds of accessors are not looked at: exporters write null for NaN.)
constexpr std::array<std::string_view, 23> kNumbers = {
    "alphaCutoff",
    "aspectRatio",
    "attenuationDistance",
    "emissiveStrength",
    "glossinessFactor",
    "innerConeAngle",
    "intensity",
    "ior",
    "metallicFactor",
    "outerConeAngle",
    "range",
    "rotation",
    "roughnessFactor",
    "scale",
    "specularFactor",
    "strength",
    "thicknessFactor",
    "transmissionFactor",
    "xmag",
    "yfov",
    "ymag",
    "zfar",
    "znear",
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

/// A list of at least so many numbers.
struct Vector {
  std::string_view key;  ///< of the object that it is in
  std::string_view name;
  std::size_t length;
};

/// What nobody counts later.
constexpr std::array<Vector, 7> kVectors = {{{"KHR_materials_volume", "attenuationColor", 3},
                                             {"KHR_materials_specular", "specularColorFactor", 3},
                                             {"KHR_materials_pbrSpecularGlossiness", "diffuseFactor", 4},
                                             {"KHR_materials_pbrSpecularGlossiness", "specularFactor", 3},
                                             {"KHR_texture_transform", "offset", 2},
                                             {"KHR_texture_transform", "scale", 2},
                                             {"lights", "color", 3}}};

/// Extensions that are looked into; what is compressed has checks of its own, members of others are theirs.
constexpr std::array<std::string_view, 12> kExtensions = {
    "EXT_mesh_gpu_instancing", "EXT_texture_webp",
    "KHR_lights_punctual",     "KHR_materials_emissive_strength",
    "KHR_materials_ior",       "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_specular",  "KHR_materials_transmission",
    "KHR_materials_unlit",     "KHR_materials_volume",
    "KHR_node_visibility",     "KHR_texture_transform",
};

[[noreturn]] void refuse(const std::string& path, const std::string& place, const std::string& name, const json& member,
                         const std::string& missed) {
  throw Error(ErrorKind::refused, path + ": " + (place.empty() ? "" : place + ": ") + name + " is " +
                                      member.dump().substr(0, 40) + ", not " + missed);
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
  const bool is_lights = key == "KHR_lights_punctual" && name == "lights";
  if (is_lights || (is_one_of(name, kObjectLists) && (key.empty() || key == "meshes" || key == "primitives"))) {
    return is_list_of(member, is_object) ? "" : "a list of objects";
  }
  if (member.is_null()) return "";  // what some exporters write for what they do not know
  if (key == "KHR_node_visibility" && name == "visible") return member.is_boolean() ? "" : "true or false";
  for (const Vector& vector : kVectors) {
    if (vector.key != key || vector.name != name) continue;
    const bool holds = is_list_of(member, is_number) && member.size() >= vector.length;
    return holds ? "" : "a list of " + std::to_string(vector.length) + " numbers";
  }
  if (is_one_of(name, kObjects)) return member.is_object() ? "" : "an object";
  if (is_one_of(key, name, kNumberLists)) return is_list_of(member, is_number) ? "" : "a list of numbers";
  return is_one_of(name, kNumbers) && !member.is_number() ? "a number" : "";
}

void check_members(const json& value, const std::string& key, const std::string& place, const std::string& path);

void check_extensions(const json& extensions, const std::string& place, const std::string& path) {
  if (!extensions.is_object()) return;
  for (const auto& [name, extension] : extensions.items()) {
    if (!is_one_of(name, kExtensions)) continue;
    if (!extension.is_object()) refuse(path, place, name, extension, "an object");
    check_members(extension, name, place, path);
  }
}

void check_members(const json& value, const std::string& key, const std::string& place, const std::string& path) {
  if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      check_members(value[i], key, place.empty() ? gltf_element_name(key, i) : place, path);
    }
    return;
  }
  if (!value.is_object()) return;
  for (const auto& [name, member] : value.items()) {
    if (name == "animations") continue;
    if (name == "extensions") {
      check_extensions(member, place, path);
      continue;
    }
    const std::string missed = missed_type(key, name, member);
    if (!missed.empty()) refuse(path, place, name, member, missed);
    check_members(member, name, place, path);
  }
}

}  // namespace

std::string gltf_element_name(const std::string& array, std::size_t index) {
  std::string singular = array == "meshes" ? "mesh" : array;
  if (singular.ends_with('s')) singular.pop_back();
  return singular + " " + std::to_string(index);
}

void check_gltf_types(const json& root, const std::string& path) {
  check_members(root, "", "", path);
}

}  // namespace vernier
