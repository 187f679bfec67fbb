#pragma once

#include <optional>
#include <string>

#include "preview/view_session.h"

namespace vernier {

/// What the panels show beside the session, and what they edit.
struct PanelState {
  std::string source;   ///< the scene's file
  std::string device;
  std::string message;  ///< what went wrong last; empty: nothing
  std::string open_path;
  std::string save_path = "view.png";
  RenderSettings settings;
  DisplaySettings display;
};

/// What the user asked for in this frame.
struct PanelActions {
  std::optional<RenderSettings> settings;  ///< to begin anew with
  bool layer_changed = false;
  bool frame_all = false;
  std::optional<std::size_t> camera;  ///< number in the file
  bool open = false;                  ///< state.open_path
  bool save = false;                  ///< to state.save_path
};

/// Draws the panels into a column `width` pixels wide at the right of the window, and returns what was asked for.
PanelActions draw_panels(const ViewSession& session, PanelState& state, float width);

}  // namespace vernier
