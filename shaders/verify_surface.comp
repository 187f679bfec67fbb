#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

// Camera rays and what lies at a hit: calls for `vernier verify`.

#include "verify_call.glsl"
#include "shared/material_layout.h"
#include "shared/render_constants.h"

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
  const uint offsets = 1u | 2u << 16;
  uvec3 corner = uvec3(0u);
  if (FUNCTION == VERIFY_FRAME && i > 0u) corner = floatBitsToUint(operand_vector(i == 1u ? 6u : 9u));
  return uvec4(corner, i == 1u ? offsets : 0u);
}
uvec4 load_vertex(uint i) {
  if (FUNCTION == VERIFY_NORMAL) return uvec4(floatBitsToUint(operand_vector(3u * i)), 0u);
  return uvec4(floatBitsToUint(operand(2u * i)), floatBitsToUint(operand(2u * i + 1u)), 0u, 0u);
}
uvec4 load_texture(uint i) {
  uint wrap = uint(operand(4u));
  uint word = TEXTURE_FORMAT_FLOAT | wrap << TEXTURE_WRAP_U_SHIFT | wrap << TEXTURE_WRAP_V_SHIFT;
  return uvec4(uint(operand(2u)), uint(operand(3u)), 0u, word | uint(operand(5u)) << TEXTURE_FILTER_SHIFT);
}
uvec4 load_texel_quad(uint i) { return uvec4(floatBitsToUint(float(i))); }
uint load_texel(uint i) { return load_texel_quad(i / 4u).x; }
uint load_curve(uint i) { return 0u; }
uvec4 load_material(uint i) { return uvec4(0u); }
uvec4 load_instance(uint i) { return uvec4(0u); }

#include "camera.glsl"
#include "surface.glsl"

// The triangle's point of these weights: no ray decides them.
TrianglePoint weighted_point(float b1, float b2) {
  TrianglePoint point = triangle_point(Ray(vec3(0.0), vec3(0.0, 0.0, 1.0)), Hit(1.0, 0u, 0u, INSTANCE_WORLD));
  point.b0 = 1.0 - b1 - b2;
  point.b1 = b1;
  point.b2 = b2;
  return point;
}

void main() {
  if (!is_called()) return;
  switch (FUNCTION) {
    case VERIFY_UNIT_VECTOR:
      answer_vector(0u, unit_vector(operand_vector(0u)));
      break;
    case VERIFY_TEXTURE:
      answer(0u, sample_texture(0u, vec2(operand(0u), operand(1u))).x);
      break;
    case VERIFY_CAMERA:
      answer_vector(0u, camera_ray(vec2(operand(11u), operand(12u))).direction);
      break;
    case VERIFY_UV: {
      vec2 uv = interpolated_uv(weighted_point(operand(6u), operand(7u)), 0u);
      answer(0u, uv.x);
      answer(1u, uv.y);
      break;
    }
    case VERIFY_FRAME: {
      vec4 frame = tangent_frame(weighted_point(0.0, 0.0), operand_vector(12u), plain_use(0u));
      answer_vector(0u, first_three(frame));
      answer(3u, frame.w);
      break;
    }
    case VERIFY_NORMAL: {
      TrianglePoint point = weighted_point(operand(9u), operand(10u));
      answer_vector(0u, smooth_point(point, operand_vector(11u), true).normal);
      break;
    }
  }
}
