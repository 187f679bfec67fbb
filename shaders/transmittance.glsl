// How much light a surface in the way of a shadow ray lets through. shaders/README.md, Image formation 5.8.
#ifndef VERNIER_TRANSMITTANCE_GLSL
#define VERNIER_TRANSMITTANCE_GLSL

#include "fresnel.glsl"
#include "path.glsl"
#include "shading_terms.glsl"

// A surface as all that meets it sees it: what is fetched at a hit.
struct HitSurface {
  TrianglePoint point;
  DeviceMaterial material;
  ShadingTerms terms;
  float alpha;
};

// Factor of the surface alone, without absorption: 1 - a + a t. `cosine` between the ray and the normal.
vec3 surface_transmittance(IN(HitSurface) surface, IN(float) cosine) {
  vec3 through = vec3(0.0f);
  if (is_transmissive(surface.material)) {
    float ior = surface.material.ior;
    float passed = boundary_transmittance(fresnel_dielectric(cosine, ior), ior, surface.terms.boundary_normal, surface.terms.boundary_grazing);
    through = surface.terms.transmission * (is_fresnel_free(surface.material) ? 1.0f : passed);
  }
  return vec3(1.0f - surface.alpha) + through * surface.alpha;
}

// Takes the shadow ray of `visit` through the surface that it met at `hit`.
void pass_surface(INOUT(LightVisit) visit, IN(Hit) hit, IN(HitSurface) surface) {
  float length_of_t = sqrt(dot_product(visit.ray.direction, visit.ray.direction));
  vec3 normal = winding_normal(surface.point);
  float along = dot_product(normal, visit.ray.direction) / length_of_t;
  visit.value *= surface_transmittance(surface, min(abs(along), 1.0f));
  if (effect_on(EFFECT_ABSORPTION) && is_transmissive(surface.material) && !has_flag(surface.material, MATERIAL_THIN_WALLED) &&
      surface.alpha > 0.0f) {
    note_run(EFFECT_ABSORPTION);
    visit.optical_depth += surface.material.absorption * (along > 0.0f ? hit.t * length_of_t : -hit.t * length_of_t);
  }
  visit.t_min = hit.t;
  visit.after_triangle = hit.triangle;
}

// What the light of `visit` adds once its shadow ray is through.
vec3 arriving_light(IN(LightVisit) visit) {
  if (!effect_on(EFFECT_ABSORPTION)) return visit.value;
  return visit.value * exp(-max(visit.optical_depth, vec3(0.0f)));
}

#endif
