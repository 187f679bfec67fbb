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

TEST(LoadScene, validates_what_was_loaded) {
  GltfFile file;
  add_triangle(file);
  file.add("nodes", {{"mesh", 0}, {"scale", {0, 0, 0}}});
  EXPECT_FALSE(load_scene(file.folder.write("test.gltf", file.text()), {}).warnings.empty());
}

}  // namespace
}  // namespace vernier
