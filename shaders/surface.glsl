// What lies at a hit: its place, its normals and where its textures are read. shaders/README.md, Image formation 3.
#ifndef VERNIER_SURFACE_GLSL
#define VERNIER_SURFACE_GLSL

#include "slot_texels.glsl"

// A hit triangle with all that the corners say.
struct SurfacePoint {
  vec3 position;         // units, on the triangle as exactly as floats allow
  vec3 position_error;   // bound of its error per axis
  vec3 geometric_normal;  // unit, towards the viewer
  vec3 normal;           // unit, shading, towards the viewer
  bool front;            // the viewer sees the front side
  uint material;
  float normal_error;    // with INSTANCED: TrianglePoint's
  vec3 rise;  // from `position` to the surface that the vertex normals round the triangle off to, where that lies above
  // The weights of corners 1 and 2, and by how much they change on a way along the triangle: its product with these / area.
  float b1, b2;
  vec3 across1, across2;
  float area;
};

// What the corners' normals say at a hit.
struct SmoothPoint {
  vec3 normal;  // unit, on the side of the triangle's
  vec3 rise;    // SurfacePoint's
};

// From the hit to a surface that touches the corners' tangent planes, as far as it lies above them, on the side (1 or -1) of
// the normals that counts: Hanika 2021, Hacking the Shadow Terminator, Ray Tracing Gems II, 4.
vec3 smooth_rise(IN(TrianglePoint) point, IN(vec3) n0, IN(vec3) n1, IN(vec3) n2, IN(float) side) {
  vec3 from_corner = point.e1 * point.b1 + point.e2 * point.b2;
  float rise0 = max(-side * dot_product(from_corner, n0), 0.0f) * point.b0;
  float rise1 = max(side * dot_product(point.e1 - from_corner, n1), 0.0f) * point.b1;
  float rise2 = max(side * dot_product(point.e2 - from_corner, n2), 0.0f) * point.b2;
  return (n0 * rise0 + n1 * rise1 + n2 * rise2) * side;
}

// Interpolated vertex normal on the side of `geometric`, or `geometric` itself where a corner has none. `front`: the viewer
// sees that side.
SmoothPoint smooth_point(IN(TrianglePoint) point, IN(vec3) geometric, IN(bool) front) {
  SmoothPoint flat_point = SmoothPoint(geometric, vec3(0.0f));
  uint texel = steering_constants().normal_texel;
  if (!effect_on(EFFECT_SMOOTH_NORMALS) || texel == NONE) return flat_point;
  note_run(EFFECT_SMOOTH_NORMALS);
  vec3 n0 = first_three(vertex_attribute(point.vertices.x, texel));
  vec3 n1 = first_three(vertex_attribute(point.vertices.y, texel));
  vec3 n2 = first_three(vertex_attribute(point.vertices.z, texel));
  if (INSTANCED) {
    AffineMap map = fetch_map(point.instance, INSTANCE_OBJECT_FROM_TRACED);
    n0 = unit_vector(mapped_normal(map, n0));
    n1 = unit_vector(mapped_normal(map, n1));
    n2 = unit_vector(mapped_normal(map, n2));
  }
  bool flat_corner = n0 == vec3(0.0f) || n1 == vec3(0.0f) || n2 == vec3(0.0f);
  vec3 smooth_normal = unit_vector(n0 * point.b0 + n1 * point.b1 + n2 * point.b2);
  if (flat_corner || smooth_normal == vec3(0.0f)) return flat_point;
  float height = dot_product(smooth_normal, geometric);
  float side = height < 0.0f ? -1.0f : 1.0f;
  vec3 rise = smooth_rise(point, n0, n1, n2, front ? side : -side);
  return SmoothPoint(smooth_normal * (mutated(MUTATION_SIGN_IN_FRAME) ? sign(height) : side), rise);
}

// `d`, a difference of texture coordinates, in the directions of the image that `use` looks up.
vec2 along_image(IN(DeviceTextureUse) use, IN(vec2) d) {
  return vec2(use.m00 * d.x + use.m01 * d.y, use.m10 * d.x + use.m11 * d.y);
}

