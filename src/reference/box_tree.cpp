#include "reference/box_tree.h"

#include <tuple>
#include <utility>

namespace vernier::reference {

namespace {

constexpr std::uint32_t kLeafTriangles = 4;

struct Box {
  glm::dvec3 lo = glm::dvec3(std::numeric_limits<double>::infinity());
  glm::dvec3 hi = -lo;
};

// kNearEdge twice over (two coordinates may be that far out) and far more than the rounding of an intersection.
Box grown_box(const Triangle& triangle, double largest_coordinate) {
  Box box;
  for (const glm::dvec3& corner : triangle.corners) {
    box.lo = glm::min(box.lo, corner);
    box.hi = glm::max(box.hi, corner);
  }
  const glm::dvec3 margin = 4.0 * kNearEdge * (box.hi - box.lo) + 0x1p-40 * largest_coordinate;
  return {box.lo - margin, box.hi + margin};
}

class Builder {
 public:
  explicit Builder(const BakedTriangles& baked) {
    for (std::uint32_t id = 0; id < baked.triangles.size(); ++id) {
      boxes_.push_back(grown_box(baked.triangles[id], baked.largest_coordinate));
      if (baked.triangles[id].normal != glm::dvec3(0.0)) tree_.order.push_back(id);
    }
  }

  BoxTree build() {
    if (!tree_.order.empty()) build_node(0, static_cast<std::uint32_t>(tree_.order.size()));
    return std::move(tree_);
  }

 private:
  glm::dvec3 centre(std::uint32_t id) const { return 0.5 * (boxes_[id].lo + boxes_[id].hi); }

  int widest_axis(std::uint32_t first, std::uint32_t last) const {
    Box centres;
    for (std::uint32_t i = first; i < last; ++i) {
      centres.lo = glm::min(centres.lo, centre(tree_.order[i]));
      centres.hi = glm::max(centres.hi, centre(tree_.order[i]));
    }
    const glm::dvec3 size = centres.hi - centres.lo;
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  }

  void build_node(std::uint32_t first, std::uint32_t last) {
    const std::size_t self = tree_.nodes.size();
    Box box;
    for (std::uint32_t i = first; i < last; ++i) {
      box.lo = glm::min(box.lo, boxes_[tree_.order[i]].lo);
      box.hi = glm::max(box.hi, boxes_[tree_.order[i]].hi);
    }
    tree_.nodes.push_back({box.lo, box.hi, first, last - first, 0});
    if (last - first <= kLeafTriangles) return;
    const int axis = widest_axis(first, last);
    const std::uint32_t middle = first + (last - first) / 2;
    std::nth_element(tree_.order.begin() + first, tree_.order.begin() + middle, tree_.order.begin() + last,
                     [&](std::uint32_t a, std::uint32_t b) {
                       return std::tuple(centre(a)[axis], a) < std::tuple(centre(b)[axis], b);
                     });
    tree_.nodes[self].count = 0;
    build_node(first, middle);
    tree_.nodes[self].second = static_cast<std::uint32_t>(tree_.nodes.size());
    build_node(middle, last);
  }

  std::vector<Box> boxes_;
  BoxTree tree_;
};

}  // namespace

BoxTree build_box_tree(const BakedTriangles& baked) {
  return Builder(baked).build();
}

double box_entry(const BoxTreeNode& box, const Ray& ray) {
  // Twice the rounding of a difference and a quotient, so that a far eye loses nothing either.
  constexpr double kSlack = 0x1p-50;
  constexpr double kMiss = std::numeric_limits<double>::infinity();
  double enter = 0.0;
  double leave = kMiss;
  for (int axis = 0; axis < 3; ++axis) {
    if (ray.direction[axis] == 0.0) {
      if (ray.origin[axis] < box.lo[axis] || ray.origin[axis] > box.hi[axis]) return kMiss;
      continue;
    }
    const double a = (box.lo[axis] - ray.origin[axis]) / ray.direction[axis];
    const double b = (box.hi[axis] - ray.origin[axis]) / ray.direction[axis];
    enter = std::max(enter, std::min(a, b) * (1.0 - kSlack));
    leave = std::min(leave, std::max(a, b) * (1.0 + kSlack));
  }
  return enter <= leave ? enter : kMiss;
}

}  // namespace vernier::reference
