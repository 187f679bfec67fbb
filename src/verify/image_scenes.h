#pragma once

#include "scene/scene.h"
#include "verify/verify_mesh.h"

namespace vernier {

/// What a case renders.
struct ImageScene {
  Scene scene;
  Camera camera;
};

/// A material whose only term is its diffuse colour.
Material matte(const glm::vec3& color);
/// A material that is seen in its colour, whatever the light.
Material unlit(const glm::vec3& color);
/// A mirror of the same reflectance at every angle.
Material mirror(float reflectance);
/// Clear glass with Fresnel reflection and a solid inside.
Material clear_glass(float ior);

/// Adds `mesh` in `material` as an instance of its own.
void add_object(Scene& scene, const VerifyMesh& mesh, const Material& material,
                const glm::dmat4& world_from_object = glm::dmat4(1.0));
/// Adds the rectangle `corner`, `corner + u`, `corner + u + v`, `corner + v`, whose front is where u x v points; UV run
/// from (0, 0) at `corner` to (1, 1).
void add_rectangle(Scene& scene, const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v,
                   const Material& material);
/// `radiance` from everywhere, but no ambient light.
void surround(Scene& scene, const glm::vec3& radiance);

/// A camera at `eye` that looks at `target`, with a vertical field of view in radians. `up` is +Y, or +Z where the view
/// runs along Y.
Camera looking(const glm::dvec3& eye, const glm::dvec3& target, double vertical_fov);

/// The box [lo, hi], 12 triangles, wound outwards.
VerifyMesh box_mesh(const glm::vec3& lo, const glm::vec3& hi);

/// Scaling along the axes.
glm::dmat4 scaling(const glm::dvec3& factors);
/// A random rotation.
glm::dmat4 rotation(SampleRandom& random);
/// Matte, mirroring and glass triangles, a few of each, under a light, seen from outside.
ImageScene mixed_scene(SampleRandom& random);

}  // namespace vernier
