#pragma once

#include "scene/scene.h"

namespace vernier {

/// A square from (0, 0, 0) to (2, 2, 0) with one material, no light and no camera: its centre is (1, 1, 0).
inline Scene unit_square() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.triangle_materials = {0, 0};
  Scene scene;
  scene.source = "square";
  scene.meshes = {mesh};
  scene.instances = {Instance{}};
  scene.materials = {Material{}};
  return scene;
}

}  // namespace vernier
