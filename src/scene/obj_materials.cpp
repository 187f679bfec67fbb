#include "scene/obj_materials.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "error.h"
#include "scene/file_bytes.h"
#include "scene/find_file.h"
#include "scene/text_words.h"

namespace vernier {
namespace {

constexpr glm::dvec3 kBlack(0.0);
constexpr glm::dvec3 kWhite(1.0);
constexpr glm::dvec3 kDefaultDiffuse(0.8);  // a light clay, as most viewers show
constexpr double kDefaultExponent = 10.0;   // a wide highlight, as of matt plastic
constexpr double kDefaultIor = 1.5;         // window glass

const MtlTexture& map_of(const MtlMaterial& source, MtlMap map) {
  return source.maps[static_cast<std::size_t>(map)];
}
bool has_map(const MtlMaterial& source, MtlMap map) {
  return !map_of(source, map).file.empty();
}

// Large values become the largest float, so that no product with a texture starts from infinity.
float finite_float(double value) {
  return static_cast<float>(std::clamp(value, -1e30, 1e30));
}
glm::vec3 finite_floats(const glm::dvec3& v) {
  return {finite_float(v.x), finite_float(v.y), finite_float(v.z)};
}

glm::dvec3 color_or_map(const std::optional<glm::dvec3>& color, const MtlMaterial& source, MtlMap map,
                        const glm::dvec3& absent) {
  return color.value_or(has_map(source, map) ? kWhite : absent);
}

bool ambient_is_diffuse(const MtlMaterial& source) {
  return !source.ambient || *source.ambient == kWhite || *source.ambient == kBlack || source.ambient == source.diffuse;
}

/// Models 4 and 9 are glass where something lets light through: exporters write 4, `Tf 1 1 1` and `Ni 1` for whatever
/// is opaque, too, which is 2 then.
int illumination_of(const MtlMaterial& source) {
  const bool shiny = source.specular.value_or(kBlack) != kBlack && source.exponent.value_or(0.0) > 0.0;
  const int illumination = source.illumination.value_or(shiny ? 2 : 1);
  if (illumination != 4 && illumination != 9) return illumination;
  const bool is_dissolved = source.opacity.value_or(1.0) < 1.0 || has_map(source, MtlMap::dissolve);
  return is_dissolved || source.ior.value_or(1.0) != 1.0 ? illumination : 2;
}

bool is_mirror(int illumination) {
  return illumination == 3 || illumination == 5 || illumination == 8;
}
bool is_glass(int illumination) {
  return illumination == 4 || illumination == 6 || illumination == 7 || illumination == 9;
}

void make_glass(Material& material, const MtlMaterial& source, double opacity, const std::string& place,
                std::vector<std::string>& warnings) {
  material.thin_walled = false;
  material.transmission = finite_floats(source.transmission.value_or(kWhite));
  if (!source.transmission && opacity < 1.0) {
    material.transmission = glm::vec3(finite_float(1.0 - opacity));
    material.base_color *= glm::vec4(glm::vec3(finite_float(opacity)), 1.0f);
  }
  if (!(source.ior.value_or(0.0) > 0.0)) {
    warnings.push_back(place + ": glass without an index of refraction above 0 (Ni); 1.5 is taken");
  }
}

}  // namespace

void warn_unsupported(Scene& scene, const LoadOptions& options, const std::string& line) {
  if (options.strict) throw Error(ErrorKind::refused, line);
  scene.warnings.push_back(line);
}

Material default_obj_material() {
  std::vector<std::string> none;
  MtlMaterial source;
  source.name = "default";
  return blinn_material(source, source.name, none);
}

Material blinn_material(const MtlMaterial& source, const std::string& place, std::vector<std::string>& warnings) {
  const int illumination = illumination_of(source);
  const glm::dvec3 diffuse = color_or_map(source.diffuse, source, MtlMap::diffuse, kDefaultDiffuse);
  const glm::dvec3 specular = color_or_map(source.specular, source, MtlMap::specular, kBlack);
  const double opacity = std::clamp(source.opacity.value_or(1.0), 0.0, 1.0);
  Material material;
  material.name = source.name;
  material.workflow = Workflow::blinn;
  material.base_color = glm::vec4(finite_floats(diffuse), 1.0f);
  // Exporters write Ns 0 for what is rough all over; by the formula its highlight would be white from everywhere.
  const bool has_highlight = illumination >= 2 && source.exponent.value_or(kDefaultExponent) > 0.0;
  material.specular = has_highlight ? finite_floats(specular) : glm::vec3(0.0f);
  material.exponent = finite_float(std::max(source.exponent.value_or(kDefaultExponent), 0.0));
  material.emission = finite_floats(color_or_map(source.emission, source, MtlMap::emission, kBlack));
  material.ambient = ambient_is_diffuse(source) ? finite_floats(diffuse) : finite_floats(*source.ambient);
  material.ior = finite_float(source.ior.value_or(0.0) > 0.0 ? std::max(*source.ior, 1e-6) : kDefaultIor);
  material.unlit = illumination == 0;
  material.fresnel_reflection = illumination >= 4 && illumination != 6 && illumination != 8;
  if (is_mirror(illumination) || is_glass(illumination)) {
    material.reflection = glm::min(finite_floats(specular), glm::vec3(1.0f));
  }
  if (is_mirror(illumination) && specular == kBlack) material.fresnel_reflection = false;
  if (is_glass(illumination)) {
    make_glass(material, source, opacity, place, warnings);
  } else {
    material.base_color.a = static_cast<float>(opacity);
    if (opacity < 1.0) material.alpha_mode = AlphaMode::blend;
  }
  if (has_map(source, MtlMap::dissolve)) material.alpha_mode = AlphaMode::blend;
  return material;
}

namespace {

/// Files of normal maps that heights would stand in for, should they be broken.
std::set<std::string> normals_with_heights(const MtlLibrary& library) {
  std::set<std::string> files;
  for (const MtlMaterial& source : library.materials) {
    if (has_map(source, MtlMap::bump)) files.insert(map_of(source, MtlMap::normal).file);
  }
  return files;
}

/// Normal maps of the files `at_once` are decoded at once.
void add_textures(Scene& scene, ObjTextures& textures, Material& material, const MtlMaterial& source,
                  const std::string& folder, const std::set<std::string>& at_once) {
  const auto use = [&](MtlMap map, MtlMapUse as, Decoding decoding = Decoding::later) {
    return use_obj_texture(scene, textures, map_of(source, map), as, folder, decoding);
  };
  std::array<TextureUse, TEXTURE_SLOT_COUNT>& slots = material.textures;
  slots[TEXTURE_SLOT_BASE_COLOR] = use(MtlMap::diffuse, MtlMapUse::color);
  slots[TEXTURE_SLOT_EMISSION] = use(MtlMap::emission, MtlMapUse::color);
  slots[TEXTURE_SLOT_SURFACE] = use(MtlMap::specular, MtlMapUse::color);
  slots[TEXTURE_SLOT_SPECULAR] = use(MtlMap::exponent, MtlMapUse::scalar);
  slots[TEXTURE_SLOT_ALPHA] = use(MtlMap::dissolve, MtlMapUse::scalar);
  slots[TEXTURE_SLOT_SPECULAR_COLOR] = use(MtlMap::ambient, MtlMapUse::color);
  // Where Ka stands for Kd it takes the picture along.
  if (!has_map(source, MtlMap::ambient) && ambient_is_diffuse(source)) {
    slots[TEXTURE_SLOT_SPECULAR_COLOR] = slots[TEXTURE_SLOT_BASE_COLOR];
  }
  // Heights stand in for normals that are missing or broken.
  const bool is_asked = at_once.contains(map_of(source, MtlMap::normal).file);
  const Decoding decoding = is_asked ? Decoding::at_once : Decoding::later;
  slots[TEXTURE_SLOT_NORMAL] = use(MtlMap::normal, MtlMapUse::normal, decoding);
  if (slots[TEXTURE_SLOT_NORMAL].texture < 0) slots[TEXTURE_SLOT_NORMAL] = use(MtlMap::bump, MtlMapUse::height);
}

std::string folder_of(const std::string& path) {
  return path.substr(0, path.find_last_of('/') + 1);
}

/// A library's name as a path: without quotes, with slashes alone.
std::string plain_name(std::string name) {
  std::ranges::replace(name, '\\', '/');
  if (name.size() > 2 && name.starts_with('"') && name.ends_with('"')) name = name.substr(1, name.size() - 2);
  return name;
}

/// The file that the library `name` is in: where it says, or beside the model. Empty: there is none.
std::string find_library(const std::string& name, const std::string& obj_folder) {
  const std::string named = name.starts_with('/') ? name : obj_folder + name;
  const std::string beside = obj_folder + name.substr(name.find_last_of('/') + 1);
  for (const bool any_case : {false, true}) {
    for (const std::string& place : {named, beside}) {
      if (const std::string path = find_file(place, any_case); !path.empty()) return path;
    }
  }
  return {};
}

/// Of a library that cannot be read nothing but a warning, as of one that is not there.
MtlLibrary read_library(Scene& scene, const std::string& path, const LoadOptions& options) {
  MtlLibrary library;
  try {
    library = parse_mtl(read_text(path));
  } catch (const MemoryError&) {
    throw;
  } catch (const Error& error) {
    warn_unsupported(scene, options, std::string(error.what()) + "; its materials are grey");
    return library;
  }
  note_file(scene.files, path);
  for (const std::string& line : library.unsupported) warn_unsupported(scene, options, path + ": " + line);
  for (const std::string& line : library.faults) scene.warnings.push_back(path + ": " + line);
  return library;
}

}  // namespace

std::map<std::string, std::uint32_t> load_obj_materials(LoadingScene& loading, const std::string& obj_path,
                                                        const std::vector<std::string>& libraries,
                                                        const LoadOptions& options) {
  std::map<std::string, std::uint32_t> index_by_name;
  Scene& scene = loading.scene;
  std::set<std::filesystem::path> read;
  ObjTextures textures{loading.images, folder_of(obj_path), options.strict};
  for (const std::string& written : libraries) {
    const std::string name = plain_name(written);
    const std::string path = find_library(name, textures.obj_folder);
    if (path.empty()) {
      warn_unsupported(scene, options,
                       obj_path + ": material library " + printable(name) + " is not there; its materials are grey");
      continue;
    }
    std::error_code failure;
    if (!read.insert(std::filesystem::weakly_canonical(path, failure)).second) continue;
    const MtlLibrary library = read_library(scene, path, options);
    const std::set<std::string> at_once = normals_with_heights(library);
    for (const MtlMaterial& source : library.materials) {
      if (!index_by_name.try_emplace(source.name, static_cast<std::uint32_t>(scene.materials.size())).second) {
        scene.warnings.push_back(path + ": material " + printable(source.name) + " was there before; the first counts");
        continue;
      }
      scene.materials.push_back(blinn_material(source, path + ": material " + printable(source.name), scene.warnings));
      add_textures(scene, textures, scene.materials.back(), source, folder_of(path), at_once);
    }
  }
  return index_by_name;
}

}  // namespace vernier
