#pragma once

#include "scene/fault_list.h"
#include "scene/scene.h"

namespace vernier {

/// Throws Error(refused) where an index of an instance, material, texture or UV set is out of range, a vertex array has
/// another size than the positions, or texels do not fit their size.
void check_references(const Scene& scene);

/// Removes instances with a non-affine, non-finite or singular transform, or one that takes a vertex beyond 2^126
/// metres.
void drop_instances(Scene& scene, FaultList& faults);

/// Removes lights with non-finite values or without a direction where they need one; negative or NaN ranges and
/// cones are repaired: range infinite, cones in order within [0, pi / 2].
void drop_lights(Scene& scene, FaultList& faults);

/// Removes cameras with a non-finite transform, a field of view outside (0, pi) or a height not above 0.
void drop_cameras(Scene& scene, FaultList& faults);

/// Non-finite values of materials and of the environment become those of a new Material or Environment.
void repair_materials(Scene& scene, FaultList& faults);

/// Whether any instance has a triangle that was not dropped.
bool has_triangles(const Scene& scene);

}  // namespace vernier
