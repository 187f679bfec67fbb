#include <cmath>

#include "gltf_file.h"

namespace vernier {
namespace {

void expect_near(const glm::dvec3& actual, const glm::dvec3& expected) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], expected[c], 1e-6);
}

glm::dvec3 placed(const Instance& instance, const glm::dvec3& point) {
  return glm::dvec3(instance.world_from_object * glm::dvec4(point, 1.0));
}

TEST(GltfNodes, multiply_translation_rotation_and_scale_down_the_tree) {
  GltfFile file;
  add_triangle(file);
  const double half = std::sqrt(0.5);  // a quarter turn about z: x to y
  file.json["nodes"] = {{{"translation", {10, 0, 0}}, {"children", {1}}},
                        {{"rotation", {0, 0, half, half}}, {"scale", {2, -3, 1}}, {"mesh", 0}}};
  const Scene scene = file.load();
  expect_near(placed(scene.instances[0], {1, 0, 0}), {10, 2, 0});
  expect_near(placed(scene.instances[0], {0, 1, 0}), {13, 0, 0});
}

TEST(GltfNodes, read_matrices_column_by_column) {
  GltfFile file;
  add_triangle(file);
  file.json["nodes"][0]["matrix"] = {1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 10, 0, 11, 12, 13, 1};
  expect_near(placed(file.load().instances[0], {1, 0, 0}), {12, 14, 16});
  for (int i : {3, 7, 11, 15}) file.json["nodes"][0]["matrix"][i] = i == 15 ? 2.0 : 0.0;
  expect_near(placed(file.load().instances[0], {1, 0, 0}), {6, 7, 8});  // a point is its homogeneous one divided by w
  file.json["nodes"][0]["matrix"][15] = 0;
  expect_refused(file, "node 0: its matrix is not affine");
  file.json["nodes"][0]["matrix"][15] = 1;
  file.json["nodes"][0]["matrix"][3] = 0.5;
  expect_refused(file, "node 0: its matrix is not affine");
  file.json["nodes"][0]["matrix"] = {1, 2};
  expect_refused(file, "node 0: matrix has 2 numbers, not 16");
}

TEST(GltfNodes, number_objects_depth_first_in_the_default_scene_only) {
  GltfFile file;
  add_triangle(file);
  file.json["nodes"] = {{{"mesh", 0}, {"name", "d"}},
                        {{"mesh", 0}, {"name", "a"}, {"children", {2, 3}}},
                        {{"mesh", 0}, {"name", "b"}, {"children", {4}}},
                        {{"mesh", 0}, {"name", "e"}},
                        {{"mesh", 0}, {"name", "c"}}};
  const auto names = [&] {
    std::string all;
    for (const Instance& instance : file.load().instances) all += instance.name;
    return all;
  };
  EXPECT_EQ(names(), "dabce") << "without scenes all roots are shown";
  file.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1, 0}}}};
  EXPECT_EQ(names(), "d") << "without a default scene the first is shown";
  file.json["scene"] = 1;
  EXPECT_EQ(names(), "abced");
  EXPECT_EQ(file.load().meshes.size(), 1u) << "the mesh is shared";
}

TEST(GltfNodes, that_are_hidden_hide_what_is_below) {
  GltfFile file;
  add_triangle(file);
  const auto visibility = [](const nlohmann::json& value) {
    return nlohmann::json{{"KHR_node_visibility", {{"visible", value}}}};
  };
  file.json["nodes"] = {{{"mesh", 0}, {"name", "a"}, {"children", {1}}, {"extensions", visibility(false)}},
                        {{"mesh", 0}, {"name", "b"}, {"camera", 0}, {"extensions", visibility(true)}},
                        {{"mesh", 0}, {"name", "c"}, {"extensions", visibility(true)}},
                        {{"mesh", 0}, {"name", "d"}, {"extensions", visibility(nullptr)}}};
  file.json["extensionsUsed"] = {"KHR_node_visibility"};
  file.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}}};
  const Scene scene = file.load();
  ASSERT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(scene.instances[0].name + scene.instances[1].name, "cd");
  EXPECT_EQ(scene.cameras.size(), 1u) << "cameras are seen by nobody anyway";
  EXPECT_TRUE(scene.warnings.empty());
}

