"""Runs the program under test: VERNIER is its path, VERNIER_SOURCE_DIR the repository."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

PROGRAM = os.environ["VERNIER"]
SCENES = Path(os.environ["VERNIER_SOURCE_DIR"]) / "scenes"
SCENE = str(SCENES / "glass_ball.glb")
SMALL = ["--size", "24x16", "--spp", "1"]

DONE, FAILED, USAGE, REFUSED, NO_DEVICE = range(5)

TRIANGLE_OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"


class ProgramTest(unittest.TestCase):
    """Each test has an empty folder of its own, in which the program runs."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_program(self, *arguments, environment=None):
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True, errors="surrogateescape",
                              timeout=300, env={**os.environ, "VERNIER_PIPELINE_CACHE": "none", **(environment or {})})

    def check_error(self, code, part, *arguments, environment=None):
        """The program ends with `code` and says exactly one `error:` line that holds `part`."""
        result = self.run_program(*arguments, environment=environment)
        self.assertEqual(result.returncode, code, result.stderr)
        errors = [line for line in result.stderr.splitlines() if not line.startswith("warning: ")]
        self.assertEqual(len(errors), 1, result.stderr)
        self.assertTrue(errors[0].startswith("error: "), errors[0])
        self.assertIn(part, errors[0])
        self.assertEqual(result.stdout, "")
        return errors[0]

    def check_done(self, *arguments, environment=None):
        result = self.run_program(*arguments, environment=environment)
        self.assertEqual(result.returncode, DONE, result.stderr)
        return result

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return str(path)
