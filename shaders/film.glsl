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

WideSum wide_add(IN(WideSum) a, IN(WideSum) b) {
  uint low = a.low + b.low;
  uint carry_low = low < a.low ? 1u : 0u;
  uint middle = a.middle + b.middle;
  uint carry_middle = middle < a.middle ? 1u : 0u;
  uint carried = middle + carry_low;
  carry_middle += carried < middle ? 1u : 0u;
  return WideSum(low, carried, a.high + b.high + carry_middle);
}

// Adds sample number `s` with its radiance; a non-finite one is counted and leaves the sums alone.
void add_sample(INOUT(PixelSum) sum, IN(vec3) radiance, IN(bool) hit, IN(uint) s) {
  sum.samples++;
  sum.hits += hit ? 1u : 0u;
  if (is_finite(radiance)) {
    sum.red = wide_add(sum.red, fixed_point(radiance.x));
    sum.green = wide_add(sum.green, fixed_point(radiance.y));
    sum.blue = wide_add(sum.blue, fixed_point(radiance.z));
  } else {
    sum.first_non_finite = sum.non_finite == 0u ? s + 1u : min(sum.first_non_finite, s + 1u);
    sum.non_finite++;
  }
}

WideSum load_wide_sum(IN(uint) first) { return WideSum(load_film(first), load_film(first + 1u), load_film(first + 2u)); }

void store_wide_sum(IN(uint) first, IN(WideSum) sum) {
  store_film(first, sum.low);
  store_film(first + 1u, sum.middle);
  store_film(first + 2u, sum.high);
}

// The sums of pixel number `pixel` of the band that is bound.
PixelSum load_pixel_sum(IN(uint) pixel) {
  uint first = pixel * FILM_WORDS;
  return PixelSum(load_wide_sum(first + FILM_RED), load_wide_sum(first + FILM_GREEN), load_wide_sum(first + FILM_BLUE),
                  load_film(first + FILM_HITS), load_film(first + FILM_SAMPLES), load_film(first + FILM_NON_FINITE),
                  load_film(first + FILM_FIRST_NON_FINITE), load_film(first + FILM_RAYS), load_film(first + FILM_NODES),
                  load_film(first + FILM_TRIANGLES));
}

// Writes the sums of pixel number `pixel` back.
void store_pixel_sum(IN(uint) pixel, IN(PixelSum) sum) {
  uint first = pixel * FILM_WORDS;
  store_wide_sum(first + FILM_RED, sum.red);
  store_wide_sum(first + FILM_GREEN, sum.green);
  store_wide_sum(first + FILM_BLUE, sum.blue);
  store_film(first + FILM_HITS, sum.hits);
  store_film(first + FILM_SAMPLES, sum.samples);
  store_film(first + FILM_NON_FINITE, sum.non_finite);
  store_film(first + FILM_FIRST_NON_FINITE, sum.first_non_finite);
  store_film(first + FILM_RAYS, sum.rays);
  store_film(first + FILM_NODES, sum.nodes);
  store_film(first + FILM_TRIANGLES, sum.triangles);
}

#endif
