#include "image/cost_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "image/display_picture.h"
#include "image/error_colors.h"
#include "image/srgb_curve.h"

namespace vernier {
namespace {

Layer cost_layer(const std::vector<float>& nodes) {
  std::vector<float> values;
  for (const float node_count : nodes) values.insert(values.end(), {1.0f, node_count, 2.0f});
  return {"cost", {"rays", "nodes", "triangles"}, values};
}

TEST(CostSteps, are_node_visits_and_triangle_tests) {
  EXPECT_EQ(cost_steps(cost_layer({10.0f, 0.5f})), (std::vector<double>{12.0, 2.5}));
  EXPECT_TRUE(cost_steps(cost_layer({})).empty());
}

TEST(CostScale, a_hundredth_of_the_pixels_may_be_above) {
  std::vector<double> steps(1000);
  std::iota(steps.begin(), steps.end(), 1.0);
  EXPECT_EQ(cost_scale(steps), 990.0) << "the 990th of 1000";
  steps[3] = 1e9;
  EXPECT_EQ(cost_scale(steps), 991.0) << "one that took very long leaves the rest as it was";
  EXPECT_EQ(cost_scale({}), 1.0);
  EXPECT_EQ(cost_scale({0.0, 0.0}), 1.0) << "nothing to divide by";
  EXPECT_TRUE(std::isfinite(cost_scale({NAN, 5.0})));
}

TEST(CostPicture, more_steps_are_never_darker) {
  std::vector<float> nodes(200);
  std::iota(nodes.begin(), nodes.end(), 0.0f);
  const Image picture = cost_picture(cost_layer(nodes), 200, 1);
  ASSERT_EQ(picture.values.size(), 600u);
  double before = -1.0;
  for (std::size_t pixel = 0; pixel < 200; ++pixel) {
    const float* code = picture.values.data() + 3 * pixel;
    const double luminance =
        0.2126 * linear_from_srgb(code[0]) + 0.7152 * linear_from_srgb(code[1]) + 0.0722 * linear_from_srgb(code[2]);
    EXPECT_GE(luminance, before) << pixel;
    before = luminance;
  }
}

TEST(CostPicture, is_what_display_images_show_of_the_cost_layer) {
  const Layer layer = cost_layer({0.0f, 40.0f, 80.0f, 7.0f});
  ASSERT_EQ(layer_meaning(layer), LayerMeaning::cost);
  const Image picture = display_picture(layer, 2, 2, {});
  EXPECT_EQ(picture.values, cost_picture(layer, 2, 2).values);
  // 4 pixels: the scale is the third smallest, 42 steps; what is above shows the palest colour too.
  EXPECT_EQ(picture.values[3], picture.values[6]);
  EXPECT_FLOAT_EQ(picture.values[6], static_cast<float>(srgb_from_linear(error_color(1.0f)[0])));
}

TEST(CostPicture, formats_of_floats_keep_the_numbers) {
  EXPECT_EQ(unsigned_picture(cost_layer({40.0f}), 1, 1).values, (std::vector<float>{1.0f, 40.0f, 2.0f}));
}

}  // namespace
}  // namespace vernier
