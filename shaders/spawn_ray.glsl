// Origins of secondary rays: off the surface by the error bound of the hit point, no more. No epsilon.
#ifndef VERNIER_SPAWN_RAY_GLSL
#define VERNIER_SPAWN_RAY_GLSL

#include "surface.glsl"

// The fast level's distance from any surface, in units of the traced space, which reaches from -1 to 1: it grows into thin
// layers of large scenes and is too small for rays that start far out. Not derived from anything: the level stands for the
// habit of choosing such a number, and 1e-4 is what is usually chosen.
const float FIXED_OFFSET = 1e-4f;

// `origin` as it is when it has been rounded to float in world coordinates.
vec3 kept_in_world(IN(vec3) origin) {
  float scale = render_constants().metres_per_unit;
  precise vec3 world = origin * scale + render_constants().world_center;
  precise vec3 back = (world - render_constants().world_center) / scale;
  return back;
}

// How far along the geometric normal a ray starts: the error bound's extent, so that it lies on that side of the exact plane.
// Waechter and Binder 2019 describe the problem ("A Fast and Robust Method for Avoiding Self-Intersection", Ray Tracing Gems
// 6); the bound is that of SurfacePoint.
float spawn_distance(IN(SurfacePoint) surface) {
  float distance = dot_product(abs(surface.geometric_normal), surface.position_error);
  if (INSTANCED) distance += surface.normal_error;
  if (level_at(SPOT_SPAWN) == LEVEL_FAST) distance = FIXED_OFFSET;
  if (mutated(MUTATION_METRE_OFFSET)) distance = FIXED_OFFSET / render_constants().metres_per_unit;
  return distance;
}

// The hit point moved along the geometric normal to the side that `direction` leaves on.
vec3 spawn_origin(IN(SurfacePoint) surface, IN(vec3) direction) {
  float distance = spawn_distance(surface);
  bool above = dot_product(direction, surface.geometric_normal) >= 0.0f;
  precise vec3 origin = surface.position + surface.geometric_normal * (above ? distance : -distance);
  return mutated(MUTATION_WORLD_ORIGIN) ? kept_in_world(origin) : origin;
}

// The hit point moved to the rounded surface above it, and above the triangle's plane however little that rises: the
// rise is known to four roundings of its size, and one sum rounds at the size of the place, as at spawn_origin.
vec3 raised_origin(IN(SurfacePoint) surface) {
  float distance = spawn_distance(surface) + 4.0f * HALF_ULP_OF_ONE * dot_product(abs(surface.geometric_normal), abs(surface.rise));
  precise vec3 origin = surface.position + (surface.geometric_normal * distance + surface.rise);
  return origin;
}

#endif
