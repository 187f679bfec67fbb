"""Pictures: PNG out and in again, textures that mean what they say, and the readers of EXR and NPZ on bytes by hand."""

import io
import pathlib
import struct
import tempfile
import unittest
import zipfile
import zlib

import tool_path  # noqa: F401
from picture_files import exr, npz, png
from scene_making import pictures


class Png(unittest.TestCase):
    def test_round_trip(self):
        for channels in (1, 3, 4):
            # More than 256 colours, so that no palette is used.
            rows = [[tuple((x * 7 + y * 13 * (part + 1)) % 256 for part in range(channels)) for x in range(23)]
                    for y in range(17)]
            width, height, found, lines = png.decode_png(png.encode_png(rows, channels))
            self.assertEqual((width, height, found), (23, 17, channels))
            self.assertEqual(lines, [bytes(value for pixel in row for value in pixel) for row in rows])

    def test_few_colors_become_a_palette(self):
        content = png.encode_png([[(1, 2, 3), (4, 5, 6)]], 3)
        self.assertIn(b"PLTE" + bytes([1, 2, 3, 4, 5, 6]), content)
        with self.assertRaises(ValueError):
            png.decode_png(content)

    def test_every_filter(self):
        # One line a filter; each is the line (10, 20, 30) above which the same line stands.
        filtered = [(0, 10, 20, 30), (1, 10, 10, 10), (2, 0, 0, 0), (3, 5, 5, 5), (4, 0, 0, 0)]
        raw = b"".join(bytes(line) for line in filtered)
        content = png.assembled(3, 5, 0, b"", raw)
        self.assertEqual(png.decode_png(content)[3], [bytes((10, 20, 30))] * 5)

    def test_rgb_rows(self):
        rows = [bytes(range(9)), bytes(range(9, 18))]
        self.assertEqual(png.decode_png(png.encode_rgb(rows))[3], rows)


    def test_deep_rows(self):
        content = png.encode_deep_rgb([[(1, 256, 65535), (0, 2, 3)]])
        at = content.index(b"IDAT")
        size, = struct.unpack(">I", content[at - 4:at])
        self.assertEqual(struct.unpack(">IIBB", content[16:26]), (2, 1, 16, 2))
        self.assertEqual(zlib.decompress(content[at + 4:at + 4 + size]), b"\0\0\1\1\0\xff\xff\0\0\0\2\0\3")


class Textures(unittest.TestCase):
    def test_a_flat_relief_points_up(self):
        self.assertEqual(set(png_pixels(pictures.normal_map(4, lambda u, v: 0.3, 1.0))), {(128, 128, 255)})

    def test_a_slope_rising_to_the_right_leans_left_and_one_rising_downwards_leans_up(self):
        self.assertLess(png_pixels(pictures.normal_map(4, lambda u, v: u, 1.0))[0][0], 128)
        self.assertGreater(png_pixels(pictures.normal_map(4, lambda u, v: v, 1.0))[0][1], 128)

    def test_letters_are_dots(self):
        canvas = pictures.Canvas(6, 8, (0, 0, 0))
        canvas.write("L", 0, 0, 1, (255, 255, 255))
        self.assertEqual([sum(pixel[0] > 0 for pixel in row) for row in canvas.rows], [1, 1, 1, 1, 1, 1, 5, 0])


def png_pixels(content):
    """The colours of a palette PNG in reading order."""
    at, chunks = 8, {}
    while at < len(content):
        length, kind = struct.unpack_from(">I4s", content, at)
        chunks[kind] = content[at + 8:at + 8 + length]
        at += 12 + length
    width, height = struct.unpack_from(">II", chunks[b"IHDR"])
    raw = zlib.decompress(chunks[b"IDAT"])
    palette = chunks[b"PLTE"]
    return [tuple(palette[3 * raw[y * (width + 1) + 1 + x] + part] for part in range(3))
            for y in range(height) for x in range(width)]


class Readers(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.folder = pathlib.Path(self.scratch.name)

    def test_npz(self):
        header = b"{'descr': '<f4', 'fortran_order': False, 'shape': (1, 3), }\n"
        with zipfile.ZipFile(self.folder / "a.npz", "w") as archive:
            archive.writestr("t.npy", b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header +
                             struct.pack("<3f", 1, 2.5, float("inf")))
        self.assertEqual(npz.read_npz(self.folder / "a.npz"), {"t": ((1, 3), (1, 2.5, float("inf")))})

    def write_exr(self, compression, blocks):
        """An EXR of channels A (float) and N (uint), WIDTH x 2 pixels, data window from (5, 3)."""
        def attribute(name, kind, content):
            return name + b"\0" + kind + b"\0" + struct.pack("<i", len(content)) + content
        channels = b"".join(name + b"\0" + struct.pack("<iiii", kind, 0, 1, 1) for name, kind in ((b"A", 2), (b"N", 0)))
        head = struct.pack("<II", 20000630, 2) + attribute(b"channels", b"chlist", channels + b"\0") + attribute(
            b"compression", b"compression", bytes([compression])) + attribute(
            b"dataWindow", b"box2i", struct.pack("<4i", 5, 3, 4 + self.WIDTH, 4)) + b"\0"
        file, at = io.BytesIO(), len(head) + 8 * len(blocks)
        file.write(head)
        for _, content in blocks:
            file.write(struct.pack("<Q", at))
            at += 8 + len(content)
        for first, content in blocks:
            file.write(struct.pack("<ii", first, len(content)) + content)
        (self.folder / "a.exr").write_bytes(file.getvalue())
        return exr.read_exr(self.folder / "a.exr")

    WIDTH = 40
    ROWS = [([1.0, 2.0] * 20, [3, 4] * 20), ([5.0, 6.0] * 20, [7, 2**32 - 1] * 20)]
    LINES = [struct.pack("<40f40I", *reals, *counts) for reals, counts in ROWS]

    def check(self, found):
        width, height, values = found
        self.assertEqual((width, height), (self.WIDTH, 2))
        self.assertEqual({name: list(part) for name, part in values.items()},
                         {"A": self.ROWS[0][0] + self.ROWS[1][0], "N": self.ROWS[0][1] + self.ROWS[1][1]})

    def test_exr_plain(self):
        self.check(self.write_exr(0, [(3, self.LINES[0]), (4, self.LINES[1])]))

    def test_exr_zip(self):
        raw = b"".join(self.LINES)
        halves = raw[0::2] + raw[1::2]
        steps = bytes([halves[0]]) + bytes((b - a + 128) & 255 for a, b in zip(halves, halves[1:]))
        packed = zlib.compress(steps, 9)
        self.assertLess(len(packed), len(raw))
        self.check(self.write_exr(3, [(3, packed)]))

    def test_exr_zip_of_a_block_that_did_not_shrink(self):
        self.check(self.write_exr(3, [(3, b"".join(self.LINES))]))

    def test_exr_of_another_compression_is_refused(self):
        with self.assertRaises(ValueError):
            self.write_exr(4, [(3, b"")])


if __name__ == "__main__":
    unittest.main()
