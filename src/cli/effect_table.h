#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "effects/effect_set.h"

namespace vernier {

/// A line per effect for people: on or off, name, reason; then a line with the count.
std::string effect_table(const EffectSet& effects);

/// {"schema": 1, "scene": ..., "effects": [{"name", "on", "reason"}...]} in bit order.
nlohmann::ordered_json effects_json(const std::string& scene, const EffectSet& effects);

}  // namespace vernier
