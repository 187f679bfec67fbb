#include "reference/sample_positions.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace vernier::reference {

namespace {

// "lowbias32" (Wellons 2018, Prospecting for Hash Functions).
std::uint32_t hash(std::uint32_t value) {
  value ^= value >> 16;
  value *= 0x7feb352du;
  value ^= value >> 15;
  value *= 0x846ca68bu;
  return value ^ (value >> 16);
}

std::uint32_t reverse_bits(std::uint32_t value) {
  std::uint32_t reversed = 0;
  for (int bit = 0; bit < 32; ++bit) reversed |= ((value >> bit) & 1u) << (31 - bit);
  return reversed;
}

// Every bit of the result depends only on the same and the higher bits of `value`: a nested (Owen) scrambling.
std::uint32_t scramble(std::uint32_t value, std::uint32_t key) {
  value = reverse_bits(value) + key;
  for (const std::uint32_t factor : {0x6c50b47cu, 0xb82f1e52u, 0xc7afe638u, 0x8d22f6e6u}) value ^= value * factor;
  return reverse_bits(value);
}

std::uint32_t second_sobol_dimension(std::uint32_t index) {
  std::uint32_t result = 0;
  for (std::uint32_t direction = 1u << 31; index != 0; index >>= 1, direction ^= direction >> 1)
    if (index & 1u) result ^= direction;
  return result;
}

double unit_interval(std::uint32_t bits) {
  return (bits >> 8) * 0x1p-24;
}

// Inverse of the tent's integral, from the nearer of its feet.
double tent_coordinate(double share) {
  const double from_foot = std::sqrt(2.0 * std::min(share, 1.0 - share));
  return share < 0.5 ? from_foot - 0.5 : 1.5 - from_foot;
}

}  // namespace

glm::dvec2 sample_position(std::uint32_t x, std::uint32_t y, std::uint32_t sample, std::uint32_t spp,
                           std::uint32_t seed) {
  if (spp == 1) return glm::dvec2(0.5);
  const std::uint32_t key = hash(x + hash(y + hash(seed)));
  const std::uint32_t index = scramble(sample, hash(key + 1));
  return {unit_interval(scramble(reverse_bits(index), hash(key + 2))),
          unit_interval(scramble(second_sobol_dimension(index), hash(key + 3)))};
}

glm::dvec2 tent_position(glm::dvec2 place) {
  return {tent_coordinate(place.x), tent_coordinate(place.y)};
}

}  // namespace vernier::reference
