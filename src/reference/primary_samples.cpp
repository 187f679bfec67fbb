#include "reference/primary_samples.h"

#include <algorithm>
#include <limits>

#include "reference/parallel_rows.h"
#include "reference/pixel_samples.h"
#include "reference/traced_scene.h"

namespace vernier {

namespace {

using namespace reference;

double smallest(const glm::dvec3& weights) {
  return std::min({weights.x, weights.y, weights.z});
}

// How narrowly `ray` misses triangles before `limit` metres; 1 where none is missed by less than kNearEdge.
double nearest_miss(const TracedScene& scene, const Ray& ray, double limit) {
  const ShearedRay sheared(ray, kNoTriangle, scene.baked.largest_coordinate);
  double nearest = 1.0;
  visit_triangles(scene.tree, ray, limit, [&](std::uint32_t id) {
    const std::optional<Crossing> crossing = sheared.plane_crossing(scene.baked.triangles[id], id);
    if (crossing && crossing->t < limit) {
      const double outside = -smallest(crossing->weights);
      if (outside > 0.0 && outside < kNearEdge) nearest = std::min(nearest, outside);
    }
    return limit;
  });
  return nearest;
}

}  // namespace

PrimarySamples primary_samples(const Scene& scene, const Camera& camera, const ReferenceSettings& settings,
                               const std::function<void(double)>& progress) {
  check_settings(settings);
  const TracedScene traced = prepare_scene(scene);
  const std::size_t row_size = static_cast<std::size_t>(settings.width) * settings.spp;
  PrimarySamples samples;
  samples.triangle_ids.resize(row_size * settings.height);
  samples.edge_distances.resize(row_size * settings.height);
  const auto trace_row = [&](int y) {
    for (std::size_t i = 0; i < row_size; ++i) {
      const int x = static_cast<int>(i / settings.spp);
      const Ray ray = sample_ray(camera, settings, x, y, static_cast<std::uint32_t>(i % settings.spp));
      const std::optional<Hit> hit = closest_hit(traced, ray, kNoTriangle);
      const double miss = nearest_miss(traced, ray, hit ? hit->t : std::numeric_limits<double>::infinity());
      samples.triangle_ids[y * row_size + i] = hit ? hit->triangle : kNoTriangle;
      samples.edge_distances[y * row_size + i] =
          static_cast<float>(hit ? std::min(miss, smallest(hit->weights)) : miss);
    }
  };
  for_each_row(settings.height, settings.thread_count, trace_row, progress);
  return samples;
}

}  // namespace vernier
