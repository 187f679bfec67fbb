"""The scenes of tools/growth: as large as they say, and whole. And its plot."""

import json
import pathlib
import struct
import tempfile
import unittest

import numpy
import tool_path  # noqa: F401
from benchmarking import growth_plot, growth_scene


def read_glb(path: pathlib.Path) -> tuple:
    content = path.read_bytes()
    magic, version, length, text_length, _ = struct.unpack_from("<IIIII", content)
    assert (magic, version, length) == (0x46546C67, 2, len(content))
    return json.loads(content[20:20 + text_length]), content[28 + text_length:]


def rows_of(document: dict, binary: bytes, index: int) -> numpy.ndarray:
    accessor = document["accessors"][index]
    view = document["bufferViews"][accessor["bufferView"]]
    part = binary[view["byteOffset"]:view["byteOffset"] + view["byteLength"]]
    kind = "<f4" if accessor["componentType"] == growth_scene.FLOAT else "<u4"
    width = {"SCALAR": 3, "VEC2": 2, "VEC3": 3}[accessor["type"]]  # indices by triangles
    return numpy.frombuffer(part, kind).reshape(-1, width)


class GrowthSceneTest(unittest.TestCase):
    def write(self, *arguments) -> tuple:
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "scene.glb"
            growth_scene.write_scene(path, *arguments)
            return read_glb(path)

    def test_as_many_triangles_as_asked_for(self):
        for asked in (1000, 20000, 300000):
            document, _ = self.write(asked)
            counts = [document["accessors"][mesh["primitives"][0]["indices"]]["count"] // 3 for mesh in document["meshes"]]
            self.assertEqual(len(counts), 26)
            # Rows and cells are whole numbers: half of one is 4 rows triangles of each sphere, 2 cells of the ground.
            rows, cells = (asked / 120.0) ** 0.5 + 1.0, (asked / 12.0) ** 0.5
            self.assertLess(abs(sum(counts) - asked), 25.0 * 4.0 * rows + 2.0 * cells)

    def test_spheres_are_closed_and_normals_are_unit_and_point_outwards(self):
        document, binary = self.write(20000)
        part = document["meshes"][1]["primitives"][0]
        positions = rows_of(document, binary, part["attributes"]["POSITION"])
        normals = rows_of(document, binary, part["attributes"]["NORMAL"])
        triangles = rows_of(document, binary, part["indices"])
        self.assertLess(triangles.max(), len(positions))
        numpy.testing.assert_allclose(numpy.linalg.norm(normals[numpy.unique(triangles)], axis=1), 1.0, atol=1e-6)
        self.assertGreater((positions * normals).sum(1)[numpy.unique(triangles)].min(), 0.0)
        # The seam and the poles have several vertices at one place: an edge is that of two places.
        _, places = numpy.unique(numpy.round(positions, 5) + 0.0, axis=0, return_inverse=True)
        corners = places.reshape(-1)[triangles]
        edges = numpy.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])
        forth = {tuple(edge) for edge in edges.tolist()}
        self.assertEqual(len(forth), len(edges), "no edge twice in one direction")
        self.assertEqual(forth, {(b, a) for a, b in forth}, "every edge has its neighbour")

    def test_materials_have_as_many_textures_as_asked_for(self):
        for count in range(5):
            document, _ = self.write(1000, count)
            for material in document["materials"]:
                held = [name for name in growth_scene.TEXTURE_SLOTS if name in material or name in material["pbrMetallicRoughness"]]
                self.assertEqual(held, list(growth_scene.TEXTURE_SLOTS[:count]))

    def test_instances_share_one_sphere_and_go_round_in_three_materials(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "scene.glb"
            growth_scene.write_instances(path, 1000, 10)
            document, binary = read_glb(path)
        spheres = [node for node in document["nodes"] if "extensions" in node]
        attributes = [node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] for node in spheres]
        self.assertEqual([document["accessors"][one["TRANSLATION"]]["count"] for one in attributes], [4, 3, 3])
        parts = [document["meshes"][node["mesh"]]["primitives"][0] for node in spheres]
        self.assertEqual(len({part["indices"] for part in parts}), 1)
        self.assertEqual([part["material"] for part in parts], [1, 2, 3])
        self.assertLess(abs(document["accessors"][parts[0]["indices"]]["count"] // 3 - 1000), 130)
        places = numpy.concatenate([rows_of(document, binary, one["TRANSLATION"]) for one in attributes])
        self.assertEqual(len(numpy.unique(places, axis=0)), 10)


class GrowthPlotTest(unittest.TestCase):
    def test_one_axis_alone_is_drawn_as_several_are(self):
        spread = {"median": 1.0, "least": 1.0, "most": 1.0}
        rows = [{"value": value, "ns_per_ray": 100.0, "times_first": spread} for value in (1, 2)]
        for axes in ({"lights": rows}, {"lights": rows, "bounces": rows}):
            self.assertEqual(len(growth_plot.draw(axes).axes), len(axes))


if __name__ == "__main__":
    unittest.main()