TEST(GltfNodes, refuse_cycles_and_second_parents) {
  GltfFile file;
  add_triangle(file);
  file.json["nodes"] = {{{"mesh", 0}}, {{"children", {2}}}, {{"children", {1}}}};
  expect_refused(file, "node 1: it is its own ancestor");
  file.json["nodes"] = {{{"mesh", 0}}, {{"children", {0}}}, {{"children", {0}}}};
  expect_refused(file, "node 0: it is a child of node 1 and of node 2");
  file.json["nodes"] = {{{"mesh", 0}, {"children", {0}}}};
  expect_refused(file, "node 0: it is its own ancestor");
  file.json["nodes"] = {{{"mesh", 0}}};
  file.json["scenes"] = {{{"nodes", {0, 0}}}};
  expect_refused(file, "node 0: the scene reaches it twice");
}

TEST(GltfNodes, go_down_a_hundred_thousand_levels) {
  GltfFile file;
  add_triangle(file);
  constexpr int kDepth = 100000;
  file.json["nodes"] = "NODES";
  std::string nodes = "[";
  for (int i = 1; i < kDepth; ++i) nodes += R"({"translation": [1, 0, 0], "children": [)" + std::to_string(i) + "]},";
  nodes += R"({"mesh": 0}])";
  std::string text = file.text();
  text.replace(text.find("\"NODES\""), 7, nodes);
  const Scene scene = finish(open_gltf(file.folder.write("test.gltf", text), {}));
  expect_near(placed(scene.instances[0], {0, 0, 0}), {kDepth - 1, 0, 0});
}

TEST(GltfNodes, instances_that_the_file_has_no_bytes_for_are_few) {
  GltfFile file;
  add_triangle(file);
  const int ids = file.add("accessors", {{"componentType", kUnsignedByte}, {"type", "SCALAR"}, {"count", 1 << 21}});
  file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"_ID", ids}};
  expect_refused(file, "accessors without bufferView ask for more than 268435456 bytes");
}

TEST(GltfNodes, instance_by_the_gpu_instancing_extension) {
  GltfFile file;
  add_triangle(file);
  const int translation = file.vec3({0, 0, 0, 5, 0, 0});
  const int rotation = file.accessor(std::vector<std::int8_t>{0, 0, 0, 127, 0, 0, 127, 0}, "VEC4", kByte, 4, true);
  const int scale = file.vec3({1, 1, 1, 2, 2, 2});
  file.json["nodes"][0]["translation"] = {0, 0, 1};
  file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
      {"TRANSLATION", translation}, {"ROTATION", rotation}, {"SCALE", scale}};
  const Scene scene = file.load();
  ASSERT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(scene.instances[1].mesh, 0u);
  expect_near(placed(scene.instances[0], {1, 0, 0}), {1, 0, 1});
  expect_near(placed(scene.instances[1], {1, 0, 0}), {3, 0, 1});
  file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["SCALE"] = 0;
  expect_refused(file, "its attributes have different counts");
}

TEST(GltfNodes, instances_may_have_attributes_of_others_alone) {
  GltfFile file;
  add_triangle(file);
  const int ids = file.accessor(std::vector<float>{1, 2}, "SCALAR", 5126, 1);
  file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"_ID", ids}};
  EXPECT_EQ(file.load().instances.size(), 2u);
  file.json["accessors"][static_cast<std::size_t>(ids)]["count"] = 20'000'000;
  expect_refused(file, "20000000 elements need");
}

