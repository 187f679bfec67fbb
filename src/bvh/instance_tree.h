#pragma once

#include <functional>
#include <span>
#include <vector>

#include "bvh/build_bvh.h"

namespace vernier {

/// A tree that stands in another once or more often, in a space of its own.
struct ObjectTree {
  Bvh bvh;                        ///< ids of its triangles count from 0
  std::uint32_t first_place = 0;  ///< place of its first triangle in the scene's list
};

/// An object tree among the triangles of the scene.
struct TreeInstance {
  Box box;               ///< around all that rays may meet of it; it has extent along every axis
  std::uint32_t object;  ///< which tree
  std::uint32_t number;  ///< by which shaders know it, below 2^24
};

/// Builds one tree over `triangles` and `instances` as build_bvh does and puts `objects` behind it: an instance becomes
/// a node with one child, the root of its object (shared/bvh_record.h). Triangle records get their place in the scene's
/// list as word 7: their id in `triangles`, counted on from first_place in an object; word 11 is numbers[id] and, in an
/// object, the id. Objects that no instance names are left out, as are instances of empty trees. `depth` is
/// that of the deepest way through both trees; counts are those of the records, the cost is that of a ray through the
/// whole. The objects are used up. Throws Error(refused) beyond BVH_MAX_RECORDS records.
Bvh build_instance_tree(std::vector<BvhTriangle> triangles, std::span<const std::uint32_t> numbers,
                        std::span<const TreeInstance> instances, std::vector<ObjectTree>& objects,
                        const std::function<bool(std::uint32_t)>& not_opaque, unsigned thread_count,
                        BuildMethod method = BuildMethod::standard,
                        const std::function<void(double share)>& progress = {});

/// Boxes that hold all triangles of `bvh` between them: those of the nodes two levels below the root, or higher up
/// where there are none; empty for an empty tree.
std::vector<Box> upper_boxes(const Bvh& bvh);

}  // namespace vernier
