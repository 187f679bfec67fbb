#include "effects/seen_materials.h"

#include "effects/effective_material.h"

namespace vernier {
namespace {

std::vector<bool> used_textures(const Scene& scene, const std::vector<MaterialUsage>& usage) {
  std::vector<bool> used(scene.textures.size());
  for (std::size_t index = 0; index < usage.size(); ++index) {
    for (const TextureUse& use : scene.materials[index].textures) {
      if (usage[index].used && use.texture >= 0) used[static_cast<std::size_t>(use.texture)] = true;
    }
  }
  return used;
}

}  // namespace

SceneFacts scene_facts(const Scene& scene) {
  SceneFacts facts;
  facts.usage = used_materials(scene);
  facts.values = texture_values(scene, used_textures(scene, facts.usage));
  facts.box = world_box(scene);
  return facts;
}

std::string label_of(const char* what, std::size_t index, const std::string& name) {
  const std::string number = std::string(what) + " " + std::to_string(index);
  return name.empty() ? number : number + " (" + name + ")";
}

std::vector<SeenMaterial> seen_materials(const Scene& scene, const SceneFacts& facts, const Supposition& supposed) {
  std::vector<SeenMaterial> seen;
  for (std::size_t index = 0; index < scene.materials.size(); ++index) {
    const MaterialUsage& usage = facts.usage[index];
    if (!usage.used && !supposed.every_material_used) continue;
    const Material& written = scene.materials[index];
    const Material material =
        supposed.texels_vary ? written : effective_material(written, facts.values, usage.vertex_colors);
    const MaterialTerms terms = material_terms(material, usage);
    seen.push_back(
        {material, usage, terms, counted_texture_slots(material, terms), label_of("material", index, material.name)});
  }
  return seen;
}

}  // namespace vernier
