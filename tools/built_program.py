"""The vernier that a tool runs."""

import argparse
import pathlib
import shutil

BUILT = pathlib.Path(__file__).resolve().parent.parent / "build/release/src/cli/vernier"


def existing_program(text: str) -> str:
    """`text`, a path or a name on PATH, as an absolute path; argparse's error where there is none."""
    found = shutil.which(text)
    if found is None:
        raise argparse.ArgumentTypeError(f"there is no program {text}; tools/vernier --version builds one")
    return str(pathlib.Path(found).resolve())


def add_program_option(parser: argparse.ArgumentParser) -> None:
    """Adds `--program`, which is absolute when it is read."""
    parser.add_argument("--program", type=existing_program, default=str(BUILT), metavar="FILE", help="a vernier (default: %(default)s)")
