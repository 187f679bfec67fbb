#include "verify/verify_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bvh/corner_order.h"

namespace vernier {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

glm::vec3 on_sphere(double polar, double azimuth, double radius) {
  return glm::vec3(radius * std::sin(polar) * std::cos(azimuth), radius * std::sin(polar) * std::sin(azimuth),
                   radius * std::cos(polar));
}

/// (u, v) across `axis` at `height`.
glm::vec3 across(int axis, float u, float v, float height) {
  return axis == 0 ? glm::vec3(height, u, v) : axis == 1 ? glm::vec3(v, height, u) : glm::vec3(u, v, height);
}

}  // namespace

VerifyMesh sphere_mesh(std::uint32_t slices, std::uint32_t stacks, double lo, double hi, SampleRandom& random) {
  VerifyMesh mesh;
  mesh.positions = {on_sphere(0.0, 0.0, random.in(lo, hi)), on_sphere(std::numbers::pi, 0.0, random.in(lo, hi))};
  for (std::uint32_t stack = 1; stack < stacks; ++stack) {
    for (std::uint32_t slice = 0; slice < slices; ++slice) {
      mesh.positions.push_back(on_sphere(std::numbers::pi * stack / stacks, kTurn * slice / slices, random.in(lo, hi)));
    }
  }
  const auto at = [&](std::uint32_t stack, std::uint32_t slice) {
    if (stack == 0) return 0u;
    return stack == stacks ? 1u : 2 + (stack - 1) * slices + slice % slices;
  };
  for (std::uint32_t stack = 0; stack < stacks; ++stack) {
    for (std::uint32_t slice = 0; slice < slices; ++slice) {
      const std::uint32_t a = at(stack, slice), b = at(stack + 1, slice);
      const std::uint32_t c = at(stack + 1, slice + 1), d = at(stack, slice + 1);
      if (stack + 1 < stacks) mesh.triangles.push_back({a, b, c});
      if (stack > 0) mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

VerifyMesh double_cone(std::uint32_t valence, double roughness, SampleRandom& random) {
  VerifyMesh mesh;
  mesh.positions = {glm::vec3(0.0f, 0.0f, 1.0f), glm::vec3(0.0f, 0.0f, -1.0f)};
  for (std::uint32_t i = 0; i < valence; ++i) {
    const double azimuth = kTurn * (i + roughness * random.in(-0.2, 0.2)) / valence;
    const double polar = std::numbers::pi * (0.5 + roughness * random.in(-0.1, 0.1));
    mesh.positions.push_back(on_sphere(polar, azimuth, 1.0 - roughness * random.in(0.0, 0.1)));
  }
  for (std::uint32_t i = 0; i < valence; ++i) {
    const std::uint32_t a = 2 + i, b = 2 + (i + 1) % valence;
    mesh.triangles.push_back({0u, a, b});
    mesh.triangles.push_back({1u, b, a});
  }
  return mesh;
}

VerifyMesh grid_mesh(std::uint32_t cells, int axis, float height) {
  VerifyMesh mesh;
  for (std::uint32_t v = 0; v <= cells; ++v) {
    for (std::uint32_t u = 0; u <= cells; ++u) {
      const auto at = [&](std::uint32_t i) { return static_cast<float>(2.0 * i / cells - 1.0); };
      mesh.positions.push_back(across(axis, at(u), at(v), height));
    }
  }
  for (std::uint32_t v = 0; v < cells; ++v) {
    for (std::uint32_t u = 0; u < cells; ++u) {
      const std::uint32_t a = v * (cells + 1) + u, b = a + cells + 1;
      mesh.triangles.push_back({a, a + 1, b + 1});
      mesh.triangles.push_back({a, b + 1, b});
    }
  }
  return mesh;
}

VerifyMesh cube_mesh(std::uint32_t cells) {
  VerifyMesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    append(mesh, grid_mesh(cells, axis, -1.0f));
    append(mesh, grid_mesh(cells, axis, 1.0f));
  }
  return mesh;
}

VerifyMesh triangle_soup(std::uint32_t count, double size, SampleRandom& random) {
  VerifyMesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    const glm::dvec3 center = glm::dvec3(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)) * (1.0 - size);
    for (int corner = 0; corner < 3; ++corner) {
      mesh.positions.push_back(glm::vec3(center + random.direction() * size * random.in(0.2, 1.0)));
    }
    mesh.triangles.push_back(glm::uvec3(3 * i, 3 * i + 1, 3 * i + 2));
  }
  return mesh;
}

void append(VerifyMesh& mesh, const VerifyMesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  for (const glm::uvec3& t : other.triangles) mesh.triangles.push_back(t + first);
}

VerifyMesh placed(VerifyMesh mesh, double scale, const glm::dvec3& offset) {
  for (glm::vec3& p : mesh.positions) p = glm::vec3(glm::dvec3(p) * scale + offset);
  return mesh;
}

double unit_scale(const VerifyMesh& mesh) {
  double largest = 0.0;
  for (const glm::vec3& p : mesh.positions) {
    largest = std::max({largest, std::abs(double{p.x}), std::abs(double{p.y}), std::abs(double{p.z})});
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::ldexp(1.0, -exponent);
}

std::vector<BvhTriangle> triangles_of(const VerifyMesh& mesh) {
  std::vector<BvhTriangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::vec3 v[] = {mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
    const int first = corner_opposite_longest_edge(v[0], v[1], v[2]);
    triangles.push_back(
        {v[first], v[(first + 1) % 3], v[(first + 2) % 3], static_cast<std::uint32_t>(triangles.size())});
  }
  return triangles;
}

}  // namespace vernier
