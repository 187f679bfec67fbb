#pragma once

#include <imgui.h>

#include <cstdint>
#include <map>
#include <string>

namespace vernier {

/// Text beside what matters, and of what went wrong.
inline const ImVec4 kQuietText{0.62f, 0.65f, 0.70f, 1.0f};
inline const ImVec4 kAlarmText{1.0f, 0.58f, 0.48f, 1.0f};

/// Where the widgets of the last frame lie, by their names, in pixels of the window: x, y, width, height. What replays
/// events clicks on names.
using WidgetPlaces = std::map<std::string, ImVec4>;

/// Remembers the widget that was drawn last as `name`.
void note_place(WidgetPlaces& places, const std::string& name);

/// `1 234 567`.
std::string grouped(std::uint64_t number);
/// `1 light`, `1 234 lights`.
std::string counted(std::uint64_t number, const char* thing);
/// `2.3 MB`, decimal.
std::string byte_text(std::uint64_t bytes);
/// printf into a string.
std::string format_text(const char* format, ...) __attribute__((format(printf, 1, 2)));

/// Wrapped text in kQuietText.
void quiet_text(const std::string& text);
/// Wrapped text in kAlarmText.
void alarm_text(const std::string& text);
/// A name on the left; the widget that follows fills the right of the column.
void label(const char* name);
/// A section that can be folded; false while it is.
bool section(const char* name, bool open_at_first);

}  // namespace vernier
