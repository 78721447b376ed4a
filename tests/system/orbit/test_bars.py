# SPDX-License-Identifier: GPL-3.0-or-later
"""What the main job must reach, on real files, by the program itself: CODE's 5-min orbits of 2024-02-03 to 05, of which every
third epoch (or fewer) is input and the rest is truth."""
import csv
import io
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import Folder, data, run, run_json  # noqa: E402

DAYS = [f"2024-035/COD0OPSFIN_2024{d:03}0000_01D_05M_ORB.SP3.gz" for d in (34, 35, 36)]
SYSTEMS = {"G", "R", "E"}


class Bars(Folder):
    def compared(self, name, *options, nodes):
        """Differences per system of day 035, made with options, from the rest of the day's epochs."""
        day, product = data(DAYS[1]), self.path(name)
        summary = run_json("orbit", "--format", "json", "-o", product, *options, day)
        for v in summary["systems"].values():
            self.assertEqual(v["nodes"] + v["left_out"], v["satellites"] * nodes)
        self.assertLess(summary["segment_error_mm"], 0.1)  # the product against its own dense integration
        self.assertLess(summary["segment_error_mps"], 1e-6)
        systems = run_json("compare", "--format", "json", product, day)["systems"]
        self.assertEqual(set(systems), SYSTEMS)
        return systems

    def below(self, systems, place, key, bar):
        for system in sorted(systems):
            limit = bar[system] if isinstance(bar, dict) else bar
            value = systems[system][place][key]
            print(f"{system} {place} {key}: {value:.3g} (at most {limit:g})")
            self.assertGreater(systems[system][place]["n"], 0)
            self.assertLessEqual(value, limit, f"{system} {place} {key}")

    def test_day_alone(self):
        s = self.compared("day.nc", "--nodes", "900", nodes=97)
        self.below(s, "inner", "rms_mm", 0.75)
        self.below(s, "inner", "max_mm", 6)
        self.below(s, "inner", "vel_rms_mps", 5e-6)
        self.below(s, "edge", "rms_mm", 1.2)

    def test_without_the_last_node(self):
        s = self.compared("no24.nc", "--nodes", "900", "--exclude", "2024-02-05/2024-02-05", nodes=96)
        self.below(s, "inner", "rms_mm", 0.75)
        self.below(s, "edge", "rms_mm", 1.5)

    def test_hourly_nodes(self):
        s = self.compared("hourly.nc", "--nodes", "3600", nodes=25)
        self.below(s, "inner", "rms_mm", {"G": 2.5, "E": 2.5, "R": 4})

    def test_an_hour_without_nodes(self):
        gaps = []  # not tuned to one place of the day
        for hour in ("05", "12", "17"):
            gaps += ["--exclude", f"2024-02-04T{hour}:00/2024-02-04T{int(hour) + 1:02}:00"]
        s = self.compared("gap.nc", "--nodes", "900", *gaps, nodes=97 - 3 * 4)
        self.below(s, "gap", "rms_mm", 3)
        self.below(s, "inner", "rms_mm", 0.75)

    def test_velocity_records(self):
        """NGA's day with V records: those are the positions' derivatives to 6e-5 m/s only, and ours are to 1e-6."""
        day, product = data("2015-200-velocity/test_input_sp3_nav_2015_200.sp3.gz"), self.path("nga.nc")
        run("orbit", "-q", "-o", product, "--nodes", "900", day)
        for kind, bar in (("records", 1e-4), ("positions", 2e-6)):
            s = run_json("compare", "--format", "json", "--velocity", kind, product, day)
            self.assertEqual(s["truth_velocity"], kind)
            self.below(s["systems"], "inner", "vel_rms_mps", bar)

    def test_midnights(self):
        """Joint smoothing of three days: no jump over midnight, while the files' own is told."""
        product = self.path("three.nc")
        summary = run_json("orbit", "--format", "json", "-o", product, "--nodes", "900", *(data(d) for d in DAYS))
        jumps = summary["day_jumps"]
        self.assertEqual(jumps["n"], 2 * 80)
        self.assertGreater(jumps["rms_mm"], 1)  # centimetres between CODE's days
        print(f"files differ at midnight by {jumps['rms_mm']:.1f} mm RMS, {jumps['max_mm']:.1f} mm at most")
        h = 0.001
        worst = [0.0, 0.0]
        for at in ("2024-02-03T23:59:59.998/2024-02-04T00:00:00", "2024-02-04T23:59:59.998/2024-02-05T00:00:00"):
            begin, end = at.split("/")
            text = run("states", product, "--from", begin, "--to", end, "--step", str(h)).stdout
            rows = list(csv.DictReader(io.StringIO(text)))
            self.assertEqual(len(rows), 3 * 80)
            for a, b, c in zip(rows[:80], rows[80:160], rows[160:]):
                self.assertEqual(a["sat"], c["sat"])
                jump = [0.0, 0.0]
                for p, v in (("x_m", "vx_mps"), ("y_m", "vy_mps"), ("z_m", "vz_mps")):
                    acc = (float(b[v]) - float(a[v])) / h
                    jump[0] += (float(b[p]) + h * float(b[v]) + h * h / 2 * acc - float(c[p])) ** 2
                    jump[1] += (float(b[v]) + h * acc - float(c[v])) ** 2
                worst = [max(w, j ** 0.5) for w, j in zip(worst, jump)]
        print(f"the product jumps by {1e3 * worst[0]:.4f} mm and {worst[1]:.1e} m/s")
        self.assertLess(worst[0], 1e-4)
        self.assertLess(worst[1], 1e-6)
        # The middle day's own file against the joint product: near its midnights the days' difference shows.
        systems = run_json("compare", "--format", "json", product, data(DAYS[1]))["systems"]
        self.below(systems, "inner", "rms_mm", 1.5)


if __name__ == "__main__":
    unittest.main()
