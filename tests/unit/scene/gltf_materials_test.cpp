#include <cmath>

#include "gltf_file.h"

namespace vernier {
namespace {

/// A BMP of one texel, red 0x10, green 0x20, blue 0x30: readers go by the content, not by the type named.
const std::string kBmp = std::string("BM\x3a\0\0\0\0\0\0\0\x36\0\0\0", 14) +
                         std::string("\x28\0\0\0\x01\0\0\0\x01\0\0\0\x01\0\x18\0\0\0\0\0\x04\0\0\0", 24) +
                         std::string(16, '\0') + std::string("\x30\x20\x10\0", 4);
const std::string kPixel = "data:image/png;base64," + base64(kBmp);

Material load_material(const nlohmann::json& material) {
  GltfFile file;
  add_triangle(file);
  file.add("materials", material);
  for (int i = 0; i < 2; ++i) file.add("textures", {{"source", 0}});
  file.json["images"] = {{{"uri", kPixel}}};
  file.json["meshes"][0]["primitives"][0]["material"] = 0;
  return file.load().materials[0];
}

Material load_extension(const char* name, const nlohmann::json& value) {
  return load_material({{"extensions", {{name, value}}}});
}

TEST(GltfMaterials, have_the_defaults_of_the_format) {
  const Material material = load_material(nlohmann::json::object());
  EXPECT_EQ(material.workflow, Workflow::metallic_roughness);
  EXPECT_EQ(material.base_color, glm::vec4(1));
  EXPECT_EQ(material.metallic, 1.0f);
  EXPECT_EQ(material.roughness, 1.0f);
  EXPECT_EQ(material.emission, glm::vec3(0));
  EXPECT_EQ(material.alpha_mode, AlphaMode::opaque);
  EXPECT_EQ(material.alpha_cutoff, 0.5f);
  EXPECT_EQ(material.ior, 1.5f);
  EXPECT_EQ(material.specular, glm::vec3(1));
  EXPECT_EQ(material.specular_strength, 1.0f);
  EXPECT_EQ(material.transmission, glm::vec3(0));
  EXPECT_TRUE(material.thin_walled);
  EXPECT_FALSE(material.double_sided || material.unlit);
  for (const TextureUse& use : material.textures) EXPECT_EQ(use.texture, -1);
}

TEST(GltfMaterials, read_the_core_factors) {
  const Material material = load_material(
      {{"name", "m"},
       {"doubleSided", true},
       {"alphaMode", "MASK"},
       {"alphaCutoff", 0.25},
       {"emissiveFactor", {1, 0.5, 0}},
       {"normalTexture", {{"index", 0}, {"scale", 2}}},
       {"occlusionTexture", {{"index", 0}, {"strength", 0.5}}},
       {"pbrMetallicRoughness",
        {{"baseColorFactor", {0.25, 0.5, 0.75, 0.125}}, {"metallicFactor", 0.5}, {"roughnessFactor", 0.25}}}});
  EXPECT_EQ(material.name, "m");
  EXPECT_EQ(material.base_color, glm::vec4(0.25f, 0.5f, 0.75f, 0.125f));
  EXPECT_EQ(material.metallic, 0.5f);
  EXPECT_EQ(material.roughness, 0.25f);
  EXPECT_EQ(material.emission, glm::vec3(1, 0.5f, 0));
  EXPECT_EQ(material.normal_scale, 2.0f);
  EXPECT_EQ(material.occlusion_strength, 0.5f);
  EXPECT_EQ(material.alpha_mode, AlphaMode::mask);
  EXPECT_EQ(material.alpha_cutoff, 0.25f);
  EXPECT_TRUE(material.double_sided);
  EXPECT_EQ(load_material({{"alphaMode", "BLEND"}}).alpha_mode, AlphaMode::blend);
  EXPECT_THROW(load_material({{"alphaMode", "HALF"}}), Error);
}

TEST(GltfMaterials, read_ior) {
  EXPECT_EQ(load_extension("KHR_materials_ior", {{"ior", 1.25}}).ior, 1.25f);
  EXPECT_EQ(load_extension("KHR_materials_ior", {{"ior", 0}}).ior, 1e6f) << "0 means infinite";
  EXPECT_EQ(load_extension("KHR_materials_ior", {{"ior", 0.5}}).ior, 1.5f);
}

TEST(GltfMaterials, read_transmission_and_volume) {
  EXPECT_EQ(load_extension("KHR_materials_transmission", {{"transmissionFactor", 0.75}}).transmission,
            glm::vec3(0.75f));
  const Material thin = load_extension("KHR_materials_volume", {{"thicknessFactor", 0}});
  EXPECT_TRUE(thin.thin_walled);
  EXPECT_EQ(thin.absorption, glm::vec3(0));
  const Material thick =
      load_extension("KHR_materials_volume",
                     {{"thicknessFactor", 0.5}, {"attenuationDistance", 2}, {"attenuationColor", {1, 0.25, 0}}});
  EXPECT_FALSE(thick.thin_walled);
  EXPECT_EQ(thick.absorption.x, 0.0f);
  EXPECT_FLOAT_EQ(thick.absorption.y, 0.6931472f);  // ln 4 / 2
  EXPECT_FLOAT_EQ(thick.absorption.z, 6.9314718f);  // ln 2^20 / 2
}

TEST(GltfMaterials, keep_specular_colour_and_strength_apart) {
  const Material material =
      load_extension("KHR_materials_specular", {{"specularFactor", 0.5}, {"specularColorFactor", {1, 2, 0.25}}});
  EXPECT_EQ(material.specular, glm::vec3(1, 2, 0.25f));
  EXPECT_EQ(material.specular_strength, 0.5f);
}

TEST(GltfMaterials, multiply_emissive_strength_in) {
  const Material material =
      load_material({{"emissiveFactor", {1, 0.5, 0}},
                     {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 20000000000.0}}}}}});
  EXPECT_EQ(material.emission, glm::vec3(2e10f, 1e10f, 0));
}

