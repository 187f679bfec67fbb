#include "gltf_file.h"

namespace vernier {
namespace {

TEST(LoadScene, picks_the_loader_by_extension_of_any_case) {
  GltfFile file;
  add_triangle(file);
  EXPECT_EQ(load_scene(file.folder.write("a.GLTF", file.text()), {}).instances.size(), 1u);
  const std::string obj = file.folder.write("a.Obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(load_scene(obj, {}).instances.size(), 1u);
}

TEST(LoadScene, refuses_other_extensions_and_missing_files) {
  expect_refused([] { load_scene("test.stl", {}); }, "must end in .gltf, .glb or .obj");
  expect_refused([] { load_scene("test.gltf", {}); }, "test.gltf: the file does not exist");
}

TEST(LoadScene, refuses_what_the_first_bytes_show_to_be_something_else) {
  const TemporaryFolder folder;
  expect_refused([&] { load_scene(folder.write("test.gltf", "<html>"), {}); }, "begins neither as JSON nor with glTF");
  expect_refused([&] { load_scene(folder.write("test.obj", std::string("v\0", 2)), {}); },
                 "not a text file: byte 1 is 0");
  // Gigabytes, of which no memory is taken: a file without data on the disk stands for them.
  for (const char* name : {"large.obj", "large.glb", "large.gltf"}) {
    const std::string path = folder.write(name, "");
    std::filesystem::resize_file(path, std::uintmax_t{4000} << 20);
    EXPECT_THROW(load_scene(path, {}), Error) << name;
  }
}

using Files = std::vector<std::string>;

TEST(LoadScene, tells_every_file_it_was_read_from_once) {
  GltfFile file;
  add_triangle(file);
  const std::string gltf = file.folder.write("a.gltf", file.text());
  EXPECT_EQ(load_scene(gltf, {}).files, Files{gltf});
  const TemporaryFolder& folder = file.folder;
  const std::string image = folder.write("a.ppm", std::string("P6\n1 1\n255\nabc"));
  const std::string obj =
      folder.write("a.obj", "mtllib a.mtl none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
  const std::string mtl = folder.write("a.mtl", "newmtl m\nmap_Kd a.ppm\nmap_Ks a.ppm\nmap_Ke none.png\n");
  EXPECT_EQ(load_scene(obj, {}).files, (Files{obj, mtl, image}));
}

TEST(LoadScene, tells_buffers_and_images_that_lie_beside_a_gltf) {
  GltfFile file;
  add_triangle(file);
  const std::string bin = file.folder.write("a b.bin", file.buffer);
  const std::string image = file.folder.write("a.ppm", std::string("P6\n1 1\n255\nabc"));
  file.json["buffers"] = {{{"byteLength", file.buffer.size()}, {"uri", "a%20b.bin"}}};
  file.add("images", {{"uri", "a.ppm"}});
  file.add("textures", {{"source", 0}});
  file.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  file.json["meshes"][0]["primitives"][0]["material"] = 0;
  const std::string path = file.folder.write("a.gltf", file.json.dump());
  EXPECT_EQ(load_scene(path, {}).files, (Files{path, bin, image}));
}

TEST(LoadScene, validates_what_was_loaded) {
  GltfFile file;
  add_triangle(file);
  file.add("nodes", {{"mesh", 0}, {"scale", {0, 0, 0}}});
  EXPECT_FALSE(load_scene(file.folder.write("test.gltf", file.text()), {}).warnings.empty());
}

}  // namespace
}  // namespace vernier
