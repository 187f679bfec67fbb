#include "preview/widgets.h"

#include <array>
#include <cstdarg>
#include <cstdio>

namespace vernier {

void note_place(WidgetPlaces& places, const std::string& name) {
  const ImVec2 corner = ImGui::GetItemRectMin();
  const ImVec2 size = ImGui::GetItemRectSize();
  places[name] = {corner.x, corner.y, size.x, size.y};
}

std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (int place = static_cast<int>(digits.size()) - 3; place > 0; place -= 3) {
    digits.insert(static_cast<std::size_t>(place), " ");
  }
  return digits;
}

std::string counted(std::uint64_t number, const char* thing) {
  return grouped(number) + " " + thing + (number == 1 ? "" : "s");
}

std::string byte_text(std::uint64_t bytes) {
  const double amount = static_cast<double>(bytes);
  if (bytes >= 1000000000u) return format_text("%.2f GB", amount * 1e-9);
  return bytes >= 1000000u ? format_text("%.1f MB", amount * 1e-6) : format_text("%.0f kB", amount * 1e-3);
}

std::string format_text(const char* format, ...) {
  std::array<char, 256> text{};
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text.data(), text.size(), format, arguments);
  va_end(arguments);
  return text.data();
}

namespace {

void colored_text(const std::string& text, const ImVec4& color) {
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

}  // namespace

void quiet_text(const std::string& text) {
  colored_text(text, kQuietText);
}

void alarm_text(const std::string& text) {
  colored_text(text, kAlarmText);
}

void label(const char* name) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(name);
  ImGui::SameLine(ImGui::GetWindowWidth() * 0.34f);
  ImGui::SetNextItemWidth(-1.0f);
}

bool section(const char* name, bool open_at_first) {
  ImGui::Spacing();
  return ImGui::CollapsingHeader(name, open_at_first ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
}

}  // namespace vernier
