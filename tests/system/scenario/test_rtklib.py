# SPDX-License-Identifier: GPL-3.0-or-later
"""`orrery simulate` judged by an independent program: RTKLIB's rnx2rtkp finds the antennas again from the observations."""
import hashlib
import json
import math
import pathlib
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import Folder, data, run, sample  # noqa: E402

COMMON = {"pos1-elmask": "0", "pos1-navsys": "1", "out-solformat": "xyz", "out-outhead": "off", "out-timesys": "gpst"}
# RTKLIB 2.4.3 has no Shapiro term; its PPP gives nothing with the troposphere off.
SINGLE = {**COMMON, "pos1-posmode": "single", "pos1-frequency": "l1", "pos1-ionoopt": "off", "pos1-tropopt": "off",
          "pos1-sateph": "precise"}
DUAL = {**SINGLE, "pos1-frequency": "l1+2", "pos1-ionoopt": "dual-freq", "pos1-tropopt": "saas"}
PPP = {**DUAL, "pos1-posmode": "ppp-kine", "pos1-tropopt": "est-ztd", "pos1-elmask": "10", "pos1-posopt3": "on"}
# One iteration computes the troposphere at the height of a code solution, metres off: 5 mm in Up.
RTK = {**DUAL, "pos1-posmode": "kinematic", "pos1-ionoopt": "off", "pos2-armode": "continuous", "pos2-gloarmode": "off",
       "ant2-postype": "rinexhead", "pos2-niter": "3"}

ANTENNAS = """
antennas:
  - {name: BASE, position: [52.28, 17.07, 124]}
  - {name: ROVE, position: [52.30, 17.10, 130]}
mask: {elevation: 10}
"""
THREE = ANTENNAS.replace("mask:", "  - {name: NEAR, position: [52.285, 17.08, 126]}\nmask:")


class Simulation(Folder):
    """Runs of one orbit product: `orbit` is its product, `from_` and `to` an hour."""

    @classmethod
    def simulate(cls, name, scenario, *options):
        path = pathlib.Path(cls.path(name + ".yaml"))
        path.write_text(f"orbit: {{product: {cls.orbit}}}\n{scenario}", encoding="ascii")
        run("simulate", path, "-o", cls.path(name), "--from", cls.from_, "--to", cls.to, *options)
        return cls.folder / name

    @classmethod
    def solve(cls, folder, options, antenna="BASE", base=None, truth=True):
        """Distances from the antenna's true place, with seconds since the first epoch and RTKLIB's quality."""
        (folder / "conf").write_text("".join(f"{k} ={v}\n" for k, v in options.items()), encoding="ascii")
        files = [f"{antenna}.rnx"] + ([f"{base}.rnx"] if base else []) + ["broadcast.rnx"]
        files += ["truth.sp3", "truth.clk"] if truth else []
        subprocess.run(["rnx2rtkp", "-k", "conf", "-o", "out.pos", *files], cwd=folder, check=True, capture_output=True, timeout=200)
        place = next(tuple(map(float, line[:60].split()))
                     for line in (folder / f"{antenna}.rnx").read_text(encoding="ascii").splitlines() if "APPROX POSITION" in line)
        rows, first = [], None
        for line in (folder / "out.pos").read_text(encoding="ascii").splitlines():
            if line[0] == "%":
                continue
            f = line.split()
            h, m, s = map(float, f[1].split(":"))
            t = 3600 * h + 60 * m + s
            first = t if first is None else first
            rows.append((t - first, math.dist(place, tuple(map(float, f[2:5]))), int(f[5])))
        return rows

    def judge(self, what, rows, rms_m, max_m, least=100):
        """Tells the distances and holds them against bars."""
        self.assertGreaterEqual(len(rows), least, what)
        d = [r[1] for r in rows]
        rms = math.sqrt(sum(x * x for x in d) / len(d))
        print(f"{what}: {len(d)} epochs, {1e3 * rms:.2f} mm RMS, {1e3 * max(d):.2f} mm at most")
        self.assertLess(rms, rms_m, what)
        self.assertLess(max(d), max_m, what)

    def bare(self):
        """Geometry and clocks alone. RINEX rounds codes to 1 mm."""
        folder = self.simulate("bare", "signals: ['G:L1CA', 'R:L1OF']\nchannel: {shapiro: no}" + ANTENNAS, "--step", "30s",
                               "--no-imu")
        for systems, name in (("1", "GPS"), ("4", "GLONASS"), ("5", "both")):
            rows = self.solve(folder, {**SINGLE, "pos1-navsys": systems})
            self.judge(f"single point, {name}", rows, 0.002, 0.005)

    def delayed(self):
        """Ionosphere and troposphere on: the ionosphere-free combination takes the first away, RTKLIB's model the second."""
        folder = self.simulate("delayed", f"signals: ['G:L1P', 'G:L2P', 'R:L1OF', 'R:L2OF']\nionosphere: {{field: {self.field}}}\n"
                               "troposphere: {model: saastamoinen, mapping: own}\nchannel: {shapiro: no}" + ANTENNAS,
                               "--step", "30s", "--no-imu")
        self.judge("iono-free, GPS", self.solve(folder, DUAL), 0.005, 0.015)
        self.judge("iono-free, GPS and GLONASS", self.solve(folder, {**DUAL, "pos1-navsys": "5"}), 0.005, 0.015)
        rows = self.solve(folder, {**DUAL, "pos1-sateph": "brdc"}, truth=False)
        self.judge("iono-free, broadcast data", rows, 1.5, 3)

    def carriers(self):
        """Phases: PPP holds wind-up and every carrier's continuity, RTK that ambiguities are integers."""
        folder = self.simulate("carriers", f"signals: ['G:L1P', 'G:L2P']\nionosphere: {{field: {self.field}}}\n"
                               "troposphere: {model: saastamoinen, mapping: niell}\nchannel: {shapiro: no}" + THREE,
                               "--step", "10s", "--no-imu")
        settled = [r for r in self.solve(folder, PPP) if r[0] >= 1800]
        self.judge("PPP, kinematic, after 30 min", settled, 0.03, 0.05)
        without = [r for r in self.solve(folder, {**PPP, "pos1-posopt3": "off"}) if r[0] >= 1800]
        self.assertGreater(sum(r[1] for r in without), 2 * sum(r[1] for r in settled), "wind-up is in the phases")
        # Ionosphere and wet troposphere differ between the antennas by 1 to 2 mm a km; RTKLIB estimates the first.
        self.baselines(folder, "all delays, ionosphere estimated", {**RTK, "pos1-ionoopt": "est-stec"}, 0.002, 0.006)
        # Left to itself it shortens baselines: at most 1 mm a km and 10 TECU above (thin shell, both carriers).
        self.baselines(folder, "all delays, ionosphere ignored", RTK, 0.01, 0.015)

    def geometry(self):
        """Phases with what RTKLIB knows as well, the dry troposphere: what is left is RINEX' thousandth of a cycle."""
        folder = self.simulate("geometry", "signals: ['G:L1P', 'G:L2P']\ntroposphere: {model: saastamoinen, mapping: niell, humidity: 0}\n"
                               "channel: {shapiro: no}" + THREE, "--step", "30s", "--no-imu")
        self.baselines(folder, "geometry", RTK, 0.0005, 0.001)

    def baselines(self, folder, what, options, rms_m, max_m):
        """Three antennas, 1 to 3 km apart: fixed throughout, and within bars."""
        for rover, base, km in (("ROVE", "BASE", 3), ("NEAR", "BASE", 1), ("NEAR", "ROVE", 2)):
            rows = self.solve(folder, options, rover, base)
            self.assertTrue(all(r[2] == 1 for r in rows[1:]), "every epoch is fixed")
            self.judge(f"RTK, {km} km, {what}", rows[1:], rms_m, max_m)


