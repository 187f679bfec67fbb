#include "ray_sets.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

namespace vernier {
namespace {

constexpr std::uint32_t kSide = 1024;  // pixels of the picture
constexpr std::uint32_t kTile = 8;
constexpr std::uint32_t kTileStep = 4;  // one tile of so many belongs to a set
constexpr float kFar = std::numeric_limits<float>::max();

// How far secondary rays start off the triangle, in the study scene's unit, a sphere's radius: far above the rounding
// of places up to 30 away (2^-19), far below the size of a triangle of a million (2^-5).
constexpr float kOffset = 0x1p-14f;

RatedRay primary_ray(const RayView& view, std::uint32_t x, std::uint32_t y) {
  const auto centered = [](std::uint32_t pixel) { return 2.0f * (static_cast<float>(pixel) + 0.5f) / kSide - 1.0f; };
  const glm::vec3 across = view.right * (centered(x) * view.half_height);
  const glm::vec3 down = view.up * (centered(y) * view.half_height);
  return {view.eye, 0, glm::normalize(view.forward + across - down), kFar};
}

/// Of the tiles that lie on every fourth diagonal, beginning with `first`.
std::vector<RatedRay> primary_rays(const RayView& view, std::uint32_t first) {
  std::vector<RatedRay> rays;
  for (std::uint32_t tile_y = 0; tile_y < kSide / kTile; ++tile_y) {
    for (std::uint32_t tile_x = 0; tile_x < kSide / kTile; ++tile_x) {
      if ((tile_x + tile_y) % kTileStep != first) continue;
      for (std::uint32_t i = 0; i < kTile * kTile; ++i) {
        rays.push_back(primary_ray(view, tile_x * kTile + i % kTile, tile_y * kTile + i / kTile));
      }
    }
  }
  return rays;
}

/// A direction around `normal`, as dense as its cosine is high (a point on the unit sphere above the normal's end).
glm::vec3 cosine_direction(const glm::vec3& normal, std::mt19937& random) {
  const auto unit = [&random] { return static_cast<float>(random() >> 8) * 0x1p-24f; };  // [0, 1) in 24 bits
  const float z = 2.0f * unit() - 1.0f;
  const float angle = 2.0f * std::numbers::pi_v<float> * unit();
  const float radius = std::sqrt(std::max(0.0f, 1.0f - z * z));
  const glm::vec3 direction = normal + glm::vec3(radius * std::cos(angle), radius * std::sin(angle), z);
  return glm::dot(direction, direction) > 0.0f ? glm::normalize(direction) : normal;
}

void add_secondary(RaySets& sets, const RayView& view, const RatedRay& ray, const SurfaceHit& hit,
                   std::mt19937& random) {
  const float side = glm::dot(hit.normal, ray.direction) > 0.0f ? -1.0f : 1.0f;
  const glm::vec3 normal = glm::normalize(hit.normal) * side;
  const glm::vec3 origin = ray.origin + ray.direction * hit.t + normal * kOffset;
  const glm::vec3 mirrored = ray.direction - normal * (2.0f * glm::dot(normal, ray.direction));
  const glm::vec3 to_light = view.light - origin;
  const auto add = [&sets](RayKind kind, const RatedRay& added) {
    if (sets[kind].size() < kRayCount) sets[kind].push_back(added);
  };
  add(kMirror, {origin, 0, mirrored, kFar});
  add(kDiffuse, {origin, 0, cosine_direction(normal, random), kFar});
  if (glm::dot(normal, to_light) > 0.0f) add(kShadow, {origin, 1, to_light, 1.0f});
}

/// Workgroups 0, 2, 4 and so on, then 1, 3, 5: a driver that gives each thread a fixed part of the workgroups shares
/// the picture among them that way, and neighbours in the picture stay neighbours in time.
std::vector<RatedRay> in_balanced_order(const std::vector<RatedRay>& rays) {
  std::vector<RatedRay> ordered;
  ordered.reserve(rays.size());
  for (const std::size_t first : {std::size_t{0}, std::size_t{RATED_GROUP}}) {
    for (std::size_t i = first; i < rays.size(); i += std::size_t{2} * RATED_GROUP) {
      ordered.insert(ordered.end(), rays.begin() + static_cast<std::ptrdiff_t>(i),
                     rays.begin() + static_cast<std::ptrdiff_t>(i + RATED_GROUP));
    }
  }
  return ordered;
}

}  // namespace

RaySets make_rays(const RayView& view, const std::function<SurfaceHit(const RatedRay&)>& closest_hit) {
  RaySets sets;
  std::mt19937 random(1);  // mt19937 gives the same numbers everywhere
  for (std::uint32_t first = 0; first < kTileStep; ++first) {
    const std::vector<RatedRay> primary = primary_rays(view, first);
    if (first == 0) sets[kPrimary] = primary;
    for (const RatedRay& ray : primary) {
      const SurfaceHit hit = closest_hit(ray);
      if (hit.hit) add_secondary(sets, view, ray, hit, random);
    }
  }
  for (std::vector<RatedRay>& rays : sets) {
    if (rays.size() != kRayCount) throw std::runtime_error("the picture has too few surfaces for rays of each kind");
    rays = in_balanced_order(rays);
  }
  return sets;
}

}  // namespace vernier
