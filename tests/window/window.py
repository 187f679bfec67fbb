"""The window under test: VERNIER is the program, VERNIER_SOURCE_DIR the repository."""

import json
import os
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from screen import Screen, skip_without_xvfb

PROGRAM = os.environ["VERNIER"]
SCENES = Path(os.environ["VERNIER_SOURCE_DIR"]) / "scenes"
SIZE = (320, 180)
ROOM = (480, 680)  # of the picture in a window that has just been opened
OUTSIDE = (1270, 710)  # of the window
PANEL = 340  # pixels, at the right of the window
# What `vernier` itself sets where a processor has wide vectors: llvmpipe crashes if it has to draw a triangle then.
WIDE_VECTORS = {"LP_NATIVE_VECTOR_WIDTH": "512"}
# On two busy cores a kernel compiles in seconds.
PATIENCE = 60.0
SURROUND = (28, 28, 28)  # 0.11 of 255, around the picture

skip_without_xvfb()


class View:
    """`vernier view` on a screen, with what it tells of its widgets. The validation layer is on."""

    def __init__(self, screen, folder, *arguments):
        self.screen, self.folder = screen, folder
        self.places_file = folder / "places.json"
        self.places_file.unlink(missing_ok=True)
        self.errors = open(folder / "stderr.txt", "w+", encoding="utf-8")
        environment = {**os.environ, **WIDE_VECTORS, "DISPLAY": screen.name, "VERNIER_VALIDATION": "1", "XDG_STATE_HOME": str(folder),
                       "VERNIER_PIPELINE_CACHE": screen.folder.name}
        self.process = subprocess.Popen([PROGRAM, "view", *map(str, arguments), "--places", str(self.places_file)],
                                        cwd=folder, env=environment, stderr=self.errors, stdout=self.errors)

    def state(self):
        try:
            return json.loads(self.places_file.read_text(encoding="utf-8"))
        except FileNotFoundError:
            return {}

    def wait(self, condition, what):
        """Until condition(state) holds; its state."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            state = self.state()
            if state and condition(state):
                return state
            if self.process.poll() is not None:
                break
            time.sleep(0.05)
        raise AssertionError(f"{what}: waited in vain; {self.state()} {self.said()}")

    def settle(self, what="a picture that is settled"):
        time.sleep(0.3)  # what was done before is seen
        state = self.wait(lambda state: state["settled"], what)
        time.sleep(0.3)  # it is on the screen one frame later
        return state

    def place(self, name, along=0.5):
        """A point of the widget `name`, `along` of its width."""
        x, y, width, height = self.wait(lambda state: name in state["places"], name)["places"][name]
        return x + along * width, y + 0.5 * height

    def click(self, name, along=0.5):
        self.screen.click(*self.place(name, along))

    def scroll_to(self, name):
        """Turns the wheel over the panels until the widget `name` is in sight."""
        self.screen.point(ROOM[0] + PANEL // 2, ROOM[1] // 2)
        for _ in range(60):
            if self.place(name)[1] < ROOM[1] - 40:
                return
            self.screen.user("click", 5)
            time.sleep(0.25)
        raise AssertionError(f"{name} does not come in sight: {self.place(name)}")

    def picture(self):
        """The part of the screen that shows the scene, without the mouse's arrow on it."""
        self.screen.point(*OUTSIDE)
        return self.screen.picture().part(0, 0, *ROOM)

    def picture_that(self, holds, what):
        """The settled picture, once it holds(picture): on a busy machine an input may arrive after a picture has settled."""
        end = time.monotonic() + PATIENCE
        while True:
            self.settle(what)
            picture = self.picture()
            if holds(picture):
                return picture
            if time.monotonic() > end:
                raise AssertionError(f"{what}: waited in vain; {self.state()} {self.said()}")

    def said(self):
        self.errors.flush()
        return Path(self.errors.name).read_text(encoding="utf-8")

    def stop(self):
        """Ends it, whatever it does."""
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()
        self.errors.close()

    def end(self):
        """Exit code, once it has ended."""
        try:
            return self.process.wait(timeout=PATIENCE)
        finally:
            self.stop()


class WindowTest(unittest.TestCase):
    """One screen for all tests of a class; a folder for each test."""

    @classmethod
    def setUpClass(cls):
        cls.screen = Screen()
        cls.addClassCleanup(cls.screen.close)

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def open(self, *arguments):
        """A window, small unless `arguments` say otherwise, that is closed at the end of the test without a fault."""
        return self.open_on(self.screen, *arguments)

    def open_on(self, screen, *arguments):
        """The same on another screen. One window at a time: files of a second one would lie where the first's do."""
        view = View(screen, self.folder, *arguments, "--size", f"{SIZE[0]}x{SIZE[1]}")
        self.addCleanup(self.close, view)
        return view

    def close(self, view):
        if view.process.poll() is None:
            view.process.send_signal(signal.SIGINT)
        self.assertEqual(view.end(), 0, (self.folder / "stderr.txt").read_text(encoding="utf-8"))
        self.assertNotIn("validation", (self.folder / "stderr.txt").read_text(encoding="utf-8").lower())

    def run_program(self, *arguments):
        """Exit code and what was said."""
        done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True,
                              timeout=120, env={**os.environ, **WIDE_VECTORS, "DISPLAY": self.screen.name,
                                                "VERNIER_VALIDATION": "1", "XDG_STATE_HOME": str(self.folder),
                                                "VERNIER_PIPELINE_CACHE": self.screen.folder.name})
        return done.returncode, done.stderr + done.stdout
