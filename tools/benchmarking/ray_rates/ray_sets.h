#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "../raw_mesh.h"
#include "ray_words.h"

namespace vernier {

/// Where primary rays begin, and the point light.
struct RayView {
  glm::vec3 eye, right, up, forward, light;
  float half_height;  ///< of the picture at distance 1; it is as wide as high
};

enum RayKind { kPrimary, kMirror, kDiffuse, kShadow };
inline constexpr std::array<const char*, 4> kRayKinds = {"primary", "mirror", "diffuse", "shadow"};

/// As many rays of each kind; shadow rays ask for any hit.
inline constexpr std::size_t kRayCount = 1u << 18;
using RaySets = std::array<std::vector<RatedRay>, kRayKinds.size()>;

/// What a ray meets first, with the direction of its triangle's normal, of any length and on either side.
struct SurfaceHit {
  bool hit;
  float t;
  glm::vec3 normal;
};

/// kRayCount rays of each kind. Primary: every fourth 8x8 tile of 1024x1024 pixels. The others start where primary rays
/// of these tiles, then of the rest, meet a surface, which `closest_hit` tells: mirrored at the triangle, in a random
/// direction by the cosine, to the light where the side seen faces it. Throws std::runtime_error where the picture has
/// too few surfaces. The same for every call.
RaySets make_rays(const RayView& view, const std::function<SurfaceHit(const RatedRay&)>& closest_hit);

}  // namespace vernier
