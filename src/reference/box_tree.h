#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "reference/baked_triangles.h"
#include "reference/camera_rays.h"

namespace vernier::reference {

/// A box of a BoxTree: `count` triangles from order[first] on, or for count = 0 two child boxes, the next node and
/// `second`.
struct BoxTreeNode {
  glm::dvec3 lo;
  glm::dvec3 hi;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  std::uint32_t second = 0;
};

/// A median-split tree of boxes that only says which triangles cannot be near a ray. Its boxes are larger than they
/// need be.
struct BoxTree {
  std::vector<BoxTreeNode> nodes;
  std::vector<std::uint32_t> order;
};

/// A crossing this far outside a triangle, as a negative barycentric coordinate, is still inside the triangle's boxes:
/// what primary_samples calls near an edge.
inline constexpr double kNearEdge = 1e-4;

/// Builds the tree over all triangles of non-zero area. Deterministic; O(n log^2 n).
BoxTree build_box_tree(const BakedTriangles& baked);

/// Where `ray` enters the box, in metres, 0 when it starts inside; infinity for a miss. Never misses a box it crosses.
double box_entry(const BoxTreeNode& box, const Ray& ray);

/// Calls `visit(triangle number)` for every triangle near `ray` whose box begins before the limit, roughly front to
/// back. `visit` returns the new limit in metres; -infinity ends the walk.
template <typename Visit>
void visit_triangles(const BoxTree& tree, const Ray& ray, double limit, Visit visit) {
  struct Entry {
    std::uint32_t node;
    double t;
  };
  // Medians halve the triangles, so 2^32 of them make at most 32 levels, each of which leaves one node open.
  std::array<Entry, 40> open;
  std::size_t open_count = 0;
  if (!tree.nodes.empty()) open[open_count++] = {0, box_entry(tree.nodes[0], ray)};
  while (open_count > 0) {
    const Entry entry = open[--open_count];
    if (!(entry.t <= limit) || entry.t == std::numeric_limits<double>::infinity()) continue;
    const BoxTreeNode& node = tree.nodes[entry.node];
    for (std::uint32_t i = 0; i < node.count; ++i) limit = std::min(limit, visit(tree.order[node.first + i]));
    if (node.count > 0) continue;
    const Entry next{entry.node + 1, box_entry(tree.nodes[entry.node + 1], ray)};
    const Entry second{node.second, box_entry(tree.nodes[node.second], ray)};
    open[open_count++] = next.t <= second.t ? second : next;
    open[open_count++] = next.t <= second.t ? next : second;
  }
}

}  // namespace vernier::reference
