#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "render/effect_cost.h"

namespace vernier {

/// What `explain` knows of a scene.
struct Explanation {
  std::string scene;   ///< as the user named it
  std::string device;  ///< empty: nothing was measured
  std::string driver;
  RenderSettings settings;
  EffectSet plan;
  double plan_ms = 0.0;  ///< wall time of finding the plan
  EffectLedger ledger;   ///< with a device
};

/// A line per effect: on or off, rays, milliseconds and share of the frame that it takes, error of the picture without
/// it, and why; then the frame, every bounce, and what the pipeline with every effect would take.
std::string ledger_table(const Explanation& explanation);

/// {"schema": 1, "scene", "plan_ms", "effects": [{"name", "on", "reason", "cost"}...]} in bit order, with "fixed" (what
/// has no switch) and "depth", and "device", "frame", "saved_memory", "all_effects" and "bounces"; null for what was
/// not measured. Times in milliseconds.
nlohmann::ordered_json explain_json(const Explanation& explanation);

}  // namespace vernier
