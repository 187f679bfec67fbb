#include "gltf_file.h"

namespace vernier {
namespace {

std::string word(std::uint32_t value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

/// A GLB of `file` whose header says `extra` bytes more than there are.
std::string glb_of(GltfFile& file, std::uint32_t extra = 0) {
  file.json["buffers"] = {{{"byteLength", file.buffer.size()}}};
  std::string json = file.text();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string chunks = word(std::uint32_t(json.size())) + "JSON" + json +
                             word(std::uint32_t(file.buffer.size())) + std::string("BIN\0", 4) + file.buffer;
  return "glTF" + word(2) + word(std::uint32_t(chunks.size()) + 12 + extra) + chunks;
}

TEST(GltfDocument, reads_a_data_uri) {
  GltfFile file;
  add_triangle(file);
  const Scene scene = file.load();
  ASSERT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.meshes[0].positions[1], glm::vec3(1, 0, 0));
  EXPECT_EQ(scene.meshes[0].triangles[0], glm::uvec3(0, 1, 2));
  EXPECT_TRUE(scene.warnings.empty());
}

TEST(GltfDocument, reads_a_percent_encoded_path_beside_the_file_longer_than_promised) {
  GltfFile file;
  add_triangle(file);
  file.json["buffers"] = {{{"byteLength", file.buffer.size()}, {"uri", "a%20b/%C3%A4.bin"}}};
  file.folder.write("a b/ä.bin", file.buffer + "more");
  EXPECT_EQ(file.load().meshes[0].positions[2], glm::vec3(0, 1, 0));
}

TEST(GltfDocument, reads_a_binary_file) {
  GltfFile file;
  add_triangle(file);
  const Scene scene = finish(open_gltf(file.folder.write("test.GLB", glb_of(file)), {}));
  EXPECT_EQ(scene.meshes[0].positions[1], glm::vec3(1, 0, 0));
}

TEST(GltfDocument, refuses_broken_binary_files) {
  GltfFile file;
  add_triangle(file);
  const std::string good = glb_of(file);
  const auto load = [&](const std::string& bytes) { open_gltf(file.folder.write("test.glb", bytes), {}); };
  expect_refused([&] { load("glTX" + good.substr(4)); }, "does not begin with glTF");
  expect_refused([&] { load(good.substr(0, 15)); }, "ends within the GLB header");
  expect_refused([&] { load(good.substr(0, good.size() - 4)); }, "promises");
  expect_refused([&] { load(good.substr(0, 4) + word(1) + good.substr(8)); }, "GLB version 1");
  expect_refused([&] { load(good.substr(0, 12) + word(0xFFFFFFF0u) + good.substr(16)); }, "goes beyond the end");
  expect_refused([&] { load(good.substr(0, 16) + "BIN " + good.substr(20)); }, "must be JSON");
  expect_refused([&] { load(""); }, "does not begin with glTF");
}

TEST(GltfDocument, refuses_what_is_not_gltf_2) {
  GltfFile file;
  const auto load = [&](const std::string& text) { open_gltf(file.folder.write("test.gltf", text), {}); };
  expect_refused([&] { load(""); }, "not valid JSON");
  expect_refused([&] { load("{\"asset\": "); }, "not valid JSON");
  expect_refused([&] { load("[1]"); }, "not an object");
  expect_refused([&] { load("{}"); }, "no asset");
  expect_refused([&] { load(R"({"asset": {"version": "1.0"}})"); }, "version 1.0");
  expect_refused([&] { load(R"({"asset": {"version": "2.0", "minVersion": "2.1"}})"); }, "2.1");
  expect_refused([&] { load(R"({"asset": {"version": "2.0"}})"); }, "no triangles");
  expect_refused([&] { load(std::string(100000, '[')); }, "nested deeper");
  expect_refused([&] { open_gltf("test.missing.gltf", {}); }, "does not exist");
}

TEST(GltfDocument, refuses_missing_and_short_buffers) {
  GltfFile file;
  add_triangle(file);
  file.json["buffers"] = {{{"byteLength", 36}, {"uri", "gone.bin"}}};
  expect_refused(file, "buffer 0: gone.bin: the file does not exist");
  file.folder.write("gone.bin", "short");
  expect_refused(file, "gone.bin has 5 bytes, byteLength promises 36");
  file.json["buffers"] = {{{"byteLength", 36}, {"uri", "DATA:;Base64,$$$$"}}};
  expect_refused(file, "base64");
  file.json["buffers"] = {{{"byteLength", 36}}};
  expect_refused(file, "buffer 0, which has no bytes");
  file.json["buffers"] = {{{"uri", "gone.bin"}}};
  expect_refused(file, "byteLength is missing");
}

struct BrokenReference {
  const char* pointer;
  int value;
  const char* message;
};

class GltfReferences : public testing::TestWithParam<BrokenReference> {};

TEST_P(GltfReferences, are_checked) {
  GltfFile file;
  add_triangle(file);
  file.add("materials", {{"pbrMetallicRoughness", nlohmann::json::object()}});
  file.add("scenes", {{"nodes", {0}}});
  file.add("skins", {{"joints", {0}}});
  file.add("textures", {{"name", "t"}});
  file.json["images"] = {{{"name", "i"}}};
  ASSERT_NO_THROW(file.load());
  file.json[nlohmann::json::json_pointer(GetParam().pointer)] = GetParam().value;
  expect_refused(file, GetParam().message);
}

TEST(GltfDocument, numbers_are_numbers) {
  const auto refusal = [](const std::string& pointer, const nlohmann::json& value, const std::string& message) {
    GltfFile file;
    add_triangle(file);
    file.add("materials", {{"pbrMetallicRoughness", nlohmann::json::object()}});
    ASSERT_NO_THROW(file.load());
    file.json[nlohmann::json::json_pointer(pointer)] = value;
    expect_refused(file, message);
  };
  refusal("/nodes/0/translation", "abc", "node 0: translation is \"abc\", not a list of numbers");
  refusal("/nodes/0/scale", {1, "2", 3}, "node 0: scale is [1,\"2\",3], not a list of numbers");
  refusal("/materials/0/pbrMetallicRoughness/metallicFactor", true, "material 0: metallicFactor is true");
  refusal("/scenes", {{{"nodes", {0, nullptr}}}}, "scene 0: nodes is [0,null], not a list of whole numbers from 0");
  refusal("/nodes/0/children", 1, "node 0: children is 1, not a list of whole numbers from 0");
  refusal("/nodes/0/mesh", nlohmann::json::array(), "node 0: mesh is [], not a whole number from 0");
  refusal("/meshes/0/primitives", nlohmann::json::object(), "mesh 0: primitives is {}, not a list of objects");
  refusal("/meshes/0/primitives/0/attributes/POSITION", "0", "mesh 0: POSITION is \"0\", not a whole number from 0");
  refusal("/materials/0/pbrMetallicRoughness", 1, "material 0: pbrMetallicRoughness is 1, not an object");
  refusal("/materials/0/emissiveFactor", 1, "material 0: emissiveFactor is 1, not a list of 3 numbers");
  refusal("/accessors/0/sparse", {{"count", 4294967297}}, "accessor 0: count is 4294967297, not a number below 2^31");
}

TEST(GltfDocument, members_of_extensions_have_their_types) {
  const auto refusal = [](const std::string& owner, const nlohmann::json& extensions, const std::string& message) {
    GltfFile file;
    add_triangle(file);
    file.add("materials", {{"name", "m"}});
    file.json[nlohmann::json::json_pointer(owner + "/extensions")] = extensions;
    expect_refused(file, message);
  };
  refusal("/materials/0", {{"KHR_materials_ior", 1.5}}, "material 0: KHR_materials_ior is 1.5, not an object");
  refusal("/materials/0", {{"KHR_materials_ior", {{"ior", "1.5"}}}}, "material 0: ior is \"1.5\", not a number");
  refusal("/materials/0", {{"KHR_materials_volume", {{"attenuationColor", {1, 1}}}}},
          "material 0: attenuationColor is [1,1], not a list of 3 numbers");
  refusal("/materials/0", {{"KHR_materials_pbrSpecularGlossiness", {{"specularFactor", 1}}}},
          "material 0: specularFactor is 1, not a list of 3 numbers");
  refusal("/materials/0", {{"KHR_materials_specular", {{"specularFactor", {1, 1, 1}}}}},
          "material 0: specularFactor is [1,1,1], not a number");
  refusal("/materials/0", {{"KHR_materials_specular", {{"specularTexture", {{"index", 0.5}}}}}},
          "material 0: index is 0.5, not a whole number from 0");
  refusal("/nodes/0", {{"KHR_node_visibility", {{"visible", 0}}}}, "node 0: visible is 0, not true or false");
  refusal("/nodes/0", {{"KHR_lights_punctual", {{"light", "0"}}}}, "node 0: light is \"0\", not a whole number");
  refusal("", {{"KHR_lights_punctual", {{"lights", 1}}}}, "lights is 1, not a list of objects");
  refusal("", {{"KHR_lights_punctual", {{"lights", {{{"type", 5}}}}}}}, "light 0: type is 5, not a text");
  refusal("", {{"KHR_lights_punctual", {{"lights", {{{"type", "point"}, {"intensity", "1"}}}}}}},
          "light 0: intensity is \"1\", not a number");
}

TEST(GltfDocument, members_that_have_to_be_there_are) {
  const auto refusal = [](const std::string& pointer, const nlohmann::json& value, const std::string& message) {
    GltfFile file;
    add_triangle(file);
    file.add("materials", {{"name", "m"}});
    file.json[nlohmann::json::json_pointer(pointer)] = value;
    expect_refused(file, message);
  };
  using Json = nlohmann::json;
  refusal("/accessors/0", {{"count", 3}, {"type", "VEC3"}}, "accessor 0: componentType is missing");
  refusal("/accessors/0/componentType", 5000, "accessor 0: componentType is 5000, which glTF does not have");
  refusal("/accessors/0/type", "VEC5", "accessor 0: type is \"VEC5\", which glTF does not have");
  refusal("/accessors/0/sparse", {{"count", 1}, {"indices", Json::object()}, {"values", Json::object()}},
          "accessor 0, indices: bufferView is missing");
  refusal("/bufferViews/0/byteStride", 13, "bufferView 0: byteStride is 13, no multiple of 4");
  refusal("/cameras/0", {{"type", "perspective"}}, "camera 0: perspective is missing");
  refusal("/cameras/0", {{"type", "perspective"}, {"perspective", {{"yfov", 1}}}},
          "camera 0, perspective: znear is missing");
  refusal("/cameras/0", {{"type", "fisheye"}}, "camera 0: type is \"fisheye\"");
  refusal("/skins/0", Json::object(), "skin 0: joints is missing");
  refusal("/meshes/0/primitives/0", Json::object(), "mesh 0, primitive 0: attributes is missing");
  refusal("/materials/0/normalTexture", {{"scale", 1}}, "material 0, normalTexture: index is missing");
  refusal("/materials/0/extensions/KHR_materials_specular", {{"specularTexture", Json::object()}},
          "material 0, specularTexture: index is missing");
  refusal("/materials/0/extensions", Json::array({1}), "material 0: extensions is [1], not an object");
  refusal("/materials/0/alphaMode", 3, "material 0: alphaMode is 3, not a text");
  refusal("/nodes/0/extensions/KHR_lights_punctual", Json::object(), "node 0, KHR_lights_punctual: light is missing");
  refusal("/extensions/KHR_lights_punctual", {{"lights", {{{"type", "spot"}}}}}, "light 0: spot is missing");
}

TEST(GltfDocument, members_that_nobody_reads_may_be_anything) {
  GltfFile file;
  add_triangle(file);
  file.json["materials"] = {{{"doubleSided", 1}, {"extensions", nlohmann::json::array()}}};
  file.json["lights"] = {{{"lumen", 1}}};
  file.json["extensions"]["EXT_other"] = {{"cameras", {{{"lens", 1}}}}, {"values", {{"a", 1}}}};
  EXPECT_NO_THROW(file.load());
}

TEST(GltfDocument, takes_minus_zero_as_an_index) {
  GltfFile file;
  add_triangle(file);
  std::string text = file.text();
  const std::size_t mesh = text.find("\"mesh\":0");
  ASSERT_NE(mesh, std::string::npos);
  text.replace(mesh, 8, "\"mesh\":-0");
  EXPECT_EQ(load_scene(file.folder.write("minus.gltf", text), {}).meshes.size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(
    All, GltfReferences,
    testing::Values(BrokenReference{"/nodes/0/mesh", 1, "node 0: mesh 1 does not exist, the file has 1"},
                    BrokenReference{"/nodes/0/mesh", -2, "node 0: mesh is -2"},
                    BrokenReference{"/nodes/0/mesh", -1, "node 0: mesh is -1, not a whole number from 0"},
                    BrokenReference{"/meshes/0/primitives/0/indices", -1, "mesh 0: indices is -1"},
                    BrokenReference{"/accessors/0/byteOffset", -4, "accessor 0: byteOffset is -4"},
                    BrokenReference{"/bufferViews/0/byteOffset", -1, "bufferView 0: byteOffset is -1"},
                    BrokenReference{"/nodes/0/camera", 0, "node 0: camera 0"},
                    BrokenReference{"/nodes/0/skin", 7, "node 0: skin 7"},
                    BrokenReference{"/nodes/0/children/0", 9, "node 0: node 9"},
                    BrokenReference{"/nodes/0/extensions/KHR_lights_punctual/light", 0, "node 0: light 0"},
                    BrokenReference{"/scenes/0/nodes/0", 5, "scene 0: node 5"},
                    BrokenReference{"/scene", 3, "scene 3 does not exist"},
                    BrokenReference{"/skins/0/joints/0", 4, "skin 0: node 4"},
                    BrokenReference{"/skins/0/inverseBindMatrices", 4, "skin 0: accessor 4"},
                    BrokenReference{"/meshes/0/primitives/0/material", 2, "mesh 0, primitive 0: material 2"},
                    BrokenReference{"/meshes/0/primitives/0/mode", 7, "mode 7 does not exist"},
                    BrokenReference{"/meshes/0/primitives/0/attributes/NORMAL", 8, "NORMAL: accessor 8"},
                    BrokenReference{"/accessors/0/bufferView", 1, "accessor 0: bufferView 1"},
                    BrokenReference{"/bufferViews/0/buffer", 1, "bufferView 0: buffer 1"},
                    BrokenReference{"/bufferViews/0/byteLength", 1000, "bufferView 0 goes beyond"},
                    BrokenReference{"/textures/0/source", 1, "texture 0: image 1"},
                    BrokenReference{"/textures/0/sampler", 0, "texture 0: sampler 0"},
                    BrokenReference{"/images/0/bufferView", 3, "image 0: bufferView 3"},
                    BrokenReference{"/materials/0/normalTexture/index", 1, "material 0: texture 1"}));

TEST(GltfDocument, takes_whole_numbers_with_a_point_as_indices) {
  GltfFile file;
  add_triangle(file);
  file.json["nodes"][0]["mesh"] = 0.0;
  EXPECT_EQ(file.load().instances.size(), 1u);
}

TEST(GltfDocument, refuses_unknown_required_extensions) {
  GltfFile file;
  add_triangle(file);
  file.json["extensionsRequired"] = {"KHR_texture_basisu"};
  expect_refused(file, "extensionsRequired: KHR_texture_basisu is not supported");
  file.json["extensionsRequired"] = "KHR_texture_basisu";
  expect_refused(file, "extensionsRequired: is no list of names");
  file.json["extensionsRequired"] = {1};
  expect_refused(file, "extensionsRequired: is no list of names");
}

TEST(GltfDocument, warns_once_of_ignored_extensions_and_refuses_them_when_strict) {
  GltfFile file;
  add_triangle(file);
  file.add("materials", {{"extensions", {{"KHR_materials_clearcoat", {{"clearcoatFactor", 1}}}}}});
  file.add("materials", {{"extensions", {{"KHR_materials_clearcoat", nlohmann::json::object()}}}});
  file.json["extensionsUsed"] = {"KHR_materials_clearcoat", "EXT_other", "KHR_mesh_quantization"};
  const Scene scene = file.load();
  EXPECT_EQ(scene.warnings, (std::vector<std::string>{"material 0: extension KHR_materials_clearcoat is ignored",
                                                      "extensionsUsed: extension EXT_other is ignored"}));
  expect_refused([&] { file.load(true); }, "material 0: extension KHR_materials_clearcoat");
}

TEST(GltfDocument, ignores_animations_with_one_warning_even_when_strict) {
  GltfFile file;
  add_triangle(file);
  file.json["animations"] = {{{"channels", nlohmann::json::array()}}, {{"channels", nlohmann::json::array()}}};
  EXPECT_EQ(file.load(true).warnings, (std::vector<std::string>{"animations: ignored, the default pose is shown"}));
}

}  // namespace
}  // namespace vernier
