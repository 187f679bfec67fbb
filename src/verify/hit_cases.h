#pragma once

#include "verify/verify_case.h"

namespace vernier {

// What a hit says: which triangle, at which t, within which limits.

/// 8: triangles of 1e-6 over a ground of 1e6; the error is that of t.
CaseResult run_mixed_scales(const CaseSetup& setup);
/// 9: triangles without area among others are never hit.
CaseResult run_degenerate(const CaseSetup& setup);
/// 10: normals of triangles of area 2^-2 to 2^-60; the error is in what rounding the edges once makes of them.
CaseResult run_near_degenerate(const CaseSetup& setup);
/// 12: of identical triangles the one with the lowest number is hit.
CaseResult run_coplanar_duplicates(const CaseSetup& setup);
/// 19: rays 1/2 to 2^-22 above a plane; the error is that of t, by its condition but at the exact level.
CaseResult run_grazing(const CaseSetup& setup);
/// 25: limits of t at a hit and a step from it.
CaseResult run_t_limits(const CaseSetup& setup);

}  // namespace vernier
