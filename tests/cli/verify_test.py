"""vernier verify: the table, what a failure says, exit codes, the kill table."""

import json
import unittest

from program import DONE, USAGE, ProgramTest

FEW = ["--rays", "2048"]


class VerifyTest(ProgramTest):
    def test_a_case_that_holds(self):
        result = self.check_done("verify", "--case", "shared_edge", *FEW, "--json", "verify.json")
        self.assertIn("fma() is fused", result.stdout)
        line = next(line for line in result.stdout.splitlines() if "shared_edge" in line)
        self.assertIn("2048", line)
        self.assertTrue(line.endswith("held"), line)
        report = json.loads((self.folder / "verify.json").read_text())
        self.assertEqual((report["schema"], report["level"], report["held"]), (1, "robust", True))
        self.assertIn("fma_is_fused", report["device"]["probe"])
        case, = report["cases"]
        self.assertEqual((case["name"], case["samples"], case["failures"]), ("shared_edge", 2048, 0))
        self.assertAlmostEqual(case["rate_bound"], 3 / 2048)
        self.assertIn("0 of 2048 rays aimed at edges and corners got out, a rate below 0.0015", result.stdout)
        self.assertIn("Embree's own test: 10900 rays at random, a rate of 2e-05 allowed", result.stdout)
        self.assertEqual((report["watertight"]["rays"], report["watertight"]["leaks"]), (2048, 0))
        self.assertEqual(report["watertight"]["embree"], {"rays": 10900, "allowed_rate": 2e-5})

    def test_json_alone_on_standard_output(self):
        result = self.check_done("verify", "--case", "shared_edge", *FEW, "--json", "-", "--quiet")
        self.assertTrue(json.loads(result.stdout)["held"])
        self.assertEqual((self.files(), result.stderr), ([], ""))

    def test_numbers_are_whole_and_in_range(self):
        for option in ("--rays", "--seed", "--sample"):
            for value in ("-1", "4294967296", "1e6", "x"):
                self.check_error(USAGE, option, "verify", "--case", "shared_edge", f"{option}={value}")
        self.check_error(USAGE, "--rays", "verify", "--rays", "0")

    def test_the_level_by_the_name_that_render_has(self):
        self.check_done("verify", "--case", "shared_edge", *FEW, "--accuracy", "exact", "--json", "verify.json")
        self.assertEqual(json.loads((self.folder / "verify.json").read_text())["level"], "exact")

    def test_fast_holds_only_what_it_could_fail(self):
        for name, verdict in (("grazing_glass", "no target"), ("t_limits", "held")):
            result = self.check_done("verify", "--case", name, *FEW, "--level", "fast", "--json", "verify.json")
            line = next(line for line in result.stdout.splitlines() if name in line)
            self.assertTrue(line.endswith(verdict), line)
            case, = json.loads((self.folder / "verify.json").read_text())["cases"]
            self.assertEqual((case["failures"], case["held"], case["has_target"]), (0, True, verdict == "held"))
            self.assertEqual(case["rate_bound"] is not None, verdict == "held")

    def test_the_seed_decides_the_inputs(self):
        errors = []
        for seed in [1, 1, 2]:
            self.check_done("verify", "--case", "grazing", *FEW, "--seed", seed, "--json", "verify.json")
            errors.append(json.loads((self.folder / "verify.json").read_text())["cases"][0]["error"]["max"])
        self.assertEqual(errors[0], errors[1])
        self.assertNotEqual(errors[0], errors[2])

    def test_a_sample_runs_alone_up_to_its_number(self):
        result = self.check_done("verify", "--case", "shared_vertex", "--sample", "9")
        line = next(line for line in result.stdout.splitlines() if "shared_vertex" in line)
        self.assertEqual(line.split()[3], "10")

    def test_fast_promises_nothing(self):
        self.check_done("verify", "--case", "shared_edge", *FEW, "--level", "fast")

    def test_unknown_names_are_usage_errors_with_the_list(self):
        self.check_error(USAGE, "shared_vertex", "verify", "--case", "no_such_case")
        self.check_error(USAGE, "contracted_edge", "verify", "--mutate", "no_such_fault")
        self.check_error(USAGE, "robust", "verify", "--level", "best")
        self.check_error(USAGE, "--case", "verify", "--sample", "3")
        self.check_error(USAGE, "--rays", "verify", "--rays", "0")

    def test_a_seeded_fault_is_caught_by_a_case_that_names_its_inputs(self):
        result = self.run_program("verify", "--mutate", "moeller_trumbore", *FEW, "--json", "kills.json")
        self.assertEqual(result.returncode, DONE, result.stdout + result.stderr)
        self.assertIn("caught by", result.stdout)
        report = json.loads((self.folder / "kills.json").read_text())
        fault, = report["mutations"]
        self.assertTrue(fault["caught"])
        broken = next(case for case in fault["cases"] if not case["held"])
        self.assertIn("direction.x=", broken["worst_inputs"])
        self.assertGreater(broken["failures"], 0)


if __name__ == "__main__":
    unittest.main()
