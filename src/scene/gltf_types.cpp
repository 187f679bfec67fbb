#include "scene/gltf_types.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string_view>

#include "error.h"

namespace vernier {
namespace {

using nlohmann::json;

enum class Type {
  whole,
  wholes,
  small_count,
  number,
  numbers,
  vector2,
  vector3,
  vector4,
  truth,
  text,
  object,
  objects
};

/// A member of an object; what is not listed may be anything.
struct Member {
  std::string_view owner;  ///< the name of the member that holds the object, or its list: "" of the file, "*" any
  std::string_view name;   ///< "*" any
  Type type;
};

/// The first that fits counts. Bounds of accessors are not looked at: exporters write null for NaN. How many numbers a
/// node's member has is looked at later; nobody else counts those of others.
constexpr Member kMembers[] = {
    {"", "accessors", Type::objects},
    {"", "buffers", Type::objects},
    {"", "bufferViews", Type::objects},
    {"", "cameras", Type::objects},
    {"", "images", Type::objects},
    {"", "materials", Type::objects},
    {"", "meshes", Type::objects},
    {"", "nodes", Type::objects},
    {"", "samplers", Type::objects},
    {"", "scenes", Type::objects},
    {"", "skins", Type::objects},
    {"", "textures", Type::objects},
    {"meshes", "primitives", Type::objects},
    {"primitives", "targets", Type::objects},
    {"KHR_lights_punctual", "lights", Type::objects},

    {"attributes", "*", Type::whole},
    {"targets", "*", Type::whole},
    {"scenes", "nodes", Type::wholes},
    {"nodes", "children", Type::wholes},
    {"skins", "joints", Type::wholes},
    {"sparse", "count", Type::small_count},
    {"sparse", "indices", Type::object},
    {"sparse", "values", Type::object},
    {"*", "buffer", Type::whole},
    {"*", "bufferView", Type::whole},
    {"*", "byteLength", Type::whole},
    {"*", "byteOffset", Type::whole},
    {"*", "byteStride", Type::whole},
    {"*", "camera", Type::whole},
    {"*", "componentType", Type::whole},
    {"*", "count", Type::whole},
    {"*", "index", Type::whole},
    {"*", "indices", Type::whole},
    {"*", "inverseBindMatrices", Type::whole},
    {"*", "light", Type::whole},
    {"*", "magFilter", Type::whole},
    {"*", "material", Type::whole},
    {"*", "mesh", Type::whole},
    {"*", "minFilter", Type::whole},
    {"*", "mode", Type::whole},
    {"*", "sampler", Type::whole},
    {"*", "scene", Type::whole},
    {"*", "skeleton", Type::whole},
    {"*", "skin", Type::whole},
    {"*", "source", Type::whole},
    {"*", "texCoord", Type::whole},
    {"*", "wrapS", Type::whole},
    {"*", "wrapT", Type::whole},

    {"nodes", "matrix", Type::numbers},
    {"nodes", "rotation", Type::numbers},
    {"nodes", "scale", Type::numbers},
    {"nodes", "translation", Type::numbers},
    {"nodes", "weights", Type::numbers},
    {"meshes", "weights", Type::numbers},
    {"materials", "emissiveFactor", Type::vector3},
    {"pbrMetallicRoughness", "baseColorFactor", Type::vector4},
    {"lights", "color", Type::vector3},
    {"KHR_materials_pbrSpecularGlossiness", "diffuseFactor", Type::vector4},
    {"KHR_materials_pbrSpecularGlossiness", "specularFactor", Type::vector3},
    {"KHR_materials_specular", "specularColorFactor", Type::vector3},
    {"KHR_materials_volume", "attenuationColor", Type::vector3},
    {"KHR_texture_transform", "offset", Type::vector2},
    {"KHR_texture_transform", "scale", Type::vector2},
    {"*", "alphaCutoff", Type::number},
    {"*", "aspectRatio", Type::number},
    {"*", "attenuationDistance", Type::number},
    {"*", "emissiveStrength", Type::number},
    {"*", "glossinessFactor", Type::number},
    {"*", "innerConeAngle", Type::number},
    {"*", "intensity", Type::number},
    {"*", "ior", Type::number},
    {"*", "metallicFactor", Type::number},
    {"*", "outerConeAngle", Type::number},
    {"*", "range", Type::number},
    {"*", "rotation", Type::number},
    {"*", "roughnessFactor", Type::number},
    {"*", "scale", Type::number},
    {"*", "specularFactor", Type::number},
    {"*", "strength", Type::number},
    {"*", "thicknessFactor", Type::number},
    {"*", "transmissionFactor", Type::number},
    {"*", "xmag", Type::number},
    {"*", "yfov", Type::number},
    {"*", "ymag", Type::number},
    {"*", "zfar", Type::number},
    {"*", "znear", Type::number},
    {"accessors", "normalized", Type::truth},
    {"KHR_node_visibility", "visible", Type::truth},
    {"accessors", "type", Type::text},
    {"cameras", "type", Type::text},
    {"lights", "type", Type::text},
    {"materials", "alphaMode", Type::text},

    {"*", "attributes", Type::object},
    {"*", "baseColorTexture", Type::object},
    {"*", "diffuseTexture", Type::object},
    {"*", "emissiveTexture", Type::object},
    {"*", "metallicRoughnessTexture", Type::object},
    {"*", "normalTexture", Type::object},
    {"*", "occlusionTexture", Type::object},
    {"*", "orthographic", Type::object},
    {"*", "pbrMetallicRoughness", Type::object},
    {"*", "perspective", Type::object},
    {"*", "sparse", Type::object},
    {"*", "specularColorTexture", Type::object},
    {"*", "specularGlossinessTexture", Type::object},
    {"*", "specularTexture", Type::object},
    {"*", "spot", Type::object},
    {"*", "thicknessTexture", Type::object},
    {"*", "transmissionTexture", Type::object},
};

/// Extensions that are looked into; what is compressed has checks of its own, members of others are theirs.
constexpr std::string_view kExtensions[] = {
    "EXT_mesh_gpu_instancing", "EXT_texture_webp",
    "KHR_lights_punctual",     "KHR_materials_emissive_strength",
    "KHR_materials_ior",       "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_specular",  "KHR_materials_transmission",
    "KHR_materials_unlit",     "KHR_materials_volume",
    "KHR_node_visibility",     "KHR_texture_transform",
};

/// Whether `list` is one, of `least` elements or more, which all are so: exporters add a fourth to a colour.
bool are_all(const json& list, bool (json::*is)() const noexcept, std::size_t least = 0) {
  return list.is_array() && list.size() >= least &&
         std::ranges::all_of(list, [&](const json& one) { return (one.*is)(); });
}

/// What `value` is not, or empty.
std::string_view missed_type(const json& value, Type type) {
  constexpr auto kIntMax = static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max());
  const auto unless = [](bool holds, std::string_view what) { return holds ? "" : what; };
  switch (type) {
    case Type::whole:
      return unless(value.is_number_unsigned(), "a whole number from 0");
    case Type::wholes:
      return unless(are_all(value, &json::is_number_unsigned), "a list of whole numbers from 0");
    case Type::objects:
      return unless(are_all(value, &json::is_object), "a list of objects");
    case Type::small_count:
      if (!value.is_number_unsigned()) return "a whole number from 0";
      return unless(value.get<std::uint64_t>() <= kIntMax, "a number below 2^31");
    default:
      break;
  }
  if (value.is_null()) return "";  // what some exporters write for what they do not know
  switch (type) {
    case Type::number:
      return unless(value.is_number(), "a number");
    case Type::numbers:
      return unless(are_all(value, &json::is_number), "a list of numbers");
    case Type::vector2:
      return unless(are_all(value, &json::is_number, 2), "a list of 2 numbers");
    case Type::vector3:
      return unless(are_all(value, &json::is_number, 3), "a list of 3 numbers");
    case Type::vector4:
      return unless(are_all(value, &json::is_number, 4), "a list of 4 numbers");
    case Type::truth:
      return unless(value.is_boolean(), "true or false");
    case Type::text:
      return unless(value.is_string(), "a text");
    default:
      return unless(value.is_object(), "an object");
  }
}

void check_type(const json& value, Type type, const std::string& name, const std::string& place,
                const std::string& path) {
  const std::string_view missed = missed_type(value, type);
  if (missed.empty()) return;
  throw Error(ErrorKind::refused, path + ": " + (place.empty() ? "" : place + ": ") + name + " is " +
                                      value.dump().substr(0, 40) + ", not " + std::string(missed));
}

void check_value(const json& value, const std::string& owner, const std::string& place, const std::string& path);

void check_extensions(const json& extensions, const std::string& place, const std::string& path) {
  if (extensions.is_array() && extensions.empty()) return;  // an empty table of Lua or PHP
  check_type(extensions, Type::object, "extensions", place, path);
  if (!extensions.is_object()) return;  // null
  for (const auto& [name, extension] : extensions.items()) {
    if (!is_checked_gltf_extension(name)) continue;
    check_type(extension, Type::object, name, place, path);
    check_value(extension, name, place, path);
  }
}

/// Checks what is in `value`, the member `owner` of an object or an element of such a list.
void check_value(const json& value, const std::string& owner, const std::string& place, const std::string& path) {
  if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      check_value(value[i], owner, place.empty() ? gltf_element_name(owner, i) : place, path);
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
    const auto fits = [&](const Member& one) {
      return (one.owner == "*" || one.owner == owner) && (one.name == "*" || one.name == name);
    };
    const auto found = std::ranges::find_if(kMembers, fits);
    if (found != std::end(kMembers)) check_type(member, found->type, name, place, path);
    check_value(member, name, place, path);
  }
}

}  // namespace

std::string gltf_element_name(const std::string& array, std::size_t index) {
  std::string singular = array == "meshes" ? "mesh" : array;
  if (singular.ends_with('s')) singular.pop_back();
  return singular + " " + std::to_string(index);
}

bool is_checked_gltf_extension(std::string_view name) {
  return std::ranges::find(kExtensions, name) != std::end(kExtensions);
}

void check_gltf_types(const json& root, const std::string& path) {
  check_value(root, "", "", path);
}

}  // namespace vernier
