#pragma once

#include <gtest/gtest.h>

#include "device_test.h"
#include "render/render_image.h"
#include "verify/image_scenes.h"

namespace vernier::golden {

/// Scenes put together by hand whose picture is known in closed form.
class AnalyticScene : public DeviceTest {
 protected:
  /// The colours of one sample at each pixel centre, [height][width][4].
  std::vector<float> render(RenderSettings settings) const {
    settings.spp = settings.sample_end = 1;
    RenderResult result = render_image(device(), scene_, camera_, settings, {});
    EXPECT_EQ(result.statistics.non_finite_pixels, 0u);
    EXPECT_EQ(result.statistics.stack_overflows, 0u);
    return std::get<std::vector<float>>(result.image.layers.at(0).values);
  }

  /// A camera at `eye` that looks along -Z.
  void look_from(const glm::dvec3& eye, double vertical_fov) {
    camera_.world_from_camera[3] = glm::dvec4(eye, 1.0);
    camera_.vertical_fov = vertical_fov;
  }

  Scene scene_;
  Camera camera_;
};

}  // namespace vernier::golden
