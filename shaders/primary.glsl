// What the ray through the pixel centre sees first: the AOVs. shaders/README.md, Image formation 6.
#ifndef VERNIER_PRIMARY_GLSL
#define VERNIER_PRIMARY_GLSL

#include "camera.glsl"
#include "shared/film_layout.h"
#include "path.glsl"
#include "shading_terms.glsl"
#include "search_scene.glsl"

void store_aov_vector(IN(uint) first, IN(vec3) v) {
  store_aov(first, floatBitsToUint(v.x));
  store_aov(first + 1u, floatBitsToUint(v.y));
  store_aov(first + 2u, floatBitsToUint(v.z));
}

// The closest hit with alpha above 0; masks and clear panes are passed.
Hit first_visible_hit(IN(Ray) ray) {
  Hit hit = no_hit(LARGEST_FLOAT);
  float t_min = 0.0f;
  uint after_triangle = NONE;
  uint round = 0u;
  bool done = false;
  for (;;) {
    if (!TEST_LAST && done) break;
    hit = search_scene(Search(ray, t_min, after_triangle, LARGEST_FLOAT, false)).hit;
    bool looking = false;
    if (rays_pass_hits() && hit.triangle != NONE) {
      TrianglePoint point = triangle_point(ray, hit);
      DeviceMaterial material = fetch_material(point.vertices.w);
      SlotTexels texels = fetch_slot_texels(point, material, 1u << TEXTURE_SLOT_BASE_COLOR | 1u << TEXTURE_SLOT_ALPHA);
      looking = surface_alpha(material, texels, vertex_color(point)) == 0.0f;
      t_min = hit.t;
      after_triangle = hit.triangle;
    }
    round++;
    done = !looking || round >= LOOP_ROUND_LIMIT;
    if (TEST_LAST && done) break;
  }
  return hit;
}

// The object that has this triangle: the last one whose first triangle is not beyond it. Halving ends after 32 rounds.
uint object_of(IN(uint) triangle) {
  uint object = 0u;
  uint beyond = steering_constants().object_count;
  for (uint i = 0u; object + 1u < beyond && i < 32u; i++) {
    uint middle = object + (beyond - object) / 2u;
    bool reached = load_first_triangle(middle) <= triangle;
    object = reached ? middle : object;
    beyond = reached ? beyond : middle;
  }
  return object;
}

void store_miss(IN(uint) first) {
  for (uint i = 0u; i < AOV_WORDS; i++) store_aov(first + i, 0u);
  store_aov(first + AOV_DEPTH, 0x7f800000u);  // +infinity
  store_aov(first + AOV_OBJECT_ID, NONE);
  store_aov(first + AOV_MATERIAL_ID, NONE);
  store_aov(first + AOV_PRIMITIVE_ID, NONE);
  store_aov(first + AOV_TRIANGLE, NONE);
}

// Writes the AOVs of pixel number `pixel` of the band for the camera ray through `position` (pixels).
void trace_primary(IN(vec2) position, IN(uint) pixel) {
  RenderConstants constants = render_constants();
  uint first = pixel * AOV_WORDS;
  Ray ray = camera_ray(position);
  Hit hit = first_visible_hit(ray);
  if (hit.triangle == NONE) {
    store_miss(first);
    return;
  }
  TrianglePoint point = triangle_point(ray, hit);
  DeviceMaterial material = fetch_material(point.vertices.w);
  SlotTexels texels = fetch_slot_texels(point, material, readable_slots());
  vec4 color = vertex_color(point);
  SurfacePoint surface = surface_point(point, material, texels, ray.direction);
  vec2 uv = interpolated_uv(point, 0u);
  store_aov(first + AOV_DEPTH, floatBitsToUint(point.t * constants.metres_per_unit));
  store_aov_vector(first + AOV_POSITION, surface.position * constants.metres_per_unit + constants.world_center);
  store_aov_vector(first + AOV_NORMAL, surface.geometric_normal);
  store_aov_vector(first + AOV_SHADING_NORMAL, surface.normal);
  store_aov(first + AOV_UV, floatBitsToUint(uv.x));
  store_aov(first + AOV_UV + 1u, floatBitsToUint(uv.y));
  store_aov_vector(first + AOV_ALBEDO, shading_terms(material, texels, first_three(color)).base);
  uint object = object_of(hit.triangle);
  store_aov(first + AOV_OBJECT_ID, object);
  store_aov(first + AOV_MATERIAL_ID, point.vertices.w);
  store_aov(first + AOV_PRIMITIVE_ID, hit.triangle - load_first_triangle(object));
  store_aov(first + AOV_TRIANGLE, hit.triangle);
}

#endif
