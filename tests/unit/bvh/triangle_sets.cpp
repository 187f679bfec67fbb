#include "triangle_sets.h"

#include <cmath>
#include <numbers>
#include <random>

namespace vernier::test {

void add(Triangles& triangles, const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2) {
  triangles.push_back({v0, v1, v2, static_cast<std::uint32_t>(triangles.size())});
}

void add_sphere(Triangles& triangles, int rows, const glm::vec3& centre, float radius) {
  const auto point = [&](int i, int j) {
    const double theta = std::numbers::pi * i / rows;
    const double phi = std::numbers::pi * (j % (2 * rows)) / rows;
    const double ring = i == 0 || i == rows ? 0.0 : std::sin(theta);
    return centre + radius * glm::vec3(ring * std::cos(phi), std::cos(theta), ring * std::sin(phi));
  };
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < 2 * rows; ++j) {
      add(triangles, point(i, j), point(i + 1, j), point(i + 1, j + 1));
      add(triangles, point(i, j), point(i + 1, j + 1), point(i, j + 1));
    }
  }
}

Triangles random_soup(std::uint32_t count, float size, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-1.0f, 1.0f);
  const auto point = [&] { return glm::vec3(place(random), place(random), place(random)); };
  Triangles triangles;
  for (std::uint32_t i = 0; i < count; ++i) {
    const glm::vec3 centre = point();
    const glm::vec3 a = centre + size * point();
    const glm::vec3 b = centre + size * point();
    add(triangles, a, b, centre + size * point());
  }
  return triangles;
}

Triangles slivers(std::uint32_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-1.0f, 1.0f);
  const auto point = [&] { return glm::vec3(place(random), place(random), place(random)); };
  Triangles triangles;
  for (std::uint32_t i = 0; i < count; ++i) {
    const glm::vec3 a = point();
    const glm::vec3 b = point();
    add(triangles, a, b, b + 1e-4f * point());
  }
  return triangles;
}

Triangles identical(std::uint32_t count) {
  Triangles triangles;
  for (std::uint32_t i = 0; i < count; ++i) {
    add(triangles, {0.1f, 0.2f, 0.3f}, {0.7f, 0.25f, 0.3f}, {0.3f, 0.9f, 0.4f});
  }
  return triangles;
}

Triangles flat_grid(int side) {
  Triangles triangles;
  const auto point = [&](int i, int j) { return glm::vec3(i, 0, j) / static_cast<float>(side); };
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      add(triangles, point(i, j), point(i + 1, j), point(i + 1, j + 1));
      add(triangles, point(i, j), point(i + 1, j + 1), point(i, j + 1));
    }
  }
  return triangles;
}

Triangles geometric_series() {
  Triangles triangles;
  for (int i = 0; i < 140; ++i) {
    const float x = std::ldexp(1.0f, -i);
    add(triangles, {x, 0, 0}, {1.25f * x, 0.25f * x, 0}, {x, 0, 0.25f * x});
  }
  return triangles;
}

Triangles stairs(int steps) {
  Triangles triangles;
  for (int i = 0; i < steps; ++i) {
    const auto s = static_cast<float>(i == steps - 1 ? 1000 * steps : i);
    add(triangles, {s, s, 0}, {s + 1, s, 0}, {s + 1, s, 1});
    add(triangles, {s, s, 0}, {s + 1, s, 1}, {s, s, 1});
    add(triangles, {s + 1, s, 0}, {s + 1, s + 1, 0}, {s + 1, s + 1, 1});
    add(triangles, {s + 1, s, 0}, {s + 1, s + 1, 1}, {s + 1, s, 1});
  }
  return triangles;
}

Triangles spheres_on_ground(int rows) {
  Triangles triangles;
  for (int k = 0; k < 25; ++k) {
    const glm::vec3 centre = glm::vec3(2.2f * (k % 5 - 2), 0.0f, 2.2f * (k / 5 - 2)) / 16.0f;
    add_sphere(triangles, rows, centre, 1.0f / 16.0f);
  }
  for (BvhTriangle ground : flat_grid(4 * rows)) {
    const glm::vec3 offset(-0.5f, -0.07f, -0.5f);
    add(triangles, ground.v0 + offset, ground.v1 + offset, ground.v2 + offset);
  }
  return triangles;
}

Triangles scaled(Triangles triangles, float factor) {
  for (BvhTriangle& triangle : triangles) {
    triangle.v0 *= factor;
    triangle.v1 *= factor;
    triangle.v2 *= factor;
  }
  return triangles;
}

std::vector<NamedSet> all_sets() {
  Triangles single;
  add(single, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  Triangles two = single;
  add(two, {0, 0, 2}, {1, 0, 2}, {0, 1, 2});
  Triangles far = random_soup(500, 0.01f, 5);
  for (BvhTriangle& triangle : far) {
    const glm::vec3 offset(148376.0f, 1234.0f, -223423.0f);
    triangle = {triangle.v0 * 8.0f + offset, triangle.v1 * 8.0f + offset, triangle.v2 * 8.0f + offset, triangle.id};
  }
  Triangles mixed = random_soup(300, 0.5f, 6);
  add(mixed, {-1000, -1000, 0}, {1000, -1000, 0}, {0, 1000, 0});
  Triangles soup = random_soup(3000, 0.05f, 1);
  return {{"single", single},
          {"two", two},
          {"small soup", random_soup(9, 0.5f, 3)},
          {"soup", soup},
          {"soup of large triangles", random_soup(400, 1.0f, 2)},
          {"slivers", slivers(2000, 4)},
          {"identical", identical(1000)},
          {"flat grid", flat_grid(30)},
          {"geometric series", geometric_series()},
          {"stairs", stairs(200)},
          {"spheres on ground", spheres_on_ground(12)},
          {"far from the origin", far},
          {"mixed sizes", mixed},
          {"huge", scaled(soup, 1e30f)},
          {"tiny", scaled(soup, 1e-30f)},
          {"denormal", scaled(soup, 1e-40f)}};
}

}  // namespace vernier::test
