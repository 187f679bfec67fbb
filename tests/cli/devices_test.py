"""vernier devices, and --device."""

import json
import unittest

from program import NO_DEVICE, SCENE, SMALL, USAGE, ProgramTest


class DevicesTest(ProgramTest):
    def test_table_and_json(self):
        result = self.check_done("devices", "--json", "devices.json")
        report = json.loads((self.folder / "devices.json").read_text())
        self.assertEqual(report["schema"], 1)
        self.assertGreaterEqual(len(report["devices"]), 1)
        for device in report["devices"]:
            self.assertIn(device["name"], result.stdout)
            self.assertTrue({"driver", "api_version", "usable", "probe"} <= device.keys())
        self.assertTrue(any(device["probe"] for device in report["devices"]))

    def test_device_that_is_not_there(self):
        for device in ["99", "no such device"]:
            self.check_error(NO_DEVICE, device, "render", SCENE, "-o", "out.png", "--device", device, *SMALL)
        self.assertEqual(self.files(), [])

    def test_calibrating_keeps_a_form_that_auto_takes(self):
        cache = {"VERNIER_PIPELINE_CACHE": str(self.folder / "cache")}
        result = self.check_done("devices", "--calibrate", "--quiet", "--device", "0", "--json", "d.json", environment=cache)
        found = json.loads((self.folder / "d.json").read_text())["calibration"]
        forms = {form["form"]: form for form in found["forms"]}
        self.assertEqual(len(forms), 5)
        usual = forms[found["usual"]]["over_usual"]
        self.assertTrue(usual["least"] <= usual["median"] <= usual["most"], usual)
        self.assertEqual(forms[found["best"]]["left_out"], "")
        for form in forms.values():
            self.assertEqual(form["left_out"] == "", form["over_usual"] is not None, form)
            self.assertNotIn("another picture", form["left_out"])
        self.assertIn("--traversal auto is " + found["best"], result.stdout)
        file, = (self.folder / "cache").glob("*.traversal")
        self.assertEqual(file.read_text(), found["best"] + "\n")

        for said, taken in [("storage-array", "storage-array"), ("no form", found["usual"])]:
            file.write_text(said + "\n")
            self.check_done("render", SCENE, "-o", "out.png", "--device", "0", "--json", "out.json", *SMALL, environment=cache)
            self.assertEqual(json.loads((self.folder / "out.json").read_text())["traversal"], taken)

    def test_device_is_for_calibrating(self):
        self.check_error(USAGE, "--calibrate", "devices", "--device", "0")

    def test_no_driver_at_all(self):
        nothing = {"VK_DRIVER_FILES": str(self.folder / "nothing.json"), "VK_ICD_FILENAMES": ""}
        self.check_error(NO_DEVICE, "", "render", SCENE, "-o", "out.png", *SMALL, environment=nothing)


if __name__ == "__main__":
    unittest.main()
