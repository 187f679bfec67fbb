#include "verify/wide_oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vernier {
namespace {

using Wide = __float128;

struct WideVector {
  Wide x, y, z;
};

template <typename Number>
WideVector wide(const glm::vec<3, Number>& v) {
  return {v.x, v.y, v.z};
}

WideVector operator-(const WideVector& a, const WideVector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

Wide dot(const WideVector& a, const WideVector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

WideVector cross(const WideVector& a, const WideVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// `v` as a unit vector; its components are brought near 1 first, where double neither overflows nor underflows.
glm::dvec3 unit(const WideVector& v) {
  const auto size = [](Wide x) { return x < 0 ? -x : x; };
  const Wide largest = std::max({size(v.x), size(v.y), size(v.z)});
  if (largest == 0) return glm::dvec3(0.0);
  return glm::normalize(glm::dvec3(static_cast<double>(v.x / largest), static_cast<double>(v.y / largest),
                                   static_cast<double>(v.z / largest)));
}

WideCrossing crossing_with(const RayQuery& query, const WideVector& v0, const WideVector& v1, const WideVector& v2) {
  const WideVector origin = wide(query.origin), direction = wide(query.direction);
  const WideVector p0 = v0 - origin, p1 = v1 - origin, p2 = v2 - origin;
  // Volumes of the direction with two corners each: the weights of the corners opposite, times their sum.
  const Wide w0 = dot(direction, cross(p1, p2)), w1 = dot(direction, cross(p2, p0)), w2 = dot(direction, cross(p0, p1));
  const Wide sum = w0 + w1 + w2;
  WideCrossing crossing;
  if (sum == 0) {
    crossing.t = std::numeric_limits<double>::quiet_NaN();
    return crossing;
  }
  const WideVector normal = cross(p1 - p0, p2 - p0);
  crossing.t = static_cast<double>(dot(normal, p0) / sum);
  crossing.nearest_edge = static_cast<double>(std::min({w0 / sum, w1 / sum, w2 / sum}));
  crossing.inside = crossing.nearest_edge >= 0.0;
  crossing.cosine = std::abs(glm::dot(unit(normal), unit(direction)));
  return crossing;
}

}  // namespace

WideCrossing wide_crossing(const RayQuery& query, const BvhTriangle& triangle) {
  return crossing_with(query, wide(triangle.v0), wide(triangle.v1), wide(triangle.v2));
}

WideCrossing wide_crossing(const RayQuery& query, const std::array<LongPoint, 3>& corners) {
  return crossing_with(query, wide(corners[0]), wide(corners[1]), wide(corners[2]));
}

glm::dvec3 wide_normal(const BvhTriangle& triangle) {
  const WideVector v0 = wide(triangle.v0);
  return unit(cross(wide(triangle.v1) - v0, wide(triangle.v2) - v0));
}

}  // namespace vernier
