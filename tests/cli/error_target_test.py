"""vernier render --error-target: stops where it says, tells what it reached, does not depend on tiles."""

import json
import math
import unittest

from program import SCENES, USAGE, ProgramTest

SCENE = str(SCENES / "materials.glb")  # highlights: few of its pixels are noisy
VIEW = ["--size", "48x36"]
TARGET = 0.02


class ErrorTargetTest(ProgramTest):
    converged = None

    def render(self, name, *arguments):
        result = self.check_done("render", SCENE, "-o", name, "--json", "out.json", *VIEW, *arguments)
        return json.loads((self.folder / "out.json").read_text()), result.stderr

    def error_of(self, name):
        """sqrt(relMSE) of an image against the converged one."""
        converged = self.folder / "converged.exr"
        if ErrorTargetTest.converged is None:
            self.check_done("render", SCENE, "-o", converged, *VIEW, "--spp", 4096, "--seed", 1000)
            ErrorTargetTest.converged = converged.read_bytes()
        converged.write_bytes(ErrorTargetTest.converged)
        self.check_done("diff", name, converged, "--json", "diff.json")
        return math.sqrt(json.loads((self.folder / "diff.json").read_text())["rel_mse"])

    def test_the_true_error_lies_below_the_bound(self):
        covered = 0
        for seed in range(12):
            report, _ = self.render("out.exr", "--error-target", TARGET, "--seed", seed)
            self.assertLessEqual(report["error_estimate"], TARGET)
            covered += self.error_of("out.exr") <= report["error_estimate"]
        # Of 12 bounds that hold with 95 % each, 9 or fewer hold once in 50 such tests; seeds are fixed, so this is no dice.
        self.assertGreaterEqual(covered, 10)

    def test_noisy_pixels_get_more_samples_and_the_whole_takes_fewer_rays(self):
        adaptive, stderr = self.render("out.exr", "--error-target", TARGET, "--aov", "sample_count")
        self.assertIn("sqrt(relMSE) at most", stderr)
        self.assertGreaterEqual(adaptive["samples_done"], 8)
        self.assertGreater(adaptive["mean_samples"], adaptive["samples_done"])
        self.assertEqual(adaptive["rays"]["primary"], round(adaptive["mean_samples"] * 48 * 36))
        reached = self.error_of("out.exr")
        uniform_spp = 8
        while uniform_spp < 1024:
            uniform, _ = self.render("uniform.exr", "--spp", uniform_spp)
            if self.error_of("uniform.exr") <= reached:
                break
            uniform_spp *= 2
        self.assertGreater(sum(uniform["rays"].values()), 2 * sum(adaptive["rays"].values()))

    def test_tiles_and_dispatches_change_no_bit(self):
        pictures = []
        for name, arguments in [("a.hdr", []), ("b.hdr", ["--tile", "20x12"]), ("c.hdr", ["--tile", "8x8", "--dispatch-ms", 1])]:
            self.render(name, "--error-target", TARGET, *arguments)
            pictures.append((self.folder / name).read_bytes())  # .hdr holds no metadata
        self.assertEqual(pictures[0], pictures[1])
        self.assertEqual(pictures[0], pictures[2])

    def test_samples_end_at_spp_and_that_is_said(self):
        report, stderr = self.render("out.exr", "--error-target", 1e-4, "--spp", 12)
        self.assertLessEqual(report["mean_samples"], 12)
        self.assertGreater(report["error_estimate"], 1e-4)
        self.assertIn("--error-target", stderr)
        self.assertTrue(any("--error-target" in warning for warning in report["warnings"]), report["warnings"])

    def test_the_image_says_what_it_reached(self):
        report, _ = self.render("out.png", "--error-target", TARGET)
        self.assertIn(b"vernier:error_estimate", (self.folder / "out.png").read_bytes())
        self.assertIsNotNone(report["error_estimate"])
        self.check_done("rerun", "out.png", "--quiet")

    def test_a_time_limit_ends_it_too(self):
        report, _ = self.render("out.exr", "--error-target", 1e-6, "--time-limit", 2)
        self.assertGreater(report["samples_done"], 0)

    def test_what_makes_no_sense_is_refused(self):
        for arguments in [["--error-target", 0], ["--error-target", "x"], ["--error-target", "nan"],
                          ["--error-target", 0.1, "--spp", 1],
                          ["--error-target", 0.1, "--spp", 8, "--sample-range", "0:4"]]:
            self.check_error(USAGE, "--error-target", "render", SCENE, "-o", "out.exr", *VIEW, *arguments)
        self.assertEqual(self.files(), [])


if __name__ == "__main__":
    unittest.main()
