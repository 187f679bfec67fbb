#include "preview/imgui_input.h"

#include <GLFW/glfw3.h>

#include <algorithm>

namespace vernier {

namespace {

// Dear ImGui's name of a key. Since 1.87 it has names of its own, and a queue for what happens to mouse and keys.
ImGuiKey key_of(int code) {
#if IMGUI_VERSION_NUM < 18700
  return code;
#else
  if (code >= GLFW_KEY_A && code <= GLFW_KEY_Z) return static_cast<ImGuiKey>(ImGuiKey_A + (code - GLFW_KEY_A));
  if (code >= GLFW_KEY_0 && code <= GLFW_KEY_9) return static_cast<ImGuiKey>(ImGuiKey_0 + (code - GLFW_KEY_0));
  if (code == GLFW_KEY_ESCAPE) return ImGuiKey_Escape;
  return code == GLFW_KEY_ENTER ? ImGuiKey_Enter : ImGuiKey_None;
#endif
}

}  // namespace

#if IMGUI_VERSION_NUM < 18700

void put_input(const ScriptedInput& input) {
  ImGuiIO& io = ImGui::GetIO();
  io.MousePos = {input.mouse.x, input.mouse.y};
  std::copy(input.buttons.begin(), input.buttons.end(), io.MouseDown);
  io.MouseWheel = input.wheel;
  std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
  for (const int key : input.keys) io.KeysDown[key] = true;
}

#else

void put_input(const ScriptedInput& input) {
  ImGuiIO& io = ImGui::GetIO();
  io.ConfigInputTrickleEventQueue = false;  // all of it belongs to this frame
  io.AddMousePosEvent(input.mouse.x, input.mouse.y);
  for (int button = 0; button < static_cast<int>(input.buttons.size()); ++button)
    io.AddMouseButtonEvent(button, input.buttons[button]);
  io.AddMouseWheelEvent(0.0f, input.wheel);
  for (int code = 0; code <= GLFW_KEY_LAST; ++code) {
    if (const ImGuiKey key = key_of(code); key != ImGuiKey_None) io.AddKeyEvent(key, input.keys.count(code) != 0);
  }
}

#endif

bool is_held(int code) {
  return ImGui::IsKeyDown(key_of(code));
}

bool is_pressed(int code) {
  return ImGui::IsKeyPressed(key_of(code), false);
}

}  // namespace vernier
