#pragma once

#include <glm/glm.hpp>
#include <span>

#include "bvh/bvh.h"
#include "render/traced_space.h"
#include "shared/instance_layout.h"

namespace vernier {

/// The instance INSTANCE_WORLD: maps that change nothing.
DeviceInstance world_instance();

/// Where a mesh lies that is traced in its own space `object`, placed by `world_from_mesh` in a scene that is traced in
/// `space`: worked out in double. object_from_traced is rounded and then the truth; traced_from_object is its inverse,
/// rounded. plan_instances has found it fit for that.
DeviceInstance device_instance(const glm::dmat4& world_from_mesh, const TracedSpace& object, const TracedSpace& space,
                               std::uint32_t first_triangle);

/// The box in the traced space around all places at which rays may meet what lies in `boxes`, of the object's space:
/// the exact image under the inverse of object_from_traced, moved outwards by what rounding moves rays that begin in
/// the traced space. `boxes` is not empty.
Box instance_box(const DeviceInstance& instance, std::span<const Box> boxes);

}  // namespace vernier
