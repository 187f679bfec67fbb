"""Small textures: functions of the place in the picture, and lettering."""

import math

from picture_files.png import encode_deep_rgb, encode_png

# A face of 5 x 7 dots; each number is a row, the highest of five bits the left dot.
LETTERS = {
    " ": (0, 0, 0, 0, 0, 0, 0), "A": (14, 17, 17, 31, 17, 17, 17), "E": (31, 16, 16, 30, 16, 16, 31),
    "I": (14, 4, 4, 4, 4, 4, 14), "N": (17, 25, 21, 19, 17, 17, 17), "R": (30, 17, 17, 30, 20, 18, 17),
    "V": (17, 17, 17, 17, 17, 10, 4), "F": (31, 16, 16, 30, 16, 16, 16), "L": (16, 16, 16, 16, 16, 16, 31),
    "T": (31, 4, 4, 4, 4, 4, 4), "U": (17, 17, 17, 17, 17, 17, 14),
    "0": (14, 17, 19, 21, 25, 17, 14), "1": (4, 12, 4, 4, 4, 4, 14), "2": (14, 17, 1, 6, 8, 16, 31),
    "3": (30, 1, 1, 14, 1, 1, 30), "4": (2, 6, 10, 18, 31, 2, 2), "5": (31, 16, 30, 1, 1, 17, 14),
    "6": (6, 8, 16, 30, 17, 17, 14), "7": (31, 1, 2, 4, 8, 8, 8), "8": (14, 17, 17, 14, 17, 17, 14),
    "9": (14, 17, 17, 15, 1, 2, 12),
}


def whole_number(value: float, largest: int) -> int:
    """`value` of [0, 1] as 0..largest; what lies outside is clamped. Rounded first, so that no last place decides."""
    return min(largest, max(0, math.floor(round(value * largest, 6) + 0.5)))


def picture(width: int, height: int, color_of, channels: int = 3) -> bytes:
    """PNG of color_of(u, v), u and v the texel centres in (0, 1), v downwards; tuples of `channels` in [0, 1]."""
    return encode_png([[tuple(whole_number(value, 255) for value in color_of((x + 0.5) / width, (y + 0.5) / height))
                        for x in range(width)] for y in range(height)], channels)


def checker(first, second, squares: int = 2, size: int = 64) -> bytes:
    """A board of squares x squares fields."""
    return picture(size, size, lambda u, v: second if (int(u * squares) + int(v * squares)) % 2 else first)


def normals_of(size: int, height_of, strength: float):
    """Tangent-space normals (green up, as glTF has it) as colours of (u, v), for height_of(u, v) of period 1."""
    step = 0.5 / size

    def normal_of(u, v):
        slope_u = (height_of(u + step, v) - height_of(u - step, v)) / (2 * step) * strength
        slope_v = (height_of(u, v + step) - height_of(u, v - step)) / (2 * step) * strength
        length = math.sqrt(slope_u * slope_u + slope_v * slope_v + 1)
        return (0.5 - 0.5 * slope_u / length, 0.5 + 0.5 * slope_v / length, 0.5 + 0.5 / length)
    return normal_of


def normal_map(size: int, height_of, strength: float) -> bytes:
    """PNG of normals_of, 8 bits a channel."""
    return picture(size, size, normals_of(size, height_of, strength))


def deep_normal_map(size: int, height_of, strength: float) -> bytes:
    """PNG of normals_of, 16 bits a channel: in 8 the gentlest slopes are steps."""
    normal_of = normals_of(size, height_of, strength)
    return encode_deep_rgb([[tuple(whole_number(value, 65535) for value in normal_of((x + 0.5) / size, (y + 0.5) / size))
                             for x in range(size)] for y in range(size)])


def noise(x: int, y: int) -> float:
    """A number in [0, 1) that looks random and depends on x and y only (lowbias32 of Wellons, 2018)."""
    value = (x * 0x9E3779B9 + y * 0x85EBCA6B) & 0xFFFFFFFF
    for multiplier, shift in ((0x7FEB352D, 15), (0x846CA68B, 16)):
        value = ((value ^ (value >> 16)) * multiplier) & 0xFFFFFFFF
        value ^= value >> shift
    return value / 2**32


def parquet(size: int, light, dark) -> bytes:
    """Two by two squares of four planks each, their direction alternating, with a seam between planks.

    Twelve tones at most: the picture stays a small palette.
    """
    half, plank = size // 2, size // 8

    def color_of(u, v):
        x, y = int(u * size), int(v * size)
        along, across = (x, y) if (x // half + y // half) % 2 == 0 else (y, x)
        if across % plank == 0 or along % half == 0:
            return tuple(0.35 * value for value in dark)
        board = across // plank + 8 * (along // half) + 16 * ((x // half + y // half) % 2)
        grain = noise(across, board) * 0.4 + noise(board, 77) * 0.6
        tone = math.floor(grain * 12) / 11
        return tuple(a + (b - a) * tone for a, b in zip(dark, light))
    return picture(size, size, color_of)


class Canvas:
    """A picture to draw rectangles and letters on, in pixels, row 0 on top."""

    def __init__(self, width: int, height: int, background):
        self.rows = [[background] * width for _ in range(height)]

    def fill(self, x: int, y: int, width: int, height: int, color):
        """A rectangle; what lies outside the picture is left out."""
        for row in self.rows[max(0, y):max(0, y + height)]:
            for column in range(max(0, x), min(len(row), x + width)):
                row[column] = color

    def write(self, text: str, x: int, y: int, dot: int, color):
        """`text` with dots of dot x dot pixels, its upper left corner at (x, y)."""
        for number, letter in enumerate(text):
            for row, bits in enumerate(LETTERS[letter]):
                for column in range(5):
                    if bits & (16 >> column):
                        self.fill(x + (6 * number + column) * dot, y + row * dot, dot, dot, color)

    def to_png(self) -> bytes:
        """The picture as PNG; colours are tuples of three bytes."""
        return encode_png(self.rows, 3)
