"""Shapes: closed where they should be, triangles that face the way their normals point."""

import collections
import math
import unittest

import tool_path  # noqa: F401
from scene_making import meshes


def facing_share(mesh):
    """Share of triangles whose own normal agrees with those of its corners; zero-area triangles are left out."""
    good = total = 0
    for a, b, c in mesh.triangles:
        p, q, r = (mesh.positions[corner] for corner in (a, b, c))
        own = meshes.cross(meshes.subtract(q, p), meshes.subtract(r, p))
        if sum(x * x for x in own) > 1e-18:
            total += 1
            good += all(sum(x * y for x, y in zip(own, mesh.normals[corner])) > 0 for corner in (a, b, c))
    return good / total


def open_edges(mesh):
    """Edges, by rounded position, that do not have exactly one triangle on either side."""
    count = collections.Counter()
    for triangle in mesh.triangles:
        corners = [tuple(round(x, 5) + 0.0 for x in mesh.positions[corner]) for corner in triangle]
        if len(set(corners)) == 3:
            for index in range(3):
                count[corners[index], corners[(index + 1) % 3]] += 1
    return [edge for edge, number in count.items() if number != 1 or count[edge[1], edge[0]] != 1]


class Meshes(unittest.TestCase):
    def test_closed_shapes_are_closed_and_face_outwards(self):
        for name, mesh in (("icosphere", meshes.icosphere(2, 0.7)), ("uv_sphere", meshes.uv_sphere(1.0, 16, 8)),
                           ("torus", meshes.torus(1.0, 0.3, 16, 8)), ("box", meshes.box((1, 2, 3))),
                           ("lathe", meshes.lathe([(0, 0), (1, 0), (1, 1), (0.5, 1.5), (0, 1.5)], 12))):
            with self.subTest(name):
                self.assertEqual(open_edges(mesh), [])
                self.assertEqual(facing_share(mesh), 1.0)
                volume = sum(sum(x * y for x, y in zip(mesh.positions[a], meshes.cross(mesh.positions[b], mesh.positions[c])))
                             for a, b, c in mesh.triangles) / 6
                self.assertGreater(volume, 0.1)

    def test_an_open_shape_is_noticed(self):
        self.assertEqual(len(open_edges(meshes.quad((0, 0, 0), (1, 0, 0), (0, 1, 0)))), 4)

    def test_icosphere_counts_and_radius(self):
        mesh = meshes.icosphere(3, 2.0)
        self.assertEqual((len(mesh.triangles), len(mesh.positions)), (20 * 4**3, 10 * 4**3 + 2))
        self.assertTrue(all(abs(math.hypot(*point) - 2.0) < 1e-12 for point in mesh.positions))

    def test_quad_shows_its_texture_upright(self):
        mesh = meshes.quad((0, 0, 0), (2, 0, 0), (0, 2, 0))
        self.assertEqual(dict(zip(mesh.positions, mesh.uvs))[(-1.0, 1.0, 0.0)], (0.0, 0.0))
        self.assertEqual(mesh.normals[0], (0.0, 0.0, 1.0))

    def test_merged_shifts_indices(self):
        one = meshes.quad((0, 0, 0), (1, 0, 0), (0, 1, 0))
        self.assertEqual(meshes.merged(one, one).triangles, [(0, 1, 2), (0, 2, 3), (4, 5, 6), (4, 6, 7)])


if __name__ == "__main__":
    unittest.main()
