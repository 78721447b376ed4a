# SPDX-License-Identifier: GPL-3.0-or-later
"""Broadcast models of the ionosphere as the source of a scenario: what `orrery tec` says along a ray is what a scenario's satellites
have, and a session over NeQuick-G carries its tables along."""
import csv
import datetime
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import Folder, data, run, sample  # noqa: E402

DAY = sample("ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz")
PLACE = "52.28,17.07,124"


def label(text, name):
    return f"{text:<60}{name:<20}\n"


def number(x):
    return f"{x:19.12E}"


def made_navigation(path, day, gal):
    """Coefficients of all models in a header of version 3, and one record, since a file without one is refused."""
    rows = (("GPSA", (1.1e-8, 1.5e-8, -6e-8, -1.2e-7)), ("GPSB", (9e4, 6e4, -2e5, -5e5)), ("BDSA", (2e-8, 1e-8, -3e-8, 1e-8)),
            ("BDSB", (1e5, 2e4, -6e4, 1e4)), ("GAL ", (*gal, 0)))
    text = label("     3.05           N: GNSS NAV DATA    E: GALILEO", "RINEX VERSION / TYPE")
    for name, four in rows:
        text += label(f"{name} " + "".join(f"{x:12.4E}" for x in four), "IONOSPHERIC CORR")
    text += label("", "END OF HEADER") + f"E02 {day} 00 50 00" + "".join(map(number, (1.4e-4, 2.6e-12, 0))) + "\n"
    week, days = divmod((datetime.date(*map(int, day.split())) - datetime.date(1980, 1, 6)).days, 7)
    toe = days * 86400 + 3000
    for four in ((69, 28.75, 2.6e-9, -0.95), (1.2e-6, 1e-4, 1e-5, 5440.61), (toe, 3e-8, 0.212, 7e-8), (0.98, 131, 0.077, -5.2e-9),
                 (-7e-10, 517, week, 0), (3.12, 0, -3.5e-9, 0), (toe + 600, 0, 0, 0)):
        text += "    " + "".join(map(number, four)) + "\n"
    pathlib.Path(path).write_text(text, encoding="ascii")
    return path


def table(text):
    return list(csv.DictReader(text.splitlines()))


class Models(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.orbit = cls.path("day.nc")
        run("orbit", "-q", "-o", cls.orbit, "--sat", "G01-G12,E01-E06", DAY)
        cls.nav = made_navigation(cls.path("nav.rnx"), "2025 03 21", (80, 0.1, 0.01))

    def scenario(self, ionosphere):
        path = pathlib.Path(self.path("s.yaml"))
        path.write_text(f"orbit: {{product: {self.orbit}}}\nionosphere: {ionosphere}\nreceiver: {{position: [{PLACE}]}}\n", encoding="ascii")
        return path

    def check(self, keys, *options, tolerance=2e-6):
        at = ("--from", "2025-03-21T12:00", "--to", "2025-03-21T12:00")
        rows = table(run("delays", self.scenario(f"{{field: {self.nav}, {keys}}}"), *at).stdout)
        self.assertGreater(len(rows), 3)
        for row in rows[:4]:
            ray = table(run("tec", self.nav, "--at", "2025-03-21T12:00", "--receiver", PLACE, "--el", row["el_deg"], "--az", row["az_deg"],
                            *options).stdout)[0]
            # Angles are printed to 1e-4 degree: a steep gradient of 1 TECU a degree is 1e-4 TECU.
            self.assertAlmostEqual(float(row["stec_tecu"]) / float(ray["stec_tecu"]), 1, delta=3e-5, msg=keys)

    def test_klobuchar(self):
        self.check("model: gps", "--model", "gps")
        self.check("model: beidou", "--model", "beidou")
        self.check("model: gps, mapping: thin-shell", "--model", "gps", "--mapping", "thin-shell")

    def test_nequick(self):
        folder = pathlib.Path(data("nequick/modip.asc.gz")).parent
        self.check(f"model: nequick, nequick: {folder}", "--model", "nequick", "--nequick", folder)

    def test_what_is_wrong_is_told_with_its_line(self):
        for ionosphere, words in (("{model: gps}", "s.yaml:2:14: ionosphere.model: has no effect without ionosphere.field"),
                                  (f"{{field: {self.nav}, model: gps, nequick: x}}", "ionosphere.nequick: has no effect with"),
                                  (f"{{field: {self.nav}, model: klobuchar}}", "'klobuchar' is none of auto, gps"),
                                  (f"{{field: {self.nav}, model: nequick}}", "ccir11.asc"),
                                  (f"{{field: {self.nav}, model: bdgim}}", "nor others of the model asked for")):
            self.assertIn(words, run("delays", self.scenario(ionosphere), status=1).stderr)

    def test_a_session_carries_its_tables(self):
        folder = pathlib.Path(data("nequick/modip.asc.gz")).parent
        observed = data("2024-035/BOR100POL_R_20240350000_01D_30S_MO.crx.gz")
        orbit, session = self.path("real.nc"), self.path("session.nc")
        run("orbit", "-q", "-o", orbit, "--sat", "G01-G12", data("2024-035/COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz"))
        nav = made_navigation(self.path("real.rnx"), "2024 02 04", (121, 0.35, 0.004))
        run("iono", "-q", observed, "--field", nav, "--model", "nequick", "--nequick", folder, "--orbit", orbit, "--sat", "G01-G12",
            "--from", "2024-02-04T12:00", "--to", "2024-02-04T12:20", "--method", "thesis", "-o", session)
        far = ("--receiver", "-35,150,100", "--from", "2024-02-04T12:10", "--to", "2024-02-04T12:10")
        text = f"orbit: {{product: {orbit}}}\nionosphere: "
        kept, fresh = pathlib.Path(self.path("kept.yaml")), pathlib.Path(self.path("fresh.yaml"))
        kept.write_text(text + f"{{session: {session}, noise: no}}\n", encoding="ascii")
        fresh.write_text(text + f"{{field: {nav}, model: nequick, nequick: {folder}}}\n", encoding="ascii")
        a, b = (table(run("delays", path, *far).stdout) for path in (kept, fresh))
        self.assertGreater(len(a), 2)
        self.assertEqual([(r["sat"], r["stec_tecu"]) for r in a], [(r["sat"], r["stec_tecu"]) for r in b])


if __name__ == "__main__":
    unittest.main()
