"""tools/setup with dpkg, apt and sudo replaced: what it would install, when, and what it says when it cannot."""

import os
import pathlib
import subprocess
import tempfile
import unittest

from tool_path import ROOT

# Each stand-in notes its arguments in $CALLS. Installed packages are listed in $INSTALLED, known ones in $KNOWN.
STAND_INS = {
    "dpkg-query": 'for name in "${@:3}"; do grep -qx "$name" "$INSTALLED" && echo "installed $name"; done; exit 1',
    "apt-cache": 'grep -qx "$2" "$KNOWN" && echo "$2 | 1.0 | somewhere"; exit 0',
    "apt-get": 'echo "apt-get $*" >>"$CALLS"; case " $* " in *" update "*) cat "$ARCHIVE" >"$KNOWN";; '
               '*" install "*) printf "%s\\n" "$@" >>"$INSTALLED";; esac',
    "sudo": "exit 1",
    "id": "echo ${FAKE_ID:-0}",
}


class Setup(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.folder = pathlib.Path(self.scratch.name)
        for name, body in STAND_INS.items():
            path = self.folder / name
            path.write_text(f"#!/bin/bash\n{body}\n", encoding="ascii")
            path.chmod(0o755)
        everything = self.run_setup("--absent", "test", "benchmark")[1].split()
        self.assertIn("libgtest-dev", everything)
        self.everything = everything

    def run_setup(self, *arguments, installed=(), known=(), archive=(), user=0):
        """(exit code, stdout, stderr, calls of apt-get)."""
        lists = {"INSTALLED": installed, "KNOWN": known, "ARCHIVE": archive, "CALLS": ()}
        environment = dict(os.environ, PATH=f"{self.folder}:{os.environ['PATH']}", FAKE_ID=str(user))
        for name, lines in lists.items():
            (self.folder / name).write_text("".join(f"{line}\n" for line in lines), encoding="ascii")
            environment[name] = str(self.folder / name)
        done = subprocess.run([str(ROOT / "tools/setup"), *arguments], env=environment, text=True, capture_output=True,
                              check=False)
        return done.returncode, done.stdout, done.stderr, (self.folder / "CALLS").read_text(encoding="ascii").splitlines()

    def test_nothing_to_do_is_silent(self):
        self.assertEqual(self.run_setup("test", "benchmark", installed=self.everything), (0, "", "", []))

    def test_only_what_is_missing_is_installed(self):
        code, _, said, calls = self.run_setup("build", "run", known=self.everything,
                                              installed=set(self.everything) - {"cmake", "libvulkan1"})
        self.assertEqual(code, 0)
        self.assertEqual(len(calls), 1)
        self.assertTrue(calls[0].endswith("install -y --no-install-recommends cmake libvulkan1"), calls)
        self.assertIn("installing cmake libvulkan1", said)

    def test_package_lists_are_fetched_once_when_empty(self):
        _, _, _, calls = self.run_setup("run", archive=self.everything)
        self.assertEqual([call.split("Timeout=600 ")[1].split()[0] for call in calls], ["update", "install"])

    def test_a_package_that_is_nowhere_is_named(self):
        code, _, said, _ = self.run_setup("run", archive=["libvulkan1"])
        self.assertEqual(code, 1)
        self.assertIn("no package mesa-vulkan-drivers", said)

    def test_an_optional_package_may_be_absent(self):
        others = set(self.everything) - {"chromium-common"}
        code, _, said, calls = self.run_setup("test", installed=others, known=others)
        self.assertEqual((code, calls), (0, []))
        self.assertIn("no package chromium-common: nothing is tested on SwiftShader", said)

    def test_without_rights_the_whole_command_is_printed(self):
        code, _, said, calls = self.run_setup("run", known=self.everything, user=1000)
        self.assertEqual((code, calls), (1, []))
        self.assertEqual(said.count("\n"), 1)
        self.assertIn("sudo apt-get install libvulkan1 mesa-vulkan-drivers", said)

    def test_unknown_group(self):
        self.assertEqual(self.run_setup("nonsense")[0], 2)


if __name__ == "__main__":
    unittest.main()
