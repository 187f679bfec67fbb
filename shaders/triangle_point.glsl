// A hit triangle: its corners, its vertices and their attributes at the hit.
#ifndef VERNIER_TRIANGLE_POINT_GLSL
#define VERNIER_TRIANGLE_POINT_GLSL

#include "effect_runs.glsl"
#include "exact_crossing.glsl"
#include "instance.glsl"
#include "intersect_triangle.glsl"
#include "shared/bvh_record.h"

// A triangle's corners, vertices and the weights of the hit.
struct TrianglePoint {
  vec3 v0, e1, e2;  // corner 0 and the edges to corners 1 and 2
  uvec4 vertices;   // vertex 0, 1, 2, material
  float b0, b1, b2;
  float t;
  vec3 position;        // of the hit
  vec3 position_error;  // bound of its distance from the triangle's plane, per axis
  // With INSTANCED:
  uint instance;
  vec3 normal;         // geometric, unit, on the side from which the corners are seen counter-clockwise
  float normal_error;  // how far along the normal, beyond position_error, a ray must start that goes on
};

// At the exact level a point is off its plane by its rounding alone, but a ray that goes on along a neighbour meets corners that
// are rounded in the ray's frame: by this share of the extent and no bound, but 2 million grazing rays beside edges met none.
const float NEIGHBOUR_ROUNDINGS = 2.0f;

// The point of the triangle v0 v1 v2 with these weights of its corners. Its place is summed with the largest term last: off
// the plane by the triangle's own rounding however far the ray came from. Edges (1 rounding), products (1), their sum (1) and
// its neighbours, each at most half an ulp of the extent; the last sum and the offset's own rounding (spawn_ray.glsl) at most
// half an ulp of the place.
TrianglePoint weighted_point(IN(vec3) v0, IN(vec3) v1, IN(vec3) v2, IN(uvec4) vertices, IN(vec3) weights, IN(float) t) {
  vec3 e1 = v1 - v0;
  vec3 e2 = v2 - v0;
  precise vec3 position = v0 + (e1 * weights.y + e2 * weights.z);
  vec3 extent = max(abs(e1), abs(e2));
  vec3 position_error = HALF_ULP_OF_ONE * (2.0f * abs(v0) + 6.0f * extent);
  return TrianglePoint(v0, e1, e2, vertices, weights.x, weights.y, weights.z, t, position, position_error, INSTANCE_WORLD, vec3(0.0f),
                       0.0f);
}

// The point of the triangle v0 v1 v2 that `ray` met at `hit`.
TrianglePoint point_on_triangle(IN(Ray) ray, IN(Hit) hit, IN(vec3) v0, IN(vec3) v1, IN(vec3) v2, IN(uvec4) vertices) {
  TrianglePoint point;
  if (level_at(SPOT_POSITION) == LEVEL_EXACT) {
    point = weighted_point(v0, v1, v2, vertices, vec3(0.0f), hit.t);
    ExactCrossing crossing = exact_crossing(ray, v0, v1, v2);
    point.b0 = crossing.b0;
    point.b1 = crossing.b1;
    point.b2 = crossing.b2;
    point.t = crossing.t;
    point.position = crossing.position;
    // Rounded once, and once more with the offset.
    const float roundings = 2.0000019073486328f;  // 2 + 2^-19: what the wide arithmetic leaves
    vec3 extent = max(abs(point.e1), abs(point.e2));
    point.position_error = HALF_ULP_OF_ONE * (roundings * abs(crossing.position) + NEIGHBOUR_ROUNDINGS * extent);
  } else {
    point = weighted_point(v0, v1, v2, vertices, crossing_weights(ray, v0, v1, v2), hit.t);
  }
  if (level_at(SPOT_POSITION) == LEVEL_FAST) point.position = ray.origin + ray.direction * hit.t;
  return point;
}

