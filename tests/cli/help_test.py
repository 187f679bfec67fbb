"""Every option of the contract is in the help, with its default; every command has an example."""

import unittest

from program import DONE, ProgramTest

RENDER_DEFAULTS = {
    "--size": "1280x720", "--crop": "the whole image", "--camera": "the first", "--eye": "the camera's",
    "--target": "the camera's", "--up": "the camera's", "--fov": "the camera's", "--view-height": "the camera's", "--light": "the file's",
    "--background": "a soft gradient", "--ambient": "that of the background", "--spp": "16", "--sample-range": "0:spp",
    "--max-bounces": "8", "--cutoff": "1/1024", "--accuracy": "robust", "--filter": "box", "--texture-filter": "file", "--effects": "auto", "--tile": "chosen", "--bvh": "default", "--traversal": "auto",
    "--dispatch-ms": "100", "--time-limit": "none", "--aov": "none", "--device": "the best", "--seed": "0",
    "--exposure": "0", "--strict": "off", "--json": "none", "--checkpoint": "none", "--resume": "none", "--quiet": "off", "--verbose": "off", "--output": "NAME.png",
}
UNITS = {"--size": "pixels", "--crop": "pixels", "--eye": "metres", "--target": "metres", "--fov": "degrees", "--view-height": "metres",
         "--light": "candela", "--dispatch-ms": "milliseconds", "--time-limit": "seconds", "--exposure": "stops",
         "--spp": "samples per pixel", "--background": "linear radiance"}
COMMANDS = ["render", "view", "explain", "cost", "reference", "diff", "merge", "rerun", "devices", "verify"]


def option_texts(text):
    """The help text of each long option, line breaks joined."""
    texts, current = {}, None
    for line in text.splitlines():
        words = line.split()
        if line.startswith("  -"):
            current = next(word for word in words[0].split(",") if word.startswith("--"))
            texts[current] = ""
        elif not line.startswith("   "):
            current = None
        if current:
            texts[current] += " ".join(words) + " "
    return texts


class HelpTest(ProgramTest):
    def help_of(self, *command):
        result = self.run_program(*command, "--help")
        self.assertEqual(result.returncode, DONE)
        self.assertEqual(result.stderr, "")
        return result.stdout

    def test_program_names_its_commands(self):
        text = self.help_of()
        for command in COMMANDS:
            self.assertIn(command, text)

    def test_render_has_every_option_with_its_default(self):
        texts = option_texts(self.help_of("render"))
        for option, default in RENDER_DEFAULTS.items():
            with self.subTest(option=option):
                self.assertIn(f"(default: {default}", texts[option])

    def test_render_tells_units(self):
        texts = option_texts(self.help_of("render"))
        for option, unit in UNITS.items():
            with self.subTest(option=option):
                self.assertIn(unit, texts[option])

    def test_every_option_of_every_command_has_a_default_or_is_required(self):
        for command in COMMANDS:
            for option, text in option_texts(self.help_of(command)).items():
                with self.subTest(command=command, option=option):
                    self.assertTrue(option == "--help" or "(default: " in text or "REQUIRED" in text, text)

    def test_every_command_has_an_example(self):
        for command in COMMANDS:
            self.assertIn(f"Example: vernier {command}", self.help_of(command))

    def test_version(self):
        self.assertRegex(self.check_done("--version").stdout, r"^\d+\.\d+\.\d+\n$")


if __name__ == "__main__":
    unittest.main()
