"""What tools/ray_rates makes of its rounds, its scene of slivers, and where its newer Mesa comes from."""

import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

import tool_path
from benchmarking import ray_table, sliver_scene
from benchmarking.ray_table import ALL_KINDS, EMBREE, KINDS, MEDIUM, QUERY, VERNIER


def turn(**seconds) -> dict:
    """A round in which every kind takes a tracer so many seconds, and twice as many of the CPU."""
    names = {"vernier": VERNIER, "embree": EMBREE, "medium": MEDIUM, "query": QUERY}
    return {names[name]: {kind: {"seconds": one, "cpu_s": 2.0 * one} for kind in KINDS} for name, one in seconds.items()}


class TableTest(unittest.TestCase):
    def test_the_same_rays_in_half_the_time_are_twice_as_many(self):
        found = ray_table.compare([turn(vernier=2.0, embree=1.0, medium=1.5, query=8.0)])
        for measure in ray_table.MEASURES:
            for kind in (*KINDS, ALL_KINDS):
                self.assertAlmostEqual(found[EMBREE][measure][kind]["median"], 0.5)
                self.assertAlmostEqual(found[QUERY][measure][kind]["median"], 4.0)

    def test_ratios_are_of_one_round(self):
        found = ray_table.compare([turn(vernier=2.0, embree=1.0), turn(vernier=20.0, embree=10.0)])
        self.assertEqual(found[EMBREE]["seconds"]["primary"], {"median": 0.5, "least": 0.5, "most": 0.5})
        self.assertNotIn(QUERY, found, "a driver without ray queries")

    def test_kinds_are_summed_up_by_their_geometric_mean(self):
        one = turn(vernier=1.0, embree=1.0)
        one[EMBREE]["primary"]["seconds"] = 16.0
        self.assertAlmostEqual(ray_table.round_ratios(one, EMBREE, "seconds")[ALL_KINDS], 16.0**0.25)

    def test_targets_hang_on_scene_and_peer(self):
        ratios = ray_table.compare([turn(vernier=100.0, embree=41.0, medium=90.0, query=290.0)])
        self.assertEqual(ray_table.missed("48k", EMBREE, ratios[EMBREE]["seconds"]), ["primary", "mirror", "shadow"])
        self.assertEqual(ray_table.missed("slivers", EMBREE, ratios[EMBREE]["seconds"]), [])
        self.assertEqual(ray_table.missed("1M", QUERY, ratios[QUERY]["seconds"]), [ALL_KINDS])
        self.assertEqual(ray_table.verdict("48k", MEDIUM, ratios[MEDIUM]["seconds"]), "")

    def test_rates_and_summary(self):
        rounds = [turn(vernier=0.5, embree=0.25)]
        measured = {"rays": 1_000_000, "passes": 4, "rounds": rounds, "driver": "some driver", "tree": {"triangles": 7},
                    "records": {kind: {"records_per_ray": 9.0, "rounds_per_subgroup": 12.0} for kind in KINDS},
                    "hits": dict.fromkeys(KINDS, 0.25), "differing": {VERNIER: dict.fromkeys(KINDS, 3)}}
        run = {"scene": "48k", "measured": measured, "rates": ray_table.rates(measured), "ratios": ray_table.compare(rounds)}
        self.assertEqual(run["rates"][VERNIER]["mirror"]["median"], 8.0)
        text = ray_table.summary([run])
        self.assertIn("48k: 7 triangles, some driver", text)
        self.assertIn("primary 0.500 (0.500 to 0.500)", text)
        self.assertIn("shadow 0.42: reached", text)
        self.assertIn("diffuse 9.0 (12.0), 0.25", text)
        self.assertIn("Vernier: primary 3, mirror 3", text)


class SliversTest(unittest.TestCase):
    def test_they_are_long_and_thin_and_always_the_same(self):
        body = sliver_scene.slivers(50)
        self.assertEqual(body, sliver_scene.slivers(50))
        self.assertEqual(len(body.triangles), 50)
        for a, b, c in body.triangles:
            base, side = (math.dist(body.positions[a], body.positions[other]) for other in (b, c))
            self.assertAlmostEqual(base, sliver_scene.WIDTH)
            self.assertAlmostEqual(side, math.hypot(sliver_scene.LENGTH, 0.5 * sliver_scene.WIDTH))


# What apt-get is told of sources goes to $SEEN; a package comes from the suite noted in $SUITE alone.
STAND_INS = {
    "apt-get": 'for word in "$@"; do case "$word" in Dir::Etc::sourceparts=*) sources=${word#*=};; Dir::Cache=*) cache=${word#*=};; '
               '-t) next=yes;; *) if [ "${next:-}" ]; then suite=$word; next=; fi;; esac; done; cat "$sources"/* >"$SEEN"; '
               'if [ "${suite:-}" ] && [ "$suite" != "$SUITE" ]; then exit 100; fi; '
               'if [ "${suite:-}" ]; then touch "$cache/archives/mesa.deb"; fi',
    "dpkg": 'mkdir -p "$3/usr/lib/some"; touch "$3/usr/lib/some/libvulkan_lvp.so"',
}


class MesaTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        for name, body in STAND_INS.items():
            path = self.folder / name
            path.write_text(f"#!/bin/bash\n{body}\n", encoding="ascii")
            path.chmod(0o755)
        (self.folder / "etc/apt/sources.list.d").mkdir(parents=True)
        (self.folder / "etc/os-release").write_text("VERSION_CODENAME=sid\n", encoding="ascii")

    def unpack(self, suite: str = "sid-backports") -> subprocess.CompletedProcess:
        environment = dict(os.environ, PATH=f"{self.folder}:{os.environ['PATH']}", SEEN=str(self.folder / "seen"), SUITE=suite)
        return subprocess.run([str(tool_path.ROOT / "tools/benchmarking/unpack_mesa"), str(self.folder / "mesa"), str(self.folder / "etc")],
                              env=environment, text=True, capture_output=True, check=False)

    def source(self, name: str, text: str) -> None:
        (self.folder / "etc/apt" / name).write_text(text, encoding="ascii")

    def test_sources_are_the_machine_s_own_with_a_suite_more(self):
        self.source("sources.list", "# by hand\ndeb [arch=all] archive sid main\ndeb archive sid-security main\n")
        self.source("sources.list.d/other.sources", "Types: deb\nURIs: archive\nSuites: sid sid-updates\nComponents: main\n")
        done = self.unpack()
        self.assertEqual(done.returncode, 0, done.stderr)
        seen = (self.folder / "seen").read_text(encoding="ascii")
        self.assertIn("deb [arch=all] archive sid main\ndeb [arch=all] archive sid-backports main\n", seen)
        self.assertIn("Suites: sid sid-backports sid-updates\n", seen)
        description = json.loads((self.folder / "mesa/lavapipe.json").read_text(encoding="ascii"))
        self.assertEqual(description["ICD"]["library_path"], str(self.folder / "mesa/usr/lib/some/libvulkan_lvp.so"))

    def test_a_second_time_nothing_is_fetched(self):
        self.assertEqual(self.unpack().returncode, 0)
        (self.folder / "seen").unlink()
        self.assertEqual((self.unpack().returncode, self.unpack().stderr), (0, ""))
        self.assertFalse((self.folder / "seen").exists())

    def test_without_backports_there_is_one_line_why(self):
        done = self.unpack(suite="another")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr.splitlines()[-1], "setup: no newer Mesa: sid-backports cannot be reached or has none")
        self.assertFalse((self.folder / "mesa").exists())


if __name__ == "__main__":
    unittest.main()
