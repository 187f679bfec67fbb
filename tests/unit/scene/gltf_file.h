#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "error.h"
#include "scene/load_scene.h"
#include "temporary_folder.h"

namespace vernier {

inline constexpr int kByte = 5120, kUnsignedByte = 5121, kShort = 5122, kUnsignedShort = 5123, kUnsignedInt = 5125,
                     kFloat = 5126;

/// `bytes` in base64.
inline std::string base64(const std::string& bytes) {
  const char* alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) word = word << 8 | (i + k < bytes.size() ? std::uint8_t(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? alphabet[word >> (18 - 6 * k) & 63u] : '=';
  }
  return text;
}

/// The bytes of `values` as they lie in memory.
template <typename T>
std::string bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// A glTF file in the making: `json` is free to edit, binary parts gather in buffer 0, a data URI.
struct GltfFile {
  nlohmann::json json = {{"asset", {{"version", "2.0"}}}};
  std::string buffer;
  TemporaryFolder folder;

  /// A bufferView of its own; its index.
  int view(const std::string& bytes) {
    buffer.resize((buffer.size() + 3) / 4 * 4, '\0');
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}});
    buffer += bytes;
    return int(json["bufferViews"].size()) - 1;
  }

  /// An accessor over a view of its own; its index.
  template <typename T>
  int accessor(const std::vector<T>& values, const char* type, int component_type, int components,
               bool normalized = false) {
    json["accessors"].push_back({{"bufferView", view(bytes_of(values))},
                                 {"componentType", component_type},
                                 {"type", type},
                                 {"count", values.size() / std::size_t(components)}});
    if (normalized) json["accessors"].back()["normalized"] = true;
    return int(json["accessors"].size()) - 1;
  }
  int vec3(const std::vector<float>& values) { return accessor(values, "VEC3", kFloat, 3); }

  /// Adds an element to a top-level array; its index.
  int add(const char* array, nlohmann::json element) {
    json[array].push_back(std::move(element));
    return int(json[array].size()) - 1;
  }

  std::string text() {
    nlohmann::json whole = json;
    if (!buffer.empty() && !whole.contains("buffers")) {
      whole["buffers"] = {
          {{"byteLength", buffer.size()}, {"uri", "data:application/octet-stream;base64," + base64(buffer)}}};
    }
    return whole.dump();
  }

  Scene load(bool strict = false) { return finish(open_gltf(folder.write("test.gltf", text()), {.strict = strict})); }
};

/// Corners (0 0 0) (1 0 0) (0 1 0).
inline const std::vector<float> kTriangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};

/// One triangle of mesh 0, shown by node 0, without material. `primitive` is a reference into the file.
inline void add_triangle(GltfFile& file) {
  file.add("meshes", {{"primitives", {{{"attributes", {{"POSITION", file.vec3(kTriangle)}}}}}}});
  file.add("nodes", {{"mesh", 0}});
}

/// Expects load to refuse with one line that names the file and contains `part`.
inline void expect_refused(const std::function<void()>& load, const std::string& part) {
  try {
    load();
    ADD_FAILURE() << "no error; expected one with: " << part;
  } catch (const Error& error) {
    const std::string line = error.what();
    EXPECT_EQ(error.kind(), ErrorKind::refused) << line;
    EXPECT_NE(line.find(part), std::string::npos) << line;
    EXPECT_NE(line.find("test."), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  }
}

inline void expect_refused(GltfFile& file, const std::string& part) {
  expect_refused([&] { file.load(); }, part);
}

/// Whether a warning of `scene` contains `part`.
inline bool has_warning(const Scene& scene, const std::string& part) {
  for (const std::string& warning : scene.warnings) {
    if (warning.find(part) != std::string::npos) return true;
  }
  return false;
}

}  // namespace vernier
