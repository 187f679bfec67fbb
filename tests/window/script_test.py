"""`vernier view --record DIR --script FILE` replays events and takes screenshots."""

import unittest

from window import SCENES, SIZE, WindowTest

SCRIPT = """
# The first picture, another view, another layer, all samples.
settle
shot first
move 200 340
press left
move 320 350
release left
settle
shot turned
set Show 2
wait 0.3
shot normals
set Show 0
drop broken.glb
wait 0.5
shot broken
click Render
settle
set File picture.png
click Save
wait 0.3
shot rendered
"""


def png_size(path):
    header = path.read_bytes()[:24]
    assert header[:8] == b"\x89PNG\r\n\x1a\n", path
    return int.from_bytes(header[16:20], "big"), int.from_bytes(header[20:24], "big")


class ScriptTest(WindowTest):
    def replay(self, script, *arguments, scene=SCENES / "glass_ball.glb"):
        (self.folder / "script.txt").write_text(script, encoding="ascii")
        return self.run_program("view", scene, "--size", f"{SIZE[0]}x{SIZE[1]}", "--script", "script.txt",
                                "--record", "shots", *arguments)

    def test_screenshots_of_a_session(self):
        (self.folder / "broken.glb").write_bytes(b"glTF, but not really")
        code, said = self.replay(SCRIPT)
        self.assertEqual(code, 0, said)
        shots = {name: self.folder / "shots" / f"{name}.png" for name in ("first", "turned", "normals", "broken", "rendered")}
        self.assertEqual({path.name for path in (self.folder / "shots").iterdir()}, {path.name for path in shots.values()})
        for path in shots.values():
            self.assertEqual(png_size(path), (820, 680), path)
        self.assertEqual(len({path.read_bytes() for path in shots.values()}), len(shots), "each shows something else")
        self.assertTrue((self.folder / "picture.png").exists())
        self.assertIn("first picture after", said)

    def test_a_lost_device_is_told_of_and_opened_anew(self):
        code, said = self.replay("settle\nlose-device\nsettle\nshot after\n", "--places", "places.json")
        self.assertEqual(code, 0, said)
        self.assertIn("the device was lost", (self.folder / "places.json").read_text(encoding="utf-8"))
        self.assertTrue((self.folder / "shots" / "after.png").exists())

    def test_a_saved_picture_takes_no_place_of_a_texture(self):
        self.run_program("render", SCENES / "glass_ball.glb", "--size", "8x8", "--spp", "1", "-o", "texture.png")
        texture = (self.folder / "texture.png").read_bytes()
        (self.folder / "a.obj").write_text("mtllib a.mtl\nusemtl a\nvt 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/1 3/1\n")
        (self.folder / "a.mtl").write_text("newmtl a\nmap_Kd texture.png\n")
        code, said = self.replay("settle\nset File texture.png\nclick Save\nwait 0.5\n", "--places", "places.json", scene="a.obj")
        self.assertEqual(code, 0, said)
        self.assertIn("a file of the scene", (self.folder / "places.json").read_text(encoding="utf-8"))
        self.assertEqual((self.folder / "texture.png").read_bytes(), texture)

    def test_sizes_that_no_window_shows(self):
        code, said = self.replay("settle\nset Size 8192x8192\n")
        self.assertEqual(code, 2, said)
        self.assertIn("pixels in a window", said)

    def test_mistakes_are_told_before_a_window_opens(self):
        for script, part in (("jump\n", "line 1: there is no event `jump`"), ("wait\n", "needs more words")):
            code, said = self.replay(script)
            self.assertEqual(code, 2)
            self.assertIn(part, said)
            self.assertEqual(len(said.splitlines()), 1, said)

    def test_a_broken_first_scene_is_refused(self):
        (self.folder / "broken.glb").write_bytes(b"glTF, but not really")
        code, said = self.run_program("view", "broken.glb")
        self.assertEqual(code, 3)
        self.assertIn("broken.glb", said)

    def test_pictures_that_no_window_shows(self):
        for size, reason in (("65536x16", "pixels a side on this device"), ("32768x2048", "pixels in a window")):
            code, said = self.run_program("view", SCENES / "glass_ball.glb", "--size", size)
            self.assertEqual(code, 2, said)
            self.assertIn("--size: at most", said)
            self.assertIn(reason, said)


if __name__ == "__main__":
    unittest.main()
