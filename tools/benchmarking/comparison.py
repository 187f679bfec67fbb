"""Two benchmark.json of different builds: did the ratios to the peers change by more than the rounds' own spread?"""

import json
import math
import pathlib
import re
import statistics

from benchmarking.measured_runs import EMBREE, POVRAY, VERNIER

SCHEMA = 2
# What has to be the same: ratios to a peer hang on the device, the scene and the picture.
SAME = ("device", "driver", "cpu", "threads", "triangles", "size", "spp", "max_bounces")
SIGNIFICANT = 0.05  # two builds that are equal are told apart in one of 20 comparisons


class NotComparable(Exception):
    """One line: what keeps the files from being compared."""


def read_results(path: pathlib.Path) -> dict:
    try:
        results = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as fault:
        raise NotComparable(f"{path}: {fault}") from fault
    if not isinstance(results, dict) or results.get("schema") != SCHEMA:
        raise NotComparable(f"{path}: is no benchmark.json of schema {SCHEMA}")
    # Builds before told llvmpipe's width in its name; which one they take is theirs to choose.
    results["device"] = re.sub(r", \d+ bits\)$", ")", str(results.get("device")))
    return results


def log_ratios(results: dict, peers: tuple) -> list:
    """Of each round: the mean over `peers` of the logarithm of Vernier's rate over theirs."""
    return [statistics.mean(math.log(one[VERNIER]["rays_per_s"] / one[peer]["rays_per_s"]) for peer in peers)
            for one in results["each_round"]]


def chance_of_equal(old: list, new: list) -> float:
    """Two-sided chance that two samples of one distribution differ in rank as much as these (Mann and Whitney 1947, "On a Test of
    Whether one of Two Random Variables is Stochastically Larger than the Other"), exact but for ties, which count half."""
    wins = sum(1.0 if b > a else 0.5 if b == a else 0.0 for a in old for b in new)
    farthest = max(wins, len(old) * len(new) - wins)
    ways = ways_to_win(len(old), len(new))
    at_least = sum(count for won, count in enumerate(ways) if won >= farthest)
    return min(1.0, 2.0 * at_least / sum(ways))


def ways_to_win(m: int, n: int) -> list:
    """[w]: orders of m and n values in which values of the second win w of the m n comparisons."""
    # By the largest value: one of the second has won against all m, one of the first against none.
    table = {(i, j): [] for i in range(m + 1) for j in range(n + 1)}
    for i in range(m + 1):
        for j in range(n + 1):
            if i == 0 or j == 0:
                table[i, j] = [1]
                continue
            counts = [0] * (i * j + 1)
            for won, count in enumerate(table[i, j - 1]):
                counts[won + i] += count
            for won, count in enumerate(table[i - 1, j]):
                counts[won] += count
            table[i, j] = counts
    return table[m, n]


def shift(old: list, new: list) -> float:
    """How many times as fast: the median over all pairs (Hodges and Lehmann 1963), of logarithms."""
    return math.exp(statistics.median(b - a for a in old for b in new))


def compare(old_path: pathlib.Path, new_path: pathlib.Path) -> str:
    """What the files say of each other, as lines."""
    old, new = read_results(old_path), read_results(new_path)
    for name in SAME:
        if old.get(name) != new.get(name):
            raise NotComparable(f"{old_path} and {new_path} differ in {name}: {old.get(name)} and {new.get(name)}")
    lines = []
    for peers in ((POVRAY,), (EMBREE,), (POVRAY, EMBREE)):
        before, after = log_ratios(old, peers), log_ratios(new, peers)
        chance = chance_of_equal(before, after)
        lines.append(f"by {' and '.join(peers)}: {shift(before, after):.3f} times as fast, "
                     f"{len(before)} and {len(after)} rounds, p {chance:.3f}")
    if chance >= SIGNIFICANT:
        verdict = "not told apart: more --rounds, or tools/compare_builds, which runs both builds at the same time, may do it"
    else:
        verdict = "the new build is " + ("faster" if shift(before, after) > 1.0 else "slower")
    return "\n".join([*lines, verdict])
