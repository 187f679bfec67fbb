#include "effects/choose_effects.h"

#include <sstream>

#include "effects/detect_effects.h"
#include "effects/effect_names.h"
#include "error.h"

namespace vernier {
namespace {

constexpr const char* kAsked = "asked for by --effects";

std::uint32_t bit_of(const std::string& name) {
  std::string known;
  for (const EffectName& effect : effect_names()) {
    if (name == effect.name) {
      return effect.bit;
    }
    known += std::string(", ") + effect.name;
  }
  throw Error(ErrorKind::usage, "--effects: there is no effect `" + name + "`; there are auto, all" + known);
}

void add_with_needs(EffectSet& effects, std::uint32_t bit) {
  switch_on(effects, bit, kAsked);
  for (const EffectNeed& need : effect_needs()) {
    if (need.effect == bit) {
      switch_on(effects, need.needed, need_reason(need));
    }
  }
}

void take_with_needs(EffectSet& effects, std::uint32_t bit) {
  switch_off(effects, bit, "switched off by --effects");
  for (const EffectNeed& need : effect_needs()) {
    if (need.needed == bit) {
      switch_off(effects, need.effect, std::string("does nothing without ") + effect_name(bit));
    }
  }
}

void add_detected(EffectSet& effects, const EffectSet& detected) {
  for (const EffectReason& verdict : detected.reasons) {
    if (verdict.on) {
      switch_on(effects, verdict.bit, verdict.reason);
    }
  }
}

void add_all(EffectSet& effects) {
  for (const EffectName& effect : effect_names()) {
    switch_on(effects, effect.bit, kAsked);
  }
}

void apply(EffectSet& effects, const EffectSet& detected, const std::string& item) {
  if (item == "auto") {
    add_detected(effects, detected);
  } else if (item == "all") {
    add_all(effects);
  } else if (item.starts_with('-')) {
    take_with_needs(effects, bit_of(item.substr(1)));
  } else {
    add_with_needs(effects, bit_of(item));
  }
}

}  // namespace

EffectSet choose_effects(const EffectSet& detected, const std::string& list) {
  EffectSet effects = no_effects();
  for (EffectReason& verdict : effects.reasons) {
    verdict.reason = "not in --effects";
  }
  if (list.starts_with("auto") || list.starts_with('-')) {
    effects = detected;
  }
  std::istringstream items(list + ",");
  std::string item;
  while (std::getline(items, item, ',')) {
    apply(effects, detected, item);
  }
  effects.fixed = detected.fixed;
  effects.depth = detected.depth;
  if ((effects.bits & ~detected.bits) != 0) {
    effects.depth.bounces = effects.depth.allowed;
    effects.depth.reason = "--effects asks for more than was found";
  }
  return effects;
}

EffectSet plan_effects(const Scene& scene, const Camera& camera, std::uint32_t max_bounces, double cutoff,
                       const std::string& list) {
  return choose_effects(detect_effects(scene, camera, static_cast<int>(max_bounces), cutoff), list);
}

}  // namespace vernier
