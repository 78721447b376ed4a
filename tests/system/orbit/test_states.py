# SPDX-License-Identifier: GPL-3.0-or-later
"""`orrery states`: the three formats say the same, what is not there is not made up, files are whole or absent."""
import csv
import io
import json
import math
import pathlib
import signal
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import ORRERY, Folder, run, run_json, sample  # noqa: E402

COLUMNS = ("t_gps,sat,x_m,y_m,z_m,vx_mps,vy_mps,vz_mps,clock_s,flags,sigma_m,clock_sigma_s,"
           "sigma_radial_m,sigma_along_m,sigma_cross_m,sigma_mps").split(",")
DAY = "ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"


def table(*args):
    text = run("states", *args).stdout
    rows = list(csv.DictReader(io.StringIO(text)))
    assert text.splitlines()[0].split(",") == COLUMNS, text.splitlines()[0]
    return rows


class States(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.product = cls.path("day.nc")
        sats = "G01-G04,G17,R08,R21,E14,E18"
        # Some hours without any node, longer than is bridged: there the product has no orbit.
        run("orbit", "-q", "-o", cls.product, "--sat", sats, "--max-gap", "1h", "--exclude",
            "2025-03-21T14:01/2025-03-21T15:59", sample(DAY))

    def test_csv(self):
        rows = table(self.product, "--from", "2025-03-21T06:00", "--to", "2025-03-21T06:00:01", "--step", "0.1")
        times = sorted({r["t_gps"] for r in rows})
        self.assertEqual(times[:3], ["2025-03-21T06:00:00", "2025-03-21T06:00:00.1", "2025-03-21T06:00:00.2"])
        self.assertEqual(len(times), 11)
        self.assertEqual(len(rows), 11 * 9)
        self.assertEqual([r["sat"] for r in rows[:9]], ["G01", "G02", "G03", "G04", "G17", "R08", "R21", "E14", "E18"])
        for r in rows:
            radius = math.hypot(*(float(r[k]) for k in ("x_m", "y_m", "z_m")))
            self.assertTrue(2.2e7 < radius < 3.4e7)
            self.assertGreaterEqual(len(r["x_m"].split(".")[1]), 5)  # 0.01 mm and better
        # Positions move by velocity: 0.1 s at 3 km/s with 0.6 m/s2 leaves 3 mm, the mean of both velocities micrometres.
        by = {(r["t_gps"], r["sat"]): r for r in rows}
        for sat in ("G01", "E14"):
            a, b = (by[(t, sat)] for t in times[:2])
            for p, v in (("x_m", "vx_mps"), ("y_m", "vy_mps"), ("z_m", "vz_mps")):
                moved = 0.1 * (float(a[v]) + float(b[v])) / 2
                self.assertAlmostEqual(float(b[p]) - float(a[p]), moved, delta=5e-6)

    def test_missing_clock_is_an_empty_field(self):
        rows = table(self.product, "--from", "2025-03-21T06:00", "--to", "2025-03-21T06:00", "--sat", "R21,G01")
        self.assertEqual({r["sat"]: r["clock_s"] == "" for r in rows}, {"G01": False, "R21": True})
        self.assertEqual({r["sat"]: int(r["flags"]) & 1 for r in rows}, {"G01": 1, "R21": 0})
        # The flagged reset at 10:00 happened somewhere since 9:45: no clock between, one at both ends.
        clocks = [table(self.product, "--from", t, "--to", t, "--sat", "G17")[0]["clock_s"] for t in
                  ("2025-03-21T09:45", "2025-03-21T09:50", "2025-03-21T10:00")]
        self.assertEqual([c == "" for c in clocks], [False, True, False])
        self.assertAlmostEqual(float(clocks[2]) - float(clocks[0]), 42e-6, delta=2e-6)

    def test_no_orbit_no_row(self):
        done = run("states", self.product, "--from", "2025-03-21T14:00", "--to", "2025-03-21T16:00", "--step", "1h")
        times = [line.split(",")[0] for line in done.stdout.splitlines()[1:]]
        self.assertEqual(sorted(set(times)), ["2025-03-21T14:00:00", "2025-03-21T16:00:00"])
        self.assertIn("9 times", done.stderr)
        self.assertEqual(run("states", "-q", self.product, "--from", "2025-03-21T15:00", "--to", "2025-03-21T15:00").stderr, "")

    def test_sigma(self):
        for row in table(self.product, "--at", "2025-03-21T12:00"):
            self.assertTrue(1e-4 < float(row["sigma_m"]) < 2e-3, row)

    def test_inertial_axes(self):
        """Of the GCRS: as far from the centre, velocities that are the positions' slopes, and no turn with the Earth."""
        span = ("--from", "2025-03-21T11:59:59", "--to", "2025-03-21T12:00:01", "--step", "1", "--sat", "G01,R08,E14")
        fixed, inertial = table(self.product, *span), table(self.product, *span, "--frame", "inertial")
        by = {(r["sat"], r["t_gps"]): r for r in inertial}
        for f in fixed:
            i = by[f["sat"], f["t_gps"]]
            radius = [math.hypot(*(float(r[k]) for k in ("x_m", "y_m", "z_m"))) for r in (f, i)]
            self.assertAlmostEqual(*radius, delta=2e-6)
            self.assertLess(abs(float(f["z_m"]) - float(i["z_m"])), 2.6e7 * 3e-3)  # precession and nutation since 2000
        for sat in ("G01", "R08", "E14"):
            a, b, c = (by[sat, f"2025-03-21T{t}"] for t in ("11:59:59", "12:00:00", "12:00:01"))
            slope = [(float(c[k]) - float(a[k])) / 2 for k in ("x_m", "y_m", "z_m")]
            v = [float(b[k]) for k in ("vx_mps", "vy_mps", "vz_mps")]
            for got, is_ in zip(v, slope):
                self.assertAlmostEqual(got, is_, delta=2e-5)  # the third derivative: 1e-4 m/s3 / 6
            r = [float(b[k]) for k in ("x_m", "y_m", "z_m")]
            energy = sum(x * x for x in v) / 2 - 3.986004418e14 / math.hypot(*r)
            period = 2 * math.pi * math.sqrt((-3.986004418e14 / 2 / energy) ** 3 / 3.986004418e14)
            self.assertAlmostEqual(period / 86164.1, {"G": 1 / 2, "R": 8 / 17, "E": 20 / 37}[sat[0]], delta=2e-3)
        self.assertIn("--frame applies only", run("states", self.product, "--frame", "inertial", "--format", "sp3", status=2).stderr)

    def test_several_products(self):
        """As of one, in whatever order they are named; at midnight the earlier day's; hours without a product are told."""
        days = {}
        for day in ("079", "080", "081"):
            days[day] = self.path(f"{day}.nc")
            run("orbit", "-q", "-o", days[day], "--sat", "G01,E14", sample(DAY.replace("2025080", f"2025{day}")))
        rows = table(days["081"], days["079"], days["080"], "--step", "6h")
        self.assertEqual([r["t_gps"] for r in rows], sorted(r["t_gps"] for r in rows))
        self.assertEqual(len(rows), 2 * 13)
        midnight = [r for r in rows if r["t_gps"] == "2025-03-21T00:00:00"]
        self.assertEqual(midnight, table(days["079"], "--at", "2025-03-21"))
        done = run("states", days["079"], days["081"], "--step", "12h")
        self.assertIn("no product covers 2025-03-21T00:00:00 to 2025-03-22T00:00:00", done.stderr)
        out = self.path("three.sp3")
        run("states", *days.values(), "--format", "sp3", "-o", out)
        self.assertEqual(run_json("inspect", out, "--format", "json")["epochs"], 3 * 96 + 1)
        whole = run("eclipses", *days.values(), "--sat", "G01", "--format", "csv").stdout.splitlines()[1:]
        parts = [line for day in days.values() for line in
                 run("eclipses", day, "--sat", "G01", "--format", "csv").stdout.splitlines()[1:]]
        self.assertEqual(whole, parts)  # none at midnight here
        self.assertEqual(len(run("satellites", *days.values(), "--step", "12h").stdout.splitlines()), 1 + 2 * 7)

    def test_formats_agree(self):
        span = ("--from", "2025-03-21T03:00", "--to", "2025-03-21T05:00", "--step", "900")
        rows = table(self.product, *span)
        objects = run_json("states", self.product, *span, "--format", "json")
        self.assertEqual(len(rows), len(objects))
        for r, o in zip(rows, objects):
            self.assertEqual(list(o), COLUMNS)
            self.assertEqual((r["t_gps"], r["sat"], int(r["flags"])), (o["t_gps"], o["sat"], o["flags"]))
            for k in COLUMNS[2:8]:
                self.assertEqual(float(r[k]), o[k])
            self.assertGreater(o["sigma_m"], 0)
            self.assertEqual(r["clock_sigma_s"], "" if o["clock_sigma_s"] is None else r["clock_sigma_s"])
            self.assertEqual(o["clock_s"] is None, o["clock_sigma_s"] is None)
            if o["clock_sigma_s"] is not None:
                self.assertTrue(0 < o["clock_sigma_s"] < 1e-6)
            self.assertEqual(r["clock_s"], "" if o["clock_s"] is None else r["clock_s"])
            if o["clock_s"] is not None:
                self.assertEqual(float(r["clock_s"]), o["clock_s"])
        text = run("states", self.product, *span, "--format", "sp3").stdout.splitlines()
        self.assertTrue(text[0].startswith("#dV2025  3 21  3  0"))
        at = None
        sp3 = {}
        for line in text:
            if line.startswith("* "):
                f = line.split()
                at = f"2025-03-21T{int(f[4]):02}:{int(f[5]):02}:00"
            elif line[0] in "PV" and at:
                sp3[(line[0], at, line[1:4])] = [float(line[4 + 14 * i:18 + 14 * i]) for i in range(4)]
        for r in rows:
            p, v = sp3[("P", r["t_gps"], r["sat"])], sp3[("V", r["t_gps"], r["sat"])]
            for i, k in enumerate(COLUMNS[2:5]):
                self.assertAlmostEqual(1e3 * p[i], float(r[k]), delta=0.00051)  # km to the mm
            for i, k in enumerate(COLUMNS[5:8]):
                self.assertAlmostEqual(0.1 * v[i], float(r[k]), delta=0.6e-7)  # dm/s, six decimals
            if r["clock_s"]:
                self.assertAlmostEqual(1e-6 * p[3], float(r["clock_s"]), delta=0.6e-12)
            else:
                self.assertGreater(p[3], 999999)

    def test_sp3_reads_back(self):
        out = self.path("states.sp3")
        run("states", self.product, "--step", "300", "--to", "2025-03-21T14:00", "--format", "sp3", "-o", out)
        seen = run_json("inspect", "--format", "json", out)
        self.assertEqual((seen["satellites"], seen["epochs"], seen["interval_s"]), (9, 14 * 12 + 1, 300))
        self.assertEqual(seen["warnings"], [])

    def test_file_is_stdout(self):
        out = self.path("states.csv")
        args = ("states", self.product, "--step", "3600", "--to", "2025-03-21T14:00")
        run(*args, "-o", out)
        self.assertEqual(pathlib.Path(out).read_text(encoding="ascii"), run(*args).stdout)

    def test_refusals(self):
        for args, status, word in (
                (("states",), 2, "PRODUCT... is needed"),
                (("states", self.path("absent.nc")), 1, "absent.nc"),
                (("states", sample(DAY)), 1, "orbit product is wanted"),
                (("states", self.product, "--from", "2025-03-20T23:00"), 1, "covers 2025-03-21T00:00:00 to"),
                (("states", self.product, "--to", "2025-03-22T00:00:00.1"), 1, "covers"),
                (("states", self.product, "--from", "2025-03-21T02:00", "--to", "2025-03-21T01:00"), 2, "--to is before"),
                (("states", self.product, "--sat", "C"), 1, "none of the satellites C"),
                (("states", self.product, "--step", "0"), 2, "--step"),
                (("states", self.product, "-o", "/nowhere/at/all.csv"), 1, "/nowhere/at/all.csv")):
            with self.subTest(args=args):
                done = run(*args, status=status)
                self.assertEqual(done.stdout, "")
                self.assertIn(word, done.stderr)

    def test_interrupt_leaves_nothing(self):
        out = self.path("long.csv")
        before = self.left()
        with subprocess.Popen([ORRERY, "states", self.product, "--step", "0.001", "-o", out]) as p:
            for _ in range(500):  # until the file is being made
                if self.left() != before:
                    break
                time.sleep(0.01)
            self.assertNotEqual(self.left(), before)
            p.send_signal(signal.SIGINT)
            self.assertEqual(p.wait(timeout=60), -signal.SIGINT)
        self.assertEqual(self.left(), before)

    def test_reader_that_leaves(self):
        with subprocess.Popen([ORRERY, "states", self.product, "--step", "0.01"], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE) as p:
            p.stdout.readline()
            p.stdout.close()
            self.assertEqual(p.stderr.read(), b"")
            self.assertNotEqual(p.wait(timeout=60), 0)


if __name__ == "__main__":
    unittest.main()
