#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

#include "gltf_file.h"

namespace vernier {
namespace {

// Two triangles of a unit square.
const std::vector<glm::vec3> kSquare = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const std::vector<std::uint32_t> kSquareIndices = {0, 1, 2, 0, 2, 3};

std::string draco_square() {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(2);
  const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  for (std::uint32_t f = 0; f < 2; ++f) {
    builder.SetAttributeValuesForFace(position, draco::FaceIndex(f), &kSquare[kSquareIndices[3 * f]],
                                      &kSquare[kSquareIndices[3 * f + 1]], &kSquare[kSquareIndices[3 * f + 2]]);
  }
  const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
  draco::Encoder encoder;
  draco::EncoderBuffer buffer;
  encoder.EncodeMeshToBuffer(*mesh, &buffer);
  return {buffer.data(), buffer.size()};
}

/// The square as Draco data only: its accessors have no bufferView.
void add_draco_square(GltfFile& file, const std::string& data) {
  file.add("accessors", {{"componentType", kFloat}, {"type", "VEC3"}, {"count", 4}});
  file.add("accessors", {{"componentType", kUnsignedShort}, {"type", "SCALAR"}, {"count", 6}});
  file.add(
      "meshes",
      {{"primitives",
        {{{"attributes", {{"POSITION", 0}}},
          {"indices", 1},
          {"extensions",
           {{"KHR_draco_mesh_compression", {{"bufferView", file.view(data)}, {"attributes", {{"POSITION", 0}}}}}}}}}}});
  file.add("nodes", {{"mesh", 0}});
  file.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
}

/// The two triangles as corners: vertex order is up to the encoder.
float area_of(const Mesh& mesh) {
  float area = 0.0f;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::vec3 e1 = mesh.positions[t.y] - mesh.positions[t.x];
    const glm::vec3 e2 = mesh.positions[t.z] - mesh.positions[t.x];
    area += glm::cross(e1, e2).z / 2.0f;
  }
  return area;
}

TEST(GltfDraco, decodes_a_primitive_without_uncompressed_data) {
  GltfFile file;
  add_draco_square(file, draco_square());
  const Mesh mesh = file.load().meshes[0];
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_NEAR(area_of(mesh), 1.0f, 1e-5f);
}

TEST(GltfDraco, refuses_broken_data_and_missing_attributes) {
  GltfFile broken;
  add_draco_square(broken, draco_square().substr(0, 20));
  expect_refused(broken, "mesh 0, primitive 0, Draco: the data cannot be decoded");
  GltfFile missing;
  add_draco_square(missing, draco_square());
  auto& extension = missing.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"];
  extension["attributes"]["POSITION"] = 9;
  expect_refused(missing, "POSITION: the data has no attribute 9");
  extension["bufferView"] = 5;
  expect_refused(missing, "bufferView 5 does not exist");
}

/// A bufferView of the fallback buffer 1 whose compressed form is `data` in buffer 0.
int add_meshopt_view(GltfFile& file, const std::string& data, const char* mode, std::size_t count, std::size_t stride,
                     const char* filter = "NONE") {
  const nlohmann::json compressed = file.json["bufferViews"][std::size_t(file.view(data))];
  nlohmann::json view = {{"buffer", 1}, {"byteLength", count * stride}};
  view["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                   {"byteOffset", compressed["byteOffset"]},
                                                   {"byteLength", data.size()},
                                                   {"mode", mode},
                                                   {"filter", filter},
                                                   {"count", count},
                                                   {"byteStride", stride}};
  if (std::string(mode) == "ATTRIBUTES") view["byteStride"] = stride;
  file.json["bufferViews"].back() = view;
  return int(file.json["bufferViews"].size()) - 1;
}

std::string encoded_vertices(const void* vertices, std::size_t count, std::size_t stride) {
  std::string data(meshopt_encodeVertexBufferBound(count, stride), '\0');
  data.resize(
      meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(data.data()), data.size(), vertices, count, stride));
  return data;
}

