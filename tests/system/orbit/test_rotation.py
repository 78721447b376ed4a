# SPDX-License-Identifier: GPL-3.0-or-later
"""The Earth's rotation that a product holds: as a file of Earth rotation parameters, and where the frame is turned by it."""
import csv
import gzip
import io
import math
import pathlib
import re
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import Folder, data, dump, run, run_json, sample  # noqa: E402

DAYS = [f"ORR0TSTFIN_2025{d:03}0000_01D_15M_ORB.SP3.gz" for d in (79, 80, 81)]
MAS = math.pi / 180 / 3.6e6
DAY = 60755  # MJD of 2025-03-21


def rtklib_readerp(path):
    """Lines as RTKLIB's readerp takes them: any with five numbers or more from the left, columns by their places (rtkcmn.c)."""
    rows = []
    for line in pathlib.Path(path).read_text(encoding="ascii").splitlines():
        v = []
        for word in line.split()[:14]:
            try:
                v.append(float(word))
            except ValueError:
                break
        if len(v) >= 5:
            v += [0.0] * (14 - len(v))
            rows.append({"mjd": v[0], "xp": v[1] * 1e-3, "yp": v[2] * 1e-3, "ut1_utc": v[3] * 1e-7, "lod": v[4] * 1e-7,
                         "xpr": v[12] * 1e-3, "ypr": v[13] * 1e-3})
    return rows


