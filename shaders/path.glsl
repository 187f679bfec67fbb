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

// Where an invocation keeps its path: word w at w * stride + invocation of the path buffer.
struct PathPlace {
  uint invocation;
  uint stride;
};

struct Path {
  PathPlace place;
  uint sample_index;
  bool hit;  // the primary ray hit something
  vec3 radiance;
  uint waiting;  // rays on the stack
  PathRay current;
};

uint path_word(IN(PathPlace) place, IN(uint) word) { return place.invocation + word * place.stride; }

uint stack_slot(IN(PathPlace) place, IN(uint) index) {
  return path_word(place, PATH_HEAD_WORDS + PATH_RAY_WORDS * (index + 1u));
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

// Puts `ray` on the stack; a full stack drops it, which is counted and reported. The stack lies in memory at all times:
// where a driver's loop limit cuts a kernel off, no loop could be trusted to save it.
void push_ray(INOUT(Path) path, INOUT(RayCounts) counts, IN(PathRay) ray) {
  if (path.waiting < PATH_STACK_SIZE) {
    save_ray(stack_slot(path.place, path.waiting), path.place.stride, ray);
    path.waiting++;
  } else {
    counts.dropped++;
  }
}

// The ray that came last onto the stack, which is not empty.
PathRay pop_ray(INOUT(Path) path) {
  path.waiting--;
  return restored_ray(stack_slot(path.place, path.waiting), path.place.stride);
}

// Puts everything but the stack, which is there already, into memory.
void save_path(IN(Path) path) {
  PathPlace place = path.place;
  store_path(path_word(place, 0u), path.sample_index);
  store_path(path_word(place, 1u), path.hit ? 1u : 0u);
  store_path(path_word(place, 2u), floatBitsToUint(path.radiance.x));
  store_path(path_word(place, 3u), floatBitsToUint(path.radiance.y));
  store_path(path_word(place, 4u), floatBitsToUint(path.radiance.z));
  store_path(path_word(place, 5u), path.waiting);
  save_ray(path_word(place, PATH_HEAD_WORDS), place.stride, path.current);
}

// The path that was saved at `place`.
Path restored_path(IN(PathPlace) place) {
  Path path;
  path.place = place;
  path.sample_index = load_path(path_word(place, 0u));
  path.hit = load_path(path_word(place, 1u)) != 0u;
  path.radiance = vec3(load_path_float(path_word(place, 2u)), load_path_float(path_word(place, 3u)),
                       load_path_float(path_word(place, 4u)));
  path.waiting = load_path(path_word(place, 5u));
  path.current = restored_ray(path_word(place, PATH_HEAD_WORDS), place.stride);
  return path;
}

#endif
