"""The page: figures, plots and pictures through one template."""

import base64
import pathlib

import jinja2
import markupsafe

from reporting import figures, plots

TEMPLATE = pathlib.Path(__file__).with_name("report.html.jinja")


def embedded(folder: pathlib.Path, name: str) -> str:
    """A picture as a URL that holds it."""
    return "data:image/png;base64," + base64.b64encode((folder / name).read_bytes()).decode("ascii")


def make_page(cost: dict, folder: pathlib.Path) -> str:
    """report.html of `cost`, the content of cost.json in `folder`, whose pictures it takes in."""
    environment = jinja2.Environment(autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=True,
                                     lstrip_blocks=True)
    environment.filters.update(ms=figures.time_text, error=figures.error_text, interval=figures.interval_text)
    template = environment.from_string(TEMPLATE.read_text(encoding="utf-8"))
    return template.render(
        cost=cost, advice=figures.recommendation(cost), pairs=figures.pairs(cost),
        adaptive=figures.adaptive_rows(cost), effects=figures.against_base(cost, "effects"),
        levels=figures.against_base(cost, "level"), spots=figures.against_base(cost, "spot"),
        wide_plot=markupsafe.Markup(plots.error_against_time(cost, narrow=False)),
        narrow_plot=markupsafe.Markup(plots.error_against_time(cost, narrow=True)),
        picture=lambda name: embedded(folder, name))

