#pragma once

#include "verify/verify_case.h"

namespace vernier {

// Rays that start on a surface: they must neither meet it again nor jump over the next one.

/// 13: 100 squares one behind the other, one step apart and more: each is hit once, in their order.
CaseResult run_layers(const CaseSetup& setup);
/// 13: rays that go on behind a square meet the next one.
CaseResult run_layers_passed(const CaseSetup& setup);
/// 14: rays that go on behind a sphere meet the one 4e-5 or 4e-6 below.
CaseResult run_near_shells(const CaseSetup& setup);
/// 15: triangles with coordinates from 1e-8 to 1e8: no ray meets its own again.
CaseResult run_self_hit(const CaseSetup& setup);
/// 15: origins so near to a triangle that rounding decides: one that lies behind is not hit.
CaseResult run_behind_origin(const CaseSetup& setup);
/// 16: unit triangles 1 to 1e7 away from 0; the error is how far off secondary rays start.
CaseResult run_self_hit_far(const CaseSetup& setup);
/// 17: a strip that bends away: no ray at 1e-4 above it meets a neighbour.
CaseResult run_neighbour_acne(const CaseSetup& setup);
/// 18: no light gets under a box that stands on the floor.
CaseResult run_detached_shadow(const CaseSetup& setup);

}  // namespace vernier
