#include "cli/recipe.h"

#include <gtest/gtest.h>

#include "error.h"
#include "temporary_folder.h"

namespace vernier {
namespace {

TEST(Recipe, OptionsThatAreGivenAndThoseWithADefault) {
  SceneArguments scene;
  scene.lights = {"dir:0,-1,0:1,1,1"};
  RenderArguments render;
  render.seed = "3";
  render.tile = "8x8";
  const nlohmann::ordered_json options = recipe_options(scene, render);
  EXPECT_EQ(options["size"], "1280x720");
  EXPECT_EQ(options["seed"], "3");
  EXPECT_EQ(options["light"][0], "dir:0,-1,0:1,1,1");
  EXPECT_FALSE(options.contains("crop"));
  EXPECT_FALSE(options.contains("tile")) << "changes no bit of the image";
}

TEST(Recipe, BuiltinSceneHasNoHash) {
  const auto metadata =
      render_recipe(scene_recipe(SceneArguments{}, {}, RenderArguments{}), {"card", "driver 1", "abc"});
  EXPECT_EQ(metadata.at("vernier:scene"), "");
  EXPECT_FALSE(metadata.contains("vernier:scene_sha1"));
  EXPECT_EQ(metadata.at("vernier:device"), "card");
  EXPECT_EQ(metadata.at("vernier:driver"), "driver 1");
  EXPECT_EQ(metadata.at("vernier:spirv_hash"), "abc");
}

// The test vector of FIPS 180, "abc", whole and in two files.
TEST(Sha1OfFiles, TestVectorOfFips180) {
  const char* digest = "a9993e364706816aba3e25717850c26c9cd0d89d";
  using Files = std::vector<std::string>;
  const TemporaryFolder folder;
  EXPECT_EQ(sha1_of_files(Files{folder.write("abc", "abc")}), digest);
  EXPECT_EQ(sha1_of_files(Files{folder.write("a", "a"), folder.write("bc", "bc")}), digest);
  EXPECT_THROW(sha1_of_files(Files{folder.file("missing")}), Error);
}

}  // namespace
}  // namespace vernier
