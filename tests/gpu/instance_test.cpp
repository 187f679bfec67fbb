#include "gpu/instance.h"

#include <gtest/gtest.h>

#include "device_test.h"

namespace vernier {
namespace {

class InstanceTest : public DeviceTest {};

TEST(VulkanInstance, collects_what_validation_finds_wrong) {
  const VulkanInstance instance(true);
  const Device device(instance, choose_device(list_devices(instance), expected_device_name()));
  EXPECT_TRUE(instance.validation_messages().empty());
  {
    // A buffer of no bytes and no use breaks two rules of vkCreateBuffer.
    const vk::raii::Buffer wrong = device.vk().createBuffer(vk::BufferCreateInfo({}, 0, {}));
  }
  const std::vector<std::string> messages = instance.validation_messages();
  ASSERT_FALSE(messages.empty());
  EXPECT_NE(messages.front().find("VUID-VkBufferCreateInfo"), std::string::npos) << messages.front();
  EXPECT_EQ(messages.front().find('\n'), std::string::npos);
}

TEST(VulkanInstance, collects_nothing_without_validation) {
  const VulkanInstance instance;
  const Device device(instance, choose_device(list_devices(instance), expected_device_name()));
  EXPECT_TRUE(instance.validation_messages().empty());
}

TEST(VulkanInstance, the_environment_turns_validation_on) {
  ASSERT_EQ(setenv("VERNIER_VALIDATION", "1", 1), 0);
  const VulkanInstance instance;
  unsetenv("VERNIER_VALIDATION");
  const Device device(instance, choose_device(list_devices(instance), expected_device_name()));
  { const vk::raii::Buffer wrong = device.vk().createBuffer(vk::BufferCreateInfo({}, 0, {})); }
  EXPECT_FALSE(instance.validation_messages().empty());
}

TEST(VulkanInstance, moving_keeps_the_devices) {
  VulkanInstance first(true);
  const std::size_t device_count = list_devices(first).size();
  const VulkanInstance second(std::move(first));
  EXPECT_EQ(list_devices(second).size(), device_count);
  EXPECT_GE(device_count, 1U);
}

TEST_F(InstanceTest, no_driver_is_an_error_of_its_own_kind) {
  ASSERT_EQ(setenv("VK_DRIVER_FILES", "/nonexistent.json", 1), 0);
  try {
    const VulkanInstance instance;
    choose_device(list_devices(instance), "");
    ADD_FAILURE() << "a device was found without a driver";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::no_device);
  }
}

}  // namespace
}  // namespace vernier
