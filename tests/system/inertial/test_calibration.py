# SPDX-License-Identifier: GPL-3.0-or-later
"""`orrery calibration`: parameters returned, plans that see less, readings as a data set, and files that it refuses."""
import csv
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import Folder, dump, run, run_json  # noqa: E402

PROFILE = "profile: {segments: [{for: 10}, {for: 1, rate: 40}, {for: 18, rate: 40}, {for: 1}, {for: 1, rate: -20}, {for: 36, rate: -20}, {for: 1}]}\n"
STAND = "stand: {lat: 56, height: 150, azimuth: 10}\nrate: 20\n"
CYCLES = """
cycles:
  - {along: right, mounting: [0.2, -0.1, 0.1], offset: [0.1, 0.03, -0.04], start: -1}
  - {along: forward, mounting: [-0.1, 0.1, 0.3], offset: [0.08, 0.08, -0.04]}
  - {along: up, mounting: [0.1, 0.1, -0.1], offset: [0.06, 0.13, -0.04], start: 2}
"""
SENSORS = """
gyro: {bias: [0.5, -0.4, 0.6], scale: [-130, 80, 160], misalignment: [51, -29, 74, 39, -56, 14]}
accelerometer: {bias: [120, -80, 50], scale: [210, -170, 90], misalignment: [0, 0, 68, 0, -45, 23], arms: [21, -13, 8, -11, 25, 17, 9, -6, -31]}
"""


class Calibration(Folder):
    def write(self, name, text):
        pathlib.Path(self.path(name)).write_text(text)
        return self.path(name)

    def test_ideal_readings_return_27_parameters(self):
        self.write("sensors.yaml", SENSORS)
        study = self.write("ideal.yaml", STAND + PROFILE + CYCLES + "errors: sensors.yaml\nnull_test: false\n")
        told = run_json("calibration", study, "--format", "json", "-o", self.path("c.nc"))
        self.assertEqual(len(told["parameters"]), 27)
        for p in told["parameters"]:
            self.assertLess(abs(p["found"] / p["injected"] - 1), 1e-9, p["name"])
        readings = dump(self.path("c.nc"))
        self.assertEqual(len(readings["measured_dv_x_mps"]), told["readings"])
        # With a wrong offset along the axis the gradient of gravity is all that is lost.
        wrong = run_json("calibration", self.write("along.yaml", pathlib.Path(study).read_text() + "along_error: 0.1\n"), "--format", "json")
        for p in wrong["parameters"]:
            if p["name"].startswith("accelerometer bias"):
                self.assertLess(abs(p["found"] - p["injected"]), 2e-6)

    def test_readings_and_sigma(self):
        self.write("noisy.yaml", SENSORS.replace("gyro: {", "gyro: {white: 0.003, ").replace("accelerometer: {", "accelerometer: {white: 10, "))
        study = self.write("noise.yaml", STAND + PROFILE + CYCLES + "errors: noisy.yaml\nseeds: 30\n")
        told = run_json("calibration", study, "--format", "json", "-o", self.path("c.csv"), "--plot", self.path("c.svg"))
        self.assertLess(abs(told["nees"] - 27), 2.576 * (2 * 27 / 30) ** 0.5)
        self.assertLess(told["null_test_m"][0], 1e-5)
        with open(self.path("c.csv")) as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), told["readings"])
        self.assertEqual({r["cycle"] for r in rows}, {"1", "2", "3"})

    def test_plans_that_see_less(self):
        one = STAND + PROFILE + "cycles: {along: right}\nnull_test: false\n"
        told = run_json("calibration", self.write("one.yaml", one + "estimate: false\n"), "--format", "json")
        unseen = {p["name"] for p in told["parameters"] if not p["seen"]}
        self.assertIn("accelerometer scale x", unseen)
        self.assertNotIn("gyro scale x", unseen)
        done = run("calibration", self.write("one.yaml", one), status=1)
        self.assertIn("the plan is singular: it cannot see the accelerometer", done.stderr)
        self.assertIn("the plan cannot see it", done.stdout)

    def test_refused(self):
        for text, words in (
                (STAND + PROFILE, "a plan has one at least"),
                (STAND + CYCLES, "has no profile"),
                (STAND + PROFILE + "cycles: {along: sideways}\n", "sideways"),
                (STAND + PROFILE + "cycles: {mounting: [1, 2]}\n", "three are wanted"),
                (STAND + PROFILE + "cycles: {mounting: [50, 0, 0]}\n", "mounting error of 50 deg"),
                (STAND + "profile: {segments: {for: 0.33}}\ncycles: {along: up}\n", "whole numbers"),
                (STAND + PROFILE + CYCLES + "errors: bad.yaml\n", "white"),
        ):
            self.write("bad.yaml", "gyro: {white: -1}\n")
            self.assertIn(words, run("calibration", self.write("study.yaml", text), status=1).stderr)


if __name__ == "__main__":
    unittest.main()
