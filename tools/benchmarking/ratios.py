"""Medians and spreads of what the rounds measured, as text and as JSON."""

import dataclasses
import statistics

from benchmarking.measured_runs import EMBREE, MITSUBA, POVRAY, VERNIER

@dataclasses.dataclass(frozen=True)
class Peer:
    """What Vernier is held against: `unit` of the work that both count, and how many times as much of it is wanted."""

    name: str
    unit: str
    target: float

    def measures(self) -> dict:
        """Keys of the measures in benchmark.json, and what to call them."""
        return {f"{self.unit}_per_s": "by the clock", f"{self.unit}_per_cpu_s": "by CPU seconds"}


PEERS = (Peer(POVRAY, "rays", 4.0), Peer(EMBREE, "rays", 0.2), Peer(MITSUBA, "samples", 0.8))


def peers_of(names) -> list:
    """Those that took part."""
    return [peer for peer in PEERS if peer.name in names]


def median_and_spread(values: list) -> dict:
    return {"median": statistics.median(values), "least": min(values), "most": max(values)}


def rays_per_cpu_s(measurement) -> float:
    return sum(measurement.rays.values()) / measurement.cpu_s


def measures_of(measurement, samples: int) -> dict:
    """`samples` of the camera are in the picture."""
    return {"rays_per_s": measurement.rays_per_s, "rays_per_cpu_s": rays_per_cpu_s(measurement),
            "samples_per_s": samples / measurement.seconds, "samples_per_cpu_s": samples / measurement.cpu_s,
            "seconds": measurement.seconds}


def each_round(rounds: list, samples: int) -> list:
    """What every round measured, for comparisons with other runs."""
    return [{name: measures_of(one, samples) for name, one in turn.items()} for turn in rounds]


def compare(rounds: list) -> dict:
    """Ratios of Vernier to the others of each_round, each of runs of the same round: a machine that slows down slows them all."""
    ratios = {}
    for peer in peers_of(rounds[0]):
        ratios[peer.name] = {measure: median_and_spread([one[VERNIER][measure] / one[peer.name][measure] for one in rounds])
                             for measure in peer.measures()}
        ratios[peer.name]["target"] = peer.target
    ratios["same picture, POV-Ray's trace time over Vernier's"] = median_and_spread(
        [one[POVRAY]["seconds"] / one[VERNIER]["seconds"] for one in rounds])
    return ratios


def median_rates(rounds: list) -> dict:
    rates = {name: {"rays": one.rays, "rays_per_s": median_and_spread([turn[name].rays_per_s for turn in rounds]),
                    "rays_per_cpu_s": median_and_spread([rays_per_cpu_s(turn[name]) for turn in rounds])}
             for name, one in rounds[0].items()}
    for kind in ("primary_per_s", "shadow_per_s"):
        rates[EMBREE][kind] = median_and_spread([turn[EMBREE].statistics[kind] for turn in rounds])
    statistics_of_vernier = [turn[VERNIER].statistics for turn in rounds]
    for name in ("compile_ms", "first_dispatch_ms", "trace_device_ms", "trace_wall_ms"):
        rates[VERNIER][name] = median_and_spread([one[name] for one in statistics_of_vernier])
    return rates


def range_text(values: dict, scale: float = 1.0, digits: int = 3) -> str:
    return (f"{values['median'] * scale:.{digits}f} ({values['least'] * scale:.{digits}f} to "
            f"{values['most'] * scale:.{digits}f})")


def summary(rates: dict, ratios: dict) -> str:
    lines = [f"{name:8s} {range_text(one['rays_per_s'], 1e-6)} Mray/s, "
             f"{range_text(one['rays_per_cpu_s'], 1e-6)} per CPU second; rays {one['rays']}"
             for name, one in rates.items()]
    for peer in peers_of(ratios):
        by_clock, by_cpu = (ratios[peer.name][measure] for measure in peer.measures())
        verdict = "reached" if by_clock["median"] >= peer.target else "missed"
        lines.append(f"Vernier / {peer.name}, {peer.unit}: {range_text(by_clock)}, by CPU seconds {range_text(by_cpu)}; "
                     f"target {peer.target:g} {verdict}")
    name = "same picture, POV-Ray's trace time over Vernier's"
    return "\n".join(lines + [f"{name}: {range_text(ratios[name])}"])
