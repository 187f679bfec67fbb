"""What ray_rates measured, as ratios of Vernier's traversal to the others', and as text."""

import math

from benchmarking.ratios import median_and_spread, range_text

VERNIER, EMBREE, MEDIUM, QUERY = "Vernier", "Embree", "Embree medium", "ray query"
PEERS = (EMBREE, MEDIUM, QUERY)
KINDS = ("primary", "mirror", "diffuse", "shadow")
MEASURES = {"seconds": "by the clock", "cpu_s": "by CPU seconds"}
ALL_KINDS = "all kinds"  # the geometric mean

# What is wanted of Embree's single rays, and of the driver's ray query.
OF_EMBREE = {"primary": 0.50, "mirror": 0.42, "diffuse": 0.36, "shadow": 0.42}
OF_EMBREE_ON_SLIVERS = {"primary": 0.40}
OF_QUERY = {ALL_KINDS: 3.0}


def targets(scene: str, peer: str) -> dict:
    """By kind; empty where nothing is wanted."""
    if peer == QUERY:
        return OF_QUERY
    if peer != EMBREE:
        return {}
    return OF_EMBREE_ON_SLIVERS if scene == "slivers" else OF_EMBREE


def round_ratios(turn: dict, peer: str, measure: str) -> dict:
    """Of one round and each kind: times as many rays as the peer, which traced the same rays beside."""
    ratios = {kind: turn[peer][kind][measure] / turn[VERNIER][kind][measure] for kind in KINDS}
    ratios[ALL_KINDS] = math.exp(sum(map(math.log, ratios.values())) / len(KINDS))
    return ratios


def compare(rounds: list) -> dict:
    """Peer, measure, kind: median and spread over the rounds."""
    found = {}
    for peer in (peer for peer in PEERS if peer in rounds[0]):
        found[peer] = {}
        for measure in MEASURES:
            each = [round_ratios(turn, peer, measure) for turn in rounds]
            found[peer][measure] = {kind: median_and_spread([one[kind] for one in each]) for kind in each[0]}
    return found


def rates(measured: dict) -> dict:
    """Tracer and kind: million rays a second, median and spread."""
    rays = measured["rays"] * measured["passes"]
    return {tracer: {kind: median_and_spread([1e-6 * rays / turn[tracer][kind]["seconds"] for turn in measured["rounds"]])
                     for kind in KINDS} for tracer in measured["rounds"][0]}


def missed(scene: str, peer: str, ratios: dict) -> list:
    """The kinds whose median is below what is wanted."""
    return [kind for kind, wanted in targets(scene, peer).items() if ratios[kind]["median"] < wanted]


def verdict(scene: str, peer: str, ratios: dict) -> str:
    wanted = targets(scene, peer)
    if not wanted:
        return ""
    short = missed(scene, peer, ratios)
    text = ", ".join(f"{kind} {value:g}" for kind, value in wanted.items())
    return f"; wanted: {text}: " + (f"missed: {', '.join(short)}" if short else "reached")


def summary(runs: list) -> str:
    """`runs` as tools/ray_rates has them in its JSON."""
    lines = []
    for run in runs:
        measured = run["measured"]
        tree = measured["tree"]
        lines.append(f"{run['scene']}: {tree['triangles']} triangles, {measured['driver']}")
        for tracer, kinds in run["rates"].items():
            lines.append(f"  {tracer}, Mray/s: " + ", ".join(f"{kind} {range_text(kinds[kind], digits=2)}" for kind in KINDS))
        lines.append("  records per ray (rounds per subgroup), part that hits: " + ", ".join(
            f"{kind} {one['records_per_ray']:.1f} ({one['rounds_per_subgroup']:.1f}), {measured['hits'][kind]:.2f}"
            for kind, one in ((kind, measured["records"][kind]) for kind in KINDS)))
        for peer, measures in run["ratios"].items():
            for measure, label in MEASURES.items():
                text = ", ".join(f"{kind} {range_text(one)}" for kind, one in measures[measure].items())
                lines.append(f"  Vernier / {peer}, {label}: {text}" + (verdict(run["scene"], peer, measures[measure])
                                                                       if measure == "seconds" else ""))
        lines.append("  answers unlike Embree's: " + "; ".join(
            f"{tracer}: " + ", ".join(f"{kind} {kinds[kind]}" for kind in KINDS) for tracer, kinds in measured["differing"].items()))
    return "\n".join(lines)
