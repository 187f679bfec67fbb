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

// Rays begun by kind, and rays dropped.
struct RayCounts {
  uint primary, shadow, reflection, refraction, dropped;
};

// What a sample took.
struct SampleCost {
  uint rays;
  uint nodes;      // with COUNT_COST
  uint triangles;  // with COUNT_COST
};

// The hit at which the current ray ended, and the shadow ray from there to one of the lights.
struct LightVisit {
  Hit hit;
  uint next_light;      // lights below that have been asked
  Ray ray;              // the shadow ray: looks for hits after (t_min, after_triangle) up to t_max
  float t_min;
  uint after_triangle;
  float t_max;
  vec3 value;           // what the light adds to the pixel if nothing more is in its way
  vec3 optical_depth;   // of what the shadow ray went through, less what it has yet to leave
};

// What an invocation is busy with: it looks for the hit of the current ray; or whether the shadow ray gets through; or,
// without a ray, it has the next light to ask (only where a loop limit or a wall without light left it there); or it looks
// whether anything lies between the hit and the rounded surface above it (direct_light.glsl).
const uint PHASE_HIT = 0u;
const uint PHASE_SHADOW = 1u;
const uint PHASE_LIGHT = 2u;
const uint PHASE_RISE = 3u;

struct Path {
  uint job;  // NONE: the invocation has none
  bool hit;  // the primary ray hit something
  vec3 radiance;
  uint waiting;  // rays on the stack
  uint phase;
  SampleCost cost;
  PathRay current;
  LightVisit visit;
};

PathRay no_ray() { return PathRay(vec3(0.0f), vec3(0.0f), vec3(0.0f), 0.0f, NONE, 0u, NONE); }

// Before any light has been asked.
LightVisit no_visit() {
  return LightVisit(no_hit(0.0f), 0u, Ray(vec3(0.0f), vec3(0.0f)), 0.0f, NONE, 0.0f, vec3(0.0f), vec3(0.0f));
}

Path no_path() { return Path(NONE, false, vec3(0.0f), 0u, PHASE_HIT, SampleCost(0u, 0u, 0u), no_ray(), no_visit()); }

// The path of `invocation` fills PATH_BLOCKS of the path buffer from here on.
uint path_place(IN(uint) invocation) { return invocation * PATH_BLOCKS(PATH_STACK_SIZE); }

uint stack_slot(IN(uint) place, IN(uint) index) { return place + PATH_HEAD_BLOCKS + PATH_RAY_BLOCKS * (index + 1u); }

// Three floats and a word as a block of memory.
uvec4 block_of(IN(vec3) v, IN(uint) word) {
  return uvec4(floatBitsToUint(v.x), floatBitsToUint(v.y), floatBitsToUint(v.z), word);
}

vec3 vector_of(IN(uvec4) block) { return vec3(uintBitsToFloat(block.x), uintBitsToFloat(block.y), uintBitsToFloat(block.z)); }

// Only then a ray may begin behind a hit.
bool rays_pass_hits() { return effect_on(EFFECT_ALPHA_MASK) || effect_on(EFFECT_ALPHA_BLEND); }

void save_ray(IN(uint) first, IN(PathRay) ray) {
  store_path(first, block_of(ray.origin, ray.depth));
  store_path(first + 1u, block_of(ray.direction, ray.medium));
  store_path(first + 2u, block_of(ray.weight, floatBitsToUint(ray.t_min)));
  if (rays_pass_hits()) store_path(first + 3u, uvec4(ray.after_triangle, 0u, 0u, 0u));
}

PathRay restored_ray(IN(uint) first) {
  uvec4 a = load_path(first);
  uvec4 b = load_path(first + 1u);
  uvec4 c = load_path(first + 2u);
  float t_min = 0.0f;
  uint after_triangle = NONE;
  if (rays_pass_hits()) {
    t_min = uintBitsToFloat(c.w);
    after_triangle = load_path(first + 3u).x;
  }
  return PathRay(vector_of(a), vector_of(b), vector_of(c), t_min, after_triangle, a.w, b.w);
}

// Puts `ray` on the stack of the path at `place`; a full stack drops it, which is counted and reported. The stack lies in
// memory at all times: where a driver's loop limit cuts a kernel off, no loop could be trusted to save it.
void push_ray(IN(uint) place, INOUT(Path) path, INOUT(RayCounts) counts, IN(PathRay) ray) {
  if (path.waiting < PATH_STACK_SIZE) {
    save_ray(stack_slot(place, path.waiting), ray);
    path.waiting++;
  } else {
    counts.dropped++;
  }
}

// The ray that came last onto the stack, which is not empty.
PathRay pop_ray(IN(uint) place, INOUT(Path) path) {
  path.waiting--;
  return restored_ray(stack_slot(place, path.waiting));
}

// Puts everything but the stack, which is there already, into memory.
void save_path(IN(uint) place, IN(Path) path) {
  LightVisit visit = path.visit;
  store_path(place, uvec4(path.job, path.hit ? 1u : 0u, path.waiting, path.phase));
  store_path(place + 1u, block_of(path.radiance, path.cost.rays));
  store_path(place + 2u, uvec4(visit.hit.triangle, visit.hit.record, path.cost.nodes, path.cost.triangles));
  store_path(place + 3u, uvec4(floatBitsToUint(visit.hit.t), visit.next_light, visit.hit.instance, 0u));
  store_path(place + 4u, block_of(visit.ray.origin, floatBitsToUint(visit.t_min)));
  store_path(place + 5u, block_of(visit.ray.direction, floatBitsToUint(visit.t_max)));
  store_path(place + 6u, block_of(visit.value, visit.after_triangle));
  store_path(place + 7u, block_of(visit.optical_depth, 0u));
  save_ray(place + PATH_HEAD_BLOCKS, path.current);
}

// The path that was saved at `place`.
Path restored_path(IN(uint) place) {
  uvec4 state = load_path(place);
  uvec4 sum = load_path(place + 1u);
  uvec4 ids = load_path(place + 2u);
  uvec4 visited = load_path(place + 3u);
  uvec4 origin = load_path(place + 4u);
  uvec4 direction = load_path(place + 5u);
  uvec4 value = load_path(place + 6u);
  uint instance = INSTANCED ? visited.z : INSTANCE_WORLD;
  LightVisit visit = LightVisit(Hit(uintBitsToFloat(visited.x), ids.x, ids.y, instance), visited.y,
                                Ray(vector_of(origin), vector_of(direction)), uintBitsToFloat(origin.w), value.w, uintBitsToFloat(direction.w), vector_of(value),
                                vector_of(load_path(place + 7u)));
  return Path(state.x, state.y != 0u, vector_of(sum), state.z, state.w, SampleCost(sum.w, ids.z, ids.w),
              restored_ray(place + PATH_HEAD_BLOCKS), visit);
}

#endif
