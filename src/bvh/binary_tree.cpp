#include "bvh/binary_tree.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "bvh/area_tree.h"
#include "bvh/box.h"
#include "bvh/coarse.h"
#include "bvh/morton_tree.h"
#include "bvh/reinsertion.h"

namespace vernier {
namespace {

// Nodes per piece of a sum: fixed, so that it does not depend on the number of threads.
constexpr std::size_t kPiece = 8192;

double half_area_sum(std::span<const BinaryNode> nodes, ThreadTeam& team) {
  std::vector<double> sums((nodes.size() + kPiece - 1) / kPiece, 0.0);
  team.run(sums.size(), [&](std::size_t piece) {
    const std::size_t first = piece * kPiece;
    for (const BinaryNode& node : nodes.subspan(first, std::min(kPiece, nodes.size() - first))) {
      sums[piece] += half_area(node.box);
    }
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

// Each inner node counts 1 and each leaf 1 + 1, weighed by area.
double sah_cost(const BinaryTree& tree, double leaf_half_area_sum, ThreadTeam& team) {
  return (2.0 * leaf_half_area_sum + half_area_sum(tree.nodes, team)) / half_area(tree.bounds);
}

void fill_nodes(const TriangleReferences& references, BuildMethod method, BinaryNode* nodes, ThreadTeam& team,
                Workspace& workspace, const CountDone& done) {
  switch (method) {
    case BuildMethod::fast:
      return fill_nodes_by_code(references, nodes, team, workspace, done);
    case BuildMethod::standard:
    case BuildMethod::quality:
      return fill_nodes_by_area(references, nodes, team, done);
  }
}

}  // namespace

BinaryTree build_binary_tree(std::span<const BvhTriangle> triangles, BuildMethod method, ThreadTeam& team,
                             Workspace workspace, const CountDone& done) {
  const TriangleReferences references = make_references(triangles, team, workspace);
  BinaryTree tree;
  tree.leaf_count = static_cast<std::uint32_t>(references.all.size());
  if (references.all.size() == 0) {
    return tree;
  }
  tree.bounds = box_from(references.bounds.box);
  tree.coarse = is_coarse(tree.bounds, references.fine_count, references.all.size());
  if (references.all.size() == 1) {
    tree.root = kLeafBit | triangle_index(references.all[0]);
  } else {
    tree.nodes.resize(references.all.size() - 1);
    fill_nodes(references, method, tree.nodes.data(), team, workspace, done);
    if (method == BuildMethod::quality) reinsert_subtrees(tree, triangles, team);
  }
  tree.sah_cost = sah_cost(tree, references.half_area_sum, team);
  return tree;
}

}  // namespace vernier
