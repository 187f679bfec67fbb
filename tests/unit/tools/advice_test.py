"""What the report of `vernier cost` recommends."""

import unittest

import tool_path  # noqa: F401
from reporting import figures


def point(name, time_ms, mean, claimed):
    return {"name": name, "command": name, "claimed_error": claimed, "device_ms": {"median": time_ms},
            "rel_error": {"mean": mean}}


class Advice(unittest.TestCase):
    def best_of(self, *others):
        points = [point("16 spp", 100.0, 0.06, 0.13), *others]
        return figures.recommendation({"settings": {"spp": 16}, "points": points})["best"]["name"]

    def test_less_spread_does_not_make_up_for_bias(self):
        self.assertEqual(self.best_of(point("0 bounces", 70.0, 0.10, 0.12)), "16 spp")

    def test_a_better_mean_does_not_make_up_for_a_worse_claim(self):
        self.assertEqual(self.best_of(point("tent filter", 70.0, 0.05, 0.20)), "16 spp")

    def test_cheaper_and_no_worse_in_both_is_best(self):
        self.assertEqual(self.best_of(point("fast", 80.0, 0.06, 0.13), point("cut-off 1/16", 75.0, 0.06, 0.13)), "cut-off 1/16")

    def test_what_no_option_names_is_not_recommended(self):
        spot = {**point("exact at box", 70.0, 0.05, 0.1), "command": None}
        self.assertEqual(self.best_of(spot), "16 spp")


if __name__ == "__main__":
    unittest.main()