TEST(GltfMaterials, read_unlit) {
  EXPECT_TRUE(load_extension("KHR_materials_unlit", nlohmann::json::object()).unlit);
}

TEST(GltfMaterials, read_specular_glossiness_in_place_of_the_core) {
  const Material material = load_material({{"pbrMetallicRoughness", {{"baseColorFactor", {0, 0, 0, 0}}}},
                                           {"extensions",
                                            {{"KHR_materials_pbrSpecularGlossiness",
                                              {{"diffuseFactor", {0.5, 0.25, 0.125, 1}},
                                               {"specularFactor", {0.25, 0.5, 1}},
                                               {"glossinessFactor", 0.75},
                                               {"diffuseTexture", {{"index", 0}}},
                                               {"specularGlossinessTexture", {{"index", 1}}}}}}}});
  EXPECT_EQ(material.workflow, Workflow::specular_glossiness);
  EXPECT_EQ(material.base_color, glm::vec4(0.5f, 0.25f, 0.125f, 1));
  EXPECT_EQ(material.specular, glm::vec3(0.25f, 0.5f, 1));
  EXPECT_EQ(material.roughness, 0.25f);
  EXPECT_EQ(material.textures[TEXTURE_SLOT_BASE_COLOR].texture, 0);
  EXPECT_EQ(material.textures[TEXTURE_SLOT_SURFACE].texture, 1);
}

TEST(GltfMaterials, transform_uvs_and_override_the_set) {
  const nlohmann::json transform = {
      {"offset", {0.5, 0.25}}, {"rotation", std::acos(0.0)}, {"scale", {2, 3}}, {"texCoord", 1}};
  const Material material = load_material(
      {{"pbrMetallicRoughness",
        {{"baseColorTexture", {{"index", 0}, {"texCoord", 2}, {"extensions", {{"KHR_texture_transform", transform}}}}},
         {"metallicRoughnessTexture", {{"index", 0}, {"texCoord", 3}}}}}});
  const TextureUse& use = material.textures[TEXTURE_SLOT_BASE_COLOR];
  EXPECT_EQ(use.uv_set, 1u);
  // (1, 0) is scaled to (2, 0) and turned to (0, -2): counter-clockwise with v down. (0, 1) to (0, 3) to (3, 0).
  const glm::vec2 u = use.uv_from_vertex_uv * glm::vec3(1, 0, 1);
  const glm::vec2 v = use.uv_from_vertex_uv * glm::vec3(0, 1, 1);
  EXPECT_NEAR(u.x, 0.5f, 1e-6f);
  EXPECT_NEAR(u.y, -1.75f, 1e-6f);
  EXPECT_NEAR(v.x, 3.5f, 1e-6f);
  EXPECT_NEAR(v.y, 0.25f, 1e-6f);
  EXPECT_EQ(material.textures[TEXTURE_SLOT_SURFACE].uv_set, 3u);
  EXPECT_EQ(material.textures[TEXTURE_SLOT_SURFACE].uv_from_vertex_uv, glm::mat3x2(1, 0, 0, 1, 0, 0));
}

