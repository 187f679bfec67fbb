#include <algorithm>

#include "error.h"
#include "scene/scene_faults.h"

namespace vernier {
namespace {

class ReferenceCheck {
 public:
  explicit ReferenceCheck(const Scene& scene) : scene_(scene) {}

  void run() const {
    for (std::size_t i = 0; i < scene_.textures.size(); ++i) check_texture(i);
    for (std::size_t i = 0; i < scene_.materials.size(); ++i) check_material(i);
    for (std::size_t i = 0; i < scene_.meshes.size(); ++i) check_mesh(i);
    for (std::size_t i = 0; i < scene_.instances.size(); ++i) {
      check_index("instance " + std::to_string(i) + ": mesh", scene_.instances[i].mesh, scene_.meshes.size());
    }
    check_texture_index("environment", scene_.environment.texture);
  }

 private:
  [[noreturn]] void refuse(const std::string& line) const {
    throw Error(ErrorKind::refused, scene_.source + ": " + line);
  }

  void check_index(const std::string& what, std::size_t index, std::size_t count) const {
    if (index >= count)
      refuse(what + " " + std::to_string(index) + " is beyond the " + std::to_string(count) + " of the scene");
  }

  void check_texture_index(const std::string& place, int texture) const {
    if (texture < -1 || texture >= static_cast<std::int64_t>(scene_.textures.size())) {
      refuse(place + ": texture " + std::to_string(texture) + " is beyond the " +
             std::to_string(scene_.textures.size()) + " of the scene");
    }
  }

  void check_texture(std::size_t index) const {
    const Texels* texels = scene_.textures[index].texels.get();
    const std::size_t words_per_texel = texels != nullptr && texels->format == TEXTURE_FORMAT_FLOAT ? 4 : 1;
    const bool fits = texels != nullptr && texels->width > 0 && texels->height > 0 &&
                      texels->format <= TEXTURE_FORMAT_FLOAT &&
                      texels->words.size() == words_per_texel * texels->width * texels->height;
    if (!fits) refuse("texture " + std::to_string(index) + ": the texels do not fit width, height and format");
  }

  void check_material(std::size_t index) const {
    const std::string place = "material " + std::to_string(index);
    for (const TextureUse& use : scene_.materials[index].textures) {
      check_texture_index(place, use.texture);
      if (use.texture >= 0) check_index(place + ": UV set", use.uv_set, kUvSetCount);
    }
  }

  void check_size(const std::string& place, const char* name, std::size_t size, std::size_t expected) const {
    if (size != expected) {
      refuse(place + ": " + std::to_string(size) + " " + name + " do not fit " + std::to_string(expected));
    }
  }

  void check_mesh(std::size_t index) const {
    const Mesh& mesh = scene_.meshes[index];
    const std::string place = "mesh " + std::to_string(index);
    const std::size_t count = mesh.positions.size();
    if (!mesh.normals.empty()) check_size(place, "normals", mesh.normals.size(), count);
    if (!mesh.tangents.empty()) check_size(place, "tangents", mesh.tangents.size(), count);
    if (!mesh.colors.empty()) check_size(place, "colours", mesh.colors.size(), count);
    for (const auto& uvs : mesh.uvs) {
      if (!uvs.empty()) check_size(place, "texture coordinates", uvs.size(), count);
    }
    check_size(place, "materials of triangles", mesh.triangle_materials.size(), mesh.triangles.size());
    const auto largest = std::ranges::max_element(mesh.triangle_materials);
    if (largest != mesh.triangle_materials.end()) check_index(place + ": material", *largest, scene_.materials.size());
  }

  const Scene& scene_;
};

}  // namespace

void check_references(const Scene& scene) {
  ReferenceCheck(scene).run();
}

}  // namespace vernier
