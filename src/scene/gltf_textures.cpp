#include "scene/gltf_textures.h"

#include "error.h"
#include "math/parallel_for.h"
#include "scene/gltf_references.h"
#include "scene/gltf_uri.h"
#include "scene/gltf_values.h"

namespace vernier {
namespace {

constexpr int kNearest = 9728;
constexpr int kClampToEdge = 33071;
constexpr int kMirroredRepeat = 33648;

std::uint32_t wrap_of(int mode) {
  if (mode == kClampToEdge) return TEXTURE_WRAP_CLAMP;
  return mode == kMirroredRepeat ? TEXTURE_WRAP_MIRROR : TEXTURE_WRAP_REPEAT;
}

Sampler sampler_of(const GltfDocument& document, const tinygltf::Texture& texture) {
  if (texture.sampler < 0) return {};
  const tinygltf::Sampler& source = document.model.samplers[static_cast<std::size_t>(texture.sampler)];
  return {wrap_of(source.wrapS), wrap_of(source.wrapT),
          source.magFilter == kNearest ? TEXTURE_FILTER_NEAREST : TEXTURE_FILTER_LINEAR};
}

/// The image to read, -1 where there is none that can be.
int image_of(GltfDocument& document, int index) {
  const tinygltf::Texture& texture = document.model.textures[static_cast<std::size_t>(index)];
  const std::string place = "texture " + std::to_string(index);
  if (const auto* webp = find_gltf_extension(texture.extensions, "EXT_texture_webp")) {
    const int source = gltf_index(*webp, "source", -1);
    check_gltf_index(document, place, "image", source, document.images.size());
    return source;
  }
  const bool is_basis = texture.extensions.contains("KHR_texture_basisu");
  if (is_basis) {
    unsupported_gltf(document, place,
                     texture.source >= 0 ? "KHR_texture_basisu is not supported, its fallback image is used"
                                         : "KHR_texture_basisu is not supported and no fallback image is there: white");
  } else if (texture.source < 0) {
    unsupported_gltf(document, place, "it has no image that can be read: white");
  }
  return texture.source;
}

std::shared_ptr<const Texels> read_image(const GltfDocument& document, const GltfImageUse& use, std::string& path) {
  const auto [index, encoding] = use;
  const GltfImage& image = document.images[static_cast<std::size_t>(index)];
  const std::string place = "image " + std::to_string(index);
  if (image.uri.empty()) {
    if (image.buffer_view < 0) throw Error(ErrorKind::refused, place + ": it has neither uri nor bufferView");
    return decode_texels(gltf_view_bytes(document, image.buffer_view, place), place, encoding);
  }
  if (is_data_uri(image.uri)) return decode_texels(decode_data_uri(image.uri, place), place, encoding);
  path = path_from_uri(image.uri, document.directory);
  return decode_texels_from_file(path, encoding);
}

DecodedImage decode_image(const GltfDocument& document, const GltfImageUse& use) {
  DecodedImage decoded;
  try {
    decoded.texels = read_image(document, use, decoded.path);
  } catch (const MemoryError&) {
    throw;
  } catch (const Error& failure) {
    if (failure.kind() != ErrorKind::refused) throw;  // not the image's fault
    decoded.fault = failure.what();
  }
  return decoded;
}

std::shared_ptr<const Texels> white_texel() {
  return std::make_shared<const Texels>(Texels{TEXTURE_FORMAT_LINEAR8, 1, 1, {0xffffffffu}});
}

std::shared_ptr<const Texels> texels_of(GltfDocument& document, const GltfImageUse& use, const std::string& place,
                                        GltfTextures& textures) {
  const auto [entry, is_new] = textures.texels.try_emplace(use, nullptr);
  if (!is_new) return entry->second;
  if (textures.wanted != nullptr) {
    textures.wanted->push_back(use);
    return entry->second = white_texel();
  }
  const auto known = textures.decoded.find(use);
  const DecodedImage decoded = known != textures.decoded.end() ? known->second : decode_image(document, use);
  if (decoded.texels == nullptr) {
    const GltfImage& source = document.images[static_cast<std::size_t>(use.first)];
    const std::string name = source.uri.empty() || is_data_uri(source.uri) ? "" : " (" + source.uri + ")";
    unsupported_gltf(document, place + ", image " + std::to_string(use.first) + name,
                     "white is used instead: " + decoded.fault);
  } else if (!decoded.path.empty()) {
    note_file(document.files, decoded.path);
  }
  return entry->second = decoded.texels;
}

}  // namespace

std::map<GltfImageUse, DecodedImage> decode_gltf_images(const GltfDocument& document,
                                                        const std::vector<GltfImageUse>& uses) {
  std::vector<DecodedImage> images(uses.size());
  parallel_for(resolve_thread_count(0), uses.size(),
               [&](std::size_t i) { images[i] = decode_image(document, uses[i]); });
  std::map<GltfImageUse, DecodedImage> decoded;
  for (std::size_t i = 0; i < uses.size(); ++i) decoded.emplace(uses[i], std::move(images[i]));
  return decoded;
}

int gltf_scene_texture(GltfDocument& document, int index, TexelEncoding encoding, const std::string& place,
                       GltfTextures& textures, Scene& scene) {
  check_gltf_index(document, place, "texture", index, document.model.textures.size());
  const auto [entry, is_new] = textures.numbers.try_emplace({index, encoding}, -1);
  if (!is_new) return entry->second;
  int image = image_of(document, index);
  if (image < 0) return -1;
  const std::string& uri = document.images[static_cast<std::size_t>(image)].uri;
  if (!uri.empty() && !is_data_uri(uri)) image = textures.image_of_file.try_emplace(uri, image).first->second;
  const auto texels = texels_of(document, {image, encoding}, "texture " + std::to_string(index), textures);
  if (texels == nullptr) return -1;
  const tinygltf::Texture& source = document.model.textures[static_cast<std::size_t>(index)];
  const GltfImage& file = document.images[static_cast<std::size_t>(image)];
  Texture texture{source.name, sampler_of(document, source), texels};
  if (texture.name.empty()) texture.name = file.name;
  if (texture.name.empty() && !is_data_uri(file.uri)) texture.name = file.uri;
  entry->second = static_cast<int>(scene.textures.size());
  scene.textures.push_back(std::move(texture));
  return entry->second;
}

}  // namespace vernier
