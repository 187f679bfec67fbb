"""Input that is itself sick is refused or repaired, with one warning per kind that says how many; the rest of the picture
keeps its bits."""

import base64
import json
import struct
import unittest

from program import DONE, REFUSED, ProgramTest

VIEW = ["--size", "32x32", "--spp", "1", "--eye", "0.3,0.3,3", "--target", "0.3,0.3,0", "--background", "0.1,0.2,0.3"]
SOUND = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"


def gltf(nodes, corners, uvs=None):
    """One triangle mesh at every node of `nodes`, as text."""
    arrays = [struct.pack("<9f", *corners)] + ([struct.pack("<6f", *uvs)] if uvs else [])
    views, accessors, offset = [], [], 0
    for number, array in enumerate(arrays):
        views.append({"buffer": 0, "byteOffset": offset, "byteLength": len(array)})
        accessors.append({"bufferView": number, "componentType": 5126, "count": 3, "type": "VEC2" if number else "VEC3"})
        offset += len(array)
    data = base64.b64encode(b"".join(arrays)).decode()
    attributes = {"POSITION": 0, "TEXCOORD_0": 1} if uvs else {"POSITION": 0}
    return json.dumps({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}],
                       "nodes": [{"mesh": 0, **node} for node in nodes],
                       "meshes": [{"primitives": [{"attributes": attributes}]}], "accessors": accessors,
                       "bufferViews": views,
                       "buffers": [{"byteLength": offset, "uri": "data:application/octet-stream;base64," + data}]})


# So strong that instances are copied (src/render/plan_instances.h).
SHEAR = [1, 0, 0, 0, 100, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]


def instanced(places, corners, **moved):
    """A mesh at many places, both of accessors without data but for a first triangle: text of some hundred bytes for any number of them."""
    node = {"mesh": 0, **moved, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 1}}}}
    accessors = [{"componentType": 5126, "count": count, "type": "VEC3"} for count in (corners, places)]
    triangle = struct.pack("<4B6f", 1, 2, 0, 0, 1, 0, 0, 0, 1, 0)  # corners 1 and 2
    accessors[0]["sparse"] = {"count": 2, "indices": {"bufferView": 0, "componentType": 5121}, "values": {"bufferView": 1}}
    buffer = {"byteLength": len(triangle), "uri": "data:application/octet-stream;base64," + base64.b64encode(triangle).decode()}
    views = [{"buffer": 0, "byteLength": 2}, {"buffer": 0, "byteOffset": 4, "byteLength": 24}]
    return json.dumps({"asset": {"version": "2.0"}, "extensionsUsed": ["EXT_mesh_gpu_instancing"], "scene": 0,
                       "scenes": [{"nodes": [0]}], "nodes": [node], "accessors": accessors,
                       "buffers": [buffer], "bufferViews": views,
                       "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}]})


class SickInputTest(ProgramTest):
    def render(self, name):
        """The picture's bytes and the warnings."""
        result = self.run_program("render", name, "-o", "out.hdr", "--quiet", *VIEW)
        self.assertEqual(result.returncode, DONE, result.stderr)
        lines = result.stderr.splitlines()
        self.assertTrue(all(line.startswith("warning: ") for line in lines), lines)
        return (self.folder / "out.hdr").read_bytes(), lines

    def check_same_picture(self, sick, sound, *warnings):
        self.write("sound." + ("gltf" if sound.startswith("{") else "obj"), sound)
        self.write("sick." + ("gltf" if sick.startswith("{") else "obj"), sick)
        name = "sick.gltf" if sick.startswith("{") else "sick.obj"
        expected, none = self.render(name.replace("sick", "sound"))
        self.assertEqual(none, [])
        picture, lines = self.render(name)
        self.assertEqual(picture, expected)
        self.assertEqual(len(lines), len(warnings), lines)
        for part in warnings:
            self.assertTrue(any(part in line for line in lines), (part, lines))

    def test_corners_that_are_not_finite(self):
        self.check_same_picture(SOUND + "v nan 0 0\nv 0 inf 0\nv 1e39 0 0\nf 1 2 4\nf 1 2 5\nf 1 6 3\n", SOUND,
                                "and 2 more: triangles with a non-finite corner are dropped")

    def test_more_than_memory_holds_is_refused_before_it_is_taken(self):
        self.write("many.gltf", instanced(places=60_000, corners=99_999, matrix=SHEAR))  # 2 000 000 000 triangles
        self.check_error(REFUSED, "of the host's memory", "render", "many.gltf", "-o", "out.png", *VIEW)
        self.write("places.gltf", instanced(places=400_000_000, corners=3))
        self.check_error(REFUSED, "accessors without bufferView ask for more than", "render", "places.gltf", "-o", "out.png", *VIEW)

    def test_nothing_but_sick_corners_is_refused(self):
        self.write("sick.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.check_error(REFUSED, "no triangle is left", "render", "sick.obj", "-o", "out.png", *VIEW)

    def test_triangles_without_area(self):
        # On one line, a corner twice, a point.
        self.check_same_picture(SOUND + "v 0.5 0.5 0\nv 0.25 0.75 0\nf 2 4 5\nf 1 1 3\nf 2 2 2\n", SOUND,
                                "3 triangles without area, never hit")

    def test_a_million_coincident_triangles(self):
        self.check_same_picture(SOUND + "f 1 2 3\n" * 1000000, SOUND, "1000000 triangles exactly on others before")

    def test_triangles_with_one_centre(self):
        rings = ["v 0 0 0\nv 1 0 0\nv 0 1 0\n"]
        faces = ["f 1 2 3\n"]
        for i in range(20000):
            # Around (1/3, 1/3), hidden by the sound one.
            size = 0.5 - i / 80000
            for x, y in [(-1, -1), (2, -1), (-1, 2)]:
                rings.append(f"v {1 / 3 + x * size / 3} {1 / 3 + y * size / 3} -0.5\n")
            faces.append(f"f {3 * i + 4} {3 * i + 5} {3 * i + 6}\n")
        self.check_same_picture("".join(rings + faces), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 -0.5\nf 1 2 3\n")

    def test_a_series_that_makes_deep_trees(self):
        corners, faces = ["v 0 0 0\nv 1 0 0\nv 0 1 0\n"], ["f 1 2 3\n"]
        for i in range(120):
            x = 2.0 ** -i  # each half as large as the one before, hidden by the sound one
            corners.append(f"v {x!r} 0 {-x!r}\nv {x / 2!r} 0 {-x!r}\nv {x / 2!r} {x / 4!r} {-x!r}\n")
            faces.append(f"f {3 * i + 4} {3 * i + 5} {3 * i + 6}\n")
        self.check_same_picture("".join(corners + faces), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")

    def test_singular_transforms(self):
        corners = [0, 0, 0, 1, 0, 0, 0, 1, 0]
        sick = [{}, {"scale": [1, 1, 0]}, {"scale": [1, 0, 0]}, {"scale": [0, 0, 0]}, {"scale": [1, 1, 1e-30]}]
        self.check_same_picture(gltf(sick, corners), gltf(sick[:1], corners),
                                "and 3 more: instances with a singular or non-finite transform are dropped")

    def test_huge_texture_coordinates(self):
        corners = [0, 0, 0, 1, 0, 0, 0, 1, 0]
        self.check_same_picture(gltf([{}], corners, [0, 0, 1e38, 0, 0, 3e38]), gltf([{}], corners, [0, 0, 1, 0, 0, 1]),
                                "and 1 more: texture coordinates beyond 65536")


if __name__ == "__main__":
    unittest.main()
