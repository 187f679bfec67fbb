// How much light comes through from a light to a point. shaders/README.md, Image formation 5.8.
#ifndef VERNIER_SHADOW_GLSL
#define VERNIER_SHADOW_GLSL

#include "path.glsl"
#include "shading_terms.glsl"
#include "fresnel.glsl"
#include "traverse_bvh.glsl"

// Slots that decide how much light a surface lets pass.
const uint TRANSMITTANCE_SLOTS = 1u << TEXTURE_SLOT_BASE_COLOR | 1u << TEXTURE_SLOT_SURFACE |
                                1u << TEXTURE_SLOT_TRANSMISSION | 1u << TEXTURE_SLOT_ALPHA;

struct Transmittance {
  vec3 value;
  bool finished;  // false: cut off by a loop limit, the value may not be used
};

// Books a traversal.
void count_cost(INOUT(RayCounts) counts, IN(TraversalCost) cost) {
  counts.nodes += cost.nodes;
  counts.triangles += cost.triangles;
}

// Factor of the hit alone, without absorption: 1 - a + a t.
vec3 hit_transmittance(IN(DeviceMaterial) material, IN(SlotTexels) texels, IN(vec4) color, IN(float) alpha, IN(float) cosine) {
  vec3 through = vec3(0.0f);
  if (is_transmissive(material)) {
    bool fresnel_free = workflow_of(material) == WORKFLOW_BLINN && !has_flag(material, MATERIAL_FRESNEL_REFLECTION);
    through = shading_terms(material, texels, first_three(color)).transmission;
    through *= fresnel_free ? 1.0f : fresnel_dielectric(cosine, material.ior).transmitted;
  }
  return vec3(1.0f - alpha) + through * alpha;
}

// Transmittance along `ray` from t = 0 to t_max, hit by hit in their order; opaque hits anywhere end it.
Transmittance tinted_transmittance(IN(Ray) ray, IN(float) t_max, INOUT(RayCounts) counts) {
  Transmittance result = Transmittance(vec3(1.0f), true);
  vec3 optical_depth = vec3(0.0f);
  float length_of_t = sqrt(dot_product(ray.direction, ray.direction));
  float t_min = 0.0f;
  uint after_triangle = NONE;
  bool open = true;
  for (uint i = 0u; open && i < TRAVERSAL_STEP_LIMIT; i++) {
    Hit hit = no_hit(t_max);
    TraversalCost cost = traverse_bvh(ray, t_min, after_triangle, true, hit);
    count_cost(counts, cost);
    result.finished = result.finished && cost.finished;
    open = hit.triangle != NONE && cost.finished;
    if (open) {
      TrianglePoint point = triangle_point(hit);
      DeviceMaterial material = fetch_material(point.vertices.w);
      SlotTexels texels = fetch_slot_texels(point, material, TRANSMITTANCE_SLOTS);
      vec4 color = vertex_color(point);
      result.finished = result.finished && texels.finished;
      float alpha = surface_alpha(material, texels, color);
      vec3 normal = unit_vector(cross_product(point.e1, point.e2));
      float along = dot_product(normal, ray.direction) / length_of_t;
      result.value *= hit_transmittance(material, texels, color, alpha, min(abs(along), 1.0f));
      if (effect_on(EFFECT_ABSORPTION) && is_transmissive(material) && !has_flag(material, MATERIAL_THIN_WALLED) && alpha > 0.0f) {
        optical_depth += material.absorption * (along > 0.0f ? hit.t * length_of_t : -hit.t * length_of_t);
      }
      t_min = hit.t;
      after_triangle = hit.triangle;
      open = max3(result.value) > 0.0f;
    }
  }
  result.finished = result.finished && !open;
  if (effect_on(EFFECT_ABSORPTION)) result.value *= exp(-max(optical_depth, vec3(0.0f)));
  return result;
}

// Transmittance along `ray` from t = 0 to t_max.
Transmittance transmittance(IN(Ray) ray, IN(float) t_max, INOUT(RayCounts) counts) {
  if (effect_on(EFFECT_TINTED_SHADOWS)) return tinted_transmittance(ray, t_max, counts);
  Hit hit = no_hit(t_max);
  TraversalCost cost = traverse_bvh(ray, 0.0f, NONE, true, hit);
  count_cost(counts, cost);
  return Transmittance(hit.triangle != NONE ? vec3(0.0f) : vec3(1.0f), cost.finished);
}

#endif
