#include "effects/choose_effects.h"

#include <gtest/gtest.h>

#include "effects/effect_names.h"
#include "error.h"
#include "one_triangle.h"

namespace vernier {
namespace {

EffectSet detected_with(std::uint32_t bits) {
  EffectSet effects = no_effects();
  for (const EffectName& effect : effect_names()) {
    if (bits & effect.bit) {
      switch_on(effects, effect.bit, "the scene");
    }
  }
  return effects;
}

TEST(ChooseEffects, AutoKeepsBitsAndReasons) {
  const EffectSet detected = detected_with(EFFECT_SHADOWS | EFFECT_AMBIENT);
  const EffectSet chosen = choose_effects(detected, "auto");
  EXPECT_EQ(chosen.bits, detected.bits);
  EXPECT_EQ(reason_for(chosen, EFFECT_SHADOWS), "the scene");
  EXPECT_EQ(reason_for(chosen, EFFECT_EMISSION), reason_for(detected, EFFECT_EMISSION));
}

TEST(ChooseEffects, AllIsEveryBit) {
  EXPECT_EQ(choose_effects(no_effects(), "all").bits, (1u << EFFECT_COUNT) - 1u);
}

TEST(ChooseEffects, ListIsReadFromLeftToRight) {
  const EffectSet detected = detected_with(EFFECT_AMBIENT);
  EXPECT_EQ(choose_effects(detected, "shadows,reflection").bits, EFFECT_SHADOWS | EFFECT_REFLECTION);
  EXPECT_EQ(choose_effects(detected, "auto,emission").bits, EFFECT_AMBIENT | EFFECT_EMISSION);
  EXPECT_EQ(choose_effects(detected, "shadows,-shadows").bits, 0u);
  EXPECT_EQ(choose_effects(detected, "-shadows,shadows").bits, EFFECT_AMBIENT | EFFECT_SHADOWS);
  EXPECT_EQ(choose_effects(detected, "-ambient").bits, 0u);
}

TEST(ChooseEffects, NeededEffectsComeAndGoTogether) {
  EXPECT_EQ(choose_effects(no_effects(), "tinted_shadows").bits, EFFECT_TINTED_SHADOWS | EFFECT_SHADOWS);
  EXPECT_EQ(choose_effects(no_effects(), "absorption").bits, EFFECT_ABSORPTION | EFFECT_REFRACTION);
  EXPECT_EQ(choose_effects(no_effects(), "spot_lights").bits, EFFECT_SPOT_LIGHTS | EFFECT_POINT_LIGHTS);
  const EffectSet without = choose_effects(no_effects(), "all,-shadows");
  EXPECT_EQ(without.bits & (EFFECT_SHADOWS | EFFECT_TINTED_SHADOWS), 0u);
  EXPECT_EQ(reason_for(without, EFFECT_TINTED_SHADOWS), "does nothing without shadows");
}

TEST(ChooseEffects, UnknownNameIsAUsageError) {
  for (const char* list : {"shadow", "auto,-fog", "", "auto,", "-auto", "Shadows"}) {
    try {
      choose_effects(no_effects(), list);
      ADD_FAILURE() << "accepted `" << list << "`";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage) << list;
    }
  }
}

TEST(EffectNames, NoChainOfNeeds) {
  for (const EffectNeed& need : effect_needs()) {
    for (const EffectNeed& other : effect_needs()) {
      EXPECT_NE(need.needed, other.effect) << effect_name(need.effect);
    }
  }
}

TEST(EffectNames, NotABitThrows) {
  EXPECT_THROW(effect_name(0), std::out_of_range);
  EXPECT_THROW(effect_name(3), std::out_of_range);
  EXPECT_THROW(effect_name(1u << EFFECT_COUNT), std::out_of_range);
}

}  // namespace
}  // namespace vernier
