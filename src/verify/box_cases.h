#pragma once

#include "verify/verify_case.h"

namespace vernier {

// Box tests and the traversal against every triangle by itself: no box may hide a hit.

/// 20: directions with one or two zeros of either sign, from planes of the boxes.
CaseResult run_zero_component(const CaseSetup& setup);
/// 21: direction components down to denormals; as many steps as other rays take, or 2.5 times that.
CaseResult run_tiny_components(const CaseSetup& setup);
/// 22: boxes without thickness.
CaseResult run_flat_boxes(const CaseSetup& setup);
/// 23: rays at vertices, which are corners and edges of leaf boxes.
CaseResult run_box_corner(const CaseSetup& setup);
/// 23: the box test alone: the four children of one node. Half of the rays lie in planes of the boxes and are short.
CaseResult run_box_alone(const CaseSetup& setup);
/// 26: rays with NaN, infinity or a zero direction: a miss, at no cost.
CaseResult run_invalid_rays(const CaseSetup& setup);

}  // namespace vernier
