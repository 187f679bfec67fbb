#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "verify/verify_case.h"

namespace vernier {

/// Distance of `answer` from `expected` in units of the last place of float32 at `expected` (at least 2^-149). NaN or
/// infinity of one alone is infinitely far.
double ulps_from(float answer, double expected);

/// Values with their names as hex floats: "ray.direction.x=0x1.8p-3 ...".
std::string hex_floats(const std::vector<std::pair<std::string, float>>& values);

/// Counts samples, failures and errors of a case. Sample numbers rise.
class Tally {
 public:
  /// For yes-or-no cases.
  Tally() = default;
  /// For cases that measure: errors are in `unit`, those above `bound` are failures.
  Tally(std::string unit, double bound);

  /// Books a sample that held or not; `inputs` is called for the first failure alone.
  void book(bool held, const std::function<std::string()>& inputs);
  /// Books an error; NaN and infinity count as non-finite failures. `inputs` is called for the first failure and for
  /// the largest error so far.
  void book_error(double error, const std::function<std::string()>& inputs);

  /// What was booked.
  CaseResult result() const;

 private:
  void note_failure(const std::function<std::string()>& inputs);

  CaseResult result_;
  std::vector<float> errors_;
};

}  // namespace vernier
