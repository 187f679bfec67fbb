#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "effects/effect_set.h"

namespace vernier {

/// An effect as the command line calls it, and what is said where nothing of the scene asks for it.
struct EffectName {
  std::uint32_t bit;
  const char* name;
  const char* why_off;
};

/// `effect` does nothing without `needed`, because of `why`.
struct EffectNeed {
  std::uint32_t effect;
  std::uint32_t needed;
  const char* why;
};

/// All EFFECT_COUNT effects in bit order. A name is the lower case of its macro without EFFECT_.
std::span<const EffectName> effect_names();

/// The pairs of effects of which one needs the other. No chains: what is needed needs nothing itself.
std::span<const EffectNeed> effect_needs();

/// `needed by tinted_shadows: ...`: why an effect is on that nothing else asks for.
std::string need_reason(const EffectNeed& need);

/// The name of the one bit that is set in `bit`. Throws std::out_of_range for any other value.
const char* effect_name(std::uint32_t bit);

/// An EffectSet with everything off, each for its usual reason.
EffectSet no_effects();

/// Switches the effect `bit` on for `reason`; the first reason stays where it is on already.
void switch_on(EffectSet& effects, std::uint32_t bit, const std::string& reason);

/// Switches the effect `bit` off for `reason`; leaves alone what is off already.
void switch_off(EffectSet& effects, std::uint32_t bit, const std::string& reason);

}  // namespace vernier