class Made(Simulation):
    """The made constellation."""

    from_, to = "2025-03-21T10:00:00", "2025-03-21T11:00:00"
    field = sample("ionosphere.ION")

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.orbit = cls.path("day.nc")
        run("orbit", "-q", "-o", cls.orbit, "--sat", "G,R", sample("ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"))

    def test_bare(self):
        self.bare()

    def test_delayed(self):
        self.delayed()

    def test_carriers(self):
        self.carriers()

    def test_geometry(self):
        self.geometry()

    def test_the_same_scenario_makes_the_same_bytes(self):
        hashes = []
        for name in ("one", "two"):
            folder = self.simulate(name, "signals: [G]\ntroposphere: {model: do229}" + ANTENNAS, "--step", "5min", "--noise",
                                   "--seed", "7")
            manifest = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))
            for item in manifest["files"]:
                digest = hashlib.sha256((folder / item["name"]).read_bytes()).hexdigest()
                self.assertEqual(digest, item["sha256"], item["name"])
            hashes.append({item["name"]: item["sha256"] for item in manifest["files"]})
            scenario, orbit = manifest["inputs"]
            self.assertEqual(scenario["name"], name + ".yaml")
            self.assertEqual(orbit, {"name": "day.nc", "sha256": hashlib.sha256(pathlib.Path(self.orbit).read_bytes()).hexdigest()})
        self.assertEqual(hashes[0], hashes[1])
        self.assertIn("BASE.rnx", hashes[0])


class Real(Simulation):
    """CODE's orbits and clocks of a day, and its maps."""

    from_, to = "2024-02-04T06:00:00", "2024-02-04T07:00:00"

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.field = data("2024-035/COD0OPSFIN_20240350000_01D_01H_GIM.INX.gz")
        cls.orbit = cls.path("day.nc")
        run("orbit", "-q", "-o", cls.orbit, "--sat", "G,R", data("2024-035/COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz"))

    def test_bare(self):
        self.bare()

    def test_carriers(self):
        self.carriers()

    def test_geometry(self):
        self.geometry()


if __name__ == "__main__":
    unittest.main()
