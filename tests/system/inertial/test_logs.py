#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""orrery imu and track on recorded telemetry: made flights with known motion, and every way a log can be odd."""
import csv
import functools
import gzip
import io
import math
import operator
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import Folder, data, run, run_json, sample  # noqa: E402

HEADER = "t_s,lat_deg,lon_deg,height_m,heading_deg,pitch_deg,roll_deg"
E2 = 6.69437999014132e-3  # of WGS 84
RADIUS_M = 6371000.0  # of the made flights alone


def flight(seconds=60, rate=5, lat=50.0, lon=20.0, heading=0.0, speed=60.0):
    """A level great circle on a sphere of latitudes: rows of HEADER. Over a pole the longitude turns, the body does not."""
    p, l, a = math.radians(lat), math.radians(lon), math.radians(heading)
    start = (math.cos(p) * math.cos(l), math.cos(p) * math.sin(l), math.sin(p))
    ahead = (-math.sin(a) * math.sin(l) - math.cos(a) * math.sin(p) * math.cos(l),
             math.sin(a) * math.cos(l) - math.cos(a) * math.sin(p) * math.sin(l), math.cos(a) * math.cos(p))
    rows = []
    for k in range(seconds * rate + 1):
        w = speed * k / rate / RADIUS_M
        x, y, z = (math.cos(w) * s + math.sin(w) * h for s, h in zip(start, ahead))
        dx, dy, dz = (math.cos(w) * h - math.sin(w) * s for s, h in zip(start, ahead))
        p, l = math.atan2(z, math.hypot(x, y)), math.atan2(y, x)
        east = -dx * math.sin(l) + dy * math.cos(l)
        north = -(dx * math.cos(l) + dy * math.sin(l)) * math.sin(p) + dz * math.cos(p)
        rows.append((k / rate, math.degrees(p), math.degrees(l), 500.0, math.degrees(math.atan2(east, north)), 0.0, 0.0))
    return rows


def text(rows, header=HEADER):
    return "\n".join([header] + [",".join("" if v is None else repr(float(v)) if not isinstance(v, str) else v for v in r)
                                 for r in rows]) + "\n"


def track(out):
    lines = [line for line in out.splitlines() if not line.startswith("#")]
    return [{k: float(v) for k, v in row.items() if k != "t_gps"} for row in csv.DictReader(io.StringIO("\n".join(lines)))]


