"""What the plots of all pages have in common: their style, and SVG whose colours follow the page."""

import io
import re

import matplotlib

matplotlib.use("svg")
from matplotlib import pyplot  # noqa: E402

INK = "#123456"  # stands for the colour of the page's text, put in at the end


def set_style() -> None:
    pyplot.rcParams.update({"svg.fonttype": "path", "font.family": "DejaVu Sans", "font.size": 9, "text.color": INK,
                            "axes.labelcolor": INK, "xtick.color": INK, "ytick.color": INK, "axes.edgecolor": INK,
                            "svg.hashsalt": "vernier"})


def save_png(figure, file) -> None:
    """On white; closes the figure."""
    figure.savefig(file, format="png", dpi=120, facecolor="white", metadata={"Software": None})
    pyplot.close(figure)


def svg_text(figure) -> str:
    """As wide as its place, without a size of its own; closes the figure."""
    buffer = io.StringIO()
    figure.savefig(buffer, format="svg", transparent=True, metadata={"Date": None})
    pyplot.close(figure)
    text = buffer.getvalue()
    text = text[text.index("<svg"):].replace(INK, "currentColor")
    return re.sub(r'(<svg[^>]*?) width="[^"]*"', r"\1", re.sub(r'(<svg[^>]*?) height="[^"]*"', r"\1", text, count=1), count=1)
