"""The error at fixed work (samples, bounces, level) does not rise beyond what is recorded; time only warns.

tests/golden/fixed_work.json says for each scene what was measured and why the margin is what it is.
`fixed_work_test.py --record` prints its content anew.
"""

import json
import math
import statistics
import sys
import unittest

from program import SCENES, ProgramTest

RECORD = SCENES.parent / "tests/golden/fixed_work.json"
VIEW = ["--size", "48x36"]
WORK = ["--spp", 16, "--max-bounces", 8, "--accuracy", "robust"]
TRUTH = ["--spp", 1024, "--max-bounces", 16, "--cutoff", "1/16384", "--accuracy", "exact", "--seed", 4000000000]
SEEDS = range(4)
SLOWER = 3.0  # machines differ by as much; a warning is all that comes of it


class FixedWorkTest(ProgramTest):
    def measure(self, scene):
        """Mean over seeds of sqrt(relMSE), the deviation of one seed, rays of a render, and its device time."""
        path = SCENES / scene
        self.check_done("render", path, "-o", "truth.exr", *VIEW, *TRUTH)
        errors, times = [], []
        for seed in SEEDS:
            self.check_done("render", path, "-o", "out.exr", "--json", "out.json", *VIEW, *WORK, "--seed", seed)
            self.check_done("diff", "out.exr", "truth.exr", "--json", "diff.json")
            difference = json.loads((self.folder / "diff.json").read_text())
            self.assertEqual(difference["non_finite"], {"a": 0, "b": 0})
            errors.append(math.sqrt(difference["rel_mse"]))
            report = json.loads((self.folder / "out.json").read_text())
            times.append(report["trace_device_ms"])
        return {"error": float(f"{statistics.fmean(errors):.4g}"),
                "deviation": float(f"{statistics.stdev(errors):.2g}"),
                "rays": sum(report["rays"].values()), "device_ms": float(f"{statistics.median(times):.3g}")}

    def test_the_error_at_fixed_work_does_not_rise(self):
        recorded = json.loads(RECORD.read_text())
        for scene, before in recorded["scenes"].items():
            with self.subTest(scene=scene):
                now = self.measure(scene)
                bound = before["error"] * (1.0 + recorded["margin"])
                self.assertLessEqual(now["error"], bound, f"{scene}: the error at {WORK} was {before['error']}")
                # The work is fixed only if it is the same rays: a few may turn at an edge on another driver.
                self.assertAlmostEqual(now["rays"] / before["rays"], 1.0, delta=recorded["margin"])
                if now["device_ms"] > SLOWER * before["device_ms"]:
                    print(f"warning: {scene}: {now['device_ms']} ms, recorded {before['device_ms']} ms")


class Recorder(FixedWorkTest):
    def runTest(self):
        recorded = json.loads(RECORD.read_text())
        recorded["scenes"] = {scene: self.measure(scene) for scene in recorded["scenes"]}
        print(json.dumps(recorded, indent=2))


if __name__ == "__main__":
    if sys.argv[1:] == ["--record"]:
        unittest.TextTestRunner().run(Recorder())
    else:
        del Recorder  # the loader would run its inherited test too
        unittest.main()
