// Functions that verify_boundary.comp, verify_light.comp and verify_surface.comp call, one per pipeline, and the words of a call. Read by C++ and GLSL alike.
#ifndef VERNIER_SHARED_VERIFY_FUNCTIONS_H
#define VERNIER_SHARED_VERIFY_FUNCTIONS_H

#define VERIFY_OPERANDS 16u  // words per call
#define VERIFY_ANSWERS 16u   // and per answer

#define VERIFY_FRESNEL 0u     // cosine, eta -> reflected, transmitted, refracted_cosine
#define VERIFY_HIGHLIGHT 1u   // normal 3, to_light 3, to_viewer 3, exponent -> highlight
#define VERIFY_UNIT_VECTOR 2u  // v 3 -> unit vector 3
#define VERIFY_REFRACTION 3u  // to_viewer 3, normal 3 (also geometric), eta -> direction 3
#define VERIFY_MIRROR 4u      // to_viewer 3, normal 3, geometric normal 3 -> direction 3
#define VERIFY_SCHLICK 5u     // cosine -> weight
#define VERIFY_LOG_ONE_MINUS 6u  // s -> log(1 - s)
#define VERIFY_TEXTURE 7u  // u, v, width, height, wrap, filter -> value of a texture whose texel i, row by row, is i
// position 3, kind, direction 3, range, intensity, cos_outer, cone_scale, point 3 -> direction 3, irradiance
#define VERIFY_LIGHT 8u
#define VERIFY_CAMERA 9u  // right 3, up 3, forward 3, width, height, x, y -> direction 3
// even sample, odd sample, count (at most 60000: llvmpipe's loop limit), the sum so far in six 16-bit digits, low
// first, green of odd samples -> the red sum in six 16-bit digits, samples, those that were not finite, the first of them + 1
#define VERIFY_SUM 10u
#define VERIFY_UV 11u  // uv of the corners 6, weights of corners 1 and 2 -> uv 2
// uv of the corners 6, edges from corner 0 to 1 and 2 6, normal 3 -> tangent 3, handedness
#define VERIFY_FRAME 12u
#define VERIFY_NORMAL 13u  // normals of the corners 9, weights of corners 1 and 2, geometric normal 3 -> normal 3
// to_viewer 3, normal 3, eta -> direction within a plate whose faces lie across the normal 3, direction behind it 3
#define VERIFY_PLATE 14u

#endif
