# SPDX-License-Identifier: GPL-3.0-or-later
"""`orrery export`: every format read back by the readers beside the samples, which are written from the formats' own documents."""
import csv
import math
import pathlib
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent.parent / "samples/exports"))
import read_novatel  # noqa: E402
import read_vectornav  # noqa: E402
from program import Folder, run, sample  # noqa: E402

WEEK_S = 604800


def place_of(lat_deg, lon_deg, height_m):
    """In the Earth's axes, WGS 84."""
    lat, lon = math.radians(lat_deg), math.radians(lon_deg)
    e2 = 0.00669437999014
    n = 6378137 / math.sqrt(1 - e2 * math.sin(lat) ** 2)
    return ((n + height_m) * math.cos(lat) * math.cos(lon), (n + height_m) * math.cos(lat) * math.sin(lon), (n * (1 - e2) + height_m) * math.sin(lat))


class Export(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        run("imu", sample("survey.yaml"), "--duration", "20s", "-o", cls.path("imu.nc"), "--errors", sample("sensors/tactical.yaml"))
        run("imu", sample("survey.yaml"), "--duration", "20s", "-o", cls.path("imu.csv"), "--errors", sample("sensors/tactical.yaml"))
        with open(cls.path("imu.csv")) as file:
            cls.rows = list(csv.DictReader(file))
        def readings(prefix):
            return [[float(r[f"{prefix}d{q}"]) for q in ("theta_x_rad", "theta_y_rad", "theta_z_rad", "v_x_mps", "v_y_mps", "v_z_mps")] for r in cls.rows[1:]]
        cls.ideal, cls.measured = readings(""), readings("measured_")

    def export(self, to, *more):
        run("export", self.path("imu.nc"), "--to", to, "-o", self.path(to), "--force", *more)
        return pathlib.Path(self.path(to)).read_bytes()

    def numbers(self, data, separator=","):
        return [[float(v) for v in line.split(separator)] for line in data.decode().splitlines() if line[0] in "-0123456789"]

    def test_texts(self):
        gyro, accel = slice(0, 3), slice(3, 6)
        swap = lambda v: [v[1], v[0], -v[2]]  # noqa: E731
        self.assertEqual([r[:6] for r in self.numbers(self.export("psins"), " ")], self.ideal)
        pyins = self.numbers(self.export("pyins"))
        self.assertEqual([r[1:] for r in pyins[1:]], [swap(r[gyro]) + swap(r[accel]) for r in self.ideal])
        self.assertEqual(pyins[0][1:], pyins[1][1:])
        navego = self.numbers(self.export("navego", "--of", "measured"))
        instinct = self.numbers(self.export("instinct", "--of", "measured"))
        for k, r in enumerate(self.measured):
            want = [100 * v for v in swap(r[accel]) + swap(r[gyro])]
            for found in (navego[k][1:], instinct[k][5:]):
                for a, b in zip(found, want):
                    self.assertAlmostEqual(a, b, 12)
            self.assertAlmostEqual(navego[k][0], (k + 1) / 100, 9)
            self.assertAlmostEqual(instinct[k][0], (k + 0.5) / 100, 9)
        self.assertIn("2000 readings", subprocess.run([sys.executable, sample("exports/read_instinct.py"), self.path("instinct")], capture_output=True, text=True, check=True).stdout)

    def test_messages(self):
        sums = [0.0] * 6
        for (week, seconds, angle, velocity), want, row in zip(read_novatel.messages(self.export("novatel")), self.ideal, self.rows[1:]):
            self.assertAlmostEqual(week * WEEK_S + seconds, 2300 * WEEK_S + 36000 + float(row["t_s"]), 5)
            for k, (found, true) in enumerate(zip(angle + velocity, want)):
                sums[k] += found - true
                self.assertLess(abs(sums[k]), 0.51 * (1e-9 if k < 3 else 2e-8))  # what is left over is carried on
        n = 0
        for ns, length, angle, velocity in read_vectornav.messages(self.export("vectornav")):
            want = self.ideal[n]
            n += 1
            self.assertEqual(ns, (2300 * WEEK_S + 36000) * 10**9 + n * 10**7)
            self.assertAlmostEqual(length, 0.01, 9)
            for found, true in zip(angle, (want[1], want[0], -want[2])):
                self.assertLess(abs(found / 57.29577951308232 - true), 6e-8 * max(abs(v) for v in want[:3]))
            for found, true in zip(velocity, (want[4], want[3], -want[5])):
                self.assertLess(abs(found - true), 6e-8 * max(abs(v) for v in want[3:]))
        self.assertEqual(n, 2000)

    def test_motion_for_simulators(self):
        """gps-sdr-sim's two forms and Skydel's rows hold the same places; the first is read back as a log."""
        plan, table = sample("survey.yaml"), {}
        for form in ("csv", "gps-sdr-sim", "gps-sdr-sim-llh", "skydel"):
            text = run("track", plan, "--duration", "20", "--rate", "10", "--format", form).stdout.splitlines()
            table[form] = [[float(x) for x in line.split(",")[:7]] for line in text if not line[0].isalpha()]
            self.assertEqual(len(table[form]), 201)
        for at, ecef, llh, sky in zip(*table.values()):
            self.assertAlmostEqual(at[0], ecef[0], places=6)
            self.assertAlmostEqual(1e3 * at[0], sky[0], places=6)
            self.assertEqual(ecef[1:], sky[1:4])
            for k in range(3):
                self.assertAlmostEqual(llh[1 + k], at[1 + k], delta=1.1e-4 if k == 2 else 1.1e-10)
            for k, place in enumerate(place_of(*at[1:4])):
                self.assertAlmostEqual(place, ecef[1 + k], delta=3e-4)
            for k in range(3):
                self.assertAlmostEqual(math.degrees(sky[4 + k]), at[4 + k], delta=1e-6)
        log = self.path("motion.csv")
        run("track", plan, "--duration", "20", "--format", "gps-sdr-sim", "-o", log)
        back = run("track", "--telemetry", log, "--start", "2024-02-04T10:00:00", "--rate", "10").stdout.splitlines()[1:]
        for line, at in zip(back, table["csv"]):
            word = [float(x) for x in line.split(",")[:4]]
            self.assertLess(math.dist(place_of(*word[1:]), place_of(*at[1:4])), 0.02)
        # Skydel's rows name their columns; SimGEN's MOT records have them declared.
        sky, umt = self.path("motion-skydel.csv"), self.path("motion.umt")
        run("track", plan, "--duration", "20", "--format", "skydel", "-o", sky)
        with open(umt, "w", encoding="ascii") as file:
            for t_ms, x, y, z, *angles in table["skydel"]:
                file.write(f"00:00:{t_ms / 1e3:06.3f},mot,v1_m1,{x:.4f},{y:.4f},{z:.4f}," + "0," * 9 +
                           ",".join(f"{a:.9f}" for a in angles) + ",0" * 9 + "\n")
        columns = "t,-,-,x,y,z," + "-," * 9 + "heading[rad],pitch[rad],roll[rad]" + ",-" * 9
        for name, more in ((sky, ()), (umt, ("--columns", columns))):
            back = run("track", "--telemetry", name, *more, "--start", "2024-02-04T10:00:00", "--rate", "10").stdout.splitlines()[1:]
            self.assertEqual(len(back), 201)
            for line, at in zip(back, table["csv"]):
                word = [float(x) for x in line.split(",")[:7]]
                self.assertLess(math.dist(place_of(*word[1:4]), place_of(*at[1:4])), 0.02)
                for k in range(4, 7):
                    self.assertLess(abs((word[k] - at[k] + 180) % 360 - 180), 0.02)
        self.assertIn("ten places a second", run("track", plan, "--format", "gps-sdr-sim", "--rate", "5", status=2).stderr)

    def test_truth_and_refusals(self):
        self.export("pyins", "--truth", self.path("truth.csv"))
        with open(self.path("truth.csv")) as file:
            first = next(csv.DictReader(file))
        for ours, theirs, sign in (("lat_deg", "lat", 1), ("height_m", "alt", 1), ("v_up_mps", "VD", -1), ("v_north_mps", "VN", 1), ("heading_deg", "heading", 1)):
            self.assertAlmostEqual(float(self.rows[0][ours]), sign * float(first[theirs]), 6)
        run("imu", sample("still.yaml"), "--duration", "2s", "-o", self.path("still.nc"))
        self.assertIn("--errors", run("export", self.path("still.nc"), "--to", "psins", "--of", "measured", "-o", "-", status=1).stderr)
        run("export", self.path("still.nc"), "--to", "matlab", status=2)


if __name__ == "__main__":
    unittest.main()
