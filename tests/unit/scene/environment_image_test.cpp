#include "scene/environment_image.h"

#include <gtest/gtest.h>

#include "error.h"
#include "scene/texel_color.h"
#include "temporary_folder.h"

namespace vernier {
namespace {

TEST(EnvironmentImage, EightBitsBecomeLinearFloats) {
  const TemporaryFolder folder;
  Scene scene;
  scene.textures.resize(1);
  const int index = add_environment_image(
      scene, folder.write("sky.ppm", std::string("P6\n2 1\n255\n\xff\x80") + std::string(4, '\0')));
  EXPECT_EQ(index, 1);
  EXPECT_EQ(scene.environment.texture, 1);
  const Texture& texture = scene.textures[1];
  EXPECT_EQ(texture.sampler.wrap_u, TEXTURE_WRAP_REPEAT);
  EXPECT_EQ(texture.sampler.wrap_v, TEXTURE_WRAP_CLAMP);
  EXPECT_EQ(texture.texels->format, TEXTURE_FORMAT_FLOAT);
  const glm::vec4 color = texel_color(*texture.texels, 0);
  EXPECT_EQ(color.r, 1.0f);
  EXPECT_NEAR(color.g, 0.2158605f, 1e-6f);  // ((128 / 255 + 0.055) / 1.055)^2.4
  EXPECT_EQ(color.b, 0.0f);
}

TEST(EnvironmentImage, MissingFileIsRefused) {
  Scene scene;
  EXPECT_THROW(add_environment_image(scene, "/nonexistent/sky.hdr"), Error);
  EXPECT_EQ(scene.environment.texture, -1);
  EXPECT_TRUE(scene.textures.empty());
}

}  // namespace
}  // namespace vernier
