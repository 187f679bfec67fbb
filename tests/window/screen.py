"""A screen without a screen (Xvfb), what is on it, and a user at it (xdotool)."""

import ctypes
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SCREEN = (1280, 720)
# A click is seen once a frame has passed with the button down; frames come every 0.1 s at the slowest when idle, later on a
# machine with other work on every core: there clicks of 0.2 s were lost.
SEEN = 0.6


def skip_without_xvfb():
    """Ends the test as skipped, with the reason, where there is no Xvfb to run it on."""
    for tool in ("Xvfb", "xdotool"):
        if shutil.which(tool) is None:
            print(f"skipped: {tool} is not installed (tools/setup test)")
            sys.exit(77)


class Picture:
    """Pixels of the screen: rows of four bytes each, blue first."""

    def __init__(self, width, height, rows):
        self.width, self.height, self.rows = width, height, rows

    def pixel(self, x, y):
        blue, green, red = self.rows[y][4 * x:4 * x + 3]
        return red, green, blue

    def part(self, x, y, width, height):
        return Picture(width, height, [row[4 * x:4 * (x + width)] for row in self.rows[y:y + height]])

    def mean(self):
        """Of all channels, 0 to 255."""
        return sum(sum(row[0::4]) + sum(row[1::4]) + sum(row[2::4]) for row in self.rows) / (3 * self.width * self.height)

    def colors(self):
        """How many different colours there are."""
        return len({row[4 * x:4 * x + 3] for row in self.rows for x in range(self.width)})

    def difference(self, other):
        """Share of the pixels that differ by more than rounding and dither could: 3 of 255 in a channel."""
        count = 0
        for mine, others in zip(self.rows, other.rows):
            if mine == others:
                continue
            for x in range(0, 4 * self.width, 4):
                count += any(abs(mine[x + channel] - others[x + channel]) > 3 for channel in range(3))
        return count / (self.width * self.height)

    def bounds_of_other_than(self, color):
        """(x, y, width, height) of the pixels that are not `color`."""
        inside = [(x, y) for y in range(self.height) for x in range(self.width) if self.pixel(x, y) != color]
        left, top = min(x for x, _ in inside), min(y for _, y in inside)
        return left, top, max(x for x, _ in inside) - left + 1, max(y for _, y in inside) - top + 1


class Screen:
    """Xvfb on a display of its own; its pixels lie in a file."""

    def __init__(self, width=SCREEN[0], height=SCREEN[1]):
        self.folder = tempfile.TemporaryDirectory()
        read_end, write_end = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write_end), "-screen", "0", f"{width}x{height}x24", "-fbdir", self.folder.name,
             "-nolisten", "tcp", "-noreset"],
            pass_fds=[write_end], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write_end)
        with os.fdopen(read_end) as number:
            self.name = ":" + number.readline().strip()

    def close(self):
        self.server.terminate()
        self.server.wait()
        self.folder.cleanup()

    def picture(self):
        """All that is on the screen now (X window dump, version 7)."""
        dump = (Path(self.folder.name) / "Xvfb_screen0").read_bytes()
        header = struct.unpack(">25I", dump[:100])
        width, height, row_bytes, color_count = header[4], header[5], header[12], header[19]
        first = header[0] + 12 * color_count
        return Picture(width, height,
                       [dump[first + y * row_bytes:first + y * row_bytes + 4 * width] for y in range(height)])

    def user(self, *words):
        return subprocess.run(["xdotool", *map(str, words)], env={**os.environ, "DISPLAY": self.name}, check=True,
                              capture_output=True, text=True, timeout=20).stdout

    def point(self, x, y):
        self.user("mousemove", round(x), round(y))
        time.sleep(SEEN)

    def click(self, x, y):
        self.point(x, y)
        self.user("mousedown", 1)
        time.sleep(SEEN)
        self.user("mouseup", 1)
        time.sleep(SEEN)

    def drag(self, start, end, button=1):
        self.point(*start)
        self.user("mousedown", button)
        time.sleep(SEEN)
        for step in range(1, 5):
            self.user("mousemove", *(round(a + (b - a) * step / 4) for a, b in zip(start, end)))
            time.sleep(0.05)
        time.sleep(SEEN)
        self.user("mouseup", button)

    def key(self, name):
        self.user("keydown", name)
        time.sleep(SEEN)
        self.user("keyup", name)
        time.sleep(SEEN)

    def windows(self):
        """Numbers of the windows that are open."""
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "Vernier"],
                               env={**os.environ, "DISPLAY": self.name}, capture_output=True, text=True, timeout=20)
        return [int(line) for line in found.stdout.split()]

    def ask_to_close(self, window):
        """What a window manager sends when the user closes a window: WM_DELETE_WINDOW."""
        x11 = ctypes.CDLL("libX11.so.6")
        x11.XOpenDisplay.restype = ctypes.c_void_p
        x11.XInternAtom.restype = ctypes.c_ulong
        display = ctypes.c_void_p(x11.XOpenDisplay(self.name.encode()))
        protocols = x11.XInternAtom(display, b"WM_PROTOCOLS", 0)
        delete = x11.XInternAtom(display, b"WM_DELETE_WINDOW", 0)
        client_message, all_of_it = 33, 192
        event = struct.pack("@iLiPLLi5l", client_message, 0, 0, 0, window, protocols, 32, delete, 0, 0, 0, 0)
        x11.XSendEvent(display, ctypes.c_ulong(window), 0, ctypes.c_long(0), event.ljust(all_of_it, b"\0"))
        x11.XFlush(display)
        x11.XCloseDisplay(display)
