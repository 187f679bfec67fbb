#include "scene/obj_materials.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "error.h"
#include "temporary_folder.h"

namespace vernier {
namespace {

Material material_of(const std::string& statements) {
  std::vector<std::string> warnings;
  return blinn_material(parse_mtl("newmtl m\n" + statements).materials.at(0), "m", warnings);
}

// Exactly what a PNM writer would make: 8 bits, `rgb` per pixel.
std::string ppm(int width, int height, const std::string& rgb) {
  return "P6\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n" + rgb;
}

TEST(ObjMaterials, IlluminationModels) {
  const std::string colors = "Kd 0.1 0.2 0.3\nKs 0.5 0.6 0.7\nNs 20\nNi 1.4\n";
  const Material unlit = material_of(colors + "illum 0");
  EXPECT_TRUE(unlit.unlit);
  EXPECT_EQ(unlit.base_color, glm::vec4(0.1f, 0.2f, 0.3f, 1.0f));
  EXPECT_EQ(material_of(colors + "illum 1").specular, glm::vec3(0.0f));
  const Material shiny = material_of(colors + "illum 2");
  EXPECT_EQ(shiny.specular, glm::vec3(0.5f, 0.6f, 0.7f));
  EXPECT_EQ(shiny.exponent, 20.0f);
  EXPECT_EQ(shiny.reflection, glm::vec3(0.0f));
  EXPECT_EQ(shiny.workflow, Workflow::blinn);
  for (const char* model : {"3", "5", "8"}) {
    const Material mirror = material_of(colors + "illum " + model);
    EXPECT_EQ(mirror.reflection, glm::vec3(0.5f, 0.6f, 0.7f));
    EXPECT_EQ(mirror.transmission, glm::vec3(0.0f));
    EXPECT_EQ(mirror.fresnel_reflection, *model == '5');
  }
  for (const char* model : {"4", "6", "7", "9"}) {
    const Material glass = material_of(colors + "illum " + model);
    EXPECT_EQ(glass.transmission, glm::vec3(1.0f));
    EXPECT_FALSE(glass.thin_walled);
    EXPECT_EQ(glass.ior, 1.4f);
    EXPECT_EQ(glass.fresnel_reflection, *model != '6');
  }
}

TEST(ObjMaterials, AnExponentOfZeroIsNoHighlight) {
  EXPECT_EQ(material_of("Ks 0.5 0.5 0.5\nNs 0\nillum 2").specular, glm::vec3(0.0f));
  const Material mirror = material_of("Ks 0.5 0.5 0.5\nNs 0\nillum 3");
  EXPECT_EQ(mirror.specular, glm::vec3(0.0f));
  EXPECT_EQ(mirror.reflection, glm::vec3(0.5f));
}

TEST(ObjMaterials, GlassModelsWithoutGlassAreOpaque) {
  for (const char* model : {"4", "9"}) {
    const std::string lines = std::string("Kd 0.5 0.5 0.5\nKs 0.5 0.5 0.5\nTf 1 1 1\nillum ") + model;
    for (const char* ior : {"", "\nNi 1.00", "\nNi 1.00\nd 1"}) {
      const Material opaque = material_of(lines + ior);
      EXPECT_EQ(opaque.transmission, glm::vec3(0.0f)) << model << ior;
      EXPECT_EQ(opaque.reflection, glm::vec3(0.0f));
      EXPECT_EQ(opaque.specular, glm::vec3(0.5f));
      EXPECT_EQ(opaque.alpha_mode, AlphaMode::opaque);
    }
    EXPECT_EQ(material_of(lines + "\nNi 1.5").transmission, glm::vec3(1.0f));
    EXPECT_EQ(material_of(lines + "\nd 0.1").transmission, glm::vec3(1.0f));
  }
  EXPECT_EQ(material_of("illum 7\nNi 1.00").transmission, glm::vec3(1.0f)) << "refraction on";
}

TEST(ObjMaterials, AbsentIlluminationFollowsTheHighlight) {
  EXPECT_EQ(material_of("Ks 1 1 1\nNs 5").specular, glm::vec3(1.0f));
  EXPECT_EQ(material_of("Ks 1 1 1").specular, glm::vec3(0.0f));
  EXPECT_FALSE(material_of("Kd 1 1 1").unlit);
}

TEST(ObjMaterials, AmbientColour) {
  EXPECT_EQ(material_of("Kd 0.5 0.25 0").ambient, glm::vec3(0.5f, 0.25f, 0.0f));
  EXPECT_EQ(material_of("Kd 0.5 0.25 0\nKa 1 1 1").ambient, glm::vec3(0.5f, 0.25f, 0.0f));
  EXPECT_EQ(material_of("Kd 0.5 0.25 0\nKa 0 0 0").ambient, glm::vec3(0.5f, 0.25f, 0.0f));
  EXPECT_EQ(material_of("Kd 0.5 0.25 0\nKa 0.01 0 0").ambient, glm::vec3(0.01f, 0.0f, 0.0f));
  EXPECT_EQ(material_of("Kd 0.5 0.25 0\nKa 0.75").ambient, glm::vec3(0.75f));
}

TEST(ObjMaterials, OpacityAndGlass) {
  const Material blended = material_of("d 0.25");
  EXPECT_EQ(blended.alpha_mode, AlphaMode::blend);
  EXPECT_EQ(blended.base_color.a, 0.25f);
  EXPECT_EQ(material_of("Tr 0.25").base_color.a, 0.75f);
  EXPECT_EQ(material_of("d 0.25\nTr 0.25").base_color.a, 0.25f);
  EXPECT_EQ(material_of("d 1").alpha_mode, AlphaMode::opaque);
  const Material glass = material_of("Kd 0.8 0.8 0.8\nd 0.25\nillum 7\nNi 1.5");
  EXPECT_EQ(glass.alpha_mode, AlphaMode::opaque);
  EXPECT_EQ(glass.base_color.a, 1.0f);
  EXPECT_EQ(glass.transmission, glm::vec3(0.75f));
  EXPECT_FLOAT_EQ(glass.base_color.r, 0.2f);
  EXPECT_EQ(material_of("Tf 0.1 0.2 0.3\nd 0.5\nillum 6\nNi 1.5").transmission, glm::vec3(0.1f, 0.2f, 0.3f));
}

TEST(ObjMaterials, GlassWithoutAnIndexWarns) {
  for (const char* ior : {"", "Ni 0\n", "Ni -1\n"}) {
    std::vector<std::string> warnings;
    const MtlLibrary library = parse_mtl(std::string("newmtl m\nillum 7\n") + ior);
    EXPECT_EQ(blinn_material(library.materials.at(0), "place", warnings).ior, 1.5f);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_TRUE(warnings[0].starts_with("place: "));
  }
}

TEST(ObjMaterials, BlackMirrorIsNone) {
  const Material material = material_of("Ks 0 0 0\nillum 5");
  EXPECT_EQ(material.reflection, glm::vec3(0.0f));
  EXPECT_FALSE(material.fresnel_reflection);
}

const std::string kFace = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n";

TEST(ObjMaterials, NamesPathsAndLibrariesWithSpaces) {
  const TemporaryFolder folder;
  folder.write("sub dir/my lib.mtl", "newmtl red paint #2 \nKd 1 0 0\nmap_Kd -s 2 4 .\\pic tures\\a b.ppm\n");
  folder.write("other.mtl", "newmtl blue\nKd 0 0 1\n");
  folder.write("sub dir/pic tures/a b.ppm", ppm(1, 1, "abc"));
  const std::string path =
      folder.write("m.obj", "mtllib sub dir\\my lib.mtl other.mtl\n" + kFace +
                                "usemtl red paint #2\nf 1/1 2/1 3/1\nusemtl blue\nf 1/1 2/1 3/1\n");
  const Scene scene = load_scene(path, {});
  EXPECT_TRUE(scene.warnings.empty());
  const auto& materials = scene.meshes[0].triangle_materials;
  ASSERT_EQ(materials.size(), 3u);
  EXPECT_EQ(scene.materials[materials[0]].base_color, glm::vec4(0.8f, 0.8f, 0.8f, 1.0f));
  EXPECT_EQ(scene.materials[materials[1]].base_color, glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(scene.materials[materials[2]].base_color, glm::vec4(0, 0, 1, 1));
  EXPECT_EQ(scene.materials[materials[1]].textures[TEXTURE_SLOT_BASE_COLOR].texture, 0);
  ASSERT_EQ(scene.textures.size(), 1u);
}

TEST(ObjMaterials, MissingLibraryMaterialAndTextureAreWarnings) {
  const TemporaryFolder folder;
  folder.write("a.mtl", "newmtl a\nmap_Kd gone.png\n");
  const std::string path = folder.write("m.obj", "mtllib gone.mtl\nmtllib a.mtl\nusemtl b\n" + kFace);
  const Scene scene = load_scene(path, {});
  ASSERT_EQ(scene.warnings.size(), 3u);
  EXPECT_NE(scene.warnings[0].find("gone.mtl"), std::string::npos);
  EXPECT_NE(scene.warnings[1].find("gone.png"), std::string::npos);
  EXPECT_NE(scene.warnings[2].find("'b'"), std::string::npos);
}

TEST(ObjMaterials, ABrokenLibraryIsAWarningAndAnErrorInStrict) {
  const TemporaryFolder folder;
  folder.write("a.mtl", std::string("newmtl a\0", 9));
  const std::string path = folder.write("m.obj", "mtllib a.mtl\nusemtl a\n" + kFace);
  const Scene scene = load_scene(path, {});
  ASSERT_EQ(scene.warnings.size(), 2u);
  EXPECT_NE(scene.warnings[0].find("a.mtl: not a text file"), std::string::npos) << scene.warnings[0];
  EXPECT_THROW(load_scene(path, {.strict = true}), Error);
}

TEST(ObjMaterials, TheFirstOfTwoMaterialsOfAName) {
  const TemporaryFolder folder;
  folder.write("a.mtl", "newmtl a\nKd 1 0 0\nnewmtl a\nKd 0 1 0\n");
  const Scene scene = load_scene(folder.write("m.obj", "mtllib a.mtl\nusemtl a\n" + kFace), {});
  EXPECT_EQ(scene.materials[scene.meshes[0].triangle_materials[0]].base_color.r, 1.0f);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(scene.warnings[0].find("material 'a' was there before"), std::string::npos) << scene.warnings[0];
}

TEST(ObjMaterials, NamesInAnotherCaseInQuotesOrBeforeCommentsAreFound) {
  const TemporaryFolder folder;
  folder.write("Library.MTL",
               "newmtl red # paint\nKd 1 0 0\nnewmtl Material #25\nKd 0 1 0\nmap_Kd \"Picture.PPM\" # new\n"
               "newmtl Material #26\nKd 0 0 1\nmap_Kd PICTURE.ppm\n");
  folder.write("picture.ppm", ppm(1, 1, "abc"));
  const std::string path =
      folder.write("m.obj",
                   "mtllib library.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl red\nf 1/1 2/1 3/1\n"
                   "usemtl Material #26\nf 1/1 2/1 3/1\nusemtl Material #25 # green\nf 1/1 2/1 3/1\n");
  const Scene scene = load_scene(path, {});
  EXPECT_TRUE(scene.warnings.empty());
  const auto& materials = scene.meshes[0].triangle_materials;
  ASSERT_EQ(materials.size(), 3u);
  EXPECT_EQ(scene.materials[materials[0]].base_color, glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(scene.materials[materials[1]].base_color, glm::vec4(0, 0, 1, 1)) << "the whole name first";
  EXPECT_EQ(scene.materials[materials[1]].textures[TEXTURE_SLOT_BASE_COLOR].texture, 0);
  EXPECT_EQ(scene.materials[materials[2]].textures[TEXTURE_SLOT_BASE_COLOR].texture, 0) << "the same file";
}

TEST(ObjMaterials, AnImageOfSeveralMaterialsIsDecodedOnce) {
  const TemporaryFolder folder;
  folder.write("sound.ppm", ppm(1, 1, "abc"));
  folder.write("a.mtl", "newmtl a\nnorm sound.ppm\nnewmtl b\nnorm sound.ppm\nmap_bump sound.ppm\n");
  const Scene scene = load_scene(folder.write("m.obj", "mtllib a.mtl\nusemtl a\n" + kFace), {});
  EXPECT_EQ(scene.textures.size(), 1u);
}

TEST(ObjMaterials, HeightsStandInForBrokenNormals) {
  const TemporaryFolder folder;
  folder.write("broken.png", "xx");
  folder.write("sound.ppm", ppm(1, 1, "abc"));
  const auto normal_texture = [&](const std::string& maps) {
    folder.write("a.mtl", "newmtl a\n" + maps);
    const Scene scene = load_scene(folder.write("m.obj", "mtllib a.mtl\nusemtl a\n" + kFace), {});
    const std::uint32_t material = scene.meshes[0].triangle_materials[0];
    const int texture = scene.materials[material].textures[TEXTURE_SLOT_NORMAL].texture;
    EXPECT_EQ(scene.warnings.size(), maps.starts_with("norm broken") ? 1u : 0u);
    return texture < 0 ? "none" : scene.textures[static_cast<std::size_t>(texture)].name;
  };
  EXPECT_EQ(normal_texture("norm broken.png\n"), "none");
  EXPECT_EQ(normal_texture("norm broken.png\nmap_bump sound.ppm\n"), "sound.ppm");
  EXPECT_EQ(normal_texture("map_bump sound.ppm\n"), "sound.ppm");
  EXPECT_EQ(normal_texture("norm sound.ppm\nmap_bump broken.png\n"), "sound.ppm") << "not asked for";
}

TEST(ObjMaterials, UnsupportedStatementsAreWarningsOrRefused) {
  const TemporaryFolder folder;
  folder.write("a.mtl", "newmtl a\nrefl -type sphere x.png\nsharpness 60\n");
  const std::string path = folder.write("m.obj", "mtllib a.mtl\nusemtl a\n" + kFace);
  const Scene scene = load_scene(path, {});
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(scene.warnings[0].find("a.mtl: line 2: refl is not supported"), std::string::npos);
  LoadOptions strict;
  strict.strict = true;
  EXPECT_THROW(load_scene(path, strict), Error);
}

TEST(ObjTextures, ScaleAndOffsetTurnWithV) {
  const TemporaryFolder folder;
  const std::string image = folder.write("a.ppm", ppm(1, 1, "abc"));
  Scene scene;
  PendingImages images;
  ObjTextures textures{images, "", {}};
  MtlTexture map;
  map.file = image;
  map.scale = {2.0, 4.0};
  map.offset = {0.5, 0.25};
  map.clamp = true;
  const TextureUse use = use_obj_texture(scene, textures, map, MtlMapUse::color, "");
  ASSERT_EQ(use.texture, 0);
  EXPECT_EQ(scene.textures[0].sampler.wrap_u, TEXTURE_WRAP_CLAMP);
  // V upwards 0.5: 0.5 * 4 + 0.25 = 2.25, downwards -1.25.
  const glm::vec2 uv = use.uv_from_vertex_uv * glm::vec3(0.25f, 0.5f, 1.0f);
  EXPECT_EQ(uv, glm::vec2(1.0f, -1.25f));
  EXPECT_EQ(use_obj_texture(scene, textures, map, MtlMapUse::color, "").texture, 0);
  map.clamp = false;
  EXPECT_EQ(use_obj_texture(scene, textures, map, MtlMapUse::color, "").texture, 1);
}

}  // namespace
}  // namespace vernier
