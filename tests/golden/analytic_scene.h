#pragma once

#include <gtest/gtest.h>

#include "device_test.h"
#include "render/render_image.h"

namespace vernier::golden {

/// Scenes put together by hand whose picture is known in closed form.
class AnalyticScene : public DeviceTest {
 protected:
  /// Adds `material` and a rectangle of it: `corner`, `corner + u`, `corner + u + v`, `corner + v`; its front is where
  /// u x v points. UV run from (0, 0) at `corner` to (1, 1).
  void add_rectangle(const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v, const Material& material) {
    Mesh mesh;
    mesh.positions = {corner, corner + u, corner + u + v, corner + v};
    mesh.uvs[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.triangle_materials.assign(2, static_cast<std::uint32_t>(scene_.materials.size()));
    scene_.materials.push_back(material);
    scene_.instances.push_back({.name = "", .mesh = static_cast<std::uint32_t>(scene_.meshes.size())});
    scene_.meshes.push_back(mesh);
  }

  /// The colours of one sample at each pixel centre, [height][width][4].
  std::vector<float> render(RenderSettings settings) const {
    settings.spp = settings.sample_end = 1;
    RenderResult result = render_image(device(), scene_, camera_, settings, {});
    EXPECT_EQ(result.statistics.non_finite_pixels, 0u);
    EXPECT_EQ(result.statistics.stack_overflows, 0u);
    return std::get<std::vector<float>>(result.image.layers.at(0).values);
  }

  /// A camera at `eye` that looks along -Z.
  void look_from(const glm::dvec3& eye, double vertical_fov) {
    camera_.world_from_camera[3] = glm::dvec4(eye, 1.0);
    camera_.vertical_fov = vertical_fov;
  }

  Scene scene_;
  Camera camera_;
};

/// A material whose only term is its diffuse colour.
inline Material matte(const glm::vec3& color) {
  Material material;
  material.workflow = Workflow::blinn;
  material.base_color = glm::vec4(color, 1.0f);
  material.specular = glm::vec3(0.0f);
  return material;
}

/// A mirror of the same reflectance at every angle.
inline Material mirror(float reflectance) {
  Material material = matte(glm::vec3(0.0f));
  material.reflection = glm::vec3(reflectance);
  return material;
}

/// Clear glass with Fresnel reflection and a solid inside.
inline Material glass(float ior) {
  Material material;
  material.transmission = glm::vec3(1.0f);
  material.roughness = 0.0f;
  material.ior = ior;
  material.thin_walled = false;
  return material;
}

}  // namespace vernier::golden
