#include "rounding_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/baked_triangles.h"
#include "reference/camera_rays.h"
#include "reference/pixel_samples.h"
#include "reference/primary_samples.h"

namespace vernier::golden {
namespace {

using reference::Ray;
using reference::Triangle;

constexpr double kHalfUlp = 0x1p-24;
// primary_samples does not look for near misses beyond.
constexpr double kOracleReach = 1e-4;

// Smallest height of `triangle` as seen along `direction`, metres.
double seen_height(const Triangle& triangle, const glm::dvec3& direction) {
  const auto& [a, b, c] = triangle.corners;
  const double longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
  const double area_twice = glm::length(glm::cross(b - a, c - a));
  return area_twice / longest * std::abs(glm::dot(triangle.normal, direction));
}

double rounding_step(const Triangle& triangle, const Ray& ray, double largest_coordinate) {
  const double t =
      glm::dot(triangle.corners[0] - ray.origin, triangle.normal) / glm::dot(ray.direction, triangle.normal);
  return kHalfUlp * (t + largest_coordinate) / seen_height(triangle, ray.direction);
}

std::vector<double> coarsest_of_neighbours(const std::vector<double>& steps, int width, int height) {
  std::vector<double> coarsest(steps.size(), 0.0);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      double& result = coarsest[static_cast<std::size_t>(y) * width + x];
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u) {
          result = std::max(result, steps[static_cast<std::size_t>(v) * width + u]);
        }
      }
    }
  }
  return coarsest;
}

}  // namespace

std::vector<float> steps_to_edge(const CaseSetup& setup, std::uint32_t spp) {
  ReferenceSettings settings;
  settings.width = setup.settings.width;
  settings.height = setup.settings.height;
  settings.spp = spp;
  settings.seed = setup.settings.seed;
  const PrimarySamples samples = primary_samples(setup.scene.scene, setup.scene.camera, settings, {});
  const reference::BakedTriangles baked = reference::bake_triangles(setup.scene.scene);
  const glm::dvec3 eye = glm::abs(glm::dvec3(setup.scene.camera.world_from_camera[3]));
  const double largest = std::max({baked.largest_coordinate, eye.x, eye.y, eye.z});

  const std::size_t pixel_count = static_cast<std::size_t>(settings.width) * settings.height;
  std::vector<double> steps(pixel_count, 0.0);
  std::vector<float> result(pixel_count, std::numeric_limits<float>::max());
  const auto nearest_edge = [&](std::size_t pixel) {
    const auto first = samples.edge_distances.begin() + static_cast<std::ptrdiff_t>(pixel * spp);
    return std::min<double>(*std::min_element(first, first + spp), kOracleReach);
  };
  for (std::size_t i = 0; i < pixel_count * spp; ++i) {
    if (samples.triangle_ids[i] >= baked.triangles.size()) continue;
    const std::size_t pixel = i / spp;
    const Ray ray =
        reference::sample_ray(setup.scene.camera, settings, static_cast<int>(pixel % settings.width),
                              static_cast<int>(pixel / settings.width), static_cast<std::uint32_t>(i % spp));
    const Triangle& triangle = baked.triangles[samples.triangle_ids[i]];
    steps[pixel] = std::max(steps[pixel], rounding_step(triangle, ray, largest));
  }
  const std::vector<double> coarsest = coarsest_of_neighbours(steps, settings.width, settings.height);
  for (std::size_t pixel = 0; pixel < pixel_count; ++pixel) {
    if (coarsest[pixel] > 0.0) result[pixel] = static_cast<float>(nearest_edge(pixel) / coarsest[pixel]);
  }
  return result;
}

}  // namespace vernier::golden
