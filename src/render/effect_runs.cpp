#include "render/effect_runs.h"

#include <cstring>

#include "shared/effects.h"
#include "shared/film_layout.h"

namespace vernier {
namespace {

static_assert(EFFECT_COUNT <= COUNTER_PATH_RAYS - COUNTER_EFFECT_RUNS, "each effect has a counter");
static_assert(COUNTER_SHADOW_RAYS - COUNTER_PATH_RAYS == COUNTED_DEPTHS);
static_assert(COUNTER_COUNT_WITH_RUNS - COUNTER_SHADOW_RAYS == COUNTED_DEPTHS);

}  // namespace

void add_effect_runs(std::span<const std::byte> counters, EffectRuns& runs) {
  if (counters.empty()) return;
  std::vector<std::uint32_t> words(COUNTER_COUNT_WITH_RUNS - COUNTER_EFFECT_RUNS);
  std::memcpy(words.data(), counters.data(), words.size() * sizeof(std::uint32_t));
  const auto at = [&](std::uint32_t counter) { return words[counter - COUNTER_EFFECT_RUNS]; };
  runs.searches.resize(EFFECT_COUNT);
  runs.by_depth.resize(COUNTED_DEPTHS);
  for (std::uint32_t bit = 0; bit < EFFECT_COUNT; ++bit) runs.searches[bit] += at(COUNTER_EFFECT_RUNS + bit);
  for (std::uint32_t depth = 0; depth < COUNTED_DEPTHS; ++depth) {
    runs.by_depth[depth].path += at(COUNTER_PATH_RAYS + depth);
    runs.by_depth[depth].shadow += at(COUNTER_SHADOW_RAYS + depth);
  }
}

}  // namespace vernier
