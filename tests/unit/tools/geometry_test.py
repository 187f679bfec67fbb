"""The comparison with a geometric reference counts each kind of difference by itself."""

import math
import unittest

import tool_path  # noqa: F401
from model_runs.geometry_check import compare, geometry_faults

COUNT = 1000


def images(depth=2.0, normal=(0.0, 0.0, -1.0), lit=1.0, told=1.0):
    """The lit, the dark and the shadowless picture of 1000 pixels that agree with REFERENCE but for what is given; the
    last 100 are misses."""
    hit = COUNT - 100
    channels = {"depth.Z": [depth] * hit + [math.inf] * 100}
    for axis, value in zip("XYZ", normal):
        channels[f"normal.{axis}"] = [value] * hit + [0.0] * 100
    shown = {**channels, **{channel: [0.5 + lit] * hit + [0.0] * 100 for channel in "RGB"}}
    dark = {channel: [0.5] * hit + [0.0] * 100 for channel in "RGB"}
    return shown, dark, {channel: [0.5 + told] * hit + [0.0] * 100 for channel in "RGB"}


REFERENCE = {"hit": ((COUNT,), (True,) * 900 + (False,) * 100), "t": ((COUNT,), (2.0,) * 900 + (math.inf,) * 100),
             "ng": ((COUNT, 3), (0.0, 0.0, 1.0) * COUNT), "shadow_lit": ((COUNT,), (True,) * 900 + (False,) * 100)}


class Geometry(unittest.TestCase):
    def test_agreement_up_to_the_sign_of_normals(self):
        shares = compare(REFERENCE, *images())
        self.assertEqual(shares, {"mask": 0.0, "depth": 1.0, "normal": 1.0, "shadow": 0.0, "told": 1.0})
        self.assertEqual(geometry_faults(shares), [])

    def test_each_difference_is_seen(self):
        for change, word in (({"depth": 2.01}, "depth"), ({"normal": (0.0, 1.0, 0.0)}, "normal"), ({"lit": 0.0}, "shadow")):
            faults = geometry_faults(compare(REFERENCE, *images(**change)))
            self.assertEqual([fault.split()[0] for fault in faults], [word])

    def test_what_no_light_changes_says_nothing_of_shadows(self):
        shares = compare(REFERENCE, *images(lit=0.0, told=0.0))
        self.assertEqual((shares["shadow"], shares["told"]), (0.0, 0.0))
        self.assertEqual(geometry_faults(shares), [])

    def test_depth_within_its_tolerance(self):
        self.assertEqual(geometry_faults(compare(REFERENCE, *images(depth=2.0019))), [])

    def test_hit_mask(self):
        lit, dark, shadowless = images()
        lit["depth.Z"][:4] = [math.inf] * 4
        self.assertEqual(geometry_faults(compare(REFERENCE, lit, dark, shadowless)), ["hit mask differs on 0.40%"])


if __name__ == "__main__":
    unittest.main()
