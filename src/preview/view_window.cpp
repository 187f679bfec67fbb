#include "preview/view_window.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "error.h"
#include "preview/camera_input.h"
#include "preview/imgui_input.h"
#include "preview/screenshot.h"

namespace vernier {
namespace {

/// `picture` as large as it fits into `room`, in its middle.
ShownPicture fitted(glm::ivec2 picture, glm::ivec2 full, glm::ivec2 room) {
  ShownPicture shown;
  shown.size = picture;
  // The aspect is the full picture's: that of a coarse one is rounded to whole pixels.
  const double factor = std::min(static_cast<double>(room.x) / full.x, static_cast<double>(room.y) / full.y);
  shown.shown_size = glm::clamp(glm::ivec2(glm::round(glm::dvec2(full) * factor)), glm::ivec2(1), room);
  shown.corner = (room - shown.shown_size) / 2;
  return shown;
}

}  // namespace

/// Takes what the window system has, draws panels and picture. True when what is being traced is to be left for it.
bool ViewWindow::frame(double wait_s) {
  const Clock::time_point look = Clock::now();
  window_.take_events(wait_s);
  // What wakes the window has just come; what was there at once may have come since the last look.
  earliest_input_ = Clock::now() - look > std::chrono::milliseconds(1) ? Clock::now() : last_frame_;
  last_frame_ = Clock::now();
  for (const std::string& path : window_.take_drops()) actions_.open = path;
  take_loaded();
  if (replay_) replay();
  stage_.interface().begin_frame([this] {
    if (replay_) put_input(replay_->next_input());
  });
  const float panel = static_cast<float>(kPanelWidth) * stage_.interface().scale();
  const glm::ivec2 size = window_.size_px();
  const glm::ivec2 room = glm::max(size - glm::ivec2(static_cast<int>(panel), 0), glm::ivec2(1));
  note(draw_panels(*session_, state_, panel));
  take_input(room);
  stage_.interface().end_frame();
  write_places();
  draw_film();
  if (size.x > 0 && size.y > 0) present(size, room);
  return has_work();
}

void ViewWindow::present(glm::ivec2 size, glm::ivec2 room) {
  const RenderSettings& settings = session_->settings();
  ShownPicture picture = fitted(shown_size_, {settings.width, settings.height}, room);
  if (shown_size_.x > 0) picture.words = &display_->words();
  inspect(picture);
  if (shot_) stage_.presenter().capture_next();
  const bool shown = stage_.presenter().present(
      picture, size, [this](const vk::raii::CommandBuffer& commands) { stage_.interface().record(commands); });
  if (shown && picture.words != nullptr) latency_.picture(!wanted_view_ && session_->is_whole());
  if (shown && shot_) write_shot();
}

bool ViewWindow::has_work() const {
  return wanted_view_ || lose_device_ || actions_.settings || actions_.camera || actions_.open || actions_.frame_all ||
         actions_.render || actions_.stop || actions_.save || actions_.measure || actions_.loaded || is_closing();
}

void ViewWindow::note(const PanelActions& now) {
  if (now.settings) actions_.settings = now.settings;
  if (now.camera) actions_.camera = now.camera;
  if (now.open) actions_.open = now.open;
  actions_.frame_all |= now.frame_all;
  actions_.render |= now.render;
  actions_.stop |= now.stop;
  actions_.save |= now.save;
  actions_.measure |= now.measure;
}

void ViewWindow::take_input(glm::ivec2 room) {
  if (is_pressed(GLFW_KEY_ESCAPE)) actions_.stop = true;
  // A drag may begin and end within one step of a measurement: what is seen of it then is that a button went down.
  const bool pressed = ImGui::IsMouseClicked(ImGuiMouseButton_Left) || ImGui::IsMouseClicked(ImGuiMouseButton_Right) ||
                       ImGui::IsMouseClicked(ImGuiMouseButton_Middle);
  if (state_.measuring && pressed && !ImGui::GetIO().WantCaptureMouse) actions_.stop = true;
  // A picture that is being rendered is not thrown away by a slip of the mouse: Stop comes first.
  if (session_->state().rendering) return;
  const OrbitView& so_far = wanted_view_ ? *wanted_view_ : view_;
  if (const auto view = camera_input(so_far, static_cast<float>(room.x), static_cast<float>(room.y))) {
    latency_.input(earliest_input_);
    wanted_view_ = view;
  }
  if (!ImGui::GetIO().WantTextInput) take_keys();
}

void ViewWindow::take_keys() {
  if (is_pressed(GLFW_KEY_F)) actions_.frame_all = true;
  if (is_pressed(GLFW_KEY_R)) actions_.render = true;
  if (is_pressed(GLFW_KEY_O)) state_.browser.open();
  for (int digit = 0; digit < 9; ++digit) {
    if (is_pressed(GLFW_KEY_1 + digit)) actions_.camera = static_cast<std::size_t>(digit);
  }
}

/// Whether nothing is left to trace, to read or to show.
bool ViewWindow::settled() const {
  return session_->is_finished() && !stale_ && !loading_.valid() && !state_.measuring && !has_work();
}

/// The script's event of this frame.
void ViewWindow::replay() {
  const ReplayRequest request = replay_->step(settled(), state_);
  note(request.actions);
  if (request.drop) actions_.open = request.drop;
  if (request.window_size) window_.set_size(*request.window_size);
  if (request.shot) shot_ = request.shot;
  if (request.close) window_.close();
  lose_device_ |= request.lose_device;
}

/// The film's picture into words, where it has changed and is one.
void ViewWindow::draw_film() {
  stale_ |= shown_ != state_.display || !session_->is_finished();
  if (!stale_ || !session_->is_whole()) return;
  const std::uint32_t layer = state_.display.layer;
  if (layer != DISPLAY_COLOR && layer != DISPLAY_RAYS) session_->trace_geometry();
  display_->draw(session_->picture_size(), state_.display);
  shown_size_ = session_->picture_size();
  shown_ = state_.display;
  inspected_ = glm::ivec2(-1);
  stale_ = false;
}

/// What lies under the mouse, anew when the mouse or the picture has changed.
void ViewWindow::inspect(const ShownPicture& shown) {
  const ImGuiIO& io = ImGui::GetIO();
  const RenderSettings& settings = session_->settings();
  const glm::vec2 mouse(io.MousePos.x, io.MousePos.y);
  const glm::vec2 along = (mouse - glm::vec2(shown.corner)) / glm::vec2(shown.shown_size);
  const bool inside = along.x >= 0.0f && along.y >= 0.0f && along.x < 1.0f && along.y < 1.0f;
  if (!inside || io.WantCaptureMouse || ImGui::IsAnyMouseDown()) {
    if (!inside) state_.pixel.reset();
    return;
  }
  const glm::ivec2 pixel(along * glm::vec2(settings.width, settings.height));
  if (pixel == inspected_) return;
  state_.pixel = session_->pixel(pixel.x, pixel.y);
  state_.pixel_place = pixel;
  inspected_ = state_.pixel ? pixel : glm::ivec2(-1);
}

void ViewWindow::write_shot() {
  const Image picture = stage_.presenter().taken_capture();
  if (picture.values.empty()) throw Error(ErrorKind::failed, "--record: this window cannot be read");
  const bool has_extension = std::filesystem::path(*shot_).has_extension();
  write_screenshot(plan_.record_folder + "/" + *shot_ + (has_extension ? "" : ".png"), picture);
  shot_.reset();
}

void ViewWindow::write_places() const {
  if (plan_.places_file.empty()) return;
  std::string text = places_json(state_.places, *session_, settled(), state_.message);
  if (text == places_text_) return;
  places_text_ = std::move(text);
  write_text(plan_.places_file, places_text_);
}

}  // namespace vernier
