"""What a command writes is whole, where it was asked for, and takes the place of nothing else."""

import json
import os
import subprocess
import unittest

from program import DONE, FAILED, PROGRAM, SCENE, SMALL, TRIANGLE_OBJ, USAGE, ProgramTest


class OutputTest(ProgramTest):
    def test_names_in_other_encodings(self):
        """Statistics are UTF-8 whatever the names of materials and files are."""
        name = os.fsdecode(b"sch\xf6n.obj")
        self.write(name, "mtllib a.mtl\n" + TRIANGLE_OBJ)
        (self.folder / name).write_bytes(b"mtllib a.mtl\nusemtl M\xf6bel\n" + TRIANGLE_OBJ.encode())
        (self.folder / "a.mtl").write_bytes(b"newmtl M\xf6bel\nKd 1 0 0\n")
        self.check_done("render", name, "-o", "out.exr", "--json", "out.json", *SMALL)
        self.assertEqual(json.loads((self.folder / "out.json").read_text())["scene"], "sch\N{REPLACEMENT CHARACTER}n.obj")
        self.check_done("explain", name, "--no-costs", "--json", "explain.json")
        self.assertIn("M\N{REPLACEMENT CHARACTER}bel", (self.folder / "explain.json").read_text())

    def test_one_file_for_two_things(self):
        self.write("triangle.obj", TRIANGLE_OBJ)
        self.check_done("render", SCENE, "-o", "sky.hdr", *SMALL)
        before = self.files()
        (self.folder / "link").symlink_to("sky.hdr")
        for arguments in (["-o", "out.png", "--json", "./out.png"], ["-o", "sky.hdr", "--json", "link"],
                          ["-o", "out.exr", "--checkpoint", "../" + self.folder.name + "/out.exr"],
                          ["-o", "out.png", "--aov", "depth", "--json", "out.depth.png"],
                          ["-o", "sky.hdr", "--background", "sky.hdr"], ["-o", "out.png", "--json", "triangle.obj"],
                          ["-o", "out.png", "--checkpoint", "a", "--json", "a"], ["-o", "out.png", "--resume", "a", "--json", "a"]):
            self.check_error(USAGE, "the same file as", "render", "triangle.obj", *SMALL, *arguments)
        self.check_error(USAGE, "the same file as", "diff", "sky.hdr", "sky.hdr", "--map", "sky.hdr")
        self.check_error(USAGE, "the same file as", "reference", "triangle.obj", "-o", "sky.hdr", "--background", "sky.hdr")
        (self.folder / "link").unlink()
        self.assertEqual(self.files(), before)
        self.check_done("diff", "sky.hdr", "sky.hdr", "--json", "/dev/null")

    def test_files_that_the_scene_reads_stay(self):
        self.write("model.obj", "mtllib model.mtl\nusemtl a\nvt 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/1 3/1\n")
        self.write("model.mtl", "newmtl a\nmap_Kd model.png\n")
        self.check_done("render", SCENE, "-o", "model.png", *SMALL)
        before = {name: (self.folder / name).read_bytes() for name in self.files()}
        for words in (["render", "model.obj"], ["render", "model.obj", "-o", "a.png", "--json", "model.mtl"],
                      ["reference", "model.obj", "-o", "model.png"], ["explain", "model.obj", "--no-costs", "--json", "model.mtl"]):
            with self.subTest(words=words):
                size = [] if words[0] == "explain" else SMALL
                self.check_error(USAGE, "a file of the scene", *words, *size)
        os.makedirs(self.folder / "out/images")
        self.check_done("render", SCENE, "-o", "out/images/reference.png", *SMALL)
        truth = (self.folder / "out/images/reference.png").read_bytes()
        (self.folder / "out/images/0.png").write_bytes(truth)
        for picture in ("reference.png", "0.png"):
            self.check_error(USAGE, f"the place of out/images/{picture}", "cost", "model.obj", "-o", "out", "--size", "24x16",
                             "--reference", f"out/images/{picture}")
        self.assertEqual((self.folder / "out/images/reference.png").read_bytes(), truth)
        self.assertEqual({name: (self.folder / name).read_bytes() for name in before}, before)

    def test_layers_are_looked_at_before_the_work(self):
        os.mkdir(self.folder / "a.depth.png")
        self.check_error(FAILED, "a.depth.png", "render", SCENE, "-o", "a.png", "--aov", "depth", *SMALL)
        self.assertEqual(self.files(), ["a.depth.png"])

    def test_sides_that_jpeg_does_not_have(self):
        self.check_error(USAGE, "65500", "render", SCENE, "-o", "out.jpg", "--size", "65501x1", "--spp", "1")
        self.check_error(USAGE, "65500", "reference", SCENE, "-o", "out.jpg", "--size", "1x65501", "--spp", "1")
        self.assertEqual(self.files(), [])
        self.check_done("render", SCENE, "-o", "out.jpg", "--size", "65500x1", "--spp", "1")

    def test_without_a_sample_the_older_picture_stays(self):
        (self.folder / "out.png").write_text("an older picture")
        self.check_error(FAILED, "before the first sample", "render", SCENE, "-o", "out.png", "--size", "2048x2048", "--spp", "4096",
                         "--dispatch-ms", "1", "--time-limit", "0.001")
        self.assertEqual((self.folder / "out.png").read_text(), "an older picture")
        self.assertEqual(self.files(), ["out.png"])

    def test_a_picture_with_gaps_is_told(self):
        self.check_error(FAILED, "pixels without a sample are black", "render", SCENE, "-o", "out.png", "--size", "2048x2048",
                         "--spp", "4", "--tile", "8x8", "--dispatch-ms", "1", "--time-limit", "1", "--quiet")
        self.assertEqual(self.files(), ["out.png"])

    def test_pixels_that_need_more_memory_than_there_is(self):
        self.check_error(USAGE, "--crop", "render", SCENE, "-o", "out.exr", "--size", "16384x16384", "--spp", "1",
                         "--aov", "depth,position,normal,shading_normal,uv,albedo", "--sample-range", "0:1")

    def test_a_full_standard_output_is_a_failure(self):
        with open("/dev/full", "w") as full:
            result = subprocess.run([PROGRAM, "explain", SCENE, "--no-costs"], stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual(result.returncode, FAILED)
        self.assertIn("standard output", result.stderr)

    def test_figures_to_the_standard_output(self):
        self.check_done("render", SCENE, "-o", "a.png", *SMALL)
        with open(self.folder / "all.txt", "w") as out:
            result = subprocess.run([PROGRAM, "diff", "a.png", "a.png", "--json", "/dev/stdout"], cwd=self.folder, stdout=out)
        self.assertEqual(result.returncode, DONE)
        text = (self.folder / "all.txt").read_text()
        figures, end = json.JSONDecoder().raw_decode(text)
        self.assertEqual(figures["rmse"], 0.0)
        self.assertIn("RMSE", text[end:])


if __name__ == "__main__":
    unittest.main()
