#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""orrery alignment and error-equations: what their files must hold, what comes out in every form, and the physics of the samples in small."""
import csv
import pathlib
import subprocess
import sys
import unittest
import xml.etree.ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import Folder, run, run_json, sample  # noqa: E402

REST = "trajectory: {kind: analytic, duration: 400, lat: 45, lon: 20}\nimu: {rate: 10}\n"
CIRCLE = "trajectory: {kind: analytic, duration: 300, lat: 45, lon: 20, motions: [{kind: circle, radius: 3000, period: 300}]}\n"
ERRORS = "gyro: {bias: [0.02, -0.01, 0.03]}\naccelerometer: {bias: [50, 30, -40]}\n"


class Studies(Folder):
    def write(self, name, text):
        pathlib.Path(self.path(name)).write_text(text, encoding="utf-8")
        return self.path(name)

    def setUp(self):
        self.write("rest.yaml", REST)
        self.write("circle.yaml", CIRCLE)
        self.write("errors.yaml", ERRORS)

    def rows(self, name):
        with open(self.path(name), encoding="utf-8", newline="") as f:
            return list(csv.DictReader(f))

    def test_self_alignment(self):
        study = self.write("self.yaml", "scenario: rest.yaml\nerrors: errors.yaml\nseeds: 3\nself: {method: average, window: 100}\n")
        told = run_json("alignment", study, "--format", "json", "-o", self.path("a.nc"), "--plot", self.path("a.svg"))
        # -dw_E / (u cos lat) + df_E tan(lat) / g with 0.02 deg/h and 50 ug: -388 arcsec and 10 arcsec
        self.assertAlmostEqual(told["heading"]["closed_form_rms_arcsec"], 378, delta=2)
        self.assertLess(told["heading"]["difference_rms_arcsec"], 1)
        self.assertAlmostEqual(told["pitch"]["rms_arcsec"], 6.2, delta=0.1)
        head = subprocess.run(["ncdump", "-h", self.path("a.nc")], capture_output=True, text=True, check=True).stdout
        for word in ("heading_error_arcsec", "input_sha256", "errors.yaml", "rest.yaml"):
            self.assertIn(word, head)
        self.assertTrue(xml.etree.ElementTree.parse(self.path("a.svg")).getroot().tag.endswith("svg"))
        first = run("alignment", study, "-o", "-").stdout
        self.assertEqual(first, run("alignment", study, "-o", "-").stdout)
        self.assertEqual(len(first.splitlines()), 4)

    def test_transfer_alignment(self):
        weave = ("trajectory: {kind: analytic, duration: 60, lat: 45, lon: 20, body: {follow_course: yes}, motions: [{kind: straight, east: 80}%s]}\n"
                 "units: [{name: reserve, right: 1, heading: 20}]\nimu: {rate: 10}\n")
        self.write("weave.yaml", weave % ", {kind: sine, north: 150, period: 30}")
        self.write("straight.yaml", weave % "")
        self.write("reserve.yaml", "gyro: {bias_sigma: 1, white: 0.1}\naccelerometer: {bias_sigma: 500, white: 50}\n")
        text = "kind: transfer\nscenario: {}.yaml\nerrors: reserve.yaml\nseeds: 4\ntransfer: {{first_errors: errors.yaml, interval: 1}}\n"
        told = {name: run_json("alignment", self.write(f"{name}-study.yaml", text.format(name)), "--format", "json", "-o", self.path(f"{name}.nc"))
                for name in ("weave", "straight")}
        self.assertTrue(told["weave"]["heading_observed"])
        self.assertLess(told["weave"]["heading_sigma_left"], 0.1)
        self.assertFalse(told["straight"]["heading_observed"])
        self.assertIn("NOT OBSERVED", run("alignment", self.path("straight-study.yaml")).stdout)
        head = subprocess.run(["ncdump", "-h", self.path("weave.nc")], capture_output=True, text=True, check=True).stdout
        for word in ("second_measured_dtheta_rad_x(second)", "first_heading_deg(first)", "track_attitude_sigma_arcmin_up"):
            self.assertIn(word, head)
        for change, sentence in (("interval: 1", "interval: 0.3"), "a multiple of 5"), (("interval: 1", "unit: 2"), "there is no unit 2"), \
                (("interval: 1", "velocity_noise: -1"), "velocity_noise"), (("interval: 1", "mounting: [1, 2]"), "three are wanted"), \
                (("interval: 1", "mounting: [1, 2, -1]"), "cannot be negative"), (("kind: transfer", "kind: self"), "transfer"):
            bad = self.write("bad.yaml", text.format("weave").replace(*change))
            self.assertIn(sentence, run("alignment", bad, status=1).stderr)

    def test_aiding(self):
        text = ("scenario: circle.yaml\nrate: 5\nbarometer: {white: 0.5}\nmagnetometer: {hard_iron: [100, 0, 0]}\nodometer: {scale: 1000}\n"
                "antennas: {baseline: [0, 2, 0], across: 0.01}\nreceiver: {range: 1, rate: 0.05}\n")
        study = self.write("aiding.yaml", text)
        told = run_json("aiding", study, "--format", "json", "-o", self.path("aiding.csv"), "--plot", self.path("aiding.svg"))
        self.assertAlmostEqual(told["barometric height"]["rms"], 0.5, delta=0.05)
        self.assertAlmostEqual(told["field, right"]["rms"], 100, delta=1e-6)
        self.assertAlmostEqual(told["odometer"]["rms"], 0.04443, delta=1e-4)  # 2 pi 3000 m in 300 s, of which North is the part of root 2
        self.assertAlmostEqual(told["two-antenna heading"]["rms"], 0.2865, delta=0.02)
        rows = [{k: float(v) for k, v in row.items()} for row in self.rows("aiding.csv")]
        self.assertEqual(len(rows), 1501)
        normalised = sum(r["gnss_error_up_m"] ** 2 / r["gnss_cov_m2_uu"] for r in rows) / len(rows)
        self.assertAlmostEqual(normalised, 1, delta=0.12)  # three of sqrt(2 / 1501)
        alone = run("aiding", self.write("baro.yaml", "scenario: rest.yaml\nbarometer: {bias: 2}\n"), "-o", "-").stdout.splitlines()
        self.assertEqual(alone[0], "t_s,baro_height_m,true_height_m,baro_pressure_hpa")
        self.assertTrue(alone[1].startswith("0,2,"))
        for change, sentence in (("{white: 0.5}", "{white: -0.5}"), "white"), (("{white: 0.5}", "{sigma: 1, time: 0}"), "time"), \
                (("[0, 2, 0]", "[0, 0, 2]"), "tell no heading"), (("[0, 2, 0]", "[2, 0]"), "three are wanted"), \
                (("hard_iron: [100, 0, 0]", "model: nowhere2020"), "nowhere2020"), (("rate: 5\n", "unit: 3\n"), "there is no unit 3"), \
                (("{range: 1,", "{orbit: rest.yaml, range: 1,"), "rest.yaml"):
            self.assertIn(sentence, run("aiding", self.write("bad.yaml", text.replace(*change)), status=1).stderr)
        self.assertIn("none of barometer", run("aiding", self.write("bad.yaml", "scenario: rest.yaml\n"), status=1).stderr)

    def test_error_equations(self):
        text = ("manoeuvres: [{name: rest, scenario: rest.yaml}, {scenario: circle.yaml, duration: 200}]\nerrors: errors.yaml\n"
                "initial: {attitude: [10, 10, 60]}\nsizes: [1, 2000]\nsteps: [2, 20]\nmethods: [euler, runge-kutta]\n{}\n")
        study = self.write("e.yaml", text.replace("{}", ""))
        told = run_json("error-equations", study, "--format", "json", "-o", self.path("map.csv"), "--csv", self.path("series.csv"),
                        "--plot", self.path("map.svg"))
        periods = told["periods"]
        self.assertAlmostEqual(periods["schuler_s"] / 60, 84.4, delta=0.1)
        self.assertAlmostEqual(periods["foucault_s"] / 3600, 33.84, delta=0.05)  # 23.93 h / sin 45
        self.assertAlmostEqual(periods["earth_s"] / 3600, 23.934, delta=0.002)
        for row in told["map"]:
            small = row["size"] == 1
            length = 400 if row["manoeuvre"] == "rest" else 200
            if small and row["method"] == "runge-kutta":  # far below the second order: the whole time
                self.assertEqual(row["position_holds_s"], length, row)
                self.assertLess(row["position_deviation"], 2e-3, row)
            if not small and row["model"] != "dynamic":  # 33 degrees of heading are no small angle
                self.assertLess(row["velocity_holds_s"], length, row)
        self.assertEqual(len(self.rows("map.csv")), 2 * 3 * 2 * 2 * 2)
        last = {k: float(v) for k, v in self.rows("series.csv")[-1].items()}
        for axis in ("east", "north", "up"):
            full = last[f"dynamic_position_m_{axis}"] + last[f"kinematic_position_m_{axis}"]
            self.assertAlmostEqual(full, last[f"position_m_{axis}"], delta=1e-9 + 1e-6 * abs(full))
        self.assertGreater(abs(last["kinematic_position_m_north"]), 100)
        mistaken = run_json("error-equations", self.write("m.yaml", text.replace("{}", "quantities: geographic")), "--format", "json")
        for own, row in zip(told["map"], mistaken["map"]):
            if own["size"] == 1 and own["method"] == "runge-kutta":
                if own["model"] == "phi":
                    self.assertEqual(own, row)
                else:
                    self.assertGreater(row["position_deviation" if own["model"] == "dynamic" else "attitude_deviation"], 0.01)

    def test_what_is_refused(self):
        rest = "scenario: rest.yaml\nerrors: errors.yaml\nself: {window: 100}\n"
        flights = "manoeuvres: {scenario: rest.yaml}\nerrors: errors.yaml\n"
        for command, text, sentence in (
                ("alignment", "errors: errors.yaml\n", "scenario"),
                ("alignment", "scenario: rest.yaml\nerrors: errors.yaml\nself: {method: guess}\n", "inertial, average"),
                ("alignment", rest + "seed: 1\nseeds: 0\n", "seeds"),
                ("alignment", rest + "orbit: x\n", "unknown key"),
                ("error-equations", flights + "steps: 0.25\n", "no whole number of readings"),
                ("error-equations", flights + "steps: 3\n", "divides the 20 s"),
                ("error-equations", flights + "compare: 2h\n", "more than the flight"),
                ("error-equations", flights + "initial: {attitude: [1, 2]}\n", "three are wanted"),
                ("error-equations", flights + "methods: heun\n", "euler, midpoint, runge-kutta"),
                ("error-equations", flights + "sizes: -1\n", "sizes")):
            with self.subTest(text=text):
                self.assertIn(sentence, run(command, self.write("bad.yaml", text), status=1).stderr)
        for key, errors, sentence in (("gyro", "temperature: {times: [0, 60], values: [20, 30]}\n", "covers 0 to 60 s"),
                                      ("gyro", "temperature: {times: [0, 9, 5], values: [1, 2, 3]}\n", "have to ascend"),
                                      ("gyro", "temperature: {times: [0, 9], values: [1]}\n", "2 times and 1 values"),
                                      ("gyro", "gyro: {white: [1, -1, 1]}\n", "cannot be negative"),
                                      ("accelerometer", "accelerometer: {arms: [1, 2, 3]}\n", "nine are wanted"),
                                      ("gyro", "gyro: {damping: 1}\n", "bandwidth"),
                                      ("gyro", "delay: 10000000\n", "delay")):
            with self.subTest(errors=errors):
                self.write("errors.yaml", errors)
                self.assertIn(sentence, run("alignment", self.write("bad.yaml", rest), status=1).stderr)
        run("alignment", status=2)
        self.assertIn("scenario: file, required", run("alignment", "--help-study").stdout)

    def test_samples_are_studies(self):
        for path in sorted(pathlib.Path(sample("studies")).glob("*.yaml")):
            self.assertIn("title:", path.read_text(encoding="utf-8"), path)


if __name__ == "__main__":
    unittest.main()
