"""Wrong usage ends with exit code 2 and one line that names the option, before anything is read or written."""

import subprocess
import unittest

from program import FAILED, PROGRAM, SCENE, USAGE, ProgramTest

BAD_OPTIONS = {
    "--size": ["12", "0x5", "5x0", "-1x5", "70000x1", "4x4x4", "axb", "65536x65536", "", " 4x4"],
    "--crop": ["1,2,3", "0,0,0,1", "1270,0,20,20", "0,0,1281,1", "-1,0,2,2"],
    "--spp": ["0", "-1", "1.5", "x", "99999999999"],
    "--sample-range": ["4:4", "5:4", "0:17", "4", "a:b", "0:1:2"],
    "--max-bounces": ["1001", "-1", "x"],
    "--cutoff": ["-0.1", "1.5", "nan", "1/0", "x", "1/2/3"],
    "--accuracy": ["best", "Fast", ""],
    "--filter": ["gauss", "Box", ""],
    "--texture-filter": ["bilinear", ""],
    "--effects": ["shadow", "auto,", "auto,-fog", ","],
    "--bvh": ["slow", "Fast", ""],
    "--traversal": ["array", "Auto", ""],
    "--tile": ["8", "0x8"],
    "--dispatch-ms": ["0", "-5", "inf", "x"],
    "--time-limit": ["0", "-1", "nan"],
    "--aov": ["depht", "depth,depth", "depth,,uv"],
    "--seed": ["-1", "4294967296"],
    "--exposure": ["x", "1000", "nan"],
    "--fov": ["0", "180", "-3", "nan", "x"],
    "--view-height": ["0", "-1", "nan", "inf", "x"],
    "--eye": ["1,2", "1,2,3,4", "a,b,c", "nan,0,0", "inf,0,0"],
    "--target": ["0,0"],
    "--up": ["0,0,x"],
    "--light": ["spot:0,0,0:1,1,1", "point:0,0,0", "dir:0,0,0:1,1,1", "point:0,0,0:-1,1,1", "point:0,0:1,1,1", "x"],
    "--background": ["1,2", "-1,0,0"],
    "--ambient": ["1", "-1,0,0"],
}


class UsageTest(ProgramTest):
    def test_bad_option_values(self):
        for option, values in BAD_OPTIONS.items():
            for value in values:
                with self.subTest(option=option, value=value):
                    line = self.check_error(USAGE, "", "render", SCENE, f"{option}={value}")
                    if (option, value) != ("--size", ""):
                        self.assertIn(option, line)
        self.assertEqual(self.files(), [])

    def test_unknown_things(self):
        self.check_error(USAGE, "--help", "paint")
        self.check_error(USAGE, "vernier --help")
        self.check_error(USAGE, "vernier render --help", "render", SCENE, "--fog")
        self.check_error(USAGE, "--help", "render", SCENE, "another.glb")
        self.check_error(USAGE, "SCENE", "explain")
        self.check_error(USAGE, "--output", "reference", SCENE)
        self.check_error(USAGE, "B", "diff", "a.png")

    def test_empty_names(self):
        for words in (["render", ""], ["render", "-o", ""], ["explain", ""], ["reference", "", "-o", "a.png"], ["cost", "", "-o", "a"],
                      ["cost", SCENE, "-o", ""], ["view", ""], ["merge", "a.exr", "-o", ""]):
            with self.subTest(words=words):
                self.check_error(USAGE, "", *words)
        self.assertEqual(self.files(), [])

    def test_a_value_that_is_missing(self):
        for option in ("--json", "--checkpoint", "--resume", "--crop", "--sample-range", "--aov", "--device", "--camera", "--eye", "--fov",
                       "--background", "--spp", "--tile", "--time-limit", "--error-target", "--effects", "--light"):
            with self.subTest(option=option):
                self.check_error(USAGE, option, "render", SCENE, option, "")
                self.check_error(USAGE, option, "render", SCENE, option, "--quiet")
        self.check_error(USAGE, "--json", "devices", "--json", "--quiet")
        self.assertEqual(self.files(), [])

    def test_options_that_do_not_go_together(self):
        self.check_error(USAGE, "--crop", "render", SCENE, "-o", "a.exr", "--error-target", "0.1", "--crop", "0,0,8,8")
        self.check_error(USAGE, "--case", "verify", "--mutate", "naive_sum", "--case", "shared_edge")
        self.check_error(USAGE, "--spp", "render", SCENE, "--spp", 2**20 + 1)
        self.check_error(USAGE, "--traversal", "view", SCENE, "--traversal", "texels-array")
        self.assertEqual(self.files(), [])

    def test_view_reads_its_options_before_a_window_opens(self):
        self.check_error(USAGE, "--size", "view", SCENE, "--size", "0x5")
        self.check_error(USAGE, "--effects", "view", SCENE, "--effects", "auto,-fog")
        self.check_error(USAGE, "--script", "view", SCENE, "--record", "shots")
        self.check_error(USAGE, "--record", "view", SCENE, "--script", "script.txt")
        self.check_error(USAGE, "--crop", "view", SCENE, "--crop", "0,0,1,1")
        self.check_error(USAGE, "--bvh", "view", SCENE, "--bvh", "best")

    def test_the_window_program_by_itself_tells_wrong_usage_the_same_way(self):
        for words in (["view", SCENE, "--size", "0x5"], ["view", "--gone"], ["gone"], []):
            with self.subTest(words=words):
                result = subprocess.run([PROGRAM + "-view", *words], cwd=self.folder, capture_output=True, text=True, check=False)
                self.assertEqual(result.returncode, USAGE, result.stderr)
                self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
                self.assertTrue(result.stderr.startswith("error: "), result.stderr)
        self.assertEqual(self.files(), [])

    def test_view_without_a_screen(self):
        # Where the window was not built, the line says what to install.
        self.check_error(FAILED, "window", "view", SCENE, environment={"DISPLAY": "", "WAYLAND_DISPLAY": ""})

    def test_option_given_twice(self):
        self.check_error(USAGE, "--spp", "render", SCENE, "--spp", "1", "--spp", "2")

    def test_quiet_excludes_verbose(self):
        self.check_error(USAGE, "--quiet", "render", SCENE, "--quiet", "--verbose")

    def test_unknown_image_extension(self):
        for name in ["picture", "picture.bmp", "picture.exr.txt"]:
            self.check_error(USAGE, name, "render", SCENE, "-o", name)

    def test_negative_numbers_are_values(self):
        self.check_error(USAGE, "not from", "render", SCENE, "--exposure", "-101")
        self.check_error(USAGE, "--target", "explain", SCENE, "--eye", "-1,-2,-3", "--target", "-1,-2")


if __name__ == "__main__":
    unittest.main()
