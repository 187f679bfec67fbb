#include "rounding_distance.h"

#include <algorithm>
#include <limits>

#include "reference/baked_triangles.h"
#include "reference/camera_rays.h"
#include "reference/parallel_rows.h"
#include "reference/pixel_samples.h"

namespace vernier::golden {
namespace {

using reference::Ray;
using reference::Triangle;

constexpr double kHalfUlp = 0x1p-24;

// Steps between `ray` and the edge from `a` to `b` at their closest approach.
double steps_between(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b, double largest_coordinate) {
  // Seen along the ray, the edge is a plane segment; the origin is the ray.
  const glm::dvec3 from = a - ray.origin, edge = b - a;
  const glm::dvec3 across = edge - ray.direction * glm::dot(edge, ray.direction);
  const glm::dvec3 offset = from - ray.direction * glm::dot(from, ray.direction);
  const double length_squared = glm::dot(across, across);
  const double s = length_squared > 0.0 ? std::clamp(-glm::dot(offset, across) / length_squared, 0.0, 1.0) : 0.0;
  const double t = glm::dot(from + s * edge, ray.direction);
  if (t < 0.0) return std::numeric_limits<double>::max();
  return glm::length(offset + s * across) / (kHalfUlp * (t + largest_coordinate));
}

double steps_to_nearest(const Ray& ray, const std::vector<Triangle>& triangles, double largest_coordinate) {
  double nearest = std::numeric_limits<float>::max();
  for (const Triangle& triangle : triangles) {
    for (int i = 0; i < 3; ++i) {
      nearest =
          std::min(nearest, steps_between(ray, triangle.corners[i], triangle.corners[(i + 1) % 3], largest_coordinate));
    }
  }
  return nearest;
}

}  // namespace

std::vector<float> steps_to_edge(const CaseSetup& setup, std::uint32_t spp) {
  ReferenceSettings settings;
  settings.width = setup.settings.width;
  settings.height = setup.settings.height;
  settings.spp = spp;
  settings.seed = setup.settings.seed;
  const reference::BakedTriangles baked = reference::bake_triangles(setup.scene.scene);
  const Camera& camera = setup.scene.camera;
  const glm::dvec3 eye = glm::abs(glm::dvec3(camera.world_from_camera[3]));
  const double largest = std::max({baked.largest_coordinate, eye.x, eye.y, eye.z});
  std::vector<float> result(static_cast<std::size_t>(settings.width) * settings.height);
  const auto measure_row = [&](int y) {
    for (int x = 0; x < settings.width; ++x) {
      double nearest = std::numeric_limits<float>::max();
      for (std::uint32_t sample = 0; sample < spp; ++sample) {
        const Ray ray = reference::sample_ray(camera, settings, x, y, sample);
        nearest = std::min(nearest, steps_to_nearest(ray, baked.triangles, largest));
      }
      result[static_cast<std::size_t>(y) * settings.width + x] = static_cast<float>(nearest);
    }
  };
  reference::for_each_row(settings.height, settings.thread_count, measure_row, {});
  return result;
}

}  // namespace vernier::golden
