# SPDX-License-Identifier: GPL-3.0-or-later
"""`orrery compare`: its report against its own series, and differences that are known: a file with itself, moved by a metre."""
import collections
import csv
import gzip
import io
import json
import math
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import Folder, run, run_json, sample  # noqa: E402

DAY, TRUTH = "ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz", "ORR0TSTFIN_20250800000_01D_05M_ORB.SP3.gz"
PARTS = ("radial", "along", "cross")


def rms(values):
    return math.sqrt(sum(v * v for v in values) / len(values))


class Compare(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.product = cls.path("day.nc")
        run("orbit", "-q", "--sat", "G01-G04,E02,E03,R05", "-o", cls.product, sample(DAY))

    def test_series_and_report_agree(self):
        series = self.path("series.csv")
        told = run_json("compare", self.product, sample(TRUTH), "--csv", series, "--format", "json")
        groups = collections.defaultdict(list)
        with open(series, encoding="ascii", newline="") as f:
            for row in csv.DictReader(f):
                rac = [float(row[f"{k}_m"]) for k in PARTS]
                xyz = [float(row[f"d{k}_m"]) for k in "xyz"]
                self.assertAlmostEqual(math.hypot(*rac), math.hypot(*xyz), delta=3e-6)  # a turn; rounded to micrometres
                groups[row["sat"][0], row["place"]].append((rac, math.hypot(*xyz)))
        self.assertEqual(told["left_out"]["between"], sum(len(v) for k, v in groups.items() if k[1] == ""))
        for system, places in told["systems"].items():
            for place, s in places.items():
                if "n" not in s:  # sunlit and shadowed apart
                    continue
                got = groups[system, place]
                self.assertEqual(len(got), s["n"])
                if not got:
                    self.assertIsNone(s["radial"]["rms_mm"])
                    continue
                self.assertAlmostEqual(rms([n for _, n in got]) * 1e3, s["rms_mm"], delta=2e-3)
                self.assertAlmostEqual(math.hypot(*(s[k]["rms_mm"] for k in PARTS)), s["rms_mm"], delta=1e-6)
                for i, part in enumerate(PARTS):
                    self.assertAlmostEqual(rms([r[i] for r, _ in got]) * 1e3, s[part]["rms_mm"], delta=2e-3)
                    self.assertAlmostEqual(sum(r[i] for r, _ in got) / len(got) * 1e3, s[part]["mean_mm"], delta=2e-3)
        self.assertEqual(run("compare", self.product, sample(TRUTH), "--csv", "-").stdout, pathlib.Path(series).read_text(encoding="ascii"))

    def test_satellites_are_chosen(self):
        told = run_json("compare", self.product, sample(TRUTH), "--sat", "G02,E", "--format", "json")
        self.assertEqual({s["sat"] for s in told["satellites"]}, {"G02", "E02", "E03"})
        self.assertEqual(set(told["systems"]), {"G", "E"})

    def test_limit(self):
        self.assertEqual(run("compare", self.product, sample(TRUTH), "--limit", "10").stderr, "")
        talk = run("compare", self.product, sample(TRUTH), "--limit", "0.01", status=1).stderr
        self.assertRegex(talk, r"GPS, inner: 0\.\d+ mm RMS, more than the limit of 0.01 mm")

    def moved(self, name, move):
        """The truth with every position moved by move(sat, x, y, z) in metres."""
        lines = []
        for line in gzip.open(sample(TRUTH), "rt", encoding="ascii"):
            if line.startswith("P"):
                xyz = [float(line[4 + 14 * k:18 + 14 * k]) * 1e3 for k in range(3)]
                new = [v + d for v, d in zip(xyz, move(line[1:4], xyz))]
                line = line[:4] + "".join(f"{v * 1e-3:14.6f}" for v in new) + line[46:]
            lines.append(line)
        path = self.path(name)
        pathlib.Path(path).write_text("".join(lines), encoding="ascii")
        return path

    def test_a_file_with_itself(self):
        same = run_json("compare", sample(TRUTH), sample(TRUTH), "--format", "json")
        self.assertEqual(same["left_out"]["no_orbit"], 0)
        for places in same["systems"].values():
            self.assertEqual((places["inner"]["max_mm"], places["edge"]["max_mm"], places["gap"]["n"]), (0, 0, 0))

    def test_a_radial_metre(self):
        """Away from the Earth's centre by a metre: radial alone."""
        path = self.moved("radial.sp3", lambda _, r: [v / math.hypot(*r) for v in r])
        told = run_json("compare", path, sample(TRUTH), "--sat", "G,E", "--format", "json")
        for places in told["systems"].values():
            s = places["inner"]
            self.assertAlmostEqual(s["radial"]["mean_mm"], 1000, delta=0.1)  # of thousands of positions rounded to 1 mm
            for part in ("along", "cross"):
                self.assertLess(abs(s[part]["mean_mm"]), 0.1)
                self.assertLess(s[part]["rms_mm"], 0.6)  # sqrt(2) of 1 mm / sqrt(12)

    def test_a_turn_about_the_axis(self):
        """By 1e-8 rad about z: in the orbit's plane along the track, r cos i on average; a hypotenuse of r cos(latitude)."""
        path = self.moved("turned.sp3", lambda _, r: [-1e-8 * r[1], 1e-8 * r[0], 0])
        rows = list(csv.DictReader(io.StringIO(run("compare", path, sample(TRUTH), "--sat", "G", "--csv", "-").stdout)))
        along = [float(r["along_m"]) for r in rows]
        radial = [float(r["radial_m"]) for r in rows]
        self.assertLess(rms(radial), 1e-3)
        a, i = 26.56e6, math.radians(55)
        self.assertAlmostEqual(sum(along) / len(along), 1e-8 * a * math.cos(i), delta=0.005)  # eccentricities to 0.02

    def test_wrong_calls(self):
        self.assertIn("standard output", run("compare", self.product, sample(TRUTH), "--csv", "-", "--format", "json", status=2).stderr)
        self.assertIn("nothing to compare", run("compare", self.product, sample(TRUTH), "--sat", "C01", status=1).stderr)
        self.assertTrue(json.loads(run("compare", self.product, sample(DAY), "--inputs", "--format", "json").stdout))


if __name__ == "__main__":
    unittest.main()
