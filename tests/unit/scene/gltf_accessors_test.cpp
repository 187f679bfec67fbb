#include "gltf_file.h"

namespace vernier {
namespace {

/// A triangle whose vertices have the extra attribute `name` in `accessor`.
Scene load_with(GltfFile& file, const char* name, int accessor) {
  file.json["meshes"][0]["primitives"][0]["attributes"][name] = accessor;
  return file.load();
}

TEST(GltfAccessors, read_every_component_type_of_colours) {
  const auto color_of = [](auto values, const char* type, int component_type, int components) {
    GltfFile file;
    add_triangle(file);
    const int accessor = file.accessor(values, type, component_type, components, component_type != kFloat);
    return load_with(file, "COLOR_0", accessor).meshes[0].colors[1];
  };
  EXPECT_EQ(color_of(std::vector<float>{0, 0, 0, 0.25f, 2, 3, 0, 0, 0}, "VEC3", kFloat, 3), glm::vec4(0.25f, 2, 3, 1));
  EXPECT_EQ(color_of(std::vector<float>{0, 0, 0, 0, 1, 2, 3, 0.5f, 0, 0, 0, 0}, "VEC4", kFloat, 4),
            glm::vec4(1, 2, 3, 0.5f));
  EXPECT_EQ(color_of(std::vector<std::uint8_t>{0, 0, 0, 0, 255, 51, 0, 102, 0, 0, 0, 0}, "VEC4", kUnsignedByte, 4),
            glm::vec4(1, 0.2f, 0, 0.4f));
  EXPECT_EQ(color_of(std::vector<std::uint16_t>{0, 0, 0, 65535, 13107, 0, 0, 0, 0}, "VEC3", kUnsignedShort, 3),
            glm::vec4(1, 0.2f, 0, 1));
}

TEST(GltfAccessors, read_signed_quantised_positions_and_normals) {
  GltfFile file;
  file.add("meshes", {{"primitives", nlohmann::json::array()}});
  file.add("nodes", {{"mesh", 0}});
  const std::vector<std::int16_t> positions = {-32768, 0, 0, 32767, 0, 0, 0, -7, 0};
  const std::vector<std::int8_t> normals = {-128, 0, 0, 0, 127, 0, 0, 0, -127};
  const int plain = file.accessor(positions, "VEC3", kShort, 3);
  const int normalised = file.accessor(positions, "VEC3", kShort, 3, true);
  const int normal = file.accessor(normals, "VEC3", kByte, 3, true);
  file.json["meshes"][0]["primitives"] = {{{"attributes", {{"POSITION", plain}, {"NORMAL", normal}}}},
                                          {{"attributes", {{"POSITION", normalised}}}}};
  const Mesh mesh = file.load().meshes[0];
  EXPECT_EQ(mesh.positions[0], glm::vec3(-32768, 0, 0));
  EXPECT_EQ(mesh.positions[2], glm::vec3(0, -7, 0));
  EXPECT_EQ(mesh.positions[3], glm::vec3(-1, 0, 0));
  EXPECT_EQ(mesh.positions[5], glm::vec3(0, -7.0f / 32767.0f, 0));
  EXPECT_EQ(mesh.normals[0], glm::vec3(-1, 0, 0));
  EXPECT_EQ(mesh.normals[2], glm::vec3(0, 0, -1));
  EXPECT_EQ(mesh.normals[3], glm::vec3(0)) << "the second primitive has none";
}

TEST(GltfAccessors, read_interleaved_attributes) {
  GltfFile file;
  add_triangle(file);
  const std::vector<float> vertices = {0, 0, 0, 9, 8, 2, 0, 0, 7, 6, 0, 2, 0, 5, 4};
  const int view = file.view(bytes_of(vertices));
  file.json["bufferViews"][view]["byteStride"] = 20;
  const int position =
      file.add("accessors", {{"bufferView", view}, {"componentType", kFloat}, {"type", "VEC3"}, {"count", 3}});
  const int uv =
      file.add("accessors",
               {{"bufferView", view}, {"byteOffset", 12}, {"componentType", kFloat}, {"type", "VEC2"}, {"count", 3}});
  file.json["meshes"][0]["primitives"][0]["attributes"] = {{"POSITION", position}, {"TEXCOORD_0", uv}};
  const Mesh mesh = file.load().meshes[0];
  EXPECT_EQ(mesh.positions[1], glm::vec3(2, 0, 0));
  EXPECT_EQ(mesh.uvs[0], (std::vector<glm::vec2>{{9, 8}, {7, 6}, {5, 4}}));
  file.json["accessors"][uv]["byteOffset"] = 16;
  expect_refused(file, "accessor 2: 3 elements need 48 bytes from byte 16 on, the bufferView has 60");
  file.json["accessors"][uv]["byteOffset"] = 12;
  file.json["bufferViews"][view]["byteStride"] = 4;
  expect_refused(file, "byteStride 4 is less than an element");
}

TEST(GltfAccessors, apply_sparse_values_over_a_view_and_over_zeros) {
  GltfFile file;
  add_triangle(file);
  const int indices = file.view(bytes_of(std::vector<std::uint8_t>{0, 2}));
  const int values = file.view(bytes_of(std::vector<float>{5, 5, 5, 7, 7, 7}));
  file.json["accessors"][0]["sparse"] = {{"count", 2},
                                         {"indices", {{"bufferView", indices}, {"componentType", kUnsignedByte}}},
                                         {"values", {{"bufferView", values}}}};
  EXPECT_EQ(file.load().meshes[0].positions, (std::vector<glm::vec3>{{5, 5, 5}, {1, 0, 0}, {7, 7, 7}}));
  file.json["accessors"][0].erase("bufferView");
  EXPECT_EQ(file.load().meshes[0].positions, (std::vector<glm::vec3>{{5, 5, 5}, {0, 0, 0}, {7, 7, 7}}));
  file.buffer[36 + 1] = 3;
  expect_refused(file, "sparse index 3 is beyond 3 elements");
}

TEST(GltfAccessors, refuse_huge_counts_before_allocating) {
  GltfFile file;
  add_triangle(file);
  file.json["accessors"][0]["count"] = std::uint64_t{1} << 62;
  expect_refused(file, "are more than");
  file.json["accessors"][0]["count"] = 100000000;
  expect_refused(file, "100000000 elements need 1200000000 bytes");
  file.json["accessors"][0].erase("bufferView");
  expect_refused(file, "are more than 67108864 bytes");
  file.json["accessors"][0]["bufferView"] = 0;
  file.json["accessors"][0]["count"] = 3;
  file.json["accessors"][0]["byteOffset"] = ~std::uint64_t{0};
  expect_refused(file, "the bufferView has 36");
}

TEST(GltfAccessors, refuse_types_that_do_not_fit) {
  GltfFile file;
  add_triangle(file);
  file.json["accessors"][0]["type"] = "VEC2";
  expect_refused(file, "mesh 0, primitive 0, POSITION: accessor 0: its elements must have 3 components");
  file.json["accessors"][0]["type"] = "VEC3";
  file.json["accessors"][0]["componentType"] = 5124;
  expect_refused(file, "component type 5124 does not exist");
  file.json["accessors"][0]["componentType"] = kUnsignedInt;
  expect_refused(file, "32-bit integers cannot be used here");
}

}  // namespace
}  // namespace vernier
