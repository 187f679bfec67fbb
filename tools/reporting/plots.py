"""Error against time as SVG whose colours follow the page."""

from matplotlib import pyplot
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from reporting import drawing, figures
from reporting.drawing import INK

# Colours that differ for readers who see few (after Okabe and Ito 2008; the blue lighter, for dark pages), each with a
# mark of its own.
SERIES = {"spp": ("samples per pixel", "#1f86d0", "o"), "adaptive": ("error target", "#d55e00", "D"),
          "level": ("numeric level", "#009e73", "s"), "bounces": ("bounces", "#cc79a7", "^"),
          "cutoff": ("cut-off", "#e69f00", "v"), "filter": ("filter", "#9467bd", "P"), "effects": ("an effect left out", "#56b4e9", "x")}


def _short(value: float, _place) -> str:
    return f"{value:g}"


def error_against_time(cost: dict, narrow: bool) -> str:
    """Log-log plot as SVG, `narrow` for phones."""
    return drawing.svg_text(_plot(cost, narrow))


def save_plot(cost: dict, file) -> None:
    """The wide plot as PNG on white."""
    drawing.save_png(_plot(cost, narrow=False), file)


def _plot(cost: dict, narrow: bool):
    drawing.set_style()
    figure, axes = pyplot.subplots(figsize=(3.7, 4.6) if narrow else (8.2, 4.8), layout="constrained")
    axes.set_xscale("log")
    axes.set_yscale("log")
    for axis, (label, color, mark) in SERIES.items():
        points = [point for point in cost["points"] if point["axis"] == axis and figures.error_of(point)]
        _draw_series(axes, points, label, color, mark)
    _draw_front(axes, cost)
    _draw_floors(axes, cost)
    _draw_reference(axes, cost)
    axes.set_xlabel("device time, ms")
    axes.set_ylabel("relative error, √relMSE")
    axes.grid(True, which="major", color=INK, alpha=0.14, linewidth=0.6)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    for one in (axes.xaxis, axes.yaxis):
        one.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        one.set_major_formatter(FuncFormatter(_short))
        one.set_minor_formatter(NullFormatter())
    axes.legend(loc="lower left", bbox_to_anchor=(-0.2 if narrow else 0.0, 1.0), ncols=2 if narrow else 4, frameon=False,
                fontsize=7.5 if narrow else 8, columnspacing=1.0, handlelength=1.5)
    return figure


def _draw_series(axes, points: list[dict], label: str, color: str, mark: str) -> None:
    if not points:
        return
    times = [figures.time_of(point) for point in points]
    errors = [figures.error_of(point) for point in points]
    ends = [[max(0.0, error - max(point["rel_error"]["low"] or 0.0, error * 0.1)) for point, error in zip(points, errors)],
            [max(0.0, (point["rel_error"]["high"] or error) - error) for point, error in zip(points, errors)]]
    axes.errorbar(times, errors, yerr=ends, fmt=mark, color=color, markersize=5, linewidth=0.9, label=label)
    if points[0]["axis"] == "spp":
        axes.plot(times, errors, color=color, linewidth=0.9, alpha=0.7)
        for point in points:
            axes.annotate(point["name"].split()[0], (figures.time_of(point), figures.error_of(point)),
                          textcoords="offset points", xytext=(5, 5), fontsize=7.5, color=color)


def _draw_front(axes, cost: dict) -> None:
    by_name = {point["name"]: point for point in cost["points"]}
    front = [by_name[name] for name in cost["pareto"]]
    axes.step([figures.time_of(point) for point in front], [figures.error_of(point) for point in front], where="post",
              color=INK, linewidth=0.9, linestyle=(0, (4, 2)), label="Pareto front")


def _draw_floors(axes, cost: dict) -> None:
    """A line where each truncated setting ends, however many samples it gets."""
    ends = axes.get_xlim()
    for point in cost["points"]:
        if point["axis"] in ("bounces", "cutoff", "filter") and point["bias_floor"]:
            _, color, _ = SERIES[point["axis"]]
            axes.hlines(point["bias_floor"], figures.time_of(point), ends[1], color=color, linewidth=0.8,
                        linestyle=(0, (1, 1.5)))
            axes.annotate("floor: " + point["name"], (ends[1], point["bias_floor"]), ha="right", va="bottom", fontsize=6.5,
                          color=color)
    axes.set_xlim(ends)


def _draw_reference(axes, cost: dict) -> None:
    own = cost["reference"].get("rel_error")
    lowest = axes.get_ylim()[0]
    if own and own > lowest:
        axes.axhspan(lowest, own, color=INK, alpha=0.06,
                     label="the reference's own error")
