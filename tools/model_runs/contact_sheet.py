"""Puts many small pictures on one, each with its number, so that a person can look at all of them."""

import pathlib

from picture_files.png import decode_png, encode_rgb
from scene_making.pictures import LETTERS

COLUMNS, GAP = 8, 4
BACKGROUND = 40


def rgb_rows(path: pathlib.Path, width: int, height: int) -> list[bytearray]:
    """The picture cut or filled to width x height, three bytes a pixel; plain grey where there is none."""
    rows = [bytearray([BACKGROUND] * 3 * width) for _ in range(height)]
    try:
        found_width, _, channels, lines = decode_png(path.read_bytes())
    except (OSError, ValueError):
        return rows
    color = (0, 1, 2) if channels >= 3 else (0, 0, 0)
    for row, line in zip(rows, lines):
        for part, channel in enumerate(color):
            values = line[channel::channels][:width]
            row[part:3 * min(width, found_width):3] = values
    return rows


def write_number(rows: list[bytearray], number: int):
    """`number` in the upper left corner, white on black."""
    for place, digit in enumerate(str(number)):
        for y in range(9):
            for x in range(6):
                inside = 1 <= y <= 7 and 1 <= x <= 5 and LETTERS[digit][y - 1] & (32 >> x)
                start = 3 * (6 * place + x)
                rows[y][start:start + 3] = bytes([255 if inside else 0] * 3)


def write_sheet(pictures: list[pathlib.Path], width: int, height: int, output: pathlib.Path):
    """All `pictures` in reading order, numbered from 1, as one PNG."""
    empty = bytes([BACKGROUND] * 3 * (width + GAP) * COLUMNS)
    sheet = []
    for first in range(0, len(pictures), COLUMNS):
        tiles = []
        for number, path in enumerate(pictures[first:first + COLUMNS], first + 1):
            tiles.append(rgb_rows(path, width, height))
            write_number(tiles[-1], number)
        gap = bytes([BACKGROUND] * 3 * GAP)
        for y in range(height):
            line = b"".join(bytes(tile[y]) + gap for tile in tiles)
            sheet.append(line + empty[len(line):])
        sheet += [empty] * GAP
    if sheet:
        output.write_bytes(encode_rgb(sheet))
