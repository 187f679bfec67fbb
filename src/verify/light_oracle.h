#pragma once

#include <glm/glm.hpp>

namespace vernier {

/// Light of a point light of intensity 1 at `offset` from it, not 0: the inverse square law.
long double exact_attenuation(const glm::vec<3, long double>& offset);

/// Share of a point light that a spot light keeps at `offset` from it, by shaders/README.md, Image formation 5.4:
/// `direction` as it is, `cone_scale` = 1 / (cos_inner - cos_outer).
long double exact_cone(const glm::vec<3, long double>& direction, long double cos_outer, long double cone_scale,
                       const glm::vec<3, long double>& offset);

}  // namespace vernier
