"""Runs a program with an end to its time and memory, and says how it went."""

import dataclasses
import os
import pathlib
import signal
import subprocess
import tempfile
import time

POLL_S = 0.02


@dataclasses.dataclass(frozen=True)
class Outcome:
    """`ending`: "exit N", "signal N", "timed out" or "too much memory"."""

    ending: str
    seconds: float
    peak_mib: float
    stdout: str
    stderr: str


def resident_mib(process_id: int) -> float:
    """Memory the process holds now, 0 where it cannot be told."""
    try:
        pages = int(pathlib.Path(f"/proc/{process_id}/statm").read_text(encoding="ascii").split()[1])
    except (OSError, IndexError, ValueError):
        return 0.0
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20


def run_limited(command: list[str], limit_s: float, limit_mib: float) -> Outcome:
    """Runs `command` to its end or kills it, with all it started, at the first limit it passes.

    Memory is watched as resident size: software Vulkan drivers reserve far more addresses than they use.
    """
    started = time.monotonic()
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as errors:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=errors, start_new_session=True)
        reason = None
        while True:
            ended, status, usage = os.wait4(process.pid, os.WNOHANG)
            if ended:
                break
            if reason is None:
                if time.monotonic() - started > limit_s:
                    reason = "timed out"
                elif resident_mib(process.pid) > limit_mib:
                    reason = "too much memory"
                if reason:
                    os.killpg(process.pid, signal.SIGKILL)
            time.sleep(POLL_S)
        process.returncode = os.waitstatus_to_exitcode(status)
        texts = []
        for file in (out, errors):
            file.seek(0)
            texts.append(file.read().decode("utf-8", errors="replace"))
    code = process.returncode
    ending = reason or (f"exit {code}" if code >= 0 else f"signal {-code}")
    return Outcome(ending, time.monotonic() - started, usage.ru_maxrss / 1024, *texts)
