"""Programs that end, fail, hang and grow."""

import sys
import unittest

import tool_path  # noqa: F401
from model_runs.limited_run import run_limited


def run(text, limit_s=20.0, limit_mib=1024.0):
    return run_limited([sys.executable, "-c", text], limit_s, limit_mib)


class LimitedRun(unittest.TestCase):
    def test_output_and_exit_code(self):
        outcome = run("import sys; print('out'); print('err', file=sys.stderr); sys.exit(3)")
        self.assertEqual((outcome.ending, outcome.stdout, outcome.stderr), ("exit 3", "out\n", "err\n"))

    def test_a_crash(self):
        self.assertEqual(run("import os, signal; os.kill(os.getpid(), signal.SIGSEGV)").ending, "signal 11")

    def test_a_hang_is_ended(self):
        outcome = run("import time; time.sleep(60)", limit_s=0.5)
        self.assertEqual(outcome.ending, "timed out")
        self.assertLess(outcome.seconds, 20)

    def test_too_much_memory_is_ended(self):
        outcome = run("import time; block = bytearray(200 << 20); time.sleep(60)", limit_mib=100)
        self.assertEqual(outcome.ending, "too much memory")

    def test_peak_memory_is_that_of_the_program(self):
        self.assertGreater(run("block = bytearray(b'x') * (64 << 20)").peak_mib, 64)


if __name__ == "__main__":
    unittest.main()
