#pragma once

#include "verify/verify_case.h"

namespace vernier {

/// Lights of intensity 1e-30 to 1e30 at distances 1e-10 to 1e10: irradiance within 1e-5 of the inverse square law
/// (numerics.md 52), infinite or 0 only beyond the range of floats.
CaseResult run_hdr_light(const CaseSetup& setup);
/// Spot lights of 3 to 90 degrees, with edges down to none, seen from inside, outside and across the edge: irradiance
/// over that of the point light. The cone is a square (2) of a cosine with the roundings of two unit vectors and a dot
/// product (8), taken from cos_outer (1), times cone_scale: 16 half ulps for each unit of cone_scale, and 16 for
/// inverse square law and products.
CaseResult run_spot_cone(const CaseSetup& setup);

inline constexpr VerifyCase kLightCases[] = {
    {52, "hdr_light", "inverse square law over the whole range", "long double", run_hdr_light},
    {52, "spot_cone", "light within and across the edge of a cone", "long double", run_spot_cone},
};

}  // namespace vernier
