"""Input that is missing or broken ends with exit code 3 and one line that names the file; nothing is left behind."""

import sys
import unittest

from program import FAILED, REFUSED, SCENE, SCENES, SMALL, TRIANGLE_OBJ, USAGE, ProgramTest

sys.path.insert(0, str(SCENES.parent / "tools"))
from picture_files.png import encode_png  # noqa: E402


class InputTest(ProgramTest):
    def check_refused(self, name):
        before = self.files()
        self.check_error(REFUSED, name, "render", name, "-o", "out.png", *SMALL)
        self.check_error(REFUSED, name, "explain", name)
        self.check_error(REFUSED, name, "reference", name, "-o", "out.exr", *SMALL)
        self.assertEqual(self.files(), before)

    def test_missing_scene(self):
        self.check_refused("nothing.glb")
        self.check_refused("nothing.obj")

    def test_folder_as_scene(self):
        (self.folder / "folder.glb").mkdir()
        self.check_refused("folder.glb")

    def test_broken_scenes(self):
        self.write("syntax.gltf", '{"asset": {"version": "2.0"')
        self.write("empty.gltf", "")
        self.write("magic.glb", "GLTF is not the magic")
        self.write("none.obj", "# no triangles\n")
        for name in ["syntax.gltf", "empty.gltf", "magic.glb", "none.obj"]:
            with self.subTest(name=name):
                self.check_refused(name)

    def test_unknown_scene_extension(self):
        self.write("scene.fbx", "x")
        self.check_refused("scene.fbx")

    def test_background_file(self):
        self.check_error(REFUSED, "sky.hdr", "render", SCENE, "-o", "out.png", "--background", "sky.hdr", *SMALL)
        self.write("sky.hdr", "not an image")
        self.check_error(REFUSED, "sky.hdr", "explain", SCENE, "--background", "sky.hdr")
        self.check_error(REFUSED, "sky.bmp", "render", SCENE, "--background", "sky.bmp")

    def test_broken_texture_is_one_warning(self):
        self.write("triangle.obj", "mtllib a.mtl\nusemtl m\n" + TRIANGLE_OBJ)
        self.write("a.mtl", "newmtl m\nmap_Kd a.png\n")
        whole = encode_png([[(1, 2, 3), (250, 5, 6)] * 4] * 8, 3)
        damaged = whole.replace(b"IDAT\x78", b"IDAT\x79")
        self.assertNotEqual(damaged, whole)
        for content in [whole[:40], whole[:-20], damaged]:
            (self.folder / "a.png").write_bytes(content)
            lines = self.check_done("explain", "triangle.obj", "--no-costs").stderr.splitlines()
            self.assertEqual(len(lines), 1, lines)
            self.assertRegex(lines[0], r"^warning: .*a\.png: .*PNG.* without this texture")

    def test_camera_that_is_not_there(self):
        self.write("triangle.obj", TRIANGLE_OBJ)
        self.check_error(USAGE, "none", "explain", "triangle.obj", "--camera", "0")

    def test_eye_at_the_target(self):
        self.write("triangle.obj", TRIANGLE_OBJ)
        self.check_error(USAGE, "--eye", "explain", "triangle.obj", "--eye", "1,2,3", "--target", "1,2,3")
        self.check_error(USAGE, "--up", "explain", "triangle.obj", "--eye", "0,0,3", "--target", "0,0,0", "--up", "0,0,1")

    def test_output_that_cannot_be_written(self):
        self.check_error(FAILED, "no folder", "render", SCENE, "-o", "nowhere/out.png", *SMALL)
        self.check_error(FAILED, "no folder", "render", SCENE, "-o", "out.png", "--json", "nowhere/out.json", *SMALL)
        (self.folder / "out.png").mkdir()
        self.check_error(FAILED, "is a folder", "render", SCENE, "-o", "out.png", *SMALL)
        self.assertEqual(self.files(), ["out.png"])

    def test_pictures_that_are_cut_off(self):
        """A background is refused, a texture is one warning: what the codec makes of missing rows is not shown as if it were there."""
        for extension, size in (("tif", 60000), ("jpg", 8000), ("png", 3000), ("hdr", 60000), ("exr", 60000)):
            whole, cut = "whole." + extension, "cut." + extension
            self.check_done("render", SCENE, "-o", whole, "--size", "256x256", "--spp", "1", "--quiet")
            (self.folder / cut).write_bytes((self.folder / whole).read_bytes()[:size])
            self.assertLess(size, (self.folder / whole).stat().st_size)
            self.check_error(REFUSED, cut, "explain", SCENE, "--background", cut, "--no-costs")
            self.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3\n")
            self.write("a.mtl", f"newmtl a\nmap_Kd {cut}\n")
            result = self.check_done("explain", "a.obj", "--no-costs")
            self.assertIn(cut, result.stderr)
            self.assertEqual(result.stderr.count("warning: "), 1, result.stderr)

    def test_codecs_that_cannot_be_loaded(self):
        """Said before anything is rendered; what reads and writes no image does without them."""
        self.write("libvernier_codecs.so", "no library")
        without = {"LD_LIBRARY_PATH": str(self.folder)}
        self.write("triangle.obj", TRIANGLE_OBJ)
        self.check_error(FAILED, "libvernier_codecs.so", "render", "triangle.obj", "-o", "out.png", *SMALL, environment=without)
        self.check_error(FAILED, "libvernier_codecs.so", "explain", str(SCENES / "texture_wrap.glb"), environment=without)
        self.check_done("explain", "triangle.obj", environment=without)
        self.assertEqual(self.files(), ["libvernier_codecs.so", "triangle.obj"])

    def test_strict_refuses_what_is_not_supported(self):
        text = '{"asset":{"version":"2.0"},"extensionsUsed":["EXT_not_there"],"scene":0,"scenes":[{"nodes":[0]}],' \
               '"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],' \
               '"materials":[{"extensions":{"EXT_not_there":{}}}],' \
               '"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",' \
               '"min":[0,0,0],"max":[1,1,0]}],"bufferViews":[{"buffer":0,"byteLength":36}],' \
               '"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,' \
               'AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}'
        self.write("odd.gltf", text)
        self.assertIn("warning: ", self.check_done("explain", "odd.gltf", "--no-costs").stderr)
        self.check_error(REFUSED, "EXT_not_there", "explain", "odd.gltf", "--strict")

    def test_strict_refuses_what_an_obj_file_lacks(self):
        self.write("a.obj", "mtllib a.mtl\nusemtl a\n" + TRIANGLE_OBJ)
        self.assertIn("a.mtl", self.check_done("explain", "a.obj", "--no-costs").stderr)
        self.check_error(REFUSED, "a.mtl", "explain", "a.obj", "--strict")
        self.write("a.mtl", "newmtl a\nmap_Kd none.png\n")
        self.assertIn("none.png", self.check_done("explain", "a.obj", "--no-costs").stderr)
        self.check_error(REFUSED, "none.png", "explain", "a.obj", "--strict")
        self.write("none.png", "no picture")
        self.check_error(REFUSED, "none.png", "explain", "a.obj", "--strict")
        self.write("a.mtl", "newmtl b\n")
        self.assertIn("material 'a' is in no", self.check_done("explain", "a.obj", "--no-costs").stderr)
        self.check_error(REFUSED, "material 'a' is in no", "explain", "a.obj", "--strict")


if __name__ == "__main__":
    unittest.main()
