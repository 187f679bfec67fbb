"""vernier explain: the effects of a scene, as a table and as JSON."""

import json
import unittest

from program import SCENE, TRIANGLE_OBJ, ProgramTest

EFFECT_COUNT = 25


class ExplainTest(ProgramTest):
    def explain(self, *arguments):
        result = self.check_done("explain", *arguments, "--json", "effects.json")
        report = json.loads((self.folder / "effects.json").read_text())
        self.assertEqual(report["schema"], 1)
        self.assertEqual(len(report["effects"]), EFFECT_COUNT)
        for effect in report["effects"]:
            word = "on " if effect["on"] else "off"
            self.assertRegex(result.stdout, rf"(?m)^{word} +{effect['name']} ")
            self.assertIn(effect["reason"], result.stdout)
        self.assertEqual(len(result.stdout.splitlines()), EFFECT_COUNT + 1)
        return {effect["name"]: effect["on"] for effect in report["effects"]}

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
