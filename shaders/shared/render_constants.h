// What stays the same for all dispatches of a render, and what changes from one to the next. Scalar layout.
// "Units" are those of the traced space: the scene shifted and scaled by a power of two into [-1, 1] (pack_scene).
#ifndef VERNIER_SHARED_RENDER_CONSTANTS_H
#define VERNIER_SHARED_RENDER_CONSTANTS_H

#include "shared/glsl.h"

#ifdef __cplusplus
namespace vernier {
using glm::uint;
using glm::vec3;
#endif

// Marks an attribute, texture or id that is not there.
#define NONE 0xffffffffu

// How a pixel weighs its samples (README, Image formation 1): 1 within the pixel, or a tent two pixels wide.
#define PIXEL_FILTER_BOX 0u
#define PIXEL_FILTER_TENT 1u

struct RenderConstants {
  vec3 camera_origin;  // units
  uint image_width;    // pixels of the full image
  vec3 camera_right;   // perspective: a t X; orthographic: a h X in units
  uint image_height;
  vec3 camera_up;  // perspective: t Y; orthographic: h Y in units
  uint seed;
  vec3 camera_forward;  // -Z
  float cutoff;
  vec3 sky;
  float metres_per_unit;
  vec3 ground;
  uint max_bounces;
  vec3 environment_scale;
  vec3 world_center;          // metres: world = unit x metres_per_unit + world_center
  vec3 ambient_harmonics[9];  // environment_harmonics.h
};

// Values that a branch may depend on alone. They lie in a storage buffer: llvmpipe compiles a kernel anew for every
// value of a uniform or push constant that decides a branch, 10 ms for each submission.
struct SteeringConstants {
  uint spp;                  // of the whole image; 1: pixel centres
  uint orthographic;         // 1: parallel rays
  uint environment_texture;  // NONE: the gradient
  uint light_count;
  uint triangle_count;
  uint vertex_texels;  // uvec4 per vertex: 0, or at least the first one, (normal or 0, material)
  uint normal_texel;   // 0, or NONE: no vertex has a normal
  uint uv01_texel;     // offset within a vertex of (uv set 0, uv set 1), or NONE; the next three likewise
  uint uv23_texel;     // (uv set 2, uv set 3)
  uint color_texel;
  uint tangent_texel;
  uint pixel_filter;  // PIXEL_FILTER_*
  uint object_count;  // numbers in BINDING_FIRST_TRIANGLES
  uint one;           // 1 (traverse_bvh.glsl, first_texel)
};

// One dispatch; steering constants go with it.
struct DispatchConstants {
  uint tile_x;  // pixels of the full image
  uint tile_y;
  uint tile_width;
  uint tile_height;
  uint band_x;  // first pixel of the film band that is bound
  uint band_y;
  uint band_width;
  uint sample_begin;  // samples of this pass
  uint sample_end;
  uint job_end;        // jobs from here on are left to later dispatches
  uint search_budget;  // searches after which an invocation takes no further job
  uint search_limit;   // and after which it saves its path; not below the budget
  uint resume;         // 1: go on with the saved paths
  uint pixel_count;    // of the list, with LISTED_PIXELS
  SteeringConstants steering;
};

#ifdef __cplusplus
static_assert(sizeof(RenderConstants) == 4 * (6 * 4 + 6 + 27));
static_assert(sizeof(DispatchConstants) == 4 * (14 + 14));
}  // namespace vernier
#endif

#endif
