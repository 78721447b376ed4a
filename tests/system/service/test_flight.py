#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""One service for a whole flight: satellites, true motion and inertial readings by time, on one clock. What the wire says has
to agree with itself: turning and accelerating as the readings say leads from one truth to the next."""
import csv
import json
import math
import os
import subprocess
import sys
import unittest

from daemon import ROOT, WORK, Daemon, Served, orrery as program, product  # first: it sets the path

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
ionosphere: {field: ionosphere.ION}
"""


def difference(a, b):
    return math.dist(a, b)


class Flight(Served):
    SCENARIO = SCENARIO

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.start = next(cls.client.poll_truth("2025-03-21T10:00:00")).t

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
        self.assertEqual([s.t1 for s in small[:-1]], [s.t for s in small[1:]])
        self.assertEqual(small[-1].t1 - small[0].t, 10 * NS // RATE_HZ)
        large = next(self.client.poll_imu(t, 0.1, 1))
        for k in range(3):
            self.assertAlmostEqual(sum(s.dtheta_rad[k] for s in small), large.dtheta_rad[k], delta=1e-12)
            self.assertAlmostEqual(sum(s.dv_mps[k] for s in small), large.dv_mps[k], delta=1e-10)

    def test_readings_are_the_means_of_rate_and_force(self):
        t = self.start + 250 * NS
        reading = next(self.client.poll_imu(t))
        truth = next(self.client.poll_truth((reading.t + reading.t1) // 2))
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
            rows = list(csv.DictReader(done.stdout.splitlines()))
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

    def test_caps_tells_what_flies(self):
        caps = self.client.caps
        spans = {r.request: (r.span.first, r.span.last) for r in caps.requests}
        self.assertEqual(spans[messages.PollTruth.TYPE][0], self.start)
        for poll in (messages.PollTruth.TYPE, messages.PollImu.TYPE, messages.PollDelays.TYPE):
            first, last = spans[poll]
            self.assertTrue(self.client.span[0] <= first < last <= self.client.span[1], poll)
        first, last = spans[messages.PollTruth.TYPE]
        self.assertEqual([next(self.client.poll_truth(t)).answer for t in (first - 2 * NS, first, last, last + 2 * NS)], [1, 0, 0, 1])
        first, last = spans[messages.PollDelays.TYPE]
        self.assertEqual([self.client.delays(t).answer for t in (first - 2 * NS, first, last, last + 2 * NS)], [1, 0, 0, 1])
        self.assertEqual((caps.receiver_source, caps.receiver_unit), (messages.ReceiverSource.TRAJECTORY, 0))
        self.assertTrue(all(map(math.isnan, caps.receiver_m)))
        self.assertEqual(caps.imu_rate_hz, RATE_HZ)
        self.assertEqual([(u.unit, u.name, u.lever_m) for u in caps.units], [(0, "", [0, 0, 0]), (1, "second", [0.5, -2, 1.2])])

    def test_sensors_with_errors(self):
        """imu.errors: the service answers what the file of readings has as measured, over whole steps and over parts of them; `served: ideal`
        leaves it as it was."""
        (WORK / "sensors.yaml").write_text("gyro: {bias: 10, white: 0.1}\naccelerometer: {bias_sigma: 1000, white: 50}\n", encoding="utf-8")
        measured = SCENARIO.replace("{rate: 100}", "{rate: 100, errors: sensors.yaml}")
        (WORK / "measured.yaml").write_text(measured, encoding="utf-8")
        (WORK / "ideal.yaml").write_text(measured.replace("sensors.yaml}", "sensors.yaml, served: ideal}"), encoding="utf-8")
        for unit in (0, 1):
            rows = list(csv.DictReader(program("imu", WORK / "measured.yaml", "--unit", str(unit), "--duration", "60", "-o", "-").stdout.splitlines()))
            with Daemon(WORK / "measured.yaml") as d, orrery.Client(d.urls[0]) as c:
                got = list(c.poll_imu(self.start + 10 * NS, 0.01, 50, unit=unit))
                half = [list(c.poll_imu(self.start + 10 * NS, 0.005, 2, unit=unit)), list(c.poll_imu(self.start + 10 * NS, 0.5, 1, unit=unit))[0]]
            for k, m in enumerate(got):
                self.assertEqual(m.readings, messages.Readings.MEASURED)
                for i, axis in enumerate("xyz"):
                    self.assertAlmostEqual(m.dtheta_rad[i], float(rows[1001 + k][f"measured_dtheta_{axis}_rad"]), delta=2e-11)
                    self.assertAlmostEqual(m.dv_mps[i], float(rows[1001 + k][f"measured_dv_{axis}_mps"]), delta=2e-9)
            self.assertGreater(abs(got[0].dv_mps[0] - float(rows[1001]["dv_x_mps"])), 1e-6)
            for i in range(3):
                self.assertAlmostEqual(sum(h.dv_mps[i] for h in half[0]), got[0].dv_mps[i], delta=1e-13)
                # Two nodes a piece of 0.01 s, or of 0.5 s between knots: the quadrature is another, the errors are the same.
                self.assertAlmostEqual(sum(m.dv_mps[i] for m in got), half[1].dv_mps[i], delta=2e-9)
        with Daemon(WORK / "ideal.yaml") as d, orrery.Client(d.urls[0]) as c:
            ideal = next(c.poll_imu(self.start + NS))
            self.assertEqual(ideal.encode(), next(self.client.poll_imu(self.start + NS)).encode())
            self.assertEqual(ideal.readings, messages.Readings.IDEAL)
        (WORK / "bad.yaml").write_text(measured.replace("sensors.yaml", "nowhere.yaml"), encoding="utf-8")
        self.assertIn("nowhere.yaml", program("serve", WORK / "bad.yaml", "--listen", "tcp://127.0.0.1:0").stderr)

    def test_outside_the_flight_there_are_no_numbers(self):
        for message in (next(self.client.poll_truth(self.start - 10 * NS)), next(self.client.poll_imu(self.start - 10 * NS))):
            self.assertNotEqual(message.answer, 0)
            values = message.pos_m if isinstance(message, messages.Truth) else message.dv_mps
            self.assertTrue(all(math.isnan(v) for v in values))
        with self.assertRaises(orrery.Refused):
            next(self.client.poll_truth(self.start, unit=7))

    def delays_are_those_of_the_truth(self, client, unit):
        """Delays of a question without a receiver are those of one that sends the true position, bit for bit."""
        t, carriers, step, seen, places = self.start + 20 * NS, (1575.42e6, 1176.45e6), 60, 0, set()
        own = list(client.poll_delays(t, step, 8, None, carriers))
        truth = list(client.poll_truth(t, step, 8, unit=unit))
        for k in range(8):
            self.assertEqual(own[k].receiver_m, truth[k].pos_m)
            places.add(tuple(own[k].receiver_m))
            asked = client.delays(t + k * step * NS, truth[k].pos_m, carriers)
            self.assertEqual(own[k].encode()[16:], asked.encode()[16:])  # but for index and count, which stand before
            seen += sum(s.answer == 0 for s in own[k].satellites)
            # In any order, alone or among others: the same question gets the same answer.
            self.assertEqual(client.delays(t + k * step * NS, None, carriers).encode(), asked.encode())
        self.assertEqual(len(places), 8)
        self.assertGreater(seen, 8)
        return own

    def test_delays_are_to_where_the_flight_is(self):
        own = self.delays_are_those_of_the_truth(self.client, 0)
        # It is the ray to the aircraft: the elevation is that of the satellite from the true position.
        states = self.client.states(own[3].t)
        up = next(self.client.poll_truth(own[3].t)).pos_m
        for s, d in zip(states.satellites, own[3].satellites):
            if d.answer != 0:
                continue
            ray = [a - b for a, b in zip(s.pos_m, up)]
            el = math.asin(sum(a * b for a, b in zip(ray, up)) / math.hypot(*ray) / math.hypot(*up))
            self.assertAlmostEqual(d.el_rad, el, delta=math.radians(0.2))  # the geocentric vertical is off by at most that

    def test_the_antenna_may_be_at_a_unit(self):
        (WORK / "antenna.yaml").write_text(SCENARIO + "receiver: {unit: 1}\n", encoding="utf-8")
        with Daemon(WORK / "antenna.yaml") as d, orrery.Client(d.urls[0]) as c:
            self.delays_are_those_of_the_truth(c, 1)

    def test_a_place_that_is_written_down_stays(self):
        (WORK / "place.yaml").write_text(SCENARIO + "receiver: {position: [52, 17, 100]}\n", encoding="utf-8")
        with Daemon(WORK / "place.yaml") as d, orrery.Client(d.urls[0]) as c:
            a, b = c.delays(self.start), c.delays(self.start + 300 * NS)
            self.assertEqual(a.receiver_m, b.receiver_m)
            self.assertEqual(c.delays(self.start - 3600 * NS).answer, messages.Answer.OK)  # the place is there before the flight
            self.assertGreater(difference(a.receiver_m, next(c.poll_truth(self.start)).pos_m), 1e6)

    def test_delays_outside_the_flight(self):
        inside, outside = self.start + 300 * NS, self.start - 3600 * NS
        truth = next(self.client.poll_truth(inside))
        self.assertEqual(self.client.delays(outside, truth.pos_m).answer, messages.Answer.OK)  # orbits and ionosphere are there
        answers = list(self.client.poll_delays(self.start - 10 * NS, step_s=10, count=3))
        self.assertEqual([d.answer for d in answers], [messages.Answer.OUTSIDE_SPAN, messages.Answer.OK, messages.Answer.OK])
        self.assertTrue(all(math.isnan(x) for x in answers[0].receiver_m) and not answers[0].satellites)
        done = program("poll", self.daemon.urls[0], "--delays", "--at", "2025-03-21T09:00:00")
        self.assertEqual(done.returncode, 1)
        self.assertIn("receiver", done.stderr)

    def test_a_flight_through_the_ionosphere(self):
        """Straight up at 3 km/s: through the shell, above which nothing is left of what is upward."""
        (WORK / "rocket.yaml").write_text(
            "orbit: {product: day.nc}\nionosphere: {field: ionosphere.ION}\n"
            "trajectory: {kind: analytic, start: 2025-03-21T10:00:00, duration: 600, lat: 56, lon: 40, height: 1000,"
            " motions: [{kind: straight, up: 3000}]}\n", encoding="utf-8")
        with Daemon(WORK / "rocket.yaml") as d, orrery.Client(d.urls[0]) as c:
            got = list(c.poll_delays(self.start, step_s=30, count=10))
            self.assertTrue(len(got) == 10 and all(a.answer == messages.Answer.OK for a in got))
            below, above = 0, 0
            for answer in got:
                up = [s for s in answer.satellites if s.answer == messages.Answer.OK and s.el_rad > 0.1]
                self.assertTrue(up)
                if math.hypot(*answer.receiver_m) < 6371e3 + 440e3:
                    below += all(s.stec_tecu > 0 for s in up)
                elif math.hypot(*answer.receiver_m) > 6371e3 + 460e3:
                    above += all(s.stec_tecu == 0 for s in up)
            self.assertTrue(below + above >= 9 and above > 3, (below, above))

    def test_the_other_client_hears_the_same_delays(self):
        t = orrery.from_text("2025-03-21T10:03:00")
        truth = next(self.client.poll_truth(t))
        want = self.client.delays(t, truth.pos_m)
        done = program("poll", self.daemon.urls[0], "--at", "2025-03-21T10:03:00", "--delays", "--format", "json")
        self.assertEqual(done.returncode, 0, done.stderr)
        got = json.loads(done.stdout)
        self.assertEqual(got["receiver_m"], list(truth.pos_m))
        self.assertEqual(len(got["satellites"]), len(want.satellites))
        for g, w in zip(got["satellites"], want.satellites):
            self.assertEqual(g["answer"], messages.Answer(w.answer).name)
            if w.answer == 0:
                self.assertEqual((g["stec_tecu"], g["mapping"], g["delay_m"][0]), (w.stec_tecu, w.mapping, w.delay_m[0]))
        module = subprocess.run([sys.executable, "-B", "-m", "orrery.poll", self.daemon.urls[0], "--at", "2025-03-21T10:03:00", "--delays"],
                                capture_output=True, text=True, env={**os.environ, "PYTHONPATH": str(ROOT / "proto/python")}, check=False)
        self.assertEqual(module.returncode, 0, module.stderr)
        self.assertIn("receiver at " + " ".join(f"{x:.4f}" for x in truth.pos_m), module.stdout)

    def test_the_program_asks_likewise(self):
        for option, key in (("--truth", "pos_m"), ("--imu", "dv_mps")):
            done = program("poll", self.daemon.urls[0], "--at", "2025-03-21T10:03:00", option, "--format", "json")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(key, done.stdout)
            json.loads(done.stdout.splitlines()[0] if done.stdout.count("\n") > 1 and done.stdout[0] == "{" else done.stdout)


class Alone(unittest.TestCase):
    """Inertial units without satellites."""

    def test_a_trajectory_alone_is_served(self):
        alone = "".join(line + "\n" for line in SCENARIO.splitlines() if not line.startswith(("orbit", "ionosphere")))
        (WORK / "alone.yaml").write_text(alone, encoding="utf-8")
        with Daemon(WORK / "alone.yaml") as d, orrery.Client(d.urls[0]) as c:
            start = c.span[0]
            self.assertEqual(c.span[1] - start, 600 * NS)
            truth, reading = next(c.poll_truth(start + 100 * NS)), next(c.poll_imu(start + 100 * NS))
            self.assertEqual((truth.answer, reading.answer), (0, 0))
            self.assertAlmostEqual(truth.force_mps2[2], reading.dv_mps[2] * RATE_HZ, delta=0.1)
            done = program("imu", WORK / "alone.yaml", "-q", "-o", "-")
            self.assertEqual(done.returncode, 0, done.stderr)
            try:
                states = c.states(start + 100 * NS)
            except orrery.Refused as refusal:
                self.assertEqual(refusal.code, messages.ErrorCode.NOT_SERVED)
            else:
                self.assertEqual((states.answer, len(list(states.satellites))), (messages.Answer.NOT_SERVED, 0))
            with self.assertRaises(orrery.Refused) as refusal:
                next(c.poll_delays(start, receiver_m=truth.pos_m))
            self.assertEqual(refusal.exception.code, messages.ErrorCode.NOT_SERVED)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
