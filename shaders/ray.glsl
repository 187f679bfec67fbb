// A ray and a hit, in units of the traced space.
#ifndef VERNIER_RAY_GLSL
#define VERNIER_RAY_GLSL

#include "rounding.glsl"
#include "shared/instance_layout.h"
#include "shared/render_constants.h"

struct Ray {
  vec3 origin;
  vec3 direction;  // any length but zero; t counts in it
};

// A crossing of a ray with a triangle. Hits are ordered by (t, triangle): at equal t the lower number comes first.
struct Hit {
  float t;
  uint triangle;  // global number; NONE: nothing hit
  uint record;    // of the BVH, where the corners lie
  uint instance;  // in whose space they lie (instance_layout.h)
};

// The start of a search for hits up to t_max, at most LARGEST_FLOAT.
Hit no_hit(IN(float) t_max) { return Hit(t_max, NONE, NONE, INSTANCE_WORLD); }

// The axis of the largest component of a direction: 0, 1 or 2.
int largest_axis(IN(vec3) direction) {
  vec3 size = abs(direction);
  return size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
}

// The component of v along `axis`.
float axis_of(IN(vec3) v, IN(int) axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

// Components of a direction below 2^-80 count as that where the ray is divided by them.
const float LEAST_COMPONENT = 8.271806125530277e-25f;

// 1 / d without infinities, with the sign of d (-0 is negative).
float bounded_inverse(IN(float) d) {
  uint sign_bit = floatBitsToUint(d) & 0x80000000u;
  float size = max(abs(d), LEAST_COMPONENT);
  return uintBitsToFloat(floatBitsToUint(1.0f / size) | sign_bit);
}

// Whether the tracing functions may be given this ray: finite, with a direction.
bool is_valid_ray(IN(Ray) ray) {
  return is_finite(ray.origin) && is_finite(ray.direction) &&
         (abs(ray.direction.x) > 0.0f || abs(ray.direction.y) > 0.0f || abs(ray.direction.z) > 0.0f);
}

#endif
