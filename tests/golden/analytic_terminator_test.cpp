#include <algorithm>

#include "analytic_scene.h"

namespace vernier::golden {
namespace {

class SheetLitFromBehind : public AnalyticScene {
 protected:
  // A tilted sheet with the normal of its triangles at each corner and a normal map that leans along u all over.
  void SetUp() override {
    AnalyticScene::SetUp();
    scene_.textures.push_back(
        {"leaning", {}, std::make_shared<Texels>(Texels{TEXTURE_FORMAT_LINEAR8, 1, 1, {0xffbe80e6u}})});
    Material material = matte(glm::vec3(1.0f));
    material.textures[TEXTURE_SLOT_NORMAL].texture = 0;
    const glm::vec3 u(2.0f, 0.3f, 0.17f), v(-0.2f, 1.6f, 0.45f);
    normal_ = glm::normalize(glm::cross(u, v));
    along_ = glm::normalize(u);
    add_rectangle(scene_, {-0.9f, -0.95f, -0.3f}, u, v, material);
    scene_.meshes.back().normals.assign(4, normal_);
    look_from({0, 0, 4}, 0.6);
  }

  // The largest colour where the light falls along the sheet, `height` above it.
  float brightest(float height, Accuracy accuracy) {
    Light sun;
    sun.kind = LightKind::directional;
    sun.direction = -glm::normalize(glm::dvec3(along_ + normal_ * height));
    scene_.lights = {sun};
    RenderSettings settings;
    settings.width = settings.height = 96;
    settings.accuracy = accuracy;
    std::vector<float> colors = render(settings);
    for (std::size_t alpha = 3; alpha < colors.size(); alpha += 4) colors[alpha] = 0.0f;
    return *std::ranges::max_element(colors);
  }

  glm::vec3 normal_, along_;
};

// The normal map turns to the light, and rounding leaves the corners' normals a hair beside the triangles': neither
// lets light through.
TEST_F(SheetLitFromBehind, IsBlack) {
  for (const Accuracy accuracy : {Accuracy::robust, Accuracy::exact}) {
    EXPECT_GT(brightest(0.3f, accuracy), 0.1f) << "from before it is lit";
    EXPECT_EQ(brightest(-0.3f, accuracy), 0.0f);
    EXPECT_EQ(brightest(-0.02f, accuracy), 0.0f);
  }
}

}  // namespace
}  // namespace vernier::golden
