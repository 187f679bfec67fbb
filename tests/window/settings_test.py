"""Panels do what they say; what is rendered and saved is the file that `vernier render` writes."""

import time
import unittest

from window import ROOM, SCENES, SIZE, WindowTest

SMALL = ["--size", f"{SIZE[0]}x{SIZE[1]}"]


def is_alarm(color):
    """Whether it is of what went wrong (kAlarmText), letters' edges included: nothing else in the panels is so red."""
    red, _, blue = color
    return red > 120 and 2 * red > 3 * blue


class SettingsTest(WindowTest):
    def save_as(self, view, name):
        for _ in range(3):  # a machine with other work may lose a key
            view.click("File")
            self.screen.key("ctrl+a")
            time.sleep(0.3)
            self.screen.user("type", "--delay", "30", name)
            self.screen.key("Return")
            view.click("Save")
            end = time.monotonic() + 20.0
            while not (self.folder / name).exists() and time.monotonic() < end:
                time.sleep(0.1)
            if (self.folder / name).exists():
                return
        self.fail(f"{name} is not written; {view.state()}")

    def render(self, view):
        view.click("Render")
        view.wait(lambda state: not state["rendering"] and state["share"] >= 1.0, "all samples")

    def test_settings_change_the_picture(self):
        view = self.open(SCENES / "mirror_pair.glb")
        view.settle()
        before = view.picture()
        view.click("Exposure", 0.7)
        view.settle()
        self.assertGreater(view.picture().mean(), before.mean() + 5.0, "more stops are brighter")
        view.click("Exposure", 0.3)
        view.settle()
        self.assertLess(view.picture().mean(), before.mean() - 5.0, "fewer are darker")

        view.scroll_to("reflection")
        dark = view.picture()
        view.click("reflection", 0.1)
        view.settle("the picture without reflection")
        self.assertGreater(view.picture().difference(dark), 0.01, "mirrors without reflection look otherwise")

    def test_render_and_save_are_the_file_of_render(self):
        scene = SCENES / "glass_ball.glb"
        view = self.open(scene)
        view.settle()
        self.render(view)
        self.save_as(view, "window.exr")
        self.assertEqual(self.run_program("render", scene, *SMALL, "-o", "render.exr")[0], 0)
        self.assertEqual((self.folder / "window.exr").read_bytes(), (self.folder / "render.exr").read_bytes())

    def test_a_turned_camera_is_in_the_recipe_to_the_bit(self):
        view = self.open(SCENES / "transforms.glb", "--spp", "4")
        view.settle()
        self.screen.drag((200, 340), (260, 330))
        view.settle()
        self.render(view)
        self.save_as(view, "turned.exr")
        code, said = self.run_program("rerun", "turned.exr")
        self.assertEqual(code, 0, said)

    def test_a_broken_file_shows_its_message_and_the_scene_stays(self):
        (self.folder / "b.obj").write_text("v 0 0 0\nf 1 2 3\n", encoding="ascii")
        view = self.open(SCENES / "glass_ball.glb")
        view.settle()
        before = view.picture()
        view.click("Open")
        view.click("Path")
        self.screen.user("type", "--delay", "30", "b.obj")
        self.screen.key("Return")
        state = view.wait(lambda state: state["message"], "a message")
        self.assertIn("b.obj", state["message"])
        view.settle()
        self.assertEqual(view.picture().difference(before), 0.0, "the scene before is still there")
        panel = self.screen.picture().part(*ROOM[:1], 0, 340, 300)
        # A line of text has some hundred pixels.
        self.assertGreater(sum(is_alarm(panel.pixel(x, y)) for y in range(300) for x in range(340)), 50,
                           "the message can be read")
        # And another one opens in its place.
        view.click("Open")
        view.click("Path")
        self.screen.key("ctrl+a")
        time.sleep(0.3)
        self.screen.user("type", "--delay", "30", str(SCENES / "mirror_pair.glb"))
        self.screen.key("Return")
        view.wait(lambda state: not state["message"], "no message")
        view.settle()
        self.assertGreater(view.picture().difference(before), 0.05, "the other scene")

    def test_effects_are_measured_in_the_panel(self):
        view = self.open(SCENES / "mirror_pair.glb")
        view.settle()
        before = view.picture()
        view.scroll_to("Measure")
        view.click("Measure")
        view.wait(lambda state: "Costs" in state["places"], "what each effect costs")
        self.assertNotIn("Measuring", view.state()["places"])
        view.settle()
        self.assertEqual(view.picture().difference(before), 0.0, "measuring leaves the picture as it is")

    def test_whoever_goes_on_ends_the_measurement(self):
        view = self.open(SCENES / "every_effect.glb")
        view.settle()
        before = view.picture()
        view.scroll_to("Measure")
        view.click("Measure")
        view.wait(lambda state: "Measuring" in state["places"], "a measurement")
        self.screen.click(200, 340)
        view.wait(lambda state: "Unmeasured" in state["places"], "an end before all are measured")
        self.screen.drag((200, 340), (320, 350))
        view.picture_that(lambda picture: picture.difference(before) > 0.05, "the camera turns")


if __name__ == "__main__":
    unittest.main()
