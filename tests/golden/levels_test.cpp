// The numeric levels, each against the arbiter.
#include <cmath>

#include "device_test.h"
#include "level_images.h"
#include "reference/render_reference.h"

namespace vernier::golden {
namespace {

ImageFile reference_of(const CaseSetup& setup) {
  ReferenceSettings settings;
  settings.width = kLevelWidth;
  settings.height = kLevelHeight;
  settings.spp = 1;
  settings.max_bounces = setup.settings.max_bounces;
  settings.cutoff = static_cast<double>(setup.settings.cutoff);
  return render_reference(setup.scene.scene, setup.scene.camera, settings, {});
}

double rmse(const ImageFile& a, const ImageFile& b) {
  const std::vector<float>&x = color_of(a), &y = color_of(b);
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += (double{x[i]} - y[i]) * (double{x[i]} - y[i]);
  return std::sqrt(sum / static_cast<double>(x.size()));
}

class Levels : public DeviceTest, public testing::WithParamInterface<GoldenCase> {};

TEST_P(Levels, RobustAndExactAreTheReferenceAndFastIsNot) {
  const CaseSetup setup = set_up_case(GetParam());
  const ImageFile reference = reference_of(setup);
  EXPECT_LE(rmse(image_at(device(), setup, Accuracy::robust), reference), GetParam().linear.rmse);
  EXPECT_LE(rmse(image_at(device(), setup, Accuracy::exact), reference), GetParam().linear.rmse);
  // A fixed offset of 1e-4 of the scene shows: else the levels would not be at work.
  EXPECT_GE(rmse(image_at(device(), setup, Accuracy::fast), reference), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Levels, testing::ValuesIn(level_scenes()),
                         [](const auto& param) { return param.param.name; });

}  // namespace
}  // namespace vernier::golden