class Rotation(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.product, cls.erp = cls.path("day.nc"), cls.path("day.erp")
        cls.summary = run_json("orbit", "--format", "json", "-o", cls.product, "--erp-out", cls.erp, "--sat", "G", sample(DAYS[1]))

    def test_the_samples_have_the_secular_pole(self):
        """Their truth turns by it, without the ocean's tides, which are up to 0.7 mas and 0.07 ms a day."""
        year = 2000 + (DAY + 0.5 - 51544.5) / 365.25
        rows = rtklib_readerp(self.erp)
        self.assertEqual([r["mjd"] for r in rows], [DAY - 0.5, DAY, DAY + 0.5, DAY + 1][-len(rows):])
        noon = next(r for r in rows if r["mjd"] == DAY + 0.5)
        self.assertLess(abs(noon["xp"] - (55.0 + 1.677 * (year - 2000))), 0.7)
        self.assertLess(abs(noon["yp"] - (320.5 + 3.460 * (year - 2000))), 0.7)

    def test_file_product_and_summary_are_one(self):
        p = dump(self.product)
        r = self.summary["earth_rotation"]
        self.assertTrue(r["used"])
        noon = next(x for x in rtklib_readerp(self.erp) if x["mjd"] == DAY + 0.5)
        self.assertAlmostEqual(noon["xp"], r["xp_mas"], delta=0.002)  # the span's middle is 18 s later
        self.assertAlmostEqual(noon["yp"], r["yp_mas"], delta=0.002)
        self.assertAlmostEqual(noon["lod"] * 1e3, r["lod_ms"], delta=0.001)
        self.assertGreater(p["earth_rotation_pole_sigma_arcsec"], 0)
        self.assertAlmostEqual(p["earth_rotation_pole_sigma_arcsec"] * 1e3, r["pole_sigma_mas"], places=6)
        k = min(range(len(p["earth_rotation_mjd"])), key=lambda i: abs(p["earth_rotation_mjd"][i] - DAY - 0.5))
        self.assertLess(abs(p["pole_x"][k] / MAS - noon["xp"]), 0.2)  # within 90 min of noon
        text = run("inspect", self.erp).stdout
        self.assertIn("Earth rotation parameters", text)
        self.assertIn("no gaps", text)

    def test_the_file_covers_the_product(self):
        """Given back it is kept, and the orbits agree with it to the digits that the format has."""
        again = run_json("orbit", "--format", "json", "-o", self.path("again.nc"), "--erp", self.erp, "--sat", "G", sample(DAYS[1]))
        self.assertTrue(again["earth_rotation_given"])
        r = again["earth_rotation"]
        self.assertFalse(r["used"])
        self.assertLess(abs(r["xp_off_mas"]) + abs(r["yp_off_mas"]), 0.01)
        self.assertLess(abs(r["lod_off_ms"]), 0.002)

    def rows(self, *args):
        return list(csv.DictReader(io.StringIO(run("elements", *args).stdout)))

    def test_elements_turn_by_it(self):
        """They are those that the file gives, and not those of the secular pole."""
        args = (self.product, "--sat", "G05,G17", "--frame", "j2000", "--from", "2025-03-21T06:00", "--to", "2025-03-21T18:00",
                "--step", "6h")
        own, by_file = self.rows(*args), self.rows(*args, "--erp", self.erp)
        for a, b in zip(own, by_file):
            self.assertLess(abs(float(a["raan_deg"]) - float(b["raan_deg"])), 1e-8)
            self.assertLess(abs(float(a["i_deg"]) - float(b["i_deg"])), 1e-8)
            self.assertLess(abs(float(a["a_m"]) - float(b["a_m"])), 0.002)

    def test_one_satellite_tells_no_pole(self):
        done = run("orbit", "-o", self.path("one.nc"), "--sat", "G05", sample(DAYS[1]))
        self.assertIn("Earth rotation: secular pole, UT1 by the leap seconds", done.stderr)
        done = run("orbit", "-o", self.path("one.nc"), "--sat", "G05", "--erp-out", self.path("one.erp"), sample(DAYS[1]), status=1)
        self.assertRegex(done.stderr, "the orbits tell no Earth rotation .*four satellites")
        self.assertNotIn("one.erp", self.left())
        self.assertNotIn("pole_x", dump(self.path("one.nc")))

    def test_inertial_positions_are_refused(self):
        """Turned by the Earth's angle, whatever the header calls the frame."""
        out, t = [], 0
        for line in gzip.open(sample(DAYS[1]), "rt", encoding="ascii").read().splitlines():
            if line.startswith("*"):
                t = int(line[14:16]) * 3600 + int(line[17:19]) * 60
            if line.startswith("P"):
                x, y, z = (float(line[4 + 14 * k:18 + 14 * k]) for k in range(3))
                c, s = math.cos(1 + 7.2921151467e-5 * t), math.sin(1 + 7.2921151467e-5 * t)
                line = f"{line[:4]}{c * x - s * y:14.6f}{s * x + c * y:14.6f}{z:14.6f}{line[46:]}"
            out.append(line)
        pathlib.Path(self.path("inertial.sp3")).write_text("\n".join(out) + "\n", encoding="ascii")
        done = run("orbit", "-o", self.path("x.nc"), self.path("inertial.sp3"), status=1)
        self.assertRegex(done.stderr, r"inertial\.sp3: its positions do not turn with the Earth: they are in inertial axes")
        self.assertNotIn("x.nc", self.left())

    def test_an_hour_of_data(self):
        """It tells no pole; the orbit is there all the same, and nothing can be predicted from it."""
        hour = ("--exclude", "2025-03-21T01:01/2025-03-23", "--sat", "G", sample(DAYS[1]))
        done = run("orbit", "-o", self.path("hour.nc"), *hour)
        self.assertIn("Earth rotation: secular pole, UT1 by the leap seconds", done.stderr)
        done = run("orbit", "-o", self.path("hour.nc"), "--predict", "1h", *hour, status=1)
        self.assertIn("nothing to predict from: no satellite has positions over two hours", done.stderr)

    def test_one_satellite_is_predicted(self):
        """It tells a rotation good enough for itself, which the product does not keep."""
        s = run_json("orbit", "--format", "json", "--predict", "6h", "--sat", "G05", "-o", self.path("g05.nc"), sample(DAYS[1]))
        self.assertEqual(s["prediction"]["orbits"], 1)
        self.assertNotIn("earth_rotation", s["prediction"])
        self.assertNotIn("pole_x", dump(self.path("g05.nc")))
        x = run_json("compare", "--format", "json", self.path("g05.nc"), sample(DAYS[2]))
        self.assertLess(next(r for r in x["prediction"]["rows"] if r["age_h"] == 3)["orbit"]["median_mm"], 300)

    def test_real_pole(self):
        """CODE's own pole, which its orbits were made with, to 0.1 mas; its length of day, whose change over a day is
        known to 0.03 ms before, to 0.05 ms."""
        erp = self.path("code.erp")
        run("orbit", "-q", "-o", self.path("code.nc"), "--erp-out", erp, "--sat", "G",
            data("2008-279/COD15000.EPH.Z"), data("2008-279/COD15001.EPH.Z"))
        theirs = self.path("theirs.erp")
        pathlib.Path(theirs).write_bytes(
            subprocess.run(["gzip", "-dc", data("2008-279/COD15007.ERP.Z")], capture_output=True, check=True).stdout)
        reference = {r["mjd"]: r for r in rtklib_readerp(theirs)}
        n = 0
        for r in rtklib_readerp(erp):
            if r["mjd"] not in reference or not 54744 < r["mjd"] < 54746:
                continue
            n += 1
            for k, most in (("xp", 0.1), ("yp", 0.1), ("lod", 5e-5)):
                self.assertLess(abs(r[k] - reference[r["mjd"]][k]), most, (k, r))
        self.assertEqual(n, 2)

    def test_a_rotation_that_contradicts_the_orbits(self):
        """Half an arc second off: told, and what the orbits tell is used."""
        text = pathlib.Path(self.erp).read_text(encoding="ascii")
        wrong = re.sub(r"^( *\d{5}\.\d\d +)(-?\d+)", lambda m: m.group(1) + str(int(m.group(2)) + 500000), text, flags=re.M)
        pathlib.Path(self.path("wrong.erp")).write_text(wrong, encoding="ascii")
        done = run("orbit", "-o", self.path("wrong.nc"), "--erp", self.path("wrong.erp"), "--sat", "G", sample(DAYS[1]))
        self.assertRegex(done.stderr, r"contradicts the orbits: they tell a pole that is 500\.0 mas off")
        self.assertIn("told by the orbits themselves", done.stderr)

    def test_a_gap_of_a_year_is_no_series(self):
        """Values half a year before and after: what the orbits tell is used, to the bit as without the file; a satellite alone
        tells nothing, and the file is refused."""
        text = pathlib.Path(self.erp).read_text(encoding="ascii")
        moved = [re.sub(r"^( *)(\d{5}\.\d\d)", lambda m: f"{m.group(1)}{float(m.group(2)) + days:.2f}", text, flags=re.M)
                 for days in (-180, 180)]
        rows = [line for line in moved[1].splitlines() if re.match(r" *\d{5}\.\d\d", line)]
        path = self.path("gap.erp")
        pathlib.Path(path).write_text(moved[0].rstrip("\n") + "\n" + "\n".join(rows) + "\n", encoding="ascii")
        done = run("orbit", "-o", self.path("gap.nc"), "--erp", path, "--sat", "G", sample(DAYS[1]))
        self.assertRegex(done.stderr, "given has no values from 2024-09-.* to 2025-09-.*, and the positions are of 2025-03-21.*"
                         "more than a month from any value; what the orbits tell is used instead")
        states = [run("states", self.path(n), "--sat", "G", "--step", "3h").stdout for n in ("gap.nc", "day.nc")]
        self.assertEqual(*states)
        done = run("orbit", "-o", self.path("alone.nc"), "--erp", path, "--sat", "G05", sample(DAYS[1]), status=1)
        self.assertRegex(done.stderr, "more than a month from any value; so few orbits do not tell the rotation by themselves: give a "
                         "file that covers them, or none")


if __name__ == "__main__":
    unittest.main()
