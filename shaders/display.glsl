// A pixel of the film as the window shows it: eight bits a channel.
#ifndef VERNIER_DISPLAY_GLSL
#define VERNIER_DISPLAY_GLSL

#include "film.glsl"
#include "sample_pattern.glsl"
#include "shared/display_constants.h"

// The mean of `samples` values; 0 without any.
float mean_of(IN(WideSum) sum, IN(uint) samples) {
  if (samples == 0u) return 0.0f;
  // 2^20, 2^-12, 2^-44: the words above FILM_FRACTION_BITS.
  float total = float(sum.high) * 1048576.0f + float(sum.middle) * 2.44140625e-4f + float(sum.low) * 5.684341886080801e-14f;
  if (sum.high == FILM_PLAIN_SUM) total = uintBitsToFloat(sum.low);
  return total / float(samples);
}

// The sRGB curve (IEC 61966-2-1).
float srgb_curve(IN(float) linear) {
  float x = clamp(linear, 0.0f, 1.0f);
  return x <= 0.0031308f ? 12.92f * x : 1.055f * pow(x, 1.0f / 2.4f) - 0.055f;
}

vec3 id_color(IN(uint) id) {
  if (id == NONE) return vec3(0.0f);
  uint bits = hash_word(id + 1u);
  return vec3(float(bits & 255u), float((bits >> 8) & 255u), float((bits >> 16) & 255u)) * (0.8f / 255.0f) + vec3(0.2f);
}

// Black, red, yellow, white, by the logarithm of the rays of a sample: 64 are white.
vec3 heat(IN(float) rays) {
  float t = log2(1.0f + rays) * 0.5f;
  return vec3(clamp(t, 0.0f, 1.0f), clamp(t - 1.0f, 0.0f, 1.0f), clamp(t - 2.0f, 0.0f, 1.0f));
}

vec3 aov_vector(IN(uint) pixel, IN(uint) first) {
  uint word = pixel * AOV_WORDS + first;
  return vec3(uintBitsToFloat(load_aov(word)), uintBitsToFloat(load_aov(word + 1u)), uintBitsToFloat(load_aov(word + 2u)));
}

// Pixel number `pixel` of the band as display values in [0, 1].
vec3 displayed(IN(DisplayConstants) constants, IN(uint) pixel) {
  uint words = pixel * AOV_WORDS;
  uint layer = constants.layer;
  if (layer == DISPLAY_DEPTH) {
    float depth = uintBitsToFloat(load_aov(words + AOV_DEPTH));
    return vec3(is_finite(depth) ? constants.far_depth / (constants.far_depth + depth) : 0.0f);
  }
  if (layer == DISPLAY_NORMAL) return aov_vector(pixel, AOV_NORMAL) * 0.5f + vec3(0.5f);
  if (layer == DISPLAY_SHADING_NORMAL) return aov_vector(pixel, AOV_SHADING_NORMAL) * 0.5f + vec3(0.5f);
  if (layer == DISPLAY_OBJECT) return id_color(load_aov(words + AOV_OBJECT_ID));
  if (layer == DISPLAY_MATERIAL) return id_color(load_aov(words + AOV_MATERIAL_ID));
  if (layer == DISPLAY_PRIMITIVE) return id_color(load_aov(words + AOV_PRIMITIVE_ID));
  vec3 linear = vec3(0.0f);
  if (layer == DISPLAY_ALBEDO) {
    linear = aov_vector(pixel, AOV_ALBEDO);
  } else {
    PixelSum sum = load_pixel_sum(pixel);
    if (layer == DISPLAY_RAYS) return heat(float(sum.rays) / max(float(sum.samples), 1.0f));
    if (sum.non_finite > 0u) return vec3(1.0f, 0.0f, 1.0f);
    linear = vec3(mean_of(sum.red, sum.samples), mean_of(sum.green, sum.samples), mean_of(sum.blue, sum.samples)) * constants.exposure;
  }
  return vec3(srgb_curve(linear.x), srgb_curve(linear.y), srgb_curve(linear.z));
}

// Values in [0, 1] as a word of R8G8B8A8.
uint display_word(IN(vec3) value) {
  vec3 bytes = clamp(value, vec3(0.0f), vec3(1.0f)) * 255.0f + vec3(0.5f);
  return uint(bytes.x) | uint(bytes.y) << 8 | uint(bytes.z) << 16 | 0xff000000u;
}

#endif
