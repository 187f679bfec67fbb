#pragma once

#include <string>

#include "effects/effect_set.h"

namespace vernier {

/// A line per effect for people: on or off, name, reason; then a line with the count.
std::string effect_table(const EffectSet& effects);

}  // namespace vernier
