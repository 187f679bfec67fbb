#include <gtest/gtest.h>

#include "cli/diff_report.h"
#include "cli/effect_table.h"
#include "cli/exposure_hint.h"
#include "cli/output_file.h"
#include "cli/render_report.h"
#include "usage_error.h"

namespace vernier {
namespace {

ImageFile grey_image(const std::vector<float>& pixels) {
  std::vector<float> values;
  for (const float pixel : pixels) {
    values.insert(values.end(), {pixel, pixel, pixel, 1.0f});
  }
  ImageFile image;
  image.width = image.full_width = static_cast<int>(pixels.size());
  image.height = image.full_height = 1;
  image.layers = {Layer{"", {"R", "G", "B", "A"}, values}};
  return image;
}

TEST(ExposureHint, OnlyWhenMoreThanHalfIsTooBright) {
  EXPECT_EQ(exposure_hint(grey_image({0.5f, 1.0f, 9.0f}), 0.0f), "");
  EXPECT_NE(exposure_hint(grey_image({0.5f, 4.0f, 9.0f}), 0.0f).find("--exposure -2"), std::string::npos);
  EXPECT_EQ(exposure_hint(grey_image({0.5f, 4.0f, 9.0f}), -2.0f), "") << "already done";
  EXPECT_NE(exposure_hint(grey_image({5.0f}), 0.0f).find("--exposure -2.5"), std::string::npos) << "half stops down";
  EXPECT_EQ(exposure_hint(ImageFile{}, 0.0f), "");
}

TEST(RenderJson, RaysPerSecondAndNulls) {
  RenderReport report;
  report.scene = "scene.glb";
  report.statistics.rays = {10, 20, 30, 40};
  report.statistics.trace_wall_ms = 50.0;
  const nlohmann::ordered_json json = render_json(report);
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["rays_per_s"], 2000.0);
  EXPECT_TRUE(json["error_estimate"].is_null());
  EXPECT_EQ(json["size"], nlohmann::ordered_json({1280, 720}));
  report.statistics.trace_wall_ms = 0.0;
  EXPECT_EQ(render_json(report)["rays_per_s"], 0.0) << "nothing was measured";
}

TEST(SummaryLine, TellsTheSizeThatWasRendered) {
  RenderReport report;
  report.settings.crop = PixelRect{5, 5, 20, 10};
  report.statistics.samples_done = 3;
  EXPECT_TRUE(summary_line(report, "out.png").starts_with("out.png: 20x10, 3 samples"));
}

TEST(DiffJson, InfinitePsnrIsNull) {
  DiffReport report;
  report.difference.psnr_db = std::numeric_limits<double>::infinity();
  EXPECT_NE(diff_json(report).dump().find("\"psnr_db\":null"), std::string::npos);
}

TEST(DefaultImagePath, NameOfTheSceneInTheCurrentFolder) {
  EXPECT_EQ(default_image_path("folder/scene.v2.gltf"), "scene.v2.png");
  EXPECT_EQ(default_image_path(""), "vernier.png");
}

TEST(CheckImageOutput, ExtensionAndFolder) {
  expect_usage_error("out.bmp", [] { check_image_output("out.bmp"); });
  EXPECT_THROW(check_image_output("no/such/folder/out.png"), Error);
  EXPECT_NO_THROW(check_image_output("out.png"));
  EXPECT_NO_THROW(check_text_output("")) << "not asked for";
}

}  // namespace
}  // namespace vernier
