#include "preview/effect_switches.h"
#include "preview/panels.h"

namespace vernier {
namespace {

/// Of the frame's time, what `effect` takes; empty where it was not measured.
std::string cost_text(const PanelState& state, const EffectReason& effect) {
  if (!state.ledger) return "";
  for (const EffectCost& cost : state.ledger->effects) {
    if (cost.bit != effect.bit) continue;
    return is_noise(cost.ratio) ? "noise" : format_text("%+.0f %%", 100.0 * (1.0 - cost.ratio.median));
  }
  return "";
}

/// The button that begins the measurement, or how far it is.
void draw_measuring(PanelState& state, PanelActions& actions) {
  if (state.measuring) {
    ImGui::ProgressBar(static_cast<float>(*state.measuring), {-1.0f, 0.0f}, "Measuring (Esc ends it)");
    note_place(state.places, "Measuring");
    return;
  }
  if (ImGui::Button("Measure what each costs", {-1.0f, 0.0f})) actions.measure = true;
  note_place(state.places, "Measure");
  if (!state.ledger) return;
  quiet_text("Share of the frame's time that leaving it out saves");
  note_place(state.places, "Costs");
  if (state.ledger->complete) return;
  quiet_text("Ended before all were measured");
  note_place(state.places, "Unmeasured");
}

void draw_effect(const ViewSession& session, const EffectReason& effect, PanelState& state, PanelActions& actions) {
  // The reason belongs to the switch above it: closer to that than to the next one.
  const ImVec2 spacing = ImGui::GetStyle().ItemSpacing;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {spacing.x, spacing.y * 0.3f});
  bool on = effect.on;
  if (ImGui::Checkbox(effect.name.c_str(), &on)) {
    state.settings.effects = with_effect(session.effects(), session.automatic_effects(), effect.bit, on);
    actions.settings = state.settings;
  }
  note_place(state.places, effect.name);
  const std::string cost = cost_text(state, effect);
  if (!cost.empty()) {
    ImGui::SameLine(ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(cost.c_str()).x);
    ImGui::TextUnformatted(cost.c_str());
  }
  const float indent = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x;
  ImGui::Indent(indent);
  quiet_text(effect.reason);
  ImGui::Unindent(indent);
  ImGui::PopStyleVar();
  ImGui::Spacing();
}

}  // namespace

void draw_effects_section(const ViewSession& session, PanelState& state, PanelActions& actions) {
  if (!section("Effects", true)) return;
  draw_measuring(state, actions);
  if (state.settings.effects != "auto" && ImGui::Button("As the scene asks (auto)", {-1.0f, 0.0f})) {
    state.settings.effects = "auto";
    actions.settings = state.settings;
  }
  for (const bool on : {true, false}) {
    for (const EffectReason& effect : session.effects().reasons) {
      if (effect.on == on) draw_effect(session, effect, state, actions);
    }
  }
}

}  // namespace vernier
