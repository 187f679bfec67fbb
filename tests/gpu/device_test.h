#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "gpu/device.h"
#include "gpu/vector_width.h"

namespace vernier {

/// VERNIER_TEST_DRIVER: lavapipe, newer_lavapipe or swiftshader; empty where any will do.
inline std::string tested_driver() {
  const char* driver = std::getenv("VERNIER_TEST_DRIVER");
  return driver != nullptr ? driver : "";
}

/// What VERNIER_TEST_DRIVER promises is part of the device's name: lavapipe's is llvmpipe.
inline std::string expected_device_name() {
  if (tested_driver().empty()) return "";
  return tested_driver() == "swiftshader" ? "SwiftShader" : "llvmpipe";
}

/// The driver the tests run on, opened when first asked for and once for all cases of a process, with validation:
/// SwiftShader takes seconds for what the device's store of pipelines has for the next case.
class TestedDevice : public testing::Environment {
 public:
  const VulkanInstance& instance() {
    if (instance_ == nullptr) {
      // The newer lavapipe is here for its ray queries.
      tested_driver() == "newer_lavapipe" ? keep_vectors_narrow() : choose_vector_width();
      instance_ = std::make_unique<VulkanInstance>(true);
    }
    return *instance_;
  }

  const Device& device() {
    if (device_ == nullptr) {
      device_ = std::make_unique<Device>(instance(), choose_device(list_devices(instance()), expected_device_name()));
    }
    return *device_;
  }

  /// Fails the case for what the validation layer has said since the last one.
  void expect_no_messages() {
    if (instance_ == nullptr) return;
    const std::vector<std::string> messages = instance_->validation_messages();
    for (; told_ < messages.size(); ++told_) ADD_FAILURE() << messages[told_];
  }

  /// No message is allowed while the device is destroyed either.
  void TearDown() override {
    device_.reset();
    expect_no_messages();
    instance_.reset();
    told_ = 0;
  }

 private:
  std::unique_ptr<VulkanInstance> instance_;
  std::unique_ptr<Device> device_;
  std::size_t told_ = 0;
};

/// The one of this process. GoogleTest owns it, and has to know it before the first case.
inline TestedDevice& tested_device = *static_cast<TestedDevice*>(testing::AddGlobalTestEnvironment(new TestedDevice));

/// A case on the driver the tests run on. No message of the validation layer is allowed.
class DeviceTest : public testing::Test {
 protected:
  void SetUp() override { tested_device.device(); }
  void TearDown() override { tested_device.expect_no_messages(); }

  const VulkanInstance& instance() const { return tested_device.instance(); }
  const Device& device() const { return tested_device.device(); }
};

}  // namespace vernier
