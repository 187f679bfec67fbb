#pragma once

#include <algorithm>
#include <cmath>

#include "bvh/lanes.h"

namespace vernier {

/// Grows `box` to hold `point`. Coordinates are finite.
inline void grow(Box& box, const glm::vec3& point) {
  box.lo = glm::min(box.lo, point);
  box.hi = glm::max(box.hi, point);
}

/// Grows `box` to hold `other`; an empty `other` changes nothing because each side only takes the smaller lo and larger
/// hi.
inline void grow(Box& box, const Box& other) {
  box.lo = glm::min(box.lo, other.lo);
  box.hi = glm::max(box.hi, other.hi);
}

/// Bounds of the three corners.
inline Box triangle_bounds(const BvhTriangle& triangle) {
  return {glm::min(glm::min(triangle.v0, triangle.v1), triangle.v2),
          glm::max(glm::max(triangle.v0, triangle.v1), triangle.v2)};
}

/// Half the surface of `box`, 0 for an empty one. In double: sides from 1e-45 to 1e38 neither underflow nor overflow.
inline double half_area(const Box& box) {
  if (box.lo.x > box.hi.x || box.lo.y > box.hi.y || box.lo.z > box.hi.z) {
    return 0.0;
  }
  const glm::dvec3 side = glm::dvec3(box.hi) - glm::dvec3(box.lo);
  return side.x * side.y + side.y * side.z + side.z * side.x;
}

/// Longest side of `box`, 0 for an empty one.
inline float longest_side(const Box& box) {
  const glm::vec3 side = box.hi - box.lo;
  return std::max(0.0f, std::max(side.x, std::max(side.y, side.z)));
}

/// The distance by which every side of a box must be moved outwards: 2^-22 of its largest absolute coordinate (on any
/// axis, because the sheared triangle test mixes the axes), at least 2^-40 of the scene's longest side. Exact in
/// double.
inline double promised_padding(const Box& box, float scene_extent) {
  const glm::vec3 reach = glm::max(glm::abs(box.lo), glm::abs(box.hi));
  const double largest = std::max(reach.x, std::max(reach.y, reach.z));
  return std::max(0x1p-22 * largest, 0x1p-40 * scene_extent);
}

/// How far pad_box moves the sides of a box whose largest absolute coordinate is `largest`.
///
/// Half as much again is added because the subtraction rounds: its error is at most 2^-24 of the largest coordinate,
/// a quarter of the promise. The smallest normal float keeps denormal boxes from a padding of 0.
inline float padding_of(float largest, float scene_extent) {
  return std::max(1.5f * std::max(0x1p-22f * largest, 0x1p-40f * scene_extent), 0x1p-126f);
}

/// `box` moved outwards by promised_padding or a little more. Monotone: the padded box of a box holds the padded
/// boxes of all boxes inside it. Works up to coordinates of 1e38; the box is not empty.
inline Box pad_box(const Box& box, float scene_extent) {
  const glm::vec3 reach = glm::max(glm::abs(box.lo), glm::abs(box.hi));
  const float padding = padding_of(std::max(reach.x, std::max(reach.y, reach.z)), scene_extent);
  return {box.lo - padding, box.hi + padding};
}

/// The same for a box in registers.
inline LaneBox pad_box(const LaneBox& box, float scene_extent) {
  const Lanes reach = lanes_max(lanes_max(box.lo, -box.lo), lanes_max(box.hi, -box.hi));
  const float padding = padding_of(std::max({reach[0], reach[1], reach[2]}), scene_extent);
  return {box.lo - padding, box.hi + padding};
}

}  // namespace vernier
