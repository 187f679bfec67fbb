#pragma once

#include "verify/verify_case.h"

namespace vernier {

/// Vectors of length 1e-38 to 1e38: each component of v / |v| within 4 half ulps of 1 (square root, quotient and
/// product round once each, the squares by half as much together); zero, NaN and infinite vectors give the zero vector.
/// A component below 2^-126 may count as 0: Vulkan lets devices flush denormals, and those that do have lost it before.
CaseResult run_unit_vectors(const CaseSetup& setup);
/// Interpolated normals with corners that are zero, huge, infinite, opposite or at right angles to the triangle's own:
/// unit and not on its far side, the triangle's own where nothing else is left.
CaseResult run_shading_normal(const CaseSetup& setup);
/// Tangents of the UV gradient, with degenerate and signed-zero normals among them: unit and orthogonal to the normal.
/// The angle left by projection is rounding over the sine between gradient and normal, so errors are weighed by that
/// sine: 8 half ulps of 1 for two dot products and the unit vector. Handedness is -1 or 1.
CaseResult run_frame(const CaseSetup& setup);

inline constexpr VerifyCase kVectorCases[] = {
    {45, "unit_vectors", "unit or zero for any input", "long double", run_unit_vectors},
    {45, "shading_normal", "unit, on the triangle's side, for any corners", "analytic", run_shading_normal},
    {46, "frame", "tangent unit, orthogonal, of a definite hand", "double", run_frame},
};

}  // namespace vernier
