#pragma once

#include "scene/scene.h"

namespace vernier {

/// Finds every fault of `scene` and repairs what can be: drops triangles with a non-finite corner or an index out of
/// range, and instances with a singular or non-finite transform, each kind as one warning with its count and first place;
/// makes -0 positions +0; replaces non-finite normals, tangents, uvs and colours by "none". Triangle numbering stays:
/// a dropped triangle gets all three indices 0 (zero area: it is never hit and never built into the BVH).
/// Throws Error(refused) where nothing is left to render or an index of an instance, material or texture is wrong.
void validate_scene(Scene& scene);

}  // namespace vernier
