#pragma once

#include <memory>
#include <string>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

namespace vernier {

/// The Vulkan loader and an instance of version 1.2. Owns both; movable by construction only.
class VulkanInstance {
 public:
  /// `validation` turns the Khronos validation layer on (with synchronisation checks); its messages are collected.
  /// The environment variable VERNIER_VALIDATION=1 does the same for any caller.
  /// `extensions`: names of instance extensions that a window asks for.
  /// Throws Error(no_device) without a loader, driver or extension, or when validation is asked for and not installed.
  explicit VulkanInstance(bool validation = false, const std::vector<const char*>& extensions = {});
  /// Takes over what `other` owns.
  VulkanInstance(VulkanInstance&& other) noexcept;
  VulkanInstance& operator=(VulkanInstance&&) = delete;
  ~VulkanInstance();

  /// The Vulkan-Hpp instance.
  const vk::raii::Instance& vk() const { return instance_; }

  /// Warnings and errors of the validation layer so far, one line each; empty without validation.
  std::vector<std::string> validation_messages() const;

 private:
  struct MessageLog;
  vk::raii::Context context_;
  std::unique_ptr<MessageLog> log_;
  vk::raii::Instance instance_{nullptr};
  vk::raii::DebugUtilsMessengerEXT messenger_{nullptr};
};

}  // namespace vernier
