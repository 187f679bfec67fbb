#include "verify/random.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace vernier {
namespace {

std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

}  // namespace

SampleRandom::SampleRandom(std::uint64_t seed, std::string_view case_name, std::uint64_t sample) : state_(mixed(seed)) {
  for (const char c : case_name) state_ = mixed(state_ ^ static_cast<unsigned char>(c));
  state_ = mixed(state_ + sample);
}

std::uint64_t SampleRandom::bits() {
  state_ += 0x9e3779b97f4a7c15u;
  return mixed(state_);
}

double SampleRandom::unit() {
  return static_cast<double>(bits() >> 11) * 0x1p-53;
}

double SampleRandom::in(double lo, double hi) {
  return lo + (hi - lo) * unit();
}

double SampleRandom::power_of_ten(double lo, double hi) {
  return std::pow(10.0, in(lo, hi));
}

std::uint32_t SampleRandom::below(std::uint32_t count) {
  return static_cast<std::uint32_t>(((bits() >> 32) * count) >> 32);
}

glm::dvec3 SampleRandom::direction() {
  const double z = in(-1.0, 1.0);
  const double angle = in(0.0, 2.0 * std::numbers::pi);
  const double radius = std::sqrt((1.0 - z) * (1.0 + z));
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

float SampleRandom::stepped(float value, int steps) {
  const float target = steps < 0 ? -std::numeric_limits<float>::infinity() : std::numeric_limits<float>::infinity();
  for (int i = 0; i != steps; i += steps < 0 ? -1 : 1) value = std::nextafter(value, target);
  return value;
}

}  // namespace vernier
