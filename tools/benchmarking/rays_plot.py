"""Vernier's traversal over Embree's single rays and over the driver's ray query: a dot a round, a row a scene."""

from matplotlib import pyplot

from benchmarking import ray_table
from reporting import drawing

COLORS = {ray_table.EMBREE: "#1f86d0", ray_table.QUERY: "#d55e00"}
TITLES = {ray_table.EMBREE: "times the searches of Embree", ray_table.QUERY: "times those of the driver's ray query"}


def run_beside(runs: list, scene: str, peer: str):
    """The first run of `scene` in which `peer` took part; the system's own driver ran first."""
    return next((run for run in runs if run["scene"] == scene and peer in run["ratios"]), None)


def draw_kinds(axes, run: dict, peer: str) -> None:
    """A dot for each round, a line at the median, a dashed one at what is wanted of a kind."""
    wanted = ray_table.targets(run["scene"], peer)
    each = [ray_table.round_ratios(turn, peer, "seconds") for turn in run["measured"]["rounds"]]
    for height, kind in enumerate(each[0]):
        values = [one[kind] for one in each]
        axes.plot(values, [height] * len(values), "o", color=COLORS[peer], markersize=5, alpha=0.55, markeredgewidth=0)
        axes.plot([run["ratios"][peer]["seconds"][kind]["median"]] * 2, [height - 0.28, height + 0.28], color=COLORS[peer], linewidth=2)
        if kind in wanted:
            axes.plot([wanted[kind]] * 2, [height - 0.42, height + 0.42], color=drawing.INK, linestyle=(0, (2, 1)), linewidth=1.2)
    axes.set_yticks(range(len(each[0])), list(each[0]))
    axes.set_ylim(len(each[0]) - 0.4, -0.6)


def draw_ratios(runs: list):
    drawing.set_style()
    scenes = list(dict.fromkeys(run["scene"] for run in runs))
    peers = [peer for peer in TITLES if any(peer in run["ratios"] for run in runs)]
    figure, grid = pyplot.subplots(len(scenes), len(peers), figsize=(3.8 * len(peers), 1.65 * len(scenes)), layout="constrained",
                                   squeeze=False, sharex="col")
    for row, scene in zip(grid, scenes):
        for axes, peer in zip(row, peers):
            run = run_beside(runs, scene, peer)
            if run is None:
                axes.set_axis_off()
                continue
            axes.set_title(f"{scene}, {TITLES[peer]}", loc="left", fontsize=9, color=drawing.INK)
            axes.grid(True, axis="x", color=drawing.INK, alpha=0.14, linewidth=0.6)
            for side in ("top", "right", "left"):
                axes.spines[side].set_visible(False)
            axes.tick_params(axis="y", length=0)
            axes.tick_params(axis="x", labelbottom=True)
            draw_kinds(axes, run, peer)
    # Last: a limit that is set ends the widening of the axis that a column shares.
    for axes in grid[0]:
        axes.set_xlim(left=0.0)
    return figure


def save_plot(runs: list, file) -> None:
    drawing.save_png(draw_ratios(runs), file)
