# SPDX-License-Identifier: GPL-3.0-or-later
"""`orrery vibration`: the source's figures through the program, in its several forms, and files that it refuses."""
import csv
import math
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import Folder, dump, run, run_json, sample  # noqa: E402

# Normalised errors of the source's three methods as a prototype had them: f_m = 100 Hz, f_v beta^2 = 1e-5.
PROTOTYPE = {0.01: (6.6e-4, 5.2e-7, 1.3e-11), 0.1: (6.5e-2, 5.0e-3, 3.5e-5), 0.25: (0.36, 0.15, 0.030), 10.3: (0.985, 0.979, 0.974)}


class Vibration(Folder):
    def study(self, name, text):
        path = self.path(name)
        pathlib.Path(path).write_text(text)
        return path

    def test_figures(self):
        study = self.study("figures.yaml", "ratios: {low: 0.01, high: 10, points: 5, also: [0.1, 0.25, 10.3]}\n")
        run("vibration", study, "-o", self.path("v.csv"), "--plot", self.path("v.svg"), "--axes", "linear")
        with open(self.path("v.csv")) as file:
            rows = list(csv.DictReader(file))
        for ratio, errors in PROTOTYPE.items():
            for method, error in zip(("1-step", "2-step", "4-step"), errors):
                found = [float(r["normalised"]) for r in rows if r["method"] == method and abs(float(r["ratio"]) / ratio - 1) < 1e-9]
                self.assertEqual(len(found), 1)
                self.assertLess(abs(found[0] / error - 1), 0.02, (ratio, method))
        self.assertIn("<svg", pathlib.Path(self.path("v.svg")).read_text())
        text = run("vibration", study, "--sweep").stdout
        self.assertIn("methods of equal error", text)
        run("vibration", study, "-o", self.path("v.nc"))
        self.assertEqual(len(dump(self.path("v.nc"))["normalised"]), len(rows))

    def test_own_coefficients_and_rest(self):
        study = self.study("own.yaml", """
ratios: {low: 0.1, high: 0.3, points: 3}
products: [1e-5, 1e-6]
methods: 2-step
own:
  - {name: same, samples: 2, coefficients: 0.66666666666666667}
  - {name: half, samples: 2, coefficients: 0.5}
rest: {lat: 60}
""")
        told = run_json("vibration", study, "--format", "json")
        errors = {(s["method"], s["product"]): [e["normalised"] for e in s["errors"]] for s in told["sweeps"]}
        for product in (1e-5, 1e-6):
            for a, b in zip(errors["2-step", product], errors["same", product]):
                self.assertAlmostEqual(a, b, 12)
        self.assertIn("half: its coefficients sum to 0.75", run("vibration", study).stdout)

    def test_all_methods(self):
        told = run_json("vibration", self.study("all.yaml", "ratios: {low: 0.1, high: 0.2, points: 2}\nduration: 0.2\nmethods: all\n"), "--format", "json")
        self.assertEqual({s["method"] for s in told["sweeps"]},
                         {f"{n}-step" for n in range(1, 6)} | {f"polynomial-{n}" for n in range(3, 6)} | {"iteration-4", "iteration-8"})
        mixed = run("vibration", self.study("mixed.yaml", "methods: [all, 1-step]\n"), status=1).stderr
        self.assertIn('no method "all"', mixed)

    def test_readings(self):
        study = self.study("rest.yaml", "rest: {lat: 56, height: 150, heading: 30}\nproducts: 1e-4\nduration: 5\nratios: {low: 0.1, high: 0.2, points: 2}\n")
        run("vibration", study, "--readings", self.path("v-imu.nc"), "--ratio", 0.05)
        told = run_json("nulltest", self.path("v-imu.nc"), "--format", "json")
        self.assertLess(told["position"]["max_3d_m"], 1e-4)
        # A one-step navigator loses what the study says of one step: 1 - sin(x)/x of the drift, x = 2 pi 0.05.
        told = run_json("nulltest", self.path("v-imu.nc"), "--navigator", "one-step", "--format", "json")
        x = 2 * math.pi * 0.05
        self.assertLess(abs(told["attitude"]["max_rad"] / (math.pi * 1e-4 * 5 * (1 - math.sin(x) / x)) - 1), 0.05)
        self.assertIn("rest", run("vibration", self.study("no.yaml", "ratios: {points: 2}\n"), "--readings", self.path("x.nc"), status=1).stderr)

    def test_sample(self):
        told = run_json("vibration", sample("studies/vibration.yaml"), "--format", "json")
        wide = told["broadband"]["2-step"]
        self.assertLess(abs(wide["runs_radps"] / wide["response_radps"] - 1), 0.15)

    def test_refused(self):
        for text, words in (
                ("methods: 7-step\n", "there is no method \"7-step\""),
                ("own: {name: a, samples: 4, coefficients: [1, 2]}\n", "4 samples need 3"),
                ("own: {name: a, samples: 12, coefficients: [1, 2]}\n", "samples"),
                ("ratios: {low: 2, high: 1}\n", "high"),
                ("products: [-1]\n", "products"),
                ("products: [9]\nratios: {low: 0.001}\n", "half a turn"),
                ("spectrum: {file: none.csv}\n", "none.csv"),
        ):
            self.assertIn(words, run("vibration", self.study("bad.yaml", text), status=1).stderr)
        for table, words in (("10,1\n5,1\n", "ascend"), ("10,1\n20,-1\n", "none is negative"), ("f,d\n10,1\nx,1\n", ":3"), ("10 1\n", "two frequencies"),
                             ("# none\n", "no rows")):
            self.study("psd.csv", table)
            self.assertIn(words, run("vibration", self.study("bad.yaml", "spectrum: {file: psd.csv}\n"), status=1).stderr)


if __name__ == "__main__":
    unittest.main()
