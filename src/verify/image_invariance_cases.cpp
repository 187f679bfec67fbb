#include <algorithm>
#include <cmath>

#include "scene/validate_scene.h"
#include "verify/image_cases.h"
#include "verify/picture.h"

namespace vernier {
namespace {

constexpr int kSide = 64;

void book_same(Tally& tally, const Picture& picture, const Picture& other) {
  book_pixels(tally, picture, [&](std::size_t pixel) { return same_bits(picture, other, pixel); });
}

/// The part `area` of `picture`.
Picture cut_out(const Picture& picture, const PixelRect& area) {
  const auto& colors = std::get<std::vector<float>>(picture.layers.front().values);
  std::vector<float> part;
  for (int y = area.y; y < area.y + area.height; ++y) {
    const auto first = colors.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * picture.width + area.x);
    part.insert(part.end(), first, first + 4 * static_cast<std::ptrdiff_t>(area.width));
  }
  Picture cut = picture;
  cut.width = area.width;
  cut.height = area.height;
  cut.layers = {{"", picture.layers.front().channels, std::move(part)}};
  return cut;
}

/// `made`, everything in it `scale` times as large and far; a power of two. The light arrives the same.
ImageScene scaled(ImageScene made, double scale) {
  for (Instance& instance : made.scene.instances) {
    instance.world_from_object = scaling(glm::dvec3(scale)) * instance.world_from_object;
  }
  for (Light& light : made.scene.lights) {
    light.position *= scale;
    light.intensity *= static_cast<float>(scale * scale);
  }
  for (Material& material : made.scene.materials) material.absorption /= static_cast<float>(scale);
  made.camera.world_from_camera[3] = glm::dvec4(glm::dvec3(made.camera.world_from_camera[3]) * scale, 1.0);
  return made;
}

}  // namespace

CaseResult run_image_order(const CaseSetup& setup) {
  constexpr const char* kName = "image_order";
  constexpr std::uint32_t kSamples = 4;
  Tally tally;
  for_each_picture(setup, kName, kSide, 4, [&](SampleRandom& random, std::uint64_t number) {
    const ImageScene made = mixed_scene(random);
    RenderSettings settings = picture_settings(setup, kSide);
    settings.spp = settings.sample_end = kSamples;
    settings.seed = random.below(1u << 16);
    Picture picture = render_picture(setup, made, settings);
    picture.number = number;
    RenderSettings other = settings;
    other.tile = {8 + static_cast<int>(random.below(kSide - 8)), 8 + static_cast<int>(random.below(kSide - 8))};
    other.dispatch_ms = 2.0;
    book_same(tally, picture, render_picture(setup, made, other));
    const PixelRect crop{static_cast<int>(random.below(kSide / 2)), static_cast<int>(random.below(kSide / 2)),
                         kSide / 2 - 1, kSide / 2 - 3};
    other.crop = crop;
    book_same(tally, cut_out(picture, crop), render_picture(setup, made, other));
  });
  return tally.result();
}

CaseResult run_image_scale(const CaseSetup& setup) {
  constexpr const char* kName = "image_scale";
  // Lights of 16 candela times 4^60 are still floats, and of 4^-60 normal ones.
  constexpr int kMostExponent = 60;
  Tally tally;
  for_each_picture(setup, kName, kSide, 8, [&](SampleRandom& random, std::uint64_t number) {
    ImageScene made = mixed_scene(random);
    for (Material& material : made.scene.materials) material.absorption = glm::vec3(0.5f, 0.25f, 0.125f);
    RenderSettings settings = picture_settings(setup, kSide);
    Picture picture = render_picture(setup, made, settings);
    picture.number = number;
    const int exponent = static_cast<int>(random.below(2 * kMostExponent + 1)) - kMostExponent;
    book_same(tally, picture, render_picture(setup, scaled(made, std::ldexp(1.0, exponent)), settings));
  });
  return tally.result();
}

CaseResult run_singular_transform(const CaseSetup& setup) {
  constexpr const char* kName = "singular_transform";
  constexpr std::size_t kSingular = 6;
  Tally tally;
  for_each_picture(setup, kName, kSide, 4, [&](SampleRandom& random, std::uint64_t number) {
    const ImageScene sound = mixed_scene(random);
    ImageScene sick = sound;
    const VerifyMesh mesh = triangle_soup(8, 0.5, random);
    glm::dmat4 projective(1.0);
    projective[0].w = 0.5;
    // A plane, a line, a point, a plane but for 1e-30, one of NaN, one that is not affine.
    const glm::dmat4 turn = rotation(random);
    for (const glm::dmat4& transform :
         {turn * scaling({1.0, 0.0, 1.0}), turn * scaling({0.0, 0.0, 1.0}), scaling(glm::dvec3(0.0)),
          turn * scaling({1.0, 1.0, 1e-30}), scaling({1.0, std::nan(""), 1.0}), projective}) {
      add_object(sick.scene, mesh, matte(glm::vec3(1.0f)), transform);
    }
    validate_scene(sick.scene);
    const bool told =
        sick.scene.instances.size() == sound.scene.instances.size() && sick.scene.warnings.size() == 1 &&
        sick.scene.warnings[0].find("and " + std::to_string(kSingular - 1) + " more") != std::string::npos;
    const RenderSettings settings = picture_settings(setup, kSide);
    Picture picture = render_picture(setup, sick, settings);
    picture.number = number;
    const Picture without = render_picture(setup, sound, settings);
    book_pixels(tally, picture, [&](std::size_t pixel) { return told && same_bits(picture, without, pixel); });
  });
  return tally.result();
}

}  // namespace vernier
