"""Ctrl-C writes what is done and ends; progress lines go to stderr."""

import signal
import subprocess
import time
import unittest

from program import FAILED, PROGRAM, SCENE, ProgramTest

ENDLESS = ["render", SCENE, "-o", "out.png", "--size", "32x32", "--spp", "16000000"]


class InterruptTest(ProgramTest):
    def start(self):
        return subprocess.Popen([PROGRAM, *ENDLESS], cwd=self.folder, stderr=subprocess.PIPE, text=True)

    def wait_for_progress(self, process):
        """Reads stderr up to the first progress line: the render is under way then."""
        deadline = time.monotonic() + 120
        while time.monotonic() < deadline:
            line = process.stderr.readline()
            if " %" in line:
                return
        self.fail("no progress line")

    def test_first_interrupt_writes_the_image(self):
        process = self.start()
        self.wait_for_progress(process)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=120)
        self.assertEqual(process.returncode, FAILED, errors)
        self.assertIn("error: out.png: interrupted", errors)
        self.assertEqual(self.files(), ["out.png"])
        self.assertTrue((self.folder / "out.png").read_bytes().startswith(b"\x89PNG"))


if __name__ == "__main__":
    unittest.main()
