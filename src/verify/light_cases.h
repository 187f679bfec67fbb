#pragma once

#include "verify/verify_case.h"

namespace vernier {

/// Lights of intensity 1e-30 to 1e30 at distances 1e-10 to 1e10: irradiance within 1e-5 of the inverse square law
/// (numerics.md 52), infinite or 0 only beyond the range of floats.
CaseResult run_hdr_light(const CaseSetup& setup);

inline constexpr VerifyCase kLightCases[] = {
    {52, "hdr_light", "inverse square law over the whole range", "long double", run_hdr_light},
};

}  // namespace vernier
