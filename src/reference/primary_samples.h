#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "reference/render_reference.h"

namespace vernier {

/// What every sample's primary ray meets, [height][width][spp]: the oracle of tests that compare hits one by one.
struct PrimarySamples {
  /// The global number of the triangle hit, 4294967295 for a miss.
  std::vector<std::uint32_t> triangle_ids;
  /// How near the ray passes to an edge that could change its hit, in barycentric coordinates: the smallest coordinate
  /// of the hit, or less where the ray just misses a triangle in front of it: then how far the worst coordinate is
  /// below 0. A miss: the latter over all triangles. Near misses of 1e-4 and more are not looked for; a miss without
  /// one has 1.
  std::vector<float> edge_distances;
};

/// Traces the primary rays that render_reference would trace with the same arguments; the same errors and progress.
PrimarySamples primary_samples(const Scene& scene, const Camera& camera, const ReferenceSettings& settings,
                               const std::function<void(double)>& progress);

}  // namespace vernier
