"""Meshes in many places: as many objects and triangles as the file says, in the memory of one; the picture is that of copies."""

import json
import math
import struct
import unittest

from program import ProgramTest

VIEW = ["--size", "96x64", "--spp", 2]
CELLS = 80  # 12800 triangles
PLACES = 100  # of which copies would be more than 2^20 triangles


def grid():
    """Positions and corners of a bumpy square."""
    positions = [(x / CELLS - 0.5, 0.1 * math.sin(0.3 * x) * math.cos(0.2 * y), y / CELLS - 0.5)
                 for y in range(CELLS + 1) for x in range(CELLS + 1)]
    corners = []
    for y in range(CELLS):
        for x in range(CELLS):
            first = y * (CELLS + 1) + x
            corners += [first, first + CELLS + 1, first + 1, first + 1, first + CELLS + 1, first + CELLS + 2]
    return positions, corners


def places(count):
    """Beside each other, turned about Y, every third mirrored."""
    return [{"translation": [1.1 * (i % 10), 0.02 * i, 1.1 * (i // 10)], "rotation": [0, math.sin(0.1 * i), 0, math.cos(0.1 * i)],
             "scale": [-0.9 if i % 3 == 0 else 1.0, 1.0, 0.8]} for i in range(count)]


class InstancesTest(ProgramTest):
    def write_scene(self, name, count, shared):
        """`count` nodes of one mesh, or of a mesh each over the same numbers."""
        positions, corners = grid()
        points = b"".join(struct.pack("<3f", *position) for position in positions)
        indices = struct.pack(f"<{len(corners)}I", *corners)
        (self.folder / "grid.bin").write_bytes(points + indices)
        mesh = {"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}
        bounds = {"min": [min(column) for column in zip(*positions)], "max": [max(column) for column in zip(*positions)]}
        document = {
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(count))}],
            "nodes": [{"mesh": 0 if shared else i, **place} for i, place in enumerate(places(count))],
            "meshes": [mesh] * (1 if shared else count), "materials": [{"pbrMetallicRoughness": {"metallicFactor": 0.5, "roughnessFactor": 0.3}}],
            "buffers": [{"uri": "grid.bin", "byteLength": len(points) + len(indices)}],
            "bufferViews": [{"buffer": 0, "byteLength": len(points)},
                            {"buffer": 0, "byteOffset": len(points), "byteLength": len(indices)}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(positions), "type": "VEC3", **bounds},
                          {"bufferView": 1, "componentType": 5125, "count": len(corners), "type": "SCALAR"}]}
        return self.write(name, json.dumps(document))

    def render(self, scene, out, *options):
        self.check_done("render", scene, "-o", out, *VIEW, "--json", "render.json", *options)
        return json.loads((self.folder / "render.json").read_text())

    def test_a_few_nodes_of_one_mesh_are_objects_each(self):
        report = self.render(self.write_scene("few.gltf", 3, True), "few.exr", "--aov", "object_id,primitive_id")
        self.assertEqual((report["instances"], report["triangles"]), (3, 3 * 2 * CELLS * CELLS))

    def test_many_take_the_memory_of_one_and_look_like_copies(self):
        copied = self.render(self.write_scene("copied.gltf", PLACES, False), "copied.exr")
        shared = self.render(self.write_scene("shared.gltf", PLACES, True), "shared.exr")
        self.assertEqual(shared["instances"], PLACES)
        self.assertEqual(shared["triangles"], copied["triangles"])
        self.assertLess(20 * shared["bvh"]["bytes"], copied["bvh"]["bytes"])
        self.check_done("diff", "shared.exr", "copied.exr", "--json", "diff.json")
        self.assertLess(json.loads((self.folder / "diff.json").read_text())["rmse"], 0.004)

    def test_whatever_makes_the_picture_its_bits_are_the_same(self):
        scene = self.write_scene("shared.gltf", PLACES, True)
        self.render(scene, "whole.exr")
        whole = (self.folder / "whole.exr").read_bytes()
        for name, crop in [("left.exr", "0,0,40,64"), ("right.exr", "40,0,56,64")]:
            self.render(scene, name, "--crop", crop)
        self.check_done("merge", "left.exr", "right.exr", "-o", "merged.exr")
        self.assertEqual((self.folder / "merged.exr").read_bytes(), whole)
        self.check_done("rerun", "whole.exr")
        self.render(scene, "a.hdr")
        for options in (["--bvh", "fast"], ["--effects", "all"], ["--traversal", "storage-array"]):
            self.render(scene, "b.hdr", *options)
            self.assertEqual((self.folder / "a.hdr").read_bytes(), (self.folder / "b.hdr").read_bytes(), options)
        self.assertIn("reflection", self.check_done("explain", scene, "--size", "48x32").stdout)


if __name__ == "__main__":
    unittest.main()
