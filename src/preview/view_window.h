#pragma once

#include <chrono>
#include <future>
#include <memory>
#include <optional>

#include "preview/latency.h"
#include "preview/orbit_view.h"
#include "preview/panels.h"
#include "preview/replay.h"
#include "preview/viewer.h"
#include "preview/window_stage.h"

namespace vernier {

/// Of the panels beside the picture, at a scale of 1, pixels.
constexpr int kPanelWidth = 340;

/// A scene in a window: input, panels, picture. Owns all but the window, which outlives it.
class ViewWindow {
 public:
  /// Shows `first` at once. `plan` outlives it.
  ViewWindow(const ViewPlan& plan, Window& window, ViewedScene first);
  ~ViewWindow();

  /// Until the window is closed. Throws Error as view_scene.
  void run();
  /// The plan that would open what is seen now.
  ViewPlan plan_of_now() const;

 private:
  using Clock = std::chrono::steady_clock;

  bool is_closing() const;
  double aspect() const;
  void show(ViewedScene viewed);
  void load(const std::string& source);
  void take_loaded();

  bool frame(double wait_s);
  bool has_work() const;
  bool settled() const;
  void take_input(glm::ivec2 room);
  void take_keys();
  void replay();
  void note(const PanelActions& now);
  void draw_film();
  void inspect(const ShownPicture& shown);
  void present(glm::ivec2 size, glm::ivec2 room);
  void write_shot();
  void write_places() const;

  void apply();
  void perform(const PanelActions& actions);
  void look(const OrbitView& view);
  void look_through(const CameraWords& words);
  void set_settings(const RenderSettings& settings);
  void measure();
  void save();
  void finish();

  const ViewPlan& plan_;
  Window& window_;
  WindowStage stage_;
  std::unique_ptr<ViewSession> session_;
  std::unique_ptr<FilmDisplay> display_;
  PanelState state_;
  PanelActions actions_;
  std::optional<Replay> replay_;
  std::optional<std::string> shot_;
  std::future<ViewedScene> loading_;
  WorldBounds bounds_{};
  CameraWords words_;
  OrbitView view_;
  std::optional<OrbitView> wanted_view_;
  glm::ivec2 shown_size_ = glm::ivec2(0);
  glm::ivec2 inspected_ = glm::ivec2(-1);
  DisplaySettings shown_;
  Latency latency_;
  mutable std::string places_text_;
  bool stale_ = true;
  bool lose_device_ = false;
  Clock::time_point last_frame_ = Clock::now(), earliest_input_ = last_frame_, last_move_ = last_frame_;
};

}  // namespace vernier
