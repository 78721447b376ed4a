#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Live motion over the wire: antennas follow it, blocks join, every block says where its motion comes from, and every sample is
accounted for."""
import math
import re
import shutil
import socket
import struct
import sys
import time
import unittest

from daemon import ROOT, WORK, Daemon, orrery as run, product  # first: it sets the path

import orrery
from orrery import messages
from test_streams import SCENARIO

NS = 10**9
C = 299792458.0
STATE = messages.MotionState


def value(c, s):
    return c[0] + s * (c[1] + s * (c[2] + s * c[3]))


def rate(c, s):
    return c[1] + s * (2 * c[2] + s * 3 * c[3])


class Body:
    """A circle of 2 km about a place, once in 300 s, with its exact derivatives, standing level."""

    def __init__(self, truth):
        self.centre, self.t0 = truth.pos_m, truth.t
        self.w, self.r = 2 * math.pi / 300, 2000.0

    def at(self, t):
        s = (t - self.t0) / NS
        out = []
        for k in range(4):
            f = self.r * self.w**k
            x, y = f * math.cos(self.w * s + k * math.pi / 2), f * math.sin(self.w * s + k * math.pi / 2)
            out.append([x + (self.centre[0] if k == 0 else 0), y + (self.centre[1] if k == 0 else 0), self.centre[2] if k == 0 else 0.0])
        return out

    def sample(self, t, order=2, **more):
        p = self.at(t)
        kind = {"t": t, "order": order, "angular_order": 0, "pos_m": p[0], "vel_mps": p[1], "acc_mps2": p[2], "jerk_mps3": p[3]}
        kind.update(more)
        return messages.Motion(**kind)


class Live(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        product()
        shutil.copy(ROOT / "samples/ionosphere.ION", WORK)
        (WORK / "motion.yaml").write_text(SCENARIO, encoding="utf-8")

    def serve(self, *args):
        daemon = Daemon(WORK / "motion.yaml", "--from", "2025-03-21T10:02:00", "--start", "command", *args)
        self.addCleanup(lambda: self.assertEqual(daemon.stop(), 0, daemon.lines))
        self.url = daemon.urls[0]
        client = orrery.Client(self.url)
        self.addCleanup(client.close)
        return client

    def refused(self, client, sample, words):
        with self.assertRaises(orrery.Refused) as got:
            client._ask(sample, messages.Pong)
        self.assertIn(words, str(got.exception))

    def test_antennas_follow_and_blocks_join(self):
        client = self.serve("--motion")
        truth = client.truth(client.time().t)
        body = Body(truth)
        self.refused(client, body.sample(truth.t), "nothing is armed")
        client.control("start")
        stream = client.subscribe(messages.PollChannels(antenna=0, terms=1), None, 0, lead_s=0.02, credit=1000)
        fixed = client.subscribe(messages.PollChannels(antenna=1), None, 0, lead_s=0.02, credit=1000)
        self.assertEqual(fixed.next().motion, STATE.SCENARIO)
        while stream.next().motion == STATE.SCENARIO:
            client.motion(body.sample(client.time().t))
        blocks, seen = [], set()
        for k in range(300):
            if k % 2 == 0:
                client.motion(body.sample(client.time().t))
            block = stream.next()
            blocks.append(block)
            seen.add(block.motion)
            self.assertEqual(block.length, 5 * 10**6)
            # The antenna is a metre above a body that stands level: to the curvature of a degree of the Earth.
            off = math.dist(block.pos_m, body.at(block.block)[0])
            self.assertAlmostEqual(off, 1, delta=2e-3)
        self.assertLessEqual(seen, {STATE.SYNCHRONOUS, STATE.INTERPOLATED, STATE.EXTRAPOLATED, STATE.JOINING})
        for a, b in zip(blocks, blocks[1:]):
            self.assertEqual(b.block, a.block + a.length)
            new = {(str(c.sat), c.signal): c for c in b.channels}
            self.assertGreater(len(new), 3)
            for c in a.channels:
                d, s = new[str(c.sat), c.signal], a.length / NS
                self.assertAlmostEqual(value(c.code, s), d.code[0], delta=4e-9)
                self.assertAlmostEqual(rate(c.code, s), d.code[1], delta=1e-6)
                self.assertAlmostEqual(c.carrier_cycles - d.carrier_cycles + value(c.carrier, s) - d.carrier[0], 0, delta=1e-7)
        # What is in a block is what a polled antenna at that place has: the geometric distance to the satellite at emission.
        block = blocks[-1]
        for c, x in zip(block.channels, block.terms):
            flight = (x.distance_m + x.sagnac_m) / C
            sat = client.states(block.block - round(flight * NS), [c.sat]).satellites[0]
            turn = 7.2921151467e-5 * flight
            p = (sat.pos_m[0] * math.cos(turn) + sat.pos_m[1] * math.sin(turn),
                 sat.pos_m[1] * math.cos(turn) - sat.pos_m[0] * math.sin(turn), sat.pos_m[2])
            self.assertAlmostEqual(math.dist(p, block.pos_m), x.distance_m + x.sagnac_m, delta=1e-4)
        m = client.motion_stats()
        self.assertEqual(m.received - m.dropped, m.late + m.early)
        self.assertEqual(m.dropped, 1)
        self.assertGreaterEqual(m.blocks, 300)
        self.assertGreater(m.used, 10)
        self.assertLess(abs(m.lateness.p50), NS / 2)
        self.assertGreaterEqual(m.worst, STATE.EXTRAPOLATED)
        self.assertEqual(fixed.unsubscribe().reason, messages.EndReason.UNSUBSCRIBED)

    def test_what_cannot_be_is_told_and_counted(self):
        client = self.serve("--motion", "--join", "0")
        client.control("start")
        t = client.time().t
        body = Body(client.truth(t))
        good = body.sample(t)
        client.motion(good)
        self.refused(client, body.sample(t), "not later")
        self.refused(client, body.sample(t - NS), "not later")
        self.refused(client, body.sample(t + 180 * NS), "more than a minute ahead")
        self.refused(client, body.sample(t + NS // 100, pos_m=[math.nan, 0, 0]), "a number that is none")
        self.refused(client, body.sample(t + NS // 100, acc_mps2=[0, math.inf, 0]), "a number that is none")
        self.refused(client, body.sample(t + NS // 100, pos_m=[7e6, 0, 0]), "send snap")
        self.refused(client, body.sample(t + NS // 100, pos_m=[1.0, 0, 0]), "inside the Earth")
        self.refused(client, body.sample(t + NS // 100, order=4), "an order")
        self.refused(client, body.sample(t + NS // 100, angular_order=1, attitude=[2, 0, 0, 0]), "unit quaternion")
        client.motion(body.sample(t + NS // 100, order=3))
        m = client.motion_stats(reset=True)
        self.assertEqual((m.received, m.dropped), (11, 9))
        self.assertEqual(client.motion_stats().received, 0)
        client.ping(1)

    def test_servers_that_take_none(self):
        client = self.serve()
        self.refused(client, Body(client.truth(client.time().t)).sample(0), "--motion")
        with self.assertRaises(orrery.Refused):
            client.motion_stats()
        reader = self.serve("--motion", "--read-only")
        with self.assertRaises(orrery.Refused) as got:
            reader._ask(messages.Motion(), messages.Pong)
        self.assertEqual(got.exception.code, messages.ErrorCode.NOT_PERMITTED)

    def test_a_recording_gives_the_same_bytes(self):
        log = WORK / "motion.log"
        client = self.serve("--motion", "--motion-log", str(log))
        client.control("start")
        body = Body(client.truth(client.time().t))
        stream = client.subscribe(messages.PollChannels(antenna=0, terms=1), None, 0, lead_s=0.02, credit=10000)
        blocks, payloads = [], []
        for k in range(200):
            if k > 20 and k % 3 and k % 17:
                client.motion(body.sample(client.time().t - 10 * (k % 4) * 10**6))
            blocks.append(stream.next())
            payloads.append(stream.payload)
        self.assertIn(STATE.JOINING, {b.motion for b in blocks})
        stream.unsubscribe()
        self.doCleanups()
        again = self.serve("--motion-replay", str(log))
        stream = again.subscribe(messages.PollChannels(antenna=0, terms=1), blocks[0].t, 0, pacing="free", count=200)
        same = [stream.payload == p for p in payloads if stream.next() is not None]
        self.assertEqual(same, [True] * 200)

    def test_skydel_datagrams(self):
        """A laboratory's own client: hello, then positions with derivatives by its clock of milliseconds; it hears where the vehicle is."""
        daemon = Daemon(WORK / "motion.yaml", "--from", "2025-03-21T10:02:00", "--start", "command", "--motion", "--motion-udp", "0",
                        "--dialect", "skydel")
        self.addCleanup(lambda: self.assertEqual(daemon.stop(), 0))
        port = int(re.search(r"127\.0\.0\.1:(\d+) \(", next(x for x in daemon.lines if "by UDP" in x)).group(1))
        client = orrery.Client(daemon.urls[0])
        self.addCleanup(client.close)
        begin = client.time().t
        body = Body(client.truth(begin))
        client.control("start")
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
            sock.settimeout(20)
            sock.connect(("127.0.0.1", port))
            sock.send(b"\x01")
            stream = client.subscribe(messages.PollChannels(antenna=0), None, 0, lead_s=0.01, credit=1000)
            for _ in range(50):
                t = client.time().t
                p = body.at(t)
                sock.send(struct.pack("<BBd", 7, 2, (t - begin) / 1e6) + struct.pack("<12d", *p[0], *p[1], *p[2], *p[3]) + struct.pack("<I", 0))
                told = struct.unpack("<BQ9d", sock.recv(200))
                self.assertEqual((told[0], told[2:5]), (3, tuple(p[0])))
                block = stream.next()
            sock.send(b"\x63nonsense")
            while block.motion == STATE.SCENARIO:
                block = stream.next()
            self.assertAlmostEqual(math.dist(block.pos_m, body.at(block.block)[0]), 1, delta=2e-3)
        end = time.monotonic() + 10
        while client.motion_stats().dropped == 0 and time.monotonic() < end:
            time.sleep(0.01)
        m = client.motion_stats()
        self.assertEqual((m.received, m.dropped), (51, 1))

    def test_time_passes(self):
        """Samples stop: blocks go on, extrapolated, and say how old what they rest on is."""
        client = self.serve("--motion", "--motion-block", "10")
        client.control("start")
        body = Body(client.truth(client.time().t))
        client.motion(body.sample(client.time().t, order=3))
        stream = client.subscribe(messages.PollChannels(antenna=0), None, 0, lead_s=0.01, credit=100)
        time.sleep(0.3)
        ages = [stream.next() for _ in range(30)]
        self.assertEqual({b.motion for b in ages}, {STATE.EXTRAPOLATED})
        self.assertTrue(all(b.motion_age - a.motion_age == 10**7 for a, b in zip(ages, ages[1:])))
        m = client.motion_stats()
        self.assertEqual((m.worst, m.extrapolated), (STATE.EXTRAPOLATED, m.blocks))
        # A log of it cannot be compared with polls, which have no live motion: that is told, and is no success.
        log = str(WORK / "live.log")
        self.assertEqual(run("record", self.url, "-o", log, "--channels", "--count", "20", "--lead", "0.02").returncode, 0)
        checked = run("replay", log, "--check", self.url)
        self.assertEqual(checked.returncode, 1)
        self.assertIn("20 of live motion were not compared", checked.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
