#include "gpu/instance.h"

#include <cstdlib>
#include <cstring>
#include <mutex>

#include "error.h"

namespace vernier {

/// Messages come from whichever thread makes the call that is at fault.
struct VulkanInstance::MessageLog {
  std::mutex mutex;
  std::vector<std::string> lines;

  static VKAPI_ATTR VkBool32 VKAPI_CALL receive(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                                VkDebugUtilsMessageTypeFlagsEXT,
                                                const VkDebugUtilsMessengerCallbackDataEXT* message, void* log) {
    const bool is_error = (severity & VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT) != 0;
    std::string line = is_error ? "error: " : "warning: ";
    line += message->pMessage != nullptr ? message->pMessage : "";
    for (char& character : line) character = character == '\n' ? ' ' : character;
    auto* self = static_cast<MessageLog*>(log);
    const std::lock_guard lock(self->mutex);
    self->lines.push_back(std::move(line));
    return VK_FALSE;
  }
};

namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

bool environment_asks_for_validation() {
  const char* value = std::getenv("VERNIER_VALIDATION");
  return value != nullptr && std::strcmp(value, "1") == 0;
}

vk::raii::Instance create_instance(const vk::raii::Context& context, bool validation,
                                   std::vector<const char*> extensions) {
  const vk::ApplicationInfo application("vernier", 1, "vernier", 1, VK_API_VERSION_1_2);
  vk::InstanceCreateInfo create({}, &application);
  const std::vector<const char*> layers{kValidationLayer};
  const vk::ValidationFeatureEnableEXT synchronization = vk::ValidationFeatureEnableEXT::eSynchronizationValidation;
  const vk::ValidationFeaturesEXT features(synchronization);
  if (validation) {
    extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
    create.setPEnabledLayerNames(layers).setPNext(&features);
  }
  create.setPEnabledExtensionNames(extensions);
  return vk::raii::Instance(context, create);
}

}  // namespace

// A try block around the whole constructor, since the loader is opened by a member.
VulkanInstance::VulkanInstance(bool validation, const std::vector<const char*>& extensions) try
    : log_(std::make_unique<MessageLog>()) {
  const bool validate = validation || environment_asks_for_validation();
  instance_ = create_instance(context_, validate, extensions);
  if (!validate) return;
  // The C structure, since versions of the C++ one differ in the callback's type.
  VkDebugUtilsMessengerCreateInfoEXT messages{};
  messages.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
  messages.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  // Not general ones: that is the loader talking about drivers it did not find.
  messages.messageType =
      VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
  messages.pfnUserCallback = &MessageLog::receive;
  messages.pUserData = log_.get();
  messenger_ = vk::raii::DebugUtilsMessengerEXT(instance_, vk::DebugUtilsMessengerCreateInfoEXT(messages));
} catch (const vk::LayerNotPresentError&) {
  throw Error(ErrorKind::no_device, "Vulkan: the validation layer " + std::string(kValidationLayer) +
                                        " was asked for and is not installed (Debian: vulkan-validationlayers)");
} catch (const vk::ExtensionNotPresentError& error) {
  throw Error(ErrorKind::no_device,
              std::string("Vulkan: no driver here has an extension that is needed: ") + error.what());
} catch (const vk::IncompatibleDriverError&) {
  throw Error(ErrorKind::no_device, "Vulkan: no driver is installed (Debian: mesa-vulkan-drivers has one for any CPU)");
} catch (const std::runtime_error& error) {
  throw Error(ErrorKind::no_device, std::string("Vulkan: the loader does not start: ") + error.what());
}

VulkanInstance::VulkanInstance(VulkanInstance&& other) noexcept = default;

VulkanInstance::~VulkanInstance() = default;

std::vector<std::string> VulkanInstance::validation_messages() const {
  const std::lock_guard lock(log_->mutex);
  return log_->lines;
}

}  // namespace vernier
