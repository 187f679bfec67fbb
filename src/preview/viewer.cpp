#include "preview/viewer.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <chrono>
#include <filesystem>
#include <optional>

#include "error.h"
#include "image/write_image.h"
#include "preview/camera_input.h"
#include "preview/panels.h"
#include "preview/presenter.h"
#include "preview/user_interface.h"
#include "render/pipeline_file.h"

namespace vernier {
namespace {

using Clock = std::chrono::steady_clock;

/// Between two frames while a picture is traced, which shares the processor with them on CPU devices.
constexpr double kFrameSeconds = 0.05;
/// Without input for that long the camera is at rest.
constexpr double kRestSeconds = 0.15;
/// While there is nothing to trace.
constexpr double kIdleWaitSeconds = 0.1;
constexpr int kPanelWidth = 330;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// `picture` as large as it fits into `room`, in its middle.
ShownPicture fitted(glm::ivec2 picture, glm::ivec2 room) {
  ShownPicture shown;
  shown.size = picture;
  const double factor = std::min(static_cast<double>(room.x) / picture.x, static_cast<double>(room.y) / picture.y);
  shown.shown_size = glm::max(glm::ivec2(glm::dvec2(picture) * factor + 0.5), glm::ivec2(1));
  shown.shown_size = glm::min(shown.shown_size, room);
  shown.corner = (room - shown.shown_size) / 2;
  return shown;
}

/// One window and what is in it.
class Viewer {
 public:
  explicit Viewer(const ViewPlan& plan)
      : plan_(plan),
        first_(plan.load_scene(plan.source, aspect(plan.settings))),
        window_("Vernier", {plan.settings.width + kPanelWidth, plan.settings.height}),
        instance_(false, window_.instance_extensions()),
        device_(open_device()),
        surface_(window_.make_surface(instance_)),
        presenter_(device_.device(), *surface_, window_.size_px(), {plan.settings.width, plan.settings.height}),
        interface_(window_, instance_, device_.device(), presenter_) {
    state_.settings = plan.settings;
    state_.display.exposure_ev = plan.exposure_ev;
    state_.device = device_.device().description().name;
    show(plan.source, std::move(first_));
  }

  void run() {
    while (!is_closing()) {
      apply();
      if (session_->is_finished()) {
        frame(kIdleWaitSeconds);
      } else {
        session_->trace([this] { return is_closing() || (seconds_since(last_frame_) > kFrameSeconds && frame(0.0)); });
        stale_ = true;
        frame(0.0);
      }
      if (seconds_since(last_move_) > kRestSeconds) session_->come_to_rest();
    }
    (void)device_.store();
  }

 private:
  static double aspect(const RenderSettings& settings) { return static_cast<double>(settings.width) / settings.height; }

  CachedDevice open_device() const {
    const DeviceDescription description = choose_device(list_devices(instance_), plan_.device);
    return CachedDevice(instance_, description, pipeline_file(description.pipeline_key),
                        {VK_KHR_SWAPCHAIN_EXTENSION_NAME});
  }

  bool is_closing() const { return window_.wants_to_close() || (plan_.interrupted && plan_.interrupted()); }

  /// Puts `viewed` in the place of the scene before; on failure that stays.
  void show(const std::string& source, ViewedScene viewed) {
    const WorldBounds bounds = world_bounds(viewed.scene);
    const Camera camera = viewed.camera;
    auto session = std::make_unique<ViewSession>(device_.device(), std::move(viewed), state_.settings);
    display_.reset();
    session_ = std::move(session);
    display_ = std::make_unique<FilmDisplay>(device_.device(), session_->film());
    bounds_ = bounds;
    view_ = orbit_view(camera, bounds);
    state_.source = source.empty() ? "the built-in scene" : source;
    state_.display.far_depth_m = static_cast<float>(glm::length(view_.target - glm::dvec3(camera.world_from_camera[3])));
    window_.set_title("Vernier: " + (source.empty() ? "built-in scene" : std::filesystem::path(source).filename().string()));
    last_move_ = Clock::now();
    stale_ = true;
  }

