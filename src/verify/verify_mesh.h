#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "bvh/bvh.h"
#include "verify/random.h"

namespace vernier {

/// Vertices shared by index: what is one corner to two triangles has the same bits in both.
struct VerifyMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;
};

/// A closed sphere of triangles around the origin, `slices` by `stacks`, each vertex at a radius in [lo, hi) of its
/// own. Where slices and stacks are 16 or more it is nowhere nearer to the origin than 0.9 lo.
VerifyMesh sphere_mesh(std::uint32_t slices, std::uint32_t stacks, double lo, double hi, SampleRandom& random);

/// Two cones on one ring of `valence` vertices: closed, with two vertices (0 and 1, on the z axis) of that valence.
/// `roughness` in [0, 1] moves the ring's vertices; 0 leaves the mesh convex. A ball of 0.05 is always inside, of 0.3
/// where it is convex and the valence 4 or more.
VerifyMesh double_cone(std::uint32_t valence, double roughness, SampleRandom& random);

/// The square [-1, 1]^2 across `axis` at `height`, cut in `cells` x `cells` quads of two triangles.
VerifyMesh grid_mesh(std::uint32_t cells, int axis, float height);

/// The surface of the cube [-1, 1]^3, each face cut in `cells` x `cells` quads. Faces share positions, not indices.
VerifyMesh cube_mesh(std::uint32_t cells);

/// `count` separate triangles within [-1, 1]^3, extents about `size`.
VerifyMesh triangle_soup(std::uint32_t count, double size, SampleRandom& random);

/// Adds `other` behind `mesh`.
void append(VerifyMesh& mesh, const VerifyMesh& other);

/// Every position times `scale` plus `offset`, in double, rounded once.
VerifyMesh placed(VerifyMesh mesh, double scale, const glm::dvec3& offset);

/// The power of two that brings the mesh's largest coordinate into (1/2, 1], as a scene is scaled before it is traced.
double unit_scale(const VerifyMesh& mesh);

/// The mesh's triangles, ids counting from 0.
std::vector<BvhTriangle> triangles_of(const VerifyMesh& mesh);

}  // namespace vernier
