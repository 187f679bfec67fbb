// Effect bits: the specialization constant EFFECTS is an OR of these. Read by C++ and GLSL alike.
// A bit that is set may be unnecessary; a bit that is clear removes work, never a field of a struct.
#ifndef VERNIER_SHARED_EFFECTS_H
#define VERNIER_SHARED_EFFECTS_H

#define EFFECT_SHADOWS (1u << 0)             // shadow rays
#define EFFECT_TINTED_SHADOWS (1u << 1)      // shadow rays pass masked, blended and transmissive triangles
#define EFFECT_REFLECTION (1u << 2)          // mirror rays
#define EFFECT_REFRACTION (1u << 3)          // transmitted rays
#define EFFECT_ABSORPTION (1u << 4)          // Beer-Lambert inside media
#define EFFECT_ALPHA_MASK (1u << 5)          // hits that are cut out
#define EFFECT_ALPHA_BLEND (1u << 6)         // surfaces that what lies behind shows through
#define EFFECT_SMOOTH_NORMALS (1u << 7)      // interpolated vertex normals
#define EFFECT_VERTEX_COLORS (1u << 8)
#define EFFECT_BASE_COLOR_TEXTURE (1u << 9)
#define EFFECT_SURFACE_TEXTURE (1u << 10)    // metallic-roughness, specular-glossiness, map_Ks
#define EFFECT_NORMAL_TEXTURE (1u << 11)
#define EFFECT_OCCLUSION_TEXTURE (1u << 12)
#define EFFECT_EMISSION_TEXTURE (1u << 13)
#define EFFECT_OTHER_TEXTURES (1u << 14)     // transmission, specular, specular colour, alpha
#define EFFECT_POINT_LIGHTS (1u << 15)       // point and spot
#define EFFECT_SPOT_LIGHTS (1u << 16)
#define EFFECT_DIRECTIONAL_LIGHTS (1u << 17)
#define EFFECT_SPECULAR (1u << 18)           // highlights of lights
#define EFFECT_AMBIENT (1u << 19)            // ambient light from the environment
#define EFFECT_EMISSION (1u << 20)
#define EFFECT_UNLIT (1u << 21)
#define EFFECT_ENVIRONMENT_MAP (1u << 22)    // an image as environment
#define EFFECT_ORTHOGRAPHIC (1u << 23)       // the camera's rays are parallel
#define EFFECT_FLOAT_TEXTURES (1u << 24)     // images of more than 8 bits per channel
#define EFFECT_COUNT 25u

#endif
