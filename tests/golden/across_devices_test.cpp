// The exact level on two drivers in one process.
#include <gtest/gtest.h>

#include <algorithm>

#include "level_images.h"
#include "verify/run_cases.h"

namespace vernier::golden {
namespace {

class AcrossDevices : public testing::TestWithParam<GoldenCase> {};

TEST_P(AcrossDevices, ExactHitsAreTheSameAndColoursNearlySo) {
  const VulkanInstance instance(true);
  const CaseSetup setup = set_up_case(GetParam());
  std::vector<ImageFile> images;
  for (const char* name : {"llvmpipe", "SwiftShader"}) {
    const Device device(instance, choose_device(list_devices(instance), name));
    images.push_back(image_at(device, setup, Accuracy::exact));
  }
  for (std::size_t layer = 1; layer < images[0].layers.size(); ++layer) {
    EXPECT_EQ(std::get<std::vector<std::uint32_t>>(images[0].layers[layer].values),
              std::get<std::vector<std::uint32_t>>(images[1].layers[layer].values))
        << images[0].layers[layer].name;
  }
  const std::vector<float>&a = color_of(images[0]), &b = color_of(images[1]);
  // One step of an 8-bit picture; above 1 of the value, which is beyond white there.
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i], b[i], std::max(1.0f, a[i]) / 255.0f) << "value " << i;
  for (const std::string& message : instance.validation_messages()) ADD_FAILURE() << message;
}

// The case of the numeric suite, which needs both drivers at once: in tests/numerics there is one.
TEST(DriverDifference, HoldsAtExact) {
  const VulkanInstance instance(true);
  const Device device(instance, choose_device(list_devices(instance), "llvmpipe"));
  vernier::CaseSetup setup;
  setup.device = &device;
  setup.level = Accuracy::exact;
  setup.levels = LEVELS_OF(LEVEL_EXACT);
  setup.sample_count = 1;  // rounded up to a picture
  const VerifyCase* verify_case = vernier::find_case("driver_difference");
  ASSERT_NE(verify_case, nullptr);
  const CaseReport report = run_case(*verify_case, setup);
  EXPECT_EQ(report.result.not_run, "");
  EXPECT_TRUE(report.held) << report.result.failures << " pixels, " << report.result.worst_inputs;
}

INSTANTIATE_TEST_SUITE_P(Scenes, AcrossDevices, testing::ValuesIn(level_scenes()),
                         [](const auto& param) { return param.param.name; });

}  // namespace
}  // namespace vernier::golden
