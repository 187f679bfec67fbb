#pragma once

#include "verify/verify_case.h"

namespace vernier {

/// 2^26 equal or alternating samples (1e-8 and 1e4), in pieces of 50000: each piece starts from the exact sum before
/// it, so by induction the whole chain is right where every piece is. Relative error of the end against integers of 128
/// bits: 1e-7 at robust, none at exact. At fast the pieces tell only how each of them drifts.
CaseResult run_many_samples(const CaseSetup& setup);
/// Samples of which every other one has a channel that is NaN or infinite: the sum is that of the others alone, bit for
/// bit, all are counted, those that are not finite once more, and the first of them is remembered.
CaseResult run_film_firewall(const CaseSetup& setup);

inline constexpr VerifyCase kSumCases[] = {
    {50, "many_samples", "the sum of 2^26 samples", "integer", run_many_samples},
    {50, "film_firewall", "samples that are not finite are counted, never added", "integer", run_film_firewall},
};

}  // namespace vernier
