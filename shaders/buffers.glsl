// Sole owner of bindings. With LOADS_TEXELS the scene's arrays, the film and the samples are read through storage texel
// buffers, else through storage buffers. With RAY_QUERIES there is the driver's tree too.
#ifndef VERNIER_BUFFERS_GLSL
#define VERNIER_BUFFERS_GLSL

#include "shared/bindings.h"
#include "shared/film_layout.h"
#include "shared/render_constants.h"

layout(set = 0, binding = BINDING_RENDER, scalar) uniform RenderBlock { RenderConstants render; };
layout(set = 0, binding = BINDING_DISPATCH, scalar) readonly buffer DispatchBlock { DispatchConstants dispatch; };

#ifdef LOADS_TEXELS
layout(set = 0, binding = BINDING_RECORDS, rgba32ui) uniform readonly uimageBuffer record_texels;
layout(set = 0, binding = BINDING_VERTICES, rgba32ui) uniform readonly uimageBuffer vertex_texels;
layout(set = 0, binding = BINDING_MATERIALS, rgba32ui) uniform readonly uimageBuffer material_texels;
layout(set = 0, binding = BINDING_LIGHTS, rgba32ui) uniform readonly uimageBuffer light_texels;
layout(set = 0, binding = BINDING_TEXTURES, rgba32ui) uniform readonly uimageBuffer texture_texels;
layout(set = 0, binding = BINDING_TEXELS, rgba32ui) uniform readonly uimageBuffer texel_quads;
layout(set = 0, binding = BINDING_SRGB_CURVE, r32ui) uniform readonly uimageBuffer curve_words;
layout(set = 0, binding = BINDING_FIRST_TRIANGLES, r32ui) uniform readonly uimageBuffer first_triangle_words;
layout(set = 0, binding = BINDING_INSTANCES, rgba32ui) uniform readonly uimageBuffer instance_texels;
uvec4 load_record(uint i) { return imageLoad(record_texels, int(i)); }
uvec4 load_vertex(uint i) { return imageLoad(vertex_texels, int(i)); }
uvec4 load_material(uint i) { return imageLoad(material_texels, int(i)); }
uvec4 load_light(uint i) { return imageLoad(light_texels, int(i)); }
uvec4 load_texture(uint i) { return imageLoad(texture_texels, int(i)); }
// Words by fours: drivers bound the number of elements, whatever their size.
uvec4 load_texel_quad(uint i) { return imageLoad(texel_quads, int(i)); }
// Word i of them.
uint load_texel(uint i) {
  uvec4 quad = load_texel_quad(i >> 2);
  uint low = (i & 1u) == 0u ? quad.x : quad.y;
  uint high = (i & 1u) == 0u ? quad.z : quad.w;
  return (i & 2u) == 0u ? low : high;
}
uint load_curve(uint i) { return imageLoad(curve_words, int(i)).x; }
uint load_first_triangle(uint i) { return imageLoad(first_triangle_words, int(i)).x; }
uvec4 load_instance(uint i) { return imageLoad(instance_texels, int(i)); }
#else
layout(set = 0, binding = BINDING_RECORDS, scalar) readonly buffer Records { uvec4 record_texels[]; };
layout(set = 0, binding = BINDING_VERTICES, scalar) readonly buffer Vertices { uvec4 vertex_texels[]; };
layout(set = 0, binding = BINDING_MATERIALS, scalar) readonly buffer Materials { uvec4 material_texels[]; };
layout(set = 0, binding = BINDING_LIGHTS, scalar) readonly buffer Lights { uvec4 light_texels[]; };
layout(set = 0, binding = BINDING_TEXTURES, scalar) readonly buffer Textures { uvec4 texture_texels[]; };
layout(set = 0, binding = BINDING_TEXELS, scalar) readonly buffer Texels { uint texel_words[]; };
layout(set = 0, binding = BINDING_FIRST_TRIANGLES, scalar) readonly buffer FirstTriangles { uint first_triangle_words[]; };
layout(set = 0, binding = BINDING_INSTANCES, scalar) readonly buffer Instances { uvec4 instance_texels[]; };
uvec4 load_record(uint i) { return record_texels[i]; }
uvec4 load_vertex(uint i) { return vertex_texels[i]; }
uvec4 load_material(uint i) { return material_texels[i]; }
uvec4 load_light(uint i) { return light_texels[i]; }
uvec4 load_texture(uint i) { return texture_texels[i]; }
uvec4 load_texel_quad(uint i) { return uvec4(texel_words[4u * i], texel_words[4u * i + 1u], texel_words[4u * i + 2u], texel_words[4u * i + 3u]); }
uint load_texel(uint i) { return texel_words[i]; }
uint load_curve(uint i) { return texel_words[i]; }
uint load_first_triangle(uint i) { return first_triangle_words[i]; }
uvec4 load_instance(uint i) { return instance_texels[i]; }
#endif

