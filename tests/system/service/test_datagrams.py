#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Streams and motion as UDP datagrams: the polls' bytes, numbers and what is missing of them; over TLS a seal, so that what is forged,
replayed, or another session's is not taken; other machines without TLS are refused."""
import hashlib
import hmac
import re
import socket
import struct
import sys
import time
import unittest

from daemon import WORK, Daemon, Served, orrery as run, scenario  # first: it sets the path

import orrery
from orrery import datagrams, frame, messages
from test_access import laboratory
from test_motion import Body
from test_streams import SCENARIO, polled

NS = 10**9
PLAIN = SCENARIO + "navdata: {window: none}\n"


def other_address():
    """An address of this machine that is not loopback; None where there is none."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as s:
        try:
            s.connect(("192.0.2.1", 9))
        except OSError:
            return None
        return s.getsockname()[0]


class Window(unittest.TestCase):
    """The receiver's end, without a socket."""

    def datagram(self, number, key=b"", channel=7):
        return datagrams.make(channel, number, frame.make(messages.Pong.TYPE, 1, messages.Pong(number).encode()), key)

    def test_each_number_once(self):
        r = datagrams.Reader(7)
        for number in (1, 5, 3, 4, 2000, 977, 2001):
            self.assertEqual(r.take(self.datagram(number)).message().token, number)
        for number in (5, 3, 2000, 976, 977, 0):
            self.assertIsNone(r.take(self.datagram(number)), number)
        self.assertEqual((r.taken, r.replayed, r.refused, r.missing), (7, 6, 0, 2001 - 7))

    def test_what_is_not_of_the_channel(self):
        key = bytes(range(32))
        r = datagrams.Reader(7, key)
        good = self.datagram(1, key)
        wrong = [self.datagram(1), self.datagram(1, bytes(32)), self.datagram(1, key, 8), b"", b"ORRD", good[:-1], good + b"x"]
        wrong += [good[:k] + bytes([good[k] ^ 1]) + good[k + 1:] for k in range(0, len(good), 7)]
        self.assertEqual([r.take(d) for d in wrong], [None] * len(wrong))
        self.assertEqual((r.taken, r.refused), (0, len(wrong)))
        self.assertIsNotNone(r.take(good))
        self.assertEqual(good[-32:], hmac.new(key, good[:-32], hashlib.sha256).digest())
        self.assertEqual(good[:16], struct.pack("<4sIQ", b"ORRD", 7, 1))


