#pragma once

#include <vector>

#include "golden_case.h"

namespace vernier::golden {

/// How many steps of float rounding the primary rays of a pixel keep from an edge that could change their hit,
/// [height][width]: the smallest over the `spp` samples (1: the pixel centre). 0 where rounding is so coarse
/// that the oracle's reach of 1e-4 barycentrics does not cover it.
///
/// A step is 2^-24 D / s in barycentric coordinates. Float moves the ray, at the depth of the hit, sideways by a few
/// 2^-24 of the numbers it is made of: direction times distance t, and the subtraction of the origin from coordinates
/// of up to L metres; D = t + L. A sideways shift d moves a barycentric coordinate by at most d / s, s the triangle's
/// smallest height times the cosine at which the ray meets it. A near miss does not say which triangle was missed, so
/// the coarsest step among the pixel and its eight neighbours counts.
/// The number of steps themselves: 3 roundings for each of the direction's components and its normalisation, 2 for the
/// translated corner, 2 for the shear and 3 for the edge function, 10 in all; 16 leaves room for the final division.
std::vector<float> steps_to_edge(const CaseSetup& setup, std::uint32_t spp);

}  // namespace vernier::golden
