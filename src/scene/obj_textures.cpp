#include "scene/obj_textures.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "error.h"
#include "scene/find_file.h"
#include "scene/height_map.h"
#include "scene/texel_memory.h"
#include "scene/text_words.h"
#include "scene/texture_from_image.h"

namespace vernier {
namespace {

/// Places where the image `name` may lie, likeliest first.
std::vector<std::string> places_of(const std::string& name, const ObjTextures& textures,
                                   const std::string& mtl_folder) {
  const bool absolute = name.starts_with('/') || name.find(":/") != std::string::npos;
  std::vector<std::string> places;
  if (absolute) places.push_back(name);
  // The path, then what is left of it without its first folders: those of another machine are not here.
  constexpr std::size_t kMostTails = 16;  // bounds the looks for a name made of slashes
  std::vector<std::string> tails{name};
  while (tails.back().find('/') != std::string::npos) {
    const std::string& last = tails.back();
    tails.push_back(last.substr((tails.size() < kMostTails ? last.find('/') : last.find_last_of('/')) + 1));
  }
  for (const std::string& tail : tails) {
    places.push_back(mtl_folder + tail);
    places.push_back(textures.obj_folder + tail);
  }
  return places;
}

std::string image_path(const ObjTextures& textures, const MtlTexture& map, const std::string& mtl_folder) {
  std::string name = map.file;
  std::ranges::replace(name, '\\', '/');
  std::vector<std::string> places = places_of(name, textures, mtl_folder);
  const std::string_view shorter = without_comment(name);
  const bool quoted = shorter.size() > 2 && shorter.front() == '"' && shorter.back() == '"';
  const std::string plain(quoted ? shorter.substr(1, shorter.size() - 2) : shorter);
  if (plain != name) std::ranges::copy(places_of(plain, textures, mtl_folder), std::back_inserter(places));
  for (const bool any_case : {false, true}) {
    for (const std::string& place : places) {
      const std::string found = find_file(place, any_case);
      if (!found.empty()) return found;
    }
  }
  return mtl_folder + name;
}

std::shared_ptr<const Texels> load_texels(const std::string& path, const MtlTexture& map, MtlMapUse use,
                                          std::uint32_t wrap) {
  const auto encoding = use == MtlMapUse::color ? TexelEncoding::srgb : TexelEncoding::linear;
  const std::shared_ptr<const Texels> texels = decode_texels_from_file(path, encoding);
  if (use == MtlMapUse::color || use == MtlMapUse::normal) return texels;
  const std::uint64_t normal_bytes = std::uint64_t{texels->width} * texels->height * sizeof(glm::vec4);
  MemoryClaim claim;
  claim_texel_memory(claim, path, 4 * texels->words.size() + (use == MtlMapUse::height ? normal_bytes : 0));
  if (use == MtlMapUse::scalar) return std::make_shared<const Texels>(scalar_map(*texels, map.channel));
  const Texels heights = scalar_map(*texels, map.channel == '\0' ? 'l' : map.channel);
  return std::make_shared<const Texels>(normals_from_heights(heights, map.bump_multiplier, wrap));
}

std::string key_of(const std::string& path, const MtlTexture& map, MtlMapUse use) {
  std::string key = path + '\n' + std::to_string(static_cast<int>(use)) + (map.clamp ? 'c' : 'r');
  if (use == MtlMapUse::scalar || use == MtlMapUse::height) key += map.channel;
  if (use == MtlMapUse::height) key += std::to_string(map.bump_multiplier);
  return key;
}

int add_texture(Scene& scene, const ObjTextures& textures, const std::string& path, const MtlTexture& map,
                MtlMapUse use, Decoding decoding) {
  const std::uint32_t wrap = map.clamp ? TEXTURE_WRAP_CLAMP : TEXTURE_WRAP_REPEAT;
  ImageJob job;
  job.decode = [=] { return load_texels(path, map, use, wrap); };
  job.file = path;
  job.after_fault = textures.strict ? "" : "; the material goes without this texture";
  job.needed = textures.strict;
  std::shared_ptr<const Texels> texels;
  try {
    check_image_file(path);
    if (decoding == Decoding::at_once) texels = job.decode();
  } catch (const MemoryError&) {
    throw;
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::refused || textures.strict) throw;  // else not the image's fault
    scene.warnings.push_back(error.what() + job.after_fault);
    return -1;
  }
  if (texels != nullptr) {
    note_file(scene.files, path);
  } else {
    texels = textures.images.add(std::move(job));
  }
  scene.textures.push_back({map.file, {wrap, wrap, TEXTURE_FILTER_LINEAR}, std::move(texels)});
  return static_cast<int>(scene.textures.size()) - 1;
}

}  // namespace

TextureUse use_obj_texture(Scene& scene, ObjTextures& textures, const MtlTexture& map, MtlMapUse use,
                           const std::string& mtl_folder, Decoding decoding) {
  TextureUse result;
  if (map.file.empty()) return result;
  const std::string path = image_path(textures, map, mtl_folder);
  const auto [known, is_new] = textures.texture_by_key.try_emplace(key_of(path, map, use), -1);
  if (is_new) known->second = add_texture(scene, textures, path, map, use, decoding);
  result.texture = known->second;
  // With V = 1 - v: v' = 1 - (V scale + offset).
  result.uv_from_vertex_uv = glm::mat3x2(float(map.scale.x), 0.0f, 0.0f, float(map.scale.y), float(map.offset.x),
                                         float(1.0 - map.scale.y - map.offset.y));
  return result;
}

}  // namespace vernier
