#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Events over the wire against what the other messages say: rises and sets against channels, arcs against states, new ephemerides against
broadcast data, a leap second against the table; whole whatever intervals are asked for, streamed, and as text."""
import json
import re
import socket
import sys
import unittest

from daemon import WORK, Served, orrery as program, scenario  # first: it sets the path

import orrery
from orrery import messages
from orrery.messages import EventKind

NS = 10**9
T0 = "2025-03-21T00:00:00"

SCENARIO = """
orbit: {product: day.nc}
signals: [G, "R:L1OF", "E:E1"]
antennas:
  - {name: NORTH, position: [56, 40, 150]}
  - {name: SOUTH, position: [-33, 18, 150]}
mask: {elevation: 10}
faults: {range: [{sats: G, from: 2025-03-21T12:00:00, to: 2025-03-21T12:05:00, step: 10}]}
"""

# The table of the IERS with a leap second that never was, at the end of 2025-03-21.
LEAP = """#$\t3676924800
#@\t4000000000
3692217600\t37\t# 1 Jan 2017
3951590400\t38\t# 22 Mar 2025
"""


class Events(Served):
    @classmethod
    def setUpClass(cls):
        (WORK / "leap.list").write_text(LEAP, encoding="ascii")
        cls.serve(scenario("events.yaml", SCENARIO), "--leap-seconds", WORK / "leap.list", "--text", "tcp://127.0.0.1:0", "--from", T0)
        cls.begin = orrery.from_text(T0)
        # From before the first instant served to beyond the last: frames outside of it have no events.
        cls.frames = list(cls.client.poll_events(cls.begin, 3600, 24))
        cls.events = [e for f in cls.frames for e in f.events]

    def of(self, *kinds):
        return [e for e in self.events if e.kind in kinds]

    def seen(self, t, antenna):
        """Satellites that the antenna sees at the begin of the block that holds t, and that begin."""
        m = self.client.channels(t, antenna)
        return {str(c.sat) for c in m.channels}, m.block

    def test_ascending_within_their_intervals(self):
        self.assertGreater(len(self.events), 100)
        for f in self.frames:
            times = [e.at for e in f.events]
            self.assertEqual(times, sorted(times))
            self.assertTrue(all(f.t <= t < f.t1 for t in times))
            self.assertEqual(f.t1, f.t + 3600 * NS)

    def test_rises_and_sets_are_where_channels_come_and_go(self):
        for antenna in (0, 1):
            mine = [e for e in self.of(EventKind.RISE, EventKind.SET) if e.antenna == antenna]
            self.assertGreater(len(mine), 20)
            self.assertEqual({e.kind for e in mine}, {EventKind.RISE, EventKind.SET})
            for e in mine[:24]:
                before, there = self.seen(e.at - NS, antenna)
                self.assertLess(there, e.at)
                after, there = self.seen(e.at + 2 * NS, antenna)
                self.assertGreaterEqual(there, e.at)
                self.assertEqual((str(e.sat) in before, str(e.sat) in after), (e.kind == EventKind.SET, e.kind == EventKind.RISE))

    def test_who_is_in_view_is_what_rose_and_did_not_set(self):
        for antenna in (0, 1):
            view, _ = self.seen(self.begin + 3600 * NS, antenna)
            for k in range(1, 23):
                for e in self.frames[k].events:
                    if e.antenna == antenna:
                        (view.add if e.kind == EventKind.RISE else view.remove)(str(e.sat))
                self.assertEqual(view, self.seen(self.frames[k].t1, antenna)[0])

    def test_whole_whatever_intervals_are_asked_for(self):
        part = [e for f in self.client.poll_events(self.begin + 3 * 3600 * NS, 7.3, 494) for e in f.events]
        end = self.begin + 3 * 3600 * NS + 494 * 7300000000
        self.assertEqual(part, [e for e in self.events if self.begin + 3 * 3600 * NS <= e.at < end])
        self.assertGreater(len(part), 5)

    def test_arcs_are_those_of_states(self):
        begins = {str(e.sat): e.at for e in self.of(EventKind.ARC_BEGIN)}
        for s in self.client.states(self.begin + 12 * 3600 * NS).satellites:
            self.assertEqual(begins[str(s.sat)], s.valid_from)

    def test_new_ephemerides_are_those_of_navdata(self):
        t = self.begin + 10 * 3600 * NS + 1000 * NS
        sets = {(str(s.sat), s.message): s for s in next(self.client.poll_navdata(t)).satellites}
        for (sat, message), s in sets.items():
            mine = [e for e in self.of(EventKind.EPHEMERIS) if (str(e.sat), e.message) == (sat, message)]
            last = max((e for e in mine if e.at <= t), key=lambda e: e.at)
            self.assertEqual((last.at, last.value), (s.set_from, s.iode))
            following = min((e.at for e in mine if e.at > t))
            self.assertEqual(following, s.set_to)

    def test_a_leap_second(self):
        # 23:59:60 UTC is 00:00:18 GPS, and the day after it begins a second later.
        leap = self.of(EventKind.LEAP_SECOND)
        caps = self.client.caps
        self.assertEqual(caps.leap.next, orrery.from_text("2025-03-22T00:00:19"))
        inside = caps.span.first <= caps.leap.next <= caps.span.last
        self.assertEqual([(e.at, e.value) for e in leap], [(caps.leap.next, 19)] if inside else [])

    def test_shadows_are_those_of_states(self):
        begins = self.of(EventKind.ECLIPSE_BEGIN)
        for e in begins[:6]:
            flags = [next(s for s in self.client.states(e.at + d * NS).satellites if s.sat == e.sat).flags for d in (-1, 1)]
            self.assertEqual([bool(f & messages.StateFlags.ECLIPSE) for f in flags], [False, True])

    def test_faults_are_where_channels_have_them(self):
        begin, end = orrery.from_text("2025-03-21T12:00:00"), orrery.from_text("2025-03-21T12:05:00")
        gps = [str(s) for s in self.client.satellites if str(s).startswith("G")]
        for kind, t, before, after in ((EventKind.FAULT_BEGIN, begin, 0, 10), (EventKind.FAULT_END, end, 10, 0)):
            self.assertEqual([(e.at, str(e.sat), e.value) for e in self.of(kind)], [(t, s, 0) for s in gps])
            for at, metres in ((t - NS, before), (t, after)):
                both = [self.client.channels(at, antenna, terms=1) for antenna in (0, 1)]
                told = {x.fault_range_m for m in both for c, x in zip(m.channels, m.terms) if str(c.sat).startswith("G")}
                self.assertEqual(told, {metres})

    def test_streamed_and_as_text(self):
        stream = self.client.subscribe(messages.PollEvents(), self.begin + 3600 * NS, 60, count=60, pacing="free")
        streamed = [e for block in stream for e in block.events]
        self.assertEqual(streamed, self.frames[1].events)
        done = program("poll", self.daemon.urls[0], "--events", "--at", "2025-03-21T01:00:00", "--format", "json")
        self.assertEqual(done.returncode, 0, done.stderr)
        told = json.loads(done.stdout)
        self.assertEqual([orrery.from_text(e["at"]) for e in told["events"]], [e.at for e in streamed])
        table = program("poll", self.daemon.urls[0], "--events", "--at", "2025-03-21T01:00:00").stdout
        self.assertRegex(table, r"\n2025-03-21T01:00:00  new ephemeris  G01  lnav +\d+\n")
        line = next(x for x in self.daemon.lines if "as text on" in x)
        with socket.create_connection(("127.0.0.1", int(re.search(r"as text on tcp://127\.0\.0\.1:(\d+)", line).group(1))), 20) as s:
            s.sendall(b"EVEN? '2025-03-21T01:00:00'\n")
            answer = s.makefile("r").readline().rstrip("\n").split(",")
        self.assertEqual(int(answer[0]), len(streamed))
        shown = program("watch", self.daemon.urls[0], "-n", "1").stdout
        self.assertRegex(shown, r"events in the next 10 min")

    def test_what_cannot_be_asked(self):
        for step, count in ((3601, 1), (-1, 1)):
            with self.assertRaises(orrery.Refused):
                list(self.client.poll_events(self.begin, step, count))
        outside = next(self.client.poll_events("2030-01-01T00:00:00"))
        self.assertEqual((outside.answer, list(outside.events)), (messages.Answer.OUTSIDE_SPAN, []))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
