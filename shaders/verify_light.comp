#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

// Light, highlights and the film's sums: calls for `vernier verify`.

#include "verify_call.glsl"

// Nothing is loaded by the functions that are called: no scene is bound.
uvec4 load_light(uint i) { return uvec4(0u); }
uvec4 load_material(uint i) { return uvec4(0u); }
uvec4 load_film(uint i) { return uvec4(0u); }
void store_film(uint i, uvec4 block) {}

#include "blinn.glsl"
#include "film.glsl"
#include "light.glsl"

uint digits(uint i) { return uint(operand(i)) | uint(operand(i + 1u)) << 16; }
void answer_digits(uint i, uint word) {
  answer(i, float(word & 0xffffu));
  answer(i + 1u, float(word >> 16));
}

void answer_sum() {
  WideSum none = WideSum(0u, 0u, 0u);
  WideSum start = WideSum(digits(3u), digits(5u), digits(7u));
  PixelSum sum = PixelSum(start, none, none, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
  uint count = uint(operand(2u));
  for (uint i = 0u; i < count; i++) add_sample(sum, vec3(operand(i & 1u), (i & 1u) == 1u ? operand(9u) : 0.0, 0.0), true, i);
  answer_digits(0u, sum.red.low);
  answer_digits(2u, sum.red.middle);
  answer_digits(4u, sum.red.high);
  answer(6u, float(sum.samples));
  answer(7u, float(sum.non_finite));
  answer(8u, float(sum.first_non_finite));
}

void answer_light() {
  DeviceLight light;
  light.position = operand_vector(0u);
  light.kind = uint(operand(3u));
  light.direction = operand_vector(4u);
  light.range = operand(7u);
  light.intensity = vec3(operand(8u));
  light.cos_outer = operand(9u);
  light.cone_scale = operand(10u);
  LightSample seen = sample_light(light, operand_vector(11u));
  answer_vector(0u, seen.direction);
  answer(3u, seen.irradiance.x);
}

void main() {
  if (!is_called()) return;
  switch (FUNCTION) {
    case VERIFY_HIGHLIGHT:
      answer(0u, blinn_highlight(operand_vector(0u), operand_vector(3u), operand_vector(6u), operand(9u)));
      break;
    case VERIFY_LOG_ONE_MINUS:
      answer(0u, log_one_minus(operand(0u)));
      break;
    case VERIFY_LIGHT:
      answer_light();
      break;
    case VERIFY_SUM:
      answer_sum();
      break;
  }
}
