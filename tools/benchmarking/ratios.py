"""Medians and spreads of what the rounds measured, as text and as JSON."""

import statistics

from benchmarking.measured_runs import EMBREE, POVRAY, VERNIER

TARGETS = {POVRAY: 4.0, EMBREE: 0.2}


def median_and_spread(values: list) -> dict:
    return {"median": statistics.median(values), "least": min(values), "most": max(values)}


def rays_per_cpu_s(measurement) -> float:
    return sum(measurement.rays.values()) / measurement.cpu_s


def each_round(rounds: list) -> list:
    """What every round measured, for comparisons with other runs."""
    return [{name: {"rays_per_s": one.rays_per_s, "rays_per_cpu_s": rays_per_cpu_s(one), "seconds": one.seconds}
             for name, one in turn.items()} for turn in rounds]


def compare(rounds: list) -> dict:
    """Ratios of Vernier to the others, each of runs of the same round: a machine that slows down slows them all."""
    ratios = {}
    for other, target in TARGETS.items():
        by_clock = [one[VERNIER].rays_per_s / one[other].rays_per_s for one in rounds]
        by_cpu = [rays_per_cpu_s(one[VERNIER]) / rays_per_cpu_s(one[other]) for one in rounds]
        ratios[other] = {"rays_per_s": median_and_spread(by_clock), "rays_per_cpu_s": median_and_spread(by_cpu),
                         "target": target}
    ratios["same picture, POV-Ray's trace time over Vernier's"] = median_and_spread(
        [one[POVRAY].seconds / one[VERNIER].seconds for one in rounds])
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
    for other, target in TARGETS.items():
        one = ratios[other]
        verdict = "reached" if one["rays_per_s"]["median"] >= target else "missed"
        lines.append(f"Vernier / {other}: {range_text(one['rays_per_s'])}, by CPU seconds "
                     f"{range_text(one['rays_per_cpu_s'])}; target {target:g} {verdict}")
    name = "same picture, POV-Ray's trace time over Vernier's"
    return "\n".join(lines + [f"{name}: {range_text(ratios[name])}"])
