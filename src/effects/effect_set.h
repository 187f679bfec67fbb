#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shared/effects.h"

namespace vernier {

/// One effect's verdict: the command line's name for it (`tinted_shadows`), on or off, and why: the material,
/// light, texture or setting that asks for it, or what rules it out.
struct EffectReason {
  std::uint32_t bit = 0;
  std::string name;
  bool on = false;
  std::string reason;
};

/// How many reflections and refractions in a row a picture can show, of those that are allowed, and what says so.
struct DepthNeed {
  std::uint32_t bounces = 0;
  std::uint32_t allowed = 0;
  std::string reason;
};

/// Effects a render runs: `bits` is an OR of EFFECT_*; `reasons` has all EFFECT_COUNT effects in bit order.
struct EffectSet {
  std::uint32_t bits = 0;
  std::vector<EffectReason> reasons;
  std::vector<EffectReason> fixed;  ///< what is asked for but has no bit (0), because leaving it out would save nothing
  DepthNeed depth;
};

}  // namespace vernier
