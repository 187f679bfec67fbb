#pragma once

#include <cstddef>

#include "scene/fault_list.h"
#include "scene/scene.h"

namespace vernier {

/// Whether a ray can hit `triangle` of `mesh`, whose positions are finite: its corners lie in no line.
bool has_area(const Mesh& mesh, const glm::uvec3& triangle);

/// Drops the triangles of `mesh` that have a non-finite corner or an index out of range (all three indices become 0),
/// replaces non-finite vertex values by "none" (normals and tangents 0, uvs 0, colours 1) and -0 positions by +0.
/// Texture coordinates beyond 65536 are told of and kept. Positions that stay non-finite, because no triangle uses them
/// any more, become 0. A mesh without vertices gets one for the dropped triangles. `mesh_index` names the mesh in
/// `faults`. The arrays have the sizes that Mesh asks for.
void repair_mesh(Mesh& mesh, std::size_t mesh_index, FaultList& faults);

}  // namespace vernier
