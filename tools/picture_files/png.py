"""Writes and reads the PNG files that the tools need, with nothing but zlib (W3C, PNG Specification, Third Edition)."""

import struct
import zlib

SIGNATURE = b"\x89PNG\r\n\x1a\n"
CHANNELS = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}


def chunk(kind: bytes, payload: bytes) -> bytes:
    """One chunk: length, kind, payload, checksum over kind and payload."""
    return struct.pack(">I", len(payload)) + kind + payload + struct.pack(">I", zlib.crc32(kind + payload))


def encode_png(rows: list[list[tuple]], channels: int) -> bytes:
    """PNG of `rows` [height][width] of tuples of `channels` (1, 3 or 4) values in 0..255.

    Pictures of at most 256 different opaque colours are stored as a palette, which is a third of the size.
    """
    height, width = len(rows), len(rows[0])
    colors = sorted({pixel for row in rows for pixel in row})
    palette = b""
    if channels == 3 and len(colors) <= 256:
        index = {color: number for number, color in enumerate(colors)}
        palette = chunk(b"PLTE", bytes(value for color in colors for value in color))
        lines = [bytes(index[pixel] for pixel in row) for row in rows]
        color_type, step = 3, 0
    else:
        lines = [bytes(value for pixel in row for value in pixel) for row in rows]
        color_type, step = {1: 0, 3: 2, 4: 6}[channels], channels
    raw = bytearray()
    for line in lines:
        # Filter 1 (the difference to the left neighbour) suits smooth pictures, filter 0 palettes.
        raw.append(1 if step else 0)
        if step:
            line = bytes((value - (line[at - step] if at >= step else 0)) & 255 for at, value in enumerate(line))
        raw += line
    return assembled(width, height, color_type, palette, bytes(raw))


def encode_rgb(rows: list[bytes]) -> bytes:
    """PNG of `rows`, each three bytes a pixel: for large pictures, without palette and filters."""
    return assembled(len(rows[0]) // 3, len(rows), 2, b"", b"".join(b"\0" + row for row in rows))


def encode_deep_rgb(rows: list[list[tuple]]) -> bytes:
    """PNG of 16 bits a channel of `rows` [height][width] of three values in 0..65535."""
    lines = [struct.pack(f">{3 * len(row)}H", *(value for pixel in row for value in pixel)) for row in rows]
    return assembled(len(rows[0]), len(rows), 2, b"", b"".join(b"\0" + line for line in lines), 16)


def assembled(width: int, height: int, color_type: int, palette: bytes, raw: bytes, depth: int = 8) -> bytes:
    """The file around `raw`, the filtered lines of `depth` bits a channel; `palette` is a whole chunk or nothing."""
    header = struct.pack(">IIBBBBB", width, height, depth, color_type, 0, 0, 0)
    return (SIGNATURE + chunk(b"IHDR", header) + palette + chunk(b"IDAT", zlib.compress(raw, 9)) +
            chunk(b"IEND", b""))


def decode_png(content: bytes) -> tuple[int, int, int, list[bytes]]:
    """(width, height, channels, rows of bytes) of an 8-bit PNG without interlacing or palette; ValueError for others."""
    if content[:8] != SIGNATURE:
        raise ValueError("not a PNG")
    at, packed, header = 8, b"", None
    while at + 8 <= len(content):
        length, kind = struct.unpack(">I4s", content[at:at + 8])
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", content[at + 8:at + 8 + length])
        elif kind == b"IDAT":
            packed += content[at + 8:at + 8 + length]
        at += 12 + length
    if header is None or header[2] != 8 or header[3] not in (0, 2, 4, 6) or header[6] != 0:
        raise ValueError("a kind of PNG that is not read here")
    width, height, channels = header[0], header[1], CHANNELS[header[3]]
    raw = zlib.decompress(packed)
    stride, rows, previous = width * channels, [], bytes(width * channels)
    for y in range(height):
        line = raw[y * (stride + 1):(y + 1) * (stride + 1)]
        previous = unfilter(line[0], bytearray(line[1:]), previous, channels)
        rows.append(bytes(previous))
    return width, height, channels, rows


def unfilter(kind: int, line: bytearray, above: bytes, step: int) -> bytearray:
    """Undoes the filter `kind` of one line (PNG Specification, section 9)."""
    if kind == 2:
        return bytearray((value + up) & 255 for value, up in zip(line, above))
    for at in range(len(line) if kind else 0):
        left = line[at - step] if at >= step else 0
        if kind == 1:
            guess = left
        elif kind == 3:
            guess = (left + above[at]) // 2
        else:
            corner = above[at - step] if at >= step else 0
            guess = nearest_of(left, above[at], corner)
        line[at] = (line[at] + guess) & 255
    return line


def nearest_of(left: int, up: int, corner: int) -> int:
    """Paeth's predictor: that of the three which is nearest to left + up - corner."""
    target = left + up - corner
    return min((abs(target - left), 0, left), (abs(target - up), 1, up), (abs(target - corner), 2, corner))[2]
