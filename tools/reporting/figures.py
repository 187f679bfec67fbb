"""Plain words and numbers for the report: pure functions over cost.json."""

import math


def base_point(cost: dict) -> dict | None:
    """The point with the settings around which one is changed at a time; None if it was not measured."""
    name = f"{cost['settings']['spp']} spp"
    return next((point for point in cost["points"] if point["name"] == name), None)


def time_text(ms: float) -> str:
    if ms < 1.0:
        return f"{ms:.2g} ms"
    return f"{ms:.3g} ms" if ms < 1000.0 else f"{ms / 1000.0:.3g} s"


def error_text(error: float | None) -> str:
    return "–" if error is None else f"{error:.2g}" if error < 0.1 else f"{error:.3g}"


def interval_text(interval: dict) -> str:
    """The mean with half the width of its interval."""
    if interval["mean"] is None:
        return "–"
    half = None if interval["high"] is None else (interval["high"] - interval["low"]) / 2.0
    if half is None:
        return error_text(interval["mean"])
    if half < 1e-9 * abs(interval["mean"]):  # seeds that change nothing, but for the rounding of their mean
        return error_text(interval["mean"]) + " ± 0"
    # Both to the interval's first digit.
    digits = max(-math.floor(math.log10(half)), 0)
    return f"{interval['mean']:.{digits}f} ± {half:.1g}"


def usable(cost: dict) -> list[dict]:
    """Points that options of render name, with a time and a claimed error."""
    return [point for point in cost["points"] if point["command"] and point["claimed_error"] is not None]


def cheapest_within(cost: dict, error: float) -> dict | None:
    within = [point for point in usable(cost) if point["claimed_error"] <= error]
    return min(within, key=lambda point: point["device_ms"]["median"], default=None)


def recommendation(cost: dict) -> dict | None:
    """The cheapest settings that are at least as accurate as the settings the sweep is about, and how they compare.

    As accurate by the claim and by the mean: a truncated setting whose error is its bias has little spread, and its claim may
    lie below that of settings which are better with nearly every seed."""
    base = base_point(cost)
    if base is None:
        return None
    as_accurate = [point for point in usable(cost)
                   if point["claimed_error"] <= base["claimed_error"] and error_of(point) <= error_of(base)]
    best = min(as_accurate, key=time_of, default=base)
    half = cheapest_within(cost, base["claimed_error"] / 2.0)
    return {"base": base, "best": best, "half": half,
            "share": best["device_ms"]["median"] / base["device_ms"]["median"],
            "half_times": half and half["device_ms"]["median"] / best["device_ms"]["median"]}


def nearest(points: list[dict], value: float, of) -> dict | None:
    """The point whose positive `of` is nearest to `value` as a ratio."""
    return min(points, key=lambda point: abs(math.log(of(point) / value)), default=None)


def time_of(point: dict) -> float:
    return point["device_ms"]["median"]


def error_of(point: dict) -> float:
    return point["rel_error"]["mean"]


def pairs(cost: dict) -> list[dict]:
    """Each telling setting beside plain sampling, at equal time and at equal error."""
    plain = [point for point in cost["points"] if point["axis"] == "spp" and error_of(point) and time_of(point)]
    chosen = []
    for axis in ("adaptive", "level", "bounces", "cutoff", "filter"):
        of_axis = [point for point in cost["points"] if point["axis"] == axis and error_of(point)]
        if not of_axis or not plain:
            continue
        point = max(of_axis, key=time_of) if axis == "adaptive" else of_axis[0]
        chosen.append({"point": point, "equal_time": nearest(plain, time_of(point), time_of),
                       "equal_error": nearest(plain, error_of(point), error_of)})
    return chosen


def at_error(plain: list[dict], error: float, of) -> float | None:
    """`of` of uniform sampling at `error`, on the line between the neighbours in log-log; None outside what was
    measured."""
    for low, high in zip(plain, plain[1:]):
        if error_of(low) >= error >= error_of(high):
            share = math.log(error_of(low) / error) / math.log(error_of(low) / error_of(high))
            return math.exp((1.0 - share) * math.log(of(low)) + share * math.log(of(high)))
    return None


def adaptive_rows(cost: dict) -> list[dict]:
    """Rays and time that uniform sampling takes at the error each adaptive point reached."""
    plain = [point for point in cost["points"] if point["axis"] == "spp" and point["name"] != "1 spp"]
    rows = []
    for point in cost["points"]:
        if point["axis"] != "adaptive":
            continue
        rays = at_error(plain, error_of(point), lambda one: one["rays"])
        ms = at_error(plain, error_of(point), time_of)
        rows.append({"point": point, "rays_gain": rays and rays / point["rays"], "time_gain": ms and ms / time_of(point)})
    return rows


def against_base(cost: dict, axis: str) -> list[dict]:
    """Time and error of the points of `axis` to those of the base."""
    base = base_point(cost)
    if base is None:
        return []
    return [{"point": point, "time": time_of(point) / time_of(base), "rays": point["rays"] / base["rays"],
             "error": error_of(point) / error_of(base) if error_of(base) else None}
            for point in cost["points"] if point["axis"] == axis]
