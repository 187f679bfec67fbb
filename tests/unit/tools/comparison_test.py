"""tools/benchmark --compare: the test of ranks, and what it refuses."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import tool_path
from benchmarking import comparison

BENCHMARK = tool_path.ROOT / "tools/benchmark"


def results(rates: list, **changes) -> dict:
    rounds = [{"Vernier": {"rays_per_s": rate}, "POV-Ray": {"rays_per_s": 1.0}, "Embree": {"rays_per_s": 20.0}} for rate in rates]
    return {"schema": comparison.SCHEMA, "device": "llvmpipe", "driver": "Mesa", "cpu": "some", "threads": 2, "triangles": 100,
            "size": [64, 64], "spp": 4, "max_bounces": 8, "each_round": rounds, **changes}


class ComparisonTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name: str, content) -> pathlib.Path:
        path = self.folder / name
        path.write_text(content if isinstance(content, str) else json.dumps(content), encoding="utf-8")
        return path

    def compare(self, old, new) -> str:
        return comparison.compare(self.write("old.json", old), self.write("new.json", new))

    def test_ways_to_win_are_those_of_all_orders(self):
        # Two values against two: of the 6 orders 1, 1, 2, 1, 1 have 0 to 4 wins.
        self.assertEqual(comparison.ways_to_win(2, 2), [1, 1, 2, 1, 1])
        self.assertEqual(sum(comparison.ways_to_win(5, 5)), 252)  # 10 over 5

    def test_chance_of_equal(self):
        self.assertEqual(comparison.chance_of_equal([1, 2, 3, 4], [1, 2, 3, 4]), 1.0)
        # All of five above all of five: one order of 252 on either side.
        self.assertAlmostEqual(comparison.chance_of_equal([1, 2, 3, 4, 5], [6, 7, 8, 9, 10]), 2 / 252)
        self.assertAlmostEqual(comparison.chance_of_equal([6, 7, 8, 9, 10], [1, 2, 3, 4, 5]), 2 / 252)

    def test_faster_slower_and_not_told_apart(self):
        slow, fast, mixed = [4.0, 4.1, 3.9, 4.05, 3.95], [4.8, 4.9, 4.7, 4.85, 4.75], [3.8, 4.2, 4.0, 4.12, 3.97]
        self.assertIn("the new build is faster", self.compare(results(slow), results(fast)))
        self.assertIn("by POV-Ray: 1.200 times as fast", self.compare(results(slow), results(fast)))
        self.assertIn("the new build is slower", self.compare(results(fast), results(slow)))
        self.assertIn("not told apart", self.compare(results(slow), results(mixed)))

    def test_other_devices_and_scenes_are_refused(self):
        for name in comparison.SAME:
            with self.assertRaisesRegex(comparison.NotComparable, f"differ in {name}"):
                self.compare(results([4.0]), results([4.0], **{name: "another"}))

    def test_widths_that_builds_chose_are_no_other_devices(self):
        old = results([1.0] * 5, device="llvmpipe (LLVM 15, 256 bits)")
        self.assertTrue(self.compare(old, results([2.0] * 5, device="llvmpipe (LLVM 15)")))

    def test_no_results_are_refused_in_one_line(self):
        good = self.write("good.json", results([4.0]))
        for text in ("", "[]", '{"schema": 1}'):
            done = subprocess.run([sys.executable, "-B", BENCHMARK, "--compare", good, self.write("bad.json", text)],
                                  capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertIn("bad.json", done.stderr)


if __name__ == "__main__":
    unittest.main()
