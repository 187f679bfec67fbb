"""vernier diff: figures of two images."""

import json
import unittest

from pictures import write_png
from program import FAILED, REFUSED, USAGE, ProgramTest


class DiffTest(ProgramTest):
    def image(self, name, width, height, pixel):
        return write_png(self.folder / name, width, height, pixel)

    def diff(self, *arguments):
        result = self.check_done("diff", *arguments, "--json", "diff.json")
        report = json.loads((self.folder / "diff.json").read_text())
        self.assertEqual(report["schema"], 1)
        for word in ["RMSE", "relMSE", "PSNR", "max", "FLIP mean", "FLIP p99", "non-finite"]:
            self.assertIn(word, result.stdout)
        return report

    def test_equal_images(self):
        a = self.image("a.png", 8, 4, lambda x, y: (x * 30, y * 60, 9))
        report = self.diff(a, a)
        self.assertEqual((report["width"], report["height"]), (8, 4))
        self.assertEqual(report["rmse"], 0)
        self.assertIsNone(report["psnr_db"])
        self.assertEqual(report["flip"], {"mean": 0, "p99": 0})
        self.assertEqual(report["non_finite"], {"a": 0, "b": 0})
        self.assertEqual(report["compared_pixels"], 32)

    def test_one_white_pixel_on_black(self):
        a = self.image("a.png", 8, 4, lambda x, y: (255,) * 3 if (x, y) == (5, 2) else (0,) * 3)
        b = self.image("b.png", 8, 4, lambda x, y: (0, 0, 0))
        report = self.diff(a, b, "--map", "map.png")
        self.assertAlmostEqual(report["rmse"], (1 / 32) ** 0.5, places=6)
        self.assertAlmostEqual(report["rel_mse"], 100 / 32, places=5)
        self.assertEqual(report["max"], 1)
        self.assertEqual(report["max_pixel"], [5, 2])
        self.assertGreater(report["flip"]["mean"], 0)
        self.assertTrue((self.folder / "map.png").read_bytes().startswith(b"\x89PNG"))

    def test_sizes_that_differ(self):
        a = self.image("a.png", 8, 4, lambda x, y: (0, 0, 0))
        b = self.image("b.png", 4, 8, lambda x, y: (0, 0, 0))
        self.check_error(REFUSED, "4x8", "diff", a, b)

    def test_json_alone_on_standard_output(self):
        a = self.image("a.png", 8, 4, lambda x, y: (x * 30, y * 60, 9))
        result = self.check_done("diff", a, a, "--json", "-", "--quiet")
        self.assertEqual(json.loads(result.stdout)["rmse"], 0)
        self.assertEqual(self.files(), ["a.png"])

    def test_missing_and_broken_images(self):
        a = self.image("a.png", 8, 4, lambda x, y: (0, 0, 0))
        self.check_error(REFUSED, "gone.png", "diff", a, "gone.png")
        content = bytearray((self.folder / a).read_bytes())
        content[content.index(b"IDAT") + 8] ^= 0x55
        (self.folder / "damaged.png").write_bytes(content)
        self.check_error(REFUSED, "damaged.png: the PNG file is damaged", "diff", a, "damaged.png")
        self.write("broken.exr", "no image")
        self.check_error(REFUSED, "broken.exr", "diff", "broken.exr", a)

    def test_outputs_are_checked_first(self):
        self.check_error(USAGE, "map.bmp", "diff", "gone.png", "gone.png", "--map", "map.bmp")
        self.check_error(FAILED, "nowhere", "diff", "gone.png", "gone.png", "--json", "nowhere/a.json")


if __name__ == "__main__":
    unittest.main()
