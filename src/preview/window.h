#pragma once

#include <chrono>
#include <glm/glm.hpp>
#include <string>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "gpu/instance.h"

struct GLFWwindow;

namespace vernier {

/// The window system, and one window. Owns both; one at a time in a program. Not movable: callbacks point here.
class Window {
 public:
  /// Makes a window, not yet to be seen, whose inside measures `size` screen coordinates, times what the desktop says
  /// of its density (2 for 192 dots per inch), or less where the screen is smaller. Throws Error(failed) without a
  /// display.
  Window(const std::string& title, glm::ivec2 size);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Instance extensions that surfaces need. Throws Error(no_device) where the Vulkan loader is not found.
  std::vector<const char*> instance_extensions() const;
  /// The surface to draw on. Throws Error(no_device).
  vk::raii::SurfaceKHR make_surface(const VulkanInstance& instance) const;

  /// Takes what the user did; waits for something up to `wait_s` seconds.
  void take_events(double wait_s);
  /// The user closed it, or close() did.
  bool wants_to_close() const;
  /// From now on wants_to_close().
  void close();
  /// Pixels inside; 0 while minimised.
  glm::ivec2 size_px() const;
  /// Opens it, if it is not open.
  void show();
  /// When it was opened.
  std::chrono::steady_clock::time_point opened() const { return opened_; }
  /// Asks for `size` pixels inside.
  void set_size(glm::ivec2 size);
  /// Above the window.
  void set_title(const std::string& title);
  /// Files dropped since the last call.
  std::vector<std::string> take_drops();
  /// For who draws over the picture.
  GLFWwindow* handle() const { return window_; }

 private:
  GLFWwindow* window_ = nullptr;
  std::vector<std::string> drops_;
  std::chrono::steady_clock::time_point opened_{};
};

}  // namespace vernier