TEST(GltfTextures, are_decoded_by_use_and_shared) {
  GltfFile file;
  add_triangle(file);
  file.json["images"] = {{{"uri", kPixel}}};
  file.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}}};
  file.json["textures"] = {{{"source", 0}}, {{"source", 0}, {"sampler", 0}}};
  file.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                         {"emissiveTexture", {{"index", 1}}},
                         {"normalTexture", {{"index", 0}}}});
  const Scene scene = file.load();
  const auto texture_of = [&](int slot) {
    return scene.textures[std::size_t(scene.materials[0].textures[std::size_t(slot)].texture)];
  };
  ASSERT_EQ(scene.textures.size(), 3u);
  const Texture base = texture_of(TEXTURE_SLOT_BASE_COLOR);
  EXPECT_EQ(base.texels->format, TEXTURE_FORMAT_SRGB8);
  EXPECT_EQ(base.texels->words, (std::vector<std::uint32_t>{0xFF302010u}));
  EXPECT_EQ(base.sampler.wrap_u, TEXTURE_WRAP_REPEAT);
  EXPECT_EQ(base.sampler.filter, TEXTURE_FILTER_LINEAR);
  const Texture emission = texture_of(TEXTURE_SLOT_EMISSION);
  EXPECT_EQ(emission.texels, base.texels);
  EXPECT_EQ(emission.sampler.wrap_u, TEXTURE_WRAP_CLAMP);
  EXPECT_EQ(emission.sampler.wrap_v, TEXTURE_WRAP_MIRROR);
  EXPECT_EQ(emission.sampler.filter, TEXTURE_FILTER_NEAREST);
  EXPECT_EQ(texture_of(TEXTURE_SLOT_NORMAL).texels->format, TEXTURE_FORMAT_LINEAR8);
}

TEST(GltfTextures, of_one_file_are_decoded_once_whatever_image_names_it) {
  GltfFile file;
  add_triangle(file);
  file.folder.write("a.bmp", kBmp);
  file.json["images"] = {{{"uri", "a.bmp"}}, {{"uri", "a.bmp"}}};
  file.json["textures"] = {{{"source", 0}}, {{"source", 1}}};
  file.add("materials",
           {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}, {"emissiveTexture", {{"index", 1}}}});
  const Scene scene = file.load();
  ASSERT_EQ(scene.textures.size(), 2u);
  EXPECT_EQ(scene.textures[0].texels, scene.textures[1].texels);
}

TEST(GltfTextures, that_cannot_be_read_are_white_with_a_warning) {
  GltfFile file;
  add_triangle(file);
  file.json["images"] = {{{"uri", "gone.png"}}, {{"uri", "data:image/png;base64,AAAA"}}, {{"uri", kPixel}}};
  file.json["textures"] = {{{"source", 0}},
                           {{"source", 1}},
                           {{"extensions", {{"KHR_texture_basisu", {{"source", 1}}}}}},
                           {{"source", 2}, {"extensions", {{"KHR_texture_basisu", {{"source", 1}}}}}},
                           {{"source", 0}, {"extensions", {{"EXT_texture_webp", {{"source", 2}}}}}}};
  for (int i = 0; i < 5; ++i) file.add("materials", {{"emissiveTexture", {{"index", i}}}});
  const Scene scene = file.load();
  const auto texture = [&](std::size_t m) { return scene.materials[m].textures[TEXTURE_SLOT_EMISSION].texture; };
  EXPECT_EQ(texture(0), -1);
  EXPECT_EQ(texture(1), -1);
  EXPECT_EQ(texture(2), -1);
  EXPECT_GE(texture(3), 0) << "the fallback";
  EXPECT_GE(texture(4), 0) << "WebP is preferred to the plain source";
  EXPECT_EQ(scene.warnings.size(), 4u);
  EXPECT_TRUE(has_warning(scene, "texture 0, image 0 (gone.png): white is used instead"));
  EXPECT_TRUE(has_warning(scene, "texture 2: KHR_texture_basisu is not supported and no fallback image"));
  file.json["textures"][2] = file.json["textures"][3] = file.json["textures"][1];
  expect_refused([&] { file.load(true); }, "test.gltf: texture 0, image 0 (gone.png): ");
}

TEST(GltfTextures, of_a_uv_set_that_is_not_read_are_white_with_a_warning) {
  GltfFile file;
  add_triangle(file);
  file.json["images"] = {{{"uri", kPixel}}};
  file.json["textures"] = {{{"source", 0}}};
  file.add("materials", {{"emissiveTexture", {{"index", 0}, {"texCoord", 4}}}});
  const Scene scene = file.load();
  EXPECT_EQ(scene.materials[0].textures[TEXTURE_SLOT_EMISSION].texture, -1);
  EXPECT_TRUE(has_warning(scene, "material 0: texture 0 uses TEXCOORD_4"));
}

TEST(GltfTextures, are_read_from_a_buffer_view) {
  GltfFile file;
  add_triangle(file);
  file.json["images"] = {{{"bufferView", file.view(kBmp)}, {"mimeType", "image/png"}}};
  file.json["textures"] = {{{"source", 0}}};
  file.add("materials", {{"emissiveTexture", {{"index", 0}}}});
  const Scene scene = file.load();
  ASSERT_EQ(scene.textures.size(), 1u) << (scene.warnings.empty() ? "" : scene.warnings[0]);
  EXPECT_EQ(scene.textures[0].texels->words, (std::vector<std::uint32_t>{0xFF302010u}));
}

}  // namespace
}  // namespace vernier
