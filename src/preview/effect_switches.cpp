#include "preview/effect_switches.h"

namespace vernier {

std::string with_effect(const EffectSet& current, const EffectSet& automatic, std::uint32_t bit, bool on) {
  std::string list = "auto";
  std::string asked_for;
  for (const EffectReason& effect : current.reasons) {
    const std::string word = (effect.bit == bit ? on : effect.on) ? "," + effect.name : ",-" + effect.name;
    if (effect.bit == bit) {
      asked_for = word;
    } else if (effect.on != ((automatic.bits & effect.bit) != 0)) {
      list += word;
    }
  }
  return on == ((automatic.bits & bit) != 0) && list == "auto" ? list : list + asked_for;
}

}  // namespace vernier
