#pragma once

#include <functional>
#include <vulkan/vulkan_raii.hpp>

#include "preview/presenter.h"
#include "preview/window.h"

namespace vernier {

/// Dear ImGui in a window: takes the window's events, draws over the picture. One at a time in a program. Owns its
/// context; window, instance, device and presenter outlive it.
class UserInterface {
 public:
  /// Begins in `window`, with text as large as its screen asks for.
  UserInterface(const Window& window, const VulkanInstance& instance, const Device& device, Presenter& presenter);
  ~UserInterface();
  UserInterface(const UserInterface&) = delete;
  UserInterface& operator=(const UserInterface&) = delete;

  /// Widgets may be called from here on, until end_frame. `put_input`: after the window's mouse and keys are in, and
  /// before widgets see them.
  void begin_frame(const std::function<void()>& put_input);
  /// No more widgets: record() draws what was called.
  void end_frame();
  /// Records the drawing of the last frame.
  void record(const vk::raii::CommandBuffer& commands) const;
  /// Size of text and widgets in proportion to a usual screen.
  float scale() const { return scale_; }

 private:
  vk::raii::DescriptorPool pool_{nullptr};
  float scale_ = 1.0f;
};

}  // namespace vernier
