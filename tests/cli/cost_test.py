"""vernier cost: what it writes, that its claims hold on a fresh seed, and what it refuses."""

import csv
import json
import math
import os
import re
import shlex
import signal
import subprocess
import unittest

from program import FAILED, PROGRAM, REFUSED, SCENES, USAGE, ProgramTest

SCENE = str(SCENES / "materials.glb")
REPORT = str(SCENES.parent / "tools/report")
VIEW = ["--size", "48x36"]


def chance_of_at_least(count, trials, share):
    """Of `count` or more among `trials` independent ones that each come with the probability `share`."""
    return sum(math.comb(trials, k) * share**k * (1 - share) ** (trials - k) for k in range(count, trials + 1))


class CostTest(ProgramTest):
    def cost(self, *arguments, report="", scene=SCENE):
        result = self.check_done("cost", scene, "-o", "report", *VIEW, *arguments,
                                 environment={"VERNIER_REPORT": report})
        return json.loads((self.folder / "report/cost.json").read_text()), result

    def test_quick_writes_a_report_whose_claims_hold(self):
        # Less fits into the time of a busy machine, and the report says what did not; then it is given more.
        for budget_s in (25, 75, 225):
            cost, result = self.cost("--quick", "--budget", budget_s, report=REPORT)
            self.check_left_out(cost)
            if self.axes_of(cost) >= {"spp", "adaptive", "level"}:
                break
        self.assertEqual(cost["schema"], 1)
        self.assertTrue(cost["complete"])
        self.check_points(cost)
        self.check_table(cost)
        self.check_page(cost)
        self.check_claims(cost)
        self.assertIn(cost["recommendations"][0]["command"], result.stdout)
        self.assertFalse([name for name in self.files_below("report") if ".partial" in name or name.startswith(".")])

    def axes_of(self, cost):
        return {point["axis"] for point in cost["points"]}

    def check_left_out(self, cost):
        self.assertGreaterEqual(len(cost["points"]), 1)
        self.assertFalse({point["name"] for point in cost["points"]} & set(cost["left_out"]))
        if cost["left_out"]:
            page = (self.folder / "report/report.html").read_text(encoding="utf-8")
            self.assertIn("No time was left for: " + cost["left_out"][0], page)

    def files_below(self, folder):
        return [path.name for path in (self.folder / folder).rglob("*")]

    def check_points(self, cost):
        by_name = {point["name"]: point for point in cost["points"]}
        self.assertEqual(len(by_name), len(cost["points"]))
        self.assertLessEqual({"spp", "adaptive", "level"}, self.axes_of(cost))
        for point in cost["points"]:
            self.assertGreaterEqual(point["runs"], 2)
            self.assertGreater(point["device_ms"]["least"], 0.0)
            self.assertLessEqual(point["device_ms"]["least"], point["device_ms"]["median"])
            self.assertEqual(point["non_finite"], 0)
            self.assertTrue((self.folder / "report" / point["picture"]).is_file())
        # Each fourfold number of samples has an error that is clearly smaller: independent samples halve it.
        self.assertLess(by_name["16 spp"]["rel_error"]["mean"], 0.8 * by_name["4 spp"]["rel_error"]["mean"])
        # Samples at the pixel centre alone miss what lies between: the same picture for all seeds, so no noise at all.
        self.assertGreater(by_name["1 spp"]["bias_floor"], by_name["16 spp"]["rel_error"]["mean"])
        self.assertLess(cost["slope"], -0.3)
        front = [by_name[name]["rel_error"]["mean"] for name in cost["pareto"]]
        self.assertEqual(front, sorted(front, reverse=True), "more time on the front buys less error")

    def check_table(self, cost):
        with open(self.folder / "report/cost.csv", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["name"] for row in rows], [point["name"] for point in cost["points"]])
        for row, point in zip(rows, cost["points"]):
            self.assertNotIn(None, row)
            self.assertAlmostEqual(float(row["rel_error"]), point["rel_error"]["mean"], delta=1e-8)  # 9 digits

    def check_page(self, cost):
        page = (self.folder / "report/report.html").read_text(encoding="utf-8")
        self.assertNotIn("src=\"http", page)
        self.assertNotIn("@import", page)
        self.assertIn(cost["recommendations"][0]["command"].replace("'", "&#39;"), page)
        self.assertIn("prefers-color-scheme", page)

    def check_claims(self, cost):
        """Each recommended command, pasted, reaches its error on seeds that the sweep did not have."""
        self.check_done("render", SCENE, "-o", "truth.exr", *VIEW, "--spp", 1024, "--max-bounces", 16, "--cutoff",
                        "1/16384", "--accuracy", "exact", "--seed", 3000000000)
        missed = tried = 0
        for one in cost["recommendations"]:
            for seed in (500, 501):
                words = shlex.split(one["command"])
                self.assertEqual(words[0], "vernier")
                self.check_done(*words[1:], "--seed", seed)
                self.check_done("diff", "render.exr", "truth.exr", "--json", "diff.json")
                error = math.sqrt(json.loads((self.folder / "diff.json").read_text())["rel_mse"])
                missed += error > one["error"]
                tried += 1
        # What is recommended depends on measured times, so this is a draw each time: a claim misses 2.5 % of seeds, and
        # as many misses as are found here, or more, come by chance in at least one test of ten thousand. Claims of the
        # mean error, without their interval, would miss every second time.
        self.assertGreater(chance_of_at_least(missed, tried, 0.025), 1e-4, f"{missed} of {tried}")

    def test_an_image_may_be_the_truth(self):
        self.check_done("render", SCENE, "-o", "mine.exr", *VIEW, "--spp", 256, "--seed", 9)
        cost, result = self.cost("--quick", "--budget", 8, "--reference", "mine.exr")
        self.assertEqual(cost["reference"]["file"], "mine.exr")
        self.assertNotIn("spp", cost["reference"])
        self.assertIn("tools/report report", result.stderr)
        self.assertFalse((self.folder / "report/report.html").exists())

    def test_interrupt_writes_what_was_measured(self):
        self.check_done("render", SCENE, "-o", "truth.exr", *VIEW, "--spp", 64)
        process = subprocess.Popen([PROGRAM, "cost", SCENE, "-o", "report", *VIEW, "--budget", "80", "--reference",
                                    "truth.exr"], cwd=self.folder, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL,
                                   text=True, env={**os.environ, "VERNIER_PIPELINE_CACHE": "none",
                                                   "VERNIER_REPORT": REPORT})
        # A later round than the first is told once a setting has been rendered twice.
        while (line := process.stderr.readline()) and not re.match(r"round ([2-9]|1\d) ", line):
            pass
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=120)
        self.assertEqual(process.returncode, FAILED, errors)
        self.assertIn("error: report: interrupted; it holds what was measured", errors)
        cost = json.loads((self.folder / "report/cost.json").read_text())
        self.assertFalse(cost["complete"])
        self.assertIn("stopped before its end", (self.folder / "report/report.html").read_text(encoding="utf-8"))

    def test_what_makes_no_sense_is_refused_before_anything_is_written(self):
        for option, values in {"--budget": ["0", "x", "nan", "-5"], "--size": ["0x4", "x"], "--spp": ["0"],
                               "--effects": ["auto,-fog"], "--accuracy": ["best"], "--cutoff": ["2"]}.items():
            for value in values:
                with self.subTest(option=option, value=value):
                    self.check_error(USAGE, option, "cost", SCENE, "-o", "report", f"{option}={value}")
        self.check_error(USAGE, "--output", "cost", SCENE)
        self.check_error(REFUSED, "gone.exr", "cost", SCENE, "-o", "report", "--reference", "gone.exr")
        self.check_error(REFUSED, "gone.glb", "cost", "gone.glb", "-o", "report")
        self.write("taken", "")
        self.check_error(FAILED, "taken", "cost", SCENE, "-o", "taken")
        self.assertEqual(self.files(), ["taken"])

    def test_a_reference_of_another_size_is_refused(self):
        self.check_done("render", SCENE, "-o", "mine.exr", "--size", "20x20", "--spp", 1)
        self.check_error(USAGE, "--reference", "cost", SCENE, "-o", "report", *VIEW, "--reference", "mine.exr")

    def test_the_page_tells_what_it_cannot_read(self):
        for text, part in [("{", "cost.json"), ('{"schema": 99}', "schema 99")]:
            self.write("cost.json", text)
            result = subprocess.run([REPORT, str(self.folder)], capture_output=True, text=True, check=False, env=os.environ)
            self.assertEqual(result.returncode, REFUSED, result.stderr)
            self.assertIn(part, result.stderr)
            self.assertEqual(self.files(), ["cost.json"])


if __name__ == "__main__":
    unittest.main()
