#pragma once

#include <functional>
#include <span>

#include "bvh/build_bvh.h"
#include "shader/memory.h"

namespace vernier::shader {

/// Memory with the BVH of `triangles` alone; `not_opaque` as build_bvh takes it.
inline Memory bvh_memory(std::span<const BvhTriangle> triangles,
                         const std::function<bool(std::uint32_t)>& not_opaque = {}) {
  const Bvh bvh = build_bvh(triangles, not_opaque, 1);
  Memory scene;
  scene.records = record_texels(bvh);
  scene.dispatch.steering.triangle_count = bvh.triangle_count;
  scene.dispatch.steering.one = 1;
  return scene;
}

}  // namespace vernier::shader
