#include "scene/gltf_textures.h"

#include <functional>
#include <span>
#include <vector>

#include "error.h"
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

/// What decodes an image once the document is gone.
std::function<std::shared_ptr<const Texels>()> decoder_of(const GltfDocument& document, const GltfImageUse& use) {
  const auto [index, encoding] = use;
  const GltfImage& image = document.images[static_cast<std::size_t>(index)];
  const std::string place = "image " + std::to_string(index);
  if (is_data_uri(image.uri)) {
    return [=, uri = image.uri] { return decode_texels(decode_data_uri(uri, place), place, encoding); };
  }
  if (!image.uri.empty()) {
    return [=, path = path_from_uri(image.uri, document.directory)] { return decode_texels_from_file(path, encoding); };
  }
  if (image.buffer_view < 0) throw Error(ErrorKind::refused, place + ": it has neither uri nor bufferView");
  const std::span<const std::byte> bytes = gltf_view_bytes(document, image.buffer_view, place);
  // Not a copy: many images may share their bytes.
  const auto view = static_cast<std::size_t>(image.buffer_view);
  const auto buffer = static_cast<std::size_t>(document.model.bufferViews[view].buffer);
  const std::shared_ptr<const std::byte> first(document.buffers[buffer], bytes.data());
  return [=, size = bytes.size()] { return decode_texels({first.get(), size}, place, encoding); };
}

ImageJob job_of(const GltfDocument& document, const GltfImageUse& use, const std::string& place) {
  const GltfImage& image = document.images[static_cast<std::size_t>(use.first)];
  const bool is_file = !image.uri.empty() && !is_data_uri(image.uri);
  ImageJob job;
  job.before_fault = (document.strict ? document.path + ": " : "") + place + ", image " + std::to_string(use.first) +
                     (is_file ? " (" + image.uri + ")" : "") + (document.strict ? ": " : ": white is used instead: ");
  job.needed = document.strict;
  try {
    job.decode = decoder_of(document, use);
    if (is_file) job.file = path_from_uri(image.uri, document.directory);
  } catch (const Error& failure) {
    job.decode = [failure]() -> std::shared_ptr<const Texels> { throw failure; };
  }
  return job;
}

std::shared_ptr<const Texels> texels_of(const GltfDocument& document, const GltfImageUse& use, const std::string& place,
                                        GltfTextures& textures) {
  const auto [entry, is_new] = textures.texels.try_emplace(use, nullptr);
  if (is_new) entry->second = textures.images.add(job_of(document, use, place));
  return entry->second;
}

/// What images with the same bytes have in common; empty where that is not known.
std::string place_of_bytes(const GltfImage& image) {
  if (!image.uri.empty()) return is_data_uri(image.uri) ? "" : image.uri;
  return image.buffer_view < 0 ? "" : "\n" + std::to_string(image.buffer_view);
}

}  // namespace

int gltf_scene_texture(GltfDocument& document, int index, TexelEncoding encoding, const std::string& place,
                       GltfTextures& textures, Scene& scene) {
  check_gltf_index(document, place, "texture", index, document.model.textures.size());
  const auto [entry, is_new] = textures.numbers.try_emplace({index, encoding}, -1);
  if (!is_new) return entry->second;
  int image = image_of(document, index);
  if (image < 0) return -1;
  const std::string source_of_image = place_of_bytes(document.images[static_cast<std::size_t>(image)]);
  if (!source_of_image.empty()) image = textures.image_of_bytes.try_emplace(source_of_image, image).first->second;
  const auto texels = texels_of(document, {image, encoding}, "texture " + std::to_string(index), textures);
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