// Tangent (xyz) around `normal` and handedness (w), from the mesh or from the gradient of the texture coordinates of `use`;
// zero for none.
vec4 tangent_frame(IN(TrianglePoint) point, IN(vec3) normal, IN(DeviceTextureUse) use) {
  SteeringConstants constants = steering_constants();
  float handedness = INSTANCED ? uintBitsToFloat(fetch_instance_words(point.instance).y) : 1.0f;
  if (constants.tangent_texel != NONE) {
    vec4 t0 = vertex_attribute(point.vertices.x, constants.tangent_texel);
    vec4 t1 = vertex_attribute(point.vertices.y, constants.tangent_texel);
    vec4 t2 = vertex_attribute(point.vertices.z, constants.tangent_texel);
    if (t0.w != 0.0f && t1.w != 0.0f && t2.w != 0.0f) {
      vec3 t = first_three(t0 * point.b0 + t1 * point.b1 + t2 * point.b2);
      if (INSTANCED) {
        AffineMap map = fetch_map(point.instance, INSTANCE_TRACED_FROM_OBJECT);
        t = unit_vector(mapped_vector(map, first_three(t0))) * point.b0 + unit_vector(mapped_vector(map, first_three(t1))) * point.b1 +
            unit_vector(mapped_vector(map, first_three(t2))) * point.b2;
      }
      return vec4(unit_vector(t - normal * dot_product(normal, t)), t0.w * handedness);
    }
  }
  uint texel = uv_texel(use.uv_set);
  if (texel == NONE) return vec4(0.0f);
  vec2 uv0 = uv_of_set(vertex_attribute(point.vertices.x, texel), use.uv_set);
  vec2 uv1 = uv_of_set(vertex_attribute(point.vertices.y, texel), use.uv_set) - uv0;
  vec2 uv2 = uv_of_set(vertex_attribute(point.vertices.z, texel), use.uv_set) - uv0;
  // As the mesh has them: turned, differences without area would have some by rounding.
  precise float area = uv1.x * uv2.y - uv1.y * uv2.x;
  precise float turn = use.m00 * use.m11 - use.m01 * use.m10;
  if (area == 0.0f || turn == 0.0f || !is_finite(area) || !is_finite(turn)) return vec4(0.0f);
  float side = (area < 0.0f) == (turn < 0.0f) ? 1.0f : -1.0f;
  vec2 d1 = along_image(use, uv1);
  vec2 d2 = along_image(use, uv2);
  vec3 t = (point.e1 * d2.y - point.e2 * d1.y) * side;
  return vec4(unit_vector(t - normal * dot_product(normal, t)), -side * handedness);
}

// `normal` bent by the material's normal texture; unchanged where there is none or no tangent.
vec3 bent_normal(IN(TrianglePoint) point, IN(DeviceMaterial) material, IN(SlotTexels) texels, IN(vec3) normal) {
  if ((material.textured_slots & (1u << TEXTURE_SLOT_NORMAL)) == 0u) return normal;
  vec4 frame = tangent_frame(point, normal, fetch_texture_use(point.vertices.w, uint(TEXTURE_SLOT_NORMAL)));
  vec3 tangent = first_three(frame);
  if (tangent == vec3(0.0f)) return normal;
  note_run(EFFECT_NORMAL_TEXTURE);
  vec3 bitangent = cross_product(normal, tangent) * frame.w;
  vec2 slope = (vec2(texels.normal.x, texels.normal.y) * 2.0f - 1.0f) * material.normal_scale;
  float height = texels.normal.z * 2.0f - 1.0f;
  // Unit already: rounding it once more would tell a flat texture from none.
  if (slope.x == 0.0f && slope.y == 0.0f && height > 0.0f) return normal;
  vec3 bent = unit_vector(tangent * slope.x + bitangent * slope.y + normal * height);
  return bent == vec3(0.0f) ? normal : bent;
}

// Place and normals of the hit, seen along `direction`.
SurfacePoint surface_point(IN(TrianglePoint) point, IN(DeviceMaterial) material, IN(SlotTexels) texels,
                           IN(vec3) direction) {
  SurfacePoint surface;
  surface.position = point.position;
  surface.position_error = point.position_error;
  surface.normal_error = point.normal_error;
  vec3 geometric = winding_normal(point);
  surface.front = dot_product(geometric, direction) <= 0.0f;
  SmoothPoint smooth_at = smooth_point(point, geometric, surface.front);
  vec3 normal = smooth_at.normal;
  if (effect_on(EFFECT_NORMAL_TEXTURE)) normal = bent_normal(point, material, texels, normal);
  surface.geometric_normal = surface.front ? geometric : -geometric;
  surface.normal = surface.front ? normal : -normal;
  surface.rise = smooth_at.rise;
  surface.b1 = point.b1;
  surface.b2 = point.b2;
  surface.across1 = cross_product(point.e2, geometric);
  surface.across2 = cross_product(geometric, point.e1);
  surface.area = dot_product(point.e1, surface.across1);
  surface.material = point.vertices.w;
  return surface;
}

// Opacity of the hit in [0, 1]: 0 where a mask cuts it out. `color` is the vertex colour.
float surface_alpha(IN(DeviceMaterial) material, IN(SlotTexels) texels, IN(vec4) color) {
  uint mode = alpha_mode_of(material);
  bool mask = mode == ALPHA_MASK;
  if (mode == ALPHA_OPAQUE || (mask ? !effect_on(EFFECT_ALPHA_MASK) : !effect_on(EFFECT_ALPHA_BLEND))) return 1.0f;
  note_run(mask ? EFFECT_ALPHA_MASK : EFFECT_ALPHA_BLEND);
  float textured = workflow_of(material) == WORKFLOW_BLINN ? texels.alpha.x : texels.base_color.w;
  float alpha = material.base_color.w * color.w * textured;
  if (mask) return alpha < material.alpha_cutoff ? 0.0f : 1.0f;
  return clamp(alpha, 0.0f, 1.0f);
}

#endif
