#pragma once

#include <functional>
#include <glm/glm.hpp>

#include "gpu/buffer.h"
#include "image/image.h"
#include "preview/swapchain.h"

namespace vernier {

/// A picture on the device and where it goes.
struct ShownPicture {
  const Buffer* words = nullptr;          ///< R8G8B8A8 [size.y][size.x]; null: none
  glm::ivec2 size = glm::ivec2(0);        ///< pixels
  glm::ivec2 corner = glm::ivec2(0);      ///< of the window, upper left
  glm::ivec2 shown_size = glm::ivec2(0);  ///< pixels of the window that it fills
};

/// Puts pictures and what is drawn over them into a window. Owns swapchain, render pass and commands.
class Presenter {
 public:
  /// `surface` is that of the window; device and surface outlive it. `largest_picture` as
  /// for set_largest_picture.
  Presenter(const Device& device, vk::SurfaceKHR surface, glm::ivec2 window_size, glm::ivec2 largest_picture);
  ~Presenter();

  /// The pass that draws over the picture; for pipelines of who draws.
  vk::RenderPass render_pass() const { return *render_pass_; }
  /// Images of the swapchain; 0 while the window is minimised.
  std::uint32_t image_count() const { return swapchain_.image_count(); }
  /// Pictures may be as large as that from now on. Throws Error(usage) where the device has no image so long or high.
  void set_largest_picture(glm::ivec2 size);

  /// Shows `picture` in a window of `window_size` pixels, and what `draw_over` records. False when there was nothing to
  /// show it on: the window is minimised or its size just changed. Throws Error(device_lost).
  bool present(const ShownPicture& picture, glm::ivec2 window_size,
               const std::function<void(const vk::raii::CommandBuffer&)>& draw_over);

  /// What the next present shows, panels and all, is kept for taken_capture().
  void capture_next() { capture_wanted_ = true; }
  /// The window as it was captured, [height][width][3] display code values in [0, 1]; empty when nothing was.
  Image taken_capture();

 private:
  void make_swapchain(glm::ivec2 window_size);
  void record(const ShownPicture& picture, std::uint32_t index,
              const std::function<void(const vk::raii::CommandBuffer&)>& draw_over);
  void record_picture(const ShownPicture& picture, vk::Image target);
  void record_capture(vk::Image target);
  void submit(std::uint32_t index);

  const Device& device_;
  vk::SurfaceKHR surface_;
  vk::SurfaceFormatKHR format_;
  vk::raii::RenderPass render_pass_;
  Swapchain swapchain_;
  vk::raii::CommandPool pool_;
  vk::raii::CommandBuffer commands_{nullptr};
  vk::raii::Fence done_;
  vk::raii::Semaphore acquired_;
  vk::raii::DeviceMemory picture_memory_{nullptr};
  vk::raii::Image picture_{nullptr};
  bool out_of_date_ = false;
  bool capture_wanted_ = false;
  Buffer captured_;  // four bytes a pixel in the order of format_
  vk::Extent2D captured_extent_;
};

}  // namespace vernier
