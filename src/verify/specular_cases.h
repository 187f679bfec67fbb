#pragma once

#include "verify/verify_case.h"

namespace vernier {

/// Blinn's highlight for exponents 1 to 1e7 against the power of the exact cosine in long double: 1e-6 at robust, 1e-7
/// at exact (numerics.md 5.3). The angle to the half vector is drawn so that the highlight lies between 0 and 1.
CaseResult run_extreme_exponent(const CaseSetup& setup);
/// Exponents 0, 1e-6, 1e30 and N.H = 0, -0, 1, below the horizon: the highlight lies in [0, 1], is 1 at exponent 0
/// above the horizon and 0 on and below it.
CaseResult run_highlight_limits(const CaseSetup& setup);
/// A larger exponent never brightens the highlight by more than its error bound.
CaseResult run_highlight_monotone(const CaseSetup& setup);
/// L = -V, exactly and within 1e-7: finite and in [0, 1], and 0 where the half vector vanishes.
CaseResult run_zero_half_vector(const CaseSetup& setup);
/// log(1 - s) for s 1e-36 to 1/4 against log1p in long double. 8 ulps: seven roundings of the series' last steps.
CaseResult run_log_one_minus(const CaseSetup& setup);
/// Schlick's weight (1 - c)^5 against long double: 5 ulps for the rounding of 1 - c, which counts five times, and four
/// products add 4 to it: 9.
CaseResult run_schlick_weight(const CaseSetup& setup);

inline constexpr VerifyCase kSpecularCases[] = {
    {43, "extreme_exponent", "highlight within the level's bound up to exponent 1e7", "long double",
     run_extreme_exponent},
    {43, "highlight_limits", "highlight in [0, 1] at the limits of exponent and cosine", "analytic",
     run_highlight_limits},
    {43, "highlight_monotone", "highlight falls with the exponent", "metamorphic", run_highlight_monotone},
    {43, "log_one_minus", "logarithm of the cosine without cancellation", "long double", run_log_one_minus},
    {43, "schlick_weight", "fifth power at grazing incidence", "long double", run_schlick_weight},
    {44, "zero_half_vector", "no highlight where light and viewer oppose", "analytic", run_zero_half_vector},
};

}  // namespace vernier