  /// One frame: what the user did, the panels, the picture. True when what is being traced is out of date.
  bool frame(double wait_s) {
    window_.take_events(wait_s);
    last_frame_ = Clock::now();
    for (const std::string& path : window_.take_drops()) {
      state_.open_path = path;
      actions_.open = true;
    }
    interface_.begin_frame();
    const glm::ivec2 size = window_.size_px();
    const float panel = kPanelWidth * interface_.scale();
    note(draw_panels(*session_, state_, panel));
    const glm::ivec2 room(std::max(size.x - static_cast<int>(panel), 1), std::max(size.y, 1));
    take_input(room);
    interface_.end_frame();
    draw_film();
    if (size.x > 0 && size.y > 0) {
      ShownPicture picture = fitted(shown_size_, room);
      picture.words = shown_size_.x > 0 ? &display_->words() : nullptr;
      presenter_.present(picture, size, [this](const vk::raii::CommandBuffer& commands) { interface_.record(commands); });
    }
    return wanted_view_ || actions_.settings || actions_.open || actions_.frame_all || actions_.camera || is_closing();
  }

  void note(const PanelActions& now) {
    if (now.settings) actions_.settings = now.settings;
    if (now.camera) actions_.camera = now.camera;
    actions_.frame_all |= now.frame_all;
    actions_.open |= now.open;
    actions_.save |= now.save;
    stale_ |= now.layer_changed;
  }

  void take_input(glm::ivec2 room) {
    if (const auto view = camera_input(wanted_view_.value_or(view_), static_cast<float>(room.x),
                                       static_cast<float>(room.y))) {
      wanted_view_ = view;
    }
    if (ImGui::GetIO().WantCaptureKeyboard) return;
    if (ImGui::IsKeyPressed(GLFW_KEY_F, false)) actions_.frame_all = true;
    for (int digit = 0; digit < 9; ++digit) {
      if (ImGui::IsKeyPressed(GLFW_KEY_1 + digit, false)) actions_.camera = static_cast<std::size_t>(digit);
    }
  }

  /// Does what was asked for, between two traces.
  void apply() {
    const PanelActions actions = std::exchange(actions_, {});
    const std::optional<OrbitView> view = std::exchange(wanted_view_, std::nullopt);
    try {
      if (actions.open) show(state_.open_path, plan_.load_scene(state_.open_path, aspect(state_.settings)));
      if (actions.settings) set_settings(*actions.settings);
      if (view) look(*view);
      const std::vector<Camera>& cameras = session_->scene().cameras;
      if (actions.camera && *actions.camera < cameras.size()) look(orbit_view(cameras[*actions.camera], bounds_));
      if (actions.frame_all) {
        const Camera framed = frame_camera(bounds_, view_.camera.vertical_fov, aspect(state_.settings));
        look(orbit_view(framed, bounds_));
      }
      if (actions.save) save();
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::device_lost) throw;
      state_.message = error.what();
      state_.settings = session_->settings();
    }
  }

  void look(const OrbitView& view) {
    view_ = view;
    session_->set_camera(view.camera, true);
    last_move_ = Clock::now();
  }

  void set_settings(const RenderSettings& settings) {
    display_.reset();
    session_->set_settings(settings);
    display_ = std::make_unique<FilmDisplay>(device_.device(), session_->film());
    shown_size_ = glm::ivec2(0);
    stale_ = true;
  }

  /// The film's picture into words, where it has changed and is one.
  void draw_film() {
    const bool tracing = !session_->is_finished();
    if (!session_->is_whole() || !(stale_ || tracing)) return;
    display_->draw(session_->picture_size(), state_.display);
    shown_size_ = session_->picture_size();
    stale_ = false;
  }

  void save() {
    const Film& film = session_->film();
    const PixelRect& area = film.area();
    DevelopedFilm developed = develop(film.read_sums(device_.device()), area);
    const ImageFile image{.width = area.width,
                          .height = area.height,
                          .x = 0,
                          .y = 0,
                          .full_width = area.width,
                          .full_height = area.height,
                          .layers = {Layer{"", {"R", "G", "B", "A"}, std::move(developed.color)}},
                          .metadata = {}};
    write_image(state_.save_path, image, {state_.display.exposure_ev});
  }

  const ViewPlan& plan_;
  ViewedScene first_;
  Window window_;
  VulkanInstance instance_;
  CachedDevice device_;
  vk::raii::SurfaceKHR surface_;
  Presenter presenter_;
  UserInterface interface_;
  std::unique_ptr<ViewSession> session_;
  std::unique_ptr<FilmDisplay> display_;
  PanelState state_;
  PanelActions actions_;
  WorldBounds bounds_{};
  OrbitView view_;
  std::optional<OrbitView> wanted_view_;
  glm::ivec2 shown_size_ = glm::ivec2(0);
  bool stale_ = true;
  Clock::time_point last_frame_, last_move_;
};

}  // namespace

void view_scene(const ViewPlan& plan) {
  Viewer(plan).run();
}

}  // namespace vernier
