#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

// Calls one of the functions that render on operands from a buffer: what `vernier verify` tests is what runs.

#include "shared/glsl.h"
#include "specialization.glsl"
#include "shared/verify_functions.h"
#include "shared/material_layout.h"
#include "shared/render_constants.h"

layout(local_size_x = 64) in;
layout(constant_id = SPECIALIZATION_FUNCTION) const uint FUNCTION = 0u;
layout(set = 0, binding = 0, scalar) readonly buffer Operands { float operands[]; };
layout(set = 0, binding = 1, scalar) writeonly buffer Answers { float answers[]; };

float operand(uint i) { return operands[gl_GlobalInvocationID.x * VERIFY_OPERANDS + i]; }
vec3 operand_vector(uint i) { return vec3(operand(i), operand(i + 1u), operand(i + 2u)); }
void answer(uint i, float value) { answers[gl_GlobalInvocationID.x * VERIFY_ANSWERS + i] = value; }
void answer_vector(uint i, vec3 v) {
  answer(i, v.x);
  answer(i + 1u, v.y);
  answer(i + 2u, v.z);
}

// What the functions would load comes from the operands instead: no scene is bound.
RenderConstants render_constants() {
  RenderConstants constants;
  constants.camera_origin = vec3(0.0);
  constants.camera_right = operand_vector(0u);
  constants.camera_up = operand_vector(3u);
  constants.camera_forward = operand_vector(6u);
  constants.image_width = uint(operand(9u));
  constants.image_height = uint(operand(10u));
  return constants;
}
SteeringConstants steering_constants() {
  SteeringConstants constants;
  constants.orthographic = 0u;
  constants.vertex_texels = 1u;
  constants.normal_texel = 0u;
  constants.uv01_texel = 0u;
  constants.uv23_texel = NONE;
  constants.color_texel = NONE;
  constants.tangent_texel = NONE;
  return constants;
}
uvec4 load_record(uint i) {
  if (FUNCTION != VERIFY_FRAME || i == 0u) return uvec4(0u);
  return uvec4(floatBitsToUint(operand_vector(i == 1u ? 6u : 9u)), 0u);
}
uvec4 load_triangle(uint i) { return uvec4(0u, 1u, 2u, 0u); }
uvec4 load_vertex(uint i) {
  if (FUNCTION == VERIFY_NORMAL) return uvec4(floatBitsToUint(operand_vector(3u * i)), 0u);
  return uvec4(floatBitsToUint(operand(2u * i)), floatBitsToUint(operand(2u * i + 1u)), 0u, 0u);
}
uvec4 load_texture(uint i) {
  uint wrap = uint(operand(4u));
  uint word = TEXTURE_FORMAT_FLOAT | wrap << TEXTURE_WRAP_U_SHIFT | wrap << TEXTURE_WRAP_V_SHIFT;
  return uvec4(uint(operand(2u)), uint(operand(3u)), 0u, word | uint(operand(5u)) << TEXTURE_FILTER_SHIFT);
}
uint load_texel(uint i) { return floatBitsToUint(float(i / 4u)); }
uvec4 load_material(uint i) { return uvec4(0u); }
uvec4 load_light(uint i) { return uvec4(0u); }
uvec4 load_film(uint i) { return uvec4(0u); }
void store_film(uint i, uvec4 block) {}

#include "blinn.glsl"
#include "camera.glsl"
#include "film.glsl"
#include "light.glsl"
#include "scatter_direction.glsl"
#include "surface.glsl"

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

// The direction behind a plane boundary with index ratio eta, as scatter() of trace_path.glsl asks for it.
vec3 refracted(vec3 to_viewer, vec3 normal, float eta) {
  float cosine = clamp(dot_product(normal, to_viewer), 0.0, 1.0);
  return refracted_direction(to_viewer, normal, normal, eta, fresnel_dielectric(cosine, eta));
}

void answer_plate() {
  vec3 within = refracted(operand_vector(0u), operand_vector(3u), operand(6u));
  answer_vector(0u, within);
  // From behind, the other face has the same normal towards the viewer.
  answer_vector(3u, refracted(-within, operand_vector(3u), 1.0 / operand(6u)));
}

// The triangle's point of these weights: no ray decides them.
TrianglePoint weighted_point(float b1, float b2) {
  TrianglePoint point = triangle_point(Ray(vec3(0.0), vec3(0.0, 0.0, 1.0)), Hit(1.0, 0u, 0u));
  point.b0 = 1.0 - b1 - b2;
  point.b1 = b1;
  point.b2 = b2;
  return point;
}

void main() {
  if (gl_GlobalInvocationID.x * VERIFY_OPERANDS >= operands.length()) return;
  switch (FUNCTION) {
    case VERIFY_FRESNEL: {
      Fresnel fresnel = fresnel_dielectric(operand(0u), operand(1u));
      answer(0u, fresnel.reflected);
      answer(1u, fresnel.transmitted);
      answer(2u, fresnel.refracted_cosine);
      break;
    }
    case VERIFY_HIGHLIGHT:
      answer(0u, blinn_highlight(operand_vector(0u), operand_vector(3u), operand_vector(6u), operand(9u)));
      break;
    case VERIFY_UNIT_VECTOR:
      answer_vector(0u, unit_vector(operand_vector(0u)));
      break;
    case VERIFY_REFRACTION:
      answer_vector(0u, refracted(operand_vector(0u), operand_vector(3u), operand(6u)));
      break;
    case VERIFY_MIRROR:
      answer_vector(0u, mirrored_direction(operand_vector(0u), operand_vector(3u), operand_vector(6u)));
      break;
    case VERIFY_SCHLICK:
      answer(0u, schlick_weight(operand(0u)));
      break;
    case VERIFY_LOG_ONE_MINUS:
      answer(0u, log_one_minus(operand(0u)));
      break;
    case VERIFY_TEXTURE:
      answer(0u, sample_texture(0u, vec2(operand(0u), operand(1u))).x);
      break;
    case VERIFY_LIGHT:
      answer_light();
      break;
    case VERIFY_CAMERA:
      answer_vector(0u, camera_ray(vec2(operand(11u), operand(12u))).direction);
      break;
    case VERIFY_SUM:
      answer_sum();
      break;
    case VERIFY_UV: {
      vec2 uv = interpolated_uv(weighted_point(operand(6u), operand(7u)), 0u);
      answer(0u, uv.x);
      answer(1u, uv.y);
      break;
    }
    case VERIFY_FRAME: {
      vec4 frame = tangent_frame(weighted_point(0.0, 0.0), operand_vector(12u), 0u);
      answer_vector(0u, first_three(frame));
      answer(3u, frame.w);
      break;
    }
    case VERIFY_NORMAL: {
      TrianglePoint point = weighted_point(operand(9u), operand(10u));
      answer_vector(0u, interpolated_normal(point, operand_vector(11u)));
      break;
    }
    case VERIFY_PLATE:
      answer_plate();
      break;
  }
}
