"""benchmark.html: Vernier's rate over its peers', round by round, and both pictures."""

import base64
import pathlib

import markupsafe
from matplotlib import pyplot

from benchmarking.measured_runs import EMBREE, MITSUBA, POVRAY, VERNIER
from benchmarking.ratios import peers_of
from reporting import drawing
from reporting.page import template_of

TEMPLATE = pathlib.Path(__file__).with_name("benchmark.html.jinja")
COLORS = {POVRAY: "#d55e00", EMBREE: "#1f86d0", MITSUBA: "#009e73"}


def round_ratios(report: dict, peer: str, measure: str) -> list:
    return [one[VERNIER][measure] / one[peer][measure] for one in report["each_round"]]


def draw_ratios(report: dict):
    """A dot for each round, a line at the median and a dashed one at what is wanted; every peer on an axis of its own, from 0."""
    drawing.set_style()
    peers = peers_of(report["ratios"])
    figure, rows = pyplot.subplots(len(peers), 1, figsize=(7.2, 1.5 * len(peers)), layout="constrained")
    for axes, peer in zip(rows, peers):
        color = COLORS[peer.name]
        for height, measure in enumerate(peer.measures()):
            values = round_ratios(report, peer.name, measure)
            axes.plot(values, [height] * len(values), "o", color=color, markersize=6, alpha=0.55, markeredgewidth=0)
            axes.plot([report["ratios"][peer.name][measure]["median"]] * 2, [height - 0.28, height + 0.28], color=color, linewidth=2)
        axes.axvline(peer.target, color=drawing.INK, linestyle=(0, (4, 2)), linewidth=0.9)
        axes.annotate(f"wanted: {peer.target:g}", (peer.target, 1.0), xycoords=("data", "axes fraction"), xytext=(3, 2),
                      textcoords="offset points", fontsize=7.5)
        axes.set_yticks(range(len(peer.measures())), list(peer.measures().values()))
        axes.set_ylim(len(peer.measures()) - 0.4, -0.6)
        axes.set_xlim(left=0.0)
        axes.set_title(f"times the {peer.unit} of {peer.name}", loc="left", fontsize=9, color=drawing.INK)
        axes.grid(True, axis="x", color=drawing.INK, alpha=0.14, linewidth=0.6)
        for side in ("top", "right", "left"):
            axes.spines[side].set_visible(False)
        axes.tick_params(axis="y", length=0)
    return figure


def save_plot(report: dict, file) -> None:
    drawing.save_png(draw_ratios(report), file)


def make_page(report: dict, folder: pathlib.Path) -> str:
    """`folder` holds the pictures of those that draw one."""
    pictures = {name: "data:image/png;base64," + base64.b64encode((folder / file).read_bytes()).decode("ascii")
                for name, file in ((VERNIER, "vernier.png"), (POVRAY, "povray.png"), (MITSUBA, "mitsuba.png"))
                if name in report["rates"]}
    return template_of(TEMPLATE, mega=lambda value: f"{value * 1e-6:.3g}").render(
        report=report, pictures=pictures, peers=peers_of(report["ratios"]), name=VERNIER,
        plot=markupsafe.Markup(drawing.svg_text(draw_ratios(report))))
