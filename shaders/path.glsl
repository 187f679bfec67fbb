// The ray tree of a sample: the ray being followed, the rays that wait, and how a path is put aside between dispatches.
#ifndef VERNIER_PATH_GLSL
#define VERNIER_PATH_GLSL

#include "ray.glsl"
#include "shared/film_layout.h"

// A ray with its weight in the pixel. It looks for hits after (t_min, after_triangle).
struct PathRay {
  vec3 origin;
  vec3 direction;
  vec3 weight;
  float t_min;
  uint after_triangle;
  uint depth;   // reflections and refractions so far
  uint medium;  // material it travels in, or NONE
};

// Work done, by kind of ray.
struct RayCounts {
  uint primary, shadow, reflection, refraction, dropped, nodes, triangles;
};

struct Path {
  uint sample_index;
  bool hit;  // the primary ray hit something
  vec3 radiance;
  uint waiting;  // rays on the stack
  PathRay current;
};

THREAD_PRIVATE PathRay waiting_rays[PATH_STACK_SIZE];

// Puts `ray` on the stack; a full stack drops it, which is counted and reported.
void push_ray(INOUT(Path) path, INOUT(RayCounts) counts, IN(PathRay) ray) {
  if (path.waiting < PATH_STACK_SIZE) {
    waiting_rays[path.waiting] = ray;
    path.waiting++;
  } else {
    counts.dropped++;
  }
}

void save_ray(IN(uint) first, IN(uint) stride, IN(PathRay) ray) {
  store_path(first, floatBitsToUint(ray.origin.x));
  store_path(first + stride, floatBitsToUint(ray.origin.y));
  store_path(first + 2u * stride, floatBitsToUint(ray.origin.z));
  store_path(first + 3u * stride, floatBitsToUint(ray.direction.x));
  store_path(first + 4u * stride, floatBitsToUint(ray.direction.y));
  store_path(first + 5u * stride, floatBitsToUint(ray.direction.z));
  store_path(first + 6u * stride, floatBitsToUint(ray.weight.x));
  store_path(first + 7u * stride, floatBitsToUint(ray.weight.y));
  store_path(first + 8u * stride, floatBitsToUint(ray.weight.z));
  store_path(first + 9u * stride, floatBitsToUint(ray.t_min));
  store_path(first + 10u * stride, ray.after_triangle);
  store_path(first + 11u * stride, ray.depth);
  store_path(first + 12u * stride, ray.medium);
}

float load_path_float(IN(uint) i) { return uintBitsToFloat(load_path(i)); }

PathRay restored_ray(IN(uint) first, IN(uint) stride) {
  PathRay ray;
  ray.origin = vec3(load_path_float(first), load_path_float(first + stride), load_path_float(first + 2u * stride));
  ray.direction = vec3(load_path_float(first + 3u * stride), load_path_float(first + 4u * stride),
                       load_path_float(first + 5u * stride));
  ray.weight = vec3(load_path_float(first + 6u * stride), load_path_float(first + 7u * stride),
                    load_path_float(first + 8u * stride));
  ray.t_min = load_path_float(first + 9u * stride);
  ray.after_triangle = load_path(first + 10u * stride);
  ray.depth = load_path(first + 11u * stride);
  ray.medium = load_path(first + 12u * stride);
  return ray;
}

// Word w of invocation i lies at w * stride + i.
void save_path(IN(uint) invocation, IN(uint) stride, IN(Path) path) {
  store_path(invocation, path.sample_index);
  store_path(invocation + stride, path.hit ? 1u : 0u);
  store_path(invocation + 2u * stride, floatBitsToUint(path.radiance.x));
  store_path(invocation + 3u * stride, floatBitsToUint(path.radiance.y));
  store_path(invocation + 4u * stride, floatBitsToUint(path.radiance.z));
  store_path(invocation + 5u * stride, path.waiting);
  save_ray(invocation + PATH_HEAD_WORDS * stride, stride, path.current);
  for (uint i = 0u; i < path.waiting; i++) {
    save_ray(invocation + (PATH_HEAD_WORDS + PATH_RAY_WORDS * (i + 1u)) * stride, stride, waiting_rays[i]);
  }
}

Path restored_path(IN(uint) invocation, IN(uint) stride) {
  Path path;
  path.sample_index = load_path(invocation);
  path.hit = load_path(invocation + stride) != 0u;
  path.radiance = vec3(load_path_float(invocation + 2u * stride), load_path_float(invocation + 3u * stride),
                       load_path_float(invocation + 4u * stride));
  path.waiting = load_path(invocation + 5u * stride);
  path.current = restored_ray(invocation + PATH_HEAD_WORDS * stride, stride);
  for (uint i = 0u; i < path.waiting; i++) {
    waiting_rays[i] = restored_ray(invocation + (PATH_HEAD_WORDS + PATH_RAY_WORDS * (i + 1u)) * stride, stride);
  }
  return path;
}

#endif
