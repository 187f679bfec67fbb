"""The picture comes, follows mouse and keys, and keeps its sides when the window does not."""

import subprocess
import time
import unittest
from pathlib import Path

from screen import Screen
from window import PANEL, ROOM, SCENES, SIZE, SURROUND, WindowTest

# The scene fills 40 % of the room: in a picture of another view over an eighth of its pixels are others.
OTHER_VIEW = 0.05


class PictureTest(WindowTest):
    def test_first_picture_orbit_and_keys(self):
        view = self.open(SCENES / "every_effect.glb")
        view.settle("the first picture")
        first = view.picture()
        self.assertGreater(first.colors(), 1000, "a rendered scene, not a plain window")

        self.screen.drag((200, 340), (320, 350))
        turned = view.picture_that(lambda picture: picture.difference(first) > OTHER_VIEW, "a drag turns the camera")

        self.screen.point(240, 340)
        self.screen.key("f")
        view.picture_that(lambda picture: picture.difference(turned) > OTHER_VIEW, "F frames all")

        self.screen.key("1")
        view.picture_that(lambda picture: picture.difference(first) == 0.0, "1 is the file's first camera, as at the start")

        self.screen.key("w")
        view.picture_that(lambda picture: picture.difference(first) > OTHER_VIEW, "W walks forward")

    def test_resized_windows_keep_the_aspect(self):
        view = self.open(SCENES / "glass_ball.glb", "--background", "0.5,0.2,0.1")
        view.settle("the first picture")
        for size in ((900, 500), (600, 600), (500, 180)):
            with self.subTest(size=size):
                self.screen.user("windowsize", self.screen.windows()[0], *size)
                time.sleep(1.0)
                room = self.screen.picture().part(0, 0, size[0] - PANEL, size[1])
                left, top, width, height = room.bounds_of_other_than(SURROUND)
                # Either side is rounded to whole pixels.
                self.assertAlmostEqual(width / SIZE[0], height / SIZE[1], delta=1.0 / SIZE[1])
                self.assertTrue(width == room.width or height == room.height, "as large as there is room")
                self.assertAlmostEqual(left, room.width - width - left, delta=1)
                self.assertAlmostEqual(top, room.height - height - top, delta=1)
    def test_dense_screens_get_larger_panels_and_a_larger_window(self):
        dense = Screen(2560, 1440)
        self.addCleanup(dense.close)
        subprocess.run([Path(__file__).with_name("set_text_dpi.py"), dense.name, "192"], check=True, timeout=60)
        plain = self.open(SCENES / "mirror_pair.glb")
        button = plain.settle()["places"]["Render"]
        self.close(plain)
        scaled = self.open_on(dense, SCENES / "mirror_pair.glb")
        left, top, width, height = scaled.settle()["places"]["Render"]
        self.assertAlmostEqual(width, 2 * button[2], delta=2)
        self.assertAlmostEqual(height, 2 * button[3], delta=2)
        self.assertAlmostEqual(top, 2 * button[1], delta=2)
        self.assertGreater(left, 2 * ROOM[0], "right of the room for the picture: the window has grown with its panels")


if __name__ == "__main__":
    unittest.main()
