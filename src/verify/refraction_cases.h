#pragma once

#include "verify/verify_case.h"

namespace vernier {

/// Refracted direction against Snell's law in long double. Exact: 1 half ulp of 1, for only the result is rounded.
/// Robust: 8 half ulps of 1 (roundings of k, g, two products, sum, quotient and the final unit vector's three) and as
/// many for each unit of condition: the cosine comes from three roundings of vectors that are unit to one each. Exits
/// so flat that sin^2 is above 15/16 are left out: there the rounding of the inputs decides.
CaseResult run_refracted_direction(const CaseSetup& setup);
/// At eta = 1 the refracted direction is the incoming one, within 4 half ulps of 1 for the unit vector at robust and 1
/// at exact.
CaseResult run_pass_through(const CaseSetup& setup);
/// Into a plane-parallel plate and out of it again: the ray leaves in the direction in which it came, 4 eps = 8 half
/// ulps of 1 (numerics.md 42). Twice the roundings of a refraction, whose errors across the direction grow by the ratio
/// of the cosines on the way out, at robust by the condition of that refraction; and the quotient 1 / eta, which tilts
/// the exit by its rounding times the tangent.
CaseResult run_plate_exit(const CaseSetup& setup);
/// Sideways shift of that ray in a plate of thickness 1: sin(theta_i) (1 - cos(theta_i) / (eta cos(theta_t))). The same
/// bound: the shift is the way within, at most 1 / cos(theta_t), times the error of the direction there.
CaseResult run_plate_shift(const CaseSetup& setup);

inline constexpr VerifyCase kRefractionCases[] = {
    {36, "pass_through", "equal indices bend nothing", "analytic", run_pass_through},
    {42, "refracted_direction", "refracted direction follows Snell's law", "long double", run_refracted_direction},
    {42, "plate_exit", "rays leave a plate as they came", "analytic", run_plate_exit},
    {42, "plate_shift", "rays are shifted sideways by a plate", "analytic", run_plate_shift},
};

}  // namespace vernier
