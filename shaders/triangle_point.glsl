// A hit triangle: its corners, its vertices and their attributes at the hit.
#ifndef VERNIER_TRIANGLE_POINT_GLSL
#define VERNIER_TRIANGLE_POINT_GLSL

#include "material.glsl"
#include "ray.glsl"

// A triangle's corners, vertices and the weights of the hit.
struct TrianglePoint {
  vec3 v0, e1, e2;  // corner 0 and the edges to corners 1 and 2
  uvec4 vertices;   // vertex 0, 1, 2, material
  float b0, b1, b2;
};

// The triangle of `hit`, which hit something.
TrianglePoint triangle_point(IN(Hit) hit) {
  uvec4 a = load_record(3u * hit.record);
  uvec4 b = load_record(3u * hit.record + 1u);
  uvec4 c = load_record(3u * hit.record + 2u);
  vec3 v0 = first_three(float_texel(a));
  vec3 e1 = first_three(float_texel(b)) - v0;
  vec3 e2 = first_three(float_texel(c)) - v0;
  return TrianglePoint(v0, e1, e2, load_triangle(hit.triangle), 1.0f - hit.b1 - hit.b2, hit.b1, hit.b2);
}

// Attribute at offset `texel` of a vertex.
vec4 vertex_attribute(IN(uint) vertex, IN(uint) texel) {
  return float_texel(load_vertex(vertex * steering_constants().vertex_texels + texel));
}

// Attribute at offset `texel` of the three vertices, weighed.
vec4 interpolated(IN(TrianglePoint) point, IN(uint) texel) {
  return vertex_attribute(point.vertices.x, texel) * point.b0 + vertex_attribute(point.vertices.y, texel) * point.b1 +
         vertex_attribute(point.vertices.z, texel) * point.b2;
}

// UV set `set` out of a texel that holds two of them.
vec2 uv_of_set(IN(vec4) pair, IN(uint) set) { return (set & 1u) == 0u ? vec2(pair.x, pair.y) : vec2(pair.z, pair.w); }

// Offset of the texel that holds UV set `set`, or NONE.
uint uv_texel(IN(uint) set) {
  SteeringConstants constants = steering_constants();
  return set < 2u ? constants.uv01_texel : constants.uv23_texel;
}

// UV set `set` at the hit; (0, 0) where no mesh has it.
vec2 interpolated_uv(IN(TrianglePoint) point, IN(uint) set) {
  uint texel = uv_texel(set);
  return texel == NONE ? vec2(0.0f) : uv_of_set(interpolated(point, texel), set);
}

// Vertex colour and opacity at the hit; (1, 1, 1, 1) where no mesh has one.
vec4 vertex_color(IN(TrianglePoint) point) {
  uint texel = steering_constants().color_texel;
  if (!effect_on(EFFECT_VERTEX_COLORS) || texel == NONE) return vec4(1.0f);
  return interpolated(point, texel);
}

#endif
