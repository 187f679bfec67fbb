"""Ctrl-C writes what is done and ends, in render and in reference; progress lines go to stderr."""

import json
import signal
import subprocess
import time
import unittest

from program import FAILED, PROGRAM, SCENE, ProgramTest

ENDLESS = ["render", SCENE, "-o", "out.png", "--size", "32x32", "--spp", "1000000"]
# Rows are what the reference counts: many short ones.
ENDLESS_REFERENCE = ["reference", SCENE, "-o", "out.exr", "--size", "32x8192", "--spp", "4096"]


class InterruptTest(ProgramTest):
    def start(self, arguments):
        return subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, stderr=subprocess.PIPE, text=True)

    def wait_for_progress(self, process):
        """Reads stderr up to the first progress line: the render is under way then."""
        deadline = time.monotonic() + 120
        while time.monotonic() < deadline:
            line = process.stderr.readline()
            if " %" in line:
                return
        self.fail("no progress line")

    def check_interrupt(self, arguments, name, magic, sent=signal.SIGINT):
        process = self.start(arguments)
        self.wait_for_progress(process)
        process.send_signal(sent)
        _, errors = process.communicate(timeout=120)
        self.assertEqual(process.returncode, FAILED, errors)
        self.assertIn(f"error: {name}: interrupted", errors)
        self.assertEqual(self.files(), [name])
        self.assertTrue((self.folder / name).read_bytes().startswith(magic))

    def test_first_interrupt_writes_the_image(self):
        self.check_interrupt(ENDLESS, "out.png", b"\x89PNG")

    def test_being_asked_to_end_is_an_interrupt(self):
        self.check_interrupt(ENDLESS, "out.png", b"\x89PNG", signal.SIGTERM)

    def test_a_case_of_verify_ends_early(self):
        process = subprocess.Popen(
            [PROGRAM, "verify", "--case", "shared_edge", "--rays", "1000000000", "--quiet", "--json", "v.json"],
            cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        while "failures" not in process.stdout.readline():
            self.assertIsNone(process.poll())
        time.sleep(1.0)  # the case is under way
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, FAILED, errors)
        self.assertLess(json.loads((self.folder / "v.json").read_text())["cases"][0]["samples"], 1000000000)

    def test_the_reference_is_interrupted_alike(self):
        self.check_interrupt(ENDLESS_REFERENCE, "out.exr", b"v/1\x01")
        self.check_done("render", SCENE, "-o", "whole.exr", "--size", "32x8192", "--spp", "1", "--quiet")
        result = self.check_done("diff", "whole.exr", "out.exr")
        self.assertRegex(result.stderr, r"^warning: out.exr: its render was stopped before its end, at \d+ %\n$")

    def test_the_reference_of_costs_is_interrupted(self):
        process = self.start(["cost", SCENE, "-o", "report", "--size", "1024x1024", "--budget", "600"])
        time.sleep(4.0)  # within its first part
        start = time.monotonic()
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=120)
        self.assertEqual(process.returncode, FAILED, errors)
        self.assertIn("error: interrupted before the reference", errors)
        self.assertLess(time.monotonic() - start, 20.0)

    def test_calibrating_is_interrupted(self):
        process = self.start(["devices", "--calibrate", "--json", "devices.json"])
        self.wait_for_progress(process)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=120)
        self.assertEqual(process.returncode, FAILED, errors)
        self.assertIsNone(json.loads((self.folder / "devices.json").read_text())["calibration"])

    def test_verify_tells_what_it_has_done(self):
        process = subprocess.Popen([PROGRAM, "verify", "--json", "verify.json"], cwd=self.folder, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        while "held" not in process.stdout.readline():
            self.assertIsNone(process.poll())
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=120)
        self.assertEqual(process.returncode, FAILED, errors)
        self.assertEqual(errors, "error: interrupted; what was done by then is told\n")
        self.assertGreaterEqual(len(json.loads((self.folder / "verify.json").read_text())["cases"]), 1)


if __name__ == "__main__":
    unittest.main()
