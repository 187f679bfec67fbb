"""Where and of what a measurement was made."""

import pathlib
import platform
import subprocess

TOOLS = pathlib.Path(__file__).resolve().parents[1]


def output_of(*command: str) -> str:
    return subprocess.run(command, cwd=TOOLS, capture_output=True, text=True, check=False).stdout.strip()


def cpu_name() -> str:
    cpuinfo = pathlib.Path("/proc/cpuinfo")
    lines = cpuinfo.read_text().splitlines() if cpuinfo.is_file() else []
    return next((line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")), platform.processor())


def provenance() -> dict:
    """For the top of a JSON file."""
    return {"commit": output_of("git", "rev-parse", "HEAD"), "changed_files": bool(output_of("git", "status", "--short")),
            "cpu": cpu_name()}
