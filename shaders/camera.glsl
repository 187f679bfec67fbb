// Camera rays. shaders/README.md, Image formation 2.
#ifndef VERNIER_CAMERA_GLSL
#define VERNIER_CAMERA_GLSL

#include "effect_runs.glsl"
#include "ray.glsl"

// The ray through (x, y) in pixels of the full image, (0, 0) its upper left corner. Its direction is unit.
Ray camera_ray(IN(vec2) pixel) {
  RenderConstants constants = render_constants();
  // The 1 taken from the numerator: after the division its rounding would be left in the middle of the image, which a wide
  // field of view magnifies. precise: with or without the parallel branch the same bits.
  float width = float(constants.image_width);
  float height = float(constants.image_height);
  precise float nx = (2.0f * pixel.x - width) / width;
  precise float ny = (height - 2.0f * pixel.y) / height;
  precise vec3 offset = constants.camera_right * nx + constants.camera_up * ny;
  if (effect_on(EFFECT_ORTHOGRAPHIC) && steering_constants().orthographic != 0u) {
    note_run(EFFECT_ORTHOGRAPHIC);
    precise vec3 origin = constants.camera_origin + offset;
    return Ray(origin, constants.camera_forward);
  }
  precise vec3 direction = offset + constants.camera_forward;
  return Ray(constants.camera_origin, unit_vector(direction));
}

#endif
