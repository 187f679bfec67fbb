"""A render that was killed, stopped or interrupted goes on from its checkpoint to the same bytes."""

import os
import signal
import struct
import subprocess
import time
import unittest

from program import DONE, FAILED, PROGRAM, REFUSED, SCENE, SCENES, USAGE, ProgramTest

# Twelve tiles, five passes, a checkpoint after each tile.
RENDER = ["render", SCENE, "--size", "96x64", "--spp", "37", "--tile", "24x24", "--aov", "depth,cost,sample_count", "--quiet"]
# Five rounds, the later ones over some of the blocks.
TO_TARGET = ["render", str(SCENES / "materials.glb"), "--size", "96x64", "--error-target", "0.015", "--tile", "24x24",
             "--aov", "depth,cost,sample_count", "--quiet"]
OFTEN = ["--checkpoint", "c.film", "--checkpoint-seconds", "0"]
RESUME = ["--checkpoint", "c.film", "--resume", "c.film"]


class StoppedRender(ProgramTest):
    """What the tests of a render and of one to a target have in common."""

    command = RENDER
    known = {}

    @property
    def whole(self):
        """The bytes of the render that nothing stopped, made once."""
        kind = type(self).__name__
        if kind not in self.known:
            self.check_done(*self.command, "-o", "whole.exr")
            self.known[kind] = (self.folder / "whole.exr").read_bytes()
        return self.known[kind]

    def start(self, *arguments):
        return subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, stderr=subprocess.PIPE, text=True,
                                env={**os.environ, "VERNIER_PIPELINE_CACHE": "none"})

    def position(self):
        """Pass and tiles at which the checkpoint stands, or round and passes; None before there is one."""
        try:
            return struct.unpack_from("<2I", (self.folder / "c.film").read_bytes(), 72)
        except FileNotFoundError:
            return None

    def stop_at(self, position, stop, *options):
        """Starts the render, sends it `stop` once its checkpoint stands there, and returns its exit code and stderr."""
        process = self.start(*self.command, "-o", "out.exr", *OFTEN, *options)
        deadline = time.monotonic() + 240
        while (self.position() or (-1, 0)) < position and process.poll() is None and time.monotonic() < deadline:
            time.sleep(0.0005)
        process.send_signal(stop)
        _, errors = process.communicate(timeout=120)
        return process.returncode, errors

    def check_whole(self, *arguments):
        self.check_done(*self.command, "-o", "out.exr", *arguments)
        self.assertEqual((self.folder / "out.exr").read_bytes(), self.whole)

    def check_kills(self, positions):
        for position in positions:
            with self.subTest(position):
                (self.folder / "c.film").unlink(missing_ok=True)
                code, errors = self.stop_at(position, signal.SIGKILL)
                self.assertEqual(code, -signal.SIGKILL, errors)
                self.assertFalse((self.folder / "out.exr").exists())
                self.check_whole("--resume", "c.film")
                (self.folder / "out.exr").unlink()


class CheckpointToTargetTest(StoppedRender):
    command = TO_TARGET

    def test_killed_at_several_moments(self):
        self.check_kills([(0, 0), (0, 3), (1, 0), (1, 12), (2, 1), (3, 0), (4, 1)])

    def test_interrupt_says_how_to_go_on(self):
        code, errors = self.stop_at((2, 1), signal.SIGINT)
        self.assertEqual(code, FAILED, errors)
        self.assertIn("go on by: vernier render ", errors)
        self.assertIn(" --error-target 0.015 ", errors)
        self.check_whole(*RESUME)
        self.check_error(REFUSED, "c.film: does not belong to this render: --error-target is `0.015`, there `0.01`",
                         *[argument.replace("0.015", "0.01") for argument in self.command], "-o", "x.exr", "--resume", "c.film")


