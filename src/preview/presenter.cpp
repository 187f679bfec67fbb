#include "preview/presenter.h"

#include <algorithm>
#include <array>
#include <utility>

#include "error.h"
#include "gpu/vk_check.h"

namespace vernier {
namespace {

constexpr vk::Format kPictureFormat = vk::Format::eR8G8B8A8Unorm;
const vk::ImageSubresourceRange kWhole(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);
const vk::ImageSubresourceLayers kLayer(vk::ImageAspectFlagBits::eColor, 0, 0, 1);
/// Around the picture: dark, so that it does not dazzle beside it.
constexpr float kSurround = 0.11f;

vk::raii::RenderPass make_render_pass(const Device& device, vk::Format format) {
  const vk::AttachmentDescription image({}, format, vk::SampleCountFlagBits::e1, vk::AttachmentLoadOp::eLoad,
                                        vk::AttachmentStoreOp::eStore, vk::AttachmentLoadOp::eDontCare,
                                        vk::AttachmentStoreOp::eDontCare, vk::ImageLayout::eColorAttachmentOptimal,
                                        vk::ImageLayout::ePresentSrcKHR);
  const vk::AttachmentReference reference(0, vk::ImageLayout::eColorAttachmentOptimal);
  vk::SubpassDescription subpass;
  subpass.setColorAttachments(reference);
  return vk::raii::RenderPass(device.vk(), vk::RenderPassCreateInfo({}, image, subpass));
}

struct Transition {
  vk::ImageLayout from, to;
  vk::AccessFlags before, after;
  vk::PipelineStageFlags stage_before, stage_after;
};

void transition(const vk::raii::CommandBuffer& commands, vk::Image image, const Transition& change) {
  const vk::ImageMemoryBarrier barrier(change.before, change.after, change.from, change.to, VK_QUEUE_FAMILY_IGNORED,
                                       VK_QUEUE_FAMILY_IGNORED, image, kWhole);
  commands.pipelineBarrier(change.stage_before, change.stage_after, {}, {}, {}, barrier);
}

constexpr auto kTransfer = vk::PipelineStageFlagBits::eTransfer;
constexpr auto kWrite = vk::AccessFlagBits::eTransferWrite;
constexpr auto kRead = vk::AccessFlagBits::eTransferRead;

std::array<vk::Offset3D, 2> corners(glm::ivec2 first, glm::ivec2 size) {
  return {vk::Offset3D(first.x, first.y, 0), vk::Offset3D(first.x + size.x, first.y + size.y, 1)};
}

}  // namespace

Presenter::Presenter(const Device& device, vk::SurfaceKHR surface, glm::ivec2 window_size, glm::ivec2 largest_picture)
    : device_(device),
      surface_(surface),
      format_(choose_surface_format(device, surface)),
      render_pass_(make_render_pass(device, format_.format)),
      pool_(device.vk(),
            vk::CommandPoolCreateInfo(vk::CommandPoolCreateFlagBits::eResetCommandBuffer, device.queue_family())),
      done_(device.vk(), vk::FenceCreateInfo()),
      acquired_(device.vk(), vk::SemaphoreCreateInfo()) {
  commands_ = std::move(
      vk::raii::CommandBuffers(device.vk(), vk::CommandBufferAllocateInfo(*pool_, vk::CommandBufferLevel::ePrimary, 1))
          .front());
  set_largest_picture(largest_picture);
  make_swapchain(window_size);
}

Presenter::~Presenter() {
  try {
    device_.queue().waitIdle();
  } catch (const vk::SystemError&) {
    // A lost device has nothing to wait for.
  }
}

void Presenter::set_largest_picture(glm::ivec2 size) {
  const std::uint32_t most = device_.physical().getProperties().limits.maxImageDimension2D;
  if (static_cast<std::uint32_t>(std::max(size.x, size.y)) > most) {
    throw Error(ErrorKind::usage, "--size: at most " + std::to_string(most) + " pixels a side on this device");
  }
  vk_check("making room for the picture", [&] {
    device_.queue().waitIdle();
    const vk::Extent3D extent(static_cast<std::uint32_t>(size.x), static_cast<std::uint32_t>(size.y), 1);
    const vk::ImageUsageFlags usage = vk::ImageUsageFlagBits::eTransferDst | vk::ImageUsageFlagBits::eTransferSrc;
    picture_ = vk::raii::Image(device_.vk(),
                               vk::ImageCreateInfo({}, vk::ImageType::e2D, kPictureFormat, extent, 1, 1,
                                                   vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal, usage));
    const vk::MemoryRequirements needs = picture_.getMemoryRequirements();
    picture_memory_ = vk::raii::DeviceMemory(
        device_.vk(), vk::MemoryAllocateInfo(needs.size, memory_type_for(device_, needs.memoryTypeBits, false)));
    picture_.bindMemory(*picture_memory_, 0);
  });
}

void Presenter::make_swapchain(glm::ivec2 window_size) {
  vk_check("resizing the window", [&] { device_.queue().waitIdle(); });
  const vk::Extent2D wanted(static_cast<std::uint32_t>(window_size.x), static_cast<std::uint32_t>(window_size.y));
  const Swapchain old = std::move(swapchain_);
  swapchain_ = Swapchain(device_, surface_, format_, *render_pass_, wanted, *old.vk());
  out_of_date_ = false;
}

bool Presenter::present(const ShownPicture& picture, glm::ivec2 window_size,
                        const std::function<void(const vk::raii::CommandBuffer&)>& draw_over) {
  if (window_size.x == 0 || window_size.y == 0) return false;
  const bool resized = swapchain_.extent().width != static_cast<std::uint32_t>(window_size.x) ||
                       swapchain_.extent().height != static_cast<std::uint32_t>(window_size.y);
  if (out_of_date_ || resized) make_swapchain(window_size);
  if (swapchain_.image_count() == 0) return false;
  try {
    const auto [result, index] = swapchain_.vk().acquireNextImage(UINT64_MAX, *acquired_);
    vk_check("drawing the window", [&] {
      record(picture, index, draw_over);
      submit(index);
    });
    const vk::Semaphore drawn = swapchain_.drawn(index);
    const vk::SwapchainKHR swapchain = *swapchain_.vk();
    const vk::Result shown = device_.queue().presentKHR(vk::PresentInfoKHR(drawn, swapchain, index));
    out_of_date_ = result == vk::Result::eSuboptimalKHR || shown == vk::Result::eSuboptimalKHR;
  } catch (const vk::OutOfDateKHRError&) {
    out_of_date_ = true;
    return false;
  } catch (const vk::DeviceLostError&) {
    throw Error(ErrorKind::device_lost, "drawing the window: the device was lost");
  }
  return true;
}

void Presenter::record(const ShownPicture& picture, std::uint32_t index,
                       const std::function<void(const vk::raii::CommandBuffer&)>& draw_over) {
  const vk::Image target = swapchain_.image(index);
  commands_.reset();
  commands_.begin(vk::CommandBufferBeginInfo(vk::CommandBufferUsageFlagBits::eOneTimeSubmit));
  transition(commands_, target,
             {vk::ImageLayout::eUndefined, vk::ImageLayout::eTransferDstOptimal, {}, kWrite, kTransfer, kTransfer});
  const vk::ClearColorValue surround(std::array<float, 4>{kSurround, kSurround, kSurround, 1.0f});
  commands_.clearColorImage(target, vk::ImageLayout::eTransferDstOptimal, surround, kWhole);
  if (picture.words != nullptr) record_picture(picture, target);
  const vk::AccessFlags drawing = vk::AccessFlagBits::eColorAttachmentRead | vk::AccessFlagBits::eColorAttachmentWrite;
  transition(commands_, target,
             {vk::ImageLayout::eTransferDstOptimal, vk::ImageLayout::eColorAttachmentOptimal, kWrite, drawing,
              kTransfer, vk::PipelineStageFlagBits::eColorAttachmentOutput});
  commands_.beginRenderPass(
      vk::RenderPassBeginInfo(*render_pass_, swapchain_.framebuffer(index), vk::Rect2D({0, 0}, swapchain_.extent())),
      vk::SubpassContents::eInline);
  draw_over(commands_);
  commands_.endRenderPass();
  if (capture_wanted_ && swapchain_.can_be_read()) record_capture(target);
  commands_.end();
}

void Presenter::record_picture(const ShownPicture& picture, vk::Image target) {
  const vk::Extent3D extent(static_cast<std::uint32_t>(picture.size.x), static_cast<std::uint32_t>(picture.size.y), 1);
  // A shader of another submission wrote the words.
  commands_.pipelineBarrier(vk::PipelineStageFlagBits::eComputeShader, kTransfer, {},
                            vk::MemoryBarrier(vk::AccessFlagBits::eShaderWrite, vk::AccessFlagBits::eTransferRead),
                            nullptr, nullptr);
  transition(commands_, *picture_,
             {vk::ImageLayout::eUndefined, vk::ImageLayout::eTransferDstOptimal, kRead, kWrite, kTransfer, kTransfer});
  commands_.copyBufferToImage(*picture.words->vk(), *picture_, vk::ImageLayout::eTransferDstOptimal,
                              vk::BufferImageCopy(0, 0, 0, kLayer, {0, 0, 0}, extent));
  transition(commands_, *picture_,
             {vk::ImageLayout::eTransferDstOptimal, vk::ImageLayout::eTransferSrcOptimal, kWrite, kRead, kTransfer,
              kTransfer});
  // The clear and the picture write the same image one after the other.
  transition(commands_, target,
             {vk::ImageLayout::eTransferDstOptimal, vk::ImageLayout::eTransferDstOptimal, kWrite, kWrite, kTransfer,
              kTransfer});
  const bool same_size = picture.size == picture.shown_size;
  const vk::ImageBlit blit(kLayer, corners(glm::ivec2(0), picture.size), kLayer,
                           corners(picture.corner, picture.shown_size));
  commands_.blitImage(*picture_, vk::ImageLayout::eTransferSrcOptimal, target, vk::ImageLayout::eTransferDstOptimal,
                      blit, same_size ? vk::Filter::eNearest : vk::Filter::eLinear);
}

void Presenter::record_capture(vk::Image target) {
  captured_extent_ = swapchain_.extent();
  captured_ = Buffer(device_, std::uint64_t{4} * captured_extent_.width * captured_extent_.height,
                     BufferUse::storage_host_visible);
  capture_wanted_ = false;
  // The render pass ends with a transition of its own, behind all of its stages.
  const vk::PipelineStageFlags drawn = vk::PipelineStageFlagBits::eAllCommands;
  transition(commands_, target,
             {vk::ImageLayout::ePresentSrcKHR, vk::ImageLayout::eTransferSrcOptimal,
              vk::AccessFlagBits::eColorAttachmentWrite, kRead, drawn, kTransfer});
  commands_.copyImageToBuffer(
      target, vk::ImageLayout::eTransferSrcOptimal, *captured_.vk(),
      vk::BufferImageCopy(0, 0, 0, kLayer, {0, 0, 0}, {captured_extent_.width, captured_extent_.height, 1}));
  transition(commands_, target,
             {vk::ImageLayout::eTransferSrcOptimal,
              vk::ImageLayout::ePresentSrcKHR,
              kRead,
              {},
              kTransfer,
              vk::PipelineStageFlagBits::eBottomOfPipe});
  const vk::MemoryBarrier host(kWrite, vk::AccessFlagBits::eHostRead);
  commands_.pipelineBarrier(kTransfer, vk::PipelineStageFlagBits::eHost, {}, host, {}, {});
}

Image Presenter::taken_capture() {
  const Buffer words = std::exchange(captured_, Buffer());
  Image image{static_cast<int>(captured_extent_.width), static_cast<int>(captured_extent_.height), 3, {}};
  if (words.size_bytes() == 0) return {};
  const bool blue_first = format_.format == vk::Format::eB8G8R8A8Unorm;
  const std::span<std::byte> bytes = words.mapped();
  const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  image.values.reserve(3 * pixels);
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    for (const std::size_t channel : {0, 1, 2}) {
      const std::size_t place = 4 * pixel + (blue_first ? 2 - channel : channel);
      image.values.push_back(static_cast<float>(std::to_integer<int>(bytes[place])) / 255.0f);
    }
  }
  return image;
}

void Presenter::submit(std::uint32_t index) {
  const vk::PipelineStageFlags wait_stage = kTransfer;
  const vk::Semaphore acquired = *acquired_;
  const vk::Semaphore drawn = swapchain_.drawn(index);
  const vk::CommandBuffer commands = *commands_;
  device_.queue().submit(vk::SubmitInfo(acquired, wait_stage, commands, drawn), *done_);
  (void)device_.vk().waitForFences(*done_, VK_TRUE, UINT64_MAX);
  device_.vk().resetFences(*done_);
}

}  // namespace vernier
