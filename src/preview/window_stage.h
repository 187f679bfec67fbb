#pragma once

#include <memory>
#include <string>

#include "preview/presenter.h"
#include "preview/user_interface.h"
#include "preview/window.h"
#include "render/pipeline_file.h"

namespace vernier {

/// A device that draws into a window, and the panels over it. Owns all from the instance on; the window outlives it.
class WindowStage {
 public:
  /// Opens the device that `selector` means (choose_device). Throws Error(no_device).
  WindowStage(Window& window, const std::string& selector, glm::ivec2 largest_picture);

  /// What traces and draws.
  const Device& device() const { return device_.device(); }
  Presenter& presenter() { return presenter_; }
  UserInterface& interface() { return interface_; }
  /// Keeps what was compiled for the next time.
  void store() const { (void)device_.store(); }
  /// Of the validation layer; empty without it.
  std::vector<std::string> validation_messages() const { return instance_.validation_messages(); }

 private:
  VulkanInstance instance_;
  CachedDevice device_;
  vk::raii::SurfaceKHR surface_;
  Presenter presenter_;
  UserInterface interface_;
};

}  // namespace vernier
