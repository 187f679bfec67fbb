#pragma once

#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "gpu/device.h"

namespace vernier {

/// The images of a window. Owns them, their views, framebuffers and semaphores.
class Swapchain {
 public:
  Swapchain() = default;
  /// For `surface`, as large as the window or, where the window does not say, as `wanted`. `render_pass` draws onto its
  /// images. `old`: what it replaces, which may be empty. Throws Error(failed).
  Swapchain(const Device& device, vk::SurfaceKHR surface, vk::SurfaceFormatKHR format, vk::RenderPass render_pass,
            vk::Extent2D wanted, vk::SwapchainKHR old);

  /// Pixels. Empty for a window that is minimised: there is nothing to show.
  vk::Extent2D extent() const { return extent_; }
  const vk::raii::SwapchainKHR& vk() const { return swapchain_; }
  /// How many there are.
  std::uint32_t image_count() const { return static_cast<std::uint32_t>(images_.size()); }
  /// Whether images can be copied from.
  bool can_be_read() const { return can_be_read_; }
  /// Image `index`, below image_count().
  vk::Image image(std::uint32_t index) const { return images_[index]; }
  /// To draw onto image `index`.
  vk::Framebuffer framebuffer(std::uint32_t index) const { return *framebuffers_[index]; }
  /// Signalled when image `index` has been drawn.
  vk::Semaphore drawn(std::uint32_t index) const { return *drawn_[index]; }

 private:
  vk::Extent2D extent_;
  bool can_be_read_ = false;
  vk::raii::SwapchainKHR swapchain_{nullptr};
  std::vector<vk::Image> images_;
  std::vector<vk::raii::ImageView> views_;
  std::vector<vk::raii::Framebuffer> framebuffers_;
  std::vector<vk::raii::Semaphore> drawn_;
};

/// Eight bits a channel without a curve of its own, which shaders apply; else whatever comes first.
/// Throws Error(no_device) where `device` cannot draw into a window.
vk::SurfaceFormatKHR choose_surface_format(const Device& device, vk::SurfaceKHR surface);

}  // namespace vernier
