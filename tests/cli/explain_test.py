"""vernier explain: the effects of a scene, as a table and as JSON."""

import json
import unittest

from program import NO_DEVICE, SCENE, SMALL, TRIANGLE_OBJ, USAGE, ProgramTest

EFFECT_COUNT = 25
FIXED_COUNT = 3
NOWHERE = {"VK_DRIVER_FILES": "/nonexistent.json", "VK_ICD_FILENAMES": "/nonexistent.json"}


class ExplainTest(ProgramTest):
    def check_report(self, result):
        """The table and effects.json say the same; the object."""
        report = json.loads((self.folder / "effects.json").read_text())
        self.assertEqual(report["schema"], 1)
        self.assertEqual(len(report["effects"]), EFFECT_COUNT)
        for effect in report["effects"]:
            word = "on " if effect["on"] else "off"
            self.assertRegex(result.stdout, rf"(?m)^{word} +{effect['name']} ")
            self.assertIn(effect["reason"], result.stdout)
        self.assertEqual(len(report["fixed"]), FIXED_COUNT)
        for one in report["fixed"]:
            self.assertRegex(result.stdout, rf"(?m)^{'on ' if one['on'] else 'off'} +{one['name']} ")
        depth = report["depth"]
        self.assertIn(f"depth needed: {depth['bounces']} of {depth['allowed']} bounces, {depth['reason']}", result.stdout)
        return report

    def explain(self, *arguments):
        result = self.check_done("explain", *arguments, "--no-costs", "--json", "effects.json")
        report = self.check_report(result)
        self.assertEqual(len(result.stdout.splitlines()), EFFECT_COUNT + 1 + 1 + FIXED_COUNT + 1)
        return {effect["name"]: effect["on"] for effect in report["effects"]}

    def test_the_scene_is_no_place_for_the_json(self):
        scene = self.write("triangle.obj", TRIANGLE_OBJ)
        self.check_error(USAGE, "--json: it names the same file as SCENE", "explain", scene, "--no-costs", "--json", scene)

    def test_options_of_render(self):
        self.write("triangle.obj", TRIANGLE_OBJ)
        frames = []
        for options in ([], ["--bvh", "fast", "--texture-filter", "nearest"], ["--filter", "tent"]):
            self.check_done("explain", "triangle.obj", *SMALL, "--quiet", "--json", "effects.json", *options)
            frames.append(json.loads((self.folder / "effects.json").read_text())["frame"]["rays"])
        self.assertEqual(len(set(frames)), 1, "one sample lies in the middle of its pixel")

    def test_costs_are_those_of_what_is_on(self):
        self.write("triangle.obj", TRIANGLE_OBJ)
        result = self.check_done("explain", "triangle.obj", *SMALL, "--quiet", "--json", "effects.json")
        self.assertEqual(result.stderr, "")
        report = self.check_report(result)
        self.assertEqual([effect["cost"] is not None for effect in report["effects"]],
                         [effect["on"] for effect in report["effects"]])
        costs = {effect["name"]: effect["cost"] for effect in report["effects"] if effect["on"]}
        rays = report["frame"]["rays"]
        self.assertEqual(report["frame"]["size"], [24, 16])
        self.assertEqual(sum(bounce["rays"] for bounce in report["bounces"]), rays)
        self.assertEqual(report["depth"]["bounces"], 0)
        self.assertGreater(report["saved_memory"]["path_stack_bytes"], 0)
        self.assertGreater(report["saved_memory"]["aov_bytes"], 0)
        self.assertEqual(costs["shadows"]["rays"], rays - 24 * 16, "all but the camera rays")
        self.assertEqual(costs["shadows"]["rmse"], 0.0, "nothing casts a shadow here")
        self.assertGreater(costs["directional_lights"]["rmse"], 0.0)
        self.assertGreater(costs["directional_lights"]["flip_mean"], 0.0)
        self.assertEqual(costs["ambient"]["rays"], 0)
        for cost in costs.values():
            self.assertLessEqual(cost["least_share"], cost["share"])
            self.assertLessEqual(cost["share"], cost["most_share"])
        self.assertLessEqual(report["all_effects"]["least"], report["all_effects"]["most"])

    def test_an_effect_takes_those_along_that_need_it(self):
        self.check_done("explain", SCENE, *SMALL, "--effects", "shadows,tinted_shadows,directional_lights,refraction",
                        "--quiet", "--json", "effects.json")
        effects = json.loads((self.folder / "effects.json").read_text())["effects"]
        without = {effect["name"]: effect["cost"]["without"] for effect in effects if effect["on"]}
        self.assertEqual(without["shadows"], ["shadows", "tinted_shadows"])
        self.assertEqual(without["tinted_shadows"], ["tinted_shadows"])

    def test_without_a_device_all_but_the_costs_is_told(self):
        result = self.run_program("explain", SCENE, "--json", "effects.json", environment=NOWHERE)
        self.assertEqual(result.returncode, NO_DEVICE, result.stderr)
        self.assertIn("error: costs need a device", result.stderr)
        report = self.check_report(result)
        self.assertIsNone(report["frame"])
        self.assertTrue(all(effect["cost"] is None for effect in report["effects"]))
        told = self.check_done("explain", SCENE, "--no-costs", environment=NOWHERE)
        self.assertEqual(told.stdout, result.stdout)

    def test_glass_refracts_until_bounces_are_off(self):
        self.assertTrue(self.explain(SCENE)["refraction"])
        self.assertTrue(self.explain(SCENE)["reflection"])
        self.assertFalse(self.explain(SCENE, "--max-bounces", "0")["reflection"])

    def test_triangle_is_lit_by_default_and_needs_no_bounces(self):
        self.write("triangle.obj", TRIANGLE_OBJ)
        effects = self.explain("triangle.obj")
        self.assertTrue(effects["directional_lights"])
        self.assertTrue(effects["shadows"])
        self.assertFalse(effects["refraction"])
        self.assertFalse(effects["base_color_texture"])

    def test_light_option_replaces_the_lights(self):
        self.write("triangle.obj", TRIANGLE_OBJ)
        effects = self.explain("triangle.obj", "--light", "point:0,0,2:1,1,1", "--light", "point:1,0,2:1,1,1")
        self.assertTrue(effects["point_lights"])
        self.assertFalse(effects["directional_lights"])

    def test_effects_option(self):
        effects = self.explain(SCENE, "--effects", "auto,-shadows")
        self.assertFalse(effects["shadows"])
        self.assertFalse(effects["tinted_shadows"])
        self.assertTrue(all(self.explain(SCENE, "--effects", "all").values()))


if __name__ == "__main__":
    unittest.main()
