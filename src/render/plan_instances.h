#pragma once

#include <cstdint>
#include <vector>

#include "render/render_settings.h"
#include "render/traced_space.h"
#include "scene/scene.h"

namespace vernier {

/// Which meshes are traced in a space of their own, once for all instances.
struct InstancePlan {
  std::vector<std::uint32_t> meshes;   ///< that are shared, rising
  std::vector<TracedSpace> spaces;     ///< [shared mesh]: its own; position = object x metres_per_unit + center
  std::vector<std::uint32_t> place;    ///< [instance]: index in `meshes`, or NONE: it is copied
  std::uint64_t triangles = 0;         ///< of all instances
  std::uint64_t stored_triangles = 0;  ///< those of a shared mesh once
  std::uint64_t stored_vertices = 0;   ///< likewise
  std::uint64_t shared_instances = 0;
};

/// The plan for `scene`, which has passed validate_scene. `automatic` shares the meshes whose copies take most memory
/// until the copies left have at most 2^20 triangles; a scene with fewer is copied as a whole. Copied is also what
/// roundings of the transform would move too far: where the row sums of |M| |M^-1| pass 32 (a rotation has 3 at most,
/// whatever it is scaled by along the mesh's axes), or where the instance is below 2^-40 of the scene. O(triangles
/// of the meshes + instances).
InstancePlan plan_instances(const Scene& scene, Sharing sharing = Sharing::automatic);

/// Largest row sum of |m| |m^-1|: how much larger roundings of either may become by the other.
double rounding_spread(const glm::dmat3& m);

}  // namespace vernier
