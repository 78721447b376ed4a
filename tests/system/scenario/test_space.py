# SPDX-License-Identifier: GPL-3.0-or-later
"""Receivers in space: what they see, judged by geometry of the test's own; where RTKLIB finds them; what the ionosphere leaves."""
import csv
import datetime
import math
import pathlib
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import ORRERY, Folder, run, sample  # noqa: E402

A, B = 6378137.0, 6356752.314245
CONF = {"pos1-posmode": "single", "pos1-frequency": "l1", "pos1-ionoopt": "off", "pos1-tropopt": "off", "pos1-sateph": "precise",
        "pos1-elmask": "0", "pos1-navsys": "1", "out-solformat": "xyz", "out-outhead": "off", "out-timesys": "gpst"}


def lowest_m(a, b):
    """Height above the ellipsoid of the lowest point of a straight line, by bisection of the angle and Bowring's first step."""
    best = math.inf
    low, high = 0.0, 1.0

    def height(u):
        x, y, z = (p + u * (q - p) for p, q in zip(a, b))
        p = math.hypot(x, y)
        beta = math.atan2(z * A, p * B)
        lat = math.atan2(z + (A * A - B * B) / B * math.sin(beta)**3, p - (A * A - B * B) / A * math.cos(beta)**3)
        return p * math.cos(lat) + z * math.sin(lat) - A * math.sqrt(1 - (1 - (B / A)**2) * math.sin(lat)**2)

    for _ in range(100):
        u, v = low + (high - low) / 3, high - (high - low) / 3
        if height(u) < height(v):
            high = v
        else:
            low = u
        best = min(best, height(u), height(v))
    return best


