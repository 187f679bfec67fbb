#pragma once

#include <imgui.h>

#include <array>
#include <glm/glm.hpp>
#include <set>

namespace vernier {

/// Mouse and keys as somebody other than the window system has them.
struct ScriptedInput {
  glm::vec2 mouse = glm::vec2(-1.0f);  ///< pixels of the window
  std::array<bool, 3> buttons{};       ///< held, by ImGuiMouseButton
  float wheel = 0.0f;                  ///< notches since the frame before
  std::set<int> keys;                  ///< held, by GLFW's numbers: letters, digits, Escape, Enter
};

/// Tells Dear ImGui of `input` in place of what the window system said; before its frame begins.
void put_input(const ScriptedInput& input);

/// Whether the key with GLFW's number `code`, a letter, a digit, Escape or Enter, is held in this frame.
bool is_held(int code);
/// The same of a key that was not held in the frame before.
bool is_pressed(int code);

}  // namespace vernier
