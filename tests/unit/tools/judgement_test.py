"""What counts as expected of a model."""

import pathlib
import tempfile
import unittest

import tool_path  # noqa: F401
from model_runs.judgement import judge
from model_runs.limited_run import Outcome
from model_runs.model_list import Model, list_models

FINE = {"non_finite_pixels": 0, "warnings": []}
REFUSED = "a.glb: chunk 1: it ends too early\n"


class Judgement(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.folder = pathlib.Path(self.scratch.name)

    def faults(self, expectation, ending, statistics=FINE, image=True, stderr="", note="", seconds=1.0, peak=100.0):
        picture = self.folder / "picture.png"
        picture.unlink(missing_ok=True)
        if image:
            picture.write_bytes(b"x")
        model = Model("a.glb", pathlib.Path("a.glb"), expectation, note)
        return len(judge(model, Outcome(ending, seconds, peak, "", stderr), picture, statistics).faults)

    def test_render(self):
        self.assertEqual(self.faults("RENDER", "exit 0"), 0)
        self.assertEqual(self.faults("RENDER", "exit 0", image=False), 1)
        self.assertEqual(self.faults("RENDER", "exit 0", {"non_finite_pixels": 2, "warnings": []}), 1)
        self.assertEqual(self.faults("RENDER", "exit 0", {}), 1)
        for ending in ("exit 1", "signal 11", "timed out", "too much memory"):
            self.assertEqual(self.faults("RENDER", ending), 1, ending)
        self.assertEqual(self.faults("RENDER", "exit 3", image=False, stderr=REFUSED), 1)

    def test_render_with_warning(self):
        self.assertEqual(self.faults("RENDER with warning", "exit 0"), 1)
        self.assertEqual(self.faults("RENDER with warning", "exit 0", {"non_finite_pixels": 0, "warnings": ["w"]}), 0)

    def test_reject(self):
        self.assertEqual(self.faults("REJECT", "exit 3", image=False, stderr=REFUSED), 0)
        self.assertEqual(self.faults("REJECT", "exit 3", image=False, stderr="broken\n"), 1)
        self.assertEqual(self.faults("REJECT", "exit 3", image=False, stderr=REFUSED * 2), 1)
        self.assertEqual(self.faults("REJECT", "exit 3", image=True, stderr=REFUSED), 1)
        self.assertEqual(self.faults("REJECT", "exit 3", image=False, stderr=REFUSED, seconds=9.0), 1)
        self.assertEqual(self.faults("REJECT", "exit 0"), 1)
        self.assertEqual(self.faults("REJECT unless supported", "exit 0"), 0)
        self.assertEqual(self.faults("REJECT", "exit 0", {"non_finite_pixels": 0, "warnings": ["w"]},
                                     note="dropping with a warning is acceptable"), 0)

    def test_safe(self):
        self.assertEqual(self.faults("SAFE", "exit 0"), 0)
        self.assertEqual(self.faults("SAFE", "exit 3", image=False, stderr=REFUSED), 0)
        self.assertEqual(self.faults("SAFE", "exit 0", peak=2000.0), 1)
        self.assertEqual(self.faults("SAFE", "signal 6", image=False), 1)

    def test_lists(self):
        (self.folder / "sub").mkdir()
        for name in ("b.OBJ", "sub/a.glb", "c.png"):
            (self.folder / name).write_bytes(b"")
        self.assertEqual([model.name for model in list_models(self.folder)], ["b.OBJ", "sub/a.glb"])
        (self.folder / "MANIFEST.tsv").write_text(
            "path\texpectation\tnote\taov\nb.OBJ\tREJECT\tsaid \"so\"\tnone\nx.hdr\tx\t\t\nsub/a.glb\tRENDER\t\tr/a.npz\n",
            encoding="utf-8")
        found = list_models(self.folder)
        self.assertEqual([(model.name, model.expectation, model.note) for model in found],
                         [("b.OBJ", "REJECT", 'said "so"'), ("sub/a.glb", "RENDER", "")])
        self.assertEqual([model.geometry for model in found], [None, self.folder / "r/a.npz"])


if __name__ == "__main__":
    unittest.main()
