// Sums of a pixel: fixed point, so that they have the same bits in any order. shared/film_layout.h.
#ifndef VERNIER_FILM_GLSL
#define VERNIER_FILM_GLSL

#include "rounding.glsl"
#include "shared/film_layout.h"

// A 96-bit unsigned number, low word first.
struct WideSum {
  uint low, middle, high;
};

struct PixelSum {
  WideSum red, green, blue;
  uint hits, samples, non_finite, first_non_finite, rays, nodes, triangles;
};

// `value` in steps of 2^-44, rounded to nearest; 0 for negative values, saturated at 2^32. `value` is finite.
WideSum fixed_point(IN(float) value) {
  uint bits = floatBitsToUint(value);
  uint exponent = bits >> 23;
  uint mantissa = (bits & 0x7fffffu) | 0x800000u;
  // value = mantissa 2^(exponent - 150) with the sign bit clear; below 2^-45 nothing is left.
  if (exponent < 82u || exponent > 255u) return WideSum(0u, 0u, 0u);
  if (exponent >= 127u + FILM_SAMPLE_MAX_EXPONENT) return WideSum(0u, 0u, 1u << 12);
  int shift = int(exponent) - 106;
  if (shift < 0) {
    uint right = uint(-shift);
    return WideSum((mantissa + (1u << (right - 1u))) >> right, 0u, 0u);
  }
  uint word = uint(shift) >> 5;
  uint left = uint(shift) & 31u;
  uint low = mantissa << left;
  uint high = left > 8u ? mantissa >> (32u - left) : 0u;
  return word == 0u ? WideSum(low, high, 0u) : word == 1u ? WideSum(0u, low, high) : WideSum(0u, 0u, low);
}

// Adds a value to the sum as the fast level does: in floats.
WideSum plainly_added(IN(WideSum) sum, IN(float) value) {
  float before = sum.high == FILM_PLAIN_SUM ? uintBitsToFloat(sum.low) : 0.0f;
  return WideSum(floatBitsToUint(before + value), 0u, FILM_PLAIN_SUM);
}

WideSum wide_add(IN(WideSum) a, IN(WideSum) b) {
  uint low = a.low + b.low;
  uint carry_low = low < a.low ? 1u : 0u;
  uint middle = a.middle + b.middle;
  uint carry_middle = middle < a.middle ? 1u : 0u;
  uint carried = middle + carry_low;
  carry_middle += carried < middle ? 1u : 0u;
  if (mutated(MUTATION_NARROW_SUM)) carry_middle = 0u;
  return WideSum(low, carried, a.high + b.high + carry_middle);
}

// `sum` with a finite value added.
WideSum added(IN(WideSum) sum, IN(float) value) {
  if (level_at(SPOT_SUM) == LEVEL_FAST) return plainly_added(sum, value);
  return wide_add(sum, fixed_point(value));
}

// A sum of costs, which ends at the largest number instead of beginning again.
uint saturated_sum(IN(uint) sum, IN(uint) more) { return sum + min(more, 0xffffffffu - sum); }

// Adds sample number `s` with its radiance; a non-finite one is counted and leaves the sums alone.
void add_sample(INOUT(PixelSum) sum, IN(vec3) radiance, IN(bool) hit, IN(uint) s) {
  sum.samples++;
  sum.hits += hit ? 1u : 0u;
  if (is_finite(radiance)) {
    sum.red = added(sum.red, radiance.x);
    sum.green = added(sum.green, radiance.y);
    sum.blue = added(sum.blue, radiance.z);
  } else {
    sum.first_non_finite = sum.non_finite == 0u ? s + 1u : min(sum.first_non_finite, s + 1u);
    sum.non_finite++;
  }
}

// The sums of pixel number `pixel` of the band that is bound.
PixelSum load_pixel_sum(IN(uint) pixel) {
  uint first = pixel * FILM_BLOCKS;
  uvec4 a = load_film(first);
  uvec4 b = load_film(first + 1u);
  uvec4 c = load_film(first + 2u);
  uvec4 d = load_film(first + 3u);
  return PixelSum(WideSum(a.x, a.y, a.z), WideSum(a.w, b.x, b.y), WideSum(b.z, b.w, c.x), c.y, c.z, c.w, d.x, d.y, d.z, d.w);
}

// Writes the sums of pixel number `pixel` back.
void store_pixel_sum(IN(uint) pixel, IN(PixelSum) sum) {
  uint first = pixel * FILM_BLOCKS;
  store_film(first, uvec4(sum.red.low, sum.red.middle, sum.red.high, sum.green.low));
  store_film(first + 1u, uvec4(sum.green.middle, sum.green.high, sum.blue.low, sum.blue.middle));
  store_film(first + 2u, uvec4(sum.blue.high, sum.hits, sum.samples, sum.non_finite));
  store_film(first + 3u, uvec4(sum.first_non_finite, sum.rays, sum.nodes, sum.triangles));
}

#endif
