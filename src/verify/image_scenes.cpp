#include "verify/image_scenes.h"

#include <array>
#include <cmath>

namespace vernier {

Material matte(const glm::vec3& color) {
  Material material;
  material.workflow = Workflow::blinn;
  material.base_color = glm::vec4(color, 1.0f);
  material.specular = glm::vec3(0.0f);
  return material;
}

Material unlit(const glm::vec3& color) {
  Material material;
  material.unlit = true;
  material.base_color = glm::vec4(color, 1.0f);
  return material;
}

Material mirror(float reflectance) {
  Material material = matte(glm::vec3(0.0f));
  material.reflection = glm::vec3(reflectance);
  return material;
}

Material clear_glass(float ior) {
  Material material;
  material.transmission = glm::vec3(1.0f);
  material.roughness = 0.0f;
  material.ior = ior;
  material.thin_walled = false;
  return material;
}

void add_object(Scene& scene, const VerifyMesh& mesh, const Material& material, const glm::dmat4& world_from_object) {
  Instance& instance = scene.instances.emplace_back();
  instance.mesh = static_cast<std::uint32_t>(scene.meshes.size());
  instance.world_from_object = world_from_object;
  Mesh& placed_mesh = scene.meshes.emplace_back();
  placed_mesh.positions = mesh.positions;
  placed_mesh.triangles = mesh.triangles;
  placed_mesh.triangle_materials.assign(mesh.triangles.size(), static_cast<std::uint32_t>(scene.materials.size()));
  scene.materials.push_back(material);
}

void add_rectangle(Scene& scene, const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v,
                   const Material& material) {
  add_object(scene, {{corner, corner + u, corner + u + v, corner + v}, {{0u, 1u, 2u}, {0u, 2u, 3u}}}, material);
  scene.meshes.back().uvs[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
}

void surround(Scene& scene, const glm::vec3& radiance) {
  scene.environment.sky = scene.environment.ground = radiance;
  scene.environment.has_ambient_override = true;
}

Camera looking(const glm::dvec3& eye, const glm::dvec3& target, double vertical_fov) {
  const glm::dvec3 back = glm::normalize(eye - target);
  const glm::dvec3 up = std::abs(back.y) > 0.999 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(up, back));
  Camera camera;
  camera.world_from_camera = glm::dmat4(glm::dvec4(right, 0.0), glm::dvec4(glm::cross(back, right), 0.0),
                                        glm::dvec4(back, 0.0), glm::dvec4(eye, 1.0));
  camera.vertical_fov = vertical_fov;
  return camera;
}

VerifyMesh box_mesh(const glm::vec3& lo, const glm::vec3& hi) {
  VerifyMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    mesh.positions.emplace_back((corner & 1) != 0 ? hi.x : lo.x, (corner & 2) != 0 ? hi.y : lo.y,
                                (corner & 4) != 0 ? hi.z : lo.z);
  }
  constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces = {
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& face : kFaces) {
    mesh.triangles.push_back({face[0], face[1], face[2]});
    mesh.triangles.push_back({face[0], face[2], face[3]});
  }
  return mesh;
}

glm::dmat4 scaling(const glm::dvec3& factors) {
  glm::dmat4 matrix(1.0);
  for (int i = 0; i < 3; ++i) matrix[i][i] = factors[i];
  return matrix;
}

glm::dmat4 rotation(SampleRandom& random) {
  const glm::dvec3 x = random.direction();
  const glm::dvec3 z = glm::normalize(glm::cross(x, random.direction()));
  return glm::dmat4(glm::dmat3(x, glm::cross(z, x), z));
}

ImageScene mixed_scene(SampleRandom& random) {
  constexpr std::uint32_t kTrianglesEach = 24;
  ImageScene made;
  for (const Material& material : {matte({0.75f, 0.5f, 0.25f}), mirror(0.75f), clear_glass(1.5f)}) {
    add_object(made.scene, triangle_soup(kTrianglesEach, 0.6, random), material);
  }
  surround(made.scene, {0.25f, 0.5f, 0.75f});
  Light light;
  light.position = random.direction() * 4.0;
  light.intensity = glm::vec3(16.0f);
  made.scene.lights.push_back(light);
  made.camera = looking(random.direction() * 3.0, glm::dvec3(0.0), 0.7);
  return made;
}

}  // namespace vernier