#ifdef RAY_QUERIES
layout(set = 0, binding = BINDING_BOX_TREE) uniform accelerationStructureEXT box_tree;
#endif

layout(set = 0, binding = BINDING_FILM, scalar) buffer Film { uvec4 film_blocks[]; };
layout(set = 0, binding = BINDING_COUNTERS, scalar) buffer Counters { uint counters[]; };
layout(set = 0, binding = BINDING_PATHS, scalar) buffer Paths { uvec4 path_blocks[]; };
layout(set = 0, binding = BINDING_SAMPLES, scalar) buffer Samples { uvec4 sample_blocks[]; };
layout(set = 0, binding = BINDING_PIXELS, scalar) readonly buffer Pixels { uint listed_pixels[]; };
layout(set = 0, binding = BINDING_AOVS, scalar) buffer Aovs { uint aov_words[]; };
layout(set = 0, binding = BINDING_DISPLAY, scalar) buffer Display { uint display_words[]; };

// llvmpipe reads a word of a buffer lane by lane where lanes may be off, 20 cycles each: there an invocation keeps copies from
// its start on, when all lanes are on.
#ifdef LOADS_TEXELS
RenderConstants own_render;
DispatchConstants own_dispatch;
// To be called first.
void keep_dispatch_constants() { own_dispatch = dispatch; }
// The same, with those of the render.
void keep_constants() {
  own_render = render;
  keep_dispatch_constants();
}
RenderConstants render_constants() { return own_render; }
DispatchConstants dispatch_constants() { return own_dispatch; }
#else
void keep_dispatch_constants() {}
void keep_constants() {}
RenderConstants render_constants() { return render; }
DispatchConstants dispatch_constants() { return dispatch; }
#endif
SteeringConstants steering_constants() { return dispatch_constants().steering; }
bool scene_has_triangles() { return steering_constants().triangle_count > 0u; }

// For the same reason the accumulate kernel reads film and samples as texels: four words of all lanes at a time. A path is
// written and read by one kernel, where nothing but a barrier would make both views agree, and that llvmpipe gets wrong.
#ifdef LOADS_TEXELS
layout(set = 0, binding = BINDING_FILM_TEXELS, rgba32ui) uniform readonly uimageBuffer film_texels;
layout(set = 0, binding = BINDING_SAMPLE_TEXELS, rgba32ui) uniform readonly uimageBuffer sample_texels;
uvec4 load_film(uint i) { return imageLoad(film_texels, int(i)); }
uvec4 load_sample(uint i) { return imageLoad(sample_texels, int(i)); }
#else
uvec4 load_film(uint i) { return film_blocks[i]; }
uvec4 load_sample(uint i) { return sample_blocks[i]; }
#endif
void store_film(uint i, uvec4 block) { film_blocks[i] = block; }
uvec4 load_path(uint i) { return path_blocks[i]; }
void store_path(uint i, uvec4 block) { path_blocks[i] = block; }
void store_sample(uint i, uvec4 block) { sample_blocks[i] = block; }
void store_aov(uint i, uint word) { aov_words[i] = word; }
uint load_aov(uint i) { return aov_words[i]; }
void store_display(uint i, uint word) { display_words[i] = word; }
uint load_pixel(uint i) { return listed_pixels[i]; }
// Adds to a counter; 0 costs no memory traffic.
void add_to_counter(uint i, uint amount) {
  if (amount > 0u) atomicAdd(counters[i], amount);
}
uint load_counter(uint i) { return counters[i]; }
// The next job of the dispatch that nobody has taken; past the last one there is none.
#ifdef TAKES_JOBS_TOGETHER
// One lane takes for all that want one: each atomic addition of llvmpipe's threads waits for the other's.
uint take_job() {
  uvec4 takers = subgroupBallot(true);
  uint first = 0u;
  if (subgroupElect()) first = atomicAdd(counters[COUNTER_NEXT_JOB], subgroupBallotBitCount(takers));
  return subgroupBroadcastFirst(first) + subgroupBallotExclusiveBitCount(takers);
}
#else
uint take_job() { return atomicAdd(counters[COUNTER_NEXT_JOB], 1u); }
#endif

#endif
