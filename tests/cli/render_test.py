"""vernier render: files, statistics, determinism."""

import base64
import hashlib
import json
import re
import resource
import shlex
import struct
import unittest

from program import DONE, FAILED, REFUSED, SCENE, SMALL, TRIANGLE_OBJ, ProgramTest

FIELDS = {"schema", "scene", "device", "driver", "size", "spp", "accuracy", "triangles", "instances", "materials", "textures",
          "bvh", "load_ms", "upload_ms", "compile_ms", "trace_device_ms", "trace_wall_ms", "rays", "rays_per_s", "effects",
          "non_finite_pixels", "stack_overflows", "error_estimate", "peak_memory", "warnings"}


class RenderTest(ProgramTest):
    def bytes_of(self, name, *arguments):
        self.check_done("render", SCENE, "-o", name, *SMALL, *arguments)
        return (self.folder / name).read_bytes()

    def test_statistics_follow_schema_1(self):
        self.check_done("render", SCENE, "-o", "out.exr", "--json", "out.json", *SMALL)
        report = json.loads((self.folder / "out.json").read_text())
        self.assertEqual(FIELDS - report.keys(), set())
        self.assertEqual(report["schema"], 1)
        self.assertEqual(report["scene"], SCENE)
        self.assertEqual(report["size"], [24, 16])
        self.assertEqual(report["bvh"].keys(), {"nodes", "bytes", "sah_cost", "depth", "build_ms"})
        self.assertEqual(report["rays"].keys(), {"primary", "shadow", "reflection", "refraction"})
        self.assertEqual(report["rays"]["primary"], 24 * 16)
        self.assertGreater(report["rays"]["refraction"], 0)
        self.assertEqual(report["peak_memory"].keys(), {"host_bytes", "device_bytes"})
        # The largest of all programs that this one has run so far.
        largest = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024
        self.assertGreater(report["peak_memory"]["host_bytes"], 1 << 20)
        self.assertLessEqual(report["peak_memory"]["host_bytes"], largest)
        self.assertGreater(report["peak_memory"]["device_bytes"], report["bvh"]["bytes"])
        self.assertEqual(report["saved_memory"].keys(), {"path_stack_bytes", "sample_cost_bytes", "aov_bytes"})
        self.assertEqual(report["saved_memory"]["aov_bytes"], 24 * 16 * 19 * 4)
        self.assertAlmostEqual(sum(report["pipelines"].values()), report["compile_ms"], places=6)
        self.assertEqual(report["pipelines"].keys(), {"trace", "accumulate", "first dispatch"})
        for name in ["triangles", "instances", "materials", "textures", "load_ms", "upload_ms", "compile_ms",
                     "trace_device_ms", "trace_wall_ms", "rays_per_s"]:
            self.assertGreater(report[name], 0, name)
        self.assertTrue(all(value > 0 for value in report["bvh"].values()), report["bvh"])
        self.assertIsNone(report["error_estimate"])
        self.assertEqual(report["non_finite_pixels"], 0)
        self.assertEqual(len(report["effects"]), 25)
        self.assertEqual(self.files(), ["out.exr", "out.json"])

    def test_two_runs_make_the_same_bytes(self):
        self.assertEqual(self.bytes_of("a.exr"), self.bytes_of("b.exr"))
        self.assertEqual(self.bytes_of("a.png"), self.bytes_of("b.png", "--tile", "8x8"))

    def test_no_form_of_traversal_changes_a_bit(self):
        plain = self.bytes_of("auto.hdr")  # holds no metadata
        for form in ["texels-shifted", "texels-array", "storage-shifted", "storage-array"]:
            self.assertEqual(self.bytes_of(form + ".hdr", "--traversal", form), plain, form)
        self.bytes_of("form.exr", "--traversal", "storage-array")
        self.check_done("rerun", "form.exr")

    def test_no_width_of_the_driver_s_vectors_changes_a_bit(self):
        plain = self.bytes_of("auto.exr")
        for bits in [128, 256, 512]:
            environment = {"MESA_SHADER_CACHE_DIR": str(self.folder / "cache"), "LP_NATIVE_VECTOR_WIDTH": str(bits),
                           "MESA_SHADER_CACHE_DISABLE": "false"}
            self.check_done("devices", "--json", "devices.json", environment=environment)
            device = json.loads((self.folder / "devices.json").read_text())["devices"][0]
            self.assertEqual(device["subgroup_size"], bits // 32)
            self.check_done("render", SCENE, "-o", "other.exr", *SMALL, environment=environment)
            self.assertEqual((self.folder / "other.exr").read_bytes(), plain, bits)
        # Kernels that the driver keeps of one width may not be run for another.
        kept = [list((self.folder / f"cache/vernier/mesa-{bits}-bits").iterdir()) for bits in [128, 256, 512]]
        self.assertTrue(all(kept), kept)

    def test_ray_queries_draw_the_same_or_are_refused(self):
        self.check_done("devices", "--json", "devices.json")
        devices = json.loads((self.folder / "devices.json").read_text())["devices"]
        arguments = ["render", SCENE, "-o", "query.hdr", "--device", "0", "--traversal", "ray-query", *SMALL]
        if devices[0]["ray_query"]:
            self.check_done(*arguments)
            self.check_done("render", SCENE, "-o", "plain.hdr", "--device", "0", *SMALL)
            self.assertEqual((self.folder / "query.hdr").read_bytes(), (self.folder / "plain.hdr").read_bytes())
        else:
            self.check_error(REFUSED, "no ray queries", *arguments)
            self.check_error(REFUSED, "no ray queries", "verify", "--device", "0", "--traversal", "ray-query")

    def test_seed_and_effects_change_the_picture(self):
        plain = self.bytes_of("a.hdr")  # holds no metadata
        self.assertNotEqual(plain, self.bytes_of("b.hdr", "--effects", "auto,-refraction"))
        for name, seed in [("c.hdr", "0"), ("d.hdr", "1")]:
            self.check_done("render", SCENE, "-o", name, "--size", "24x16", "--spp", "2", "--seed", seed)
        self.assertNotEqual((self.folder / "c.hdr").read_bytes(), (self.folder / "d.hdr").read_bytes())
        self.assertEqual(plain, self.bytes_of("e.hdr", "--effects", "all"))

    def test_default_names(self):
        self.write("triangle.obj", TRIANGLE_OBJ)
        self.check_done("render", "triangle.obj", *SMALL)
        self.assertEqual(self.files(), ["triangle.obj", "triangle.png"])
        self.check_done("render", *SMALL)
        self.assertIn("vernier.png", self.files())

    def test_aovs_of_other_formats_are_files(self):
        self.check_done("render", SCENE, "-o", "out.png", "--aov", "depth,normal,object_id", *SMALL)
        self.assertEqual(self.files(), ["out.depth.png", "out.normal.png", "out.object_id.png", "out.png"])

    def test_png_holds_the_recipe(self):
        data = self.bytes_of("out.png", "--seed", "7")
        for part in [b"vernier:options", b"vernier:scene_sha1", b"vernier:device", b"vernier:spirv_hash"]:
            self.assertIn(part, data)

    def test_the_hash_of_the_scene_covers_the_files_it_refers_to(self):
        text = "mtllib a.mtl\nusemtl m\n" + TRIANGLE_OBJ
        self.write("triangle.obj", text)
        for materials in ["newmtl m\nKd 1 0 0\n", "newmtl m\nKd 0 1 0\n"]:
            self.write("a.mtl", materials)
            digest = hashlib.sha1((text + materials).encode()).hexdigest()
            for command in ["render", "reference"]:
                self.check_done(command, "triangle.obj", "-o", "out.exr", *SMALL)
                self.assertIn(digest.encode(), (self.folder / "out.exr").read_bytes())

    def test_summary_and_quiet(self):
        result = self.check_done("render", SCENE, "-o", "out.png", *SMALL)
        self.assertEqual(result.stdout, "")
        self.assertRegex(result.stderr, r"(?m)^out\.png: 24x16, 1 sample, .* [kM]rays/s$")
        quiet = self.check_done("render", SCENE, "-o", "out.png", "--quiet", *SMALL)
        self.assertEqual(quiet.stdout + quiet.stderr, "")
        verbose = self.check_done("render", SCENE, "-o", "out.png", "--verbose", *SMALL)
        self.assertRegex(verbose.stderr, r"(?m)^on +refraction ")

    def test_costs_are_a_heat_map_with_a_legend(self):
        legend = r"cost: black 0 to pale yellow ([0-9.]+) node visits and triangle tests per sample .* largest ([0-9.]+)"
        result = self.check_done("render", SCENE, "-o", "out.png", "--aov", "cost", *SMALL)
        self.assertEqual(self.files(), ["out.cost.png", "out.png"])
        found = re.search(legend, result.stderr)
        self.assertIsNotNone(found, result.stderr)
        self.assertLessEqual(float(found[1]), float(found[2]))
        self.assertIn(b"vernier:cost_legend", (self.folder / "out.cost.png").read_bytes())
        self.assertNotIn("cost:", self.check_done("render", SCENE, "-o", "out.png", *SMALL).stderr)

    def test_effect_runs_are_told_when_asked_for(self):
        self.check_done("render", SCENE, "-o", "out.png", "--json", "out.json", "--count-effects", *SMALL)
        report = json.loads((self.folder / "out.json").read_text())
        self.assertEqual({name: count > 0 for name, count in report["effect_runs"].items()}, report["effects"])
        depths = report["rays_by_depth"]
        self.assertEqual(depths[0]["path"], report["rays"]["primary"])
        self.assertEqual(sum(depth["shadow"] for depth in depths), report["rays"]["shadow"])
        self.check_done("render", SCENE, "-o", "out.png", "--json", "out.json", *SMALL)
        self.assertNotIn("effect_runs", json.loads((self.folder / "out.json").read_text()))

    def test_compiled_pipelines_are_kept_and_no_fault_of_their_file_is_an_error(self):
        place = {"VERNIER_PIPELINE_CACHE": str(self.folder / "kept")}
        arguments = ["render", SCENE, "-o", "out.hdr", "--verbose", *SMALL]
        first = self.check_done(*arguments, environment=place)
        self.assertRegex(first.stderr, r"(?m)^pipelines: trace [0-9.]+ ms, .*not there yet, \d+ bytes written$")
        self.assertRegex(first.stderr, r"(?m)^not allocated: path stack [0-9.]+ MiB, .*AOVs [0-9.]+ MiB$")
        picture = (self.folder / "out.hdr").read_bytes()
        [kept] = (self.folder / "kept").iterdir()
        self.assertRegex(self.check_done(*arguments, environment=place).stderr, r"\d+ bytes read")
        for damage in [b"", b"nonsense", kept.read_bytes()[:-1]]:
            kept.write_bytes(damage)
            self.assertRegex(self.check_done(*arguments, environment=place).stderr, r"cut short, \d+ bytes written")
            self.assertEqual((self.folder / "out.hdr").read_bytes(), picture)
        off = self.check_done(*arguments, environment={"VERNIER_PIPELINE_CACHE": "none"})
        self.assertIn("no file of compiled pipelines", off.stderr)
        (self.folder / "in_the_way").write_text("")
        nowhere = self.check_done(*arguments, environment={"VERNIER_PIPELINE_CACHE": str(self.folder / "in_the_way")})
        self.assertIn("not written", nowhere.stderr)

    def test_hint_for_a_picture_that_is_too_bright(self):
        self.write("triangle.obj", TRIANGLE_OBJ)
        bright = ["render", "triangle.obj", "-o", "out.png", "--background", "8,8,8", *SMALL]
        self.assertIn("try --exposure -3", self.check_done(*bright).stderr)
        self.assertNotIn("--exposure", self.check_done(*bright, "--exposure", "-3").stderr)

    def test_pixels_that_are_not_finite_fail_but_are_written(self):
        self.write("a triangle.obj", TRIANGLE_OBJ)
        result = self.run_program("render", "a triangle.obj", "-o", "out.exr", "--json", "out.json", "--light",
                                  "point:0.3,0.3,0.001:3e38,3e38,3e38", "--eye", "-0.3,0.3,2", "--target", "0.3,0.3,0",
                                  "--size", "24x16", "--spp", "4", "--sample-range", "1:4", "--aov", "depth", "--tile", "8x8")
        self.assertEqual(result.returncode, FAILED, result.stderr)
        found = re.search(r"(?m)^error: out\.exr: (\d+) pixels? (?:is|are) not finite, the first: pixel (\d+),(\d+), "
                          r"sample (\d+); again by: vernier (.*)$", result.stderr)
        self.assertIsNotNone(found, result.stderr)
        count, x, y, sample = map(int, found.groups()[:4])
        self.assertEqual(json.loads((self.folder / "out.json").read_text())["non_finite_pixels"], count)
        self.assertIn(sample, range(1, 4))
        self.assertEqual(self.files(), ["a triangle.obj", "out.exr", "out.json"])
        # The command in the message traces that sample and no other, and meets the fault again.
        again = self.run_program(*shlex.split(found.group(5)), "--json", "again.json")
        self.assertEqual(again.returncode, FAILED, again.stderr)
        self.assertIn(f"sample.exr: 1 pixel is not finite, the first: pixel {x},{y}, sample {sample};", again.stderr)
        self.assertEqual(json.loads((self.folder / "again.json").read_text())["rays"]["primary"], 1)

    def test_an_opacity_at_the_cutoff_hides_nothing(self):
        corners = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0) + struct.pack("<12f", *[1.0] * 12)
        scene = {"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                 "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "COLOR_0": 1}, "material": 0}]}],
                 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                               {"bufferView": 0, "byteOffset": 36, "componentType": 5126, "count": 3, "type": "VEC4"}],
                 "bufferViews": [{"buffer": 0, "byteLength": len(corners)}],
                 "buffers": [{"byteLength": len(corners),
                              "uri": "data:application/octet-stream;base64," + base64.b64encode(corners).decode()}]}
        for name, mode in (("mask", {"alphaMode": "MASK", "alphaCutoff": 1.0}), ("opaque", {})):
            self.write(f"{name}.gltf", json.dumps({**scene, "materials": [mode]}))
            for command in ("render", "reference"):
                self.check_done(command, f"{name}.gltf", "-o", f"{command}_{name}.exr", "--size", "48x48", "--spp", "1")
        for command in ("render", "reference"):
            self.assertIn("RMSE         0\n", self.check_done("diff", f"{command}_mask.exr", f"{command}_opaque.exr").stdout)

    def test_old_file_survives_a_failure(self):
        (self.folder / "out.png").write_bytes(b"old")
        result = self.run_program("render", "gone.glb", "-o", "out.png", *SMALL)
        self.assertNotEqual(result.returncode, DONE)
        self.assertEqual((self.folder / "out.png").read_bytes(), b"old")
        self.assertEqual(self.files(), ["out.png"])

    def test_time_limit_ends_early(self):
        self.check_done("render", SCENE, "-o", "out.png", "--json", "out.json", "--size", "32x32", "--spp", "1000000",
                        "--time-limit", "1")
        report = json.loads((self.folder / "out.json").read_text())
        self.assertLess(report["samples_done"], 4000000)


if __name__ == "__main__":
    unittest.main()
