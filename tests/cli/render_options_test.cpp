#include "cli/render_options.h"

#include <cmath>

#include "cli/scene_options.h"
#include "usage_error.h"

namespace vernier {
namespace {

TEST(RenderOptions, DefaultsAreThoseOfRenderSettings) {
  const RenderSettings parsed = parse_render_settings(RenderArguments{});
  const RenderSettings defaults;
  EXPECT_EQ(parsed.width, defaults.width);
  EXPECT_EQ(parsed.height, defaults.height);
  EXPECT_FALSE(parsed.crop.has_value());
  EXPECT_EQ(parsed.sample_begin, defaults.sample_begin);
  EXPECT_EQ(parsed.sample_end, defaults.sample_end);
  EXPECT_EQ(parsed.spp, defaults.spp);
  EXPECT_EQ(parsed.max_bounces, defaults.max_bounces);
  EXPECT_EQ(parsed.cutoff, defaults.cutoff);
  EXPECT_EQ(parsed.accuracy, defaults.accuracy);
  EXPECT_EQ(parsed.effects, defaults.effects);
  EXPECT_EQ(parsed.tile, defaults.tile);
  EXPECT_EQ(parsed.bvh, defaults.bvh);
  EXPECT_EQ(parsed.traversal, defaults.traversal);
  EXPECT_EQ(parsed.dispatch_ms, defaults.dispatch_ms);
  EXPECT_EQ(parsed.time_limit_s, defaults.time_limit_s);
  EXPECT_EQ(parsed.seed, defaults.seed);
  EXPECT_EQ(parsed.aovs, defaults.aovs);
}

TEST(RenderOptions, EveryTextArrives) {
  RenderArguments arguments;
  arguments.size = "100x50";
  arguments.crop = "10,20,30,30";
  arguments.spp = "8";
  arguments.sample_range = "2:6";
  arguments.max_bounces = "0";
  arguments.cutoff = "0";
  arguments.effects = "auto,-shadows";
  arguments.tile = "16x8";
  arguments.bvh = "fast";
  arguments.traversal = "storage-shifted";
  arguments.dispatch_ms = "5.5";
  arguments.time_limit = "2.5";
  arguments.aov = "depth,cost";
  arguments.seed = "9";
  const RenderSettings settings = parse_render_settings(arguments);
  EXPECT_EQ(settings.width, 100);
  EXPECT_EQ(settings.height, 50);
  ASSERT_TRUE(settings.crop.has_value());
  EXPECT_EQ(settings.crop->x, 10);
  EXPECT_EQ(settings.crop->height, 30);
  EXPECT_EQ(settings.sample_begin, 2u);
  EXPECT_EQ(settings.sample_end, 6u);
  EXPECT_EQ(settings.spp, 8u);
  EXPECT_EQ(settings.max_bounces, 0u);
  EXPECT_EQ(settings.cutoff, 0.0f);
  EXPECT_EQ(settings.effects, "auto,-shadows");
  EXPECT_EQ(settings.tile, glm::ivec2(16, 8));
  EXPECT_EQ(settings.bvh, BuildMethod::fast);
  EXPECT_EQ(settings.traversal, TraversalForm::storage_shifted);
  EXPECT_EQ(settings.dispatch_ms, 5.5);
  EXPECT_EQ(settings.time_limit_s, 2.5);
  EXPECT_EQ(settings.aovs, (std::vector<std::string>{"depth", "cost"}));
  EXPECT_EQ(settings.seed, 9u);
}

TEST(RenderOptions, PixelBoundAppliesToWhatIsRendered) {
  RenderArguments arguments;
  arguments.size = "65536x65536";
  expect_usage_error("--crop", [&] { parse_render_settings(arguments); });
  arguments.crop = "65535,65535,1,1";
  EXPECT_EQ(parse_render_settings(arguments).width, 65536);
  arguments.crop = "65535,65535,2,1";
  expect_usage_error("--crop", [&] { parse_render_settings(arguments); });
}

TEST(RenderOptions, AccuracyHasThreeLevels) {
  RenderArguments arguments;
  for (const Accuracy level : {Accuracy::fast, Accuracy::robust, Accuracy::exact}) {
    arguments.accuracy = to_string(level);
    EXPECT_EQ(parse_render_settings(arguments).accuracy, level);
  }
  arguments.accuracy = "best";
  expect_usage_error("--accuracy", [&] { parse_render_settings(arguments); });
}

TEST(SceneOptions, FieldOfViewIsOpenOnBothSides) {
  SceneArguments arguments;
  arguments.fov = "90";
  EXPECT_DOUBLE_EQ(*parse_scene_settings(arguments).vertical_fov, std::acos(0.0));
  for (const char* degrees : {"0", "180", "-1", "nan"}) {
    arguments.fov = degrees;
    expect_usage_error("--fov", [&] { parse_scene_settings(arguments); });
  }
}

TEST(SceneOptions, BackgroundIsAColourOrAFile) {
  SceneArguments arguments;
  arguments.background = "0.5,1e-1,2";
  EXPECT_EQ(parse_scene_settings(arguments).background_color, glm::vec3(0.5f, 0.1f, 2.0f));
  arguments.background = "sky.hdr";
  EXPECT_EQ(parse_scene_settings(arguments).background_file, "sky.hdr");
  arguments.background = "sky.txt";
  try {
    parse_scene_settings(arguments);
    ADD_FAILURE() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_NE(std::string(error.what()).find("sky.txt"), std::string::npos);
  }
}

}  // namespace
}  // namespace vernier
