"""Renders and compares with the real program in a folder of its own."""

import json
import math
import pathlib
import subprocess

TRUTH = ["--max-bounces", "16", "--cutoff", "1/16384", "--accuracy", "exact"]
# Seeds of truths, far from those that are checked, which count up from 0 or 1000.
TRUTH_SEEDS = (3000000000, 3000000001)


class ProgramFailed(Exception):
    """The program ended with another exit code than 0; the text is its last line."""


class Bench:
    """Where `program` works: `folder` holds what it writes."""

    def __init__(self, program: str, folder: pathlib.Path):
        self.program = program
        self.folder = folder

    def run(self, *words) -> None:
        result = subprocess.run([self.program, *map(str, words)], cwd=self.folder, capture_output=True, text=True, check=False)
        if result.returncode != 0:
            raise ProgramFailed((result.stderr.strip().splitlines() or ["no word"])[-1])

    def render(self, *words) -> dict:
        """Renders with `words` behind `render` and returns its statistics."""
        self.run("render", *words, "--quiet", "--json", "statistics.json")
        return json.loads((self.folder / "statistics.json").read_text(encoding="utf-8"))

    def error(self, a: str, b: str) -> float:
        """sqrt(relMSE) of the picture `a` against `b`."""
        self.run("diff", a, b, "--json", "difference.json")
        return math.sqrt(json.loads((self.folder / "difference.json").read_text(encoding="utf-8"))["rel_mse"])

    def render_truth(self, scene: pathlib.Path, size: str, spp: int) -> float:
        """Writes truth.exr, exact and deep, and returns its own error, as one of another seed tells."""
        for name, seed in zip(("truth.exr", "other.exr"), TRUTH_SEEDS):
            self.render(scene, "-o", name, "--size", size, "--spp", spp, "--seed", seed, *TRUTH)
        return self.error("other.exr", "truth.exr") / math.sqrt(2.0)
