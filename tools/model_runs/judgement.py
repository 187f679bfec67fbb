"""Holds what a render did against what the manifest expects."""

import dataclasses
import json
import pathlib

from model_runs.limited_run import Outcome
from model_runs.model_list import Model

REJECT_LIMIT_S = 5.0
SAFE_LIMIT_MIB = 1024.0


@dataclasses.dataclass(frozen=True)
class Verdict:
    """`result`: rendered, refused, crashed, timed out, too much memory or failed; `faults` empty: as expected."""

    result: str
    warnings: int
    non_finite: int | None
    faults: list[str]


def read_statistics(path: pathlib.Path) -> dict:
    """What `render --json` wrote, empty where it wrote nothing usable."""
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}


def judge(model: Model, outcome: Outcome, picture: pathlib.Path, statistics: dict) -> Verdict:
    """`picture` is where the image would be. A rejected model that is rendered is a fault, and the other way round."""
    result = {"exit 0": "rendered", "exit 3": "refused", "timed out": "timed out",
              "too much memory": "too much memory"}.get(outcome.ending)
    if result is None:
        result = "crashed" if outcome.ending.startswith("signal") else f"failed ({outcome.ending})"
    non_finite = statistics.get("non_finite_pixels")
    warnings = len(statistics.get("warnings", []))
    faults = []
    if result == "rendered":
        if not picture.is_file() or not picture.stat().st_size:
            faults.append("no image")
        if non_finite is None:
            faults.append("no statistics")
        elif non_finite:
            faults.append(f"{non_finite} non-finite pixels")
    if result == "refused":
        lines = outcome.stderr.strip().splitlines()
        if len(lines) != 1 or model.path.name not in lines[0]:
            faults.append("the message is not one line that names the file")
        if picture.exists():
            faults.append("refused, yet wrote an image")
        if outcome.seconds > REJECT_LIMIT_S:
            faults.append(f"refused after {outcome.seconds:.1f} s")
    if result not in allowed_results(model):
        faults.append(f"{result}, expected {model.expectation}")
    if result == "rendered" and wants_warning(model) and not warnings:
        faults.append("no warning")
    if model.expectation == "SAFE" and outcome.peak_mib > SAFE_LIMIT_MIB:
        faults.append(f"{outcome.peak_mib:.0f} MiB")
    return Verdict(result, warnings, non_finite, faults)


def allowed_results(model: Model) -> set[str]:
    """The results that the manifest's words allow."""
    words = f"{model.expectation} {model.note}"
    if model.expectation.startswith("RENDER"):
        return {"rendered"}
    if model.expectation == "SAFE" or "unless supported" in words or "acceptable" in words:
        return {"rendered", "refused"}
    return {"refused"}


def wants_warning(model: Model) -> bool:
    """Whether a picture without a warning hides something."""
    return "with warning" in model.expectation or "acceptable" in model.note
