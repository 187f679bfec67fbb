// The driver's own tree in place of ours: the same bits, and rays that find nothing less.
#include "device_test.h"
#include "error.h"
#include "numerics/case_at_level.h"
#include "render/render_image.h"
#include "shader/tiny_scene.h"
#include "verify/verify_report.h"

namespace vernier {
namespace {

class RayQueryTest : public DeviceTest {
 protected:
  RenderResult rendered(const Scene& scene, const Camera& camera, RenderSettings settings, TraversalForm form) const {
    settings.traversal = form;
    return render_image(device(), scene, camera, settings, {});
  }
  void expect_same(const Scene& scene, const Camera& camera, const RenderSettings& settings) const {
    const RenderResult ours = rendered(scene, camera, settings, TraversalForm::automatic);
    const RenderResult driver = rendered(scene, camera, settings, TraversalForm::ray_query);
    ASSERT_EQ(driver.image.layers.size(), ours.image.layers.size());
    for (std::size_t layer = 0; layer < ours.image.layers.size(); ++layer) {
      EXPECT_EQ(driver.image.layers[layer].values, ours.image.layers[layer].values) << ours.image.layers[layer].name;
    }
    EXPECT_EQ(driver.statistics.rays.shadow, ours.statistics.rays.shadow);
    EXPECT_EQ(driver.statistics.bvh_nodes, 0u) << "a tree of ours was built for nothing";
  }
};

TEST_F(RayQueryTest, is_refused_in_one_line_where_the_driver_has_none) {
  const RenderSettings settings = test::small_image(8, 8, 1);
  try {
    rendered(test::tiny_scene(), test::camera_at(3.5), settings, TraversalForm::ray_query);
    EXPECT_TRUE(device().description().ray_query);
  } catch (const Error& error) {
    EXPECT_FALSE(device().description().ray_query) << error.what();
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_NE(std::string(error.what()).find("no ray queries"), std::string::npos) << error.what();
  }
}

TEST_F(RayQueryTest, draws_the_bits_of_our_own_tree) {
  RenderSettings settings = test::small_image(40, 24, 4);
  settings.aovs = {"depth", "primitive_id"};
  expect_same(test::tiny_scene(), test::camera_at(3.5), settings);
}

TEST_F(RayQueryTest, boxes_grow_with_the_distance_of_the_eye) {
  Camera camera = test::camera_at(3.0e4);
  camera.vertical_fov = 1e-4;
  expect_same(test::tiny_scene(), camera, test::small_image(40, 24, 2));
}

TEST_F(RayQueryTest, a_scene_without_triangles_is_background) {
  expect_same(Scene{}, test::camera_at(3.5), test::small_image(8, 8, 1));
}

/// Instances are copied, and equal triangles are found once, as by our tree.
TEST_F(RayQueryTest, instances_and_coincident_triangles_are_found_alike) {
  Scene scene = test::tiny_scene();
  for (int i = 0; i < 3; ++i) scene.instances.push_back(scene.instances[2]);
  for (int i = 0; i < 8; ++i) test::add_square(scene, 0.2f, 3.0f);
  expect_same(scene, test::camera_at(3.5), test::small_image(32, 32, 2));
}

/// Rays aimed at what boxes or triangles may lose, more than numerics_test takes.
class RayQueryCaseTest : public DeviceTest, public testing::WithParamInterface<CaseAtLevel> {};

TEST_P(RayQueryCaseTest, meets_its_target) {
  CaseSetup setup = setup_of(GetParam(), device(), 1u << 15);
  setup.traversal = TraversalForm::ray_query;
  const CaseReport report = run_case(*GetParam().verify_case, setup);
  EXPECT_EQ(report.result.not_run, "");
  EXPECT_TRUE(report.held) << report.verify_case->property << ": " << report.result.failures << " of "
                           << report.result.samples << ", first " << report.result.first_failure << "\n"
                           << report.result.worst_inputs;
}

std::vector<CaseAtLevel> ray_cases() {
  std::vector<CaseAtLevel> cases;
  for (const char* name :
       {"shared_edge",       "shared_vertex", "single_hit",          "far_mesh",          "needles",
        "tiny_mesh",         "self_hit",      "behind_origin",       "grazing",           "zero_component",
        "tiny_components",   "flat_boxes",    "box_corner",          "origin_on_surface", "t_limits",
        "invalid_rays",      "garbage_mesh",  "identical_centroids", "deep_tree",         "coplanar_duplicates",
        "instance_transform"}) {
    cases.push_back({find_case(name), Accuracy::robust});
  }
  for (const char* name : {"shared_edge", "shared_vertex", "single_hit", "deep_tree"})
    cases.push_back({find_case(name), Accuracy::exact});
  return cases;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, RayQueryCaseTest, testing::ValuesIn(ray_cases()),
                         [](const auto& one) { return name_of(one.param); });

}  // namespace
}  // namespace vernier
