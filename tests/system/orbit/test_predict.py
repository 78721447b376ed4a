# SPDX-License-Identifier: GPL-3.0-or-later
"""`orrery orbit --predict` and `--now`: the made days' third from their first two, flagged everywhere; broadcast data and a
service from what is predicted; ultra-rapid files out of the cache; what is refused, and with which words."""
import csv
import gzip
import io
import os
import pathlib
import re
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import ORRERY, ROOT, Folder, data, dump, run, run_json, sample, ultra  # noqa: E402

sys.path.insert(0, str(ROOT / "proto/python"))
import orrery  # noqa: E402

DAYS = [f"ORR0TSTFIN_2025{d:03}0000_01D_15M_ORB.SP3.gz" for d in (79, 80, 81)]
PREDICTED = 2  # flag


def rows(*args):
    return list(csv.DictReader(io.StringIO(run("states", *args).stdout)))


class Predict(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.product = cls.path("tomorrow.nc")
        cls.summary = run_json("orbit", "--format", "json", "--predict", "24h", "--sat", "G,E", "-o", cls.product,
                               sample(DAYS[0]), sample(DAYS[1]))
        cls.text = gzip.open(sample(DAYS[1]), "rt", encoding="ascii").read()

    def test_summary(self):
        p = self.summary["prediction"]
        self.assertEqual((p["from"], p["to"]), ("2025-03-22T00:00:00", "2025-03-23T00:00:00"))
        self.assertEqual((p["orbits"], p["clocks"], p["left_out"]), (56, 56, 0))
        self.assertIn("xp_mas", p["earth_rotation"])

    def test_the_third_day(self):
        """The made Earth turns without tides, zonal or the ocean's, with which the prediction reckons: 7 and 14 cm after a day.
        G10 burns on the third day."""
        x = run_json("compare", "--format", "json", self.product, sample(DAYS[2]))
        self.assertEqual(x["prediction"]["manoeuvres"], ["G10"])
        seen = set()
        for r in x["prediction"]["rows"]:
            if r["age_h"] <= 24:
                seen.add((r["system"], r["age_h"]))
                self.assertLess(r["orbit"]["median_mm"], {1: 40, 3: 140, 6: 250, 12: 250, 24: 400}[r["age_h"]], r)
                self.assertLess(r["clock"]["median_ns"] or 0, 5, r)
        self.assertEqual(seen, {(s, a) for s in "GE" for a in (1, 3, 6, 12, 24)})
        table = run("compare", self.product, sample(DAYS[2])).stdout
        self.assertRegex(table, r"predicted, by age since a satellite's last position")

    def test_flags_and_sigma(self):
        before, after = (rows(self.product, "--sat", "G05", "--from", a, "--to", b, "--step", "900")
                         for a, b in (("2025-03-21T20:00", "2025-03-21T23:45"), ("2025-03-22T00:15", "2025-03-23T00:00")))
        self.assertEqual({int(r["flags"]) & PREDICTED for r in before}, {0})
        self.assertEqual({int(r["flags"]) & PREDICTED for r in after}, {PREDICTED})
        self.assertEqual(len(after), 96)
        self.assertTrue(all(r["clock_s"] for r in after))
        p = dump(self.product)
        first = sum(p["sample_count"][:p["satellite_name"].index("G05")])  # one arc a satellite
        sigma = p["position_sigma"][first:first + p["sample_count"][p["satellite_name"].index("G05")]]
        last = sigma[-1 - 576:]  # a day of 150 s
        self.assertTrue(all(a < b for a, b in zip(last, last[1:])))
        self.assertLess(sigma[100], 0.005)
        self.assertTrue(0.03 < sigma[-1] < 0.5)
        self.assertIn("predicted from 2025-03-22T00:00:00",
                      subprocess.run(["ncdump", "-h", self.product], capture_output=True, text=True, check=True).stdout)
        sp3 = run("states", self.product, "--format", "sp3", "--sat", "G05", "--from", "2025-03-22T06:00", "--to",
                  "2025-03-22T06:15", "--step", "900").stdout
        for line in sp3.splitlines():
            if line.startswith("P"):
                self.assertEqual((line[75], line[79]), ("P", "P"))

    def test_rotation_goes_on(self):
        p = dump(self.product)
        self.assertLess(p["earth_rotation_mjd"][0], 60754.1)
        self.assertGreater(p["earth_rotation_mjd"][-1], 60757)
        self.assertEqual(p["earth_rotation_mjd"], sorted(set(p["earth_rotation_mjd"])))
        steps = [b - a for a, b in zip(p["ut1_minus_utc"], p["ut1_minus_utc"][1:])]
        self.assertLess(max(steps) - min(steps), 2e-4)  # no jump where the two estimates meet

    def test_any_number_of_threads(self):
        for jobs in (1, 3):
            run("orbit", "-q", "--predict", "6h", "--sat", "G01-G08", "--jobs", jobs, "-o", self.path(f"jobs{jobs}.nc"),
                sample(DAYS[1]))
        a, b = (dump(self.path(f"jobs{j}.nc")) for j in (1, 3))
        self.assertEqual(a, b)

    def test_broadcast_data_of_tomorrow(self):
        made = run("navfit", self.product, "-o", self.path("tomorrow.rnx"))
        self.assertIn("GPS", made.stderr + made.stdout)
        epochs = re.findall(r"^G05 2025 03 22 (\d\d)", pathlib.Path(self.path("tomorrow.rnx")).read_text(encoding="ascii"), re.M)
        self.assertGreater(len(epochs), 10)

    def test_a_service_plays_now(self):
        """The newest ultra-rapid of the cache, up to a present that is told, served: states of now, flagged."""
        folder = pathlib.Path(self.path("cache")) / "2025/080"
        folder.mkdir(parents=True)
        (folder / "TST0OPSULT_20250800000_01D_15M_ORB.SP3").write_text(ultra(self.text, "17:45"), encoding="ascii")
        (folder / "TST0OPSULT_20250791200_01D_15M_ORB.SP3").write_text(ultra(self.text, "11:45"), encoding="ascii")
        (folder / "other_ORB.SP3").write_text(self.text, encoding="ascii")  # no ultra-rapid: nothing in it is predicted
        env = dict(os.environ, ORRERY_CACHE=self.path("cache"))
        now = self.path("now.nc")
        s = run_json("orbit", "--now", "--present", "2025-03-21T20:10", "--sat", "G01-G06", "--format", "json", "-o", now,
                     env=env)
        self.assertEqual(s["prediction"]["from"], "2025-03-21T17:45:00")
        self.assertEqual(s["prediction"]["to"], "2025-03-22T02:15:00")  # six hours on, to the end of a segment
        with subprocess.Popen([ORRERY, "serve", now, "--listen", f"unix:{self.path('s')}"], stderr=subprocess.PIPE,
                              text=True) as serve:
            try:
                for line in serve.stderr:
                    if "ready on" in line:
                        break
                with orrery.Client(f"unix:{self.path('s')}") as client:
                    t = client.span[0] + (20 * 3600 + 600) * 10**9
                    states = client.states(t)
                    self.assertEqual(len(states.satellites), 6)
                    self.assertTrue(all(x.flags & PREDICTED for x in states.satellites))
            finally:
                serve.terminate()
                serve.wait(60)

    def test_what_a_file_predicts_itself_is_not_used(self):
        pathlib.Path(self.path("u.sp3")).write_text(ultra(self.text, "11:45"), encoding="ascii")
        s = run_json("orbit", "--predict", "1h", "--sat", "G01-G06", "--format", "json", "-o", self.path("u.nc"),
                     self.path("u.sp3"))
        self.assertEqual(s["prediction"]["from"], "2025-03-21T11:45:00")
        self.assertEqual(s["systems"]["G"]["nodes"], 6 * 48)

    def test_refusals(self):
        source, out = sample(DAYS[1]), self.path("x.nc")
        pathlib.Path(self.path("p.sp3")).write_text(ultra(self.text, ""), encoding="ascii")
        for status, args, words in (
                (1, ("--predict", "1h", self.path("p.sp3")), "files flag all as predicted"),
                (1, ("--predict", "8d", source), "at most 7 days"),
                (1, ("--predict", "1h", "--exclude", "2025-03-21T01:00/2025-03-23", source), "two hours"),
                (1, ("--now", source), "at most 7 days"),
                (2, ("--present", "2025-03-22", source), "--now"),
                (2, ("--predict", "-1h", source), "predict"),
                (2, (), "SP3... is needed")):
            with self.subTest(args=args):
                done = run("orbit", "-o", out, *args, status=status)
                self.assertRegex(done.stderr, words)
                self.assertNotIn("x.nc", self.left())
        env = dict(os.environ, ORRERY_CACHE=self.path("nowhere"))
        done = run("orbit", "--now", "-o", out, env=env, status=1)
        self.assertRegex(done.stderr, "no ultra-rapid orbits .*orrery fetch")

    def test_real_ultra(self):
        """What the IGS observed in the half day after: as near as its own prediction of then (2.0 and 3.5 cm at 1 and 6 h)."""
        product = self.path("igu.nc")
        run("orbit", "-q", "--predict", "12h", "-o", product, data("ultra/igu16295_00.sp3.gz"))
        x = run_json("compare", "--format", "json", product, data("ultra/igu16295_12.sp3.gz"))
        self.assertEqual(x["prediction"]["predicted_truth"], 0)
        for r in x["prediction"]["rows"]:
            if not r["eclipses"]:
                self.assertLess(r["orbit"]["median_mm"], {1: 30, 3: 50, 6: 60, 12: 90}[r["age_h"]])
                self.assertTrue(0.5 < r["orbit"]["error_over_sigma"] < 1.5, r)


if __name__ == "__main__":
    unittest.main()
