"""vernier merge: crops and parts of the samples give the bytes of one render; what does not belong together is refused."""

import unittest

from program import REFUSED, SCENE, USAGE, ProgramTest

RENDER = ["render", SCENE, "--size", "40x24", "--spp", "13", "--aov", "normal,object_id,cost,sample_count", "--quiet"]
CROPS = ["0,0,17,9", "17,0,23,9", "0,9,17,15", "17,9,23,15"]
RANGES = ["0:1", "1:6", "6:13"]


class MergeTest(ProgramTest):
    def render(self, name, *options):
        self.check_done(*RENDER, "-o", name, *options)
        return name

    def whole(self, *options):
        return (self.folder / self.render("whole.exr", *options)).read_bytes()

    def merge(self, *parts, output="merged.exr"):
        self.check_done("merge", *parts, "-o", output)
        return (self.folder / output).read_bytes()

    def test_crops_and_ranges_give_the_bytes_of_the_whole(self):
        whole = self.whole()
        crops = [self.render(f"crop{i}.exr", "--crop", crop) for i, crop in enumerate(CROPS)]
        ranges = [self.render(f"range{i}.exr", "--sample-range", part) for i, part in enumerate(RANGES)]
        self.assertEqual(self.merge(*reversed(crops)), whole)
        self.assertEqual(self.merge(*ranges), whole)
        self.assertEqual(self.merge(*reversed(ranges)), whole)
        both = [self.render(f"both{i}.exr", "--crop", CROPS[3], "--sample-range", part) for i, part in enumerate(RANGES)]
        self.assertEqual(self.merge(*crops[:3], *both), whole)
        self.check_done("rerun", "merged.exr", "--quiet")
        for parts, line in [(crops[:3], "parts are missing: none holds pixel 17,9, sample 0 of 13"),
                            (ranges[::2], "parts are missing: none holds pixel 0,0, sample 1 of 13"),
                            ([*ranges, ranges[0]], "range0.exr: holds samples that range0.exr holds too"),
                            ([*crops, both[0]], "both0.exr: holds samples that crop3.exr holds too, the first of them: pixel 17,9, sample 0")]:
            self.check_error(REFUSED, line, "merge", *parts, "-o", "x.exr")
        self.assertNotIn("x.exr", self.files())
        self.check_error(USAGE, "--output: it names the same file as PART", "merge", *crops, "-o", crops[0])

    def test_exposure_is_that_of_the_parts(self):
        halves = [self.render(f"{i}.exr", "--exposure", "1", "--crop", crop) for i, crop in enumerate(("0,0,20,24", "20,0,20,24"))]
        self.render("whole.png", "--exposure", "1")
        self.assertEqual(self.merge(*halves, output="merged.png"), (self.folder / "whole.png").read_bytes())
        self.check_done("rerun", "merged.png", "--quiet")
        other = self.render("2.exr", "--exposure", "2", "--crop", "20,0,20,24")
        self.check_error(REFUSED, "--exposure is `2`, there `1`", "merge", halves[0], other, "-o", "x.png")

    def test_a_part_of_the_samples_has_no_legend_of_costs(self):
        result = self.check_done("render", SCENE, *RENDER[2:6], "--sample-range", "0:2", "-o", "a.exr")
        self.assertNotIn("cost:", result.stderr)

    def test_parts_of_the_built_in_scene(self):
        render = ["render", "--size", "16x9", "--spp", "2", "--quiet", "-o"]
        self.check_done(*render, "whole.exr")
        self.check_done(*render, "a.exr", "--sample-range", "0:1")
        self.check_done(*render, "b.exr", "--sample-range", "1:2")
        self.assertEqual(self.merge("a.exr", "b.exr"), (self.folder / "whole.exr").read_bytes())

    def test_what_was_rendered_otherwise_is_refused(self):
        first = self.render("a.exr", "--sample-range", "0:6")
        for options, said in [(["--seed", "1"], "--seed is `1`, there `0`"), (["--max-bounces", "2"], "--max-bounces is `2`, there `8`"),
                              (["--light", "dir:0,-1,0:1,1,1"], "--light is `[\"dir:0,-1,0:1,1,1\"]`, there not set"),
                              (["--background", "0,0,0"], "--background is `0,0,0`, there not set")]:
            other = self.render("b.exr", "--sample-range", "6:13", *options)
            self.check_error(REFUSED, f"b.exr: does not belong to a.exr: {said}", "merge", first, other, "-o", "x.exr")
        self.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.check_done("render", "t.obj", *RENDER[2:], "-o", "b.exr", "--sample-range", "6:13")
        self.check_error(REFUSED, "b.exr: does not belong to a.exr: SHA-1 of the scene's files", "merge", first, "b.exr", "-o", "x.exr")

    def test_numbers_in_other_words_are_the_same(self):
        parts = [self.render("a.exr", "--sample-range", "0:6", "--cutoff", "1/1024"),
                 self.render("b.exr", "--sample-range", "6:13", "--cutoff", "0.0009765625")]
        self.check_done("merge", *parts, "-o", "x.exr", "--quiet")

    def test_sums_of_floats_are_refused(self):
        parts = [self.render(f"{i}.exr", "--accuracy", "fast", "--sample-range", part) for i, part in enumerate(RANGES)]
        self.check_error(REFUSED, "0.exr: has sums of floats, which have other bits in parts", "merge", *parts, "-o", "x.exr")

    def test_what_is_no_part_is_refused(self):
        self.check_error(USAGE, "-o", "merge", "a.exr")
        self.check_error(REFUSED, "a.exr: No such file or directory", "merge", "a.exr", "-o", "x.exr")
        self.render("a.png")
        self.check_error(REFUSED, "a.png: only EXR files", "merge", "a.png", "-o", "x.exr")
        self.check_done("reference", SCENE, "-o", "r.exr", "--size", "8x8", "--spp", "1", "--quiet")
        self.check_error(REFUSED, "r.exr: is an image of vernier reference", "merge", "r.exr", "-o", "x.exr")

    def test_display_images_of_parts_have_no_sums_beside_them(self):
        self.render("a.png", "--sample-range", "0:6")
        self.assertFalse([name for name in self.files() if "film" in name])


if __name__ == "__main__":
    unittest.main()