class Sealed(Served):
    """By TLS and without, on loopback."""

    @classmethod
    def setUpClass(cls):
        lab = laboratory("lab", "generator", "cockpit")
        cls.identity = str(lab / "generator.pem")
        cls.serve(scenario("datagrams.yaml", PLAIN), "--access", lab / "access.yaml", "--from", "2025-03-21T10:02:00", "--motion", "--motion-udp", "0",
                  listen=("tcp://127.0.0.1:0", "tls://127.0.0.1:0", f"unix:{WORK}/datagrams.sock"))
        cls.tls = cls.daemon.urls[1]
        cls.start = orrery.from_text("2025-03-21T10:03:00")

    def secret(self):
        return self.connect(self.tls, identity=self.identity)

    def test_streams_are_the_polls_bytes(self):
        for client in (self.connect(), self.secret(), self.connect(self.daemon.urls[2])):
            for request, step in ((messages.PollChannels(antenna=1, terms=1), 0), (messages.Poll(), 0.01)):
                stream = client.subscribe(request, self.start, step, count=150, pacing="free", credit=16, datagrams=True)
                self.assertGreater(stream._port.reader.channel, 0)
                seen = 0
                for block in stream:
                    seen += 1
                    if seen % 10 == 0:
                        self.assertEqual(stream.payload, polled(client, request, block.t, stream.step))
                self.assertEqual((seen, stream.lost, stream.end.reason), (150, 0, messages.EndReason.FINISHED))
            client.ping(1)

    def test_gaps_are_told_twice_and_counted_once(self):
        """Without credit the clock leaves blocks out: the notice comes as a datagram and by the connection."""
        client = self.secret()
        stream = client.subscribe(messages.Poll(), None, 0.01, lead_s=0.1, credit=5, window=0, datagrams=True)
        first = [stream.next().t for _ in range(5)]
        time.sleep(0.9)
        stream.credit(3)
        after = stream.next().t
        self.assertEqual([(g.first, g.reason) for g in stream.gaps], [(first[-1] + NS // 100, messages.GapReason.CREDIT)])
        self.assertEqual(stream.gaps[0].last + NS // 100, after)
        self.assertEqual(stream.unsubscribe().reason, messages.EndReason.UNSUBSCRIBED)

    def test_forged_and_replayed_blocks(self):
        """Whoever knows the port sends what he likes: nothing of it is taken, and the stream goes on."""
        client = self.secret()
        stream = client.subscribe(messages.Poll(), self.start, 0.1, count=40, pacing="free", credit=10, datagrams=True)
        port, kept = stream._port, []
        take = port.reader.take
        port.reader.take = lambda d: kept.append(d) or take(d)
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as foe:
            for k in range(40):
                block = stream.next()
                self.assertEqual(block.t, self.start + k * NS // 10)
                for d in (kept[0], kept[-1], kept[-1][:-1] + bytes([kept[-1][-1] ^ 1]), b"ORRD", kept[-1][:8] + struct.pack("<Q", 10**6) + kept[-1][16:]):
                    foe.sendto(d, port.socket.getsockname())
            self.assertIsNone(stream.next())
        self.assertEqual(port.reader.taken, 41)
        self.assertGreater(port.reader.replayed, 20)
        self.assertGreater(port.reader.refused, 20)

    def test_motion_sealed(self):
        """Another key, another's channel, a replay, a changed byte: refused and counted; what is only late is the predictor's business."""
        client = self.secret()
        client.motion_stats(reset=True)
        body = Body(client.truth(client.time().t))
        with client.motion_datagrams() as sender:
            def settled(taken):
                end = time.monotonic() + 20
                while (told := client.datagrams()).taken < taken and time.monotonic() < end:
                    time.sleep(0.005)
                return told
            made = [sender.make(body.sample(client.time().t + k * 10**6, order=2)) for k in range(20)]
            order = [3, 0, 1, 2] + list(range(4, 20))  # out of order on the way
            for k in order:
                sender.send_bytes(made[k])
            self.assertEqual(settled(20).taken, 20)
            foreign = datagrams.make(sender.channel, 21, made[0][16:-32], bytes(32))
            for bad in (made[5], made[19], foreign, made[0][:-32], made[7][:40] + b"?" + made[7][41:], made[3][:4] + struct.pack("<I", 999) + made[3][8:]):
                sender.send_bytes(bad)
            sender.send(body.sample(client.time().t + NS, order=2))
            told = settled(21)
            self.assertEqual((told.taken, told.replayed, told.refused), (21, 2, 3))
        m = client.motion_stats()
        self.assertEqual((m.received, m.dropped), (21, 3))  # of the first four the last came first
        # Its key is this session's alone.
        other = self.secret()
        self.assertNotEqual(other.datagrams().keys, client.datagrams().keys)
        self.assertNotEqual(other.datagrams().channel, client.datagrams().channel)

    def test_motion_of_this_machine(self):
        """Without TLS there is no seal on loopback, but numbers: none is taken twice."""
        client = self.connect()
        told = client.datagrams()
        self.assertEqual((told.seal, told.keys), (messages.Seal.NONE, b""))
        with client.motion_datagrams() as sender:
            sample = sender.make(Body(client.truth(client.time().t)).sample(client.time().t, order=1))
            sender.send_bytes(sample)
            sender.send_bytes(sample)
            end = time.monotonic() + 20
            while client.datagrams().replayed < 1 and time.monotonic() < end:
                time.sleep(0.005)
        told = client.datagrams()
        self.assertEqual((told.taken, told.replayed, told.refused), (1, 1, 0))
        client.close()

    def test_ring_of_motion(self):
        """Shared memory over a Unix socket: samples are used, what is no sample is counted, who writes too much loses, and nothing that stands in
        the memory disturbs the server."""
        with self.assertRaisesRegex(orrery.Refused, "Unix socket"):
            self.connect().motion_ring()
        client = self.connect(self.daemon.urls[2])
        client.motion_stats(reset=True)
        begin = client.time().t
        body = Body(client.truth(begin))
        with client.motion_ring() as ring:
            def settled(taken):
                end = time.monotonic() + 20
                while (told := client.motion_ring_counts()).taken < taken and time.monotonic() < end:
                    time.sleep(0.005)
                return told
            for k in range(30):
                ring.send(body.sample(begin + 20 * NS + k * 10**6, order=3))
            self.assertEqual(settled(30).taken, 30)
            m = client.motion_stats()
            self.assertEqual((m.received, m.dropped), (30, 0))
            ring.write(messages.Motion.TYPE, b"too short")
            ring.write(messages.Ping.TYPE, bytes(200))
            ring.ring_bell()
            self.assertEqual(settled(32).taken, 32)
            self.assertEqual(client.motion_stats().dropped, 2)
            for k in range(1000):  # the bell not rung: the first of them are written over
                ring.write(messages.Motion.TYPE, body.sample(begin + 21 * NS + k * 10**6, order=3).encode())
            ring.ring_bell()
            told = settled(32 + 128)
            self.assertEqual(told.taken + told.lost, 1032)
            self.assertGreaterEqual(told.lost, 1000 - told.slots)
            with self.assertRaisesRegex(ValueError, "already"):
                client.motion_ring()
            for word in (2**64 - 1, 1, 0x4141414141414141):
                for k in range(0, len(ring._words), 3):
                    ring._words[k] = word
                ring.ring_bell()
                client.ping(1)
            self.assertEqual(client.states(self.start).t, self.start)

    def test_who_may_not_send_motion(self):
        rules = laboratory("lab", "generator", "cockpit") / "reader.yaml"
        rules.write_text("certificate: server.pem\nkey: server.key\nauthority: ca.pem\nclients:\n  - {name: generator, may: read}\n")
        with Daemon(WORK / "datagrams.yaml", "--access", rules, "--motion", "--motion-udp", "0", listen=("tls://127.0.0.1:0",)) as d:
            client = self.connect(d.urls[0], identity=self.identity)
            body = Body(client.truth(client.time().t))
            with client.motion_datagrams() as sender:
                sender.send(body.sample(client.time().t, order=1))
                end = time.monotonic() + 20
                while client.datagrams().taken < 1 and time.monotonic() < end:
                    time.sleep(0.005)
            self.assertEqual(client.motion_stats().received, 0)

    def test_recorded(self):
        """The client in C: keys of its own session, the same frames."""
        for k, (url, more) in enumerate(((self.url, ()), (self.tls, ("--identity", self.identity)))):
            log = WORK / f"datagrams{k}.log"
            done = run("record", url, *more, "-o", log, "--datagrams", "--channels", "--antenna", 1, "--count", 120, "--free", "--from", "2025-03-21T10:03:00")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("120 blocks, 0 left out, 0 lost", done.stderr + done.stdout)
            checked = run("replay", log, "--check", self.url)
            self.assertEqual((checked.returncode, checked.stderr), (0, ""))
            self.assertIn(" 0 unlike", checked.stdout)

    def test_mistakes(self):
        client = self.connect()
        asked = messages.Subscribe(request=messages.Poll.TYPE, delivery=messages.Delivery.DATAGRAMS, credit=1,
                                   poll=messages.Poll(messages.Epochs(self.start, NS, 1), []).encode())
        with self.assertRaisesRegex(orrery.Refused, "want a port"):
            client._ask(asked, messages.Subscribed)
        client.ping(1)
        done = run("serve", WORK / "datagrams.yaml", "--motion", "--motion-udp", "*:0", "--dialect", "nmea", "--listen", "tcp://127.0.0.1:0")
        self.assertEqual(done.returncode, 2)
        self.assertIn("sealed", done.stderr)
        for place in ("nowhere", "there:x", "127.0.0.1:99999"):
            done = run("serve", WORK / "datagrams.yaml", "--motion", "--motion-udp", place, "--listen", "tcp://127.0.0.1:0")
            self.assertEqual(done.returncode, 2, place)


class OtherMachines(unittest.TestCase):
    def test_not_without_a_seal(self):
        """By an address of this machine that others reach: TLS seals, without it there are no datagrams, in either direction."""
        here = other_address()
        if here is None:
            self.skipTest("this machine has no address but loopback")
        lab = laboratory("lab", "generator", "cockpit")
        path = scenario("far.yaml", PLAIN)
        with Daemon(path, "--access", lab / "access.yaml", "--insecure-listen", "--motion", "--motion-udp", f"{here}:0",
                    listen=(f"tcp://{here}:0",)) as d:
            with orrery.Client(d.urls[0]) as client:
                with self.assertRaisesRegex(orrery.Refused, "tls://"):
                    client.datagrams()
                with self.assertRaisesRegex(orrery.Refused, "tls://"):
                    client.subscribe(messages.Poll(), None, 0.1, datagrams=True)
                host, port = re.search(r"by UDP on ([\d.]+):(\d+)", "".join(d.lines)).groups()
                body = Body(client.truth(client.time().t))
                with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as s:
                    s.bind((here, 0))
                    sample = frame.make(messages.Motion.TYPE, 1, body.sample(client.time().t, order=1).encode())
                    for data in (sample, datagrams.make(1, 1, sample)):
                        s.sendto(data, (host, int(port)))
                time.sleep(0.2)
                m = client.motion_stats()
                self.assertEqual((m.received, m.dropped), (0, 0))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
