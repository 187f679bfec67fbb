// Where a mesh lies that is traced in a space of its own: whole RGBA32UI texels, scalar layout. Read by C++ and GLSL alike.
#ifndef VERNIER_SHARED_INSTANCE_LAYOUT_H
#define VERNIER_SHARED_INSTANCE_LAYOUT_H

#include "shared/glsl.h"

#ifdef __cplusplus
namespace vernier {
using glm::uint;
using glm::vec4;
#endif

// The instance that is the scene itself: the traced space, unchanged.
#define INSTANCE_WORLD 0u

// Affine maps as rows: (x, y, z) are multiplied, w is added. object_from_traced is what decides where the mesh lies, since rays
// go through it; traced_from_object is its inverse, rounded.
struct DeviceInstance {
  vec4 object_from_traced_x, object_from_traced_y, object_from_traced_z;
  vec4 traced_from_object_x, traced_from_object_y, traced_from_object_z;
  uint first_triangle;  // global number of the mesh's first triangle
  float handedness;     // -1 where the map mirrors
  float roundings;      // 1; 0 where the maps round nothing
  uint free_word;
};

#define INSTANCE_TEXELS 7u
#define INSTANCE_OBJECT_FROM_TRACED 0u
#define INSTANCE_TRACED_FROM_OBJECT 3u
#define INSTANCE_WORDS 6u

#ifdef __cplusplus
static_assert(sizeof(DeviceInstance) == 16 * INSTANCE_TEXELS);
}  // namespace vernier
#endif

#endif
