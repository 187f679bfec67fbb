#include "scene/environment_image.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "error.h"
#include "scene/texel_color.h"
#include "temporary_folder.h"

namespace vernier {
namespace {

TEST(EnvironmentImage, EightBitsBecomeLinearFloats) {
  const TemporaryFolder folder;
  Scene scene;
  scene.textures.push_back({"", {}, std::make_shared<const Texels>()});
  PendingImages images;
  const int index = add_environment_image(
      scene, images, folder.write("sky.ppm", std::string("P6\n2 1\n255\n\xff\x80") + std::string(4, '\0')));
  EXPECT_EQ(index, 1);
  images.finish(scene);
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
  PendingImages images;
  EXPECT_THROW(add_environment_image(scene, images, "/nonexistent/sky.hdr"), Error);
  EXPECT_EQ(scene.environment.texture, -1);
  EXPECT_TRUE(scene.textures.empty());
}

TEST(EnvironmentImage, BrokenFileIsRefused) {
  const TemporaryFolder folder;
  const std::string path = folder.write("sky.hdr", "#?RADIANCE\n");
  Scene scene;
  PendingImages images;
  add_environment_image(scene, images, path);
  try {
    images.finish(scene);
    ADD_FAILURE() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_EQ(std::string(error.what()).find(path + ": "), 0u) << error.what();
  }
}

}  // namespace
}  // namespace vernier
