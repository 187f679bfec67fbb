#include "cli/effect_table.h"

#include <algorithm>

#include "cli/warnings.h"

namespace vernier {

std::string unswitched_lines(const EffectSet& effects) {
  std::size_t widest = 0;
  for (const EffectReason& one : effects.fixed) widest = std::max(widest, one.name.size());
  std::string lines = "with no switch, since nothing would be saved:\n";
  for (const EffectReason& one : effects.fixed) {
    const std::string padding(widest - one.name.size(), ' ');
    lines += (one.on ? "on   " : "off  ") + one.name + padding + "  " + terminal_line(one.reason) + "\n";
  }
  const DepthNeed& depth = effects.depth;
  return lines + "depth needed: " + std::to_string(depth.bounces) + " of " + std::to_string(depth.allowed) +
         " bounces, " + terminal_line(depth.reason) + "\n";
}

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
    table += (effect.on ? "on   " : "off  ") + effect.name + padding + "  " + terminal_line(effect.reason) + "\n";
  }
  return table + std::to_string(on_count) + " of " + std::to_string(effects.reasons.size()) + " effects on\n" +
         unswitched_lines(effects);
}

}  // namespace vernier
