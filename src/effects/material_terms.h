#pragma once

#include "effects/used_materials.h"
#include "scene/material.h"

namespace vernier {

/// Which terms of shaders/README.md, section 4, can be other than zero for some hit on a material.
struct MaterialTerms {
  bool base = false;          ///< base_color.rgb
  bool diffuse = false;       ///< kd
  bool specular = false;      ///< ks
  bool ambient = false;       ///< ka
  bool mirror = false;        ///< r0 or r90, or the Fresnel reflection of what is transmissive
  bool transmission = false;  ///< kt
  bool absorption = false;    ///< kt of a volume that absorbs
  bool emission = false;      ///< ke
  bool cut_out = false;       ///< mode mask, and alpha can lie below the cutoff
  bool see_through = false;   ///< mode blend, and alpha can lie below 1
};

/// The terms of `material` on triangles with or without vertex colours. Never too few: a texture or vertex colour may
/// hold any finite value, NaN factors count as not zero. Unlit materials have base and alpha, and the transmission that
/// their shadows may show.
MaterialTerms material_terms(const Material& material, const MaterialUsage& usage);

/// Texture slots (bit 1 << TEXTURE_SLOT_*) whose texels can change a pixel or an AOV of `material`: there is a
/// texture and what it is multiplied with is not zero.
unsigned counted_texture_slots(const Material& material, const MaterialTerms& terms);

}  // namespace vernier
