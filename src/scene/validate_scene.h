#pragma once

#include "scene/scene.h"

namespace vernier {

/// Finds every fault of `scene` and repairs what can be: drops triangles with a non-finite corner or an index out of
/// range, and instances with a singular or non-finite transform, each kind as one warning with its count and first
/// place; makes -0 positions +0; replaces non-finite normals, tangents, uvs and colours by "none". Triangle numbering
/// stays: a dropped triangle gets all three indices 0 (zero area: it is never hit and never built into the BVH). Also
/// lights and cameras with values that make no sense are dropped, non-finite material values become the default. A
/// transform is singular where it is not affine, where its determinant is below 1e-20 of the cube of its longest
/// column, or where it takes a vertex beyond 2^126 metres. Throws Error(refused) where nothing is left to render or an
/// index of an instance, material or texture is wrong.
void validate_scene(Scene& scene);

}  // namespace vernier
