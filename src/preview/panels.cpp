#include "preview/panels.h"

#include <imgui_stdlib.h>

#include <algorithm>

namespace vernier {
namespace {

constexpr ImGuiWindowFlags kColumn = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                     ImGuiWindowFlags_AlwaysVerticalScrollbar;

void draw_messages(PanelState& state) {
  if (!state.loading.empty()) quiet_text("Reading " + state.loading + " ...");
  if (!state.notice.empty()) quiet_text(state.notice);
  if (state.message.empty()) return;
  alarm_text(state.message);
  if (ImGui::SmallButton("Dismiss")) state.message.clear();
  note_place(state.places, "Dismiss");
}

/// `12 s`, `3 min`, `2.5 h`.
std::string time_text(double seconds) {
  constexpr double kMinute = 60.0, kHour = 3600.0;
  if (seconds < 2.0 * kMinute) return format_text("%.0f s", seconds);
  return seconds < 2.0 * kHour ? format_text("%.0f min", seconds / kMinute) : format_text("%.1f h", seconds / kHour);
}

std::string progress_text(const ViewSession& session, const PictureState& picture) {
  const std::uint32_t all = session.settings().spp;
  const int done = static_cast<int>(picture.samples_done);
  if (session.is_complete()) return format_text("done: %u samples in %.1f s", all, picture.seconds);
  if (picture.rendering) {
    return format_text("rendering: %d of %u samples, %s left (Esc stops)", done, all, time_text(picture.eta_s).c_str());
  }
  return format_text("preview: %d of %u samples; Render takes all", done, all);
}

}  // namespace

void draw_tasks(const ViewSession& session, PanelState& state, PanelActions& actions) {
  const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2.0f;
  if (ImGui::Button("Open ...", {half, 0.0f})) state.browser.open();
  note_place(state.places, "Open");
  ImGui::SameLine();
  if (ImGui::Button("Frame all (F)", {half, 0.0f})) actions.frame_all = true;
  note_place(state.places, "Frame all");
  draw_messages(state);

  const PictureState& picture = session.state();
  const float share = static_cast<float>(picture.samples_done / session.settings().spp);
  ImGui::ProgressBar(share, {-1.0f, 0.0f}, format_text("%.0f %%", 100.0 * share).c_str());
  quiet_text(progress_text(session, picture));
  if (picture.rendering) {
    if (ImGui::Button("Stop", {half, 0.0f})) actions.stop = true;
  } else {
    if (ImGui::Button("Render (R)", {half, 0.0f})) actions.render = true;
  }
  note_place(state.places, "Render");
  ImGui::SameLine();
  if (ImGui::Button("Save", {half, 0.0f})) actions.save = true;
  note_place(state.places, "Save");
  label("File");
  ImGui::InputText("##save", &state.save_path);
  note_place(state.places, "File");
}

PanelActions draw_panels(const ViewSession& session, PanelState& state, float width) {
  PanelActions actions;
  state.places.clear();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({std::max(window.x - width, 0.0f), 0.0f});
  ImGui::SetNextWindowSize({width, window.y});
  ImGui::Begin("panels", nullptr, kColumn);
  draw_tasks(session, state, actions);
  draw_pixel_section(session, state);
  draw_view_section(state);
  draw_picture_section(state, actions);
  draw_scene_section(session, state, actions);
  draw_time_section(session);
  draw_effects_section(session, state, actions);
  ImGui::Spacing();
  quiet_text(state.device);
  ImGui::End();
  if (const std::optional<std::string> chosen = state.browser.draw(state.places)) actions.open = chosen;
  return actions;
}

}  // namespace vernier
