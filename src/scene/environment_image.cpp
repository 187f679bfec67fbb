#include "scene/environment_image.h"

#include <bit>
#include <utility>

#include "scene/texel_color.h"
#include "scene/texel_memory.h"
#include "scene/texture_from_image.h"

namespace vernier {
namespace {

std::shared_ptr<const Texels> decode_as_float(const std::string& path) {
  const std::shared_ptr<const Texels> texels = decode_texels_from_file(path, TexelEncoding::radiance);
  if (texels->format == TEXTURE_FORMAT_FLOAT) return texels;
  Texels result{TEXTURE_FORMAT_FLOAT, texels->width, texels->height, {}};
  const std::size_t count = std::size_t{texels->width} * texels->height;
  MemoryClaim claim;
  claim_texel_memory(claim, path, count * sizeof(glm::vec4));
  result.words.reserve(4 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec4 color = texel_color(*texels, i);
    for (int c = 0; c < 4; ++c) result.words.push_back(std::bit_cast<std::uint32_t>(color[c]));
  }
  return std::make_shared<const Texels>(std::move(result));
}

}  // namespace

int add_environment_image(Scene& scene, PendingImages& images, const std::string& path) {
  check_image_file(path);
  ImageJob job;
  job.decode = [path] { return decode_as_float(path); };
  job.file = path;
  job.needed = true;
  const Sampler sampler{TEXTURE_WRAP_REPEAT, TEXTURE_WRAP_CLAMP, TEXTURE_FILTER_LINEAR};
  scene.textures.push_back({path, sampler, images.add(std::move(job))});
  scene.environment.texture = static_cast<int>(scene.textures.size()) - 1;
  return scene.environment.texture;
}

}  // namespace vernier
