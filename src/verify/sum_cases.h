#pragma once

#include "verify/verify_case.h"

namespace vernier {

/// 2^26 equal or alternating samples (1e-8 and 1e4), in pieces of 50000: each piece starts from the exact sum before
/// it, so by induction the whole chain is right where every piece is. Relative error of the end against integers of 128
/// bits: 1e-7 at robust, none at exact. At fast the pieces tell only how each of them drifts.
CaseResult run_many_samples(const CaseSetup& setup);

inline constexpr VerifyCase kSumCases[] = {
    {50, "many_samples", "the sum of 2^26 samples", "integer", run_many_samples},
};

}  // namespace vernier
