#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Mode changes as events: those of the clock, of what paces it, of the lock to a generator and of live motion, polled and subscribed, in
both clients and as text; and what a client hears of samples of motion that are refused."""
import json
import re
import socket
import sys
import time
import unittest

from daemon import WORK, Served, orrery as run, scenario  # first: it sets the path

import orrery
from orrery import messages
from test_motion import Body
from test_streams import SCENARIO

NS = 10**9
M, K, S = messages.Mode, messages.ModeKind, messages.MotionState
T = "2025-03-21T10:02:00"


class Modes(Served):
    @classmethod
    def setUpClass(cls):
        cls.serve(scenario("modes.yaml", SCENARIO), "--from", T, "--start", "command", "--motion", "--join", "20", "--text", "tcp://127.0.0.1:0",
                  listen=("tcp://127.0.0.1:0", f"unix:{WORK}/modes.sock"))

    def setUp(self):
        self.client.control("stop")
        self.client.motion_stats(reset=True)

    def test_a_clock_and_a_generator(self):  # the first of them: numbers begin
        daemon, client = self.daemon, self.client
        begin = orrery.from_text(T)
        self.assertEqual((client.modes().last, client.modes().changes), (0, []))
        stream = client.subscribe(messages.GetModes(0), pacing="free")
        other = self.connect(daemon.urls[1])
        ring = other.subscribe(messages.GetModes(0), pacing="free", ring=True)
        client.control("arm")
        client.control("start", at=client.time().wall + NS // 5)
        while client.time().state != messages.ClockState.RUNNING:
            time.sleep(0.01)
        client.control("pause")
        client.radio_time(5 * NS)
        client.control("start", reference="radio")
        client.radio_time(5000 * NS)
        client.radio_time(5000 * NS + 1000)
        client.control("stop")
        got = client.modes()
        self.assertEqual([(c.kind, c.before, c.mode) for c in got.changes], [
            (K.CLOCK, M.STOPPED, M.ARMED), (K.CLOCK, M.ARMED, M.WAITING), (K.CLOCK, M.WAITING, M.RUNNING), (K.CLOCK, M.RUNNING, M.PAUSED),
            (K.GENERATOR, M.SILENT, M.LOCKED), (K.CLOCK, M.PAUSED, M.RUNNING), (K.REFERENCE, M.WALL, M.RADIO),
            (K.GENERATOR, M.LOCKED, M.STEPPING), (K.GENERATOR, M.STEPPING, M.LOCKED), (K.CLOCK, M.RUNNING, M.STOPPED)])
        self.assertEqual([c.number for c in got.changes], list(range(1, 11)))
        self.assertEqual((got.last, got.lost, got.more), (10, 0, 0))
        self.assertEqual(got.changes[2].at, begin)  # not when somebody looked
        walls = [c.wall for c in got.changes]
        self.assertEqual(walls, sorted(walls))
        self.assertEqual(client.modes(7).changes, got.changes[7:])
        for x in (stream, ring):
            heard = []
            while len(heard) < 10:
                heard += x.next().changes
            self.assertEqual(heard, got.changes)
        end = stream.unsubscribe()
        self.assertEqual(end.reason, messages.EndReason.UNSUBSCRIBED)
        # The text twin: JSON with the descriptors' names, SCPI.
        port = int(re.search(r"as text on tcp://127\.0\.0\.1:(\d+)", "".join(daemon.lines)).group(1))
        with socket.create_connection(("127.0.0.1", port), 10) as s, s.makefile("rw", encoding="utf-8", newline="\n") as f:
            f.write('{"request": "GET_MODES", "after": 8}\nMODE? 9\n')
            f.flush()
            told = json.loads(f.readline())
            self.assertEqual([(c["number"], c["kind"], c["before"], c["mode"]) for c in told["changes"]],
                             [(9, "GENERATOR", "STEPPING", "LOCKED"), (10, "CLOCK", "RUNNING", "STOPPED")])
            self.assertRegex(f.readline(), r"^1,.*CLOCK,RUNNING,STOPPED")
        shown = run("watch", "-n", "1", daemon.urls[0])
        self.assertEqual(shown.returncode, 0, shown.stderr)
        self.assertIn("10 changes of mode", shown.stdout)
        self.assertIn("generator: locked, before stepping", shown.stdout)

    def test_only_those_from_now_on(self):
        client = self.connect()
        client.control("arm")
        known = client.modes().last
        self.assertGreater(known, 0)
        stream = client.subscribe(messages.GetModes(2**64 - 1), pacing="clock", credit=1, window=0)
        client.control("start")
        self.assertEqual([c.mode for c in stream.next().changes if c.kind == K.CLOCK], [M.RUNNING])
        for action in ("pause", "start", "pause"):  # there is no credit: they are told together when there is
            client.control(action)
        stream.credit(1)
        self.assertEqual([c.mode for c in stream.next().changes if c.kind == K.CLOCK], [M.PAUSED, M.RUNNING, M.PAUSED])
        self.assertGreaterEqual(client.modes(known).last, known + 4)

    def test_motion(self):
        client = self.connect()
        client.control("start")
        body = Body(client.truth(client.time().t))
        stream = client.subscribe(messages.PollChannels(antenna=0), None, 0, lead_s=0.02, credit=1000)
        modes = client.subscribe(messages.GetModes(2**64 - 1), pacing="free")
        seen = []

        def take_until(motion):
            while True:
                block = stream.next()
                if not seen or seen[-1][1] != block.motion:
                    seen.append((block.block, block.motion))
                if block.motion == motion:
                    return
        for k in range(4):
            client.motion(body.sample(client.time().t))
            if k > 0:
                take_until(S.JOINING)
            take_until(S.EXTRAPOLATED)
        client.control("stop")
        # What the stream's blocks say of themselves is what the events say, with the instants of the blocks.
        want = seen if seen[0][1] != S.SCENARIO else seen[1:]
        heard = []
        while len(heard) < len(want):
            heard += [(c.at, c.mode - M.SCENARIO) for c in modes.next().changes if c.kind == K.MOTION]
        self.assertGreaterEqual(len(want), 7)
        self.assertEqual(heard[:len(want)], want)

    def test_refusals_of_motion_are_heard(self):
        client = self.connect()
        body = Body(client.truth(client.time().t))
        t = client.time().t + NS
        with self.assertRaisesRegex(orrery.Refused, "nothing is armed"):
            client.motion(body.sample(t), check=True)
        client.control("start")
        client.motion(body.sample(t), check=True)
        client.motion(body.sample(t - NS))
        client.time()
        self.assertEqual([(r.code, str(r)) for r in client.motion_refusals],
                         [(messages.ErrorCode.BAD_REQUEST, "MOTION: its tag is not later than that of the sample before")])
        for k in range(1, 300):  # of many the last are kept
            client.motion(body.sample(t - k * NS))
        client.time()
        self.assertEqual(len(client.motion_refusals), 256)
        self.assertEqual(client.motion_stats().dropped, 301)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
