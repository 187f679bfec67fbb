#pragma once

#include <cstdint>

#include "bvh/large_array.h"
#include "render/bake_instances.h"
#include "render/build_trees.h"

namespace vernier {

/// Puts the vertices of `baked` into the order in which the triangle records of `trees` use them:
/// [vertex][layout.texels][4] float bits, a vertex's material as the fourth word. Writes into each of these records
/// where its vertices lie, or its material where vertices have no texels (shared/bvh_record.h); until now they name
/// their place in baked.triangles. What lies close to each other in the tree so lies close to each other here too,
/// which is what lets a record do with offsets of 16 bits: records are taken by some thousands, and a vertex is there
/// once for all of these that use it with one material. Vertices that no traced triangle uses are left out. The result
/// is the same for every `thread_count` (0: all cores).
LargeArray<std::uint32_t> lay_out_vertices(BakedScene baked, SceneTrees& trees, unsigned thread_count);

}  // namespace vernier
