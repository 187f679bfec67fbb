#pragma once

#include "verify/verify_case.h"

namespace vernier {

/// Power reflected, for eta 1e-3 to 1e3 and cosines 1e-8 to 1. Oracle: Fresnel's equations in long double. Bounds of
/// numerics.md 5.3: what the form without cancellation leaves of rounded squares.
CaseResult run_fresnel_sweep(const CaseSetup& setup);
/// Reflected and transmitted power make 1 within 1e-6 (robust: some ten roundings of terms up to 1) or 1e-7 (exact).
CaseResult run_fresnel_energy(const CaseSetup& setup);
/// Power reflected for |eta - 1| = 0 and 2^-23 to 1e-2. At eta = 1 exactly nothing, else within 2e-5 or 1e-7.
CaseResult run_fresnel_near_one(const CaseSetup& setup);
/// Power reflected at the critical angle's cosine times 1 +- 2^-1 to 2^-30, where it moves with the root of the
/// distance: the same bounds, for g^2 comes from exact squares.
CaseResult run_fresnel_critical(const CaseSetup& setup);
/// Total reflection is decided as in exact arithmetic: g^2 of floats has the right sign at both levels.
CaseResult run_critical_angle(const CaseSetup& setup);
/// Transmitted power at cosines 2^-1 to 2^-26, in ulps: 16 at robust, 1 at exact (wide arithmetic, rounded at the end).
CaseResult run_grazing_glass(const CaseSetup& setup);

inline constexpr VerifyCase kFresnelCases[] = {
    {35, "fresnel_sweep", "reflected power within the level's bound", "long double", run_fresnel_sweep},
    {35, "fresnel_energy", "reflected and transmitted power make 1", "conservation", run_fresnel_energy},
    {36, "fresnel_near_one", "reflected power where the indices nearly agree", "long double", run_fresnel_near_one},
    {37, "fresnel_critical", "reflected power next to the critical angle", "long double", run_fresnel_critical},
    {37, "critical_angle", "total reflection decided as in exact arithmetic", "long double", run_critical_angle},
    {38, "grazing_glass", "transmitted power at grazing incidence", "long double", run_grazing_glass},
};

}  // namespace vernier
