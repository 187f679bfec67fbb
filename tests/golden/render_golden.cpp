// Renders one golden by the reference: `render_golden CASE FILE.exr`, prints its recipe as JSON. tools/update_goldens
// runs it.
#include <algorithm>
#include <cstdio>
#include <iostream>

#include "cli/recipe.h"
#include "cli/version.h"
#include "error.h"
#include "golden_case.h"
#include "image/write_image.h"
#include "reference/render_reference.h"
#include "rounding_distance.h"

namespace vernier::golden {
namespace {

bool is_kept(const Layer& layer) {
  return layer.name.empty() || layer.name == "object_id" || layer.name == "primitive_id";
}

ImageFile render_golden(const CaseSetup& setup) {
  ReferenceSettings settings;
  settings.width = setup.settings.width;
  settings.height = setup.settings.height;
  settings.spp = setup.settings.spp;
  settings.max_bounces = setup.settings.max_bounces;
  settings.cutoff = static_cast<double>(setup.settings.cutoff);
  settings.seed = setup.settings.seed;
  ImageFile image = render_reference(setup.scene.scene, setup.scene.camera, settings, {});
  std::erase_if(image.layers, [](const Layer& layer) { return !is_kept(layer); });
  image.layers.push_back({"edge_steps", {"center"}, steps_to_edge(setup, 1)});
  image.layers.push_back({"sample_edge_steps", {"least"}, steps_to_edge(setup, settings.spp)});
  return image;
}

int run(const std::string& name, const std::string& path) {
  const GoldenCase golden = find_case(name);
  const CaseSetup setup = set_up_case(golden);
  write_image(path, render_golden(setup), {});
  const nlohmann::ordered_json recipe = {{"case", name},
                                         {"scene", "scenes/" + golden.scene},
                                         {"scene_sha1", sha1_of_files(setup.scene.scene.files)},
                                         {"options", golden.options},
                                         {"renderer", std::string("reference of Vernier ") + kVersion}};
  std::cout << recipe.dump(2) << "\n";
  return 0;
}

}  // namespace
}  // namespace vernier::golden

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: render_golden CASE FILE.exr\n", stderr);
    return static_cast<int>(vernier::ErrorKind::usage);
  }
  try {
    return vernier::golden::run(argv[1], argv[2]);
  } catch (const vernier::Error& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return static_cast<int>(error.kind());
  }
}
