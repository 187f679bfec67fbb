// Light from all around: the background a ray sees and the ambient light a surface receives.
#ifndef VERNIER_ENVIRONMENT_GLSL
#define VERNIER_ENVIRONMENT_GLSL

#include "texture.glsl"

const float INVERSE_PI = 0.31830988618379067154f;
const float HALF_PI = 1.57079632679489661923f;

// atan(x) for x in [0, 1], absolute error below 2e-7: Taylor about the nearer of 0 and 1. GLSL's own may be off by 4096 ulp.
float arc_tangent(IN(float) x) {
  // Beyond tan(pi / 8): atan(x) = pi / 4 + atan((x - 1) / (x + 1)).
  bool upper = x > 0.41421356f;
  float y = upper ? (x - 1.0f) / (x + 1.0f) : x;
  float s = y * y;
  // Terms to y^15: the next, y^17 / 17 at tan(pi / 8), is below 2e-8.
  float series = 1.0f + s * (-1.0f / 3.0f + s * (1.0f / 5.0f + s * (-1.0f / 7.0f + s * (1.0f / 9.0f + s * (-1.0f / 11.0f +
                 s * (1.0f / 13.0f + s * (-1.0f / 15.0f)))))));
  return (upper ? 0.78539816339744831f : 0.0f) + y * series;
}

// Angle of (x, y) from the x axis in (-pi, pi]; 0 for (0, 0).
float angle_of(IN(float) y, IN(float) x) {
  float larger = max(abs(x), abs(y));
  if (!(larger > 0.0f)) return 0.0f;
  float angle = arc_tangent(min(abs(x), abs(y)) / larger);
  angle = abs(y) > abs(x) ? HALF_PI - angle : angle;
  angle = x < 0.0f ? 2.0f * HALF_PI - angle : angle;
  return y < 0.0f ? -angle : angle;
}

// Radiance that arrives along unit `direction` (the way the ray goes) from beyond the scene.
vec3 environment_radiance(IN(vec3) direction) {
  RenderConstants constants = render_constants();
  uint image = steering_constants().environment_texture;
  if (effect_on(EFFECT_ENVIRONMENT_MAP) && image != NONE) {
    note_run(EFFECT_ENVIRONMENT_MAP);
    float around = angle_of(direction.x, -direction.z) * (0.5f * INVERSE_PI) + 0.5f;
    float horizontal = sqrt(direction.x * direction.x + direction.z * direction.z);
    float down = angle_of(horizontal, direction.y) * INVERSE_PI;
    return first_three(sample_texture(image, vec2(around, down))) * constants.environment_scale;
  }
  return mix(constants.ground, constants.sky, 0.5f + 0.5f * direction.y);
}

// Cosine-weighted mean radiance around unit normal n (irradiance / pi) from order-2 spherical harmonics (Ramamoorthi and
// Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps"), constants folded in by the host; >= 0.
vec3 ambient_radiance(IN(vec3) n) {
  RenderConstants constants = render_constants();
  vec3 sum = constants.ambient_harmonics[0] + constants.ambient_harmonics[1] * n.y + constants.ambient_harmonics[2] * n.z +
             constants.ambient_harmonics[3] * n.x + constants.ambient_harmonics[4] * (n.x * n.y) +
             constants.ambient_harmonics[5] * (n.y * n.z) + constants.ambient_harmonics[6] * (3.0f * n.z * n.z - 1.0f) +
             constants.ambient_harmonics[7] * (n.x * n.z) + constants.ambient_harmonics[8] * (n.x * n.x - n.y * n.y);
  return max(sum, vec3(0.0f));
}

#endif
