#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "scene/camera.h"
#include "scene/light.h"
#include "scene/material.h"

namespace vernier {

/// UV sets a mesh may carry; more are ignored with a warning.
inline constexpr std::size_t kUvSetCount = 4;

/// Triangles in one object space. Every vertex array is empty or has positions.size() entries.
struct Mesh {
  std::string name;
  std::vector<glm::vec3> positions;  ///< metres, object space
  std::vector<glm::vec3> normals;    ///< unit; (0, 0, 0): the triangle's own normal (flat)
  bool flat_normals = false;         ///< `normals` is empty because the file's were those of the triangles
  std::vector<glm::vec4> tangents;   ///< xyz unit, w = +-1 handedness; (0, 0, 0, 0): from the UV gradient
  std::vector<glm::vec4> colors;     ///< linear Rec.709 and opacity, multiplies base_color
  std::array<std::vector<glm::vec2>, kUvSetCount> uvs;
  std::vector<glm::uvec3> triangles;              ///< vertex indices, counter-clockwise seen from the front
  std::vector<std::uint32_t> triangle_materials;  ///< one per triangle, indexes Scene::materials
};

/// A mesh placed in the world: an object. Its index in Scene::instances is the object id.
struct Instance {
  std::string name;
  std::uint32_t mesh = 0;                          ///< indexes Scene::meshes
  glm::dmat4 world_from_object = glm::dmat4(1.0);  ///< affine; may mirror, scale unevenly and shear
};

/// How texels are looked up outside [0, 1) and between centres.
struct Sampler {
  std::uint32_t wrap_u = TEXTURE_WRAP_REPEAT;
  std::uint32_t wrap_v = TEXTURE_WRAP_REPEAT;
  std::uint32_t filter = TEXTURE_FILTER_LINEAR;
};

/// Decoded texels: `format` (TEXTURE_FORMAT_*) says how many words each of the width * height texels has; row 0 first.
struct Texels {
  std::uint32_t format = TEXTURE_FORMAT_SRGB8;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint32_t> words;
};

/// An image with its sampler. Textures may share texels.
struct Texture {
  std::string name;
  Sampler sampler;
  std::shared_ptr<const Texels> texels;
};

/// What a ray sees that hits nothing, and the source of ambient light.
/// Radiance along unit direction d: with `texture` >= 0 the equirectangular image (Scene::textures), else the
/// mix of `ground` (d.y = -1) and `sky` (d.y = +1), linear in d.y.
struct Environment {
  glm::vec3 sky = glm::vec3(0.0f);
  glm::vec3 ground = glm::vec3(0.0f);
  int texture = -1;
  glm::vec3 texture_scale = glm::vec3(1.0f);
  bool has_ambient_override = false;    ///< `ambient` replaces the environment as the source of ambient light
  glm::vec3 ambient = glm::vec3(0.0f);  ///< radiance, the same from all directions
};

/// A scene as loaded: plain values, right-handed, +Y up, metres. Empty vectors are valid.
struct Scene {
  std::string source;              ///< the file as the user named it
  std::vector<std::string> files;  ///< paths of all files the scene was read from, in that order, each once
  std::vector<Mesh> meshes;
  std::vector<Instance> instances;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<Light> lights;
  std::vector<Camera> cameras;
  Environment environment;
  std::vector<std::string> warnings;  ///< one line each: place and what is not supported or was repaired
};

/// Adds `path`, whose file was read, to `files` unless it is there already.
void note_file(std::vector<std::string>& files, const std::string& path);

}  // namespace vernier
