#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "verify/verify_case.h"

namespace vernier {

/// A case that was run.
struct CaseReport {
  const VerifyCase* verify_case = nullptr;
  CaseResult result;
  double seconds = 0.0;
  bool held = false;  ///< the target of the level is met; nothing is promised at fast, and of a case that was not run
  bool has_target = true;  ///< false at fast where samples failed, and where errors have no bound to be held against
};

/// The case called `name`; nullptr when there is none.
const VerifyCase* find_case(const std::string& name);

/// The names of all cases, separated by commas.
std::string case_names();

/// Runs one case and takes its time.
CaseReport run_case(const VerifyCase& verify_case, const CaseSetup& setup);

/// Upper bound of the failure rate, 95 % confidence, when `samples` showed none: 3 / N (the rule of three, Hanley and
/// Lippman-Hand 1983, JAMA 249). 0 samples bound nothing: 1.
double rate_bound(std::uint64_t samples);

}  // namespace vernier