class CheckpointTest(StoppedRender):
    def test_killed_at_several_moments(self):
        self.check_kills([(0, 0), (0, 1), (0, 12), (1, 5), (5, 2)])

    def test_killed_at_any_moment_and_begun_again_by_the_same_command(self):
        kills = 0
        for attempt in range(40):
            process = self.start(*RENDER, "-o", "out.exr", *OFTEN, "--resume", "c.film")
            try:
                process.communicate(timeout=0.1 + 0.35 * attempt)
            except subprocess.TimeoutExpired:
                process.kill()
                process.communicate()
                kills += 1
            if process.returncode == DONE:
                break
            self.assertEqual(process.returncode, -signal.SIGKILL)
        self.assertGreater(kills, 1)
        self.assertEqual((self.folder / "out.exr").read_bytes(), self.whole)

    def test_another_tile_size_changes_nothing(self):
        self.stop_at((1, 3), signal.SIGKILL)
        tile = RENDER.index("--tile") + 1
        self.check_done(*RENDER[:tile], "96x64", *RENDER[tile + 1:], "-o", "out.exr", "--resume", "c.film")
        self.assertEqual((self.folder / "out.exr").read_bytes(), self.whole)

    def test_interrupt_writes_image_and_checkpoint_and_says_how_to_go_on(self):
        code, errors = self.stop_at((1, 2), signal.SIGINT)
        self.assertEqual(code, FAILED, errors)
        self.assertIn("out.exr: interrupted; it holds what was done by then; go on by: vernier render ", errors)
        self.assertIn(" --checkpoint c.film --resume c.film", errors)
        self.assertTrue((self.folder / "out.exr").exists())
        # Four: the first pass over so small a picture.
        self.check_error(REFUSED, "out.exr: was stopped before its end, at 4 samples per pixel", "rerun", "out.exr")
        self.check_error(REFUSED, "out.exr: was stopped before its end", "merge", "out.exr", "-o", "m.exr")
        self.check_whole(*RESUME)

    def stop_early(self):
        """Behind the first samples, among them or before them, by how busy the machine is: then there is a checkpoint alone."""
        result = self.run_program(*RENDER, "-o", "out.exr", "--checkpoint", "c.film", "--time-limit", "0.001")
        is_written = "nothing is written" not in result.stderr
        if result.returncode != DONE:
            self.assertEqual(result.returncode, FAILED, result.stderr)
            why = "pixels without a sample are black" if is_written else "before the first sample, nothing is written"
            self.assertIn(why + "; go on by: vernier render ", result.stderr)
        self.assertEqual((self.folder / "out.exr").exists(), is_written)

    def test_a_time_limit_can_be_gone_on_from(self):
        self.stop_early()
        if (self.folder / "out.exr").exists():
            self.assertNotEqual((self.folder / "out.exr").read_bytes(), self.whole)
        self.check_whole(*RESUME)

    def test_what_does_not_belong_is_refused(self):
        self.stop_early()
        for option, value, said in [("--seed", "1", "--seed is `0`, there `1`"), ("--spp", "8", "--spp is `37`, there `8`"),
                                    ("--aov", "cost", "--aov is"), ("--crop", "0,0,8,8", "--crop is not set, there `0,0,8,8`"),
                                    ("--accuracy", "exact", "--accuracy is `robust`, there `exact`")]:
            arguments = [*RENDER]
            if option in arguments:
                del arguments[arguments.index(option):arguments.index(option) + 2]
            self.check_error(REFUSED, f"c.film: does not belong to this render: {said}", *arguments, option, value, "-o", "x.exr",
                             "--resume", "c.film")
        other = [str(self.folder / "t.obj") if argument == SCENE else argument for argument in RENDER]
        self.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.check_error(REFUSED, "SHA-1 of the scene's files", *other, "-o", "x.exr", "--resume", "c.film")
        self.assertNotIn("x.exr", self.files())

    def test_broken_and_missing_checkpoints_are_refused(self):
        self.check_error(REFUSED, "no.film: there is no such file", *RENDER, "-o", "x.exr", "--resume", "no.film")
        self.write("bad.film", "vernier-film--2\n")
        self.check_error(REFUSED, "bad.film: is cut short", *RENDER, "-o", "x.exr", "--resume", "bad.film")

    def test_an_older_checkpoint_stays_until_something_is_done(self):
        self.stop_at((1, 5), signal.SIGKILL)
        before = (self.folder / "c.film").read_bytes()
        process = self.start(*RENDER, "-o", "out.exr", "--checkpoint", "c.film")
        time.sleep(1.0)
        process.kill()
        process.communicate(timeout=120)
        self.assertEqual((self.folder / "c.film").read_bytes(), before)
        self.check_whole("--resume", "c.film")
        self.check_error(USAGE, "is no checkpoint", *RENDER, "-o", "a.exr", "--checkpoint", "out.exr")

    def test_a_checkpoint_that_cannot_be_written(self):
        self.check_error(FAILED, "no/c.film: there is no folder no", *RENDER, "-o", "x.exr", "--checkpoint", "no/c.film")
        self.check_error(USAGE, "--checkpoint: it names the same file as --output, x.exr", *RENDER, "-o", "x.exr", "--checkpoint", "x.exr")
        result = self.check_done(*RENDER, "-o", "out.exr", "--checkpoint", "/dev/full", "--checkpoint-seconds", "1000")
        self.assertIn("warning: /dev/full: cannot write: No space left on device; the render goes on", result.stderr)
        self.assertEqual((self.folder / "out.exr").read_bytes(), self.whole)


if __name__ == "__main__":
    unittest.main()
