#include "image/flip_filters.h"

#include <cmath>
#include <numbers>

namespace vernier {
namespace {

constexpr double kPi = std::numbers::pi;

// A sensitivity a1 sqrt(pi / b1) exp(-pi^2 x^2 / b1) + the same with a2, b2, x in degrees.
struct Sensitivity {
  double a1, b1, a2, b2;
};

// FLIP paper, table 1.
Sensitivity sensitivity(Opponent channel) {
  switch (channel) {
    case Opponent::luminance:
      return {1.0, 0.0047, 0.0, 1e-5};
    case Opponent::red_green:
      return {1.0, 0.0053, 0.0, 1e-5};
    case Opponent::blue_yellow:
      return {34.1, 0.04, 13.5, 0.025};
  }
  return {};
}

double sum(const Weights& weights) {
  double total = 0.0;
  for (const double weight : weights) total += weight;
  return total;
}

// exp(-pi^2 x^2 / b) with the factor outside, at offsets of 1 / pixels_per_degree.
Weights gaussian(double b, int radius, double pixels_per_degree) {
  Weights weights;
  for (int offset = -radius; offset <= radius; ++offset) {
    const double x = offset / pixels_per_degree;
    weights.push_back(std::exp(-kPi * kPi * x * x / b));
  }
  return weights;
}

// Positive weights to the sum 1, negative ones to -1.
void normalize_signs(Weights& weights) {
  double positive = 0.0;
  double negative = 0.0;
  for (const double weight : weights) (weight > 0.0 ? positive : negative) += weight;
  for (double& weight : weights) weight /= weight > 0.0 ? positive : -negative;
}

}  // namespace

SeparableFilter contrast_filter(Opponent channel, double pixels_per_degree) {
  // Three standard deviations of the widest Gaussian of all channels, b = 0.04.
  const int radius = static_cast<int>(std::ceil(3.0 * std::sqrt(0.04 / (2.0 * kPi * kPi)) * pixels_per_degree));
  const Sensitivity s = sensitivity(channel);
  SeparableFilter filter;
  std::vector<double> shares;
  double total = 0.0;
  for (const auto& [a, b] : {std::pair{s.a1, s.b1}, std::pair{s.a2, s.b2}}) {
    if (a == 0.0) continue;
    filter.push_back(gaussian(b, radius, pixels_per_degree));
    shares.push_back(a * std::sqrt(kPi / b));
    total += shares.back() * sum(filter.back()) * sum(filter.back());
  }
  // Both directions carry the square root of the factor.
  for (std::size_t term = 0; term < filter.size(); ++term)
    for (double& weight : filter[term]) weight *= std::sqrt(shares[term] / total);
  return filter;
}

FeatureWeights feature_weights(double pixels_per_degree) {
  constexpr double kFeatureWidthDegrees = 0.082;
  const double deviation = 0.5 * kFeatureWidthDegrees * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3.0 * deviation));
  FeatureWeights weights;
  for (int offset = -radius; offset <= radius; ++offset) {
    const double x = offset / deviation;
    const double value = std::exp(-0.5 * x * x);
    weights.smooth.push_back(value);
    weights.edge.push_back(-x * value);
    weights.point.push_back((x * x - 1.0) * value);
  }
  const double total = sum(weights.smooth);
  for (double& weight : weights.smooth) weight /= total;
  normalize_signs(weights.edge);
  normalize_signs(weights.point);
  return weights;
}

}  // namespace vernier
