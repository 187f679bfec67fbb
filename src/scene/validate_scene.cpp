#include "scene/validate_scene.h"

#include "error.h"
#include "scene/mesh_faults.h"
#include "scene/scene_faults.h"

namespace vernier {

void validate_scene(Scene& scene) {
  FaultList faults(scene.source);
  check_references(scene);
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) repair_mesh(scene.meshes[i], i, faults);
  drop_instances(scene, faults);
  drop_lights(scene, faults);
  drop_cameras(scene, faults);
  repair_materials(scene, faults);
  faults.append_to(scene.warnings);
  if (has_triangles(scene)) return;
  const std::string reason = faults.first_fault();
  throw Error(ErrorKind::refused,
              scene.source + ": nothing to render, no triangle is left" + (reason.empty() ? "" : "; " + reason));
}

}  // namespace vernier
