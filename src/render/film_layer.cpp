#include "render/film_layer.h"

#include <algorithm>
#include <array>
#include <string>

#include "shared/film_layout.h"

namespace vernier {
namespace {

/// In the order of the film's words.
const std::array<std::string, FILM_WORDS> kChannels = {
    "red_low",   "red_middle", "red_high", "green_low",  "green_middle",     "green_high", "blue_low", "blue_middle",
    "blue_high", "hits",       "samples",  "non_finite", "first_non_finite", "rays",       "nodes",    "triangles"};
static_assert(FILM_BLUE + 3 == FILM_HITS && FILM_TRIANGLES + 1 == FILM_WORDS);

/// Adds a number of three words, low word first.
void add_wide(std::uint32_t* sum, const std::uint32_t* more) {
  std::uint64_t carry = 0;
  for (int word = 0; word < 3; ++word) {
    carry += std::uint64_t{sum[word]} + more[word];
    sum[word] = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
}

/// The lower of two numbers of samples plus 1, where 0 stands for none.
std::uint32_t first_of(std::uint32_t a, std::uint32_t b) {
  return a == 0 || b == 0 ? std::max(a, b) : std::min(a, b);
}

}  // namespace

Layer film_layer(const std::vector<std::uint32_t>& sums) {
  return {kFilmLayer, {kChannels.begin(), kChannels.end()}, sums};
}

std::vector<std::uint32_t> sums_of_layer(const Layer& layer) {
  const auto* words = std::get_if<std::vector<std::uint32_t>>(&layer.values);
  if (words == nullptr || layer.channels.size() != FILM_WORDS) return {};
  std::vector<std::uint32_t> sums(words->size());
  for (std::size_t word = 0; word < FILM_WORDS; ++word) {
    const auto channel = std::ranges::find(layer.channels, kChannels[word]);
    if (channel == layer.channels.end()) return {};
    const auto place = static_cast<std::size_t>(channel - layer.channels.begin());
    for (std::size_t pixel = 0; pixel < sums.size(); pixel += FILM_WORDS) sums[pixel + word] = (*words)[pixel + place];
  }
  return sums;
}

void add_sums(std::span<std::uint32_t> sums, std::span<const std::uint32_t> more) {
  for (const std::uint32_t color : {FILM_RED, FILM_GREEN, FILM_BLUE}) add_wide(&sums[color], &more[color]);
  for (const std::uint32_t count : {FILM_HITS, FILM_SAMPLES, FILM_NON_FINITE, FILM_RAYS, FILM_NODES, FILM_TRIANGLES}) {
    sums[count] += std::min(more[count], ~sums[count]);  // as saturated_sum of shaders/film.glsl
  }
  sums[FILM_FIRST_NON_FINITE] = first_of(sums[FILM_FIRST_NON_FINITE], more[FILM_FIRST_NON_FINITE]);
}

}  // namespace vernier
