#pragma once

#include <string>
#include <vector>

#include "effects/light_reach.h"
#include "effects/material_terms.h"
#include "effects/normal_map_bend.h"
#include "effects/texture_values.h"
#include "effects/used_materials.h"

namespace vernier {

/// What takes time to find out about a scene, found out once.
struct SceneFacts {
  std::vector<MaterialUsage> usage;   ///< by material
  std::vector<TextureValues> values;  ///< by texture, of those that used materials have
  std::vector<NormalMapBend> bends;   ///< by material; varies where it has no normal texture or no triangle uses it
  WorldBounds box;
};

/// O(triangles + vertices + texels of textures that are the same all over).
SceneFacts scene_facts(const Scene& scene);

/// What detection takes for granted beside the facts; the defaults are how things are. The others tell why an effect is
/// off: it would be on if ...
struct Supposition {
  int max_bounces = 0;
  double cutoff = 0.0;               ///< rays of a weight below are not traced
  bool ior_differs = false;          ///< ... glass had another index of refraction than what is around it
  bool texels_vary = false;          ///< ... the texels of a texture were not all 0 or all 1
  bool every_material_used = false;  ///< ... a triangle used the material
  bool every_light_shines = false;   ///< ... the light were not black and in range
};

/// A material that counts, as its textures leave it, with its terms and its name for a reason.
struct SeenMaterial {
  Material material;
  MaterialUsage usage;
  MaterialTerms terms;
  unsigned texture_slots = 0;
  double mirror_weight = 0.0;  ///< of a reflected ray, at most
  NormalMapBend bend = NormalMapBend::varies;
  std::string label;
};

/// `material 3 (glass)`.
std::string label_of(const char* what, std::size_t index, const std::string& name);

/// The materials of `scene` that count.
std::vector<SeenMaterial> seen_materials(const Scene& scene, const SceneFacts& facts, const Supposition& supposed);

}  // namespace vernier
