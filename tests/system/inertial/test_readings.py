#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""orrery imu, nulltest, gravimetry and track on scenarios: what the files hold against closed forms and against each other,
against what docs/inertial.md says of them, and how they refuse."""
import csv
import hashlib
import io
import math
import os
import pathlib
import re
import signal
import struct
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import ORRERY, ROOT, Folder, dump, run, run_json, sample  # noqa: E402

EARTH_RATE = 7.292115e-5  # rad/s, of the inertial room
A_M, E2 = 6378137.0, 6.69437999014132e-3  # WGS 84
SURVEY = ("imu", sample("survey.yaml"), "-q", "--duration", "120")


def normal_gravity(lat):
    """Somigliana's formula on the WGS 84 ellipsoid (NIMA TR8350.2, table 3.4)."""
    s2 = math.sin(lat) ** 2
    return 9.7803253359 * (1 + 0.00193185265241 * s2) / math.sqrt(1 - E2 * s2)


def ecef(lat, lon, h):
    n = A_M / math.sqrt(1 - E2 * math.sin(lat) ** 2)
    return ((n + h) * math.cos(lat) * math.cos(lon), (n + h) * math.cos(lat) * math.sin(lon), (n * (1 - E2) + h) * math.sin(lat))


def table(text):
    """Rows of a CSV as numbers by column; lines of '#' are comments."""
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    return [{k: float(v) for k, v in row.items() if k != "t_gps"} for row in csv.DictReader(io.StringIO("\n".join(lines)))]


def vector(row, *names):
    return [row[name] for name in names]


def turned(q, v):
    """q* v q: the components of v in the newer frame."""
    w, x, y, z = q
    # conj(q) v
    a = (x * v[0] + y * v[1] + z * v[2], w * v[0] - y * v[2] + z * v[1], w * v[1] - z * v[0] + x * v[2], w * v[2] - x * v[1] + y * v[0])
    return (a[0] * x + a[1] * w + a[2] * z - a[3] * y, a[0] * y - a[1] * z + a[2] * w + a[3] * x,
            a[0] * z + a[1] * y - a[2] * x + a[3] * w)