void add_meshopt_square(GltfFile& file, const char* mode) {
  const int positions =
      add_meshopt_view(file, encoded_vertices(kSquare.data(), kSquare.size(), 12), "ATTRIBUTES", kSquare.size(), 12);
  std::string data(1024, '\0');
  auto* bytes = reinterpret_cast<unsigned char*>(data.data());
  data.resize(std::string(mode) == "TRIANGLES" ? meshopt_encodeIndexBuffer(bytes, 1024, kSquareIndices.data(), 6)
                                               : meshopt_encodeIndexSequence(bytes, 1024, kSquareIndices.data(), 6));
  const int indices = add_meshopt_view(file, data, mode, 6, 2);
  file.add("accessors", {{"bufferView", positions}, {"componentType", kFloat}, {"type", "VEC3"}, {"count", 4}});
  file.add("accessors", {{"bufferView", indices}, {"componentType", kUnsignedShort}, {"type", "SCALAR"}, {"count", 6}});
  file.add("meshes", {{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}});
  file.add("nodes", {{"mesh", 0}});
  file.json["buffers"] = {{{"byteLength", file.buffer.size()}, {"uri", "data:;base64," + base64(file.buffer)}},
                          {{"byteLength", 1000}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
}

TEST(GltfMeshopt, decodes_views_of_a_fallback_buffer_without_bytes) {
  for (const char* mode : {"TRIANGLES", "INDICES"}) {
    GltfFile file;
    add_meshopt_square(file, mode);
    const Mesh mesh = file.load().meshes[0];
    EXPECT_EQ(mesh.positions, kSquare);
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(area_of(mesh), 1.0f) << mode;
  }
}

TEST(GltfMeshopt, applies_the_octahedral_filter) {
  GltfFile file;
  add_meshopt_square(file, "INDICES");
  const std::vector<float> normals = {0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  std::vector<std::int8_t> filtered(16);
  meshopt_encodeFilterOct(filtered.data(), 4, 4, 8, normals.data());
  const int view = add_meshopt_view(file, encoded_vertices(filtered.data(), 4, 4), "ATTRIBUTES", 4, 4, "OCTAHEDRAL");
  const int accessor =
      file.add("accessors",
               {{"bufferView", view}, {"componentType", kByte}, {"normalized", true}, {"type", "VEC3"}, {"count", 4}});
  file.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = accessor;
  file.json["buffers"][0] = {{"byteLength", file.buffer.size()}, {"uri", "data:;base64," + base64(file.buffer)}};
  const Mesh mesh = file.load().meshes[0];
  for (int v = 0; v < 4; ++v) {
    const auto n = static_cast<std::size_t>(v) * 4;
    EXPECT_GT(glm::dot(mesh.normals[std::size_t(v)], glm::vec3(normals[n], normals[n + 1], normals[n + 2])), 0.999f);
  }
}

TEST(GltfMeshopt, refuses_broken_parameters_and_data) {
  GltfFile file;
  add_meshopt_square(file, "TRIANGLES");
  auto& extension = file.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"];
  const nlohmann::json good = extension;
  const auto expect_message = [&](const char* member, const nlohmann::json& value, const char* message) {
    extension = good;
    extension[member] = value;
    expect_refused(file, message);
  };
  expect_message("buffer", 2, "bufferView 0, EXT_meshopt_compression: buffer 2 does not exist");
  expect_message("byteLength", 100000, "its bytes go beyond buffer 0");
  expect_message("byteOffset", -4, "its bytes go beyond buffer 0");
  expect_message("count", 2000000000, "cannot decode to 24000000000");
  expect_message("byteLength", 8, "the data cannot be decoded");
  expect_message("byteStride", 13, "do not go with count and byteStride");
  expect_message("mode", "OTHER", "mode OTHER");
  expect_message("filter", "OCTAHEDRAL", "filter OCTAHEDRAL");
  extension = good;
  file.json["bufferViews"][0].erase("extensions");
  expect_refused(file, "bufferView 0 reads buffer 1, which has no bytes");
}

}  // namespace
}  // namespace vernier
