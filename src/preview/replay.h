#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "preview/imgui_input.h"
#include "preview/panels.h"
#include "preview/script.h"

namespace vernier {

/// What an event asks of the window, beside mouse and keys.
struct ReplayRequest {
  PanelActions actions;
  std::optional<std::string> drop;
  std::optional<glm::ivec2> window_size;  ///< pixels
  std::optional<std::string> shot;        ///< name of a screenshot
  bool close = false;
  bool lose_device = false;
};

/// A script in the place of the user: events come through the same widgets and the same camera as mouse and keys do.
class Replay {
 public:
  /// Begins with the first of `events`.
  explicit Replay(std::vector<ScriptEvent> events);

  /// The next event, if it is due: one a frame, so that each is seen apart. `settled`: nothing is left to trace, to
  /// read or to show. Edits `state` where an event sets something. Throws Error(usage) with the line for a widget that
  /// is not there and a value that makes no sense.
  ReplayRequest step(bool settled, PanelState& state);
  /// What has not been done.
  std::vector<ScriptEvent> events_left() const;
  /// Mouse and keys of the next frame.
  ScriptedInput next_input();

 private:
  void point(const ScriptEvent& event);
  void click(const ScriptEvent& event, const WidgetPlaces& places);
  bool is_due(const ScriptEvent& event, bool settled);
  ReplayRequest perform(const ScriptEvent& event, PanelState& state);

  std::vector<ScriptEvent> events_;
  std::size_t next_ = 0;
  std::optional<std::chrono::steady_clock::time_point> waiting_since_;
  ScriptedInput input_;   // but for clicks and keys under way
  int click_frames_ = 0;  // left of a click: pressed, then released
  int key_frames_ = 0;
  int pressed_key_ = -1;
};

}  // namespace vernier
