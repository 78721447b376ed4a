#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The scenario's clock over the wire: control, a start at an instant of the wall, a generator that paces it, and who may not."""
import datetime
import sys
import time
import unittest

from daemon import Daemon, product  # first: it sets the path

import orrery
from orrery import messages

NS = 10**9
S = messages.ClockState


class Clock(unittest.TestCase):
    def serve(self, *args):
        daemon = Daemon(product(), *args)
        self.addCleanup(lambda: self.assertEqual(daemon.stop(), 0))
        client = orrery.Client(daemon.urls[0])
        self.addCleanup(client.close)
        return daemon, client

    def test_control(self):
        _, client = self.serve("--start", "command", "--from", "2025-03-21T10:00:00")
        begin = orrery.from_text("2025-03-21T10:00:00")
        m = client.time()
        self.assertEqual((m.state, m.t, m.leap.gps_utc_s), (S.STOPPED, begin, 18))
        self.assertEqual((m.week, m.tow), divmod(begin, 604800 * NS))
        self.assertLess(abs(m.wall - orrery.from_datetime(datetime.datetime.now(datetime.timezone.utc))), 5 * NS)
        stream = client.subscribe(messages.Poll(), None, 0.01, credit=100)
        m = client.control("start", at=client.time().wall + NS // 2)
        self.assertEqual(m.state, S.WAITING)
        self.assertLess(m.t, begin)
        self.assertEqual(stream.next().t, begin)
        self.assertGreaterEqual(client.time().t, begin)
        paused = client.control("pause")
        self.assertEqual(paused.state, S.PAUSED)
        time.sleep(0.05)
        self.assertEqual(client.time().t, paused.t)
        self.assertEqual(client.control("start", t=begin + 100 * NS).state, S.RUNNING)
        self.assertGreaterEqual(client.time().t, begin + 100 * NS)
        self.assertEqual(client.control("stop").t, begin)
        for action, kind in (("pause", {}), ("wait_pps", {}), ("arm", {"reference": "radio"}), ("start", {"at": begin})):
            with self.assertRaises(orrery.Refused) as refused:
                client.control(action, **kind)
            self.assertIn("CONTROL", str(refused.exception))
        client.ping(1)

    def test_a_generator_paces(self):
        """A generator twice as fast as this machine's clock: whoever followed the machine would be far off."""
        _, client = self.serve("--start", "command")
        begin = orrery.from_text("2025-03-21T12:00:00")
        zero = time.monotonic_ns() - NS // 2

        def elapsed(now):
            return 2 * (now - zero)

        def tell(n):
            for _ in range(n):
                now = time.monotonic_ns()
                pace = client.radio_time(elapsed(now), now, "monotonic")
                time.sleep(0.002)
            return pace
        tell(50)
        client.control("arm", reference="radio")
        client.control("wait_pps", t=begin)
        pps = -(-elapsed(time.monotonic_ns()) // NS) * NS
        client.control("start", delay_s=0.1)
        stream = client.subscribe(messages.Poll(), begin + NS // 10, 0.01, credit=10000, lead_s=0.02)
        pace = tell(600)
        self.assertAlmostEqual(pace.rate, 1.0, delta=0.01)
        m = client.time()
        self.assertEqual((m.state, m.reference, m.pps0), (S.RUNNING, messages.ClockReference.RADIO, begin))
        self.assertAlmostEqual((m.t - begin - (elapsed(m.host) - pps)) / 1e6, 0, delta=20)
        self.assertEqual(stream.next().t, begin + NS // 10)
        self.assertLess(pace.until_air, 20e6)
        self.assertGreater(pace.made, begin)
        with self.assertRaises(orrery.Refused) as refused:
            client.radio_time(-1)
        self.assertIn("RADIO_TIME", str(refused.exception))

    def test_who_may_only_read(self):
        _, client = self.serve("--read-only")
        self.assertEqual(client.time().state, S.RUNNING)
        for ask in (lambda: client.control("stop"), lambda: client.radio_time(5)):
            with self.assertRaises(orrery.Refused) as refused:
                ask()
            self.assertEqual(refused.exception.code, messages.ErrorCode.NOT_PERMITTED)
        self.assertEqual(client.time().state, S.RUNNING)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
