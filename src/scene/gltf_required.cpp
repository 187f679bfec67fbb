#include "scene/gltf_required.h"

#include <algorithm>
#include <string_view>

#include "error.h"
#include "scene/gltf_types.h"

namespace vernier {
namespace {

using nlohmann::json;

/// A member that objects have: of the list or the member `owner`.
struct Required {
  std::string_view owner, name;
};

constexpr Required kRequired[] = {
    {"accessors", "componentType"},
    {"accessors", "count"},
    {"accessors", "type"},
    {"baseColorTexture", "index"},
    {"bufferViews", "buffer"},
    {"bufferViews", "byteLength"},
    {"cameras", "type"},
    {"diffuseTexture", "index"},
    {"emissiveTexture", "index"},
    {"EXT_texture_webp", "source"},
    {"indices", "bufferView"},
    {"indices", "componentType"},
    {"lights", "type"},
    {"metallicRoughnessTexture", "index"},
    {"normalTexture", "index"},
    {"occlusionTexture", "index"},
    {"orthographic", "xmag"},
    {"orthographic", "ymag"},
    {"orthographic", "zfar"},
    {"orthographic", "znear"},
    {"perspective", "yfov"},
    {"perspective", "znear"},
    {"primitives", "attributes"},
    {"skins", "joints"},
    {"sparse", "count"},
    {"sparse", "indices"},
    {"sparse", "values"},
    {"specularColorTexture", "index"},
    {"specularGlossinessTexture", "index"},
    {"specularTexture", "index"},
    {"thicknessTexture", "index"},
    {"transmissionTexture", "index"},
    {"values", "bufferView"},
};

/// Those of OpenGL, which the parser knows; that glTF has no int and no double is said where they are read.
constexpr int kComponentTypes[] = {5120, 5121, 5122, 5123, 5124, 5125, 5126, 5130};
/// Members of the file that are looked into.
constexpr std::string_view kLists[] = {"accessors", "bufferViews", "cameras", "extensions", "materials",
                                       "meshes",    "nodes",       "skins",   "textures"};
constexpr std::string_view kElementTypes[] = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
constexpr std::string_view kCameraTypes[] = {"perspective", "orthographic"};

class RequiredCheck {
 public:
  RequiredCheck(const json& root, std::string path) : root_(root), path_(std::move(path)) {}

  /// Of `value`, the member `owner` of an object or an element of such a list.
  void check(const json& value, const std::string& owner, const std::string& place) const {
    if (value.is_array()) {
      for (std::size_t i = 0; i < value.size(); ++i) {
        const std::string element = gltf_element_name(owner, i);
        check(value[i], owner, place.empty() ? element : owner == "primitives" ? place + ", " + element : place);
      }
      return;
    }
    if (!value.is_object()) return;
    for (const Required& one : kRequired) {
      if (one.owner == owner) need(value, std::string(one.name), inside(place, owner));
    }
    check_values(value, owner, place);
    for (const auto& [name, member] : value.items()) {
      if (owner.empty() && std::ranges::find(kLists, name) == std::end(kLists)) continue;
      if (name != "extensions") {
        check(member, name, place);
        continue;
      }
      for (const auto& [extension, content] : member.items()) {
        if (is_checked_gltf_extension(extension)) check(content, extension, place);
      }
    }
  }

 private:
  /// "material 3, baseColorTexture"; what is an element of a list of the file has the place alone.
  static std::string inside(const std::string& place, const std::string& owner) {
    return owner.ends_with('s') && owner != "indices" && owner != "values" ? place : place + ", " + owner;
  }

  void need(const json& value, const std::string& name, const std::string& place) const {
    if (!value.contains(name)) refuse(path_ + ": " + place, name + " is missing");
  }

  template <typename Choices>
  void need_one_of(const json& value, const char* name, const std::string& place, const Choices& choices) const {
    const json& is = value[name];
    if (std::ranges::none_of(choices, [&](const auto& one) { return is == one; })) {
      refuse(path_ + ": " + place, std::string(name) + " is " + is.dump().substr(0, 40) + ", which glTF does not have");
    }
  }

  void need_element(const json& value, const char* name, const char* list, const std::string& place) const {
    const auto index = value.find(name);
    const std::size_t count = root_.contains(list) ? root_[list].size() : 0;
    if (index == value.end() || index->get<std::uint64_t>() < count) return;
    refuse(path_ + ": " + place, gltf_element_name(list, index->get<std::uint64_t>()) +
                                     " does not exist, the file has " + std::to_string(count));
  }

  void check_values(const json& value, const std::string& owner, const std::string& place) const {
    if (owner == "accessors") {
      need_one_of(value, "componentType", place, kComponentTypes);
      need_one_of(value, "type", place, kElementTypes);
      need_element(value, "bufferView", "bufferViews", place);
    } else if (owner == "primitives") {
      need_element(value, "indices", "accessors", place);
    } else if (owner == "cameras") {
      need_one_of(value, "type", place, kCameraTypes);
      need(value, value["type"].get<std::string>(), place);
    } else if (owner == "lights" && value["type"] == "spot") {
      need(value, "spot", place);
    } else if (owner == "KHR_lights_punctual" && !place.empty()) {
      need(value, "light", place + ", " + owner);
    } else if (owner == "bufferViews" && value.contains("byteStride") &&
               value["byteStride"].get<std::uint64_t>() % 4 != 0) {
      refuse(path_ + ": " + place, "byteStride is " + value["byteStride"].dump() + ", no multiple of 4");
    }
  }

  const json& root_;
  std::string path_;
};

}  // namespace

void check_gltf_required(const json& root, const std::string& path) {
  RequiredCheck(root, path).check(root, "", "");
}

}  // namespace vernier
