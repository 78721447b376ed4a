# SPDX-License-Identifier: GPL-3.0-or-later
"""The manners of the program: help for every command, nearest words, exit status, stdout and stderr apart."""
import pathlib
import re
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import ORRERY, run  # noqa: E402


def commands():
    """Names of all commands, from `orrery --help`: indented lines below a heading."""
    lines = run("--help").stdout.splitlines()
    return [line.split()[0] for line in lines if line.startswith("  ") and not line.startswith("   ")]


class Program(unittest.TestCase):
    def test_help_of_every_command(self):
        names = commands()
        self.assertLessEqual({"orbit", "states", "compare", "inspect"}, set(names))
        for name in names:
            with self.subTest(command=name):
                text = run(name, "--help").stdout
                self.assertEqual(text, run("help", name).stdout)
                self.assertIn(f"Usage: orrery {name}", text)
                self.assertIn("\nExample:\n", text)
                self.assertIn(f"  orrery {name} ", text.split("\nExample:\n")[1])
                self.assertLessEqual(max(map(len, text.splitlines())), 130)

    def test_help_is_sentences(self):
        for name in commands():
            if name == "poll":
                continue  # the polls' options are worded with the messages
            page = run("--man", name).stdout
            for option, text in re.findall(r"^\.TP\n.*\\fB\\-\\-(.*?)\\fR.*\n(.*)\n", page, re.M):
                with self.subTest(command=name, option=option):
                    text = re.sub(r"( \([^()]*\))+$", "", text)
                    self.assertRegex(text, r"^[A-Z].*\.$")

    def test_groups_stand_together(self):
        lines = run("--help").stdout.splitlines()
        headings = [a for a, b in zip(lines, lines[1:]) if a and not a.startswith(" ") and b.startswith("  ")]
        self.assertEqual(len(headings), len(set(headings)))

    def test_version(self):
        version = re.fullmatch(r"orrery (\d+\.\d+\.\d+)\n", run("--version").stdout)[1]
        root = pathlib.Path(__file__).resolve().parents[3]
        client = (root / "proto/python/orrery/_version.py").read_text(encoding="utf-8")
        self.assertIn(f'__version__ = "{version}"\n', client)
        # The changes: releases under their dates, the newest first, which is this program once there is one.
        headings = re.findall(r"^## (.*)$", (root / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE)
        self.assertEqual(headings[0], "[Unreleased]")
        for heading in headings[1:]:
            self.assertRegex(heading, r"^\[\d+\.\d+\.\d+\] - \d{4}-\d{2}-\d{2}$")
        if headings[1:]:
            self.assertIn(f"[{version}]", headings[1])
        kinds = re.findall(r"^### (.*)$", (root / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE)
        self.assertLessEqual(set(kinds), {"Added", "Changed", "Deprecated", "Removed", "Fixed", "Security"})

    def test_nearest_words(self):
        done = run("stats", status=2)
        self.assertEqual(done.stdout, "")
        self.assertIn("'states'", done.stderr)
        self.assertIn("'orbit'", run("help", "orbti", status=2).stderr)
        self.assertIn("--output", run("orbit", "--ouput", "x", "y.sp3", status=2).stderr)
        self.assertNotIn("did you mean", run("qqqqqqqq", status=2).stderr)

    def test_nothing_asked(self):
        done = run(status=2)
        self.assertEqual(done.stdout, "")
        self.assertIn("Usage: orrery COMMAND", done.stderr)

    def test_full_disk_is_told(self):
        full = pathlib.Path("/dev/full")
        if not full.exists():
            self.skipTest("there is no /dev/full")
        with full.open("w") as out:
            done = subprocess.run([ORRERY, "--help"], stdout=out, stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("stdout", done.stderr)


if __name__ == "__main__":
    unittest.main()