class Readings(Folder):
    def scenario(self, name, text):
        pathlib.Path(self.path(name)).write_text(text, encoding="utf-8")
        return self.path(name)

    def still(self, lat=50, heading=0, pitch=0, roll=0, extra=""):
        return self.scenario("still.yaml", f"trajectory: {{kind: analytic, duration: 100, lat: {lat}, lon: 20, "
                             f"body: {{heading: {heading}, pitch: {pitch}, roll: {roll}}}}}\n{extra}")

    def test_a_unit_at_rest_reads_gravity_and_the_earth(self):
        for lat in (0, 50, -80):
            phi = math.radians(lat)
            rows = table(run("imu", "-q", self.still(lat), "--rate", "20", "-o", "-").stdout)
            self.assertEqual(len(rows), 2001)  # edges
            for row in rows[1:]:
                # the table's constants carry 11 digits; matrices and rates of the order 1 round to 1e-16
                self.assertAlmostEqual(row["dv_z_mps"] * 20, normal_gravity(phi), delta=2e-10)
                self.assertAlmostEqual(row["dtheta_y_rad"] * 20, EARTH_RATE * math.cos(phi), delta=1e-16)
                self.assertAlmostEqual(row["dtheta_z_rad"] * 20, EARTH_RATE * math.sin(phi), delta=1e-16)
                for name in ("dv_x_mps", "dv_y_mps", "dtheta_x_rad"):
                    self.assertAlmostEqual(row[name], 0, delta=1e-15)

    def test_axes_are_right_forward_up(self):
        """Nose East: the Earth turns about what is left of it. Nose up: forward reads gravity. Right wing down: right reads less."""
        g = normal_gravity(math.radians(50))
        east = table(run("imu", "-q", self.still(heading=90), "-o", "-").stdout)[1]
        self.assertAlmostEqual(east["dtheta_x_rad"] * 100, -EARTH_RATE * math.cos(math.radians(50)), delta=1e-16)
        up = table(run("imu", "-q", self.still(pitch=30), "-o", "-").stdout)[1]
        self.assertAlmostEqual(up["dv_y_mps"] * 100, g * 0.5, delta=1e-9)
        down = table(run("imu", "-q", self.still(roll=30), "-o", "-").stdout)[1]
        self.assertAlmostEqual(down["dv_x_mps"] * 100, -g * 0.5, delta=1e-9)
        self.assertEqual(vector(down, "heading_deg", "pitch_deg"), [0.0, 0.0])
        self.assertAlmostEqual(down["roll_deg"], 30, delta=1e-9)

    def test_netcdf_and_csv_are_the_same_run(self):
        nc, text = self.path("run.nc"), self.path("run.csv")
        run(*SURVEY, "--rate", "7", "--truth-rate", "7", "--instantaneous", "-o", nc)
        run(*SURVEY, "--rate", "7", "--instantaneous", "-o", text)
        f, rows = dump(nc), table(pathlib.Path(text).read_text(encoding="utf-8"))
        self.assertEqual(len(rows), len(f["dtheta_rad"]) + 1)
        self.assertEqual([r["t_s"] for r in rows], [round(t, 9) for t in f["time_s"]])
        self.assertEqual([vector(r, "dtheta_x_rad", "dtheta_y_rad", "dtheta_z_rad") for r in rows[1:]], f["dtheta_rad"])
        self.assertEqual([vector(r, "dv_x_mps", "dv_y_mps", "dv_z_mps") for r in rows[1:]], f["dv_mps"])
        self.assertEqual([vector(r, "gyro_x_radps", "gyro_y_radps", "gyro_z_radps") for r in rows], f["gyro_radps"])
        self.assertEqual([vector(r, "accel_x_mps2", "accel_y_mps2", "accel_z_mps2") for r in rows], f["accel_mps2"])
        for row, r in zip(rows, f["position_m"]):  # 1e-11 deg is 1 um
            self.assertLess(math.dist(ecef(math.radians(row["lat_deg"]), math.radians(row["lon_deg"]), row["height_m"]), r), 2e-6)
        # An increment is the mean of the readings at its ends but for their second derivative: 0.03 m/s2 by wind and roll.
        for k, dv in enumerate(f["dv_mps"]):
            for i in range(3):
                self.assertAlmostEqual(dv[i] * 7, 0.5 * (f["accel_mps2"][k][i] + f["accel_mps2"][k + 1][i]), delta=0.03)

    def test_files_hold_what_the_page_says(self):
        page = (ROOT / "docs/inertial.md").read_text(encoding="utf-8").split("## Files")[1].split("\n## ")[0]
        nc = self.path("page.nc")
        run(*SURVEY, "--instantaneous", "-o", nc)
        f = dump(nc)
        said = re.findall(r"`(\w+)`", re.search(r"^\| NetCDF variables \|(.*)$", page, re.M).group(1))
        self.assertEqual(sorted(said), sorted(k for k, v in f.items() if isinstance(v, list)))
        for attribute in re.findall(r"`(\w+)`", re.search(r"^\| NetCDF numbers \|(.*)$", page, re.M).group(1)):
            self.assertIn(attribute, f)
        for command, args in (("imu", (*SURVEY[:-1], "1", "-o", "-")), ("track", ("track", sample("survey.yaml"), "--duration", "1")),
                              ("nulltest", ("nulltest", nc, "--csv", "-")),
                              ("gravimetry", ("gravimetry", nc, "--csv", "-", "--filter", "3"))):
            header = next(line for line in run(*args).stdout.splitlines() if not line.startswith("#"))
            self.assertIn(f"`{header}`", page, command)

    def test_the_same_question_gets_the_same_bytes(self):
        made = []
        for folder in ("one", "two"):
            pathlib.Path(self.path(folder)).mkdir()
            run(*SURVEY, "-o", "imu.nc", cwd=self.path(folder))
            made.append(pathlib.Path(self.path(folder), "imu.nc").read_bytes())
        self.assertEqual(made[0], made[1])
        text = pathlib.Path(sample("survey.yaml")).read_text(encoding="utf-8")
        seeds = [run("track", self.scenario(f"seed{k}.yaml", text.replace("seed: 1", f"seed: {k}")), "--duration", "60").stdout
                 for k in (1, 1, 2)]
        self.assertEqual(seeds[0], seeds[1])
        self.assertNotEqual(seeds[0], seeds[2])

    def test_every_rate_returns_the_trajectory(self):
        """Bars of an hour (0.1 mm at 100 Hz, 5 mm at 10 Hz) on two minutes; below, samples are coarser than the motion."""
        nc = self.path("rate.nc")
        for rate, bar in ((400, 1e-4), (100, 1e-4), (33.3, 1e-3), (10, 5e-3)):
            run(*SURVEY, "--rate", rate, "-o", nc)
            report = run_json("nulltest", nc, "--format", "json")
            self.assertLess(report["position"]["max_3d_m"], bar, rate)
            self.assertAlmostEqual(report["duration_s"], math.floor(120 * rate + 1e-6) / rate, delta=1e-9)
        for place in ("90,0", "56,180", "-90,0,30"):
            run(*SURVEY, "--transfer", place, "-o", nc)
            self.assertLess(run_json("nulltest", nc, "--format", "json")["position"]["max_3d_m"], 1e-4, place)
        run(*SURVEY, "--unit", "1", "-o", nc)
        self.assertLess(run_json("nulltest", nc, "--format", "json")["position"]["max_3d_m"], 1e-3)

    def test_matched_readings_suit_their_own_navigator_alone(self):
        nc = self.path("matched.nc")
        for frame in ("inertial", "geographic", "body"):
            for project in ("mid", "start"):
                run(*SURVEY, "--approach", "1", "--frame", frame, "--project", project, "--rate", "20", "-o", nc)
                own = run_json("nulltest", nc, "--format", "json")
                self.assertTrue(own["bit_identical"], (frame, project))
                self.assertLess(own["position"]["max_3d_m"], 50e-6, (frame, project))
                self.assertIn(frame, own["navigator"])
                other = run_json("nulltest", nc, "--format", "json", "--navigator", "reference")
                self.assertNotIn("bit_identical", other)
                self.assertGreater(other["position"]["max_3d_m"], 1e-3, (frame, project))
        refused = run("gravimetry", nc, status=1).stderr
        self.assertIn("approach 1", refused)

    def test_null_test_as_csv(self):
        nc = self.path("series.nc")
        run(*SURVEY, "--rate", "20", "-o", nc)
        every, tenth = (table(run("nulltest", nc, "--csv", "-", "--every", k).stdout) for k in (1, 10))
        self.assertEqual(tenth, every[::10])
        report = run_json("nulltest", nc, "--format", "json")
        self.assertEqual(report["compared"], len(every))
        largest = max(math.hypot(r["dxi1_m"], r["dxi2_m"], r["dxi3_m"]) for r in every)
        self.assertAlmostEqual(largest, report["position"]["max_3d_m"], delta=1e-7 * largest)
        for r in every:
            self.assertAlmostEqual(math.hypot(r["horizontal_m"], r["vertical_m"]), math.hypot(r["dxi1_m"], r["dxi2_m"], r["dxi3_m"]),
                                   delta=1e-7 * largest)

    def test_gravimetry_of_a_flight_due_east(self):
        """A straight flight over a mass: its disturbance is GM h/d^3, the Eotvoes term 2 u v cos(lat) + v^2/(N + h)."""
        v, gm, depth = 80.0, 2e5, 4000.0
        path = self.scenario("east.yaml", "trajectory: {kind: analytic, duration: 100, lat: 0, lon: 20, height: 1000, "
                             "motions: [{kind: straight, east: 80}]}\n"
                             f"gravity: {{masses: [{{lat: 0, lon: 20, height: {1000 - depth}, gm: {gm}}}]}}\n")
        nc = self.path("east.nc")
        run("imu", "-q", path, "-o", nc)
        rows = table(run("gravimetry", nc, "--filter", "2", "--csv", "-").stdout)
        eotvos = 1e5 * (2 * EARTH_RATE * v + v * v / (A_M + 1000))
        up, down = A_M + 1000, A_M + 1000 - depth  # radii on the equator
        for r in rows:
            turn = v * r["t_s"] / up
            towards = up - down * math.cos(turn)
            wanted = 1e5 * gm * towards / math.hypot(towards, down * math.sin(turn)) ** 3
            self.assertAlmostEqual(r["true_mgal"], wanted, delta=2e-3)  # two ends' mean, as below
            # The mean over 0.1 s against that of its ends: a twelfth of the second difference, 1.3e-3 in the middle; and 480 mGal
            # sideways in a vertical that turns by 4e-6 in half that time, 2e-3.
            self.assertAlmostEqual(r["recovered_mgal"], r["true_mgal"], delta=3.5e-3)
            self.assertAlmostEqual(r["eotvos_mgal"], eotvos, delta=1e-6)
        summary = run_json("gravimetry", nc, "--filter", "2", "--format", "json")
        self.assertEqual(summary["values"], len(rows))
        self.assertAlmostEqual(summary["true"]["max_mgal"], max(r["true_mgal"] for r in rows), delta=1e-6)
        self.assertLess(summary["difference"]["filtered_rms_mgal"], 0.01)

    def test_a_transfer_takes_the_masses_along(self):
        """49 mGal at home are 49 mGal over the pole (they were 0.000): lengths along the ground differ by at most 0.7 %."""
        path = self.scenario("moved.yaml", "trajectory: {kind: analytic, duration: 100, lat: 50, lon: 20, height: 1000, "
                             "motions: [{kind: straight, north: 80}]}\n"
                             "gravity: {masses: [{lat: 50.0359, lon: 20, height: -3000, gm: 7840}]}\n")
        nc, largest = self.path("moved.nc"), []
        for more in ((), ("--transfer", "90,0"), ("--transfer", "-20,180,70")):
            run("imu", "-q", path, *more, "-o", nc)
            largest.append(run_json("gravimetry", nc, "--filter", "2", "--format", "json")["true"]["max_mgal"])
            self.assertLess(run_json("nulltest", nc, "--format", "json")["position"]["max_3d_m"], 1e-4)
        self.assertAlmostEqual(largest[0], 49, delta=0.1)
        for other in largest[1:]:
            self.assertAlmostEqual(other, largest[0], delta=0.01 * 49)

    def test_errors_of_sensors_and_their_allan_deviation(self):
        """Each grade of samples/sensors is read; what it puts in as white noise comes back; the ideal readings stay beside it."""
        still, nc, ideal = self.scenario("allan.yaml", "trajectory: {kind: analytic, duration: 1000, lat: 50, lon: 20}\nimu: {rate: 20}\n"), \
            self.path("errors.nc"), self.path("ideal.nc")
        run("imu", "-q", still, "-o", ideal)
        clean = dump(ideal)["dv_mps"]
        white = {"gravimeter": 0.0015, "navigation": 0.002, "tactical": 0.125, "industrial-mems": 0.15, "consumer-mems": 0.6}
        for grade, root_hour in white.items():
            run("imu", "-q", still, "--errors", sample(f"sensors/{grade}.yaml"), "-o", nc)
            told = run_json("allan", nc, "--format", "json")
            self.assertAlmostEqual(told["longest_tau_s"], 5, delta=0.01)
            for axis in "xyz":
                n = told["noises"][f"gyro_{axis}"]["white noise"]
                self.assertAlmostEqual(n["value"] * 60 * 180 / math.pi / root_hour, 1, delta=0.03, msg=grade)
                self.assertLess(n["low"], n["value"])
                self.assertLess(n["value"], n["high"])
        file = dump(nc)
        self.assertEqual(file["dv_mps"], clean)
        self.assertNotEqual(file["measured_dv_mps"], clean)
        self.assertIn("Consumer MEMS", subprocess.run(["ncdump", "-h", nc], capture_output=True, text=True, check=True).stdout)
        self.assertLess(run_json("nulltest", nc, "--format", "json")["position"]["max_3d_m"], 1e-3)
        run("imu", "-q", still, "--errors", sample("sensors/tactical.yaml"), "-o", nc)
        strayed = run_json("nulltest", nc, "--readings", "measured", "--vertical", "held", "--format", "json")["position"]["max_3d_m"]
        self.assertGreater(strayed, 50)  # 1 mg of bias after 1000 s
        self.assertLess(strayed, 20000)
        rows = table(run("imu", "-q", still, "--errors", sample("sensors/tactical.yaml"), "--error-seed", "7", "--axes", "frd", "-o", "-").stdout)
        self.assertAlmostEqual(rows[5]["measured_dv_z_mps"], rows[5]["dv_z_mps"], delta=1e-2)
        curves = table(run("allan", nc, "--csv", "-").stdout.replace("gyro_", "").replace("accel_", "")
                       .replace("\nx,", "\n0,").replace("\ny,", "\n0,").replace("\nz,", "\n0,"))
        self.assertTrue(all(r["low"] < r["deviation"] < r["high"] for r in curves))
        self.assertIn("no readings with errors", run("nulltest", ideal, "--readings", "measured", status=1).stderr)
        self.assertIn("no readings with errors", run("allan", ideal, "--of", "errors", status=1).stderr)
        for text, sentence in (("gyro: {white: -1}\n", "white"), ("gyro: {instability: {sigma: 1, time: 0}}\n", "time"),
                               ("gyro: {bias: [1, 2]}\n", "2 values; one for all, or 3"), ("gyro: {drift: 1}\n", "unknown key"),
                               ("accelerometer: {limit: 0.5}\n", "measure nothing"), ("accelerometer: {g_sensitivity: 1}\n", "unknown key")):
            self.assertIn(sentence, run("imu", "-q", still, "--errors", self.scenario("bad.yaml", text), "-o", nc, status=1).stderr)

    def test_phases_from_rest_to_rest(self):
        """A unit that stands, takes off, climbs and lands: what it reads at rest is gravity, and the whole navigates back."""
        path = self.scenario("phases.yaml", "trajectory:\n  kind: phases\n  lat: 50\n  lon: 20\n  azimuth: 40\n  turbulence: {rms: 1}\n"
                             "  phases: [{kind: rest, duration: 60}, {kind: takeoff}, {kind: climb, height: 300}, {kind: landing, height: 0}, "
                             "{kind: rest, duration: 40}]\n")
        rows = table(run("imu", "-q", path, "--rate", "50", "-o", "-").stdout)
        g = normal_gravity(math.radians(50))
        for row in rows[1:1500]:
            self.assertAlmostEqual(row["dv_z_mps"] * 50, g, delta=1e-6)
            self.assertAlmostEqual(row["heading_deg"], 40, delta=1e-6)
        self.assertAlmostEqual(max(r["height_m"] for r in rows), 300, delta=25)  # a rounded top in turbulent air
        self.assertAlmostEqual(rows[-1]["height_m"], 0, delta=1e-4)
        self.assertLess(math.hypot(*vector(rows[-1], "v_east_mps", "v_north_mps", "v_up_mps")), 1e-6)
        nc = self.path("phases.nc")
        run("imu", "-q", path, "-o", nc)
        self.assertLess(run_json("nulltest", nc, "--format", "json")["position"]["max_3d_m"], 1e-4)
        self.assertIn("phase 2 (climb): the body is on the ground", run("track", self.scenario(
            "wrong.yaml", "trajectory: {kind: phases, lat: 50, lon: 20, phases: [{kind: rest, duration: 9}, {kind: climb, height: 9}]}\n"),
            status=1).stderr)

    def test_axes_forward_right_down(self):
        """Body axes forward, right, down and velocities North, East, Down: the same numbers in other places, and a file that
        comes back as it was."""
        ours, other = (self.path(f"{name}.nc") for name in ("rfu", "frd"))
        run(*SURVEY, "--instantaneous", "-o", ours)
        run(*SURVEY, "--instantaneous", "--axes", "frd", "-o", other)
        a, b = dump(ours), dump(other)
        for name in ("dtheta_rad", "dv_mps", "gyro_radps", "accel_mps2"):
            for (x, y, z), (f, r, d) in zip(a[name], b[name]):
                self.assertEqual((f, r, d), (y, x, -z), name)
        # v_body = q* v q: a vector along ecef's x, in both bodies.
        for q, p in zip(a["attitude"][::37], b["attitude"][::37]):
            x, y, z = turned(q, (1, 0, 0))
            for one, two in zip(turned(p, (1, 0, 0)), (y, x, -z)):
                self.assertAlmostEqual(one, two, delta=1e-14)
        self.assertAlmostEqual(run_json("nulltest", other, "--format", "json")["position"]["max_3d_m"],
                               run_json("nulltest", ours, "--format", "json")["position"]["max_3d_m"], delta=1e-6)
        rows = [[list(csv.DictReader(line for line in run(command, *SURVEY[1:], *more, "-o", "-").stdout.splitlines() if line[0] != "#"))
                 for more in ((), ("--axes", "frd"))] for command in ("imu", "track")]
        for ours, other in rows:
            for x, y in zip(ours[::50], other[::50]):
                self.assertEqual((x["v_north_mps"], x["v_east_mps"], float(x["v_up_mps"])),
                                 (y["v_north_mps"], y["v_east_mps"], -float(y["v_down_mps"])))
                self.assertEqual(x["heading_deg"], y["heading_deg"])
        self.assertIn("replayed to the bit", run(*SURVEY, "--approach", "1", "--axes", "frd", "-o", other, status=2).stderr)

    def test_the_quaternion_turns_vectors_into_the_body(self):
        """The example of docs/inertial.md: at rest on the equator at longitude 0, heading North, the body's axes are East, North, Up."""
        nc = self.path("still.nc")
        run("imu", "-q", self.scenario("equator.yaml", "trajectory: {kind: analytic, duration: 1, lat: 0, lon: 0}\n"), "-o", nc)
        q = dump(nc)["attitude"][0]
        for got, half in zip(q, (0.5, 0.5, 0.5, 0.5)):
            self.assertAlmostEqual(abs(got), half, delta=1e-9)
        for v, body in (((1, 0, 0), (0, 0, 1)), ((0, 1, 0), (1, 0, 0)), ((0, 0, 1), (0, 1, 0))):  # up, East, North
            for got, wanted in zip(turned(q, v), body):
                self.assertAlmostEqual(got, wanted, delta=1e-9)

    def test_a_transfer_takes_profiles_and_maps_along(self):
        """The flight meets over the pole what it met at home, and its file of readings knows where that lies."""
        motion = ("trajectory: {kind: analytic, duration: 100, lat: 50, lon: 20, height: 1000, motions: [{kind: straight, north: 80}]}\n")
        grid = "lat,lon,mgal\n" + "".join(f"{49.9 + 0.05 * i},{19.9 + 0.05 * k},{30 * math.sin(i + 2 * k):.4f}\n"
                                          for i in range(6) for k in range(6))
        pathlib.Path(self.path("map.csv")).write_text(grid, encoding="ascii")
        nc, series = self.path("moved.nc"), self.path("moved.csv")
        for name, gravity in (("profile", "{profile: {lat: 50, lon: 20, azimuth: 10, distance: [-9000, -2000, 1500, 4000, 9000], "
                                          "mgal: [0, 20, -15, 30, 0]}}"), ("map", "{file: map.csv}")):
            path, true = self.scenario(f"{name}.yaml", motion + f"gravity: {gravity}\n"), []
            for more in ((), ("--transfer", "90,0"), ("--transfer", "-20,180,70", "--transfer-attitude", "literal")):
                run("imu", "-q", path, *more, "-o", nc)
                run("gravimetry", nc, "--filter", "2", "--csv", series)
                with open(series, encoding="ascii") as file:
                    true.append([float(r["true_mgal"]) for r in csv.DictReader(file)])
                self.assertLess(run_json("nulltest", nc, "--format", "json")["position"]["max_3d_m"], 1e-4, name)
            self.assertGreater(max(true[0]) - min(true[0]), 5)
            for other in true[1:]:
                self.assertLess(max(abs(a - b) for a, b in zip(true[0], other)), 1e-4, name)

    def test_spherical_harmonics_and_their_folder(self):
        """A model of its central term alone, whose pull is closed: a unit at rest reads it, and the file of readings finds it again."""
        gm, lat = 3.9e14, math.radians(50)
        models = pathlib.Path(self.path("models"))
        models.mkdir()
        (models / "central.egm").write_text(
            "EGMF-1\nName central\nPublisher test\nReleaseDate 2024-01-01\nDataVersion 1\nModelRadius 6378137\n"
            f"ModelMass {gm}\nAngularVelocity 7.292115e-5\nReferenceRadius 6378137\nReferenceMass 3.986004418e14\n"
            "Flattening 1/298.257223563\nHeightOffset 0\nCorrectionMultiplier 1\nNormalization full\nID ORRTEST1\n", encoding="ascii")
        (models / "central.egm.cof").write_bytes(b"ORRTEST1" + struct.pack("<2i6d3d2i", 2, 2, *[0.0] * 9, -1, -1))
        path, nc = self.still(extra="gravity: {model: central, folder: models}\n"), self.path("central.nc")
        run("imu", "-q", path, "-o", nc)
        r = ecef(lat, math.radians(20), 0)
        size, axis = math.hypot(*r), math.hypot(*r[:2])
        up = gm / size ** 3 * (axis * math.cos(lat) + r[2] * math.sin(lat)) - EARTH_RATE ** 2 * axis * math.cos(lat)
        north = gm / size ** 3 * (r[2] * math.cos(lat) - axis * math.sin(lat)) + EARTH_RATE ** 2 * axis * math.sin(lat)
        f = dump(nc)
        self.assertAlmostEqual(f["dv_mps"][0][2] * 100, up, delta=1e-12)
        self.assertAlmostEqual(f["dv_mps"][0][1] * 100, north, delta=1e-12)
        self.assertAlmostEqual(f["gravity_disturbance"][0], 1e5 * (up - normal_gravity(lat)), delta=1e-4)
        self.assertLess(run_json("nulltest", nc, "--format", "json")["position"]["max_3d_m"], 1e-6)
        models.rename(self.path("elsewhere"))
        for command in ("nulltest", "gravimetry"):
            self.assertIn("central", run(command, nc, status=1).stderr)
            run(command, nc, "--gravity-folder", self.path("elsewhere"))

    def test_track_reads_back(self):
        """What track prints, read as a log, is the same flight: also at a rate whose times are no milliseconds."""
        for rate in ("2", "0.7"):
            log = self.path("again.csv")
            run("track", sample("two-hours.yaml"), "--duration", "300", "--rate", rate, "-o", log)
            first = table(pathlib.Path(log).read_text(encoding="utf-8"))
            for a, b in zip(first, first[1:]):
                self.assertAlmostEqual(b["t_s"] - a["t_s"], 1 / float(rate), delta=1e-8)
            self.assertEqual(len(first), math.floor(300 * float(rate)) + 1)

    def test_truth_no_denser_than_the_readings(self):
        for wish, instants in (("0.001", 2), ("7", 11), ("20", 21), ("1000", 21)):  # 7 Hz: every second of 20 Hz
            nc = self.path("truth.nc")
            run(*SURVEY[:-1], "1", "--rate", "20", "--truth-rate", wish, "-o", nc)
            self.assertEqual(len(dump(nc)["time_s"]), instants, wish)
            self.assertLess(run_json("nulltest", nc, "--format", "json")["position"]["max_3d_m"], 1e-3)

    def test_what_made_a_file_stands_in_it(self):
        field = self.scenario("field.csv", "lat,lon,mgal\n" + "".join(
            f"{49 + i},{19 + k},{i + 2 * k}\n" for i in range(4) for k in range(4)))
        path = self.still(extra="gravity: {file: field.csv}\nimu: {rate: 10}\n")
        nc = self.path("provenance.nc")
        run("imu", "-q", path, "--rate", "5", "-o", nc)
        head = subprocess.run(["ncdump", "-h", nc], capture_output=True, text=True, check=True).stdout
        self.assertIn("--rate 5", head)
        self.assertIn("still.yaml\\nfield.csv", head)
        self.assertAlmostEqual(dump(nc)["gravity_disturbance"][0], 3, delta=1e-9)  # a plane through 50 N, 20 E
        self.assertTrue(field)

    def test_a_map_of_gravity_in_netcdf(self):
        lats, lons = range(49, 53), range(19, 23)
        cdl = self.scenario("field.cdl", "netcdf field { dimensions: lat = 4; lon = 4; variables: double lat(lat); "
                            "double lon(lon); double disturbance(lat, lon); data: lat = " + ", ".join(map(str, lats)) +
                            "; lon = " + ", ".join(map(str, lons)) + "; disturbance = " +
                            ", ".join(str(a - 49 + 2 * (o - 19)) for a in lats for o in lons) + "; }\n")
        for kind in ("classic", "nc4"):
            subprocess.run(["ncgen", "-k", kind, "-o", self.path("field.nc"), cdl], check=True)
            path = self.still(extra="gravity: {file: field.nc}\nimu: {rate: 10}\n")
            nc = self.path("by-map.nc")
            run("imu", "-q", path, "--rate", "5", "-o", nc)
            self.assertAlmostEqual(dump(nc)["gravity_disturbance"][0], 3, delta=1e-9, msg=kind)
        with open(self.path("field.nc"), "r+b") as cut:
            cut.truncate(cut.seek(0, 2) // 2)
        refused = subprocess.run([ORRERY, "imu", "-q", path, "-o", self.path("none.nc")], capture_output=True, text=True)
        self.assertNotEqual(refused.returncode, 0)
        self.assertIn("field.nc", refused.stderr)

    def test_inspect_tells_what_a_file_holds(self):
        nc = self.path("told.nc")
        run(*SURVEY, "--rate", "25", "--start", "2024-02-04T23:59:00", "-o", nc)
        told = run_json("inspect", "--format", "json", nc)
        self.assertEqual((told["kind"], told["from"], told["to"], told["records"], told["interval_s"]),
                         ("netcdf", "2024-02-04T23:59:00", "2024-02-05T00:01:00", 3000, 0.04))
        self.assertIn("inertial readings", told["facts"]["product"])
        self.assertIn("approach 2", told["facts"]["mode"])
        self.assertIn("profile of 14 points", told["facts"]["gravity"])
        self.assertEqual(told["facts"]["made from"], "survey.yaml")
        model = self.scenario("gone.yaml", "trajectory: {kind: analytic, duration: 10, lat: 50, lon: 20}\n")
        run("imu", "-q", model, "--approach", "1", "-o", nc)
        told = run("inspect", nc).stdout
        self.assertIn("approach 1, inertial frame, projection at mid-step, closed loop", told)
        self.assertRegex(told, r"gravity +normal gravity; its truth beside")
        pathlib.Path(self.path("foreign.cdl")).write_text('netcdf foreign { dimensions: x = 2; variables: double v(x); data: v = 1, 2; }\n',
                                                         encoding="ascii")
        subprocess.run(["ncgen", "-4", "-o", self.path("foreign.nc"), self.path("foreign.cdl")], check=True)
        self.assertIn("neither orbits", run("inspect", self.path("foreign.nc"), status=1).stderr)

    def test_wrong_calls(self):
        nc = self.path("calls.nc")
        run(*SURVEY[:-1], "1", "-o", nc)
        for args, sentence in (
                (("imu",), "name a scenario"),
                (("imu", sample("survey.yaml"), "--telemetry", "x"), "not both"),
                (("imu", "--telemetry", "a", "--columns", "t", "--columns", "t"), "2 lists of columns for 1 logs"),
                (("imu", sample("survey.yaml"), "--unit", "5"), "0 to 1"),
                (("imu", sample("survey.yaml"), "--rate", "0"), "between"),
                (("imu", sample("survey.yaml"), "--rate", "nan"), "wants a number"),
                (("imu", sample("survey.yaml"), "-o", "-", "--truth-rate", "5"), "CSV"),
                ((*SURVEY, "--approach", "1", "--quadrature", "gauss"), "--quadrature applies only with --approach 2"),
                ((*SURVEY, "--approach", "1", "--order", "3"), "--order applies only with --approach 2"),
                ((*SURVEY, "--frame", "body"), "--frame applies only with --approach 1"),
                ((*SURVEY, "--loop", "open"), "--loop applies only with --approach 1"),
                ((*SURVEY, "--project", "start"), "--project applies only with --approach 1"),
                (("track", sample("survey.yaml"), "--degree", "5"), "--degree belongs to a log"),
                (("track", sample("survey.yaml"), "--report", "x.csv"), "--report belongs to a log"),
                (("track", sample("survey.yaml"), "--transfer", "91,0"), "LATITUDE,LONGITUDE"),
                (("track", sample("survey.yaml"), "--transfer", "1,2,3,4"), "LATITUDE,LONGITUDE"),
                (("track", sample("survey.yaml"), "--unit", "2"), "0 to 1"),
                (("nulltest", nc, "--csv", "-", "--format", "json"), "standard output"),
                (("nulltest", nc, "--navigator", "2-sample", "--samples", "4"), "reference"),
                (("nulltest",), "IMU"),
                (("gravimetry", nc, "--csv", "-", "--format", "json"), "standard output"),
                (("gravimetry", nc, "--filter", "0"), "positive")):
            done = run(*args, status=2)
            self.assertIn(sentence, done.stderr, args)
            self.assertEqual(done.stdout, "")

    def test_what_cannot_be_done(self):
        """One sentence each, status 1, and neither a file nor a part of one."""
        good = self.path("good.nc")
        run(*SURVEY[:-1], "1", "-o", good)
        csv_file = self.scenario("no.csv", "0,1\n")
        orbit = "trajectory: {kind: analytic, lat: 50, lon: 20, duration: 60, motions: [{kind: straight, north: 50}]}\n"
        before = self.left()
        for name, text, sentence in (
                ("none.yaml", "title: x\n", "trajectory"),
                ("long.yaml", "trajectory: {kind: analytic, lat: 50, lon: 20}\n", "duration"),
                ("pole.yaml", orbit.replace("lat: 50", "lat: 90"), "pole"),
                ("over.yaml", orbit.replace("lat: 50", "lat: 89.99"), "pole"),
                ("tight.yaml", "trajectory: {kind: waypoints, speed: 300, bank: 5, waypoints: [{lat: 50, lon: 20}, "
                 "{lat: 50.01, lon: 20}, {lat: 50, lon: 20.01}]}\n", "turn"),
                ("model.yaml", orbit + "gravity: {model: nosuch}\n", "nosuch"),
                ("folder.yaml", orbit + "gravity: {model: nosuch, folder: nowhere}\n", "nowhere"),
                ("leaves.yaml", orbit + "gravity: {profile: {lat: 50, lon: 20, distance: [-500, 0, 500], mgal: [1, 2, 3]}}\n", "covers")):
            done = run("imu", self.scenario(name, text), "-o", self.path("out.nc"), status=1)
            self.assertIn(sentence, done.stderr, name)
            self.assertNotIn("null", done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            pathlib.Path(self.path(name)).unlink()
        for args, sentence in (
                ((*SURVEY[:3], "--duration", "10", "--rate", "0.05"), "no sample"),
                ((*SURVEY, "--order", "7"), "1 to 5"), ((*SURVEY[:3], "--duration", "1h", "--rate", "100000"), "50000000"),
                ((*SURVEY, "--transfer", "90,0", "--approach", "1", "--frame", "geographic"), "pole")):
            self.assertIn(sentence, run(*args, "-o", self.path("out.nc"), status=1).stderr)
        for place in (self.path("no/imu.nc"), self.path("no/imu.csv")):
            self.assertIn("cannot be written", run(*SURVEY, "-o", place, status=1).stderr)
        for command in ("nulltest", "gravimetry"):
            self.assertIn("no NetCDF", run(command, csv_file, status=1).stderr)
            self.assertIn("cannot be opened", run(command, self.path("absent.nc"), status=1).stderr)
            self.assertIn("cannot be written", run(command, good, "--csv", self.path("no/x.csv"), *(
                ("--filter", "0.1") if command == "gravimetry" else ()), status=1).stderr)
        self.assertIn("needs a run", run("gravimetry", good, status=1).stderr)
        self.assertEqual(self.left(), before)
        # A file that is there stays as it is when its successor fails.
        kept = pathlib.Path(good).read_bytes()
        run(*SURVEY[:3], "--duration", "10", "--rate", "0.05", "-o", good, status=1)
        self.assertEqual(pathlib.Path(good).read_bytes(), kept)

    def test_damaged_files_are_told(self):
        nc = self.path("whole.nc")
        run(*SURVEY[:-1], "10", "-o", nc)
        whole = pathlib.Path(nc).read_bytes()
        bad = pathlib.Path(self.path("bad.nc"))
        for cut in (0, 3, 100, len(whole) // 2, len(whole) - 200):  # the seal is the last line
            bad.write_bytes(whole[:cut])
            for command in ("nulltest", "gravimetry"):
                self.assertIn("bad.nc", run(command, bad, status=1).stderr)
        for at in range(200, len(whole), len(whole) // 40):
            bad.write_bytes(whole[:at] + bytes([whole[at] ^ 0x55]) + whole[at + 1:])
            self.assertIn("bad.nc", run("nulltest", bad, status=1).stderr, at)

    def test_inputs_are_read_once(self):
        """A scenario and a log out of pipes: the bytes that were read are those that are hashed."""
        for how, source in (([], sample("survey.yaml")), (["--telemetry"], sample("telemetry.csv"))):
            with self.subTest(source=source):
                folder = pathlib.Path(self.path("pipe" + pathlib.Path(source).suffix[1:]))
                folder.mkdir()
                pipe, nc = folder / pathlib.Path(source).name, folder / "imu.nc"
                os.mkfifo(pipe)
                with subprocess.Popen(["cp", source, pipe]) as writer:
                    try:
                        run("imu", "-q", *how, pipe, "--rate", "5", "-o", nc)
                    finally:
                        writer.kill()
                head = subprocess.run(["ncdump", "-h", nc], capture_output=True, text=True, check=True).stdout
                self.assertIn(hashlib.sha256(pathlib.Path(source).read_bytes()).hexdigest(), head)

    def test_an_interrupt_leaves_a_whole_file_or_none(self):
        before = self.left()
        for wait_s in (0.02, 0.1, 0.3):
            with subprocess.Popen([ORRERY, "imu", "-q", sample("survey.yaml"), "--rate", "400", "-o", self.path("cut.nc")],
                                  stderr=subprocess.DEVNULL) as process:
                time.sleep(wait_s)
                process.send_signal(signal.SIGINT)
                status = process.wait(120)
            if status == 0:
                run("nulltest", self.path("cut.nc"))
                pathlib.Path(self.path("cut.nc")).unlink()
            self.assertEqual(self.left(), before)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
