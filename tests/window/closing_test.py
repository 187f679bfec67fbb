"""Closing the window at any moment, or Ctrl-C, ends with 0 and without a fault of the validation layer."""

import signal
import time
import unittest

from window import SCENES, View, WindowTest


class ClosingTest(WindowTest):
    def check_end(self, view, what):
        self.assertEqual(view.end(), 0, f"{what}: {(self.folder / 'stderr.txt').read_text(encoding='utf-8')}")
        self.assertNotIn("validation", (self.folder / "stderr.txt").read_text(encoding="utf-8").lower(), what)

    def wait_for_window(self):
        end = time.monotonic() + 60.0
        while not self.screen.windows():
            self.assertLess(time.monotonic(), end, "no window")
            time.sleep(0.02)
        return self.screen.windows()[0]

    def test_closed_at_any_moment(self):
        # Before the first picture, while it is traced, and when all is done.
        for wait in (0.0, 0.1, 0.4, 1.0, 3.0):
            with self.subTest(wait=wait):
                view = View(self.screen, self.folder, SCENES / "every_effect.glb", "--size", "640x360")
                window = self.wait_for_window()
                time.sleep(wait)
                self.screen.ask_to_close(window)
                self.check_end(view, f"closed after {wait} s")

    def test_closed_while_the_camera_moves(self):
        view = View(self.screen, self.folder, SCENES / "every_effect.glb", "--size", "640x360")
        view.wait(lambda state: state["samples"] > 0, "a picture")
        window = self.wait_for_window()
        self.screen.user("mousemove", 200, 200, "mousedown", 1, "mousemove", 260, 220)
        self.screen.ask_to_close(window)
        self.screen.user("mouseup", 1)
        self.check_end(view, "closed in a drag")

    def test_interrupted_while_it_renders(self):
        view = View(self.screen, self.folder, SCENES / "every_effect.glb", "--size", "640x360", "--spp", "256")
        view.wait(lambda state: state["samples"] > 0, "a picture")
        self.screen.point(200, 200)
        self.screen.key("r")
        view.wait(lambda state: state["rendering"], "rendering")
        view.process.send_signal(signal.SIGINT)
        self.check_end(view, "Ctrl-C")


if __name__ == "__main__":
    unittest.main()
