#include "preview/window_stage.h"

namespace vernier {
namespace {

CachedDevice open_device(const VulkanInstance& instance, const std::string& selector) {
  const DeviceDescription description = choose_device(list_devices(instance), selector);
  return CachedDevice(instance, description, pipeline_file(description.pipeline_key),
                      {VK_KHR_SWAPCHAIN_EXTENSION_NAME});
}

}  // namespace

WindowStage::WindowStage(Window& window, const std::string& selector, glm::ivec2 largest_picture)
    : instance_(false, window.instance_extensions()),
      device_(open_device(instance_, selector)),
      surface_(window.make_surface(instance_)),
      presenter_(device_.device(), *surface_, window.size_px(), largest_picture),
      interface_(window, instance_, device_.device(), presenter_) {}

}  // namespace vernier
