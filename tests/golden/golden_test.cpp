#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "cli/recipe.h"
#include "compare_tiers.h"
#include "device_test.h"
#include "golden_case.h"
#include "image/error_colors.h"
#include "image/flip.h"
#include "image/read_image.h"
#include "image/write_image.h"
#include "render/render_image.h"

namespace vernier::golden {
namespace {

class Golden : public DeviceTest, public testing::WithParamInterface<GoldenCase> {
 protected:
  // Renders the case with meshes copied or shared and judges it; files that are kept begin with `name`.
  void match_reference(Sharing sharing, const std::string& name) const;
};

// Renders lie where they can be looked at when the test fails: in the build folder, by driver.
std::string kept_path(const std::string& file) {
  const std::filesystem::path folder = std::filesystem::path(VERNIER_GOLDEN_OUTPUT) / expected_device_name();
  std::filesystem::create_directories(folder);
  return (folder / file).string();
}

nlohmann::json json_of(const std::string& path) {
  return nlohmann::json::parse(std::ifstream(path));
}

void check_recipe(const GoldenCase& golden, const CaseSetup& setup) {
  const nlohmann::json recipe = json_of(golden_path("images/" + golden.name + ".json"));
  const std::string remedy = golden.name + ": the golden is of another recipe; tools/update_goldens " + golden.name;
  EXPECT_EQ(recipe.at("scene_sha1"), sha1_of_files(setup.scene.scene.files)) << remedy;
  EXPECT_EQ(recipe.at("options"), golden.options) << remedy;
  EXPECT_FALSE(recipe.at("reason").get<std::string>().empty());
}

void keep_difference(const std::string& name, const ImageFile& render, const ImageFile& expected) {
  const std::string render_path = kept_path(name + ".exr");
  write_image(render_path, render, {});
  write_image(kept_path(name + ".golden.exr"), expected, {});
  const FlipError error = flip(color_of(expected), color_of(render));
  const ImageFile map{.width = error.width,
                      .height = error.height,
                      .full_width = error.width,
                      .full_height = error.height,
                      .layers = {{"", {"Y"}, error.map}},
                      .metadata = {}};
  write_image(kept_path(name + ".flip.exr"), map, {});
  std::cout << "kept: " << render_path << " with .golden.exr, .flip.exr and .png beside it\n";
}

// SwiftShader takes seconds for each kernel. There the fewest effects and most of them have their own, the other scenes
// one with every effect: that it has the bits of each scene's own is what Invariance shows on lavapipe.
std::string effects_for(const GoldenCase& golden) {
  const bool has_its_own = golden.name == "first_light" || golden.name == "every_effect";
  return tested_driver() == "swiftshader" && !has_its_own ? "all" : "auto";
}

void Golden::match_reference(Sharing sharing, const std::string& name) const {
  const GoldenCase& golden = GetParam();
  CaseSetup setup = set_up_case(golden);
  check_recipe(golden, setup);
  setup.settings.aovs = {"object_id", "primitive_id"};
  setup.settings.sharing = sharing;
  setup.settings.effects = effects_for(golden);
  const ImageFile render = render_image(device(), setup.scene.scene, setup.scene.camera, setup.settings, {}).image;
  const ImageFile expected = read_image(golden_path("images/" + golden.name + ".exr"));
  ASSERT_EQ(render.width, expected.width);
  ASSERT_EQ(render.height, expected.height);
  const std::string shown = kept_path(name + ".png");
  write_image(shown,
              {.width = render.width,
               .height = render.height,
               .full_width = render.width,
               .full_height = render.height,
               .layers = {layer_of(render, "")},
               .metadata = {}},
              {});

  const ImageFile png = read_image(shown);
  const Image shown_color{png.width, png.height, static_cast<int>(png.layers.at(0).channels.size()),
                          std::get<std::vector<float>>(png.layers.at(0).values)};
  const std::array<TierResult, 3> tiers = {compare_hits(render, expected, golden.hits, setup.settings.spp),
                                           compare_linear(render, expected, golden.linear, golden.hits.rounding_steps),
                                           compare_display(shown_color, expected, golden.display)};
  std::string faults, surprises;
  for (std::size_t i = 0; i < tiers.size(); ++i) {
    std::cout << name << ": " << tiers[i].figures << "\n";
    faults += tiers[i].faults;
    surprises += unexpected(name, std::string(1, "ABC"[i]), tiers[i].faults);
  }
  if (!faults.empty()) keep_difference(name, render, expected);
  EXPECT_EQ(surprises, "");
}

TEST_P(Golden, MatchesTheReference) {
  match_reference(Sharing::automatic, GetParam().name);
}

TEST_P(Golden, MatchesItWithMeshesShared) {
  match_reference(Sharing::always, GetParam().name + ".shared");
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden, testing::ValuesIn(load_cases()),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace vernier::golden
