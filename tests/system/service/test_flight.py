#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""One service for a whole flight: satellites, true motion and inertial readings by time, on one clock. What the wire says has
to agree with itself: turning and accelerating as the readings say leads from one truth to the next."""
import csv
import json
import math
import unittest

from daemon import ROOT, WORK, Daemon, orrery as program, product  # first: it sets the path

import orrery
from orrery import messages

NS = 10**9
RATE_HZ = 100
EARTH_RATE = 7.292115e-5

SCENARIO = """
orbit: {product: day.nc}
trajectory:
  kind: survey
  start: 2025-03-21T10:00:00
  duration: 600
  lat: 56
  lon: 40
  height: 1500
  survey: {azimuth: 20, length: 10000, spacing: 2000, lines: 2}
  speed: 65
  turbulence: {rms: 0.5, low: 0.02, high: 0.25}
units:
  - {name: second, right: 0.5, forward: -2, up: 1.2}
imu: {rate: 100}
"""


def difference(a, b):
    return math.dist(a, b)


class Flight(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        product()
        (WORK / "flight.yaml").write_text(SCENARIO, encoding="utf-8")
        cls.daemon = Daemon(WORK / "flight.yaml")
        cls.client = orrery.Client(cls.daemon.urls[0])
        cls.start = next(cls.client.poll_truth("2025-03-21T10:00:00")).t

    @classmethod
    def tearDownClass(cls):
        cls.client.close()
        status = cls.daemon.stop()
        if status != 0:
            raise AssertionError(f"the service ended with {status}: {''.join(cls.daemon.lines)}")

    def test_satellites_and_motion_share_a_clock(self):
        t = self.start + 100 * NS
        states, truth = self.client.states(t), next(self.client.poll_truth(t))
        self.assertEqual((states.t, truth.t), (t, t))
        self.assertEqual(truth.answer, 0)
        self.assertAlmostEqual(math.hypot(*truth.pos_m), 6.3653e6, delta=2e4)  # 1500 m above latitude 56
        self.assertAlmostEqual(math.hypot(*truth.vel_mps), 65, delta=5)
        self.assertAlmostEqual(math.hypot(*truth.attitude), 1, delta=1e-12)

    def test_velocity_and_acceleration_are_derivatives(self):
        step = 0.01
        a, b, c = self.client.poll_truth(self.start + 200 * NS, step, 3)
        for k in range(3):
            self.assertAlmostEqual((c.pos_m[k] - a.pos_m[k]) / (2 * step), b.vel_mps[k], delta=1e-4)  # jerk h^2/6, rounding 1e-7
            self.assertAlmostEqual((c.vel_mps[k] - a.vel_mps[k]) / (2 * step), b.acc_mps2[k], delta=1e-4)

    def test_increments_add_up(self):
        """Ten intervals one by one are as much as one tenfold interval, to second order of the turn within it."""
        t = self.start + 300 * NS
        small = list(self.client.poll_imu(t, 0, 10))
        self.assertEqual([s.t1 for s in small[:-1]], [s.t0 for s in small[1:]])
        self.assertEqual(small[-1].t1 - small[0].t0, 10 * NS // RATE_HZ)
        large = next(self.client.poll_imu(t, 0.1, 1))
        for k in range(3):
            self.assertAlmostEqual(sum(s.dtheta_rad[k] for s in small), large.dtheta_rad[k], delta=1e-12)
            self.assertAlmostEqual(sum(s.dv_mps[k] for s in small), large.dv_mps[k], delta=1e-10)

    def test_readings_are_the_means_of_rate_and_force(self):
        t = self.start + 250 * NS
        reading = next(self.client.poll_imu(t))
        truth = next(self.client.poll_truth((reading.t0 + reading.t1) // 2))
        for k in range(3):  # the mean over 10 ms is the value in the middle but for the second derivative
            self.assertAlmostEqual(reading.dtheta_rad[k] * RATE_HZ, truth.rate_radps[k], delta=1e-5)
            self.assertAlmostEqual(reading.dv_mps[k] * RATE_HZ, truth.force_mps2[k], delta=1e-3)
        self.assertAlmostEqual(truth.force_mps2[2], 9.81, delta=1.5)  # a bank of 20 deg adds 0.6, turbulence the rest

    def test_a_file_of_readings_says_the_same(self):
        """orrery imu of the same scenario: its rows are what the service answers, to the rounding of an instant after 20 s, 3.6e-15 s
        at each end of a step, times 10 m/s2."""
        for unit in (0, 1):
            done = program("imu", WORK / "flight.yaml", "-q", "--unit", unit, "-o", "-")
            self.assertEqual(done.returncode, 0, done.stderr)
            rows = list(csv.DictReader(done.stdout.splitlines()[1:]))
            for k in (1, 777, 2000):
                reading = next(self.client.poll_imu(self.start + (k - 1) * NS // RATE_HZ, unit=unit))
                self.assertEqual(reading.t1, self.start + k * NS // RATE_HZ)
                for i, axis in enumerate("xyz"):
                    self.assertAlmostEqual(float(rows[k][f"dtheta_{axis}_rad"]), reading.dtheta_rad[i], delta=1e-15)
                    self.assertAlmostEqual(float(rows[k][f"dv_{axis}_mps"]), reading.dv_mps[i], delta=7.2e-14)

    def test_the_second_unit_is_an_arm_away(self):
        t = self.start + 150 * NS
        first, second = next(self.client.poll_truth(t)), next(self.client.poll_truth(t, unit=1))
        self.assertAlmostEqual(difference(first.pos_m, second.pos_m), math.hypot(0.5, 2, 1.2), delta=1e-6)

    def test_the_same_question_gets_the_same_answer(self):
        t = self.start + 77 * NS
        self.assertEqual(next(self.client.poll_imu(t)).encode(), next(self.client.poll_imu(t)).encode())
        self.assertEqual(next(self.client.poll_truth(t)).encode(), next(self.client.poll_truth(t)).encode())

    def test_outside_the_flight_there_are_no_numbers(self):
        for message in (next(self.client.poll_truth(self.start - 10 * NS)), next(self.client.poll_imu(self.start - 10 * NS))):
            self.assertNotEqual(message.answer, 0)
            values = message.pos_m if isinstance(message, messages.Truth) else message.dv_mps
            self.assertTrue(all(math.isnan(v) for v in values))
        with self.assertRaises(orrery.Refused):
            next(self.client.poll_truth(self.start, unit=7))

    def test_the_program_asks_likewise(self):
        for option, key in (("--truth", "pos_m"), ("--imu", "dv_mps")):
            done = program("poll", self.daemon.urls[0], "--at", "2025-03-21T10:03:00", option, "--json")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(key, done.stdout)
            json.loads(done.stdout.splitlines()[0] if done.stdout.count("\n") > 1 and done.stdout[0] == "{" else done.stdout)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
