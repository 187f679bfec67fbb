"""--filter and --texture-filter: the renderer does what the arbiter does by code of its own, and each changes the picture."""

import json
import unittest

from program import SCENES, ProgramTest

SCENE = str(SCENES / "texture_wrap.glb")  # both ways of looking up, and edges everywhere
VIEW = ["--size", "96x72", "--spp", 16]
FILTERS = [["--filter", "tent"], ["--texture-filter", "nearest"], ["--texture-filter", "linear"]]


class FilterTest(ProgramTest):
    def rmse(self, a, b):
        self.check_done("diff", a, b, "--json", "diff.json")
        return json.loads((self.folder / "diff.json").read_text())["rmse"]

    def test_each_filter_is_what_the_reference_does(self):
        self.check_done("render", SCENE, "-o", "plain.exr", *VIEW)
        for options in FILTERS:
            with self.subTest(options=options):
                self.check_done("render", SCENE, "-o", "a.exr", *VIEW, *options)
                self.check_done("reference", SCENE, "-o", "b.exr", *VIEW, *options)
                changed = self.rmse("a.exr", "plain.exr")
                self.assertGreater(changed, 0.001)
                # Floats against doubles: a sample that rounds to the other side of an edge is one of a thousand at most.
                self.assertLess(self.rmse("a.exr", "b.exr"), changed / 100)

    def test_one_sample_stays_in_the_middle(self):
        for name, filter_name in [("a.hdr", "box"), ("b.hdr", "tent")]:
            self.check_done("render", SCENE, "-o", name, "--size", "24x16", "--spp", 1, "--filter", filter_name)
        self.assertEqual((self.folder / "a.hdr").read_bytes(), (self.folder / "b.hdr").read_bytes())

    def test_crops_have_the_bits_of_the_whole(self):
        view = ["--size", "32x20", "--spp", 4, "--filter", "tent"]
        self.check_done("render", SCENE, "-o", "whole.exr", *view)
        for name, crop in [("left.exr", "0,0,13,20"), ("right.exr", "13,0,19,20")]:
            self.check_done("render", SCENE, "-o", name, *view, "--crop", crop)
        self.check_done("merge", "left.exr", "right.exr", "-o", "merged.exr")
        self.assertEqual((self.folder / "merged.exr").read_bytes(), (self.folder / "whole.exr").read_bytes())
        self.check_done("rerun", "whole.exr")


if __name__ == "__main__":
    unittest.main()
