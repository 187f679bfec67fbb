#include "scene/gltf_lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/gltf_references.h"
#include "scene/gltf_values.h"

namespace vernier {
namespace {

void read_cone(const GltfDocument& document, const tinygltf::SpotLight& spot, const std::string& place, Light& light) {
  constexpr double kHalfPi = std::numbers::pi / 2.0;
  constexpr double kRounding = 1e-6;  // pi / 2 as printed by exporters that compute in float
  light.inner_cone_angle = spot.innerConeAngle;
  light.outer_cone_angle = spot.outerConeAngle;
  // Equal angles, which the extension forbids, are how exporters write a cone with a sharp edge.
  if (!(light.inner_cone_angle >= 0.0 && light.inner_cone_angle <= light.outer_cone_angle &&
        light.outer_cone_angle > 0.0 && light.outer_cone_angle <= kHalfPi + kRounding)) {
    refuse_gltf(document, place,
                "cone angles " + std::to_string(light.inner_cone_angle) + " and " +
                    std::to_string(light.outer_cone_angle) + " are not 0 <= inner < outer <= pi / 2");
  }
  light.outer_cone_angle = std::min(light.outer_cone_angle, kHalfPi);
  light.inner_cone_angle = std::min(light.inner_cone_angle, light.outer_cone_angle);
}

Light read_light(const GltfDocument& document, int index) {
  const tinygltf::Light& source = document.model.lights[static_cast<std::size_t>(index)];
  const std::string place = "light " + std::to_string(index);
  Light light;
  light.name = source.name;
  glm::dvec3 color(1.0);
  if (source.color.size() >= 3) color = {source.color[0], source.color[1], source.color[2]};
  if (source.intensity < 0.0 || color.x < 0.0 || color.y < 0.0 || color.z < 0.0) {
    refuse_gltf(document, place, "intensity or colour is negative");
  }
  for (int c = 0; c < 3; ++c) light.intensity[c] = gltf_float(color[c] * source.intensity);
  if (source.range > 0.0) light.range = source.range;  // tinygltf says 0 for none
  if (source.type == "point") {
    light.kind = LightKind::point;
  } else if (source.type == "directional") {
    light.kind = LightKind::directional;
  } else if (source.type == "spot") {
    light.kind = LightKind::spot;
    read_cone(document, source.spot, place, light);
  } else {
    refuse_gltf(document, place, "type \"" + source.type + "\" is not known");
  }
  return light;
}

}  // namespace

std::vector<Light> gltf_lights(GltfDocument& document, std::span<const int> nodes,
                               std::span<const glm::dmat4> world_from_node) {
  std::vector<Light> lights;
  for (const int node_index : nodes) {
    const tinygltf::Node& node = document.model.nodes[static_cast<std::size_t>(node_index)];
    const tinygltf::Value* extension = find_gltf_extension(node.extensions, "KHR_lights_punctual");
    if (extension == nullptr) continue;
    const std::string place = "node " + std::to_string(node_index);
    const int index = gltf_index(*extension, "light", -1);
    check_gltf_index(document, place, "light", index, document.model.lights.size());
    Light light = read_light(document, index);
    if (light.name.empty()) light.name = node.name;
    const glm::dmat4& world = world_from_node[static_cast<std::size_t>(node_index)];
    light.position = glm::dvec3(world[3]);
    if (light.kind != LightKind::point) {
      const double length = glm::length(glm::dvec3(world[2]));
      if (!(length > 0.0) || !std::isfinite(length)) {
        warn_gltf(document, place, "its light has no direction and is left out");
        continue;
      }
      light.direction = -glm::dvec3(world[2]) / length;
    }
    lights.push_back(light);
  }
  return lights;
}

}  // namespace vernier
