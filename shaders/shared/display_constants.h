// What a window shows of a film, and where. Read by C++ and GLSL alike.
#ifndef VERNIER_SHARED_DISPLAY_CONSTANTS_H
#define VERNIER_SHARED_DISPLAY_CONSTANTS_H

#include "shared/glsl.h"

#define DISPLAY_COLOR 0u
#define DISPLAY_DEPTH 1u
#define DISPLAY_NORMAL 2u
#define DISPLAY_SHADING_NORMAL 3u
#define DISPLAY_ALBEDO 4u
#define DISPLAY_OBJECT 5u
#define DISPLAY_MATERIAL 6u
#define DISPLAY_PRIMITIVE 7u
#define DISPLAY_RAYS 8u
#define DISPLAY_COUNT 9u

#ifdef __cplusplus
namespace vernier {
using glm::uint;
#endif

struct DisplayConstants {
  uint width;       // pixels of the picture
  uint height;      // its rows in this band
  uint row_pixels;  // pixels of a row of the film
  uint first_row;   // of the picture, where the band begins
  float exposure;   // factor of the colour
  float far_depth;  // metres at which the depth is shown half as bright
  uint layer;       // DISPLAY_*
};

#ifdef __cplusplus
}
#endif

#endif
