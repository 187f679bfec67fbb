#include "gpu/probe_device.h"

#include "device_test.h"

namespace vernier {
namespace {

class ProbeDeviceTest : public DeviceTest {};

TEST_F(ProbeDeviceTest, what_the_renderer_builds_on_holds) {
  const ProbeResult probe = probe_device(device());
  EXPECT_FALSE(probe.precise_sum_is_fused);
  EXPECT_TRUE(probe.precise_two_sum_survives);
  EXPECT_TRUE(probe.isnan_works);
  EXPECT_GE(probe.max_division_error_ulps, 0.4) << "65536 quotients cannot all be nearly exact";
  EXPECT_LE(probe.max_division_error_ulps, 2.5) << "the bound of Vulkan";
}

TEST_F(ProbeDeviceTest, lavapipe_and_swiftshader_differ_where_they_are_known_to) {
  const ProbeResult probe = probe_device(device());
  EXPECT_EQ(probe.float64, device().description().float64);
  if (device().description().is_llvmpipe) {
    // Mesa lowers ffma and divides by the CPU's instruction; without `precise` it folds (a + b) - a.
    EXPECT_FALSE(probe.fma_is_fused);
    EXPECT_FALSE(probe.two_sum_survives);
    EXPECT_TRUE(probe.float64);
    EXPECT_EQ(probe.min_of_nan, NanChoice::number);
    EXPECT_EQ(probe.max_of_nan, NanChoice::number);
    EXPECT_LE(probe.max_division_error_ulps, 0.5);
  } else {
    EXPECT_FALSE(probe.float64);
  }
}

}  // namespace
}  // namespace vernier
