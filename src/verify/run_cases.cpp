#include "verify/run_cases.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "math/elapsed.h"

namespace vernier {

const VerifyCase* find_case(const std::string& name) {
  const std::span<const VerifyCase> cases = verify_cases();
  const auto found = std::find_if(cases.begin(), cases.end(), [&](const VerifyCase& one) { return name == one.name; });
  return found == cases.end() ? nullptr : &*found;
}

std::string case_names() {
  std::string names;
  for (const VerifyCase& one : verify_cases()) names += (names.empty() ? "" : ", ") + std::string(one.name);
  return names;
}

CaseReport run_case(const VerifyCase& verify_case, const CaseSetup& setup) {
  CaseReport report;
  report.verify_case = &verify_case;
  const auto start = std::chrono::steady_clock::now();
  report.result = verify_case.run(setup);
  report.seconds = seconds_since(start);
  const bool met = report.result.samples > 0 && (setup.level == Accuracy::fast || report.result.failures == 0);
  report.held = met || !report.result.not_run.empty();
  const bool bounded = !report.result.has_errors || std::isfinite(report.result.bound);
  report.has_target = setup.level != Accuracy::fast || (report.result.failures == 0 && bounded);
  return report;
}

double rate_bound(std::uint64_t samples) {
  return samples == 0 ? 1.0 : std::min(1.0, 3.0 / static_cast<double>(samples));
}

}  // namespace vernier
