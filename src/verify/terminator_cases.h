#pragma once

#include "verify/verify_case.h"

namespace vernier {

/// A light that sinks over a coarse sphere, seen from places all over it, near edges and vertices too: as long as the
/// light is above the facet, by 1e-4 radians or more, the shadow ray meets nothing. So the shadow term falls once along
/// a sweep, where the light passes the facet's plane, and never comes back. What is not promised: how large that step
/// is. Light on a smooth normal does not fade towards the facet's plane; only finer facets make the step smaller.
/// 1e-4: facets of the sphere are 0.1 wide, and neighbours that should lie in one plane rise by 2^-24 of it over that.
CaseResult run_terminator(const CaseSetup& setup);

inline constexpr VerifyCase kTerminatorCases[] = {
    {47, "terminator", "a convex mesh casts no shadow on facets that face the light", "analytic", run_terminator},
};

}  // namespace vernier
