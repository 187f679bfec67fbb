#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <string>

#include "gpu/device.h"

namespace vernier {

/// What VERNIER_TEST_DRIVER promises is part of the device's name: lavapipe's is llvmpipe.
inline std::string expected_device_name() {
  const char* driver = std::getenv("VERNIER_TEST_DRIVER");
  if (driver == nullptr) return "";
  return std::string(driver) == "swiftshader" ? "SwiftShader" : "llvmpipe";
}

/// Opens the driver the test runs on with validation; no message of the validation layer is allowed, not even while the
/// device is destroyed.
class DeviceTest : public testing::Test {
 protected:
  void SetUp() override {
    instance_ = std::make_unique<VulkanInstance>(true);
    description_ = choose_device(list_devices(*instance_), expected_device_name());
    device_ = std::make_unique<Device>(*instance_, description_);
  }

  void TearDown() override {
    if (instance_ == nullptr) return;
    device_.reset();
    for (const std::string& message : instance_->validation_messages()) ADD_FAILURE() << message;
  }

  const VulkanInstance& instance() const { return *instance_; }
  const Device& device() const { return *device_; }

 private:
  std::unique_ptr<VulkanInstance> instance_;
  DeviceDescription description_;
  std::unique_ptr<Device> device_;
};

}  // namespace vernier
