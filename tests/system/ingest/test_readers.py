#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What files of the field ask of the program: pipes, leap seconds beyond the table, F/NAV alone, GLONASS channels of a
navigation file. All inputs are made."""
import gzip
import math
import os
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(__file__), ".."))
from program import ORRERY, Folder, ROOT, run, run_json  # noqa: E402

GOLDEN = ROOT / "tests/golden/ingest/c.sp3"
C = 299792458.0


def label(text, name):
    return f"{text:<60}{name:<20}\n"


def fields(*values):
    return "".join(" " * 19 if v is None else f"{v:19.12E}" for v in values)


def pipe(data, *args, status=0):
    done = subprocess.run([ORRERY, *map(str, args)], input=data, capture_output=True, timeout=60, check=False)
    if done.returncode != status:
        raise AssertionError(f"{args}: status {done.returncode}\n{done.stderr.decode()}")
    return done.stdout.decode()


class Readers(Folder):
    def test_pipes(self):
        text = GOLDEN.read_bytes()
        plain = run("inspect", GOLDEN).stdout.split("\n", 1)[1]
        for data in (text, gzip.compress(text)):
            for name in ("-", "/dev/stdin"):
                self.assertEqual(pipe(data, "inspect", name).split("\n", 1)[1], plain)
        fifo = self.path("fifo")
        os.mkfifo(fifo)
        with subprocess.Popen([ORRERY, "inspect", fifo], stdout=subprocess.PIPE, text=True) as child:
            with open(fifo, "wb") as f:
                f.write(text)
            self.assertEqual(child.communicate(timeout=60)[0].split("\n", 1)[1], plain)
        table = b"time,x\n1,2\n2,3\n3,4\n"
        self.assertIn("columns      2", pipe(table, "inspect", "-"))
        self.assertIn("zip archive", subprocess.run([ORRERY, "inspect", "-"], input=b"PK\x03\x04", capture_output=True,
                                                    check=False).stderr.decode())

    def test_pipes_without_an_end(self):
        """They are refused by what they begin with, not read until memory is short."""
        field = ("tec", "-", "--at", "2024-02-04", "--point", "50,10")
        for args in (("inspect", "-"), ("orbit", "-o", self.path("y.nc"), "-"), field, ("sisre", "-", GOLDEN),
                     ("iono", "-", "--field", "x", "--orbit", "y"), ("compare", "-", GOLDEN), ("compare", GOLDEN, "-")):
            for stream in (["yes"], ["cat", "/dev/zero"], ["sh", "-c", "yes | gzip -1"])[:3 if args[0] == "orbit" else 1]:
                with subprocess.Popen(stream, stdout=subprocess.PIPE) as endless:
                    done = subprocess.run([ORRERY, *map(str, args)], stdin=endless.stdout, capture_output=True, text=True, timeout=60,
                                          check=False)
                    endless.stdout.close()
                    endless.terminate()
                self.assertEqual(done.returncode, 1, (args, done.stderr))
                self.assertRegex(done.stderr, "first lines|text of an unknown|binary|not text|no text", (args, stream))

    def test_leap_seconds(self):
        sp3 = GOLDEN.read_text().replace("GPS ccc", "UTC ccc").replace("2024  2  4", "2027  2  4")
        late = self.path("late.sp3")
        with open(late, "w", encoding="ascii") as f:
            f.write(sp3)
        told = run("inspect", late)
        self.assertIn("beyond the table of leap seconds", told.stderr)
        self.assertIn("2027-02-04T00:00:18", told.stdout)
        newer = self.path("leap-seconds.list")
        with open(newer, "w", encoding="ascii") as f:  # 36 s from 2006 on, made up; certain to 2099
            f.write("#@\t6279552000\n2272060800\t35\n3345062400\t36\n4007750400\t37\n4023388800\t38\n")
        for done in (run("inspect", late, "--leap-seconds", newer),
                     run("inspect", late, env={**os.environ, "ORRERY_LEAP_SECONDS": newer})):
            self.assertNotIn("beyond", done.stderr)
            self.assertIn("2027-02-04T00:00:18", done.stdout)  # 37 s from 2027 on
        self.assertIn("/nowhere", run("inspect", late, "--leap-seconds", "/nowhere", status=1).stderr)
        self.assertIn("beyond the table", run("tec", GOLDEN, "--at", "2030-01-01T00:00:00Z", "--point", "0,0",
                                              status=1).stderr)

    def test_glonass_channels(self):
        """A satellite whose channel the observations' header does not tell; it moves round a circle, and stands high."""
        r0 = (12000e3, -5000e3, 22000e3)
        size = math.dist(r0, (0, 0, 0))
        side = (r0[1] / math.hypot(r0[0], r0[1]), -r0[0] / math.hypot(r0[0], r0[1]), 0)
        v0 = [3950 * s for s in side]
        site = [x / size * 6371e3 for x in r0]
        nav = self.path("nav.rnx")
        with open(nav, "w", encoding="ascii") as f:
            f.write(label("     3.05           N: GNSS NAV DATA    R: GLONASS", "RINEX VERSION / TYPE"))
            f.write(label("GPSA   1.0000E-08  0.0000E+00  0.0000E+00  0.0000E+00", "IONOSPHERIC CORR"))
            f.write(label("GPSB   1.0000E+05  0.0000E+00  0.0000E+00  0.0000E+00", "IONOSPHERIC CORR"))
            f.write(label("", "END OF HEADER"))
            f.write("R02 2020 06 25 00 15 00" + fields(1e-4, 0, 345600) + "\n")
            for i in range(3):
                last = (0, -4, 0)[i]
                f.write("    " + fields(r0[i] / 1e3, v0[i] / 1e3, 0, last) + "\n")
            f.write("    " + fields(None, 0, 15, None) + "\n")
        lines = [label("     2.11           OBSERVATION DATA    R (GLONASS)", "RINEX VERSION / TYPE"),
                 label("MADE", "MARKER NAME"),
                 label("".join(f"{x:14.4f}" for x in site), "APPROX POSITION XYZ"),
                 label("     4    L1    L2    P1    P2", "# / TYPES OF OBSERV"),
                 label("  2020     6    25     0     5    0.0000000     GLO", "TIME OF FIRST OBS"),
                 label("", "END OF HEADER")]
        f1, f2 = 1602e6 - 4 * 0.5625e6, 1246e6 - 4 * 0.4375e6
        for k in range(40):
            t = k * 30 - 600
            rho = math.dist(site, [r0[i] + v0[i] * t for i in range(3)])
            lines.append(f" 20  6 25  0 {5 + k // 2:2d}{k % 2 * 30:11.7f}  0  1R02\n")
            lines.append(f"{rho * f1 / C:14.3f}  {rho * f2 / C:14.3f}  {rho:14.3f}  {rho:14.3f}\n")
        obs = self.path("made.20o")
        with open(obs, "w", encoding="ascii") as f:
            f.write("".join(lines))
        done = run("iono", obs, "--field", nav, "--orbit", nav, "--csv", "-", "--method", "thesis")
        self.assertGreater(sum(",R02," in row for row in done.stdout.splitlines()), 30, done.stderr)
        self.assertNotIn("left out", done.stderr)

    def test_models_of_the_ionosphere(self):
        """Broadcast models by system, each in its own formula, and by time."""
        eph = ("C20 2024 02 04 06 00 00" + fields(1.4e-4, 2.6e-12, 0) + "\n" +
               "".join("    " + fields(*row) + "\n" for row in
                       ((1, 28.75, 2.6e-9, -0.95), (1.2e-6, 1e-4, 1e-5, 5282.6), (21600, 3e-8, 0.212, 7e-8),
                        (0.98, 131, 0.077, -5.2e-9), (-7e-10, 0, 944, 0), (2, 0, 1e-9, 1e-9), (21600, 0, None, None))))
        old = self.path("old.rnx")
        with open(old, "w", encoding="ascii") as f:
            f.write(label("     3.05           N: GNSS NAV DATA    C", "RINEX VERSION / TYPE"))
            for half, eight in (("A", (2e-8, 1e-8, -3e-8, 0)), ("B", (1e5, 2e4, 0, 0))):
                f.write(label(f"BDS{half} " + "".join(f"{x:12.4E}" for x in eight), "IONOSPHERIC CORR"))
            f.write(label("", "END OF HEADER") + eph)
        at = ("--at", "2024-02-04T06:00:14", "--carrier", "1561.098")

        def delay(nav, *more):
            return float(run("tec", nav, *at, *more).stdout.splitlines()[1].split(",")[-1])

        # 14 h local at 120 E, straight up from the Equator: 5 ns and the amplitude alpha_0.
        up = ("--receiver", "0,120,0")
        self.assertAlmostEqual(delay(old, *up), 2.5e-8 * C, places=3)
        self.assertAlmostEqual(delay(old, *up, "--model", "beidou"), 2.5e-8 * C, places=3)
        for model in ("gps", "bdgim", "nequick", "qzss"):
            self.assertIn("no Klobuchar coefficients in it", run("tec", old, *at, *up, "--model", model, status=1).stderr)

        new = self.path("new.rnx")
        with open(new, "w", encoding="ascii") as f:
            f.write(label("     4.00           NAVIGATION DATA     C", "RINEX VERSION / TYPE"))
            f.write(label("", "END OF HEADER"))
            for hour, a in (("05", 3e-8), ("03", 1e-8), ("07", 9e-8)):
                f.write(f"> ION C20 D1D2\n    2024 02 04 {hour} 00 00" + fields(a, 0, 0) + "\n    " + fields(0, 1e5, 0, 0) +
                        "\n    " + fields(0, 0, None, None) + "\n")
            f.write("> EPH C20 D1\n" + eph)
            f.write(f"> ION E02 IFNV\n    2024 02 04 05 00 00" + fields(80, 0.1, 0.01) + "\n    " + fields(0, None, None, None) + "\n")
        # BDT is 14 s later: 06:00:14 lies between the sets of 5 h and 7 h.
        self.assertAlmostEqual(delay(new, *up), 3.5e-8 * C, places=3)
        done = run("tec", new, *at, *up, "--model", "nequick", status=1)
        self.assertIn("ccir11.asc", done.stderr)

    def test_fnav_alone(self):
        nav = self.path("fnav.rnx")
        with open(nav, "w", encoding="ascii") as f:
            f.write(label("     3.05           N: GNSS NAV DATA    E", "RINEX VERSION / TYPE"))
            f.write(label("", "END OF HEADER"))
            f.write("E02 2020 06 25 00 50 00" + fields(1.4e-4, 2.6e-12, 0) + "\n")
            rows = ((69, 28.75, 2.6e-9, -0.95), (1.2e-6, 1e-4, 1e-5, 5440.61), (348600, 3e-8, 0.212, 7e-8),
                    (0.98, 131, 0.077, -5.2e-9), (-7e-10, 258, 2111, None), (3.12, 0, -3.5e-9, 0), (353690, None, None, None))
            for row in rows:
                f.write("    " + fields(*row) + "\n")
        report = run_json("inspect", "--format", "json", nav)
        self.assertIn("1 FNAV", report["facts"]["Galileo"])
        self.assertIn("no satellite", run("sisre", nav, GOLDEN, status=1).stderr)  # another day and system: said, not crashed
        self.assertIn("no message", run("sisre", nav, GOLDEN, "--message", "XNAV", status=2).stderr)


if __name__ == "__main__":
    unittest.main()
