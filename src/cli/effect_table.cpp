#include "cli/effect_table.h"

#include <algorithm>

namespace vernier {

std::string effect_table(const EffectSet& effects) {
  std::size_t widest = 0;
  std::size_t on_count = 0;
  for (const EffectReason& effect : effects.reasons) {
    widest = std::max(widest, effect.name.size());
    on_count += effect.on ? 1 : 0;
  }
  std::string table;
  for (const EffectReason& effect : effects.reasons) {
    const std::string padding(widest - effect.name.size(), ' ');
    table += (effect.on ? "on   " : "off  ") + effect.name + padding + "  " + effect.reason + "\n";
  }
  return table + std::to_string(on_count) + " of " + std::to_string(effects.reasons.size()) + " effects on\n";
}

nlohmann::ordered_json effects_json(const std::string& scene, const EffectSet& effects) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const EffectReason& effect : effects.reasons) {
    list.push_back({{"name", effect.name}, {"on", effect.on}, {"reason", effect.reason}});
  }
  return {{"schema", 1}, {"scene", scene}, {"effects", list}};
}

}  // namespace vernier
