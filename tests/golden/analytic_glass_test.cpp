#include <cmath>

#include "analytic_scene.h"

namespace vernier::golden {
namespace {

// Unpolarised Fresnel reflectance from outside (Born and Wolf 1999, Principles of Optics, section 1.5.2).
double fresnel(double cosine, double ior) {
  const double inside = std::sqrt(1.0 - (1.0 - cosine * cosine) / (ior * ior));
  const double s = (cosine - ior * inside) / (cosine + ior * inside);
  const double p = (ior * cosine - inside) / (ior * cosine + inside);
  return (s * s + p * p) / 2.0;
}

class Slab : public AnalyticScene {};

// The colour behind the slab tells the place the ray arrives at: red grows with x across a linear ramp. Snell says how
// far a slab of thickness d moves the ray: d (tan a - tan b), sin b = sin a / n. One transmission path is left by
// max_bounces = 2: through, through; a reflection inside would need a third bounce.
TEST_F(Slab, ShiftsTheRayAsSnellSays) {
  constexpr double kThickness = 0.5, kIor = 1.5, kFar = -2.0, kHalf = 4.0;
  add_rectangle(scene_, {-9, -9, -0.25f}, {18, 0, 0}, {0, 18, 0}, clear_glass(kIor));
  add_rectangle(scene_, {-9, -9, -0.75f}, {0, 18, 0}, {18, 0, 0}, clear_glass(kIor));
  Material ramp;
  ramp.unlit = true;
  add_rectangle(scene_, {-kHalf, -9, kFar}, {2 * kHalf, 0, 0}, {0, 18, 0}, ramp);
  scene_.meshes.back().colors = {{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 0, 0, 1}, {0, 0, 0, 1}};
  look_from({0, 0, 0}, 1.5707963267948966);
  RenderSettings settings;
  settings.width = 65;
  settings.height = 1;
  settings.cutoff = 0.0f;
  settings.max_bounces = 2;
  camera_.vertical_fov = 2.0 * std::atan(1.0 / 65.0);  // nx a t = nx
  const std::vector<float> colors = render(settings);
  for (int pixel = 0; pixel < settings.width; ++pixel) {
    const double slope = 2.0 * (pixel + 0.5) / settings.width - 1.0;  // tan a
    const double sine = slope / std::sqrt(1.0 + slope * slope) / kIor;
    const double arrival = slope * (-kFar - kThickness) + kThickness * sine / std::sqrt(1.0 - sine * sine);
    const double through = 1.0 - fresnel(1.0 / std::sqrt(1.0 + slope * slope), kIor);
    const double expected = through * through * (arrival + kHalf) / (2.0 * kHalf);
    EXPECT_NEAR(colors[4 * pixel], expected, 2e-6) << "pixel " << pixel;  // 30 roundings of 2^-24 of 1
  }
}

class Furnace : public AnalyticScene {
 protected:
  void add_cube(const Material& material) {
    for (int axis = 0; axis < 3; ++axis) {
      glm::vec3 u(0.0f), v(0.0f), corner(-1.0f);
      u[(axis + 1) % 3] = v[(axis + 2) % 3] = 2.0f;
      add_rectangle(scene_, corner, v, u, material);
      corner[axis] = 1.0f;
      add_rectangle(scene_, corner, u, v, material);
    }
  }
};

// Lossless glass in a white world is invisible, but for what max_bounces cuts off. Nearly straight through two parallel
// faces of reflectance R = 0.04 and T = 1 - R, depth n lets n - 2 reflections inside end in an exit:
// R + T^2 (1 + R + ... + R^(n-2)) = 1 - T R^(n-1).
TEST_F(Furnace, ClearCubeVanishesInAWhiteWorld) {
  add_cube(clear_glass(1.5f));
  scene_.environment.sky = scene_.environment.ground = glm::vec3(1.0f);
  scene_.environment.has_ambient_override = true;
  look_from({0.125, 0.0625, 3}, 0.25);
  RenderSettings settings;
  settings.width = settings.height = 9;
  settings.cutoff = 0.0f;
  for (const std::uint32_t depth : {2u, 3u, 4u, 8u}) {
    settings.max_bounces = depth;
    const std::vector<float> colors = render(settings);
    for (int pixel = 0; pixel < 81; ++pixel) {
      const double lost = 1.0 - colors[4 * pixel];
      const double expected = 0.96 * std::pow(0.04, depth - 1.0);
      // At up to 10 degrees R changes by less than 0.1 %, its third power by less than 1 %; then roundings of 1.
      EXPECT_NEAR(lost, expected, 0.01 * expected + 0x1p-20) << "depth " << depth << ", pixel " << pixel;
    }
  }
}

// What a surface does not mirror it shows diffusely or lets through, whatever its metal, roughness and transmission.
TEST_F(Furnace, NoWhiteSheetIsSeenInAWhiteWorld) {
  scene_.environment.sky = scene_.environment.ground = scene_.environment.ambient = glm::vec3(1.0f);
  scene_.environment.has_ambient_override = true;
  look_from({0, 0, 3}, 0.02);  // straight on: at grazing incidence more is mirrored than diffuse light is told of
  RenderSettings settings;
  settings.width = settings.height = 3;
  settings.cutoff = 0.0f;
  add_rectangle(scene_, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, Material{});
  for (const float metallic : {0.0f, 0.5f, 1.0f}) {
    for (const float transmission : {0.0f, 0.25f, 1.0f}) {
      for (const float roughness : {0.0f, 0.5f, 1.0f}) {
        for (const float strength : {0.0f, 1.0f}) {
          Material& material = scene_.materials.back();
          material.base_color = glm::vec4(1.0f);
          material.metallic = metallic;
          material.roughness = roughness;
          material.transmission = glm::vec3(transmission);
          material.specular_strength = strength;
          material.thin_walled = true;
          // A dozen roundings of 1.
          EXPECT_NEAR(render(settings).at(0), 1.0, 12 * 0x1p-24)
              << metallic << " metal, " << transmission << " clear, " << roughness << " rough, " << strength;
        }
      }
    }
  }
}

/// A thin sheet of KHR_materials_transmission seen straight on, before what it lets through and opposite what it
/// mirrors.
class Sheet : public AnalyticScene {
 protected:
  /// The colours of the sheet where all that is white is `behind` it, or in front.
  glm::vec3 color(const Material& material, bool behind) {
    scene_ = Scene();
    Material wall;
    wall.unlit = true;
    wall.base_color = glm::vec4(glm::vec3(behind ? 1.0f : 0.0f), 1.0f);
    add_rectangle(scene_, {-9, -9, -1}, {18, 0, 0}, {0, 18, 0}, wall);
    add_rectangle(scene_, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, material);
    scene_.environment.sky = scene_.environment.ground = glm::vec3(behind ? 0.0f : 1.0f);
    scene_.environment.has_ambient_override = true;
    look_from({0, 0, 3}, 0.02);
    RenderSettings settings;
    settings.width = settings.height = 1;
    settings.cutoff = 0.0f;
    const std::vector<float> colors = render(settings);
    return {colors[0], colors[1], colors[2]};
  }

