"""A file that is dragged here from another program is opened; one that is broken leaves the scene as it is."""

import shutil
import subprocess
import unittest
from pathlib import Path

from window import SCENES, WindowTest

SOURCE = Path(__file__).with_name("drop_source.py")


class DropTest(WindowTest):
    def drop(self, path):
        done = subprocess.run([SOURCE, self.screen.name, str(self.screen.windows()[0]), "200", "300", path],
                              capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_dropped_file_is_opened(self):
        view = self.open(SCENES / "glass_ball.glb")
        view.settle()
        before = view.picture()
        # A name that is not the same as a URI.
        dropped = self.folder / "mirror pair, 100 % é.glb"
        shutil.copy(SCENES / "mirror_pair.glb", dropped)
        self.drop(dropped)
        opened = view.picture_that(lambda picture: picture.difference(before) > 0.05, "the dropped scene")

        broken = self.folder / "broken.glb"
        broken.write_bytes(b"glTF, but not really")
        self.drop(broken)
        state = view.wait(lambda state: state["message"], "a message")
        self.assertIn("broken.glb", state["message"])
        view.settle()
        self.assertEqual(view.picture().difference(opened), 0.0, "the scene before is still there")


if __name__ == "__main__":
    unittest.main()
