# SPDX-License-Identifier: GPL-3.0-or-later
"""The scripts around the build: they parse, apt is asked for what is missing alone, and a failing step shows its log."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import program  # noqa: E402

SCRIPTS = ["demo", "check", ".ci/run", "cmake/setup", "cmake/steps.sh"]


def folder(case):
    made = tempfile.TemporaryDirectory()
    case.addCleanup(made.cleanup)
    return made.name


class Scripts(unittest.TestCase):
    def test_they_parse_and_can_be_run(self):
        for name in SCRIPTS:
            subprocess.run(["bash", "-n", str(program.ROOT / name)], check=True)
            if not name.endswith(".sh"):
                self.assertTrue(os.access(program.ROOT / name, os.X_OK), name)

    def test_failing_step_shows_its_log(self):
        text = '. cmake/steps.sh; step "the work" "$1" bash -c "echo seen; echo error: broken; exit 3"; echo not reached'
        with open(os.devnull, "rb") as nothing:
            done = subprocess.run(["bash", "-c", text, "bash", os.path.join(folder(self), "a.log")], cwd=program.ROOT, stdin=nothing,
                                  capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("error: broken", done.stderr)
        self.assertIn("the work: failed", done.stderr)
        self.assertNotIn("not reached", done.stdout)


class Setup(unittest.TestCase):
    """cmake/setup among commands that only write down how they were called."""

    def setUp(self):
        self.bin = pathlib.Path(folder(self))
        self.log = self.bin / "log"
        self.log.write_text("")

    def put(self, name, body):
        path = self.bin / name
        path.write_text(f'#!/bin/sh\n{body}\n')
        path.chmod(0o755)

    def setup(self, part, missing=(), user=1000, apt="exit 0"):
        lacks = "|".join(missing) or "nothing"
        # called as: dpkg-query -W -f=FORMAT PACKAGE...
        self.put("dpkg-query", f'shift 2\nfor p; do case $p in {lacks}) ;; *) echo "installed $p" ;; esac; done')
        self.put("id", f"echo {user}")
        self.put("sudo", f'echo "sudo $1" >>{self.log}\nexec "$@"')
        self.put("apt-get", f'echo "apt-get $*" >>{self.log}\n{apt}')
        env = dict(os.environ, PATH=f"{self.bin}:{os.environ['PATH']}")
        return subprocess.run([str(program.ROOT / "cmake/setup"), part], env=env, stdin=subprocess.DEVNULL, capture_output=True,
                              text=True, check=False)

    def test_nothing_missing_nothing_asked(self):
        done = self.setup("check")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("all here", done.stdout)
        self.assertEqual(self.log.read_text(), "")

    def test_only_the_missing_with_sudo(self):
        done = self.setup("check", ["cppcheck", "libgsl-dev"])
        self.assertEqual(done.returncode, 0, done.stderr)
        calls = self.log.read_text()
        self.assertIn("sudo apt-get", calls)
        self.assertIn("apt-get update", calls)
        install = next(line for line in calls.splitlines() if "install" in line)
        self.assertEqual(install.split()[-2:], ["cppcheck", "libgsl-dev"])
        self.assertNotIn("cmake", install)

    def test_root_needs_no_sudo(self):
        self.assertEqual(self.setup("build", ["g++"], user=0).returncode, 0)
        self.assertIn("apt-get", self.log.read_text())
        self.assertNotIn("sudo", self.log.read_text())

    def test_build_does_not_want_what_tests_want(self):
        done = self.setup("build", ["cppcheck"])
        self.assertEqual(done.returncode, 0)
        self.assertEqual(self.log.read_text(), "")

    def test_failure_of_apt_is_told(self):
        done = self.setup("build", ["libgsl-dev"], user=0, apt='echo "E: no network"; exit 100')
        self.assertEqual(done.returncode, 1)
        self.assertIn("E: no network", done.stderr)
        self.assertEqual(self.setup("everything").returncode, 2)


if __name__ == "__main__":
    unittest.main(verbosity=1)
