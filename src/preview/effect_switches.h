#pragma once

#include <cstdint>
#include <string>

#include "effects/effect_set.h"

namespace vernier {

/// The `--effects` list that makes of `current` the same with the effect `bit` on or off: `auto`, then what differs
/// from `automatic`, what `auto` alone switches on. The effect asked for comes last, so that what it needs, or what
/// needs it, follows it.
std::string with_effect(const EffectSet& current, const EffectSet& automatic, std::uint32_t bit, bool on);

}  // namespace vernier
