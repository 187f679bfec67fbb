#include "preview/swapchain.h"

#include <algorithm>

#include "error.h"
#include "gpu/vk_check.h"

namespace vernier {
namespace {

vk::Extent2D chosen_extent(const vk::SurfaceCapabilitiesKHR& can, vk::Extent2D wanted) {
  constexpr std::uint32_t kWindowFollows = 0xffffffffu;
  if (can.currentExtent.width != kWindowFollows) return can.currentExtent;
  return {std::clamp(wanted.width, can.minImageExtent.width, can.maxImageExtent.width),
          std::clamp(wanted.height, can.minImageExtent.height, can.maxImageExtent.height)};
}

std::uint32_t chosen_image_count(const vk::SurfaceCapabilitiesKHR& can) {
  const std::uint32_t wanted = can.minImageCount + 1;
  return can.maxImageCount > 0 ? std::min(wanted, can.maxImageCount) : wanted;
}

/// A window that nobody sees must not keep the program waiting, as first in, first out may.
vk::PresentModeKHR chosen_mode(const Device& device, vk::SurfaceKHR surface) {
  const std::vector<vk::PresentModeKHR> modes = device.physical().getSurfacePresentModesKHR(surface);
  const bool mailbox = std::ranges::find(modes, vk::PresentModeKHR::eMailbox) != modes.end();
  return mailbox ? vk::PresentModeKHR::eMailbox : vk::PresentModeKHR::eFifo;
}

/// The window is opaque; where the system does not let us say so, what it does with alpha is its own.
vk::CompositeAlphaFlagBitsKHR chosen_alpha(const vk::SurfaceCapabilitiesKHR& can) {
  using Alpha = vk::CompositeAlphaFlagBitsKHR;
  for (const Alpha alpha : {Alpha::eOpaque, Alpha::eInherit, Alpha::ePreMultiplied}) {
    if (can.supportedCompositeAlpha & alpha) return alpha;
  }
  return Alpha::ePostMultiplied;
}

}  // namespace

Swapchain::Swapchain(const Device& device, vk::SurfaceKHR surface, vk::SurfaceFormatKHR format,
                     vk::RenderPass render_pass, vk::Extent2D wanted, vk::SwapchainKHR old) {
  vk_check("making the window's images", [&] {
    const vk::SurfaceCapabilitiesKHR can = device.physical().getSurfaceCapabilitiesKHR(surface);
    extent_ = chosen_extent(can, wanted);
    if (extent_.width == 0 || extent_.height == 0) return;
    vk::ImageUsageFlags usage = vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eTransferDst;
    // For screenshots, where that is possible.
    usage |= can.supportedUsageFlags & vk::ImageUsageFlagBits::eTransferSrc;
    can_be_read_ = static_cast<bool>(usage & vk::ImageUsageFlagBits::eTransferSrc);
    const vk::SwapchainCreateInfoKHR create({}, surface, chosen_image_count(can), format.format, format.colorSpace,
                                            extent_, 1, usage, vk::SharingMode::eExclusive, {}, can.currentTransform,
                                            chosen_alpha(can), chosen_mode(device, surface), VK_TRUE, old);
    swapchain_ = vk::raii::SwapchainKHR(device.vk(), create);
    for (const VkImage image : swapchain_.getImages()) images_.emplace_back(image);
    const vk::ImageSubresourceRange whole(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);
    for (const vk::Image image : images_) {
      views_.emplace_back(device.vk(),
                          vk::ImageViewCreateInfo({}, image, vk::ImageViewType::e2D, format.format, {}, whole));
      const vk::ImageView view = *views_.back();
      framebuffers_.emplace_back(device.vk(),
                                 vk::FramebufferCreateInfo({}, render_pass, view, extent_.width, extent_.height, 1));
      drawn_.emplace_back(device.vk(), vk::SemaphoreCreateInfo());
    }
  });
}

vk::SurfaceFormatKHR choose_surface_format(const Device& device, vk::SurfaceKHR surface) {
  const std::uint32_t family = device.queue_family();
  const vk::QueueFlags can = device.physical().getQueueFamilyProperties()[family].queueFlags;
  const bool presents = (can & vk::QueueFlagBits::eGraphics) && device.physical().getSurfaceSupportKHR(family, surface);
  // Pictures are copied into the window's images.
  if (!presents || !(device.physical().getSurfaceCapabilitiesKHR(surface).supportedUsageFlags &
                     vk::ImageUsageFlagBits::eTransferDst)) {
    throw Error(ErrorKind::no_device, "device " + std::to_string(device.description().index) + " (" +
                                          device.description().name + ") cannot draw into a window here");
  }
  const std::vector<vk::SurfaceFormatKHR> formats = device.physical().getSurfaceFormatsKHR(surface);
  for (const vk::Format wanted : {vk::Format::eB8G8R8A8Unorm, vk::Format::eR8G8B8A8Unorm}) {
    const auto found = std::ranges::find(formats, wanted, &vk::SurfaceFormatKHR::format);
    if (found != formats.end()) return *found;
  }
  return formats.front();
}

}  // namespace vernier
