// The same scene made in other ways: every scene of goldens.json, since its own effects choose its own pipeline.
#include <cmath>
#include <cstring>

#include "device_test.h"
#include "golden_case.h"
#include "render/render_image.h"

namespace vernier::golden {
namespace {

constexpr int kWidth = 72;  // wider than a tile of 64, so that it is cut
constexpr int kHeight = 40;
constexpr std::uint32_t kSpp = 4;

class Invariance : public DeviceTest, public testing::WithParamInterface<GoldenCase> {
 protected:
  void SetUp() override {
    DeviceTest::SetUp();
    setup_ = set_up_case(GetParam());
    setup_.settings.width = kWidth;
    setup_.settings.height = kHeight;
    setup_.settings.spp = setup_.settings.sample_end = kSpp;
    whole_ = colors(setup_.settings);
  }

  std::vector<float> colors(const RenderSettings& settings) const {
    RenderResult result = render_image(device(), setup_.scene.scene, setup_.scene.camera, settings, {});
    return std::get<std::vector<float>>(result.image.layers.at(0).values);
  }

  // Records what `check` found; known failures are expected to fail.
  void judge(const char* check, const std::string& fault) const {
    EXPECT_EQ(unexpected(GetParam().name, check, fault), "");
  }

  // Bits, since NaN is not equal to itself and -0 is equal to 0.
  void expect_whole(const RenderSettings& settings, const char* check) const {
    const std::vector<float> other = colors(settings);
    ASSERT_EQ(other.size(), whole_.size());
    const bool same = std::memcmp(other.data(), whole_.data(), whole_.size() * sizeof(float)) == 0;
    judge(check, same ? "" : "other bits");
  }

  void expect_crop(const PixelRect& crop) const {
    RenderSettings settings = setup_.settings;
    settings.crop = crop;
    const std::vector<float> part = colors(settings);
    const std::size_t row_size = 4u * static_cast<std::size_t>(crop.width);
    ASSERT_EQ(part.size(), row_size * static_cast<std::size_t>(crop.height));
    std::string fault;
    for (int y = 0; y < crop.height; ++y) {
      const float* row = whole_.data() + 4 * (static_cast<std::size_t>(crop.y + y) * kWidth + crop.x);
      const bool same = std::memcmp(part.data() + y * row_size, row, row_size * sizeof(float)) == 0;
      if (!same) fault += "row " + std::to_string(y) + " ";
    }
    judge("crop", fault);
  }

  // The sums are exact, so two halves differ from the whole by their own rounding to float and the division alone:
  // half an ulp each.
  void expect_halves() const {
    RenderSettings first = setup_.settings, second = setup_.settings;
    first.sample_end = second.sample_begin = kSpp / 2;
    const std::vector<float> a = colors(first), b = colors(second);
    for (std::size_t i = 0; i < whole_.size(); ++i) {
      const double mean = (static_cast<double>(a[i]) + b[i]) / 2.0;
      ASSERT_NEAR(mean, whole_[i], 0x1p-23 * (std::abs(a[i]) + std::abs(b[i]))) << "value " << i;
    }
  }

  CaseSetup setup_;
  std::vector<float> whole_;
};

TEST_P(Invariance, HoldsForEveryWayToMakeTheImage) {
  const RenderSettings& chosen = setup_.settings;
  expect_whole(chosen, "second run");
  RenderSettings other = chosen;
  other.tile = {8, 8};
  other.dispatch_ms = 5.0;
  expect_whole(other, "small tiles");
  other.tile = {64, 64};
  other.dispatch_ms = 500.0;
  expect_whole(other, "large tiles");
  other = chosen;
  other.tile = {kWidth, kHeight};
  expect_whole(other, "one tile");
  other = chosen;
  other.effects = "all";
  expect_whole(other, "all effects");
  for (const BuildMethod method : kBuildMethods) {
    other = chosen;
    other.bvh = method;
    expect_whole(other, "another tree");
  }
  expect_crop({13, 7, 41, 22});
  expect_halves();
}

INSTANTIATE_TEST_SUITE_P(Scenes, Invariance, testing::ValuesIn(load_cases()),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace vernier::golden
