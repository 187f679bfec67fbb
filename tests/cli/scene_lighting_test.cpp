#include <gtest/gtest.h>

#include "cli/scene_setup.h"
#include "unit_square.h"

namespace vernier {
namespace {

void light(Scene& scene, const Camera& camera, const SceneSettings& settings) {
  PendingImages images;
  set_lighting(scene, images, camera, settings);
}

TEST(SetLighting, LightsOfTheFileStay) {
  Scene scene = unit_square();
  scene.lights.resize(2);
  light(scene, Camera{}, SceneSettings{});
  EXPECT_EQ(scene.lights.size(), 2u);
  EXPECT_NE(scene.environment.sky, glm::vec3(0.0f)) << "metals have something to mirror";
}

TEST(SetLighting, BlackThatIsAskedForStaysBesideLights) {
  Scene scene = unit_square();
  scene.lights.resize(1);
  SceneSettings settings;
  settings.background_color = glm::vec3(0.0f);
  light(scene, Camera{}, settings);
  EXPECT_EQ(scene.environment.sky, glm::vec3(0.0f));
  EXPECT_EQ(scene.environment.ground, glm::vec3(0.0f));
}

TEST(SetLighting, LightsOfTheOptionReplaceThem) {
  Scene scene = unit_square();
  scene.lights.resize(2);
  SceneSettings settings;
  settings.lights.resize(1);
  settings.lights[0].name = "given";
  light(scene, Camera{}, settings);
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].name, "given");
}

TEST(SetLighting, LightsOfTheOptionBringTheDimEnvironmentToo) {
  Scene with_option = unit_square(), with_file = unit_square();
  with_file.lights.resize(1);
  light(with_file, Camera{}, SceneSettings{});
  SceneSettings settings;
  settings.lights.resize(1);
  light(with_option, Camera{}, settings);
  EXPECT_NE(with_option.environment.sky, glm::vec3(0.0f));
  EXPECT_EQ(with_option.environment.sky, with_file.environment.sky);
  EXPECT_EQ(with_option.environment.ground, with_file.environment.ground);
}

TEST(SetLighting, DefaultLightsWhereThereAreNone) {
  Scene scene = unit_square();
  light(scene, Camera{}, SceneSettings{});
  EXPECT_FALSE(scene.lights.empty());
  EXPECT_NE(scene.environment.sky, glm::vec3(0.0f));
}

TEST(SetLighting, BackgroundStaysBesideDefaultLights) {
  Scene scene = unit_square();
  SceneSettings settings;
  settings.background_color = glm::vec3(0.0f);
  light(scene, Camera{}, settings);
  EXPECT_FALSE(scene.lights.empty());
  EXPECT_EQ(scene.environment.sky, glm::vec3(0.0f)) << "black was asked for";
  EXPECT_EQ(scene.environment.ground, glm::vec3(0.0f));
}

TEST(SetLighting, AmbientOverridesTheBackground) {
  Scene scene = unit_square();
  SceneSettings settings;
  settings.background_color = glm::vec3(1.0f);
  settings.ambient = glm::vec3(0.25f);
  light(scene, Camera{}, settings);
  EXPECT_EQ(scene.environment.sky, glm::vec3(1.0f));
  EXPECT_TRUE(scene.environment.has_ambient_override);
  EXPECT_EQ(scene.environment.ambient, glm::vec3(0.25f));
}

}  // namespace
}  // namespace vernier
