// Rays that verify_rays.comp and verify_triangles.comp trace, and their answers. Scalar layout, read by C++ and GLSL alike.
#ifndef VERNIER_SHARED_VERIFY_RAYS_H
#define VERNIER_SHARED_VERIFY_RAYS_H

#include "shared/glsl.h"

#ifdef __cplusplus
namespace vernier {
using glm::uint;
using glm::vec3;
#endif

#define BINDING_QUERIES 30  // RayQuery; above those of a render, shared/bindings.h
#define BINDING_ANSWERS 31  // RayAnswer
#define BINDING_CORNERS 32  // verify_triangles.comp: BVH records, uvec4, 3 per record

// What verify_rays.comp does with a ray.
#define VERIFY_CLOSEST 0u   // one search
#define VERIFY_ALL_HITS 1u  // one search after the other, each from the hit before on
#define VERIFY_RESPAWN 2u   // a second search, from the hit on along `outgoing`, as paths and shadow rays go on
// What verify_triangles.comp does with it.
#define VERIFY_TRIANGLES 0u  // every triangle by itself
#define VERIFY_BOXES 1u      // the child boxes of record 0

// Searches in a row at most: llvmpipe leaves loops after 65535 rounds in all, and a search takes hundreds.
#define VERIFY_HIT_LIMIT 128u

#define RAY_ANY_HIT 1u  // of RayQuery::flags: the first opaque triangle ends the search

struct RayQuery {
  vec3 origin;
  float t_min;
  vec3 direction;
  float t_max;
  vec3 outgoing;  // VERIFY_RESPAWN
  uint after_triangle;
  uint flags;
};

struct RayAnswer {
  uint triangle;  // of the first search; NONE: a miss
  float t;         // of the first hit; VERIFY_RESPAWN: as it is shaded, which may be more exact than it was sought
  uint is_opaque;
  uint finished;       // all searches; 0: the answer may not be used
  uint nodes;          // visited by the first search
  uint tested;         // triangles tested by it
  uint hit_count;      // hits of all searches; VERIFY_TRIANGLES: triangles hit when asked alone
  uint descents;       // hits whose triangle number was below that of the hit before
  uint next_triangle;  // VERIFY_RESPAWN: hit by the second search, or NONE
  float next_t;
  vec3 position;   // VERIFY_RESPAWN: of the first hit
  vec3 respawned;  // origin of the second search
  vec3 normal;     // geometric, towards the viewer
};

#ifdef __cplusplus
static_assert(sizeof(RayQuery) == 4 * 13);
static_assert(sizeof(RayAnswer) == 4 * 19);
}  // namespace vernier
#endif

#endif
