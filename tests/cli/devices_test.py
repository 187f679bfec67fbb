"""vernier devices, and --device."""

import json
import unittest

from program import NO_DEVICE, SCENE, SMALL, ProgramTest


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

    def test_no_driver_at_all(self):
        nothing = {"VK_DRIVER_FILES": str(self.folder / "nothing.json"), "VK_ICD_FILENAMES": ""}
        self.check_error(NO_DEVICE, "", "render", SCENE, "-o", "out.png", *SMALL, environment=nothing)


if __name__ == "__main__":
    unittest.main()
