// Rays and answers of the kernels that ray_rates times, as texels where the device reads those faster.
#ifndef VERNIER_RAY_WORDS_GLSL
#define VERNIER_RAY_WORDS_GLSL

#include "ray_words.h"

#ifdef LOADS_TEXELS
layout(set = 0, binding = BINDING_RATED_RAYS, rgba32ui) uniform readonly uimageBuffer ray_texels;
layout(set = 0, binding = BINDING_RATED_ANSWERS, rgba32ui) uniform writeonly uimageBuffer answer_texels;
uvec4 load_ray(uint i) { return imageLoad(ray_texels, int(i)); }
void store_answer(uint i, uvec4 answer) { imageStore(answer_texels, int(i), answer); }
#else
layout(set = 0, binding = BINDING_RATED_RAYS, std430) readonly buffer RatedRays { uvec4 ray_texels[]; };
layout(set = 0, binding = BINDING_RATED_ANSWERS, std430) writeonly buffer RatedAnswers { uvec4 answer_texels[]; };
uvec4 load_ray(uint i) { return ray_texels[i]; }
void store_answer(uint i, uvec4 answer) { answer_texels[i] = answer; }
#endif

#endif
