// What a window does between two traces.
#include <cstdio>
#include <filesystem>
#include <new>
#include <utility>

#include "error.h"
#include "math/elapsed.h"
#include "preview/camera_words.h"
#include "preview/recent_files.h"
#include "preview/view_window.h"
#include "render/read_film.h"

namespace vernier {
namespace {

/// Between two frames while a picture is traced, which shares the processor with them on CPU devices.
constexpr double kFrameSeconds = 0.05;
/// Without input for that long the camera is at rest.
constexpr double kRestSeconds = 0.15;
/// While there is nothing to trace.
constexpr double kIdleWaitSeconds = 0.1;
/// The same while something else goes on.
constexpr double kBusyWaitSeconds = 0.01;

}  // namespace

ViewWindow::ViewWindow(const ViewPlan& plan, Window& window, ViewedScene first)
    : plan_(plan), window_(window), stage_(window, plan.device, {plan.settings.width, plan.settings.height}) {
  state_.settings = plan.settings;
  state_.display.exposure_ev = plan.exposure_ev;
  state_.device = stage_.device().description().name;
  state_.message = plan.message;
  state_.browser.set_recent(read_recent_files(recent_files_path()));
  if (!plan.record_folder.empty()) replay_.emplace(plan.script);
  show(std::move(first));
  // With a scene to show: nobody looks at an empty window.
  window_.show();
  latency_.begin(window_.opened());
}

ViewWindow::~ViewWindow() = default;

bool ViewWindow::is_closing() const {
  return window_.wants_to_close() || (plan_.interrupted && plan_.interrupted());
}

double ViewWindow::aspect() const {
  return aspect_of(state_.settings);
}

void ViewWindow::run() {
  while (!is_closing()) {
    apply();
    if (session_->is_finished()) {
      frame(replay_ || loading_.valid() ? kBusyWaitSeconds : kIdleWaitSeconds);
    } else {
      session_->trace([this] { return is_closing() || (seconds_since(last_frame_) > kFrameSeconds && frame(0.0)); },
                      [this] { return is_closing(); });
      stale_ = true;
      frame(0.0);
    }
    if (seconds_since(last_move_) > kRestSeconds) session_->come_to_rest();
  }
  finish();
}

void ViewWindow::finish() {
  stage_.store();
  if (replay_) std::fprintf(stderr, "%s\n", latency_.text().c_str());
  const std::vector<std::string> messages = stage_.validation_messages();
  for (const std::string& message : messages) std::fprintf(stderr, "validation: %s\n", message.c_str());
  if (!messages.empty()) throw Error(ErrorKind::failed, "the validation layer found faults");
}

ViewPlan ViewWindow::plan_of_now() const {
  ViewPlan plan = plan_;
  plan.source = session_->viewed().source;
  plan.settings = session_->settings();
  plan.words = words_;
  plan.exposure_ev = state_.display.exposure_ev;
  if (replay_) plan.script = replay_->events_left();
  return plan;
}

/// Puts `viewed` in the place of the scene before; on failure that stays.
void ViewWindow::show(ViewedScene viewed) {
  const std::string source = viewed.source;
  const CameraWords words = viewed.words;
  const WorldBounds bounds = seen_bounds(viewed.scene);
  auto session = std::make_unique<ViewSession>(stage_.device(), std::move(viewed), state_.settings);
  auto display = std::make_unique<FilmDisplay>(stage_.device(), session->film());
  display_ = std::move(display);
  session_ = std::move(session);
  bounds_ = bounds;
  words_ = words;
  view_ = orbit_view(session_->camera(), bounds);
  state_.edited_size = {state_.settings.width, state_.settings.height};
  state_.edited_tile = state_.settings.tile;
  state_.display.far_depth_m =
      static_cast<float>(glm::length(view_.target - glm::dvec3(view_.camera.world_from_camera[3])));
  state_.ledger.reset();
  shown_size_ = glm::ivec2(0);
  stale_ = true;
  last_move_ = Clock::now();
  const std::string name = source.empty() ? "built-in scene" : std::filesystem::path(source).filename().string();
  window_.set_title("Vernier: " + name);
  state_.save_path = source.empty() ? "vernier.png" : std::filesystem::path(source).stem().string() + ".png";
  if (source.empty()) return;
  state_.browser.start_at(source);
  std::error_code failure;
  const std::string place = std::filesystem::absolute(source, failure).string();
  const std::vector<std::string> recent = with_recent(read_recent_files(recent_files_path()), place);
  write_recent_files(recent_files_path(), recent);
  state_.browser.set_recent(recent);
}

/// Reads a scene beside what is going on.
void ViewWindow::load(const std::string& source) {
  if (loading_.valid()) throw Error(ErrorKind::failed, "wait until " + state_.loading + " is read");
  state_.loading = source;
  state_.message.clear();
  state_.notice.clear();
  loading_ = std::async(std::launch::async, plan_.load_scene, source, CameraWords{}, aspect());
}

void ViewWindow::take_loaded() {
  if (loading_.valid() && loading_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
    actions_.loaded = true;
}

/// Does what was asked for, between two traces.
void ViewWindow::apply() {
  const PanelActions actions = std::exchange(actions_, {});
  const std::optional<OrbitView> view = std::exchange(wanted_view_, std::nullopt);
  if (std::exchange(lose_device_, false)) throw Error(ErrorKind::device_lost, "the device was lost");
  try {
    if (view) look(*view);
    perform(actions);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::device_lost) throw;
    state_.message = error.what();
    state_.notice.clear();
    state_.settings = session_->settings();
    state_.edited_size = {state_.settings.width, state_.settings.height};
  } catch (const std::bad_alloc&) {  // by what is loaded beside
    state_.message = "not enough memory on the host";
  }
}

void ViewWindow::perform(const PanelActions& actions) {
  if (actions.open) load(*actions.open);
  if (actions.loaded) {
    state_.loading.clear();
    show(loading_.get());
    state_.message.clear();
  }
  if (actions.settings) set_settings(*actions.settings);
  if (actions.camera && *actions.camera < session_->scene().cameras.size()) {
    look_through(
        {.camera = std::to_string(*actions.camera), .eye = {}, .target = {}, .up = {}, .fov = {}, .view_height = {}});
  }
  if (actions.frame_all) look(framed(view_, bounds_, aspect()));
  if (actions.render) session_->render();
  if (actions.stop) session_->stop();
  if (actions.measure) measure();
  if (actions.save) save();
}

void ViewWindow::look(const OrbitView& view) {
  words_ = camera_words(words_, view);
  view_ = view;
  const Camera camera = plan_.camera_of(session_->scene(), words_, aspect());
  view_.camera = camera;
  session_->set_camera(camera);
  last_move_ = Clock::now();
}

void ViewWindow::look_through(const CameraWords& words) {
  const Camera camera = plan_.camera_of(session_->scene(), words, aspect());
  words_ = words;
  view_ = orbit_view(camera, bounds_);
  session_->set_camera(camera);
  last_move_ = Clock::now();
}

void ViewWindow::set_settings(const RenderSettings& settings) {
  const bool resized = settings.width != session_->settings().width || settings.height != session_->settings().height;
  if (resized) stage_.presenter().set_largest_picture({settings.width, settings.height});
  const Film* film = &session_->film();
  session_->set_settings(settings);
  if (&session_->film() != film) {
    display_ = std::make_unique<FilmDisplay>(stage_.device(), session_->film());
    shown_size_ = glm::ivec2(0);
  }
  state_.settings = settings;
  state_.edited_size = {settings.width, settings.height};
  // A camera that is framed depends on the picture's sides.
  if (resized && words_.eye.empty()) session_->set_camera(plan_.camera_of(session_->scene(), words_, aspect()));
  last_move_ = Clock::now();
  stale_ = true;
}

/// Whatever is asked for meanwhile ends it: what is measured by then is kept. Each step compiles a kernel, so that it
/// may take seconds.
void ViewWindow::measure() {
  state_.measuring = 0.0;
  try {
    state_.ledger = session_->measure_effects(
        [this](double share) {
          state_.measuring = share;
          frame(0.0);
        },
        [this] { return has_work(); });
  } catch (...) {
    state_.measuring.reset();
    throw;
  }
  state_.measuring.reset();
}

void ViewWindow::save() {
  if (wants_geometry(session_->settings())) session_->trace_geometry();
  RenderStatistics statistics;
  ImageFile image = read_film(stage_.device(), session_->film(), session_->settings(), statistics);
  statistics.stopped = !session_->is_complete();
  const std::uint64_t not_finite = statistics.non_finite_pixels;
  plan_.save({state_.save_path, std::move(image), std::move(statistics), session_->viewed(), words_,
              session_->settings(), state_.display.exposure_ev, stage_.device().description()});
  state_.message.clear();
  state_.notice = "Saved " + state_.save_path;
  if (!session_->is_complete()) {
    state_.notice += format_text(" with %.0f of %u samples", session_->state().samples_done, session_->settings().spp);
  }
  if (not_finite > 0) state_.notice += "; not finite: " + counted(not_finite, "pixel");
}

}  // namespace vernier
