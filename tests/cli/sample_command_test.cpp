#include "cli/sample_command.h"

#include <gtest/gtest.h>

namespace vernier {
namespace {

TEST(ShellWord, IsQuotedOnlyWhereAShellWouldReadMore) {
  EXPECT_EQ(shell_word("scenes/glass_ball.glb"), "scenes/glass_ball.glb");
  EXPECT_EQ(shell_word("1,2,3"), "1,2,3");
  EXPECT_EQ(shell_word(""), "''");
  EXPECT_EQ(shell_word("my scene.glb"), "'my scene.glb'");
  EXPECT_EQ(shell_word("a;b$c"), "'a;b$c'");
  EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
}

TEST(SampleCommand, NamesEverythingThatDecidesABit) {
  RenderPlan plan;
  plan.scene_arguments.scene = "my scene.glb";
  plan.scene_arguments.eye = "-1,2,3";
  plan.scene_arguments.lights = {"dir:0,-1,0:1,1,1", "point:0,1,0:9,9,9"};
  plan.render_arguments.size = "64x32";
  plan.render_arguments.spp = "8";
  plan.render_arguments.sample_range = "2:8";
  plan.render_arguments.crop = "0,0,32,32";
  plan.render_arguments.aov = "depth";
  plan.render_arguments.accuracy = "exact";
  plan.render_arguments.tile = "8x8";
  EXPECT_EQ(
      sample_command(plan, "llvmpipe (LLVM 15)", {.x = 12, .y = 30, .sample = 5}),
      "vernier render 'my scene.glb' -o sample.exr --size 64x32 --crop 12,30,1,1 --eye=-1,2,3 --light dir:0,-1,0:1,1,1 "
      "--light point:0,1,0:9,9,9 --spp 8 --sample-range 5:6 --max-bounces 8 --cutoff 1/1024 --accuracy exact "
      "--effects auto --filter box --texture-filter file --bvh default --seed 0 --device 'llvmpipe (LLVM 15)'");
}

TEST(SampleCommand, AnErrorTargetLeavesItsMostSamples) {
  RenderPlan plan;
  plan.render_arguments.error_target = "0.1";
  const std::string command = sample_command(plan, "card", {.x = 1, .y = 2, .sample = 3});
  EXPECT_NE(command.find("--spp 65536 --sample-range 3:4"), std::string::npos) << command;
  EXPECT_EQ(command.find("--error-target"), std::string::npos) << command;
}

TEST(SampleCommand, TheBuiltinSceneHasNoName) {
  EXPECT_EQ(sample_command({}, "card", {}).find("vernier render -o sample.exr --size"), 0u);
}

}  // namespace
}  // namespace vernier