class Logs(Folder):
    def log(self, content, name="log.csv"):
        path = pathlib.Path(self.path(name))
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return str(path)

    def assert_same_way(self, rows, got, at, delta_m):
        """Places of `track` rows against the made ones; `at` maps their times to the log's."""
        made = {round(r[0], 6): r for r in rows}
        for g in got:
            r = made[round(at + g["t_s"], 6)]
            north = math.radians(g["lat_deg"] - r[1]) * RADIUS_M
            turn = (g["lon_deg"] - r[2] + 180) % 360 - 180
            east = math.radians(turn) * RADIUS_M * math.cos(math.radians(r[1]))
            self.assertLess(math.hypot(north, east, g["height_m"] - r[3]), delta_m, g)

    def test_a_clean_flight_anywhere(self):
        """A great circle is smooth: the splines return it within the rounding of the table, across pole and date line too."""
        for name, rows in (("mid", flight(heading=30)), ("date line", flight(lat=10, lon=179.99, heading=90)),
                           ("back over it", flight(lat=-10, lon=-179.99, heading=-90)), ("north pole", flight(lat=89.985)),
                           ("beside it", flight(lat=89.985, heading=10)), ("south pole", flight(lat=-89.985, heading=180))):
            log = self.log(text(rows))
            got = track(run("track", "-q", "--telemetry", log, "--rate", "5").stdout)
            self.assertEqual(len(got), len(rows), name)
            self.assert_same_way(rows, got, 0, 0.02)  # knots a second and the ellipsoid's flattening: mm
            nc = self.path("clean.nc")
            for rate in (20, 100, 250):
                run("imu", "-q", "--telemetry", log, "--rate", rate, "-o", nc)
                self.assertLess(run_json("nulltest", nc, "--format", "json")["position"]["max_3d_m"], 1e-4, (name, rate))

    def test_shapes_of_a_log_are_one_flight(self):
        """With a header, declared, without one, in other units, separators and order, compressed, in two files: the same table."""
        rows = flight(20)
        made = track(run("track", "-q", "--telemetry", self.log(text(rows))).stdout)
        two = [",".join(map(repr, r[:4])) for r in rows], [f"{r[0] * 1e3!r} {r[4]!r} {r[5]!r} {r[6]!r}" for r in rows]
        for args in (
                (self.log(text(rows).split("\n", 1)[1], "seven.csv"),),
                (self.log(text(rows).replace(",", ";"), "semi.csv"),),
                (self.log(text(rows).replace(",", "\t").replace("\n", "\r\n"), "tabs.csv"),),
                (self.log("\ufeff" + text(rows), "spreadsheet.csv"),),
                (self.log(gzip.compress(text(rows).encode()), "log.csv.gz"),),
                (self.log("# columns: t,lat,lon,height,heading,pitch,roll\n# more\n\n" + text(rows).split("\n", 1)[1], "comment.csv"),),
                (self.log(text([(r[1], r[2], "x", r[0], *r[3:]) for r in rows], "lat,lon,note,t,h,yaw,pitch,roll"), "order.csv"),),
                (self.log("\n".join(two[0]) + "\n", "places.csv"), "--columns", "t,lat,lon,height", "--telemetry",
                 self.log("\n".join(two[1]) + "\n", "angles.txt"), "--columns", "t[ms],heading,pitch,roll")):
            self.assertEqual(track(run("track", "-q", "--telemetry", *args).stdout), made, args)

    def test_nmea_and_motion_files(self):
        """The same flight as NMEA sentences over midnight (1e-6 of a minute is 2 mm) and as a user-motion file of ecef places."""
        rows, nmea, motion = flight(40, lat=-33.0, lon=-70.0, heading=200), "", ""
        for t, lat, lon, h, heading, _, _ in rows:
            clock = (86380 + t) % 86400
            hms = f"{int(clock // 3600):02}{int(clock // 60 % 60):02}{clock % 60:05.2f}"
            dm = [f"{int(abs(v)):0{n}}{abs(v) % 1 * 60:09.6f},{c[v < 0]}" for v, n, c in ((lat, 2, "NS"), (lon, 3, "EW"))]
            for body in (f"GPRMC,{hms},A,{dm[0]},{dm[1]},116.6,200.0,040224,,", f"GNGGA,{hms},{dm[0]},{dm[1]},1,12,0.8,{h - 30:.3f},M,30.0,M,,",
                         f"GNHDT,{heading % 360:.6f},T"):
                nmea += f"${body}*{functools.reduce(operator.xor, body.encode()):02X}\r\n"
            n = 6378137.0 / math.sqrt(1 - E2 * math.sin(math.radians(lat)) ** 2)
            p, l = math.radians(lat), math.radians(lon)
            motion += (f"{t:.1f},{(n + h) * math.cos(p) * math.cos(l):.6f},{(n + h) * math.cos(p) * math.sin(l):.6f},"
                       f"{(n * (1 - E2) + h) * math.sin(p):.6f}\n")
        done = run("track", "--telemetry", self.log(nmea, "flight.nmea"), "--rate", "5")
        self.assertIn("2024-02-04T23:59:58", done.stdout.splitlines()[1])  # 23:59:40 UTC
        self.assert_same_way(rows, track(done.stdout), 0, 0.02)
        for r, made in zip(track(done.stdout), rows):
            self.assertAlmostEqual(r["heading_deg"], made[4] % 360, delta=0.01)
        self.assert_same_way(rows, track(run("track", "-q", "--telemetry", self.log(motion, "motion.csv"), "--rate", "5").stdout), 0, 0.02)

    def test_absolute_times_set_the_start(self):
        rows = [(f"2024-02-04T12:00:{r[0]:06.3f}", *r[1:]) for r in flight(40)]
        made = run("track", "-q", "--telemetry", self.log(text(rows, HEADER.replace("t_s", "time(gps)")))).stdout
        self.assertIn("2024-02-04T12:00:00", made.splitlines()[1])
        made = run("track", "-q", "--telemetry", self.log(text(rows, HEADER.replace("t_s", "time(utc)")))).stdout
        self.assertIn("2024-02-04T12:00:18", made.splitlines()[1])  # leap seconds
        made = run("track", "-q", "--telemetry", self.log(text(flight(40))), "--start", "2300:43200").stdout
        self.assertIn("2024-02-04T12:00:00", made.splitlines()[1])

    def nmea(self, seconds, date="150824", name="made.nmea"):
        """A place a second, East at 10 m/s, from 10:00:00 UTC on."""
        made = ""
        for k in range(seconds):
            bodies = [f"GPGGA,1000{k:02}.00,0000.000000,N,00000.{k * 10 / 1855.3248:09.7f},E,1,08,1.0,100.0,M,47.0,M,,".replace(".0.", ".")]
            if date:
                bodies.insert(0, f"GPRMC,1000{k:02}.00,A,0000.0,N,00000.0,E,19.4,90.0,{date},,")
            made += "".join(f"${b}*{functools.reduce(operator.xor, b.encode()):02X}\r\n" for b in bodies)
        return self.log(made, name)

    def test_a_date_that_nothing_tells_is_said_to_be_assumed(self):
        done = run("track", "--telemetry", self.nmea(60, None))
        self.assertIn("2024-02-04T10:00:18", done.stdout.splitlines()[1])  # the time of day is kept
        self.assertIn("tells no date", done.stderr)
        done = run("track", "--telemetry", self.log(text(flight(40))))
        self.assertIn("tells no date", done.stderr)
        self.assertNotIn("tells no date", run("track", "--telemetry", self.nmea(60)).stderr)
        self.assertNotIn("tells no date", run("track", "--telemetry", self.log(text(flight(40))), "--start", "2300:0").stderr)

    def test_own_tables_come_back_to_the_instant(self):
        """track, and imu's CSV: read as logs, they are the same motion at the same instants."""
        first, again = self.path("first.csv"), self.path("again.csv")
        run("track", "-q", "--telemetry", self.nmea(60), "--rate", "5", "-o", first)
        for made in (first, self.path("imu.csv")):
            if made != first:
                run("imu", "-q", "--telemetry", first, "--rate", "10", "-o", made)
            done = run("track", "--telemetry", made, "-o", again)
            self.assertNotIn("tells no date", done.stderr)
            lines = pathlib.Path(again).read_text(encoding="utf-8").splitlines()
            self.assertEqual(lines[1].rsplit(",", 1)[1], "2024-08-15T10:00:18")
            self.assertNotIn("clock", done.stderr.replace("log's clock", ""))
            for r in track("\n".join(lines)):
                self.assertAlmostEqual(math.radians(r["lon_deg"]) * 6378137.0, 10 * r["t_s"] * 6378137.0 / 6378157.4, delta=0.05)

    def test_two_clocks_are_tied_over_the_whole_log(self):
        """GPS time beside a clock that runs 100 ppm slow and is late: the places have GPS time, and the tie is reported."""
        rows = ["week,tow,t,lat,lon,height"]
        for k in range(600):
            rows.append(f"2325,{381618 + k},{40 + (k + 0.1 * (k % 3)) * (1 - 1e-4):.4f},50,{20 + 1e-4 * k:.9f},300")
        done = run("track", "--telemetry", self.log("\n".join(rows) + "\n"), "--rate", "1")
        self.assertIn("600 rows tell both", done.stderr)
        self.assertRegex(done.stderr, r"drift (9[5-9]|10[0-5])[.0-9]* ppm")
        self.assertIn("2024-08-01T10:00:18", done.stdout.splitlines()[1])
        for r in track(done.stdout):
            self.assertAlmostEqual(r["lon_deg"], 20 + 1e-4 * r["t_s"], delta=2e-7)

    def test_longer_than_log_or_plan_is_told(self):
        self.assertIn("the log holds 59.000 s", run("track", "--telemetry", self.nmea(60), "--duration", "90").stderr)
        done = run("track", sample("survey.yaml"), "--duration", "9000", "-o", self.path("long.csv"))
        self.assertIn("goes straight on", done.stderr)

    def test_faults_are_left_out_and_reported(self):
        """Every fault a row can have: the flight comes back as it was, and the report names each row that was left out."""
        good = flight(60)
        rows = [list(r) for r in good]
        rows[50][1] = float("nan")  # read by the table as no number
        rows[60][2] = "x"
        rows[70][1] = 95.0
        rows[80][1] += 0.01  # 1.1 km off
        rows[90] = list(rows[89])  # once more
        rows[100][0] -= 7.1  # its clock set back
        rows[110][4] += 60.0  # the heading alone
        log, report = self.log(text(rows)), self.path("report.csv")
        done = run("track", "--telemetry", log, "--rate", "5", "--report", report)
        self.assert_same_way(good, track(done.stdout), 0, 0.05)
        for line in (52, 62, 72):
            self.assertIn(f"log.csv:{line}: row left out", done.stderr)
        left = {(int(r["line"]), r["of"]): r["fault"]
                for r in csv.DictReader(pathlib.Path(report).read_text(encoding="utf-8").splitlines())}
        self.assertEqual({k: v for k, v in left.items() if k[1] == "place"},
                         {(82, "place"): "jump", (92, "place"): "repeated", (102, "place"): "clock"})
        self.assertEqual({k: v for k, v in left.items() if k[1] == "angles"},
                         {(92, "angles"): "repeated", (102, "angles"): "clock", (112, "angles"): "jump"})

    def test_dropouts_part_a_log_where_they_are_long(self):
        good = flight(100)
        short = [r for r in good if not 40 < r[0] < 44]
        done = run("track", "--telemetry", self.log(text(short)), "--rate", "5")
        self.assertIn("gap of places from 40.000 s to 44.000 s", done.stderr)
        self.assertEqual(len(track(done.stdout)), len(good))
        self.assert_same_way(good, track(done.stdout), 0, 0.5)  # nothing but the spline's own roughness bridges the 4 s
        long = [r for r in good if not 30 < r[0] < 45]
        done = run("track", "--telemetry", self.log(text(long)), "--rate", "5")
        self.assertIn("trajectory: 45.000 s to 100.000 s", done.stderr)
        self.assertIn("outside", done.stderr)
        self.assert_same_way(good, track(done.stdout), 45, 0.02)

    def test_rates_of_a_log(self):
        nc = self.path("rates.nc")
        for rate in (1, 2, 10, 50):
            run("imu", "-q", "--telemetry", self.log(text(flight(60, rate))), "-o", nc)
            self.assertLess(run_json("nulltest", nc, "--format", "json")["position"]["max_3d_m"], 1e-4, rate)
        run("imu", "-q", "--telemetry", self.log(text(flight(60))), "--degree", "5", "--per-knot", "10",
            "--attitude-per-knot", "5", "-o", nc)
        self.assertLess(run_json("nulltest", nc, "--format", "json")["position"]["max_3d_m"], 1e-4)

    def test_what_is_no_flight(self):
        good = text(flight(20))
        lines = good.splitlines(keepends=True)
        out = self.path("out.nc")
        for name, content, sentence in (
                ("empty", "", "empty"), ("header", lines[0], "no row"), ("one", lines[0] + lines[1], "at least 8"),
                ("one of seven", lines[1], "at least 8"), ("two", "".join(lines[:3]), "at least 8"),
                ("seven", "".join(lines[:8]), "at least 8"),
                ("nan", text([(r[0], *[float("nan")] * 6) for r in flight(20)]), "no row"),
                ("backward", lines[0] + "".join(lines[:0:-1]), "do not ascend"),
                ("one time", text([(5.0, *r[1:]) for r in flight(20)]), "do not ascend"),
                ("short", text([(r[0] * 1e-3, *r[1:]) for r in flight(20)]), "a second at least"),
                ("far apart", text([(r[0] * 1e6, *r[1:]) for r in flight(20)]), "gap"),
                ("past all clocks", text([(r[0] + 1e12, *r[1:]) for r in flight(20)]), "no row"),
                ("angles alone", "\n".join(["t,heading,pitch,roll"] + ["1,2,3,4"] * 20), "no place"),
                ("five numbers", "1 2 3 4 5\n", "declare the columns"), ("no time", "lat,lon,height\n1,2,3\n", "no time"),
                ("prose", "It was a dark and stormy night;\nthe rain fell in torrents.\n", "telemetry needs"),
                ("bytes", bytes(range(256)) * 20, ""), ("zeros", bytes(5000), ""), ("one long line", "7" * 2000000, "")):
            done = run("imu", "--telemetry", self.log(content, "odd.csv"), "-o", out, status=1)
            self.assertIn(sentence, done.stderr, name)
            self.assertEqual(len([x for x in done.stderr.splitlines() if "warning" not in x]), 1, (name, done.stderr))
            self.assertNotIn("out.nc", " ".join(self.left()), name)
        angles = self.log("\n".join(["t,heading,pitch,roll"] + [f"{k / 5 + 1000},0,0,0" for k in range(100)]), "late.csv")
        self.assertIn("in common", run("imu", "--telemetry", self.log(good), "--telemetry", angles, "-o", out, status=1).stderr
                      .replace("0 of 100 rows of attitude can be used", "in common"))
        self.assertIn("one file or two", run("imu", "--telemetry", self.log(good), "--telemetry", angles, "--telemetry", angles,
                                             "-o", out, status=1).stderr)
        for columns, sentence in (("t,lat,lon", "neither a whole place"), ("t,lat,lon,height,colour", "colour"),
                                  ("t[m],lat,lon,height", "unit"), ("t,t,lat,lon,height", "twice"), ("", "no column")):
            self.assertIn(sentence, run("imu", "--telemetry", self.log(good), "--columns", columns, "-o", out, status=1).stderr)
        self.assertIn("cannot open", run("imu", "--telemetry", self.path("absent.csv"), "-o", out, status=1).stderr)

    def test_a_body_at_rest(self):
        rows = [(k / 5, 50.0, 20.0, 500.0, 45.0, 0.0, 0.0) for k in range(200)]
        nc = self.path("rest.nc")
        run("imu", "-q", "--telemetry", self.log(text(rows)), "-o", nc)
        report = run_json("nulltest", nc, "--format", "json")
        self.assertLess(report["position"]["max_3d_m"], 1e-6)
        places = [r[:4] for r in rows]  # without angles: no motion to take a heading from
        got = track(run("track", "-q", "--telemetry", self.log(text(places, "t,lat,lon,height"))).stdout)
        self.assertEqual({r["heading_deg"] for r in got}, {0.0})

    def test_angles_from_the_motion(self):
        """A flight due East without angles: heading 90, level; climbing at 1 in 20: pitch 2.86 deg."""
        rows = [(r[0], r[1], r[2], 500.0 + 3.0 * r[0]) for r in flight(60, lat=0.0, heading=90)]
        done = run("track", "--telemetry", self.log(text(rows, "t,lat,lon,height")))
        self.assertIn("none recorded", done.stderr)
        for r in track(done.stdout):
            self.assertAlmostEqual(r["heading_deg"], 90, delta=1e-3)
            self.assertAlmostEqual(r["roll_deg"], 0, delta=0.01)
            self.assertAlmostEqual(r["pitch_deg"], math.degrees(math.atan2(3.0, 60.0 * 6378137 / RADIUS_M)), delta=2e-3)

    def test_the_sample_and_a_real_log(self):
        nc = self.path("real.nc")
        run("imu", "-q", "--telemetry", sample("telemetry.csv"), "-o", nc)
        self.assertLess(run_json("nulltest", nc, "--format", "json")["position"]["max_3d_m"], 1e-3)
        gps, att = data("flight-x8/GPS.txt.gz"), data("flight-x8/ATT.txt.gz")
        made = []
        for folder in ("one", "two"):
            pathlib.Path(self.path(folder)).mkdir()
            run("imu", "-q", "--telemetry", gps, "--columns", "-,fix[>=3],tow[ms],week,-,-,lat,lon,-,alt,-,-,-,t[ms]", "--telemetry", att,
                "--columns", "-,t[ms],roll,pitch,heading,-,-", "-o", "imu.nc", "--report", "left.csv", cwd=self.path(folder))
            made.append([pathlib.Path(self.path(folder), name).read_bytes() for name in ("imu.nc", "left.csv")])
        self.assertEqual(made[0], made[1])
        self.assertLess(run_json("nulltest", self.path("one/imu.nc"), "--format", "json")["position"]["max_3d_m"], 1e-3)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
