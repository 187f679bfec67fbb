#pragma once

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstring>
#include <numbers>

#include "shader/shader.h"

namespace vernier::shader {

inline constexpr float kHalfRoot = 1.0f / std::numbers::sqrt2_v<float>;
inline constexpr vec3 kUp(0, 0, 1);

/// Vertex data of a triangle's three corners, and where they lie in a vertex: normal, tangent, UV sets 0 and 1.
struct Corners {
  std::array<vec3, 3> normals{vec3(0, 0, 1), vec3(0, 0, 1), vec3(0, 0, 1)};
  std::array<vec4, 3> tangents{};
  std::array<vec2, 3> uvs{vec2(0, 0), vec2(1, 0), vec2(0, 1)};
  std::array<vec2, 3> second_uvs{};
};

inline constexpr std::uint32_t kMaterial = 7;

/// Memory with one triangle's vertices: all attributes but colours are there; `use` is that of the normal texture.
inline Memory memory_with(const Corners& corners, const DeviceTextureUse& use = plain_use(0)) {
  Memory scene;
  scene.materials.resize(std::size_t{kMaterial + 1} * MATERIAL_TEXELS);
  const std::size_t slot = TEXTURE_SLOT_NORMAL;
  std::memcpy(&scene.materials[kMaterial * MATERIAL_TEXELS + MATERIAL_OWN_TEXELS + slot * TEXTURE_USE_TEXELS], &use,
              sizeof use);
  SteeringConstants& steering = scene.dispatch.steering;
  steering.vertex_texels = 3;
  steering.normal_texel = 0;
  steering.tangent_texel = 1;
  steering.uv01_texel = 2;
  steering.uv23_texel = steering.color_texel = NONE;
  for (std::size_t i = 0; i < 3; ++i) {
    const vec4 uvs(corners.uvs[i].x, corners.uvs[i].y, corners.second_uvs[i].x, corners.second_uvs[i].y);
    for (const vec4& texel : {vec4(corners.normals[i], 0), corners.tangents[i], uvs})
      scene.vertices.push_back(std::bit_cast<uvec4>(texel));
  }
  return scene;
}

/// The point with weights b1 and b2 of the triangle (0, 0, 0), (1, 0, 0), (0, 1, 0), whose front looks along +Z.
inline TrianglePoint unit_triangle_point(float b1, float b2) {
  return weighted_point(vec3(0), vec3(1, 0, 0), vec3(0, 1, 0), uvec4(0, 1, 2, kMaterial), vec3(1 - b1 - b2, b1, b2),
                        1.0f);
}

/// A unit vector has two roundings per component: the scaled sum's and the reciprocal's, and those of the sum under the
/// root at half their size. 4 half ulps of 1 bound them.
inline void expect_unit_near(const vec3& value, const vec3& expected) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(value[i], expected[i], 4 * 0x1p-24f) << i;
}

}  // namespace vernier::shader
