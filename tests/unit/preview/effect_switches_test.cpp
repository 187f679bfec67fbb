#include "preview/effect_switches.h"

#include <gtest/gtest.h>

#include <bit>

#include "effects/choose_effects.h"
#include "effects/effect_names.h"

namespace vernier {
namespace {

EffectSet automatic() {
  EffectSet effects = no_effects();
  for (const std::uint32_t bit : {EFFECT_SHADOWS, EFFECT_TINTED_SHADOWS, EFFECT_REFLECTION})
    switch_on(effects, bit, "test");
  return effects;
}

EffectSet after(const EffectSet& current, std::uint32_t bit, bool on) {
  return choose_effects(automatic(), with_effect(current, automatic(), bit, on));
}

TEST(EffectSwitchesTest, EachSwitchDoesWhatItSaysAndBackIsAuto) {
  for (const EffectReason& effect : automatic().reasons) {
    const EffectSet switched = after(automatic(), effect.bit, !effect.on);
    EXPECT_EQ((switched.bits & effect.bit) != 0, !effect.on) << effect.name;
  }
  const EffectSet off = after(automatic(), EFFECT_REFLECTION, false);
  EXPECT_EQ(with_effect(off, automatic(), EFFECT_REFLECTION, true), "auto");
}

TEST(EffectSwitchesTest, WhatNeedsItGoesWithIt) {
  const EffectSet off = after(automatic(), EFFECT_SHADOWS, false);
  EXPECT_EQ(off.bits, automatic().bits & ~(EFFECT_SHADOWS | EFFECT_TINTED_SHADOWS));
  const EffectSet on = after(off, EFFECT_TINTED_SHADOWS, true);
  EXPECT_EQ(on.bits, automatic().bits) << "what it needs comes with it";
}

TEST(EffectSwitchesTest, TwoSwitchesAddUp) {
  const EffectSet one = after(automatic(), EFFECT_REFLECTION, false);
  const EffectSet two = after(one, EFFECT_TINTED_SHADOWS, false);
  EXPECT_EQ(two.bits, automatic().bits & ~(EFFECT_REFLECTION | EFFECT_TINTED_SHADOWS));
}

}  // namespace
}  // namespace vernier
