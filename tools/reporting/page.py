"""The page: figures, plots and pictures through one template."""

import base64
import pathlib

import jinja2
import markupsafe

from reporting import figures, plots

FOLDER = pathlib.Path(__file__).parent


def embedded(folder: pathlib.Path, name: str) -> str:
    """A picture as a URL that holds it."""
    return "data:image/png;base64," + base64.b64encode((folder / name).read_bytes()).decode("ascii")


def template_of(path: pathlib.Path, **filters) -> jinja2.Template:
    """The template at `path`, which may include what lies in this folder."""
    environment = jinja2.Environment(autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=True,
                                     lstrip_blocks=True, loader=jinja2.FileSystemLoader([path.parent, FOLDER]))
    environment.filters.update(filters)
    return environment.get_template(path.name)


def make_page(cost: dict, folder: pathlib.Path) -> str:
    """report.html of `cost`, the content of cost.json in `folder`, whose pictures it takes in."""
    template = template_of(FOLDER / "report.html.jinja", ms=figures.time_text, error=figures.error_text,
                           interval=figures.interval_text)
    return template.render(
        cost=cost, advice=figures.recommendation(cost), pairs=figures.pairs(cost),
        adaptive=figures.adaptive_rows(cost), effects=figures.against_base(cost, "effects"),
        levels=figures.against_base(cost, "level"), spots=figures.against_base(cost, "spot"),
        wide_plot=markupsafe.Markup(plots.error_against_time(cost, narrow=False)),
        narrow_plot=markupsafe.Markup(plots.error_against_time(cost, narrow=True)),
        picture=lambda name: embedded(folder, name))

