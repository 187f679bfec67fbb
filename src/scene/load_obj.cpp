#include <algorithm>
#include <optional>

#include "error.h"
#include "math/parallel_for.h"
#include "scene/file_bytes.h"
#include "scene/load_scene.h"
#include "scene/obj_materials.h"
#include "scene/obj_meshes.h"
#include "scene/parse_obj.h"
#include "scene/text_words.h"

namespace vernier {
namespace {

// Index of each material that usemtl names, and of the one for faces without.
struct MaterialChoice {
  std::vector<std::uint32_t> by_name;
  std::uint32_t none = 0;
};

/// A part for each core, but of a megabyte at least.
std::size_t choose_part_count(std::size_t bytes) {
  constexpr std::size_t kLeastPartBytes = std::size_t{1} << 20;
  return std::clamp<std::size_t>(bytes / kLeastPartBytes, 1, resolve_thread_count(0));
}

using MaterialIndex = std::map<std::string, std::uint32_t>;

/// `index_by_name` by names without comments; of several the first by name.
MaterialIndex without_comments(const MaterialIndex& index_by_name) {
  MaterialIndex bare;
  for (const auto& [name, index] : index_by_name) bare.try_emplace(std::string(without_comment(name)), index);
  return bare;
}

/// The material `name`; of names that are in no library that of the same but for comments behind either.
std::optional<std::uint32_t> find_material(const MaterialIndex& index_by_name, const MaterialIndex& bare,
                                           const std::string& name) {
  const auto found = index_by_name.find(name);
  if (found != index_by_name.end()) return found->second;
  const auto alike = bare.find(std::string(without_comment(name)));
  return alike == bare.end() ? std::nullopt : std::optional(alike->second);
}

MaterialChoice choose_materials(Scene& scene, const ObjGeometry& geometry, const MaterialIndex& index_by_name,
                                const LoadOptions& options) {
  const MaterialIndex bare = without_comments(index_by_name);
  MaterialChoice choice;
  choice.none = static_cast<std::uint32_t>(scene.materials.size());
  scene.materials.push_back(default_obj_material());
  std::size_t unknown_count = 0;
  std::string first_unknown;
  for (const std::string& name : geometry.material_names) {
    const std::optional<std::uint32_t> found = find_material(index_by_name, bare, name);
    choice.by_name.push_back(found.value_or(choice.none));
    if (!found && unknown_count++ == 0) first_unknown = name;
  }
  if (unknown_count > 0) {
    const std::string others = unknown_count == 1 ? " is" : " and " + std::to_string(unknown_count - 1) + " more are";
    warn_unsupported(
        scene, options,
        scene.source + ": material " + printable(first_unknown) + others + " in no material library and shown grey");
  }
  return choice;
}

}  // namespace

LoadingScene open_obj(const std::string& path, const LoadOptions& options) {
  LoadingScene loading;
  Scene& scene = loading.scene;
  scene.source = path;
  const std::string text = read_text(path);
  const ObjGeometry geometry = parse_obj(path, text, choose_part_count(text.size()));
  scene.files.push_back(path);
  if (geometry.shapes.empty()) throw Error(ErrorKind::refused, path + ": no faces");
  for (const std::string& line : geometry.unsupported) warn_unsupported(scene, options, path + ": " + line);
  for (const std::string& line : geometry.faults) scene.warnings.push_back(path + ": " + line);
  const auto index_by_name = load_obj_materials(loading, path, geometry.material_libraries, options);
  const MaterialChoice choice = choose_materials(scene, geometry, index_by_name, options);
  add_obj_meshes(scene, geometry, choice.by_name, choice.none);
  return loading;
}

}  // namespace vernier