class Space(Folder):
    """An orbit at 500 km under the made constellation, ten minutes."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        run("orbit", "-q", "-o", cls.path("day.nc"), "--sat", "G", sample("ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"))
        cls.scenario("leo.yaml", "signals: ['G:L1CA']\ntroposphere: {model: saastamoinen}\n")
        run("simulate", cls.path("leo.yaml"), "-o", cls.path("leo"), "--from", "2025-03-21T12:00:00", "--to", "2025-03-21T12:10:00",
            "--step", "30s", "--no-imu")
        with open(cls.path("leo/receiver-track.csv"), encoding="ascii") as f:
            cls.track = {r["t_gps"]: tuple(float(r[k]) for k in ("x_m", "y_m", "z_m")) for r in csv.DictReader(f)}
        with open(cls.path("leo/receiver-channels.csv"), encoding="ascii") as f:
            cls.channels = list(csv.DictReader(f))

    @classmethod
    def scenario(cls, name, more, motion="elements: {semimajor_axis: 6878137, inclination: 97.4, node: 30, mean_anomaly: 100}"):
        text = ("orbit: {product: day.nc}\ntrajectory: {kind: orbit, start: 2025-03-21T12:00:00, duration: 20min, " + motion + "}\n"
                "mask: {elevation: -90}\n" + more)
        (cls.folder / name).write_text(text, encoding="ascii")

    def states(self, when):
        rows = csv.DictReader(run("states", self.path("day.nc"), "--from", when, "--to", when, "--step", "1").stdout.splitlines())
        return {r["sat"]: tuple(float(r[k]) for k in ("x_m", "y_m", "z_m")) for r in rows}

    def test_the_earth_and_its_air_hide_what_is_behind(self):
        below = 0
        for when in sorted(self.track)[::5]:
            seen = {r["sat"] for r in self.channels if r["t_gps"] == when}
            want = set()
            for sat, place in self.states(when).items():
                lowest = lowest_m(self.track[when], place)
                # Nearer than 2 km either is right: the satellite is where it was when its signal left it.
                if lowest > 102e3 or (lowest > 98e3 and sat in seen):
                    want.add(sat)
            self.assertEqual(seen, want, when)
            below += sum(float(r["el_deg"]) < 0 for r in self.channels if r["t_gps"] == when)
        self.assertGreater(below, 5)
        self.assertTrue(all(float(r["troposphere_hydrostatic_m"]) == 0 for r in self.channels))
        # Beyond the Earth's limb a satellite's antenna radiates less: nobody below the level is as strong as overhead.
        self.assertLess(max(float(r["power_dbw"]) for r in self.channels if float(r["el_deg"]) < -15),
                        max(float(r["power_dbw"]) for r in self.channels))

    def test_rtklib_finds_the_receiver(self):
        folder = self.folder / "leo"
        (folder / "conf").write_text("".join(f"{k} ={v}\n" for k, v in CONF.items()), encoding="ascii")
        subprocess.run(["rnx2rtkp", "-k", "conf", "-o", "out.pos", "receiver.rnx", "broadcast.rnx", "truth.sp3", "truth.clk"], cwd=folder,
                       check=True, capture_output=True, timeout=200)
        far = []
        for line in (folder / "out.pos").read_text(encoding="ascii").splitlines():
            if line[0] == "%":
                continue
            f = line.split()
            at = datetime.datetime.strptime(f[0] + " " + f[1][:8], "%Y/%m/%d %H:%M:%S").strftime("%Y-%m-%dT%H:%M:%S")
            far.append(math.dist(self.track[at], tuple(map(float, f[2:5]))))
        self.assertGreater(len(far), 18)
        print(f"RTKLIB: {len(far)} epochs, {max(far):.4f} m at most from the orbit")
        # Codes are rounded to a millimetre, and RTKLIB 2.4.3 has no Shapiro term, 2 cm.
        self.assertLess(max(far), 0.1)

    def test_a_satellite_of_a_product_is_where_it_has_it(self):
        self.scenario("ride.yaml", "signals: ['G:L1CA']\nsatellites: {exclude: G05}\n", "product: day.nc, sat: G05")
        run("simulate", self.path("ride.yaml"), "-o", self.path("ride"), "--from", "2025-03-21T12:00:00", "--to", "2025-03-21T12:10:00",
            "--step", "60s", "--no-imu")
        with open(self.path("ride/receiver-track.csv"), encoding="ascii") as f:
            for r in csv.DictReader(f):
                place = self.states(r["t_gps"])["G05"]
                self.assertLess(math.dist(place, tuple(float(r[k]) for k in ("x_m", "y_m", "z_m"))), 1e-4, r["t_gps"])

    def test_delays_above_the_shell(self):
        """500 km is above the shell of 450 km: upward nothing, and what goes down through it meets it twice."""
        self.scenario("delays.yaml", f"signals: ['G:L1CA']\nionosphere: {{field: {sample('ionosphere.ION')}}}\n")
        text = run("delays", self.path("delays.yaml"), "--mask", "-90", "--from", "2025-03-21T12:00:00", "--to", "2025-03-21T12:10:00",
                   "--step", "60").stdout
        rows = list(csv.DictReader(text.splitlines()))
        up = [r for r in rows if float(r["el_deg"]) >= 0]
        down = [r for r in rows if float(r["el_deg"]) < -15]  # 500 km is above 450 km by 7 degrees of dip
        self.assertGreater(len(up), 50)
        self.assertGreater(len(down), 5)
        self.assertTrue(all(float(r["stec_tecu"]) == 0 for r in up))
        for r in down:
            self.assertGreater(float(r["stec_tecu"]), 2 * 1.5 * 0.5 * float(r["vtec_tecu"]))

    def test_what_cannot_be_is_said(self):
        for motion, word in (("product: day.nc, sat: G99", "G99"), ("product: day.nc, sat: moon", "moon"),
                             ("product: missing.nc, sat: G05", "missing.nc")):
            self.scenario("bad.yaml", "signals: ['G:L1CA']\n", motion)
            done = subprocess.run([ORRERY, "check", self.path("bad.yaml")], capture_output=True, text=True, check=False,
                                  timeout=60)
            self.assertNotEqual(done.returncode, 0, motion)
            self.assertIn(word, done.stderr, motion)


if __name__ == "__main__":
    unittest.main()
