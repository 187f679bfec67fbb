#include "effects/seen_materials.h"

#include "effects/effective_material.h"
#include "effects/mirror_weight.h"

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

std::vector<NormalMapBend> normal_map_bends(const Scene& scene, const std::vector<MaterialUsage>& usage) {
  std::vector<NormalMapBend> bends(usage.size(), NormalMapBend::varies);
  for (std::size_t index = 0; index < usage.size(); ++index) {
    const Material& material = scene.materials[index];
    const int texture = material.textures[TEXTURE_SLOT_NORMAL].texture;
    if (!usage[index].used || texture < 0) continue;
    const Texels* texels = scene.textures[static_cast<std::size_t>(texture)].texels.get();
    if (texels != nullptr) bends[index] = normal_map_bend(*texels, material.normal_scale);
  }
  return bends;
}

Material as_supposed(const Scene& scene, const SceneFacts& facts, const Supposition& supposed, std::size_t index) {
  Material material = scene.materials[index];
  if (!supposed.texels_vary) {
    material = effective_material(material, facts.values, facts.usage[index].vertex_colors);
    if (facts.bends[index] == NormalMapBend::none) material.textures[TEXTURE_SLOT_NORMAL].texture = -1;
  }
  if (supposed.ior_differs && material.ior == 1.0f) material.ior = Material{}.ior;
  return material;
}

}  // namespace

SceneFacts scene_facts(const Scene& scene) {
  SceneFacts facts;
  facts.usage = used_materials(scene);
  facts.values = texture_values(scene, used_textures(scene, facts.usage));
  facts.bends = normal_map_bends(scene, facts.usage);
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
    if (!facts.usage[index].used && !supposed.every_material_used) continue;
    SeenMaterial one;
    one.material = as_supposed(scene, facts, supposed, index);
    one.usage = facts.usage[index];
    one.terms = material_terms(one.material, one.usage);
    one.texture_slots = counted_texture_slots(one.material, one.terms);
    one.mirror_weight = largest_mirror_weight(scene, one.material, one.terms, one.usage);
    one.bend = facts.bends[index];
    one.label = label_of("material", index, one.material.name);
    seen.push_back(std::move(one));
  }
  return seen;
}

}  // namespace vernier
