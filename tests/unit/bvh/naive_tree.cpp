#include "naive_tree.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace vernier::test {
namespace {

struct Extent {
  glm::dvec3 lo = glm::dvec3(std::numeric_limits<double>::infinity());
  glm::dvec3 hi = glm::dvec3(-std::numeric_limits<double>::infinity());

  void add(const BvhTriangle& triangle) {
    for (const glm::vec3& corner : {triangle.v0, triangle.v1, triangle.v2}) {
      lo = glm::min(lo, glm::dvec3(corner));
      hi = glm::max(hi, glm::dvec3(corner));
    }
  }
  double area() const {
    const glm::dvec3 side = hi - lo;
    return side.x * side.y + side.y * side.z + side.z * side.x;
  }
};

Extent extent_of(std::span<const BvhTriangle> triangles) {
  Extent extent;
  for (const BvhTriangle& triangle : triangles) {
    extent.add(triangle);
  }
  return extent;
}

void sort_by_centre(std::span<BvhTriangle> triangles, int axis) {
  std::sort(triangles.begin(), triangles.end(), [axis](const BvhTriangle& a, const BvhTriangle& b) {
    const auto key = [axis](const BvhTriangle& t) {
      return std::min({t.v0[axis], t.v1[axis], t.v2[axis]}) + std::max({t.v0[axis], t.v1[axis], t.v2[axis]});
    };
    return key(a) != key(b) ? key(a) < key(b) : a.id < b.id;
  });
}

// Sum of the areas of the subtree's nodes, leaves twice.
double area_sum(std::span<BvhTriangle> triangles) {
  if (triangles.size() == 1) {
    return 2.0 * extent_of(triangles).area();
  }
  double best_cost = std::numeric_limits<double>::infinity();
  int best_axis = 0;
  std::size_t best_middle = 1;
  for (int axis = 0; axis < 3; ++axis) {
    sort_by_centre(triangles, axis);
    std::vector<double> right_areas(triangles.size());
    Extent right;
    for (std::size_t i = triangles.size(); i-- > 1;) {
      right.add(triangles[i]);
      right_areas[i] = right.area();
    }
    Extent left;
    for (std::size_t i = 1; i < triangles.size(); ++i) {
      left.add(triangles[i - 1]);
      const double cost =
          left.area() * static_cast<double>(i) + right_areas[i] * static_cast<double>(triangles.size() - i);
      if (cost < best_cost) {
        best_cost = cost;
        best_axis = axis;
        best_middle = i;
      }
    }
  }
  sort_by_centre(triangles, best_axis);
  return extent_of(triangles).area() + area_sum(triangles.first(best_middle)) +
         area_sum(triangles.subspan(best_middle));
}

}  // namespace

double naive_sah_cost(std::span<const BvhTriangle> triangles) {
  std::vector<BvhTriangle> own(triangles.begin(), triangles.end());
  return area_sum(own) / extent_of(triangles).area();
}

}  // namespace vernier::test
