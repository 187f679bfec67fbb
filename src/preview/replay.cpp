#include "preview/replay.h"

#include <imgui.h>

#include <utility>

#include "error.h"
#include "preview/script_values.h"

namespace vernier {
namespace {

std::size_t button_of(const std::string& name) {
  return name == "left" ? ImGuiMouseButton_Left : name == "right" ? ImGuiMouseButton_Right : ImGuiMouseButton_Middle;
}

/// Frames of a click or a key: it is seen down in one at least, and up in one.
constexpr int kClickFrames = 3;

}  // namespace

Replay::Replay(std::vector<ScriptEvent> events) : events_(std::move(events)) {}

bool Replay::is_due(const ScriptEvent& event, bool settled) {
  if (event.verb == "settle") return settled;
  if (event.verb != "wait") return true;
  const auto now = std::chrono::steady_clock::now();
  if (!waiting_since_) waiting_since_ = now;
  if (std::chrono::duration<double>(now - *waiting_since_).count() < event.numbers[0]) return false;
  waiting_since_.reset();
  return true;
}

void Replay::click(const ScriptEvent& event, const WidgetPlaces& places) {
  const auto found = places.find(event.words[0]);
  if (found == places.end()) {
    throw Error(ErrorKind::usage,
                "script, line " + std::to_string(event.line) + ": no `" + event.words[0] + "` is in sight");
  }
  const ImVec4& place = found->second;
  input_.mouse = {place.x + place.z * 0.5f, place.y + place.w * 0.5f};
  click_frames_ = kClickFrames;
}

void Replay::point(const ScriptEvent& event) {
  if (event.verb == "move") input_.mouse = {event.numbers[0], event.numbers[1]};
  if (event.verb == "press") input_.buttons[button_of(event.words[0])] = true;
  if (event.verb == "release") input_.buttons[button_of(event.words[0])] = false;
  if (event.verb == "wheel") input_.wheel = static_cast<float>(event.numbers[0]);
  if (event.verb == "hold") input_.keys.insert(key_code(event.words[0]));
  if (event.verb == "let") input_.keys.erase(key_code(event.words[0]));
  if (event.verb == "key") {
    pressed_key_ = key_code(event.words[0]);
    key_frames_ = kClickFrames;
  }
}

ReplayRequest Replay::perform(const ScriptEvent& event, PanelState& state) {
  ReplayRequest request;
  if (event.verb == "click") click(event, state.places);
  if (event.verb == "size") request.window_size = glm::ivec2(event.numbers[0], event.numbers[1]);
  if (event.verb == "drop") request.drop = event.words[0];
  if (event.verb == "open") request.actions.open = event.words[0];
  if (event.verb == "set") set_by_script(event, state, request.actions);
  if (event.verb == "shot") request.shot = event.words[0];
  request.close = event.verb == "close";
  request.lose_device = event.verb == "lose-device";
  point(event);
  return request;
}

ReplayRequest Replay::step(bool settled, PanelState& state) {
  input_.wheel = 0.0f;
  if (click_frames_ > 0 || key_frames_ > 0) return {};  // still under way
  ReplayRequest request;
  if (next_ == events_.size()) {
    request.close = true;
    return request;
  }
  const ScriptEvent& event = events_[next_];
  if (!is_due(event, settled)) return request;
  ++next_;
  return perform(event, state);
}

std::vector<ScriptEvent> Replay::events_left() const {
  return {events_.begin() + static_cast<std::ptrdiff_t>(next_), events_.end()};
}

ScriptedInput Replay::next_input() {
  ScriptedInput input = input_;
  if (click_frames_ > 0) input.buttons[ImGuiMouseButton_Left] = --click_frames_ == 1;
  if (key_frames_ > 0) input.keys.erase(pressed_key_);
  if (key_frames_ > 0 && --key_frames_ == 1) input.keys.insert(pressed_key_);
  return input;
}

}  // namespace vernier
