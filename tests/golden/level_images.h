#pragma once

#include <vector>

#include "golden_case.h"
#include "render/render_image.h"

namespace vernier::golden {

inline constexpr int kLevelWidth = 72;
inline constexpr int kLevelHeight = 40;

/// Scenes whose pictures are made by refraction and reflection.
inline std::vector<GoldenCase> level_scenes() {
  std::vector<GoldenCase> scenes;
  for (const GoldenCase& scene : load_cases()) {
    if (scene.name == "glass_ball" || scene.name == "nested_glass" || scene.name == "mirror_pair")
      scenes.push_back(scene);
  }
  return scenes;
}

/// The case's picture at a numeric level, a sample per pixel, with object_id and primitive_id.
inline ImageFile image_at(const Device& device, const CaseSetup& setup, Accuracy accuracy) {
  RenderSettings settings = setup.settings;
  settings.width = kLevelWidth;
  settings.height = kLevelHeight;
  settings.spp = settings.sample_end = 1;
  settings.accuracy = accuracy;
  settings.aovs = {"object_id", "primitive_id"};
  return render_image(device, setup.scene.scene, setup.scene.camera, settings, {}).image;
}

/// Its colours, four floats a pixel.
inline const std::vector<float>& color_of(const ImageFile& image) {
  return std::get<std::vector<float>>(image.layers.at(0).values);
}

}  // namespace vernier::golden
