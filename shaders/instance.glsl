// Instances: meshes that are traced in spaces of their own, and the maps to and from there (shared/instance_layout.h).
#ifndef VERNIER_INSTANCE_GLSL
#define VERNIER_INSTANCE_GLSL

#include "material.glsl"
#include "ray.glsl"
#include "shared/instance_layout.h"

// Rows of an affine map: (x, y, z) are multiplied, w is added.
struct AffineMap {
  vec4 x, y, z;
};

// The map that begins at texel `first` of an instance.
AffineMap fetch_map(IN(uint) instance, IN(uint) first) {
  uint texel = instance * INSTANCE_TEXELS + first;
  return AffineMap(float_texel(load_instance(texel)), float_texel(load_instance(texel + 1u)), float_texel(load_instance(texel + 2u)));
}

// The words of an instance: its first triangle, handedness, roundings.
uvec4 fetch_instance_words(IN(uint) instance) { return load_instance(instance * INSTANCE_TEXELS + INSTANCE_WORDS); }

// The linear part times v. Per row 3 roundings of products and sums.
vec3 mapped_vector(IN(AffineMap) map, IN(vec3) v) {
  precise vec3 mapped = vec3(map.x.x * v.x + map.x.y * v.y + map.x.z * v.z, map.y.x * v.x + map.y.y * v.y + map.y.z * v.z,
                             map.z.x * v.x + map.z.y * v.y + map.z.z * v.z);
  return mapped;
}

// The map of p, what is added last: 4 roundings of the products, 1 of what is added.
vec3 mapped_point(IN(AffineMap) map, IN(vec3) p) {
  precise vec3 mapped = mapped_vector(map, p) + vec3(map.x.w, map.y.w, map.z.w);
  return mapped;
}

// The transpose of the linear part times v: a normal goes back by the map that points come by.
vec3 mapped_normal(IN(AffineMap) map, IN(vec3) v) {
  precise vec3 mapped = vec3(map.x.x * v.x + map.y.x * v.y + map.z.x * v.z, map.x.y * v.x + map.y.y * v.y + map.z.y * v.z,
                             map.x.z * v.x + map.y.z * v.y + map.z.z * v.z);
  return mapped;
}

// The linear part times v, every number by its size: what bounds of v become.
vec3 mapped_bound(IN(AffineMap) map, IN(vec3) v) {
  return vec3(abs(map.x.x) * v.x + abs(map.x.y) * v.y + abs(map.x.z) * v.z, abs(map.y.x) * v.x + abs(map.y.y) * v.y + abs(map.y.z) * v.z,
              abs(map.z.x) * v.x + abs(map.z.y) * v.y + abs(map.z.z) * v.z);
}

// The size of what the map of p is summed up from.
vec3 mapped_size(IN(AffineMap) map, IN(vec3) p) {
  return mapped_bound(map, abs(p)) + abs(vec3(map.x.w, map.y.w, map.z.w));
}

// `ray` in the space of an instance. Its t stays: the direction takes on whatever length the map gives it.
Ray ray_in_instance(IN(Ray) ray, IN(uint) instance) {
  AffineMap map = fetch_map(instance, INSTANCE_OBJECT_FROM_TRACED);
  return Ray(mapped_point(map, ray.origin), mapped_vector(map, ray.direction));
}

#endif
