#include "effects/needed_depth.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vernier {
namespace {

// The largest n with weight^n >= cutoff. Its logarithms are off by far less than the rounding that `weight` allows for.
double bounces_above(double cutoff, double weight) {
  return std::floor(std::log(cutoff) / std::log(weight));
}

}  // namespace

DepthNeed needed_depth(std::uint32_t effects, std::span<const SeenMaterial> seen, std::uint32_t max_bounces,
                       double cutoff) {
  if ((effects & (EFFECT_REFLECTION | EFFECT_REFRACTION)) == 0) {
    return {0, max_bounces, "no ray is reflected or refracted"};
  }
  const auto deepest = std::ranges::max_element(seen, {}, &SeenMaterial::mirror_weight);
  std::ostringstream reason;
  for (const SeenMaterial& one : seen) {
    if (one.terms.transmission) return {max_bounces, max_bounces, one.label + ": rays in glass need not get weaker"};
  }
  if (deepest == seen.end() || !(deepest->mirror_weight < 1.0) || !(cutoff > 0.0)) {
    reason << (deepest == seen.end() ? "" : deepest->label + ": ") << "rays need not get weaker than the cutoff";
    return {max_bounces, max_bounces, reason.str()};
  }
  const double bounces = bounces_above(cutoff, deepest->mirror_weight);
  reason << deepest->label << ": each reflection leaves at most " << deepest->mirror_weight
         << " of a ray, the cutoff is " << cutoff;
  return {static_cast<std::uint32_t>(std::min<double>(bounces, max_bounces)), max_bounces, reason.str()};
}

}  // namespace vernier
