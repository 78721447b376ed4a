#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Streams by real clients over loopback: every block is the poll's bytes, requests go on beside them, credit and the clock are kept, and
a client that takes nothing harms nobody."""
import pathlib
import re
import socket
import subprocess
import sys
import time
import unittest

from daemon import FIRMWARE, WORK, Daemon, Served, scenario  # first: it sets the path

import orrery
from orrery import frame, messages

NS = 10**9

SCENARIO = """
orbit: {product: day.nc}
ionosphere: {field: ionosphere.ION}
troposphere: {model: saastamoinen}
signals: ["G:L1CA", "R:L1OF", "E:E1"]
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
mask: {elevation: 0}
"""


def polled(client, request, t, step):
    """The payload that the poll of one instant gets."""
    made = orrery.asking.from_epoch(request, t, step, 1)
    got = client._next_frame(client._send(made))
    return bytes(got.payload)


class Streams(Served):
    @classmethod
    def setUpClass(cls):
        cls.serve(scenario("streams.yaml", SCENARIO), listen=("tcp://127.0.0.1:0", f"unix:{WORK}/streams.sock"))
        cls.start = orrery.from_text("2025-03-21T10:00:00")

    def kinds(self):
        return ((messages.Poll(), 0.001), (messages.PollNavdata(), 1), (messages.PollChannels(antenna=0, terms=1), 0.1),
                (messages.PollChannels(antenna=1), 0.01), (messages.PollImu(unit=0), 0.001), (messages.PollTruth(unit=0), 0.001), (messages.PollEvents(), 1))

    def check(self, stream, request, blocks, judge):
        """Each block is the poll's answer for its instant; the instants follow each other."""
        t = stream.first
        for k in range(blocks):
            block = stream.next()
            self.assertIsNotNone(block, f"the stream ended at block {k}: {stream.end}")
            self.assertEqual((block.t, block.index, block.count), (t, 0, 1))
            self.assertEqual(stream.payload, polled(judge, request, t, stream.step))
            t = t + stream.step if stream.step else block.block + block.length
        return t

    def test_caps_list_streams(self):
        served = {r.request: r.answer for r in self.connect().caps.requests}
        self.assertEqual(served[messages.Subscribe.TYPE], messages.Subscribed.TYPE)

    def test_every_kind_is_the_polls_bytes(self):
        client, judge = self.connect(), self.connect()
        for request, step in self.kinds():
            with self.subTest(type(request).__name__):
                stream = client.subscribe(request, self.start + 100 * NS, step, count=60, pacing="free", credit=20)
                self.assertEqual((stream.first, stream.step), (self.start + 100 * NS, round(step * NS)))
                self.check(stream, request, 60, judge)
                self.assertIsNone(stream.next())
                self.assertEqual(stream.end.reason, messages.EndReason.FINISHED)
                self.assertEqual(stream.end.next, stream.first + 60 * stream.step)

    def test_channels_block_by_block(self):
        client, judge = self.connect(), self.connect()
        request = messages.PollChannels(antenna=0)
        stream = client.subscribe(request, self.start + 200 * NS, 0, pacing="free", credit=8)
        end = self.check(stream, request, 80, judge)
        self.assertGreater(end - stream.first, 79 * 10**6)
        self.assertEqual(stream.unsubscribe().reason, messages.EndReason.UNSUBSCRIBED)

    def test_navdata_frame_by_frame(self):
        """With step 0 the next comes where the first of the frames ends, and pages of each message join without a gap."""
        client, judge = self.connect(), self.connect()
        request = messages.PollNavdata(kinds=(1 << 32) - 1, form=messages.NavForm.SYMBOLS)
        stream = client.subscribe(request, self.start + 100 * NS, 0, pacing="free", credit=3)
        self.assertEqual((stream.first, stream.step), (self.start + 100 * NS, 0))
        t, pages, steps = stream.first, {}, set()
        for _ in range(40):
            block = stream.next()
            self.assertEqual(block.t, t)
            self.assertEqual(stream.payload, polled(judge, request, t, 0))
            sent = [s for s in block.satellites if s.answer == messages.Answer.OK]
            for s in sent:
                for page in s.pages:
                    pages.setdefault((str(s.sat), s.message, s.signals), {})[page.t] = page.length
            after = min(s.frame_to for s in sent)
            steps.add(after - t)
            t = after
        self.assertGreater(len(steps), 1)  # frames of several lengths
        self.assertGreater(len(pages), 30)
        for held in pages.values():
            begins = sorted(held)
            self.assertEqual([b + held[b] for b in begins[:-1]], begins[1:])
            self.assertLessEqual(begins[0], stream.first)
            self.assertGreaterEqual(begins[-1] + held[begins[-1]], t)
        self.assertEqual(stream.unsubscribe().reason, messages.EndReason.UNSUBSCRIBED)
        with self.assertRaisesRegex(orrery.Refused, "its step is 1 ms to 60 s"):
            client.subscribe(messages.Poll(), self.start, 0, pacing="free")

    def test_a_ring_has_the_polls_bytes(self):
        """Through shared memory, which comes with the answer; over TCP there is none."""
        judge = self.connect()
        client = self.connect(self.daemon.urls[1])
        for request, step in self.kinds():
            with self.subTest(type(request).__name__):
                stream = client.subscribe(request, self.start + 100 * NS, step, count=60, pacing="free", credit=20, ring=True)
                self.check(stream, request, 60, judge)
                self.assertIsNone(stream.next())
                self.assertEqual((stream.end.reason, stream.lost), (messages.EndReason.FINISHED, 0))
        slow = client.subscribe(messages.Poll(), self.start, 0.01, count=2000, pacing="free", credit=2000, window=0, ring=True)
        end = client._decode(client._next_frame(slow.number), messages.StreamEnd)  # it comes over the socket as well
        self.assertEqual(end.reason, messages.EndReason.FINISHED)
        read = sum(1 for _ in slow)
        self.assertGreater(slow.lost, 1000)
        self.assertEqual(read + slow.lost, 2000)
        with self.assertRaises(orrery.Refused):
            judge.subscribe(messages.Poll(), self.start, 1, ring=True)
        judge.ping(1)

    def test_several_streams_and_requests_side_by_side(self):
        client, judge = self.connect(), self.connect()
        made = [(request, client.subscribe(request, self.start + k * NS, step, pacing="free", credit=10))
                for k, (request, step) in enumerate(self.kinds())]
        cursors = [stream.first for _, stream in made]
        for turn in range(30):
            for k, (request, stream) in enumerate(made):
                block = stream.next()
                self.assertEqual(block.t, cursors[k])
                self.assertEqual(stream.payload, polled(judge, request, block.t, stream.step))
                cursors[k] += stream.step
            client.ping(turn)
            self.assertEqual(client.states(self.start + turn * NS).t, self.start + turn * NS)
        for _, stream in made:
            self.assertEqual(stream.unsubscribe().reason, messages.EndReason.UNSUBSCRIBED)
        client.ping(99)

    def test_a_client_that_says_no_more(self):
        """Its side closed, it gets what it has credit for; then nothing can come of the connection, and it is closed."""
        client = self.connect()
        stream = client.subscribe(messages.Poll(), self.start, 0.01, count=0, pacing="free", credit=40, window=0)
        client._sock.shutdown(socket.SHUT_WR)
        self.assertEqual([stream.next().t for _ in range(40)], [self.start + k * NS // 100 for k in range(40)])
        with self.assertRaisesRegex(orrery.ProtocolError, "closed"):
            stream.next()

    def test_the_clock_paces(self):
        """Blocks of 100 Hz come 0.2 s ahead of the clock: 100 of them in about a second, after 20 at once."""
        client, judge = self.connect(), self.connect()
        stream = client.subscribe(messages.Poll(), None, 0.01, pacing="clock", lead_s=0.2, credit=1000)
        begin = time.monotonic()
        self.check(stream, messages.Poll(), 120, judge)
        took = time.monotonic() - begin
        self.assertGreater(took, 0.9)  # never earlier than the clock says; how late is the bench's business
        self.assertEqual(stream.first % stream.step, 0)
        self.assertEqual(stream.gaps, [])
        end = stream.unsubscribe()
        self.assertEqual(end.next % stream.step, 0)

    def test_look_ahead(self):
        """From the clock's present instant on, 60 s ahead at 100 Hz: as fast as they are taken."""
        client = self.connect()
        now = client.subscribe(messages.Poll(), None, 0.01, credit=0)
        ahead = client.subscribe(messages.Poll(), now.first + NS, 0.01, pacing="clock", lead_s=60, credit=2000)
        begin = time.monotonic()
        for k in range(1000):
            self.assertEqual(ahead.next().t, now.first + NS + k * 10**7)
        self.assertLess(time.monotonic() - begin, 9)
        ahead.unsubscribe()

    def test_without_credit_nothing_comes_and_the_gap_is_told(self):
        client = self.connect()
        stream = client.subscribe(messages.Poll(), None, 0.01, pacing="clock", credit=0, window=0)
        time.sleep(1.0)
        client.ping(1)
        self.assertFalse(client._inbox[stream.number])
        stream.credit(3)
        blocks = [stream.next() for _ in range(3)]
        self.assertEqual(len(stream.gaps), 1)
        gap = stream.gaps[0]
        self.assertEqual((gap.first, gap.reason), (stream.first, messages.GapReason.CREDIT))
        self.assertEqual(gap.last - gap.first, (gap.blocks - 1) * stream.step)
        self.assertGreater(gap.blocks, 50)
        self.assertEqual([b.t for b in blocks], [gap.last + k * stream.step for k in (1, 2, 3)])
        stream.unsubscribe()

    def test_a_client_that_takes_nothing_loses_its_stream_and_slows_nobody(self):
        frozen, other, judge = self.connect(), self.connect(), self.connect()
        frozen._sock.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 65536)
        streams = [frozen.subscribe(messages.Poll(), None, 0.001, credit=10**6, window=0) for _ in range(8)]
        begin = time.monotonic()
        beside = other.subscribe(messages.Poll(), None, 0.01, pacing="clock", credit=1000)
        self.check(beside, messages.Poll(), 200, judge)
        self.assertGreater(time.monotonic() - begin, 1.9)
        self.assertEqual(beside.gaps, [])
        for stream in streams:
            while (got := frozen._next_frame(stream.number)).type == messages.States.TYPE:
                pass
            end = messages.StreamEnd.decode(got.payload)
            self.assertEqual((got.type, end.reason), (messages.StreamEnd.TYPE, messages.EndReason.SLOW))
        frozen.ping(5)  # the connection lives

    def test_input_is_read_while_output_waits(self):
        """A client that reads nothing, with a long answer under way, can still say things of its streams."""
        client, judge = self.connect(), self.connect()
        stream = client.subscribe(messages.Poll(), self.start, 0.001, pacing="free", credit=5, window=0)
        client._sock.sendall(frame.make(messages.Poll.TYPE, 1000, messages.Poll(messages.Epochs(self.start, NS, 20000)).encode()))
        client._sequence = 1000
        client._inbox[1000] = __import__("collections").deque()
        for _ in range(5):
            self.assertIsNotNone(stream.next())
        stream.credit(7)
        self.check_rest(stream, 7, judge)
        stream.unsubscribe()
        del client._inbox[1000]
        client.close()

    def check_rest(self, stream, n, judge):
        for k in range(n):
            block = stream.next()
            self.assertEqual(block.t, stream.first + (5 + k) * stream.step)
            self.assertEqual(stream.payload, polled(judge, messages.Poll(), block.t, stream.step))

    def test_the_span_ends(self):
        client = self.connect()
        last = next(r.span.last for r in client.caps.requests if r.request == messages.PollTruth.TYPE)
        stream = client.subscribe(messages.PollTruth(unit=0), last - NS, 0.5, pacing="free", credit=10)
        self.assertEqual([b.t for b in stream], [last - NS, last - NS // 2, last])
        self.assertEqual(stream.end.reason, messages.EndReason.OUTSIDE_SPAN)

    def test_the_generators_loop_of_the_samples(self):
        with Daemon(WORK / "streams.yaml", "--from", "2025-03-21T10:01:00") as daemon:
            loop = subprocess.run([str(pathlib.Path(FIRMWARE).with_name("live_loop")), daemon.urls[0].rsplit(":", 1)[1], "60"],
                                  capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual(loop.returncode, 0)
        blocks, joints = re.fullmatch(r"(\d+) blocks, joints within (\S+) m\n", loop.stdout).groups()
        self.assertEqual(blocks, "60")
        self.assertLess(float(joints), 4e-9)

    def test_what_cannot_be_asked_is_refused(self):
        client = self.connect()
        t = self.start
        for request, kind, words in (
                (messages.Poll(), {"step_s": 0.0005}, "1 ms to 60 s"), (messages.Poll(), {"step_s": 0}, "1 ms to 60 s"),
                (messages.PollImu(), {"step_s": 2}, "1 ms to 1 s"), (messages.Poll(), {"step_s": 1, "lead_s": 61}, "0 to 60 s"),
                (messages.Poll(), {"step_s": 1, "lead_s": -1}, "0 to 60 s"), (messages.PollElements(), {"step_s": 1}, "can be streamed"),
                (messages.PollTruth(unit=9), {"step_s": 1}, "no unit 9"), (messages.PollChannels(antenna=7), {}, "POLL_CHANNELS")):
            with self.assertRaises(orrery.Refused) as refused:
                client.subscribe(request, t, **kind)
            self.assertIn(words, str(refused.exception))
        with self.assertRaises(orrery.Refused) as refused:
            client.subscribe(messages.Poll(), t - 10**6 * NS, 1)
        self.assertIn("outside the span", str(refused.exception))
        with self.assertRaises(orrery.Refused) as refused:
            client._ask(messages.Credit(12345, 1), messages.Pong)
        self.assertIn("no stream of that number", str(refused.exception))
        streams = [client.subscribe(messages.Poll(), t, 1, credit=0) for _ in range(32)]
        with self.assertRaises(orrery.Refused) as refused:
            client.subscribe(messages.Poll(), t, 1)
        self.assertIn("32 streams", str(refused.exception))
        for stream in streams:
            stream.unsubscribe()
            client._send(messages.Credit(stream.number, 1))  # of one that has ended: passed over
        client.ping(7)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
