#include "preview/camera_input.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <cmath>

#include "preview/imgui_input.h"

namespace vernier {
namespace {

constexpr double kPi = 3.14159265358979323846;
/// Of the distance to the target, per notch of the wheel.
constexpr double kZoomPerNotch = 0.88;
/// Distances to the target per second with a key held.
constexpr double kStepsPerSecond = 0.6;

double key(int code) {
  return is_held(code) ? 1.0 : 0.0;
}

std::optional<OrbitView> dragged(const OrbitView& view, float height) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseDelta.x == 0.0f && io.MouseDelta.y == 0.0f) return std::nullopt;
  const double right = io.MouseDelta.x / height;
  const double down = io.MouseDelta.y / height;
  // The way to the place where a button went down is none of the drag.
  for (const ImGuiMouseButton button : {ImGuiMouseButton_Left, ImGuiMouseButton_Right, ImGuiMouseButton_Middle}) {
    if (ImGui::IsMouseClicked(button)) return std::nullopt;
  }
  const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left);
  if (ImGui::IsMouseDown(ImGuiMouseButton_Middle) || (left && io.KeyShift)) return panned(view, -right, down);
  if (left) return orbited(view, right * kPi, down * kPi);
  if (ImGui::IsMouseDown(ImGuiMouseButton_Right)) return zoomed(view, std::exp2(down * 3.0));
  return std::nullopt;
}

std::optional<OrbitView> walked(const OrbitView& view) {
  const glm::dvec3 steps(key(GLFW_KEY_D) - key(GLFW_KEY_A), key(GLFW_KEY_E) - key(GLFW_KEY_Q),
                         key(GLFW_KEY_W) - key(GLFW_KEY_S));
  if (steps == glm::dvec3(0.0)) return std::nullopt;
  return moved(view, steps * (kStepsPerSecond * std::min(static_cast<double>(ImGui::GetIO().DeltaTime), 0.2)));
}

}  // namespace

std::optional<OrbitView> camera_input(const OrbitView& view, float picture_width, float picture_height) {
  const ImGuiIO& io = ImGui::GetIO();
  std::optional<OrbitView> out;
  if (!io.WantCaptureKeyboard) out = walked(view);
  if (io.WantCaptureMouse) return out;
  const OrbitView& so_far = out ? *out : view;
  // A drag that began in the picture goes on wherever the mouse is.
  if (const std::optional<OrbitView> drag = dragged(so_far, picture_height)) out = drag;
  if (io.MouseWheel != 0.0f && io.MousePos.x < picture_width) {
    out = zoomed(out ? *out : view, std::pow(kZoomPerNotch, io.MouseWheel));
  }
  return out;
}

}  // namespace vernier
