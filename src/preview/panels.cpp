#include "preview/panels.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace vernier {
namespace {

constexpr std::array<const char*, DISPLAY_COUNT> kLayers = {
    "Colour", "Depth", "Normals", "Shading normals", "Albedo", "Objects", "Materials", "Triangles", "Rays per sample"};
constexpr std::array<const char*, 3> kLevels = {"fast", "robust", "exact"};
const ImVec4 kQuiet{0.62f, 0.65f, 0.70f, 1.0f};
const ImVec4 kAlarm{1.0f, 0.55f, 0.45f, 1.0f};

/// `1 234 567`.
std::string grouped(std::size_t number) {
  std::string digits = std::to_string(number);
  for (int place = static_cast<int>(digits.size()) - 3; place > 0; place -= 3) {
    digits.insert(static_cast<std::size_t>(place), " ");
  }
  return digits;
}

void quiet_text(const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, kQuiet);
  ImGui::TextWrapped("%s", text.c_str());
  ImGui::PopStyleColor();
}

/// A name on the left, the widget that follows on the right.
void label(const char* name) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(name);
  ImGui::SameLine(ImGui::GetWindowWidth() * 0.38f);
  ImGui::SetNextItemWidth(-1.0f);
}

std::size_t triangle_count(const Scene& scene) {
  std::size_t count = 0;
  for (const Instance& instance : scene.instances) count += scene.meshes[instance.mesh].triangles.size();
  return count;
}

void scene_panel(const ViewSession& session, PanelState& state, PanelActions& actions) {
  if (!ImGui::CollapsingHeader("Scene", ImGuiTreeNodeFlags_DefaultOpen)) return;
  const Scene& scene = session.scene();
  ImGui::TextWrapped("%s", state.source.c_str());
  quiet_text(grouped(triangle_count(scene)) + " triangles, " + grouped(scene.materials.size()) + " materials, " +
             grouped(scene.lights.size()) + " lights");
  for (std::size_t index = 0; index < scene.cameras.size(); ++index) {
    const std::string& name = scene.cameras[index].name;
    const std::string text = std::to_string(index + 1) + "  " + (name.empty() ? "camera" : name);
    if (ImGui::Selectable(text.c_str())) actions.camera = index;
  }
  if (ImGui::Button("Frame all (F)", {-1.0f, 0.0f})) actions.frame_all = true;
  label("Open");
  if (ImGui::InputTextWithHint("##open", "file, or drop one", &state.open_path, ImGuiInputTextFlags_EnterReturnsTrue)) {
    actions.open = true;
  }
}

void progress_panel(const ViewSession& session) {
  if (!ImGui::CollapsingHeader("Progress", ImGuiTreeNodeFlags_DefaultOpen)) return;
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "%.0f %%", 100.0 * session.share());
  ImGui::ProgressBar(static_cast<float>(session.share()), {-1.0f, 0.0f}, text.data());
  std::snprintf(text.data(), text.size(), "%.2f Mrays/s, %.1f s, %.1f s left", session.rays_per_s() * 1e-6,
                session.traced_s(), session.eta_s());
  quiet_text(text.data());
}

void settings_panel(PanelState& state, PanelActions& actions) {
  if (!ImGui::CollapsingHeader("Picture", ImGuiTreeNodeFlags_DefaultOpen)) return;
  RenderSettings& settings = state.settings;
  bool changed = false;
  label("Samples");
  int samples = static_cast<int>(settings.spp);
  if (ImGui::SliderInt("##spp", &samples, 1, 1024, "%d", ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp)) {
    settings.spp = settings.sample_end = static_cast<std::uint32_t>(samples);
    changed = true;
  }
  label("Bounces");
  int bounces = static_cast<int>(settings.max_bounces);
  if (ImGui::SliderInt("##bounces", &bounces, 0, 32, "%d", ImGuiSliderFlags_AlwaysClamp)) {
    settings.max_bounces = static_cast<std::uint32_t>(bounces);
    changed = true;
  }
  label("Accuracy");
  int level = static_cast<int>(settings.accuracy);
  if (ImGui::Combo("##accuracy", &level, kLevels.data(), static_cast<int>(kLevels.size()))) {
    settings.accuracy = static_cast<Accuracy>(level);
    changed = true;
  }
  if (changed) actions.settings = settings;
}

void display_panel(PanelState& state, PanelActions& actions) {
  if (!ImGui::CollapsingHeader("View", ImGuiTreeNodeFlags_DefaultOpen)) return;
  label("Show");
  int layer = static_cast<int>(state.display.layer);
  if (ImGui::Combo("##layer", &layer, kLayers.data(), static_cast<int>(kLayers.size()))) {
    state.display.layer = static_cast<std::uint32_t>(layer);
    actions.layer_changed = true;
  }
  label("Exposure");
  ImGui::SliderFloat("##exposure", &state.display.exposure_ev, -8.0f, 8.0f, "%+.1f stops");
}

void effects_panel(const ViewSession& session, PanelState& state, PanelActions& actions) {
  if (!ImGui::CollapsingHeader("Effects")) return;
  for (const EffectReason& effect : session.effects().reasons) {
    bool on = effect.on;
    if (ImGui::Checkbox(effect.name.c_str(), &on)) {
      state.settings.effects += std::string(on ? "," : ",-") + effect.name;
      actions.settings = state.settings;
    }
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", effect.reason.c_str());
  }
  if (ImGui::Button("As the scene asks (auto)", {-1.0f, 0.0f})) {
    state.settings.effects = "auto";
    actions.settings = state.settings;
  }
}

void save_panel(PanelState& state, PanelActions& actions) {
  if (!ImGui::CollapsingHeader("Save", ImGuiTreeNodeFlags_DefaultOpen)) return;
  label("File");
  ImGui::InputText("##save", &state.save_path);
  if (ImGui::Button("Save the picture", {-1.0f, 0.0f})) actions.save = true;
}

}  // namespace

PanelActions draw_panels(const ViewSession& session, PanelState& state, float width) {
  PanelActions actions;
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({window.x - width, 0.0f});
  ImGui::SetNextWindowSize({width, window.y});
  ImGui::Begin("panels", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
  if (!state.message.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, kAlarm);
    ImGui::TextWrapped("%s", state.message.c_str());
    ImGui::PopStyleColor();
    if (ImGui::SmallButton("Dismiss")) state.message.clear();
  }
  scene_panel(session, state, actions);
  progress_panel(session);
  settings_panel(state, actions);
  display_panel(state, actions);
  effects_panel(session, state, actions);
  save_panel(state, actions);
  quiet_text(state.device);
  ImGui::End();
  return actions;
}

}  // namespace vernier
