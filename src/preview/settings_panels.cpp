// The sections that say how the picture is made and shown.
#include <algorithm>
#include <array>

#include "preview/panels.h"
#include "preview/picture_limit.h"

namespace vernier {
namespace {

constexpr std::array<const char*, DISPLAY_COUNT> kLayers = {"Colour",          "Depth",     "Normals",
                                                            "Shading normals", "Albedo",    "Objects",
                                                            "Materials",       "Triangles", "Cost (rays per sample)"};
constexpr std::array<const char*, 3> kLevels = {"fast", "robust", "exact"};
constexpr int kMostSamples = 4096;
constexpr int kMostBounces = 64;

/// Two whole numbers; true when Enter or another widget ended the edit.
bool edit_pair(const char* name, const char* text, PanelState& state, glm::ivec2& pair) {
  label(text);
  ImGui::InputInt2((std::string("##") + name).c_str(), &pair.x);
  note_place(state.places, name);
  return ImGui::IsItemDeactivatedAfterEdit();
}

bool edit_size(PanelState& state) {
  if (!edit_pair("Size", "Size", state, state.edited_size)) return false;
  const glm::ivec2 size = glm::max(state.edited_size, glm::ivec2(1));
  if (const std::string fault = picture_fault(size); !fault.empty()) {
    state.message = "Size: " + fault;
    state.edited_size = {state.settings.width, state.settings.height};
    return false;
  }
  state.edited_size = size;
  state.settings.width = size.x;
  state.settings.height = size.y;
  return true;
}

bool edit_tile(PanelState& state) {
  if (!edit_pair("Tile", "Tile (0: auto)", state, state.edited_tile)) return false;
  // Both or none: 0 lets the renderer choose.
  state.edited_tile = glm::max(state.edited_tile, glm::ivec2(0));
  if (state.edited_tile.x == 0 || state.edited_tile.y == 0) state.edited_tile = glm::ivec2(0);
  state.settings.tile = state.edited_tile;
  return true;
}

/// A slider that counts as moved when it is let go: kernels may have to be compiled.
bool edit_count(const char* name, PanelState& state, std::uint32_t& value, int least, int most) {
  label(name);
  int count = static_cast<int>(value);
  const bool changed = ImGui::SliderInt((std::string("##") + name).c_str(), &count, least, most, "%d",
                                        ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
  note_place(state.places, name);
  if (changed) value = static_cast<std::uint32_t>(count);
  return ImGui::IsItemDeactivatedAfterEdit();
}

}  // namespace

void draw_picture_section(PanelState& state, PanelActions& actions) {
  if (!section("Picture", true)) return;
  RenderSettings& settings = state.settings;
  bool changed = edit_size(state);
  changed |= edit_count("Samples", state, settings.spp, 1, kMostSamples);
  changed |= edit_count("Bounces", state, settings.max_bounces, 0, kMostBounces);
  label("Accuracy");
  int level = static_cast<int>(settings.accuracy);
  if (ImGui::Combo("##accuracy", &level, kLevels.data(), static_cast<int>(kLevels.size()))) {
    settings.accuracy = static_cast<Accuracy>(level);
    changed = true;
  }
  note_place(state.places, "Accuracy");
  changed |= edit_tile(state);
  if (!changed) return;
  settings.sample_end = settings.spp;
  actions.settings = settings;
}

void draw_view_section(PanelState& state) {
  if (!section("View", true)) return;
  label("Show");
  int layer = static_cast<int>(state.display.layer);
  if (ImGui::Combo("##layer", &layer, kLayers.data(), static_cast<int>(kLayers.size()), DISPLAY_COUNT)) {
    state.display.layer = static_cast<std::uint32_t>(layer);
  }
  note_place(state.places, "Show");
  label("Exposure");
  ImGui::SliderFloat("##exposure", &state.display.exposure_ev, -8.0f, 8.0f, "%+.1f stops");
  note_place(state.places, "Exposure");
}

}  // namespace vernier
