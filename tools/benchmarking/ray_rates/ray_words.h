// Rays that ray_rates traces and their answers, texel by texel. Read by C++ and GLSL alike.
//
// texel        x         y         z         w
// ray, 2 i     origin x  origin y  origin z  1: any hit ends the search, 0: the closest is sought
// ray, 2 i + 1 direction ...                 t_max
// answer, i    triangle  bits of t finished  records visited, where they are counted
#ifndef VERNIER_RAY_WORDS_H
#define VERNIER_RAY_WORDS_H

// Above those of a render, shared/bindings.h.
#define BINDING_RATED_RAYS 30
#define BINDING_RATED_ANSWERS 31
#define BINDING_RATED_SCENE 32  // the driver's acceleration structure

// Specialization constant of ray_queries.comp: what a ray asks is then known when the driver compiles.
#define RATED_ANY_HIT 0

#define RATED_GROUP 64             // rays of a workgroup
#define RATED_NOTHING 0xffffffffu  // in place of a triangle: a miss

#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>

namespace vernier {

struct RatedRay {
  glm::vec3 origin;
  std::uint32_t any_hit;
  glm::vec3 direction;
  float t_max;
};

struct RatedAnswer {
  std::uint32_t triangle;
  float t;
  std::uint32_t finished;  // 0: cut off by the driver, the answer counts for nothing
  std::uint32_t records;
};

static_assert(sizeof(RatedRay) == 32);
static_assert(sizeof(RatedAnswer) == 16);

}  // namespace vernier
#endif

#endif
