#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace vernier::reference {

/// Where sample `sample` of `spp` lies within pixel (x, y) of the full image: both coordinates in [0, 1), multiples
/// of 2^-24. (1/2, 1/2) for spp = 1; otherwise independent of spp. "Image formation" section 1: Owen-scrambled Sobol
/// points in shuffled order (Burley 2020, Practical Hash-based Owen Scrambling, JCGT 9(4)).
glm::dvec2 sample_position(std::uint32_t x, std::uint32_t y, std::uint32_t sample, std::uint32_t spp,
                           std::uint32_t seed);

/// Where a sample at `place` in [0, 1)^2 is moved to, in [-1/2, 3/2)^2, so that samples lie as densely as a tent of
/// width 2 around the pixel's centre is high. "Image formation" section 1.
glm::dvec2 tent_position(glm::dvec2 place);

}  // namespace vernier::reference
