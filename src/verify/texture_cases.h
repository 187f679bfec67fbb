#pragma once

#include "verify/verify_case.h"

namespace vernier {

/// Nearest look-ups at hard and random coordinates, in textures of 1 to 4096 texels, all wrap modes: the texel is the
/// one of exact arithmetic, or its neighbour where the place is within the rounding of u times the size, 2^-22 of the
/// size, of a border; texel 0 for NaN and infinity. A wrong texel fails, and so does the first texel for a coordinate
/// just below 0: the border between the periods is exact, for rounding a fraction leaves it within [0, 1].
CaseResult run_texture_wrap(const CaseSetup& setup);
/// Linear look-ups in textures of up to 64 x 64 texels, texel i having the value i. The place rounds thrice on its way
/// to texels, which counts by the value's slope, largest where a texture repeats; two steps of mixing round three times
/// each and count by the largest value: 6 half ulps of the sum of these.
CaseResult run_bilinear(const CaseSetup& setup);
/// UV up to 1e4 at weights down to 1e-6: each component within 6 half ulps of the largest corner value (b0 rounds
/// twice, products once, sums twice).
CaseResult run_interpolated_uv(const CaseSetup& setup);

inline constexpr VerifyCase kTextureCases[] = {
    {48, "texture_wrap", "texel index in range and as in exact arithmetic", "long double", run_texture_wrap},
    {48, "bilinear", "the mean of four texels", "long double", run_bilinear},
    {49, "interpolated_uv", "interpolated UV within its rounding bound", "long double", run_interpolated_uv},
};

}  // namespace vernier
