#pragma once

#include <tiny_gltf.h>

#include <glm/glm.hpp>

namespace vernier {

// Members of the JSON object of an extension. One that is missing, null or of another type is `otherwise`; of those
// that check_gltf_types looks into it has refused other types.

/// A number.
double gltf_number(const tinygltf::Value& object, const char* name, double otherwise);

/// An index: a whole number in [0, 2^31).
int gltf_index(const tinygltf::Value& object, const char* name, int otherwise);

/// Three numbers (more are left alone).
glm::dvec3 gltf_vector3(const tinygltf::Value& object, const char* name, const glm::dvec3& otherwise);

/// Two numbers.
glm::dvec2 gltf_vector2(const tinygltf::Value& object, const char* name, const glm::dvec2& otherwise);

/// The extension `name`, nullptr where the object does not carry it.
const tinygltf::Value* find_gltf_extension(const tinygltf::ExtensionMap& extensions, const char* name);

/// `value` as float; beyond its range the largest float of its sign.
float gltf_float(double value);

/// `value` clamped to [0, 1] as float.
float gltf_unit_float(double value);

}  // namespace vernier
