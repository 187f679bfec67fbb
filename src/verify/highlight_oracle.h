#pragma once

#include <glm/glm.hpp>

namespace vernier {

/// Blinn's highlight in wide arithmetic: the cosine between normal and half vector to the power of `exponent`, by the
/// logarithm of a cosine that is taken from the sine, so that nothing cancels. `normal` counts by its direction alone,
/// not 0. Light and viewer count as they are: they are unit to a rounding each, and scaled to unit length they would
/// turn the half vector by that rounding, which the exponent 1e7 magnifies to 1e-4. 0 where the normal faces away from
/// the half vector.
long double exact_highlight(const glm::vec<3, long double>& normal, const glm::vec<3, long double>& to_light,
                            const glm::vec<3, long double>& to_viewer, long double exponent);

}  // namespace vernier
