#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "scene/gltf_document.h"

namespace vernier {

/// Bytes of one component, 0 for a type glTF does not have.
std::size_t gltf_component_bytes(int component_type);

/// Components of an element, 0 for a type glTF does not have.
std::size_t gltf_component_count(int type);

// All readers take an accessor that check_gltf_references has passed, apply its sparse values, read zeros where it has
// no bufferView (at most 2^26 bytes of them, 2^28 in all), and throw Error(refused) "file: place: accessor N: ..."
// for another element type, bytes beyond the bufferView, a sparse index out of range or more than kMaxGltfBytes.

/// Counts `bytes` that a file without the bytes for them makes us take, and throws Error(refused) beyond 2^28 in all.
void count_gltf_zeros(const GltfDocument& document, const std::string& place, std::uint64_t bytes);

/// Throws Error(refused) where an attribute of `count` elements does not go with `vertex_count` vertices.
void check_element_count(const GltfDocument& document, const std::string& place, std::size_t count,
                         std::size_t vertex_count);

/// Elements as bytes without gaps, in order: [count][components].
std::vector<std::byte> read_gltf_elements(const GltfDocument& document, int accessor, const std::string& place);

/// Elements of `N` components (2, 3 or 4) of type float, or 8 or 16 bit integers; these go to [0, 1] or [-1, 1] when
/// the accessor is normalised and keep their value when not. NaN and infinity are passed on.
template <int N>
std::vector<glm::vec<N, float>> read_gltf_vectors(const GltfDocument& document, int accessor, const std::string& place);

/// Colours: four components as above, or three with opacity 1.
std::vector<glm::vec4> read_gltf_colors(const GltfDocument& document, int accessor, const std::string& place);

/// Scalars of unsigned integer type (vertex indices).
std::vector<std::uint32_t> read_gltf_indices(const GltfDocument& document, int accessor, const std::string& place);

/// Four unsigned integers an element (joint numbers).
std::vector<glm::uvec4> read_gltf_joints(const GltfDocument& document, int accessor, const std::string& place);

/// 4x4 matrices of float, column after column.
std::vector<glm::mat4> read_gltf_matrices(const GltfDocument& document, int accessor, const std::string& place);

}  // namespace vernier
