#pragma once

#include <string>
#include <vector>

#include "effects/light_reach.h"
#include "effects/material_terms.h"
#include "effects/texture_values.h"
#include "effects/used_materials.h"

namespace vernier {

/// What takes time to find out about a scene, found out once.
struct SceneFacts {
  std::vector<MaterialUsage> usage;   ///< by material
  std::vector<TextureValues> values;  ///< by texture, of those that used materials have
  WorldBox box;
};

/// O(triangles + vertices + texels of textures that are the same all over).
SceneFacts scene_facts(const Scene& scene);

/// What detection takes for granted beside the facts; the defaults are how things are. The others tell why an effect is
/// off: it would be on if ...
struct Supposition {
  int max_bounces = 0;
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
  std::string label;
};

/// `material 3 (glass)`.
std::string label_of(const char* what, std::size_t index, const std::string& name);

/// The materials of `scene` that count.
std::vector<SeenMaterial> seen_materials(const Scene& scene, const SceneFacts& facts, const Supposition& supposed);

}  // namespace vernier
