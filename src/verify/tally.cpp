#include "verify/tally.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace vernier {
namespace {

/// The value below which `share` of the errors lie; reorders them.
double quantile(std::vector<float>& errors, double share) {
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(errors.size() - 1));
  std::nth_element(errors.begin(), errors.begin() + rank, errors.end());
  return errors[static_cast<std::size_t>(rank)];
}

}  // namespace

double ulps_from(float answer, double expected) {
  if (std::isnan(answer) && std::isnan(expected)) return 0.0;
  if (!std::isfinite(answer)) {
    return static_cast<float>(expected) == answer ? 0.0 : std::numeric_limits<double>::infinity();
  }
  constexpr int kLeastExponent = -149;
  constexpr int kMantissaBits = 23;
  const int exponent =
      expected == 0.0 ? kLeastExponent : std::max(std::ilogb(expected) - kMantissaBits, kLeastExponent);
  return std::abs(static_cast<double>(answer) - expected) / std::ldexp(1.0, exponent);
}

std::string hex_floats(const std::vector<std::pair<std::string, float>>& values) {
  std::string text;
  for (const auto& [name, value] : values) {
    char number[64];
    std::snprintf(number, sizeof number, "%a", static_cast<double>(value));
    text += (text.empty() ? "" : " ") + name + "=" + number;
  }
  return text;
}

Tally::Tally(std::string unit, double bound) {
  result_.has_errors = true;
  result_.unit = std::move(unit);
  result_.bound = bound;
}

void Tally::note_failure(const std::function<std::string()>& inputs) {
  if (result_.failures == 0) {
    result_.first_failure = result_.samples;
    result_.worst_inputs = inputs();
  }
  ++result_.failures;
}

void Tally::book(bool held, const std::function<std::string()>& inputs) {
  if (!held) note_failure(inputs);
  ++result_.samples;
}

void Tally::book_error(double error, const std::function<std::string()>& inputs) {
  if (!std::isfinite(error)) {
    ++result_.non_finite;
    note_failure(inputs);
  } else {
    if (error > result_.bound) {
      note_failure(inputs);
    } else if (error > result_.max && result_.failures == 0) {
      result_.worst_inputs = inputs();
    }
    result_.max = std::max(result_.max, error);
    errors_.push_back(static_cast<float>(error));
  }
  ++result_.samples;
}

CaseResult Tally::result() const {
  CaseResult result = result_;
  if (errors_.empty()) return result;
  std::vector<float> errors = errors_;
  result.p50 = quantile(errors, 0.5);
  result.p99 = quantile(errors, 0.99);
  double squares = 0.0;
  for (const float error : errors) squares += static_cast<double>(error) * error;
  result.rms = std::sqrt(squares / static_cast<double>(errors.size()));
  return result;
}

}  // namespace vernier
