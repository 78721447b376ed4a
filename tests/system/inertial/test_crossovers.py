# SPDX-License-Identifier: GPL-3.0-or-later
"""`orrery crossovers` and the filters of `orrery gravimetry`: a small draped survey, ideal and with errors."""
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import Folder, dump, run, run_json, sample  # noqa: E402

FLIGHT = """
trajectory:
  kind: survey
  lat: 56
  lon: 40
  height: 1500
  survey: {azimuth: 0, length: 3000, spacing: 1500, lines: 2, tie_lines: 2, tie_spacing: 1000}
  lead: 1000
  speed: 65
  bank: 35
  turbulence: {rms: 0.5, low: 0.02, high: 0.25}
  drape: [{amplitude: 64, wavelength: 880, azimuth: 10}, {amplitude: 20, wavelength: 3000}]
  knots: 0.2
gravity: {masses: [{lat: 56.01, lon: 40.01, height: -6000, gm: 4.0e4}]}
"""
SENSORS = """
accelerometer: {white: 8, bias_sigma: 10, temperature: {bias: 0.3}}
gyro: {white: 0.0015, bias_sigma: 0.002}
temperature: {times: [0, 3000], values: [20, 25], reference: 20, lag: 300}
"""
STUDY = """
scenario: flight.yaml
errors: sensors.yaml
filter: {kind: gaussian, length: 5}
lines: {least: 20, margin: 10}
receiver: {white: 0.001, wander: 0.001}
seeds: 1
"""


class Crossovers(Folder):
    def write(self, name, text):
        pathlib.Path(self.path(name)).write_text(text)
        return self.path(name)

    def test_survey(self):
        self.write("flight.yaml", FLIGHT)
        self.write("sensors.yaml", SENSORS)
        told = run_json("crossovers", self.write("study.yaml", STUDY), "--format", "json", "-o", self.path("c.nc"), "--plot", self.path("c.svg"))
        self.assertLess(told["ideal_max_mgal"], 1e-4)
        self.assertGreater(told["greatest_g"], 2.3)
        self.assertEqual(told["crossovers"], 4)
        # Short filters leave the noise of the accelerometers, 8 ug/sqrt(Hz) through 5 s, and of the receiver's places.
        self.assertTrue(0.5 < told["rms_mgal"] < 60)
        self.assertEqual(len(dump(self.path("c.nc"))["crossover_difference_mgal"]), 4)

    def test_filters_and_measured(self):
        run("imu", self.write("short.yaml", FLIGHT), "-o", self.path("imu.nc"), "--errors", self.write("s.yaml", SENSORS))
        for kind, length in (("gaussian", 10), ("fir", 60), ("kalman", 30)):
            told = run_json("gravimetry", self.path("imu.nc"), "--filter-kind", kind, "--filter", length, "--format", "json")["difference"]
            self.assertLess(told["filtered_max_mgal"], 1e-4)
            self.assertLess(told["edge_rms_mgal"], 1e-4)
        noisy = run_json("gravimetry", self.path("imu.nc"), "--of", "measured", "--filter-kind", "fir", "--filter", 60, "--format", "json")["difference"]
        self.assertTrue(0.1 < noisy["filtered_rms_mgal"] < 60)
        run("gravimetry", self.path("imu.nc"), "--model", 5, status=2)
        self.assertIn("needs a run of", run("gravimetry", self.path("imu.nc"), "--filter", 1000, status=1).stderr)
        run("imu", sample("still.yaml"), "--duration", "2s", "-o", self.path("still.nc"))
        self.assertIn("--errors", run("gravimetry", self.path("still.nc"), "--of", "measured", status=1).stderr)

    def test_refused(self):
        self.write("flight.yaml", FLIGHT)
        self.write("sensors.yaml", SENSORS)
        for old, new, words in (("length: 5", "length: 500", "needs a run of"), ("margin: 10", "margin: 100", "no stretch is straight"),
                                ("kind: gaussian", "kind: wavelet", "wavelet"), ("white: 0.001", "white: -1", "white")):
            self.assertIn(words, run("crossovers", self.write("bad.yaml", STUDY.replace(old, new)), status=1).stderr)
        self.write("sensors.yaml", SENSORS.replace("[0, 3000]", "[0, 30]"))
        self.assertIn("temperature", run("crossovers", self.write("bad.yaml", STUDY), status=1).stderr)


if __name__ == "__main__":
    unittest.main()
