#include "preview/file_browser.h"

#include <GLFW/glfw3.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <ranges>

#include "preview/imgui_input.h"
#include "scene/load_scene.h"

namespace vernier {

namespace fs = std::filesystem;

void FileBrowser::open() {
  open_ = true;
  std::error_code failure;
  enter(folder_.empty() ? fs::current_path(failure) : folder_);
}

void FileBrowser::start_at(const std::string& file) {
  std::error_code failure;
  const fs::path path = fs::absolute(file, failure);
  if (!failure && path.has_parent_path()) folder_ = path.parent_path();
}

void FileBrowser::enter(const fs::path& folder) {
  folder_ = folder;
  entries_.clear();
  std::error_code failure;
  for (fs::directory_iterator place(folder, failure), end; !failure && place != end; place.increment(failure)) {
    std::error_code unreadable;
    const bool is_folder = place->is_directory(unreadable);
    const std::string name = place->path().filename().string();
    if (name.front() == '.' || !(is_folder || has_scene_extension(place->path()))) continue;
    entries_.push_back({name, is_folder});
  }
  std::ranges::sort(entries_, [](const Entry& a, const Entry& b) {
    return a.is_folder != b.is_folder ? a.is_folder : a.name < b.name;
  });
}

std::optional<std::string> FileBrowser::draw_recent() const {
  std::optional<std::string> chosen;
  if (recent_.empty()) return chosen;
  ImGui::TextUnformatted("Recent");
  constexpr int kShown = 5;  // more would leave no room for the folder
  for (const std::string& file : recent_ | std::views::take(kShown)) {
    if (ImGui::Selectable(file.c_str())) chosen = file;
  }
  ImGui::Separator();
  return chosen;
}

std::optional<std::string> FileBrowser::draw_entries(WidgetPlaces& places) {
  std::optional<std::string> chosen;
  std::optional<fs::path> next;
  ImGui::BeginChild("entries", {0.0f, -2.0f * ImGui::GetFrameHeightWithSpacing()}, true);
  if (ImGui::Selectable("..")) next = folder_.parent_path();
  for (const Entry& entry : entries_) {
    if (ImGui::Selectable((entry.is_folder ? entry.name + "/" : entry.name).c_str())) {
      if (entry.is_folder) {
        next = folder_ / entry.name;
      } else {
        chosen = (folder_ / entry.name).string();
      }
    }
    note_place(places, "Entry " + entry.name);
  }
  ImGui::EndChild();
  if (next) enter(*next);
  return chosen;
}

std::optional<std::string> FileBrowser::draw(WidgetPlaces& places) {
  if (!open_) return std::nullopt;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x * 0.5f, screen.y * 0.5f}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(screen.x * 0.9f, ImGui::GetFontSize() * 36.0f),
                            std::min(screen.y * 0.9f, ImGui::GetFontSize() * 30.0f)});
  ImGui::Begin("Open a scene", &open_,
               ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
  std::optional<std::string> chosen = draw_recent();
  quiet_text(folder_.string());
  if (const std::optional<std::string> entry = draw_entries(places)) chosen = entry;
  ImGui::SetNextItemWidth(-1.0f);
  if (ImGui::InputTextWithHint("##typed", "or type a path and press Enter", &typed_,
                               ImGuiInputTextFlags_EnterReturnsTrue)) {
    chosen = typed_;
  }
  note_place(places, "Path");
  if (ImGui::Button("Cancel") || is_pressed(GLFW_KEY_ESCAPE)) open_ = false;
  note_place(places, "Cancel");
  ImGui::End();
  if (chosen) open_ = false;
  return chosen;
}

}  // namespace vernier