// Takes `point`, found in the space of `instance`, to the traced space, where `ray` met it. Bounds of errors in half ulps
// (HALF_ULP_OF_ONE):
// - of the place: each number of the map 1 for its own rounding, products 1, their sums and what is added 3, the offset's own
//   rounding (spawn_ray.glsl) 1: 6 of the size that it is summed up from. The error within the object's space comes on top.
// - of the way back: the next ray's origin is mapped into the object's space again, 4 of the size that it is summed up from
//   (instance.glsl), and its direction, 3 of its: while that crosses the triangle it covers the sum of two edges at most, along
//   each axis. A distance along the object's normal n is 1 / |n A| of it in the traced space, A the linear part of the map.
// After NVIDIA's self-intersection-avoidance, which leaves the direction out.
void place_point(INOUT(TrianglePoint) point, IN(Ray) ray, IN(uint) instance) {
  AffineMap in_map = fetch_map(instance, INSTANCE_OBJECT_FROM_TRACED);
  AffineMap out_map = fetch_map(instance, INSTANCE_TRACED_FROM_OBJECT);
  uvec4 words = fetch_instance_words(instance);
  float half_ulp = HALF_ULP_OF_ONE * uintBitsToFloat(words.z);
  vec3 within = unit_vector(cross_product(point.e1, point.e2));
  vec3 normal = mutated(MUTATION_POINT_NORMAL) ? mapped_vector(out_map, within) : mapped_normal(in_map, within);
  vec3 position = mapped_point(out_map, point.position);
  if (level_at(SPOT_POSITION) == LEVEL_FAST) position = ray.origin + ray.direction * point.t;
  vec3 place_error = mapped_bound(out_map, point.position_error) + mapped_size(out_map, point.position) * (6.0f * half_ulp);
  vec3 e1 = mapped_vector(out_map, point.e1);
  vec3 e2 = mapped_vector(out_map, point.e2);
  vec3 back_error = (mapped_size(in_map, position) * 4.0f + mapped_bound(in_map, abs(e1) + abs(e2)) * 3.0f) * half_ulp;
  float stretch = sqrt(dot_product(normal, normal));
  point.instance = instance;
  point.normal = unit_vector(normal);
  point.normal_error = stretch > 0.0f ? dot_product(abs(within), back_error) / stretch : 0.0f;
  point.position = position;
  point.position_error = place_error;
  point.v0 = mapped_point(out_map, point.v0);
  point.e1 = e1;
  point.e2 = e2;
}

// Vertices 0, 1, 2 and the material that words 3 and 7 of a triangle record say (shared/bvh_record.h).
uvec4 fetch_vertices(IN(uint) word3, IN(uint) word7) {
  uint texels = steering_constants().vertex_texels;
  uint first = BVH_VERTEX_NUMBER(word3);
  uvec4 vertices = uvec4(first, first + uint(int(word7 << 16) >> 16), first + uint(int(word7) >> 16), word7);
  if (texels > 0u) vertices.w = load_vertex(first * texels).w;
  return vertices;
}

// The triangle of `hit`, which `ray` met.
TrianglePoint triangle_point(IN(Ray) ray, IN(Hit) hit) {
  uvec4 a = load_record(3u * hit.record);
  uvec4 b = load_record(3u * hit.record + 1u);
  uvec4 c = load_record(3u * hit.record + 2u);
  Ray within = ray;
  if (INSTANCED) within = ray_in_instance(ray, hit.instance);
  TrianglePoint point = point_on_triangle(within, hit, first_three(float_texel(a)), first_three(float_texel(b)),
                                          first_three(float_texel(c)), fetch_vertices(a.w, b.w));
  if (INSTANCED) place_point(point, ray, hit.instance);
  return point;
}

// Its geometric normal, unit, on the side from which the corners are seen counter-clockwise.
vec3 winding_normal(IN(TrianglePoint) point) {
  return INSTANCED ? point.normal : unit_vector(cross_product(point.e1, point.e2));
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
  vec2 uv = texel == NONE ? vec2(0.0f) : uv_of_set(interpolated(point, texel), set);
  if (mutated(MUTATION_SHORT_FLOATS)) uv = uintBitsToFloat(floatBitsToUint(uv) & HALF_FLOAT_BITS);
  return uv;
}

// Vertex colour and opacity at the hit; (1, 1, 1, 1) where no mesh has one.
vec4 vertex_color(IN(TrianglePoint) point) {
  uint texel = steering_constants().color_texel;
  if (!effect_on(EFFECT_VERTEX_COLORS) || texel == NONE) return vec4(1.0f);
  note_run(EFFECT_VERTEX_COLORS);
  // From corner 0, so that three equal ones give what they are: an opacity of 1 is none below a cutoff of 1.
  vec4 c0 = vertex_attribute(point.vertices.x, texel);
  return c0 + (vertex_attribute(point.vertices.y, texel) - c0) * point.b1 + (vertex_attribute(point.vertices.z, texel) - c0) * point.b2;
}

#endif
