#include "preview/script_values.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "error.h"
#include "preview/picture_limit.h"
#include "render/setting_limits.h"

namespace vernier {
namespace {

[[noreturn]] void refuse(const ScriptEvent& event, const std::string& why = "") {
  throw Error(ErrorKind::usage, "script, line " + std::to_string(event.line) + ": `" + event.words[0] +
                                    "` cannot be `" + event.words[1] + "`" + why);
}

std::uint32_t count_of(const ScriptEvent& event, std::uint32_t least, std::uint32_t most) {
  char* end = nullptr;
  const unsigned long value = std::strtoul(event.words[1].c_str(), &end, 10);
  if (*end != '\0' || value < least || value > most) refuse(event);
  return static_cast<std::uint32_t>(value);
}

glm::ivec2 pair_of(const ScriptEvent& event, int least) {
  constexpr int kMostSide = 8192;
  glm::ivec2 pair;
  char rest = '\0';
  const bool read = std::sscanf(event.words[1].c_str(), "%dx%d%c", &pair.x, &pair.y, &rest) == 2;
  if (!read || pair.x < least || pair.y < least || pair.x > kMostSide || pair.y > kMostSide) refuse(event);
  return pair;
}

float exposure_of(const ScriptEvent& event) {
  constexpr float kMostStops = 100.0f;
  char* end = nullptr;
  const float value = std::strtof(event.words[1].c_str(), &end);
  if (*end != '\0' || !(std::abs(value) <= kMostStops)) refuse(event);
  return value;
}

Accuracy level_of(const ScriptEvent& event) {
  for (const Accuracy level : kAccuracies) {
    if (event.words[1] == to_string(level)) return level;
  }
  refuse(event);
}

/// True where the name is one of the picture's settings.
bool set_picture(const ScriptEvent& event, PanelState& state) {
  constexpr std::uint32_t kMostSamples = 65536;
  const std::string& name = event.words[0];
  RenderSettings& settings = state.settings;
  if (name == "Size") {
    state.edited_size = pair_of(event, 1);
    if (const std::string fault = picture_fault(state.edited_size); !fault.empty()) refuse(event, ", " + fault);
    settings.width = state.edited_size.x;
    settings.height = state.edited_size.y;
  } else if (name == "Samples") {
    settings.spp = settings.sample_end = count_of(event, 1, kMostSamples);
  } else if (name == "Bounces") {
    settings.max_bounces = count_of(event, 0, kMaxBounces);
  } else if (name == "Accuracy") {
    settings.accuracy = level_of(event);
  } else if (name == "Tile") {
    settings.tile = state.edited_tile = pair_of(event, 0);
  } else if (name == "Effects") {
    settings.effects = event.words[1];
  } else {
    return false;
  }
  return true;
}

}  // namespace

void set_by_script(const ScriptEvent& event, PanelState& state, PanelActions& actions) {
  const std::string& name = event.words[0];
  if (set_picture(event, state)) {
    actions.settings = state.settings;
  } else if (name == "Show") {
    state.display.layer = count_of(event, 0, DISPLAY_COUNT - 1);
  } else if (name == "Exposure") {
    state.display.exposure_ev = exposure_of(event);
  } else if (name == "File") {
    state.save_path = event.words[1];
  } else {
    refuse(event);
  }
}

}  // namespace vernier
