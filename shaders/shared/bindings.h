// Binding numbers of descriptor set 0, read by C++ and GLSL alike.
#ifndef VERNIER_SHARED_BINDINGS_H
#define VERNIER_SHARED_BINDINGS_H

#define BINDING_RENDER 0            // RenderConstants, uniform
#define BINDING_RECORDS 1           // BVH records, uvec4, 3 per record (bvh_record.h)
#define BINDING_INSTANCES 2         // uvec4, INSTANCE_TEXELS per instance of a shared mesh (instance_layout.h)
#define BINDING_VERTICES 3          // uvec4, SteeringConstants::vertex_texels per vertex
#define BINDING_MATERIALS 4         // uvec4, MATERIAL_TEXELS per material
#define BINDING_LIGHTS 5            // uvec4, LIGHT_TEXELS per light
#define BINDING_TEXTURES 6          // uvec4 per texture: width, height, first word, format | wrap and filter bits
#define BINDING_TEXELS 7            // uint: 256 of the sRGB curve, then texels, each texture's from a multiple of 4 on
#define BINDING_FILM 8              // uint, FILM_WORDS per pixel of a band
#define BINDING_COUNTERS 9          // uint, COUNTER_COUNT
#define BINDING_PATHS 10            // uvec4, PATH_BLOCKS(stack) per invocation
#define BINDING_FIRST_TRIANGLES 11  // uint per object: number of its first triangle
#define BINDING_AOVS 12             // uint, AOV_WORDS per pixel of a band
#define BINDING_DISPATCH 13         // DispatchConstants
#define BINDING_SAMPLES 14          // uvec4, SAMPLE_BLOCKS per job
#define BINDING_PIXELS 15           // uint per listed pixel: y << 16 | x within the tile
#define BINDING_DISPLAY 16          // uint per pixel of a window's picture: R8G8B8A8
#define BINDING_FILM_TEXELS 17      // the memory of BINDING_FILM, read as uvec4 texels (buffers.glsl, LOADS_TEXELS)
#define BINDING_SAMPLE_TEXELS 18    // the memory of BINDING_SAMPLES, likewise
#define BINDING_BOX_TREE 19         // the driver's tree over the boxes of the triangles' records (RAY_QUERIES)
#define BINDING_SRGB_CURVE 20       // uint: the curve alone (LOADS_TEXELS, where BINDING_TEXELS is read as uvec4)

#endif
