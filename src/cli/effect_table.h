#pragma once

#include <string>

#include "effects/effect_set.h"

namespace vernier {

/// What a plan says beyond its effects: a line for each thing without a switch, and one for the depth of the ray tree.
std::string unswitched_lines(const EffectSet& effects);

/// A line per effect for people: on or off, name, reason; then a line with the count, and the unswitched_lines.
std::string effect_table(const EffectSet& effects);

}  // namespace vernier
