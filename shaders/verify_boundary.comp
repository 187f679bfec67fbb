#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

// What happens to light at the boundary of two media: calls for `vernier verify`.

#include "verify_call.glsl"
#include "scatter_direction.glsl"

// The direction behind each of one or two plane boundaries across the same normal, as scatter() of trace_path.glsl asks for
// it; the second leads out again. A loop, so that the kernel holds the functions once.
void answer_refraction(uint boundaries) {
  vec3 to_viewer = operand_vector(0u);
  vec3 normal = operand_vector(3u);
  float eta = operand(6u);
  for (uint i = 0u; i < boundaries; i++) {
    float cosine = clamp(dot_product(normal, to_viewer), 0.0, 1.0);
    vec3 behind = refracted_direction(to_viewer, normal, normal, eta, fresnel_dielectric(cosine, eta));
    answer_vector(3u * i, behind);
    // From behind, the other face has the same normal towards the viewer.
    to_viewer = -behind;
    eta = 1.0 / eta;
  }
}

void main() {
  if (!is_called()) return;
  switch (FUNCTION) {
    case VERIFY_FRESNEL: {
      Fresnel fresnel = fresnel_dielectric(operand(0u), operand(1u));
      answer(0u, fresnel.reflected);
      answer(1u, fresnel.transmitted);
      answer(2u, fresnel.refracted_cosine);
      break;
    }
    case VERIFY_REFRACTION:
    case VERIFY_PLATE:
      answer_refraction(FUNCTION == VERIFY_PLATE ? 2u : 1u);
      break;
    case VERIFY_MIRROR:
      answer_vector(0u, mirrored_direction(operand_vector(0u), operand_vector(3u), operand_vector(6u)));
      break;
    case VERIFY_SCHLICK:
      answer(0u, schlick_weight(operand(0u)));
      break;
  }
}
