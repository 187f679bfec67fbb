#include "scene/scene_faults.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/mesh_faults.h"

namespace vernier {
namespace {

// Relative to the longest column cubed. Flatter than this, float normals are noise.
constexpr double kSmallestDeterminant = 1e-20;
// Sums and differences of two such coordinates are still floats.
constexpr double kLargestCoordinate = 0x1p126;

template <class Vector>
bool is_finite(const Vector& v) {
  for (int i = 0; i < v.length(); ++i) {
    if (!std::isfinite(v[i])) return false;
  }
  return true;
}

bool is_finite_matrix(const glm::dmat4& m) {
  return is_finite(m[0]) && is_finite(m[1]) && is_finite(m[2]) && is_finite(m[3]);
}

bool is_regular(const glm::dmat4& m) {
  if (!is_finite_matrix(m) || m[0].w != 0.0 || m[1].w != 0.0 || m[2].w != 0.0 || m[3].w != 1.0) return false;
  double longest = 0.0;
  for (int c = 0; c < 3; ++c) {
    longest = std::max({longest, std::abs(m[c].x), std::abs(m[c].y), std::abs(m[c].z)});
  }
  if (!(longest > 0.0)) return false;
  const glm::dmat3 scaled = glm::dmat3(m) / longest;
  return std::abs(glm::determinant(scaled)) > kSmallestDeterminant;
}

bool stays_in_range(const glm::dmat4& m, const Mesh& mesh) {
  return std::ranges::all_of(mesh.positions, [&](const glm::vec3& p) {
    const glm::dvec3 world = m * glm::dvec4(p, 1.0);
    return std::max({std::abs(world.x), std::abs(world.y), std::abs(world.z)}) <= kLargestCoordinate;
  });
}

/// The largest absolute coordinate of each mesh; infinite where one is not finite.
std::vector<double> reaches(const std::vector<Mesh>& meshes) {
  std::vector<double> out;
  for (const Mesh& mesh : meshes) {
    double& reach = out.emplace_back(0.0);
    for (const glm::vec3& p : mesh.positions) {
      const double farthest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
      reach = is_finite(p) ? std::max(reach, farthest) : std::numeric_limits<double>::infinity();
      if (std::isinf(reach)) break;
    }
  }
  return out;
}

/// Whether no point within `reach` of a mesh's origin along each axis comes near the range's end: then no vertex has to
/// be asked, be there ever so many instances.
bool stays_far_from_range(const glm::dmat4& m, double reach) {
  double farthest = 0.0;
  for (int row = 0; row < 3; ++row) {
    const double turned = std::abs(m[0][row]) + std::abs(m[1][row]) + std::abs(m[2][row]);
    farthest = std::max(farthest, turned * reach + std::abs(m[3][row]));
  }
  return farthest <= kLargestCoordinate / 2.0;
}

template <class Value>
void repair(Value& value, const Value& standard, bool& repaired) {
  bool finite = true;
  if constexpr (std::is_floating_point_v<Value>) {
    finite = std::isfinite(value);
  } else {
    finite = is_finite(value);
  }
  if (finite) return;
  value = standard;
  repaired = true;
}

bool repair_material(Material& m) {
  const Material standard;
  bool repaired = false;
  repair(m.base_color, standard.base_color, repaired);
  repair(m.specular, standard.specular, repaired);
  repair(m.specular_strength, standard.specular_strength, repaired);
  repair(m.metallic, standard.metallic, repaired);
  repair(m.roughness, standard.roughness, repaired);
  repair(m.exponent, standard.exponent, repaired);
  repair(m.reflection, standard.reflection, repaired);
  repair(m.emission, standard.emission, repaired);
  repair(m.transmission, standard.transmission, repaired);
  repair(m.ior, standard.ior, repaired);
  repair(m.absorption, standard.absorption, repaired);
  repair(m.ambient, standard.ambient, repaired);
  repair(m.alpha_cutoff, standard.alpha_cutoff, repaired);
  repair(m.normal_scale, standard.normal_scale, repaired);
  repair(m.occlusion_strength, standard.occlusion_strength, repaired);
  for (TextureUse& use : m.textures) {
    for (int c = 0; c < 3; ++c) repair(use.uv_from_vertex_uv[c], TextureUse{}.uv_from_vertex_uv[c], repaired);
  }
  return repaired;
}

// Whether anything had to be repaired.
bool repair_ranges(Light& light) {
  constexpr double kRightAngle = std::numbers::pi / 2;
  const Light before = light;
  if (!(light.range > 0.0)) light.range = std::numeric_limits<double>::infinity();
  if (!(light.outer_cone_angle >= 0.0 && light.outer_cone_angle <= kRightAngle)) light.outer_cone_angle = kRightAngle;
  if (!(light.inner_cone_angle >= 0.0)) light.inner_cone_angle = 0.0;
  light.inner_cone_angle = std::min(light.inner_cone_angle, light.outer_cone_angle);
  return light.range != before.range || light.outer_cone_angle != before.outer_cone_angle ||
         light.inner_cone_angle != before.inner_cone_angle;
}

bool is_light(const Light& light) {
  if (!is_finite(light.intensity) || !is_finite(light.position) || !is_finite(light.direction)) return false;
  return light.kind == LightKind::point || light.direction != glm::dvec3(0.0);
}

bool is_camera(const Camera& camera) {
  if (!is_finite_matrix(camera.world_from_camera)) return false;
  if (camera.orthographic) return camera.half_height > 0.0 && std::isfinite(camera.half_height);
  return camera.vertical_fov > 0.0 && camera.vertical_fov < std::numbers::pi;
}

// Removes the elements that `keep` refuses; the index in the message is that of the file.
template <class Element, class Keep>
void drop(std::vector<Element>& elements, const char* name, const std::string& kind, FaultList& faults, Keep keep) {
  std::size_t index = 0;
  std::erase_if(elements, [&](const Element& element) {
    const bool dropped = !keep(element);
    if (dropped) faults.add(kind, std::string(name) + " " + std::to_string(index));
    ++index;
    return dropped;
  });
}

}  // namespace

void drop_instances(Scene& scene, FaultList& faults) {
  drop(scene.instances, "instance", "instances with a singular or non-finite transform are dropped", faults,
       [](const Instance& instance) { return is_regular(instance.world_from_object); });
  const std::vector<double> reach = reaches(scene.meshes);
  drop(scene.instances, "instance", "instances beyond the range of float are dropped", faults,
       [&](const Instance& instance) {
         return stays_far_from_range(instance.world_from_object, reach[instance.mesh]) ||
                stays_in_range(instance.world_from_object, scene.meshes[instance.mesh]);
       });
}

void drop_lights(Scene& scene, FaultList& faults) {
  // First, so that both kinds of line count lights as the file does.
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    if (!repair_ranges(scene.lights[i])) continue;
    faults.add("ranges and cones of lights that make no sense become the widest", "light " + std::to_string(i));
  }
  drop(scene.lights, "light", "lights with non-finite values or no direction are dropped", faults, is_light);
}

void drop_cameras(Scene& scene, FaultList& faults) {
  drop(scene.cameras, "camera", "cameras with a senseless transform or field of view are dropped", faults, is_camera);
}

void repair_materials(Scene& scene, FaultList& faults) {
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    if (repair_material(scene.materials[i]))
      faults.add("non-finite values are replaced", "material " + std::to_string(i));
  }
  const Environment standard;
  Environment& environment = scene.environment;
  bool repaired = false;
  repair(environment.sky, standard.sky, repaired);
  repair(environment.ground, standard.ground, repaired);
  repair(environment.texture_scale, standard.texture_scale, repaired);
  repair(environment.ambient, standard.ambient, repaired);
  if (repaired) faults.add("non-finite values are replaced", "environment");
}

bool has_triangles(const Scene& scene) {
  std::vector<bool> visible;
  for (const Mesh& mesh : scene.meshes) {
    visible.push_back(
        std::ranges::any_of(mesh.triangles, [&](const glm::uvec3& triangle) { return has_area(mesh, triangle); }));
  }
  return std::ranges::any_of(scene.instances, [&](const Instance& instance) { return visible[instance.mesh]; });
}

}  // namespace vernier
