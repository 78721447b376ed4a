#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Channels over the wire: blocks join, agree with what the other messages say, and do not depend on who asked before."""
import math
import sys
import unittest

from daemon import Served, product  # first: it sets the path

import orrery
from orrery import messages

NS = 10**9
C = 299792458.0

SCENARIO = """
orbit: {product: day.nc}
navdata: {window: none}
ionosphere: {field: ionosphere.ION}
troposphere: {model: saastamoinen}
signals: [G, "R:L1OF", "E:E1"]
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
antennas:
  - {name: ROVE, up: 1}
  - {name: BASE, position: [56, 40, 150]}
satellites: {unhealthy: G03}
mask: {elevation: 0}
"""


def value(c, s):
    return c[0] + s * (c[1] + s * (c[2] + s * c[3]))


def rate(c, s):
    return c[1] + s * (2 * c[2] + s * 3 * c[3])


class Channels(Served):
    SCENARIO = SCENARIO

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.start = next(cls.client.poll_truth("2025-03-21T10:00:00")).t

    def test_caps_tell_antennas_signals_and_transmitters(self):
        caps = self.client.caps
        self.assertEqual([(a.antenna, a.name) for a in caps.antennas], [(0, "ROVE"), (1, "BASE")])
        self.assertTrue(math.isnan(caps.antennas[0].pos_m[0]) and math.hypot(*caps.antennas[1].pos_m) > 6.3e6)
        names = {(chr(s.system), s.name): s for s in caps.signals}
        self.assertIn(("G", "L1CA"), names)
        self.assertNotIn(("E", "E5a"), names)
        self.assertEqual(names["G", "L1CA"].carrier_hz, 1575.42e6)
        self.assertEqual(names["R", "L1OF"].channel_hz, 562500)
        self.assertEqual([str(t.sat) for t in caps.transmitters if t.unhealthy], ["G03"])

    def test_neighbouring_blocks_join(self):
        for antenna in (0, 1):
            block = self.client.channels(self.start + 60 * NS, antenna)
            for _ in range(20):
                after = self.client.channels(block.block + block.length, antenna)
                self.assertEqual(after.block, block.block + block.length)
                self.assertEqual(block.block % block.length, 0)
                self.assertLess(block.error_m, 1e-5)
                s, new = block.length / NS, {(str(c.sat), c.signal): c for c in after.channels}
                for c in block.channels:
                    d = new[str(c.sat), c.signal]
                    wave = C / c.carrier_hz
                    self.assertAlmostEqual(value(c.code, s), d.code[0], delta=4e-9)
                    self.assertAlmostEqual(rate(c.code, s), d.code[1], delta=1e-6)
                    carrier = c.carrier_cycles - d.carrier_cycles + value(c.carrier, s) - d.carrier[0]
                    self.assertAlmostEqual(carrier * wave, 0, delta=1e-9)
                    self.assertAlmostEqual((rate(c.carrier, s) - d.carrier[1]) * wave, 0, delta=1e-6)
                block = after

    def test_terms_sum_up_and_agree_with_the_other_messages(self):
        t = self.start + 100 * NS
        m = self.client.channels(t, 0, terms=1)
        self.assertEqual(len(m.terms), len(m.channels))
        delays = {str(d.sat): d for d in self.client.delays(m.block, receiver_m=m.pos_m).satellites}
        # Slow terms have a node at whole tens of seconds for every tenth satellite, a second later for the next ones, and so on.
        order = [str(s.sat) for s in self.client.states(m.block).satellites]
        nodes = set(order[0::10])
        self.assertTrue(nodes & set(delays))
        for c, x in zip(m.channels, m.terms):
            parts = [getattr(x, name) for name in (f.name for f in x.LAYOUT) if name not in ("wind_up_m", "phase_bias_m")]
            self.assertAlmostEqual(sum(parts), c.code[0], delta=8e-9)
            d = delays[str(c.sat)]
            self.assertAlmostEqual(x.ionosphere_m, 40.3e16 * d.stec_tecu / c.carrier_hz**2, delta=1e-9 if str(c.sat) in nodes else 1.5e-6)
            self.assertAlmostEqual(c.el_rad, d.el_rad, delta=1e-9)
            self.assertAlmostEqual(math.remainder(c.az_rad - d.az_rad, 2 * math.pi), 0, delta=1e-9)
            flight_s = (m.block - c.transmit) / NS - c.transmit_fraction_ns / 1e9
            self.assertAlmostEqual(flight_s * C, c.code[0], delta=1e-6)  # a double of seconds
            state = self.client.states(m.block - round(1e9 * (x.distance_m + x.sagnac_m) / C), [c.sat]).satellites[0]
            self.assertAlmostEqual(x.satellite_clock_m, -C * state.clock_s, delta=1e-7)
            self.assertEqual(bool(c.flags & messages.ChannelFlags.UNHEALTHY), str(c.sat) == "G03")

    def test_contents_between_nodes_are_those_of_delays(self):
        # Between nodes: a tenth of channel.error_m beside the moving antenna.
        for seconds in (101, 103, 107.3, 115.9):
            m = self.client.channels(self.start + round(seconds * NS), 0, terms=1)
            delays = {str(d.sat): d for d in self.client.delays(m.block, receiver_m=m.pos_m).satellites}
            for c, x in zip(m.channels, m.terms):
                self.assertAlmostEqual(x.ionosphere_m, 40.3e16 * delays[str(c.sat)].stec_tecu / c.carrier_hz**2, delta=1.5e-6)

    def test_the_same_question_gets_the_same_answer(self):
        t = self.start + 77 * NS
        first = self.client.channels(t, 0, terms=1).encode()
        for k in range(50):
            self.client.channels(self.start + (k + 3) * NS, k % 2)
        self.assertEqual(self.client.channels(t, 0, terms=1).encode(), first)
        with orrery.Client(self.daemon.urls[0]) as other:
            self.assertEqual(other.channels(t, 0, terms=1).encode(), first)

    def test_signals_can_be_chosen(self):
        l1 = next(s.signal for s in self.client.caps.signals if (chr(s.system), s.name) == ("G", "L1CA"))
        m = self.client.channels(self.start + 10 * NS, 1, signals=[l1])
        self.assertEqual({c.signal for c in m.channels}, {l1})

    def test_what_cannot_be_asked_is_refused(self):
        for kind in ({"antenna": 2}, {"terms": 2}, {"signals": [63]}):
            with self.assertRaises(orrery.Refused) as refused:
                self.client.channels(self.start, **kind)
            self.assertIn("POLL_CHANNELS", str(refused.exception))
        outside = self.client.channels(self.start - 100 * NS, 0)
        self.assertEqual((outside.answer, len(outside.channels)), (messages.Answer.OUTSIDE_SPAN, 0))
        self.assertTrue(math.isnan(outside.error_m))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
