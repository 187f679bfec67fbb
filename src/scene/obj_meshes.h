#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/parse_obj.h"
#include "scene/scene.h"

namespace vernier {

/// The origin that all meshes of the file are moved to, so that float positions stay fine in survey coordinates: on
/// each axis a multiple of a power of two near the middle of the faces' vertices where that is further than 8 extents
/// away, else 0. One for the whole file, because vertices that meshes share must stay equal after rounding. Non-finite
/// positions count for nothing.
glm::dvec3 object_origin(const ObjGeometry& geometry);

/// Adds a mesh and an instance of its name for each shape. Positions are those of the file less object_origin, rounded
/// once; v is turned downwards; vertex colours are taken as sRGB, as exporters write them. Corners without a
/// normal: smoothed within their smoothing group over the whole file (weighed by angle), flat without a group. Corners
/// without uv: (0, 0). `material_of_name` maps indices of ObjGeometry::material_names to Scene::materials,
/// `no_material` is for faces without.
void add_obj_meshes(Scene& scene, const ObjGeometry& geometry, const std::vector<std::uint32_t>& material_of_name,
                    std::uint32_t no_material);

}  // namespace vernier
