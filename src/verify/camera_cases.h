#pragma once

#include "verify/verify_case.h"

namespace vernier {

/// Ray directions for fields of view 1e-4 to 179.99 degrees against double: 8 half ulps of 1 (numerics.md 53: 4 eps).
/// The oracle takes the axes as rounded to floats.
CaseResult run_camera_edges(const CaseSetup& setup);

inline constexpr VerifyCase kCameraCases[] = {
    {53, "camera_edges", "ray directions for extreme fields of view", "long double", run_camera_edges},
};

}  // namespace vernier