TEST(GltfCameras, are_rigid_and_ordered_by_their_number) {
  GltfFile file;
  add_triangle(file);
  file.json["cameras"] = {
      {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 2.5}, {"zfar", 10}, {"znear", 0}}}},
      {{"type", "perspective"}, {"name", "eye"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}}};
  file.add("nodes", {{"camera", 1}, {"translation", {1, 2, 3}}, {"scale", {2, 3, -4}}});
  file.add("nodes", {{"camera", 0}, {"name", "top"}});
  const Scene scene = file.load();
  ASSERT_EQ(scene.cameras.size(), 2u);
  EXPECT_TRUE(scene.cameras[0].orthographic);
  EXPECT_EQ(scene.cameras[0].name, "top");
  EXPECT_EQ(scene.cameras[0].half_height, 2.5);
  EXPECT_EQ(scene.cameras[1].name, "eye");
  EXPECT_EQ(scene.cameras[1].vertical_fov, 0.5);
  const glm::dmat4& world = scene.cameras[1].world_from_camera;
  expect_near(glm::dvec3(world[2]), {0, 0, -1});
  expect_near(glm::dvec3(world[1]), {0, 1, 0});
  expect_near(glm::dvec3(world[0]), {-1, 0, 0});
  expect_near(glm::dvec3(world[3]), {1, 2, 3});
  file.json["cameras"][1]["perspective"]["yfov"] = 4;
  expect_refused(file, "camera 1: yfov 4.000000 is not between 0 and pi");
}

TEST(GltfLights, read_all_kinds_in_node_order) {
  GltfFile file;
  add_triangle(file);
  const double half = std::sqrt(0.5);
  file.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "directional"}, {"color", {1, 0.5, 0}}, {"intensity", 4}},
      {{"type", "point"}, {"range", 7}, {"name", "bulb"}},
      {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.5}}}}};
  const auto light_node = [](int light) {
    return nlohmann::json{{"extensions", {{"KHR_lights_punctual", {{"light", light}}}}},
                          {"translation", {0, 8, 0}},
                          {"scale", {3, 3, 3}}};
  };
  file.add("nodes", light_node(1));
  file.add("nodes", light_node(2));
  file.add("nodes", light_node(0));
  file.json["nodes"][3]["rotation"] = {-half, 0, 0, half};  // a quarter turn about x: -z to -y
  const Scene scene = file.load();
  ASSERT_EQ(scene.lights.size(), 3u);
  EXPECT_EQ(scene.lights[0].kind, LightKind::point);
  EXPECT_EQ(scene.lights[0].name, "bulb");
  EXPECT_EQ(scene.lights[0].range, 7.0);
  expect_near(scene.lights[0].position, {0, 8, 0});
  EXPECT_EQ(scene.lights[1].kind, LightKind::spot);
  EXPECT_EQ(scene.lights[1].inner_cone_angle, 0.25);
  EXPECT_EQ(scene.lights[1].outer_cone_angle, 0.5);
  EXPECT_TRUE(std::isinf(scene.lights[1].range));
  expect_near(scene.lights[1].direction, {0, 0, -1});
  EXPECT_EQ(scene.lights[2].kind, LightKind::directional);
  EXPECT_EQ(scene.lights[2].intensity, glm::vec3(4, 2, 0));
  expect_near(scene.lights[2].direction, {0, -1, 0});
  auto& spot = file.json["extensions"]["KHR_lights_punctual"]["lights"][2]["spot"];
  spot = {{"innerConeAngle", 0.5}, {"outerConeAngle", 0.5}};
  EXPECT_EQ(file.load().lights[1].inner_cone_angle, 0.5) << "a sharp edge";
  spot = {{"innerConeAngle", 1.5707964}, {"outerConeAngle", 1.5707964}};
  EXPECT_TRUE(file.load().warnings.empty()) << "pi / 2 as float";
  spot["outerConeAngle"] = 0.1;
  expect_refused(file, "light 2: cone angles");
}

}  // namespace
}  // namespace vernier
