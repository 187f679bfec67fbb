"""vernier rerun: the same bits, or what differs, or why it cannot be told."""

import json
import unittest

from pictures import write_png
from program import FAILED, NO_DEVICE, REFUSED, SCENE, SMALL, TRIANGLE_OBJ, ProgramTest

ARGUMENTS = ["--size", "24x16", "--aov", "depth,cost", "--quiet"]


class RerunTest(ProgramTest):
    def render(self, name, *options, scene=SCENE, spp="1"):
        self.check_done("render", scene, "-o", name, *ARGUMENTS, "--spp", spp, *options)
        return name

    def test_every_format_with_metadata_comes_out_the_same(self):
        self.render("e.exr", "--sample-range", "1:3", "--crop", "3,4,10,8", "--seed", "7", "--light", "dir:0,-1,0.5:1,1,1",
                    "--eye=-1,2,3", spp="5")
        self.check_done("rerun", "e.exr", "--quiet")
        for name, options in [("a.exr", []), ("b.png", ["--exposure", "-1.5"]), ("c.jpg", []), ("d.tif", [])]:
            result = self.check_done("rerun", self.render(name, *options), "--quiet")
            self.assertIn(f"{name}: the same bits again", result.stdout)
        self.check_done("rerun", "b.depth.png", "--quiet")

    def test_a_name_that_looks_like_that_of_a_layer(self):
        self.render("shot.depth.png")
        for name in ("shot.depth.png", "shot.depth.depth.png"):
            self.check_done("rerun", name, "--quiet")

    def test_a_target_that_no_time_ended(self):
        """Blocks without an error stop at 8 samples; the others reach --spp: no clock had a say."""
        self.check_done("render", SCENE, "-o", "a.exr", "--size", "64x36", "--background", "0,0,0", "--eye", "0,0,40", "--target",
                        "0,0,0", "--spp", "32", "--error-target", "0.00001", "--json", "a.json", "--quiet")
        self.assertLess(json.loads((self.folder / "a.json").read_text())["samples_done"], 32)
        self.check_done("rerun", "a.exr", "--quiet")

    def test_the_built_in_scene(self):
        self.check_done("render", "-o", "a.exr", *SMALL, "--quiet")
        self.check_done("rerun", "a.exr", "--quiet")

    def test_changed_pixels_are_told(self):
        self.render("a.exr")
        self.render("b.exr", "--seed", "0", "--background", "0.1,0.2,0.3")
        changed = (self.folder / "b.exr").read_bytes().replace(b'"background":"0.1,0.2,0.3"', b'"background":"0.1,0.2,0.4"')
        (self.folder / "b.exr").write_bytes(changed)
        result = self.run_program("rerun", "b.exr", "--quiet")
        self.assertEqual(result.returncode, FAILED, result.stderr)
        self.assertRegex(result.stdout, r"^colour: \d+ of 384 pixels differ, the first: pixel \d+,\d+, B 0\.\d+ instead of 0\.\d+\n$")
        self.assertEqual(result.stderr, "error: b.exr: the render is another now\n")

    def test_a_file_of_the_scene_that_changed_is_named(self):
        self.write("t.obj", "mtllib t.mtl\n" + TRIANGLE_OBJ)
        self.write("t.mtl", "newmtl a\nKd 1 0 0\n")
        self.render("a.exr", scene="t.obj")
        self.check_done("rerun", "a.exr", "--quiet")
        self.write("t.mtl", "newmtl a\nKd 0 1 0\n")
        self.check_error(REFUSED, "t.mtl: is not the file it was when a.exr was rendered", "rerun", "a.exr", "--quiet")
        (self.folder / "t.mtl").unlink()
        self.check_error(REFUSED, "t.mtl: cannot be read", "rerun", "a.exr", "--quiet")

    def test_a_device_that_is_not_there(self):
        self.render("a.exr")
        self.check_error(NO_DEVICE, "GeForce 9999", "rerun", "a.exr", "--device", "GeForce 9999")

    def test_images_without_a_recipe_are_refused(self):
        write_png(self.folder / "a.png", 2, 2, lambda x, y: (0, 0, 0))
        self.check_error(REFUSED, "a.png: holds no recipe", "rerun", "a.png")
        self.check_error(REFUSED, "b.hdr: holds no recipe", "rerun", self.render("b.hdr"))
        self.check_error(REFUSED, "none.exr: No such file or directory", "rerun", "none.exr")
        self.check_done("reference", SCENE, "-o", "r.exr", "--size", "8x8", "--spp", "1", "--quiet")
        self.check_error(REFUSED, "r.exr: is an image of vernier reference", "rerun", "r.exr")

    def test_recipes_that_make_no_sense_are_refused(self):
        self.render("a.exr")
        sound = (self.folder / "a.exr").read_bytes()
        for old, new, said in [(b'"spp":"1"', b'"spp":"x"', "in its recipe: --spp"), (b'"seed":', b'"sead":', "--sead, which this version"),
                               (b'{"size"', b'["size"', "vernier:options in its metadata is no JSON object")]:
            self.assertIn(old, sound)
            (self.folder / "a.exr").write_bytes(sound.replace(old, new))
            self.check_error(REFUSED, said, "rerun", "a.exr")


if __name__ == "__main__":
    unittest.main()
