#include <numbers>

#include "scene/frame_scene.h"

namespace vernier {
namespace {

// Towards the lights in the camera's frame: the key above its left shoulder, the fill low at its right.
constexpr glm::dvec3 kKeySide(-0.55, 0.75, 0.75);
constexpr glm::dvec3 kFillSide(0.9, 0.15, 0.6);
// Radiance of a white diffuse surface at right angles to each: with the gradient 0.85 in the key, 0.25 in its shadow.
constexpr glm::vec3 kKeyRadiance(0.60f, 0.58f, 0.55f);
constexpr glm::vec3 kFillRadiance(0.10f, 0.105f, 0.115f);
// Overcast sky over warm dark ground.
constexpr glm::vec3 kSky(0.27f, 0.30f, 0.35f);
constexpr glm::vec3 kGround(0.13f, 0.115f, 0.10f);
// Around lights of the file's own: a third of that, so that shadows stay deep and metals still have something to
// mirror.
constexpr glm::vec3 kDimSky(0.085f, 0.098f, 0.12f);
constexpr glm::vec3 kDimGround(0.045f, 0.040f, 0.036f);

Light directional(const char* name, const Camera& camera, const glm::dvec3& side, const glm::vec3& radiance) {
  Light light;
  light.name = name;
  light.kind = LightKind::directional;
  light.direction = -glm::normalize(glm::dmat3(camera.world_from_camera) * side);
  // Radiance of white under irradiance E is E / pi.
  light.intensity = radiance * std::numbers::pi_v<float>;
  return light;
}

bool is_untouched(const Environment& environment) {
  return environment.texture < 0 && !environment.has_ambient_override && environment.sky == glm::vec3(0.0f) &&
         environment.ground == glm::vec3(0.0f);
}

}  // namespace

std::vector<Light> default_lights(const Camera& camera) {
  return {directional("default key", camera, kKeySide, kKeyRadiance),
          directional("default fill", camera, kFillSide, kFillRadiance)};
}

void add_default_lighting(Scene& scene, const Camera& camera) {
  const bool brings_lights = !scene.lights.empty();
  if (!brings_lights) scene.lights = default_lights(camera);
  if (!is_untouched(scene.environment)) return;
  scene.environment.sky = brings_lights ? kDimSky : kSky;
  scene.environment.ground = brings_lights ? kDimGround : kGround;
}

}  // namespace vernier
