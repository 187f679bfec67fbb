"""Time of a ray against what grows, one small plot each, all of the same height."""

import math

from matplotlib import pyplot
from matplotlib.ticker import FuncFormatter, NullFormatter, NullLocator

from reporting import drawing

COLOR = "#1f86d0"


def short(value: float, _place=None) -> str:
    for size, letter in ((1e6, "M"), (1e3, "k")):
        if value >= size:
            return f"{value / size:g} {letter}"
    return f"{value:g}"


def draw(axes_rows: dict):
    """`axes_rows`: by name, rows with value, ns_per_ray and times_first."""
    drawing.set_style()
    columns = min(len(axes_rows), 3)
    rows_of_plots = math.ceil(len(axes_rows) / columns)
    figure, plots = pyplot.subplots(rows_of_plots, columns, figsize=(2.9 * columns, 2.5 * rows_of_plots), layout="constrained",
                                   sharey=True, squeeze=False)
    for plot, (name, rows) in zip(plots.flat, axes_rows.items()):
        draw_axis(plot, name, rows)
    for plot in plots.flat[len(axes_rows):]:
        plot.remove()
    for first in plots[:, 0]:
        first.set_ylabel("ns per ray")
    plots[0, 0].set_ylim(bottom=0.0)
    return figure


def draw_axis(plot, name: str, rows: list) -> None:
    values, times = [row["value"] for row in rows], [row["ns_per_ray"] for row in rows]
    # The spread is that of the ratio to the first setting, at its time.
    ends = [[times[0] * (row["times_first"]["median"] - row["times_first"]["least"]) for row in rows],
            [times[0] * (row["times_first"]["most"] - row["times_first"]["median"]) for row in rows]]
    places = values if min(values) > 0 and max(values) > 50 else list(range(len(values)))
    plot.errorbar(places, times, yerr=ends, fmt="o-", color=COLOR, markersize=4.5, linewidth=1.1)
    if places is values:
        plot.set_xscale("log")
        plot.xaxis.set_minor_formatter(NullFormatter())
        plot.xaxis.set_minor_locator(NullLocator())
    plot.set_xticks(places, [f"{int(value**0.5)}²" if name == "pixels" else short(value) for value in values], fontsize=7.5)
    plot.set_title(f"{name}: {rows[-1]['times_first']['median']:.2f} times", loc="left", fontsize=9, color=drawing.INK)
    plot.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    plot.grid(True, axis="y", color=drawing.INK, alpha=0.14, linewidth=0.6)
    for side in ("top", "right"):
        plot.spines[side].set_visible(False)


def save_plot(axes_rows: dict, file) -> None:
    drawing.save_png(draw(axes_rows), file)
