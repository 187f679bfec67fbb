#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "scene/gltf_document.h"

namespace vernier {

/// Vertices of one primitive as a Mesh without triangles: positions, and normals (not yet unit), tangents, colours and
/// UV sets where the primitive has them. More than kUvSetCount UV sets and a second colour are unsupported.
/// Throws Error(refused) where an attribute has another count than POSITION or a type it must not have.
Mesh read_gltf_vertices(GltfDocument& document, const tinygltf::Primitive& primitive, const std::string& place);

/// Triangles of a primitive of mode 4 (list), 5 (strip) or 6 (fan), corners in the order that makes the front
/// counter-clockwise (glTF 2.0, section 3.7.2.1). Left-over indices of a list are dropped with a warning.
/// Throws Error(refused) for an index that is not below `vertex_count`.
std::vector<glm::uvec3> read_gltf_triangles(GltfDocument& document, const tinygltf::Primitive& primitive,
                                            std::size_t vertex_count, const std::string& place);

/// Makes normals unit and tangents' xyz unit with w = +-1, whatever quantisation, morphing or skinning made of them.
/// Those without length or not finite become zero: no normal, no tangent.
void normalise_gltf_directions(Mesh& vertices);

}  // namespace vernier
