#include "scene/gltf_document.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

#include "error.h"
#include "image/file_format.h"
#include "scene/file_bytes.h"
#include "scene/gltf_container.h"
#include "scene/gltf_extensions.h"
#include "scene/gltf_json.h"
#include "scene/gltf_references.h"
#include "scene/gltf_uri.h"

namespace vernier {
namespace {

using nlohmann::json;

/// A GLB cannot be longer; a text file or buffer beyond it is no still image's scene.
constexpr std::uint64_t kMaxFileBytes = 0xFFFFFFFFu;

/// Nobody reads more, and a hostile file has a fault in each of its million objects.
constexpr std::size_t kMaxWarnings = 100;

/// An image is kept out of tinygltf's way, but its loader must exist.
bool leave_image_encoded(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int,
                         void*) {
  return true;
}

json take_array(json& root, const char* name) {
  json taken = json::array();
  const auto found = root.find(name);
  if (found == root.end()) return taken;
  if (found->is_array()) taken = std::move(*found);
  root.erase(found);
  return taken;
}

std::string string_member(const json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

bool is_fallback_buffer(const json& buffer) {
  return std::ranges::any_of(kMeshoptExtensions, [&](const char* name) {
    const json::json_pointer fallback(std::string("/extensions/") + name);
    return buffer.contains(fallback) && buffer.at(fallback).is_object() &&
           buffer.at(fallback).value("fallback", json()) == json(true);
  });
}

/// Bytes of a buffer, and where they are from, for messages.
struct BufferBytes {
  std::vector<std::byte> bytes;
  std::string source;
};

/// Of `uri`, or of the BIN chunk where it is empty. `place` is that of the buffer.
BufferBytes read_buffer(GltfDocument& document, const std::string& uri, const GltfContainer& container,
                        const std::string& place) {
  const std::string full_place = document.path + ": " + place;
  if (uri.empty()) return {{container.bin.begin(), container.bin.end()}, "the BIN chunk"};
  if (is_data_uri(uri)) return {decode_data_uri(uri, full_place), "the data URI"};
  const std::string path = path_from_uri(uri, document.directory);
  BufferBytes read{read_file_bytes(path, full_place + ": " + uri, kMaxFileBytes), uri};
  note_file(document.files, path);
  return read;
}

GltfBuffer load_buffer(GltfDocument& document, const json& json_buffer, std::size_t index,
                       const GltfContainer& container) {
  const std::string place = "buffer " + std::to_string(index);
  if (!json_buffer.is_object()) refuse_gltf(document, place, "it is not an object");
  const auto length = json_buffer.find("byteLength");
  if (length == json_buffer.end() || !length->is_number_unsigned()) {
    refuse_gltf(document, place, "byteLength is missing or not a positive integer");
  }
  GltfBuffer buffer;
  const std::string uri = string_member(json_buffer, "uri");
  if (is_fallback_buffer(json_buffer) || (uri.empty() && (index > 0 || !container.has_bin))) {
    buffer.is_fallback = true;
    return buffer;
  }
  auto [bytes, source] = read_buffer(document, uri, container, place);
  const std::uint64_t promised = length->get<std::uint64_t>();
  if (promised > bytes.size()) {
    refuse_gltf(
        document, place,
        source + " has " + std::to_string(bytes.size()) + " bytes, byteLength promises " + std::to_string(promised));
  }
  bytes.resize(static_cast<std::size_t>(promised));
  buffer.bytes = std::move(bytes);
  return buffer;
}

GltfImage describe_image(const GltfDocument& document, const json& image, std::size_t index) {
  const std::string place = "image " + std::to_string(index);
  if (!image.is_object()) refuse_gltf(document, place, "it is not an object");
  GltfImage result{string_member(image, "name"), string_member(image, "uri"), -1};
  const auto view = image.find("bufferView");
  if (view == image.end()) return result;
  if (!view->is_number_unsigned()) refuse_gltf(document, place, "bufferView is not an index");
  result.buffer_view = view->get<int>();
  return result;
}

// tinygltf refuses indices whose accessor has no bufferView, which KHR_draco_mesh_compression calls for: such accessors
// are lent one beyond the last, and lose it after parsing. Returns which were.
std::vector<bool> lend_views(json& root) {
  if (!root.contains("bufferViews") || !root["bufferViews"].is_array()) root["bufferViews"] = json::array();
  const std::size_t lent_view = root["bufferViews"].size();
  root["bufferViews"].push_back({{"buffer", 0}, {"byteLength", 1}});
  std::vector<bool> lent;
  const auto accessors = root.find("accessors");
  if (accessors == root.end() || !accessors->is_array()) return lent;
  for (json& accessor : *accessors) {
    lent.push_back(accessor.is_object() && !accessor.contains("bufferView"));
    if (lent.back()) accessor["bufferView"] = lent_view;
  }
  return lent;
}

void take_views_back(tinygltf::Model& model, const std::vector<bool>& lent) {
  model.bufferViews.pop_back();
  for (std::size_t i = 0; i < lent.size() && i < model.accessors.size(); ++i) {
    if (lent[i]) model.accessors[i].bufferView = -1;
  }
}

// tinygltf complains of a skin without inverse bind matrices, which are identities then.
void name_missing_inverse_binds(json& root) {
  const auto skins = root.find("skins");
  if (skins == root.end() || !skins->is_array()) return;
  for (json& skin : *skins) {
    if (skin.is_object() && !skin.contains("inverseBindMatrices")) skin["inverseBindMatrices"] = -1;
  }
}

/// The first line of what tinygltf has to say.
std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

void parse_model(GltfDocument& document, json& root) {
  const std::vector<bool> lent = lend_views(root);
  name_missing_inverse_binds(root);
  tinygltf::TinyGLTF parser;
  parser.SetImageLoader(leave_image_encoded, nullptr);
  std::string error;
  std::string warning;
  bool parsed = false;
  try {
    const std::string text = root.dump();
    parsed = parser.LoadASCIIFromString(&document.model, &error, &warning, text.data(),
                                        static_cast<unsigned int>(text.size()), document.directory);
  } catch (const std::exception& failure) {
    error = failure.what();
  }
  if (!parsed || !error.empty()) {
    refuse_gltf(document, "", error.empty() ? "not a valid glTF file" : first_line(error));
  }
  take_views_back(document.model, lent);
}

void check_names(const GltfDocument& document, const json& root, const char* name) {
  const auto found = root.find(name);
  if (found == root.end()) return;
  const bool are_names =
      found->is_array() && std::ranges::all_of(*found, [](const json& one) { return one.is_string(); });
  if (!are_names) refuse_gltf(document, name, "is no list of names");
}

}  // namespace

void refuse_gltf(const GltfDocument& document, const std::string& place, const std::string& what) {
  throw Error(ErrorKind::refused, document.path + ": " + (place.empty() ? what : place + ": " + what));
}

void warn_gltf(GltfDocument& document, const std::string& place, const std::string& what) {
  const std::string line = place.empty() ? what : place + ": " + what;
  const std::size_t count = document.warnings.size();
  if (count > kMaxWarnings ||
      std::find(document.warnings.begin(), document.warnings.end(), line) != document.warnings.end()) {
    return;
  }
  document.warnings.push_back(count < kMaxWarnings ? line : "further warnings are left out");
}

void unsupported_gltf(GltfDocument& document, const std::string& place, const std::string& what) {
  if (document.strict) refuse_gltf(document, place, what);
  warn_gltf(document, place, what);
}

GltfDocument read_gltf_document(const std::string& path, const LoadOptions& options) {
  const bool binary_expected = lower_case_extension(path) == ".glb";
  const auto check_start = [&](std::string_view start) { check_gltf_start(start, path, binary_expected); };
  return parse_gltf_document(read_file_bytes(path, path, kMaxFileBytes, check_start), path, options);
}

GltfDocument parse_gltf_document(std::span<const std::byte> file, const std::string& path, const LoadOptions& options) {
  GltfDocument document;
  document.path = path;
  document.directory = std::filesystem::path(path).parent_path().string();
  document.strict = options.strict;
  const GltfContainer container = split_gltf_container(file, path);
  GltfJson parsed = parse_gltf_json(container.json, path);

  // tinygltf passes over what is no list of names.
  check_names(document, parsed.root, "extensionsRequired");
  check_names(document, parsed.root, "extensionsUsed");
  const json buffers = take_array(parsed.root, "buffers");
  const json images = take_array(parsed.root, "images");
  const bool is_animated = !take_array(parsed.root, "animations").empty();
  parse_model(document, parsed.root);
  check_gltf_extensions(document, parsed.extension_places);
  if (is_animated) warn_gltf(document, "animations", "ignored, the default pose is shown");
  for (std::size_t i = 0; i < images.size(); ++i) document.images.push_back(describe_image(document, images[i], i));
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    document.buffers.push_back(std::make_shared<const GltfBuffer>(load_buffer(document, buffers[i], i, container)));
  }
  check_gltf_references(document);
  return document;
}

std::span<const std::byte> gltf_view_bytes(const GltfDocument& document, int view, const std::string& place) {
  const tinygltf::BufferView& buffer_view = document.model.bufferViews[static_cast<std::size_t>(view)];
  const GltfBuffer& buffer = *document.buffers[static_cast<std::size_t>(buffer_view.buffer)];
  const std::string name = "bufferView " + std::to_string(view);
  if (buffer.is_fallback) {
    refuse_gltf(document, place, name + " reads buffer " + std::to_string(buffer_view.buffer) + ", which has no bytes");
  }
  const std::size_t size = buffer.bytes.size();
  if (buffer_view.byteOffset > size || buffer_view.byteLength > size - buffer_view.byteOffset) {
    refuse_gltf(
        document, place,
        name + " goes beyond the " + std::to_string(size) + " bytes of buffer " + std::to_string(buffer_view.buffer));
  }
  return std::span(buffer.bytes).subspan(buffer_view.byteOffset, buffer_view.byteLength);
}

}  // namespace vernier
