# SPDX-License-Identifier: GPL-3.0-or-later
"""One table of leap seconds a run: --leap-seconds, ORRERY_LEAP_SECONDS; of commands, scenarios, logs and what is written."""
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import Folder, dump, run, sample  # noqa: E402

MJD_OF_NTP = 15020
# A list as IERS serves it, with a leap second at the end of 2026 (MJD 61406 is 2027-01-01).
TABLE = list(zip((41317, 41499, 41683, 42048, 42413, 42778, 43144, 43509, 43874, 44239, 44786, 45151, 45516, 46247, 47161, 47892, 48257,
                  48804, 49169, 49534, 50083, 50630, 51179, 53736, 54832, 56109, 57204, 57754, 61406), range(10, 39)))
EXPIRES = 61583


def stamp(mjd):
    return (mjd - MJD_OF_NTP) * 86400


def ut1_minus_utc(product):
    """The first value that a product holds; by the built-in table, whatever the run's was."""
    return dump(product)["ut1_minus_utc"][0]


class LeapSeconds(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.list = cls.path("leap-seconds.list")
        rows = "".join(f"{stamp(mjd)}\t{n}\n" for mjd, n in TABLE)
        pathlib.Path(cls.list).write_text(f"#$ {stamp(61200)}\n#@ {stamp(EXPIRES)}\n{rows}", encoding="ascii")

    def test_ut1_without_measurements(self):
        """A leap second at the end of June 2024 that the built-in table does not know: UT1 is behind by half a second at least, for the
        rotation that orbits tell and for a satellite alone, whose product says so to any reader."""
        late = pathlib.Path(self.path("late.list"))
        rows = "".join(f"{stamp(mjd)}\t{n}\n" for mjd, n in (*TABLE[:-1], (60492, 38)))
        late.write_text(f"#$ {stamp(61200)}\n#@ {stamp(EXPIRES)}\n{rows}", encoding="ascii")
        day = sample("ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz")
        for sats in ("G", "G05"):
            for option in ((), ("--leap-seconds", late)):
                run("orbit", "-q", "-o", self.path(f"{sats}{len(option)}.nc"), "--nodes", "3600", "--sat", sats, *option, day,
                    env={"ORRERY_LEAP_SECONDS": "", "PATH": "/nowhere"} if not option else None)
        ut1 = [ut1_minus_utc(self.path(f"G{n}.nc")) for n in (0, 2)]
        self.assertLess(abs(ut1[0]), 0.01)  # years after the built-in table's last: 0, and zonal tides
        self.assertTrue(-1 < ut1[1] < -0.5, ut1)
        self.assertNotIn("ut1_minus_utc", dump(self.path("G050.nc")))
        self.assertLess(abs(ut1_minus_utc(self.path("G052.nc")) - ut1[1]), 0.01)
        at = ("--sat", "G05", "--frame", "j2000", "--from", "2025-03-21T12:00", "--to", "2025-03-21T12:00")
        node = [float(run("elements", self.path(n), *at).stdout.splitlines()[1].split(",")[5]) for n in ("G050.nc", "G052.nc")]
        self.assertLess(abs(node[1] - node[0] - ut1[1] * 15.041 / 3600), 1e-5)  # the Earth's turn in that time, deg

    def test_scenario_and_log(self):
        scenario = pathlib.Path(self.path("s.yaml"))
        scenario.write_text("trajectory: {kind: analytic, start: '2027-01-02T00:00:00Z', duration: 2, lat: 50, lon: 20, height: 300}\n", encoding="ascii")
        log = pathlib.Path(self.path("log.csv"))
        log.write_text("utc,lat,lon,height\n" + "".join(f"2027-01-02T00:00:{k:02d}Z,50,20,{300 + k}\n" for k in range(20)), encoding="ascii")
        for what in ([scenario], ["--telemetry", log]):
            known = run("track", *what, "--leap-seconds", self.list).stdout
            self.assertIn("2027-01-02T00:00:19", known, what)  # 38 - 19 s ahead of UTC
            self.assertNotIn("00:00:18", known)
            assumed = run("track", *what, env={"ORRERY_LEAP_SECONDS": "", "PATH": "/nowhere"})
            self.assertIn("2027-01-02T00:00:18", assumed.stdout)
            self.assertEqual(known, run("track", *what, env={"ORRERY_LEAP_SECONDS": self.list}).stdout)


if __name__ == "__main__":
    unittest.main()
