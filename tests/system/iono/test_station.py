#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""orrery tec and orrery iono on a real station's day, and on what they must refuse."""
import csv
import gzip
import hashlib
import io
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "service"))
from daemon import WORK, Daemon, orrery  # noqa: E402

import orrery as client_package  # noqa: E402
from orrery import messages  # noqa: E402

DATA = pathlib.Path(os.environ.get("ORRERY_DATA", ""))
DAY = DATA / "2024-035"
OBS = DAY / "BOR100POL_R_20240350000_01D_30S_MO.crx.gz"
MAPS = DAY / "COD0OPSFIN_20240350000_01D_01H_GIM.INX.gz"
SP3 = DAY / "COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz"
BIAS = DAY / "COD0OPSFIN_20240350000_01D_01D_OSB.BIA.gz"
NAV = DAY / "BRDC00CNE_R_20240350000_01D_GN.rnx.gz"
SINEX = DAY / "IGS0OPSSNX_20240350000_01D_01D_CRD.SNX.gz"
PAIR = DATA / "2005-092-pair"


def orbit():
    path = WORK / "day.nc"
    if not path.exists():
        done = orrery("orbit", "-o", path, "--nodes", "900", SP3)
        assert done.returncode == 0, done.stderr
    return path


@unittest.skipUnless(OBS.exists(), "no real data (ORRERY_DATA)")
class Station(unittest.TestCase):
    def ok(self, *args):
        done = orrery(*args)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def refused(self, words, *args, status=1):
        done = orrery(*args)
        self.assertEqual(done.returncode, status, done.stderr)
        for word in words if isinstance(words, list) else [words]:
            self.assertIn(word, done.stderr)

    def test_tec_at_a_place(self):
        rows = list(csv.DictReader(io.StringIO(self.ok("tec", MAPS, "--at", "2024-02-04T12:00:00Z", "--point", "50,15"))))
        self.assertEqual(len(rows), 1)
        with gzip.open(MAPS, "rt", errors="replace") as f:  # the 13th map's cell, read by hand
            text = f.read()
        one = text.split("START OF TEC MAP")[13].split("    50.0-180.0 180.0   5.0 450.0")[1].split("LAT/LON")[1]
        values = one.split("\n", 1)[1].split()[:73]
        self.assertAlmostEqual(float(rows[0]["vtec_tecu"]), int(values[39]) / 10, delta=0.08)
        ray = json.loads(self.ok("tec", MAPS, "--at", "2024-02-04T12:00", "--receiver", "52,17,0", "--el", 30, "--format", "json"))[0]
        self.assertAlmostEqual(ray["delay_m"], 40.3e16 * ray["stec_tecu"] / 1575.42e6**2, places=4)
        self.assertAlmostEqual(ray["stec_tecu"], ray["mapping"] * ray["vtec_tecu"], places=2)

    def test_tec_files(self):
        maps, ion = WORK / "g.INX", WORK / "g.ION"
        self.ok("tec", MAPS, "--grid", "--format", "ionex", "-o", maps)
        self.ok("tec", MAPS, "--format", "ion", "-o", ion)
        place = ["--at", "2024-02-04T07:20", "--point", "-20,-60"]
        values = [float(list(csv.DictReader(io.StringIO(self.ok("tec", f, *place))))[0]["vtec_tecu"]) for f in (MAPS, ion, maps)]
        self.assertAlmostEqual(values[0], values[1], delta=1e-3)  # the .ION's epochs are as the maps': 4 decimals are printed
        self.assertAlmostEqual(values[0], values[2], delta=0.1)   # printed to 0.1 and fitted again
        self.ok("tec", NAV, "--at", "2024-02-04T07:20", "--point", "0,0")
        self.refused("covers", "tec", MAPS, "--at", "2024-02-06T00:00", "--point", "0,0")
        self.refused("below the horizon", "tec", MAPS, "--at", "2024-02-04T07:20", "--receiver", "0,0,0", "--el", "-3")
        self.refused("neither an IONEX", "tec", OBS, "--at", "2024-02-04T07:20", "--point", "0,0")
        self.refused("where?", "tec", MAPS, "--at", "2024-02-04T07:20", status=2)

    def test_sinex_puts_the_antenna_over_the_marker(self):
        """The station is the marker of SOLUTION/ESTIMATE and SITE/ECCENTRICITY above it: 62.2 mm Up for BOR1."""
        session = WORK / "sinex.nc"
        self.ok("iono", OBS, "--field", MAPS, "--orbit", NAV, "--sinex", SINEX, "--to", "2024-02-04T00:30", "-q", "-o", session)
        header = subprocess.run(["ncdump", "-h", session], capture_output=True, text=True, check=True).stdout
        site = [float(re.search(rf"station_{axis}_m = ([-0-9.]+)", header).group(1)) for axis in "xyz"]
        marker = (3738358.13315294, 1148174.00879205, 5021815.93384643)
        up = (math.cos(math.radians(52.277)) * math.cos(math.radians(17.0735)),
              math.cos(math.radians(52.277)) * math.sin(math.radians(17.0735)), math.sin(math.radians(52.277)))
        for k in range(3):
            self.assertAlmostEqual(site[k] - marker[k], 0.0622 * up[k], delta=1e-5)

    def test_a_session_from_pipes_is_the_same(self):
        """Each input is read once, so that pipes do as well as files, and their bytes are what is hashed."""
        fed = [OBS, MAPS, NAV]
        pipes = []
        (WORK / "pipes").mkdir()
        for path in fed:
            pipes.append(WORK / "pipes" / path.name)
            os.mkfifo(pipes[-1])
        files, piped = WORK / "files.nc", WORK / "piped.nc"
        self.ok("iono", fed[0], "--field", fed[1], "--orbit", fed[2], "--to", "2024-02-04T06:00", "-q", "-o", files)
        writers = [subprocess.Popen(["cp", source, pipe]) for source, pipe in zip(fed, pipes)]
        try:
            self.ok("iono", pipes[0], "--field", pipes[1], "--orbit", pipes[2], "--to", "2024-02-04T06:00", "-q", "-o", piped)
        finally:
            for writer in writers:
                writer.kill()
                writer.wait()
        dumps = [subprocess.run(["ncdump", f], capture_output=True, text=True, check=True).stdout.split("\n", 1)[1] for f in (files, piped)]
        same = [re.sub(r"(:history = ).*", r"\1", text) for text in dumps]
        self.assertTrue(same[0] == same[1], "sessions differ")
        for path in fed:
            self.assertIn(hashlib.sha256(path.read_bytes()).hexdigest(), dumps[1])

    def test_fusion(self):
        session = WORK / "session.nc"
        joint = json.loads(self.ok("iono", OBS, "--field", MAPS, "--orbit", orbit(), "--biases", BIAS, "-o", session, "--format", "json",
                                   "--explain", "--csv", WORK / "s.csv"))
        thesis = json.loads(self.ok("iono", OBS, "--field", MAPS, "--orbit", orbit(), "--method", "thesis", "--format", "json"))
        print(f"thesis {thesis['residual']['rms_tecu']} TECU, joint {joint['residual']['rms_tecu']} TECU, "
              f"Galileo codes {joint['galileo_code']['std_tecu']} TECU", file=sys.stderr)
        self.assertEqual((thesis["method"], joint["method"]), ("thesis", "joint"))
        self.assertLessEqual(thesis["residual"]["rms_tecu"], 2.2)
        self.assertLessEqual(joint["residual"]["rms_tecu"], 1.0)
        self.assertTrue(joint["galileo_code"]["withheld"])
        self.assertLessEqual(joint["galileo_code"]["std_tecu"], 1.5)
        self.assertEqual(joint["arcs"], len(joint["arc_list"]))
        self.assertGreater(joint["arcs"], 100)
        self.assertEqual(sum(b["n"] for b in joint["residual"]["by_elevation"]), joint["samples"])
        self.assertTrue(all(s["verdict"] in ("break", "repaired", "none", "outlier") and s["causes"] for s in joint["slip_list"]))
        with open(WORK / "s.csv", newline="") as f:
            rows = list(csv.DictReader(f))
        self.assertEqual(len(rows), joint["samples"])
        self.assertEqual({r["sat"][0] for r in rows}, set("GRE"))
        self.served(session, rows)
        told = json.loads(self.ok("inspect", "--format", "json", session))
        self.assertEqual((told["kind"], told["systems"], told["satellites"]), ("netcdf", ["G", "R", "E"], len({r["sat"] for r in rows})))
        self.assertEqual((told["from"], told["to"]), (min(r["t_gps"] for r in rows), max(r["t_gps"] for r in rows)))
        self.assertEqual((told["epochs"], told["interval_s"]), (len({r["t_gps"] for r in rows}), 30))
        self.assertIn("ionospheric session", told["facts"]["product"])
        self.assertIn("BOR1", told["facts"]["station"])
        self.assertIn(f"{joint['arcs']} with {joint['samples']} samples", told["facts"]["arcs"])
        self.assertIn(OBS.name, told["facts"]["made from"])
        # Galileo's codes may be used, and other stations' orbits may be broadcast ones.
        used = json.loads(self.ok("iono", OBS, "--field", MAPS, "--orbit", orbit(), "--biases", BIAS, "--code", "GE", "--format", "json"))
        self.assertFalse(used["galileo_code"]["withheld"])
        nav = json.loads(self.ok("iono", OBS, "--field", MAPS, "--orbit", NAV, "--format", "json"))
        self.assertLessEqual(nav["residual"]["rms_tecu"], 1.2)  # GPS alone, metres off: as good
        self.assertIsNone(nav["galileo_code"]["std_tecu"])

    def served(self, session, rows):
        """The session on the wire: at the station the fused curve, 30 km away alike, noise where the station saw nothing."""
        scenario = WORK / "session.yaml"
        scenario.write_text(f"orbit: {{product: {orbit()}}}\nionosphere: {{session: {session}, seed: 3}}\n")
        noon = [r for r in rows if r["t_gps"] == "2024-02-04T12:00:00"]
        self.assertGreater(len(noon), 15)
        with Daemon(scenario) as d, client_package.Client(d.urls[0]) as c:
            home = {client_package.client.sat_name(s.sat): s for s in c.delays("2024-02-04T12:00:00").satellites}
            joined = 0
            for r in noon:
                s = home[r["sat"]]
                self.assertEqual(s.origin, messages.TecOrigin.FUSED)
                off = abs(s.stec_tecu - float(r["stec_tecu"]))
                joined += off > 1e-5
                self.assertLess(off, 1)  # near a joint of two arcs the one is bent towards the other
                self.assertAlmostEqual(math.degrees(s.el_rad), float(r["el_deg"]), places=3)
            self.assertLess(joined, len(noon) / 4)
            own = c.delays("2024-02-04T12:00:00").receiver_m
            away = [own[0] - 9.2e3, own[1] + 28.6e3, own[2]]
            near = {client_package.client.sat_name(s.sat): s for s in c.delays("2024-02-04T12:00:00", away).satellites}
            for r in noon:
                self.assertEqual(near[r["sat"]].origin, messages.TecOrigin.TRANSFERRED)
                self.assertAlmostEqual(near[r["sat"]].stec_tecu, home[r["sat"]].stec_tecu, delta=6)
            unseen = [s for s in home.values() if s.answer == messages.Answer.OK and s.origin == messages.TecOrigin.NOISE]
            self.assertTrue(unseen)
            self.assertGreater(min(s.sigma_tecu for s in unseen), 0.3)
            self.assertEqual(c.delays("2024-02-04T12:00:00", away).encode(), c.delays("2024-02-04T12:00:00", away).encode())
        self.flown_over(scenario, home)

    def flown_over(self, scenario, home):
        """The same with an aircraft 6 km north of the station at noon: delays are its own, what the station saw is carried to it,
        which over so short a way changes it by some tenths of a TECU."""
        flight = WORK / "flown.yaml"
        flight.write_text(scenario.read_text() + "trajectory: {kind: analytic, start: 2024-02-04T11:59:00, duration: 120, lat: 52.277,"
                          " lon: 17.073, height: 1100, motions: [{kind: straight, north: 100}]}\n")
        with Daemon(flight) as d, client_package.Client(d.urls[0]) as c:
            t = client_package.from_text("2024-02-04T12:00:00")
            truth, own = next(c.poll_truth(t)), c.delays(t)
            self.assertEqual(own.receiver_m, truth.pos_m)
            self.assertEqual(own.encode(), c.delays(t, truth.pos_m).encode())
            for s in own.satellites:
                there = home[client_package.client.sat_name(s.sat)]
                if s.answer == there.answer == messages.Answer.OK and there.origin == messages.TecOrigin.FUSED:
                    self.assertEqual(s.origin, messages.TecOrigin.TRANSFERRED)
                    self.assertAlmostEqual(s.stec_tecu, there.stec_tecu, delta=1)
            self.assertEqual(c.delays(t - 3600 * 10**9).answer, messages.Answer.OUTSIDE_SPAN)  # never the station instead

    def test_antennas(self):
        """A phase centre that stands 0.3 m further out on L1 than on L2 makes codes tell 0.3 m K cos(nadir) TECU too much and phases
        as much too little: both are mended, so an arc's bias rises by it, what its codes say of that bias by twice as much."""
        line = "{:<60}{}\n".format
        antenna = [line("", "START OF ANTENNA"), line("BLOCK IIIA          G05                 G099      2000-000A", "TYPE / SERIAL NO"),
                   line("     0.0", "DAZI"), line("     0.0  14.0   7.0", "ZEN1 / ZEN2 / DZEN"), line("     2", "# OF FREQUENCIES"),
                   line("  2000     1     1     0     0    0.0000000", "VALID FROM")]
        for code, z in (("G01", 1000), ("G02", 700)):
            antenna += [line(f"   {code}", "START OF FREQUENCY"), line(f"      0.00      0.00{z:10.2f}", "NORTH / EAST / UP"),
                        "   NOAZI    0.00    0.00    0.00\n", line(f"   {code}", "END OF FREQUENCY")]
        text = [line("     1.4            M", "ANTEX VERSION / SYST"), line("A", "PCV TYPE / REFANT"), line("", "END OF HEADER"), *antenna,
                line("", "END OF ANTENNA")]
        antex = WORK / "made.atx"
        antex.write_text("".join(text))
        args = ["iono", OBS, "--field", MAPS, "--orbit", NAV, "--biases", BIAS, "--sat", "G05", "--method", "thesis", "--format", "json",
                "--explain"]
        plain, shifted = (json.loads(self.ok(*args, *more)) for more in ([], ["--antex", antex]))
        k = 1575.42e6**2 * 1227.60e6**2 / (40.3e16 * (1575.42e6**2 - 1227.60e6**2))
        for a, b in zip(plain["arc_list"], shifted["arc_list"]):
            self.assertAlmostEqual(b["bias_tecu"] - a["bias_tecu"], 0.3 * k * 0.98, delta=0.3 * k * 0.02)  # nadir to 14 degrees
            self.assertAlmostEqual(b["code_bias_tecu"] - a["code_bias_tecu"], 0.6 * k * 0.98, delta=0.6 * k * 0.02)
        missing = orrery(*args[:8], "--sat", "G07", "--antex", antex, "--method", "thesis")
        self.assertIn("1 satellites have no antenna", missing.stderr)

    def test_pair(self):
        a, b = PAIR / "07590920.05o.gz", PAIR / "30400920.05o.gz"
        got = json.loads(self.ok("iono", a, "--compare", b, "--format", "json"))
        print(f"pair: {got['rms_tecu']} TECU over {got['epochs']} epochs", file=sys.stderr)
        self.assertLessEqual(got["rms_tecu"], 0.08)
        rows = list(csv.DictReader(io.StringIO(self.ok("iono", a, "--compare", b))))
        self.assertEqual(len(rows), got["epochs"])
        for name in {r["curve"] for r in rows}:
            self.assertAlmostEqual(sum(float(r["a_tecu"]) for r in rows if r["curve"] == name), 0, places=1)
        self.refused("no common arc", "iono", a, "--compare", OBS)

    def test_refusals(self):
        plain = PAIR / "07590920.05o.gz"
        with gzip.open(plain, "rt") as f:
            text = f.read()
        single = WORK / "single.05o"
        single.write_text(text.replace("     4    L1    C1    L2    P2  ", "     4    L1    C1    S1    S2  "))
        args = ["--field", MAPS, "--orbit", orbit()]
        self.refused(["single.05o", "two frequencies"], "iono", single, *args)
        nowhere = WORK / "nowhere.05o"
        nowhere.write_text("".join(line + "\n" for line in text.split("\n") if "APPROX POSITION" not in line))
        self.refused("no position", "iono", nowhere, *args)
        self.refused("known position", "iono", plain, *args)  # another year's orbit
        self.refused("covers", "iono", OBS, "--field", DATA / "odd/ionex/split-2.19i.gz", "--orbit", orbit())
        self.refused("--orbit", "iono", OBS, "--field", MAPS, status=2)
        self.refused("neither an orbit product", "iono", OBS, "--field", MAPS, "--orbit", MAPS)
        self.refused("neither LAT,LON", "iono", OBS, *args, "--receiver", "1", status=2)
        self.refused("not on the Earth", "iono", OBS, *args, "--receiver", "ecef:1,2,3", status=2)
        self.refused("--code", "iono", OBS, *args, "--code", "xyz", status=2)

    def test_odd_maps(self):
        for path in sorted((DATA / "odd/ionex").glob("*.gz")):
            done = orrery("tec", path, "--grid", "--bilinear", "--format", "ionex", "-o", WORK / "odd.INX")
            self.assertIn(done.returncode, (0, 1), path.name)
            if done.returncode == 1:
                self.assertRegex(done.stderr, "orrery tec: .{20}", path.name)

    def test_maps_with_faults(self):
        with gzip.open(MAPS, "rt", errors="replace") as f:
            text = f.read()
        first = text.index("LAT/LON1/LON2/DLON/H") + len("LAT/LON1/LON2/DLON/H\n")
        negative, hole = WORK / "negative.INX", WORK / "hole.INX"
        negative.write_text(text[:first] + "   -7" + text[first + 5:])
        done = orrery("tec", negative, "--at", "2024-02-04T00:30", "--point", "50,-150")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("1 values of maps are negative", done.stderr)
        whole = orrery("tec", MAPS, "--at", "2024-02-04T00:30", "--point", "50,-150")
        self.assertEqual(done.stdout.replace(negative.name, MAPS.name), whole.stdout) # far from the cell
        row = text.index("    50.0-180.0 180.0   5.0 450.0")
        cells = text.index("\n", row) + 1
        hole.write_text(text[:cells] + " 9999" * 16 + text[cells + 80:])
        self.refused("hole", "tec", hole, "--at", "2024-02-04T00:30", "--point", "50,-150")
        self.refused("hole", "tec", hole, "--at", "2024-02-04T00:30", "--point", "50,-150", "--bilinear")
        self.ok("tec", hole, "--at", "2024-02-04T02:30", "--point", "50,-150")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
