"""The glTF writer: a file that is laid out as the specification wants it, and rotations that turn where they should."""

import json
import struct
import unittest

import tool_path  # noqa: F401
from scene_making import gltf, meshes


def turned(quaternion, vector):
    """`vector` turned by the quaternion (x, y, z, w)."""
    axis, w = tuple(quaternion[:3]), quaternion[3]
    twice = meshes.scale(meshes.cross(axis, vector), 2.0)
    return meshes.add(meshes.add(vector, meshes.scale(twice, w)), meshes.cross(axis, twice))


def parsed(content):
    """(document, binary chunk) of a .glb, its framing checked."""
    magic, version, length, json_length, json_kind = struct.unpack_from("<5I", content)
    assert (magic, version, length, json_kind) == (0x46546C67, 2, len(content), 0x4E4F534A)
    binary_length, binary_kind = struct.unpack_from("<II", content, 20 + json_length)
    assert binary_kind == 0x004E4942 and 28 + json_length + binary_length == length and json_length % 4 == 0
    return json.loads(content[20:20 + json_length]), content[28 + json_length:]


class Gltf(unittest.TestCase):
    def assert_near(self, found, wanted):
        for x, y in zip(found, wanted):
            self.assertAlmostEqual(x, y, places=6)

    def test_facing_turns_minus_z(self):
        for direction in ((1, 0, 0), (0, 0, 1), (0, 0, -1), (0, -1, 0), (0, 1, 0), (-0.3, -0.8, 0.5), (1, 2, 3)):
            self.assert_near(turned(gltf.facing(direction), (0, 0, -1)), meshes.unit(direction))

    def test_facing_keeps_the_horizon_level(self):
        self.assertAlmostEqual(turned(gltf.facing((0.4, -0.5, -0.7)), (1, 0, 0))[1], 0.0, places=6)
        self.assertGreater(turned(gltf.facing((0.4, -0.5, -0.7)), (0, 1, 0))[1], 0.0)

    def test_about(self):
        self.assert_near(turned(gltf.about((0, 1, 0), 90), (0, 0, -1)), (-1, 0, 0))

    def test_file_layout(self):
        scene = gltf.SceneFile("test")
        paint = scene.add_material("paint", extensions={"KHR_materials_unlit": {}})
        mesh = scene.add_mesh("quad", (meshes.quad((0, 0, 0), (2, 0, 0), (0, 4, 0)), paint))
        parent = scene.add_node("parent")
        scene.add_node("child", parent=parent, mesh=mesh)
        scene.add_light("sun", "directional", (1, 1, 1), 3.0, towards=(0, -1, 0))
        document, binary = parsed(scene.to_bytes())
        self.assertEqual(document["extensionsUsed"], ["KHR_lights_punctual", "KHR_materials_unlit"])
        self.assertEqual(document["scenes"][0]["nodes"], [0, 2])
        self.assertEqual(document["nodes"][0]["children"], [1])
        part = document["meshes"][0]["primitives"][0]
        positions = document["accessors"][part["attributes"]["POSITION"]]
        self.assertEqual((positions["min"], positions["max"]), ([-1, -2, 0], [1, 2, 0]))
        view = document["bufferViews"][positions["bufferView"]]
        self.assertEqual(struct.unpack_from("<3f", binary, view["byteOffset"]), (-1, -2, 0))
        for view in document["bufferViews"]:
            self.assertEqual(view["byteOffset"] % 4, 0)
            self.assertLessEqual(view["byteOffset"] + view["byteLength"], document["buffers"][0]["byteLength"])


if __name__ == "__main__":
    unittest.main()