  void expect_colors(const Material& material, const glm::vec3& mirrored, const glm::vec3& through) {
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(color(material, false)[i], mirrored[i], 12 * 0x1p-24) << i;  // a dozen roundings of 1
      EXPECT_NEAR(color(material, true)[i], through[i], 12 * 0x1p-24) << i;
    }
  }

  static Material sheet() {
    Material material;
    material.base_color = glm::vec4(1.0f);
    material.metallic = 0.0f;
    material.roughness = 0.0f;
    material.transmission = glm::vec3(1.0f);
    material.thin_walled = true;
    return material;
  }
};

// "The ratio of transmission and reflection computed from the Fresnel term also depends on dielectric_f0 and
// dielectric_f90": KHR_materials_specular, Interaction with other extensions.
TEST_F(Sheet, MirrorsAndTransmitsBySpecularToo) {
  Material material = sheet();
  expect_colors(material, glm::vec3(0.04f), glm::vec3(0.96f));
  material.specular_strength = 0.5f;
  expect_colors(material, glm::vec3(0.02f), glm::vec3(0.98f));
  material.specular_strength = 0.0f;
  expect_colors(material, glm::vec3(0.0f), glm::vec3(1.0f));
  material.specular_strength = 1.0f;
  material.specular = {0.0f, 1.0f, 2.0f};
  expect_colors(material, {0.0f, 0.04f, 0.08f}, glm::vec3(0.92f));
}

// Metal mirrors in its colour however much of the rest is glass: glTF 2.0, appendix B.3.5, mixes the two.
TEST_F(Sheet, OfMetalMirrorsAsMetal) {
  Material material = sheet();
  material.base_color = {0.9f, 0.6f, 0.3f, 1.0f};
  for (const float metallic : {0.5f, 0.99f, 1.0f}) {
    material.metallic = metallic;
    const glm::vec3 base(material.base_color);
    expect_colors(material, glm::mix(glm::vec3(0.04f), base, metallic), base * (1.0f - metallic) * 0.96f);
  }
}

}  // namespace
}  // namespace vernier::golden
