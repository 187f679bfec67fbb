"""The counters of effect runs leave nothing in a pipeline that does not count. Arguments: spirv-opt, spirv-dis, modules."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SPIRV_OPT, SPIRV_DIS, *MODULES = sys.argv[1:]
COUNT_EFFECTS = 8  # SPECIALIZATION_COUNT_EFFECTS

# trace_jobs.glsl: a job is taken; unfinished, stuck, four kinds of rays and the dropped ones are reported.
PLAIN_ATOMICS = 8
# count_runs.glsl: a counter per bit of the word of effects, and one each for rays by depth.
COUNTING_ATOMICS = 32 + 2


def atomics(module, counts):
    """Atomic additions of `module` with the constant set, after what is dead has been removed."""
    with tempfile.TemporaryDirectory() as folder:
        optimized = Path(folder) / "optimized.spv"
        subprocess.run([SPIRV_OPT, f"--set-spec-const-default-value={COUNT_EFFECTS}:{'true' if counts else 'false'}",
                        "--freeze-spec-const", "-O", module, "-o", optimized], check=True)
        text = subprocess.run([SPIRV_DIS, optimized], check=True, capture_output=True, text=True).stdout
    return text.count("OpAtomicIAdd")


class CountersOff(unittest.TestCase):
    def test_no_instruction_is_left_of_counters_that_are_off(self):
        for module in MODULES:
            self.assertEqual(atomics(module, False), PLAIN_ATOMICS, module)
            self.assertEqual(atomics(module, True), PLAIN_ATOMICS + COUNTING_ATOMICS, "the count sees them when they are on")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
