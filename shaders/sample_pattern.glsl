// Where in its pixel a sample lies: an Owen-scrambled Sobol (0, 2)-sequence per pixel, from integers alone.
// shaders/README.md, Image formation 1.
#ifndef VERNIER_SAMPLE_PATTERN_GLSL
#define VERNIER_SAMPLE_PATTERN_GLSL

#include "shared/glsl.h"
#include "shared/render_constants.h"

// "lowbias32" (Wellons 2018, "Prospecting for Hash Functions").
uint hash_word(IN(uint) word) {
  uint v = word;
  v ^= v >> 16;
  v *= 0x7feb352du;
  v ^= v >> 15;
  v *= 0x846ca68bu;
  v ^= v >> 16;
  return v;
}

// Owen scrambling of the bits of v, the highest first (Burley 2020, "Practical Hash-based Owen Scrambling", JCGT 9(4)).
uint owen_scramble(IN(uint) value, IN(uint) key) {
  uint v = bitfieldReverse(value);
  v += key;
  v ^= v * 0x6c50b47cu;
  v ^= v * 0xb82f1e52u;
  v ^= v * 0xc7afe638u;
  v ^= v * 0x8d22f6e6u;
  return bitfieldReverse(v);
}

// Second Sobol dimension: the Pascal matrix modulo 2 applied to the reversed bits, in log steps. Bit c of the index, counted
// from 0, reaches bit 31 - r of the result where the bits of r are a subset of those of c (Lucas's theorem).
uint sobol_1(IN(uint) index) {
  uint v = bitfieldReverse(index);
  v ^= v << 16;
  v ^= (v & 0x00ff00ffu) << 8;
  v ^= (v & 0x0f0f0f0fu) << 4;
  v ^= (v & 0x33333333u) << 2;
  v ^= (v & 0x55555555u) << 1;
  return v;
}

float unit_float(IN(uint) word) { return float(word >> 8) * 5.9604644775390625e-8f; }  // 2^-24: exact

// The place in [-1/2, 3/2) at which a tent of width 2 around 1/2 has the share u of its area to the left.
float tent_place(IN(float) u) {
  float rising = sqrt(2.0f * u);
  float falling = 2.0f - sqrt(2.0f - 2.0f * u);
  return (u < 0.5f ? rising : falling) - 0.5f;
}

// `offset` in [0, 1)^2 spread as the filter weighs its pixel's surroundings: samples then count alike.
vec2 filtered_offset(IN(vec2) offset, IN(uint) pixel_filter) {
  return pixel_filter == PIXEL_FILTER_TENT ? vec2(tent_place(offset.x), tent_place(offset.y)) : offset;
}

// Offset in [0, 1)^2 of sample number `s` in pixel (x, y); the centre where the image has one sample per pixel.
vec2 sample_offset(IN(uint) x, IN(uint) y, IN(uint) s, IN(uint) seed, IN(uint) spp) {
  if (spp == 1u) return vec2(0.5f);
  uint key = hash_word(x + hash_word(y + hash_word(seed)));
  uint i = owen_scramble(s, hash_word(key + 1u));
  return vec2(unit_float(owen_scramble(bitfieldReverse(i), hash_word(key + 2u))),
              unit_float(owen_scramble(sobol_1(i), hash_word(key + 3u))));
}

#endif
