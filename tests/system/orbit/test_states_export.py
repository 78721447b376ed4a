#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""States in other programs' forms, each read back by a reader written here from the form's own document, or by the program itself."""
import csv
import datetime
import json
import math
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import oem  # noqa: E402
from program import Folder, run, sample  # noqa: E402

SATS = ("G01", "G05", "R01", "E02")
CF = """
import json, sys, xarray
with xarray.open_dataset(sys.argv[1]) as d:
    d.load()
    names = [bytes(n).decode() if isinstance(n, bytes) else "".join(x.decode() for x in n) if hasattr(n, "__len__") and not isinstance(n, str) else n for n in d.satellite_name.values]
    print(json.dumps({"conventions": d.attrs["Conventions"], "coords": list(d.coords), "names": names, "units": {k: v.attrs.get("units") for k, v in d.data_vars.items()},
                      "t": [str(t) for t in d.time.values], "pos": d.position.values.tolist(), "vel": d.velocity.values.tolist(), "clock": d.clock.values.tolist()}))
"""


def instant(text):
    return datetime.datetime.fromisoformat(text)


class Export(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.product = cls.path("day.nc")
        run("orbit", "-q", "-o", cls.product, "--sat", ",".join(SATS), sample("ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"))
        rows = csv.DictReader(run("states", cls.product, "--step", "900").stdout.splitlines())
        cls.rows = {(instant(r["t_gps"]), r["sat"]): r for r in rows}

    def states(self, form, name, *more):
        path = pathlib.Path(self.path(name))
        run("states", self.product, "--step", "900", "--format", form, "-o", path, *more)
        return path

    def test_clocks(self):
        n = 0
        for line in self.states("clk", "day.clk").read_text(encoding="ascii").splitlines():
            if not line.startswith("AS "):
                continue
            word = line.split()
            t = datetime.datetime(*map(int, word[2:7])) + datetime.timedelta(seconds=float(word[7]))
            row = self.rows[t, word[1]]
            self.assertEqual(int(word[8]), 2)
            self.assertAlmostEqual(float(word[9]), float(row["clock_s"]), delta=1e-15)
            self.assertAlmostEqual(float(word[10]), float(row["clock_sigma_s"]), delta=1e-15)
            n += 1
        self.assertEqual(n, sum(r["clock_s"] != "" for r in self.rows.values()))

    def test_attitude(self):
        """The body's Z looks to the Earth, its Y stands across the Sun, its X towards it."""
        lines = self.states("orbex", "day.obx").read_text(encoding="ascii").splitlines()
        self.assertEqual((lines[0], lines[-1]), ("%=ORBEX  0.09", "%END_ORBEX"))
        head = lines[:lines.index("-FILE/DESCRIPTION")]
        self.assertIn(" FRAME_TYPE          ECEF", head)
        t, left, n = None, 0, 0
        for line in lines[lines.index("+EPHEMERIS/DATA") + 1:lines.index("-EPHEMERIS/DATA")]:
            word = line.split()
            if line.startswith("##"):
                self.assertEqual(left, 0)
                t, left = datetime.datetime(*map(int, word[1:6])) + datetime.timedelta(seconds=float(word[6])), int(word[7])
            elif line.startswith(" ATT"):
                left -= 1
                n += 1
                self.assertEqual((line[5:8], word[2]), (word[1], "4"))
                q = [float(x) for x in word[3:]]
                self.assertAlmostEqual(sum(x * x for x in q), 1, delta=1e-14)
                row = self.rows[t, word[1]]
                r = [float(row[k]) for k in ("x_m", "y_m", "z_m")]
                z = turn(q, [-x / math.hypot(*r) for x in r])
                self.assertLess(math.dist(z, (0, 0, 1)), 1e-9)
                sun = turn(q, sun_at(t))
                self.assertLess(abs(sun[1]), 4e-4)  # the almanac's formula is good to 0.01 deg
                self.assertGreater(sun[0], 0)
        self.assertEqual((left, n), (0, len(self.rows)))

    def test_oem(self):
        """Read as any reader of the message does: what stands in it, and the states between by the interpolation that it names."""
        for frame, name in (("ecef", "ITRF2020"), ("inertial", "GCRF")):
            segments = oem.read(self.states("oem", frame + ".oem", "--frame", frame))
            self.assertEqual(sorted(s.meta["OBJECT_NAME"] for s in segments), sorted(SATS))
            rows = {(instant(r["t_gps"]), r["sat"]): r
                    for r in csv.DictReader(run("states", self.product, "--step", "450", "--frame", frame).stdout.splitlines())}
            seen = 0
            for s in segments:
                self.assertEqual((s.meta["REF_FRAME"], s.meta["TIME_SYSTEM"], s.meta["CENTER_NAME"]), (name, "GPS", "EARTH"))
                for (t, sat), row in rows.items():
                    if sat != s.meta["OBJECT_NAME"]:
                        continue
                    pos, vel = s.at(t)
                    seen += 1
                    inside = t in s.epochs
                    for k, key in enumerate("xyz"):
                        # Hermite's polynomial of degree 7 through four nodes 900 s apart: 0.02 mm in the middle of them, r n^8 (450 1350)^4 / 8!;
                        # at the ends of a segment, where all nodes lie to one side, fifty times as much.
                        self.assertAlmostEqual(1e3 * pos[k], float(row[key + "_m"]), delta=2e-6 if inside else 2e-3)
                        self.assertAlmostEqual(1e3 * vel[k], float(row[f"v{key}_mps"]), delta=2e-9 if inside else 2e-5)
            self.assertEqual(seen, len(rows))

    def test_a_message_that_is_wrong_is_refused(self):
        """The reader of these tests is judged too."""
        good = self.states("oem", "good.oem").read_text(encoding="ascii")
        for old, new, words in (("OBJECT_ID = G01\n", "", "OBJECT_ID"), ("META_STOP", "META_END", "META"), ("CENTER_NAME = EARTH\nREF_FRAME = ITRF2020\n", "REF_FRAME = ITRF2020\nCENTER_NAME = EARTH\n", "order"),
                                ("2025-03-21T00:15:00 ", "2025-03-20T00:15:00 ", "ascend"), ("STOP_TIME = 2025-03-22", "STOP_TIME = 2025-03-21", "STOP_TIME"), ("VERS = 2.0", "VERS = 9.0", "version")):
            bad = pathlib.Path(self.path("bad.oem"))
            self.assertIn(old, good)
            bad.write_text(good.replace(old, new, 1), encoding="ascii")
            with self.assertRaisesRegex(ValueError, words):
                oem.read(bad)

    def test_netcdf(self):
        path = self.states("netcdf", "day-states.nc")
        python = next((p for p in ("/usr/bin/python3", sys.executable) if subprocess.run([p, "-c", "import xarray, netCDF4"], capture_output=True, check=False).returncode == 0), None)
        if python is None:
            self.skipTest("python3-xarray is not installed")
        told = json.loads(subprocess.run([python, "-c", CF, path], capture_output=True, text=True, check=True).stdout)
        self.assertTrue(told["conventions"].startswith("CF-"))
        self.assertIn("satellite_name", told["coords"])  # named by every variable's `coordinates`
        self.assertEqual(told["names"], sorted(SATS, key=lambda s: ("GREC".index(s[0]), s)))
        self.assertEqual({k: v for k, v in told["units"].items() if v is None}, {"flags": None})
        for i, t in enumerate(told["t"]):
            for k, sat in enumerate(told["names"]):
                row = self.rows[instant(t[:19]), sat]
                for a, key in enumerate("xyz"):
                    self.assertAlmostEqual(told["pos"][i][k][a], float(row[key + "_m"]), delta=1e-6)
                    self.assertAlmostEqual(told["vel"][i][k][a], float(row[f"v{key}_mps"]), delta=1e-9)
                self.assertAlmostEqual(told["clock"][i][k], float(row["clock_s"]), delta=1e-15)
        self.assertIn("--output FILE", run("states", self.product, "--format", "netcdf", status=2).stderr)

    def test_hours(self):
        """Ten a second, a file an hour: together they are the whole, and each begins where the one before ended."""
        folder = pathlib.Path(self.path("hours"))
        ask = ("states", self.product, "--step", "0.1", "--format", "sp3", "--sat", "G05", "--from", "2025-03-21T10:59:00", "--to", "2025-03-21T11:01:00")
        run(*ask, "-o", folder, "--split", "1h")
        names = sorted(p.name for p in folder.iterdir())
        self.assertEqual(names, ["ORR0OPSFIN_20250801000_01H_10Z_ORB.SP3", "ORR0OPSFIN_20250801100_01H_10Z_ORB.SP3"])
        whole = pathlib.Path(self.path("whole.sp3"))
        run(*ask, "-o", whole)

        def body(path):
            lines = path.read_text(encoding="ascii").splitlines()
            return lines[next(i for i, line in enumerate(lines) if line.startswith("*")):-1]

        parts = [body(folder / n) for n in names]
        self.assertEqual(parts[0] + parts[1], body(whole))
        self.assertEqual([sum(line.startswith("*") for line in p) for p in parts], [600, 601])
        self.assertIn("--output DIR", run(*ask, "--split", "1h", status=2).stderr)
        (folder / names[0]).write_text("mine", encoding="ascii")
        self.assertIn("was not written by Orrery", run(*ask, "-o", folder, "--split", "1h", status=1).stderr)


def turn(q, v):
    """q (0, v) conj(q)."""
    w, x, y, z = q
    t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])]
    return [v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2], v[2] + w * t[2] + x * t[1] - y * t[0]]


def sun_at(t):
    """Direction of the Sun in the Earth's axes by the Astronomical Almanac's low-precision formula (page C5)."""
    d = (t - datetime.datetime(2000, 1, 1, 12)).total_seconds() / 86400 - 18 / 86400  # UT, about
    g, mean = math.radians(357.528 + 0.9856003 * d), 280.460 + 0.9856474 * d
    lon, tilt = math.radians(mean + 1.915 * math.sin(g) + 0.020 * math.sin(2 * g)), math.radians(23.439 - 4e-7 * d)
    x, y, z = math.cos(lon), math.cos(tilt) * math.sin(lon), math.sin(tilt) * math.sin(lon)
    turned = math.radians(280.46061837 + 360.98564736629 * d)
    return [x * math.cos(turned) + y * math.sin(turned), y * math.cos(turned) - x * math.sin(turned), z]


if __name__ == "__main__":
    import unittest
    unittest.main()
