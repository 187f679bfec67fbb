"""What tools/benchmark makes of its rounds, and the files that it hands to Mitsuba."""

import json
import pathlib
import struct
import tempfile
import unittest

import tool_path  # noqa: F401
from benchmarking import ratios, scene_files, study_scene
from benchmarking.measured_runs import EMBREE, MITSUBA, POVRAY, VERNIER, Measurement


def measured(rays: int, seconds: float, cpu_s: float) -> Measurement:
    return Measurement({"primary": rays}, seconds, rays / seconds, cpu_s)


class RatiosTest(unittest.TestCase):
    ROUND = {VERNIER: measured(600, 2.0, 3.0), POVRAY: measured(500, 5.0, 10.0), EMBREE: measured(4000, 1.0, 2.0),
             MITSUBA: measured(100, 1.0, 2.0)}

    def compare(self, *rounds) -> dict:
        return ratios.compare(ratios.each_round(list(rounds), 100))

    def test_each_peer_is_held_against_by_what_both_count(self):
        found = self.compare(self.ROUND)
        self.assertAlmostEqual(found[POVRAY]["rays_per_s"]["median"], 300 / 100)
        self.assertAlmostEqual(found[POVRAY]["rays_per_cpu_s"]["median"], 200 / 50)
        self.assertAlmostEqual(found[EMBREE]["rays_per_s"]["median"], 300 / 4000)
        # 100 camera samples in 2 seconds against 100 in 1.
        self.assertAlmostEqual(found[MITSUBA]["samples_per_s"]["median"], 0.5)
        self.assertAlmostEqual(found[MITSUBA]["samples_per_cpu_s"]["median"], 2 / 3)
        self.assertAlmostEqual(found["same picture, POV-Ray's trace time over Vernier's"]["median"], 2.5)

    def test_ratios_are_of_one_round(self):
        slow = {name: measured(one.rays["primary"], 10.0 * one.seconds, 10.0 * one.cpu_s) for name, one in self.ROUND.items()}
        spread = self.compare(self.ROUND, slow)[POVRAY]["rays_per_s"]
        self.assertAlmostEqual(spread["least"], spread["most"], msg="a machine that slows down slows all")

    def test_without_mitsuba_nothing_is_said_of_it(self):
        short = {name: one for name, one in self.ROUND.items() if name != MITSUBA}
        found = self.compare(short)
        self.assertNotIn(MITSUBA, found)
        self.assertEqual([peer.name for peer in ratios.peers_of(found)], [POVRAY, EMBREE])

    def test_the_summary_says_what_was_reached(self):
        found = self.compare(self.ROUND)
        rate = {"median": 1e6, "least": 1e6, "most": 1e6}
        text = ratios.summary({name: {"rays": {}, "rays_per_s": rate, "rays_per_cpu_s": rate} for name in self.ROUND}, found)
        self.assertIn("Vernier / Mitsuba, samples: 0.500", text)
        self.assertIn("target 0.8 missed", text)
        self.assertIn("Vernier / POV-Ray, rays: 3.000", text)


class MitsubaFilesTest(unittest.TestCase):
    def test_meshes_hold_all_bodies_of_their_surface(self):
        bodies = study_scene.make_bodies(9000)
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            scene_files.write_mitsuba(bodies, folder)
            surfaces = json.loads((folder / "mitsuba.json").read_text())["surfaces"]
            self.assertEqual(surfaces.keys(), {body.surface.name for body in bodies})
            for surface in surfaces:
                self.check_mesh((folder / f"{surface}.ply").read_bytes(), [body for body in bodies if body.surface.name == surface])

    def check_mesh(self, content: bytes, bodies: list):
        header, _, rest = content.partition(b"end_header\n")
        vertices, triangles = (sum(len(getattr(body, part)) for body in bodies) for part in ("positions", "triangles"))
        self.assertIn(f"element vertex {vertices}\n".encode(), header)
        self.assertIn(f"element face {triangles}\n".encode(), header)
        self.assertEqual(len(rest), 24 * vertices + 13 * triangles)
        for got, want in zip(struct.unpack_from("<6f", rest), (*bodies[0].positions[0], *bodies[0].normals[0])):
            self.assertAlmostEqual(got, want, places=5)
        last = struct.unpack_from("<B3I", rest, len(rest) - 13)
        start = vertices - len(bodies[-1].positions)
        self.assertEqual(last, (3, *(start + corner for corner in bodies[-1].triangles[-1])))

    def test_surfaces_are_the_nearest_there_are(self):
        kinds = {surface.name: scene_files.mitsuba_surface(surface)["type"] for surface in (study_scene.GROUND, *study_scene.SPHERES)}
        self.assertEqual(kinds, {"ground": "diffuse", "plastic": "roughplastic", "mirror": "conductor", "glass": "dielectric"})


if __name__ == "__main__":
    unittest.main()
