"""vernier reference: a small image with its layers."""

import unittest

from program import SMALL, TRIANGLE_OBJ, ProgramTest


class ReferenceTest(ProgramTest):
    def test_small_image_is_written_and_repeats(self):
        self.write("triangle.obj", TRIANGLE_OBJ)
        for name in ["a.exr", "b.exr"]:
            result = self.check_done("reference", "triangle.obj", "-o", name, "--threads", "2", *SMALL)
            self.assertIn("24x16", result.stderr)
        self.assertEqual((self.folder / "a.exr").read_bytes(), (self.folder / "b.exr").read_bytes())
        self.assertEqual(self.files(), ["a.exr", "b.exr", "triangle.obj"])

    def test_other_formats_hold_the_colours_alone(self):
        self.write("triangle.obj", TRIANGLE_OBJ)
        self.check_done("reference", "triangle.obj", "-o", "a.png", *SMALL, "--quiet")
        self.assertEqual(self.files(), ["a.png", "triangle.obj"])

    def test_quiet_says_nothing(self):
        self.write("triangle.obj", TRIANGLE_OBJ)
        result = self.check_done("reference", "triangle.obj", "-o", "a.exr", "--quiet", *SMALL)
        self.assertEqual(result.stdout + result.stderr, "")


if __name__ == "__main__":
    unittest.main()
