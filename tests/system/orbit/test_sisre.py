# SPDX-License-Identifier: GPL-3.0-or-later
"""orrery sisre on broadcast data that were fitted to a known orbit: what it must find, and what it says when it cannot."""
import gzip
import json
import pathlib
import re
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import Folder, run, run_json, sample  # noqa: E402

DAYS = [f"ORR0TSTFIN_2025{d:03}0000_01D_15M_ORB.SP3.gz" for d in (79, 80, 81)]


class Sisre(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        product, cls.nav = cls.path("day.nc"), cls.path("day.rnx")
        run("orbit", "-q", "-o", product, "--sat", "G08-G12,R08,R09", sample(DAYS[1]))
        run("navfit", "-q", product, "-o", cls.nav)

    def test_fitted_sets_are_near(self):
        found = run_json("sisre", "--format", "json", self.nav, sample(DAYS[1]))["systems"]
        self.assertEqual({k: v["satellites"] for k, v in found.items()}, {"G": 5, "R": 2})
        self.assertLess(found["G"]["orbit_3d_m"], 0.05)  # what two hours of 15 parameters leave
        self.assertLess(found["R"]["orbit_3d_m"], 0.5)  # what the lattice of GLONASS leaves

    def test_another_day(self):
        with gzip.open(sample(DAYS[1]), "rt", encoding="ascii") as f:
            other = re.sub(r"(?m)^(\*  )2025", r"\g<1>2021", f.read())
        path = self.path("other.sp3")
        pathlib.Path(path).write_text(other, encoding="ascii")
        text = run("sisre", self.nav, path, status=1).stderr
        self.assertIn("the positions are of 2021-03-21", text)
        self.assertIn("the records of 2025-03-2", text)

    def test_names_that_are_others(self):
        with gzip.open(sample(DAYS[1]), "rt", encoding="ascii") as f:
            lines = f.read().splitlines()
        turned = {f"PG{k:02}": f"PG{k + 1:02}" for k in range(8, 12)} | {"PG12": "PG08"}
        path = self.path("turned.sp3")
        pathlib.Path(path).write_text("\n".join(turned.get(x[:4], x[:4]) + x[4:] for x in lines) + "\n", encoding="ascii")
        found = json.loads(run("sisre", "--format", "json", self.nav, path).stdout)["systems"]
        self.assertEqual((found["G"]["n"], found["R"]["satellites"]), (0, 2))
        self.assertGreater(found["G"]["outliers"], 100)
        self.assertIn("same satellites", run("sisre", self.nav, path).stdout)


if __name__ == "__main__":
    unittest.main()
