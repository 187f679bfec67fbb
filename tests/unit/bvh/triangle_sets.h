#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bvh/bvh.h"

namespace vernier::test {

using Triangles = std::vector<BvhTriangle>;

/// Adds a triangle whose id is its place.
void add(Triangles& triangles, const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2);

/// Sphere of radius `radius` around `centre`, 2 x rows x (2 rows) triangles, those at the poles without area.
void add_sphere(Triangles& triangles, int rows, const glm::vec3& centre, float radius);

/// Small triangles spread over the unit cube.
Triangles random_soup(std::uint32_t count, float size, std::uint32_t seed);
/// Long thin triangles in all directions through the unit cube.
Triangles slivers(std::uint32_t count, std::uint32_t seed);
/// `count` times the same triangle.
Triangles identical(std::uint32_t count);
/// A square grid of 2 side^2 triangles with y = 0: boxes without thickness.
Triangles flat_grid(int side);
/// Triangles at x = 2^-i that shrink as they approach 0, as long as a float has room: every split peels off one.
Triangles geometric_series();
/// A flight of `steps` steps, the last very far away.
Triangles stairs(int steps);
/// 25 spheres over a ground, of uneven density.
Triangles spheres_on_ground(int rows);
/// `triangles` times `factor`.
Triangles scaled(Triangles triangles, float factor);

/// All the above, small, with a name each.
struct NamedSet {
  std::string name;
  Triangles triangles;
};
std::vector<NamedSet> all_sets();

}  // namespace vernier::test
