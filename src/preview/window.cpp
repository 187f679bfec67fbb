#include "preview/window.h"

#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "error.h"

namespace vernier {
namespace {

/// What GLFW says of its last failure.
std::string last_failure() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text != nullptr ? text : "unknown reason";
}

void receive_drops(GLFWwindow* window, int count, const char** paths) {
  auto* drops = static_cast<std::vector<std::string>*>(glfwGetWindowUserPointer(window));
  drops->insert(drops->end(), paths, paths + count);
}

/// `size`, or less where the screen is smaller once GLFW has made it larger by what the desktop says of its density.
glm::ivec2 at_most_the_screen(glm::ivec2 size) {
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  if (monitor == nullptr) return size;
  glm::ivec2 corner, screen;
  glfwGetMonitorWorkarea(monitor, &corner.x, &corner.y, &screen.x, &screen.y);
  glm::vec2 scale(1.0f);
  glfwGetMonitorContentScale(monitor, &scale.x, &scale.y);
  const glm::ivec2 room(glm::vec2(screen) / glm::max(scale, glm::vec2(1.0f)));
  return room.x > 0 && room.y > 0 ? glm::min(size, room) : size;
}

}  // namespace

Window::Window(const std::string& title, glm::ivec2 size) {
  const auto is_set = [](const char* name) { return std::getenv(name) != nullptr && *std::getenv(name) != '\0'; };
  // Asked beforehand, since libraries of Wayland say more than one line about it.
  if (!is_set("DISPLAY") && !is_set("WAYLAND_DISPLAY"))
    throw Error(ErrorKind::failed, "no window can be opened: neither DISPLAY nor WAYLAND_DISPLAY names a screen");
#ifdef GLFW_PLATFORM  // since 3.4 it looks for Wayland first
  if (!is_set("WAYLAND_DISPLAY")) glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
  if (glfwInit() != GLFW_TRUE) throw Error(ErrorKind::failed, "no window can be opened: " + last_failure());
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  const glm::ivec2 fitting = at_most_the_screen(size);
  window_ = glfwCreateWindow(fitting.x, fitting.y, title.c_str(), nullptr, nullptr);
  if (window_ == nullptr) {
    const std::string reason = last_failure();
    glfwTerminate();
    throw Error(ErrorKind::failed, "no window can be opened: " + reason);
  }
  glfwSetWindowUserPointer(window_, &drops_);
  glfwSetDropCallback(window_, receive_drops);
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

std::vector<const char*> Window::instance_extensions() const {
  std::uint32_t count = 0;
  const char** names = glfwGetRequiredInstanceExtensions(&count);
  if (names == nullptr) throw Error(ErrorKind::no_device, "Vulkan cannot draw into windows here: " + last_failure());
  return {names, names + count};
}

vk::raii::SurfaceKHR Window::make_surface(const VulkanInstance& instance) const {
  VkSurfaceKHR surface = VK_NULL_HANDLE;
  if (glfwCreateWindowSurface(*instance.vk(), window_, nullptr, &surface) != VK_SUCCESS) {
    throw Error(ErrorKind::no_device, "Vulkan cannot draw into the window: " + last_failure());
  }
  return vk::raii::SurfaceKHR(instance.vk(), surface);
}

void Window::take_events(double wait_s) {
  if (wait_s > 0.0) {
    glfwWaitEventsTimeout(wait_s);
  } else {
    glfwPollEvents();
  }
}

bool Window::wants_to_close() const {
  return glfwWindowShouldClose(window_) == GLFW_TRUE;
}

void Window::close() {
  glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

glm::ivec2 Window::size_px() const {
  glm::ivec2 size;
  glfwGetFramebufferSize(window_, &size.x, &size.y);
  return size;
}

void Window::set_size(glm::ivec2 size) {
  float scale_x = 1.0f, scale_y = 1.0f;
  glm::ivec2 inside;
  glfwGetWindowSize(window_, &inside.x, &inside.y);
  const glm::ivec2 pixels = size_px();
  if (inside.x > 0 && inside.y > 0) {
    scale_x = static_cast<float>(pixels.x) / static_cast<float>(inside.x);
    scale_y = static_cast<float>(pixels.y) / static_cast<float>(inside.y);
  }
  glfwSetWindowSize(window_, static_cast<int>(static_cast<float>(size.x) / scale_x),
                    static_cast<int>(static_cast<float>(size.y) / scale_y));
}

void Window::show() {
  if (opened_ != std::chrono::steady_clock::time_point{}) return;
  glfwShowWindow(window_);
  opened_ = std::chrono::steady_clock::now();
}

void Window::set_title(const std::string& title) {
  glfwSetWindowTitle(window_, title.c_str());
}

std::vector<std::string> Window::take_drops() {
  return std::exchange(drops_, {});
}

}  // namespace vernier
