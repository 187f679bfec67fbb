#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "gpu/device.h"
#include "render/render_settings.h"
#include "shared/accuracy.h"

namespace vernier {

/// Under what a case runs.
struct CaseSetup {
  const Device* device = nullptr;
  Accuracy level = Accuracy::robust;                   ///< whose targets count
  std::uint32_t levels = LEVELS_OF(LEVEL_ROBUST);      ///< of the spots, as the kernels are specialized (accuracy.h)
  std::uint32_t mutation = MUTATION_NONE;              ///< seeded fault
  TraversalForm traversal = TraversalForm::automatic;  ///< of rays and pictures
  std::uint64_t seed = 0;                              ///< the inputs are a function of seed, case and sample number
  std::uint64_t sample_count = 1u << 16;               ///< wanted; a case may round up to its own grain
  std::function<bool()> stop;                          ///< true: no more samples are begun; may be empty

  /// Whether sample number `sample` is to be taken.
  bool wants(std::uint64_t sample) const { return sample < sample_count && !(stop && stop()); }
};

/// What a case found. Filled by Tally.
struct CaseResult {
  std::uint64_t samples = 0;
  std::uint64_t failures = 0;  ///< samples that broke the property, or whose error is above the level's bound
  bool has_errors = false;     ///< the case measures errors; else the next four are 0
  double p50 = 0.0;            ///< of the errors, in `unit`
  double p99 = 0.0;
  double max = 0.0;
  double rms = 0.0;                 ///< root of the mean of their squares
  std::string unit;                 ///< "ulp", "absolute", "relative"; empty without errors
  double bound = 0.0;               ///< errors above it are failures; infinity where the level promises nothing
  std::uint64_t non_finite = 0;     ///< answers that are NaN or infinite and should not be; they are failures too
  std::uint64_t first_failure = 0;  ///< sample number of the first failure, where there is one
  std::string not_run;              ///< why the case could not be run here; empty where it was
  std::string worst_inputs;         ///< of the first failure, or else of the largest error: hex floats, named
};

/// One hard case of the catalogue.
struct VerifyCase {
  int number;            ///< in the catalogue, 1 to 56
  const char* name;      ///< for --case: lower case with underscores, unique
  const char* property;  ///< what must hold, one line
  const char* oracle;    ///< "analytic", "double", "float128", "metamorphic", "conservation"
  /// Runs it. Throws Error like any submission.
  CaseResult (*run)(const CaseSetup& setup);
};

/// All cases, by rising number. A number may occur more than once, a name may not.
std::span<const VerifyCase> verify_cases();

}  // namespace vernier
