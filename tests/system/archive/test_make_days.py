#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Made days: one orbit whatever is asked beside it, a manoeuvre by its closed form, and nobody's file is lost."""
import csv
import math
import os
import pathlib
import resource
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import Folder, run  # noqa: E402

FIRST = "ORR0TSTFIN_20240010000_01D_15M_ORB.SP3"


def positions(path):
    """(epoch's line, satellite) -> (x, y, z in m, the record's text)."""
    found, epoch = {}, None
    for line in pathlib.Path(path).read_text(encoding="ascii").splitlines():
        if line.startswith("*"):
            epoch = line
        elif line.startswith("P"):
            found[epoch, line[1:4]] = ([1e3 * float(line[k:k + 14]) for k in (4, 18, 32)], line)
    return found


class MakeDays(Folder):
    def make(self, name, *args, **kwargs):
        folder = pathlib.Path(self.path(name))
        return folder, run("make-days", "-o", folder, "--from", "2024-01-01", *args, **kwargs)

    def test_one_orbit_whatever_is_asked(self):
        whole, told = self.make("whole", "--to", "2024-01-02", "--sat", "G01-G06,E02,R07")
        self.assertIn("2 days of made orbits", told.stderr)
        names = sorted(p.name for p in whole.iterdir())
        self.assertEqual(names, [FIRST, FIRST.replace("001", "002", 1)])
        part, _ = self.make("part", "--to", "2024-01-02", "--sat", "R07,G05", "--jobs", "1")
        dense, _ = self.make("dense", "--to", "2024-01-02", "--sat", "G05,R07", "--step", "300")
        for name in names:
            first, few, truth = positions(whole / name), positions(part / name), positions(dense / name.replace("15M", "05M"))
            self.assertEqual({s for _, s in first}, {*(f"G{k:02d}" for k in range(1, 7)), "E02", "R07"})
            self.assertEqual((len(few), len(truth)), (2 * 96, 2 * 288))
            for key, (place, text) in few.items():
                self.assertEqual(text, first[key][1])
                self.assertLess(math.dist(place, truth[key][0]), 1.8e-3)  # another step is another path of rounding: a digit at most
        # The files are input as any others are, and the product meets the positions that were none.
        product = self.path("day.nc")
        run("orbit", "-q", "-o", product, *(part / n for n in names))
        with_truth = run("compare", product, *(dense / n.replace("15M", "05M") for n in names), "--csv", self.path("c.csv"))
        self.assertIn("G05", with_truth.stdout + with_truth.stderr)
        with open(self.path("c.csv"), encoding="ascii") as f:
            radial = [float(r["radial_m"]) for r in csv.DictReader(f)]
        self.assertGreater(len(radial), 600)
        self.assertLess(math.sqrt(sum(r * r for r in radial) / len(radial)), 1e-3)

    def test_a_push_by_its_closed_form(self):
        """Faster by dv along a circle: 2 a dv / v higher half a revolution later, and behind by 3 dv t in the mean; nothing before."""
        pushed, _ = self.make("pushed", "--sat", "G05,G06", "--push", "G05,2024-01-01T06:00:00,0.1")
        still, _ = self.make("still", "--sat", "G05,G06")
        a, b = positions(pushed / FIRST), positions(still / FIRST)
        period_s = 2 * math.pi * math.sqrt(26.56e6 ** 3 / 3.986004415e14)
        for (epoch, sat), (place, text) in a.items():
            t_s = 3600 * int(epoch[14:16]) + 60 * int(epoch[17:19]) - 6 * 3600
            apart = math.dist(place, b[epoch, sat][0])
            if sat == "G06" or t_s <= 0:
                self.assertEqual(text, b[epoch, sat][1])
                continue
            n = 2 * math.pi / period_s
            radial = 2 * 0.1 / n * (1 - math.cos(n * t_s))  # Clohessy and Wiltshire 1960
            along = 0.1 * (4 / n * math.sin(n * t_s) - 3 * t_s)
            self.assertAlmostEqual(apart / math.hypot(radial, along), 1, delta=0.02, msg=epoch)

    def test_bad_calls(self):
        for args, words in ((("--to", "2023-12-31"), "--to is before --from"), (("--to", "2150-01-01"), "at most 40000 days"),
                            (("--step", "7s"), "a day is a multiple"), (("--step", "0.5"), "whole seconds"),
                            (("--sat", "C01,G28"), "G01-G27"), (("--push", "G05,0.1"), "SAT,T,MPS"), (("--push", "G05,noon,0.1"), "SAT,T,MPS"),
                            (("--push", "G05,2024-01-01T12:00,fast"), "SAT,T,MPS"), (("--push", "C05,2024-01-01,1"), "C05, which is not made"),
                            (("--push", "G05,2024-01-02,1"), "on none of the days"), (("--sat", "R", "--push", "G05,2024-01-01,1"), "not made")):
            with self.subTest(args=args):
                self.assertIn(words, self.make("none", *args, status=2)[1].stderr)
                self.assertFalse(os.path.exists(self.path("none")))
        self.assertIn("becomes impossible", self.make("fallen", "--sat", "G05", "--push", "G05,2024-01-01T01:00,-3800", status=1)[1].stderr)
        self.assertEqual(os.listdir(self.path("fallen")), [])

    def test_nobody_s_file_is_lost(self):
        folder = pathlib.Path(self.path("theirs"))
        folder.mkdir()
        theirs = folder / FIRST.replace("001", "003", 1)
        theirs.write_text("#dP2024 notes of somebody\n", encoding="ascii")
        self.assertIn("--force replaces it", self.make("theirs", "--to", "2024-01-04", "--sat", "G05", status=1)[1].stderr)
        self.assertEqual([p.name for p in folder.iterdir()], [theirs.name])  # nothing was begun
        self.make("theirs", "--to", "2024-01-04", "--sat", "G05", "--force")
        again = {p.name: p.read_bytes() for p in folder.iterdir()}
        self.make("theirs", "--to", "2024-01-04", "--sat", "G05")  # our own are made again, the same
        self.assertEqual({p.name: p.read_bytes() for p in folder.iterdir()}, again)
        self.assertEqual(len(again), 4)
        in_the_way = pathlib.Path(self.path("file"))
        in_the_way.write_text("", encoding="ascii")
        self.assertEqual(self.make("file", "--sat", "G05", status=1)[1].stdout, "")

    def test_full_disk(self):
        def small():
            resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))
        folder, told = self.make("full", "--to", "2024-01-02", status=1, preexec_fn=small)
        self.assertIn("File too large", told.stderr)
        self.assertEqual(os.listdir(folder), [])


if __name__ == "__main__":
    import unittest
    unittest.main(argv=[__file__])
