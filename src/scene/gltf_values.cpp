#include "scene/gltf_values.h"

#include <algorithm>
#include <limits>

namespace vernier {
namespace {

template <int N>
glm::vec<N, double> vector_member(const tinygltf::Value& object, const char* name, glm::vec<N, double> otherwise) {
  if (!object.Has(name)) return otherwise;
  const tinygltf::Value& array = object.Get(name);
  if (array.ArrayLen() < N) return otherwise;
  glm::vec<N, double> result;
  for (int i = 0; i < N; ++i) {
    if (!array.Get(i).IsNumber()) return otherwise;
    result[i] = array.Get(i).GetNumberAsDouble();
  }
  return result;
}

}  // namespace

double gltf_number(const tinygltf::Value& object, const char* name, double otherwise) {
  return object.Has(name) && object.Get(name).IsNumber() ? object.Get(name).GetNumberAsDouble() : otherwise;
}

int gltf_index(const tinygltf::Value& object, const char* name, int otherwise) {
  return object.Has(name) && object.Get(name).IsInt() ? object.Get(name).GetNumberAsInt() : otherwise;
}

glm::dvec3 gltf_vector3(const tinygltf::Value& object, const char* name, const glm::dvec3& otherwise) {
  return vector_member<3>(object, name, otherwise);
}

glm::dvec2 gltf_vector2(const tinygltf::Value& object, const char* name, const glm::dvec2& otherwise) {
  return vector_member<2>(object, name, otherwise);
}

const tinygltf::Value* find_gltf_extension(const tinygltf::ExtensionMap& extensions, const char* name) {
  const auto found = extensions.find(name);
  return found != extensions.end() && found->second.IsObject() ? &found->second : nullptr;
}

float gltf_float(double value) {
  constexpr double kMax = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(value, -kMax, kMax));
}

float gltf_unit_float(double value) {
  return static_cast<float>(std::clamp(value, 0.0, 1.0));
}

}  // namespace vernier
