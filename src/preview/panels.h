#pragma once

#include <optional>
#include <string>
#include <vector>

#include "preview/file_browser.h"
#include "preview/view_session.h"
#include "preview/widgets.h"

namespace vernier {

/// What the panels show beside the session, and what they edit.
struct PanelState {
  std::string device;
  std::string message;  ///< what went wrong last; empty: nothing
  std::string notice;   ///< what went well last
  std::string loading;  ///< the file that is being read; empty: none
  std::string save_path = "vernier.png";
  RenderSettings settings;
  glm::ivec2 edited_size = glm::ivec2(0);  ///< in the fields, until Enter
  glm::ivec2 edited_tile = glm::ivec2(0);
  DisplaySettings display;
  std::optional<EffectLedger> ledger;  ///< of the scene, once measured
  std::optional<double> measuring;     ///< share of the ledger that is done, while it is being measured
  std::optional<PixelFacts> pixel;     ///< under the mouse
  glm::ivec2 pixel_place = glm::ivec2(0);
  FileBrowser browser;
  WidgetPlaces places;
};

/// What the user asked for in this frame.
struct PanelActions {
  std::optional<RenderSettings> settings;  ///< to begin anew with
  std::optional<std::size_t> camera;       ///< number in the file
  std::optional<std::string> open;         ///< a scene file
  bool frame_all = false;
  bool render = false;
  bool stop = false;
  bool save = false;  ///< to state.save_path
  bool measure = false;
  bool loaded = false;  ///< a scene has been read
};

/// Draws the panels into a column `width` pixels wide at the right of the window, and returns what was asked for.
PanelActions draw_panels(const ViewSession& session, PanelState& state, float width);

// The sections of the column, from top to bottom.

/// Open, Render with its progress, Save.
void draw_tasks(const ViewSession& session, PanelState& state, PanelActions& actions);
/// Counts, memory, cameras, warnings.
void draw_scene_section(const ViewSession& session, PanelState& state, PanelActions& actions);
/// Size, samples, bounces, level, tile.
void draw_picture_section(PanelState& state, PanelActions& actions);
/// Layer and exposure.
void draw_view_section(PanelState& state);
/// A switch for each effect, why it is on or off, what it costs.
void draw_effects_section(const ViewSession& session, PanelState& state, PanelActions& actions);
/// Rates, and the error against time.
void draw_time_section(const ViewSession& session);
/// What lies under the mouse.
void draw_pixel_section(const ViewSession& session, const PanelState& state);

}  // namespace vernier
