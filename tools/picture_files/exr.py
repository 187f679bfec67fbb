"""Reads the OpenEXR files that Vernier writes: one part, scan lines, not compressed or ZIP (OpenEXR File Layout)."""

import array
import itertools
import struct
import zlib

LINES_OF_BLOCK = {0: 1, 2: 1, 3: 16}  # none, ZIPS, ZIP
TYPE_CODES = {0: "I", 2: "f"}  # uint, float: both 4 bytes


def read_exr(path) -> tuple[int, int, dict[str, array.array]]:
    """(width, height, values by channel name, row 0 on top). ValueError for other kinds of EXR."""
    with open(path, "rb") as file:
        content = file.read()
    magic, version = struct.unpack_from("<II", content)
    if magic != 20000630 or version & 0x1A00:
        raise ValueError(f"{path}: not an EXR file of one part with scan lines")
    attributes, at = read_attributes(content)
    channels = read_channels(attributes["channels"])
    compression = attributes["compression"][0]
    if compression not in LINES_OF_BLOCK or any(kind not in TYPE_CODES for _, kind in channels):
        raise ValueError(f"{path}: compression {compression} or a channel type that is not read here")
    left, top, right, bottom = struct.unpack("<4i", attributes["dataWindow"])
    width, height = right - left + 1, bottom - top + 1
    values = {name: array.array(TYPE_CODES[kind], bytes(4 * width * height)) for name, kind in channels}
    block = LINES_OF_BLOCK[compression]
    for offset in struct.unpack_from(f"<{-(-height // block)}Q", content, at):
        first, size = struct.unpack_from("<ii", content, offset)
        lines = min(block, bottom + 1 - first)
        raw = content[offset + 8:offset + 8 + size]
        # A block that would not shrink is stored as it is.
        if compression and size < 4 * width * lines * len(channels):
            raw = unpacked(zlib.decompress(raw))
        for number in range(lines * len(channels)):
            name, kind = channels[number % len(channels)]
            line = array.array(TYPE_CODES[kind], raw[4 * width * number:4 * width * (number + 1)])
            start = (first - top + number // len(channels)) * width
            values[name][start:start + width] = line
    return width, height, values


def read_attributes(content: bytes) -> tuple[dict[str, bytes], int]:
    """The header's attributes by name, and the offset of what follows."""
    attributes, at = {}, 8
    while content[at]:
        name_end = content.index(b"\0", at)
        type_end = content.index(b"\0", name_end + 1)
        size, = struct.unpack_from("<i", content, type_end + 1)
        attributes[content[at:name_end].decode()] = content[type_end + 5:type_end + 5 + size]
        at = type_end + 5 + size
    return attributes, at + 1


def read_channels(content: bytes) -> list[tuple[str, int]]:
    """(name, type) in the order of the file, which is by name."""
    channels, at = [], 0
    while content[at]:
        end = content.index(b"\0", at)
        channels.append((content[at:end].decode(), struct.unpack_from("<i", content, end + 1)[0]))
        at = end + 17
    return channels


def unpacked(raw: bytes) -> bytes:
    """Undoes what ZIP does before deflating: differences, and the halves of the bytes apart."""
    summed = bytes(itertools.accumulate(raw, lambda before, step: (before + step - 128) & 255))
    half = (len(summed) + 1) // 2
    whole = bytearray(len(summed))
    whole[0::2], whole[1::2] = summed[:half], summed[half:]
    return bytes(whole)
