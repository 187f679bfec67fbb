// Ids and flags of materials and textures, read by C++ and GLSL alike.
#ifndef VERNIER_SHARED_MATERIAL_FLAGS_H
#define VERNIER_SHARED_MATERIAL_FLAGS_H

#define WORKFLOW_METALLIC_ROUGHNESS 0u
#define WORKFLOW_SPECULAR_GLOSSINESS 1u
#define WORKFLOW_BLINN 2u
#define ALL_WORKFLOWS 7u  // OR of 1 << WORKFLOW_*

#define ALPHA_OPAQUE 0u
#define ALPHA_MASK 1u
#define ALPHA_BLEND 2u

// Bits 0-1 of the flags word are the workflow, bits 2-3 the alpha mode.
#define MATERIAL_WORKFLOW_MASK 3u
#define MATERIAL_ALPHA_SHIFT 2u
#define MATERIAL_ALPHA_MASK 3u
#define MATERIAL_UNLIT 16u
#define MATERIAL_THIN_WALLED 32u
#define MATERIAL_FRESNEL_REFLECTION 64u

// Texture slots. What a slot means in each workflow (channels in brackets, c: colour, sRGB unless the file says otherwise):
//                                   metallic-roughness        specular-glossiness      blinn
#define TEXTURE_SLOT_BASE_COLOR 0    // base colour [rgb c, a]  diffuse [rgb c, a]       map_Kd [rgb c]
#define TEXTURE_SLOT_SURFACE 1       // [g rough, b metal]      [rgb c spec, a gloss]    map_Ks [rgb c]
#define TEXTURE_SLOT_NORMAL 2        // tangent space, all workflows (height maps are converted by the loader)
#define TEXTURE_SLOT_OCCLUSION 3     // [r]                     [r]                      -
#define TEXTURE_SLOT_EMISSION 4      // [rgb c]                 [rgb c]                  map_Ke [rgb c]
#define TEXTURE_SLOT_TRANSMISSION 5  // [r]                     -                        -
#define TEXTURE_SLOT_SPECULAR 6      // factor [a]              -                        map_Ns [r]
#define TEXTURE_SLOT_SPECULAR_COLOR 7  // [rgb c]               -                        map_Ka [rgb c]
#define TEXTURE_SLOT_ALPHA 8         // -                       -                        map_d [r]
#define TEXTURE_SLOT_COUNT 9

// How texel words are stored, and what lies outside [0, 1).
#define TEXTURE_FORMAT_SRGB8 0u    // one word, r in the low byte, rgb through the sRGB curve, a linear
#define TEXTURE_FORMAT_LINEAR8 1u  // one word, r in the low byte, value / 255
#define TEXTURE_FORMAT_FLOAT 2u    // four words, rgba float32
#define TEXTURE_WRAP_REPEAT 0u
#define TEXTURE_WRAP_CLAMP 1u
#define TEXTURE_WRAP_MIRROR 2u
#define TEXTURE_FILTER_NEAREST 0u
#define TEXTURE_FILTER_LINEAR 1u

#endif
