#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Clients of a real service: all of them get the same bytes, and none can harm another."""
import concurrent.futures
import math
import random
import re
import socket
import struct
import subprocess
import time
import unittest

from daemon import FIRMWARE, PATIENCE_S, ROOT, WORK, Daemon, product  # first: it sets the path

import orrery
from orrery import frame, messages
from orrery.client import connect

NS = 10**9


def receive_exactly(sock, n):
    data = b""
    while len(data) < n:
        part = sock.recv(n - len(data))
        if not part:
            raise EOFError
        data += part
    return data


def raw_poll(url, poll, sequence=1):
    """The payloads that answer a POLL, as they are on the wire."""
    with connect(url, PATIENCE_S) as sock:
        sock.sendall(frame.make(messages.Poll.TYPE, sequence, poll.encode()))
        got = [frame.read(lambda n: receive_exactly(sock, n)) for _ in range(poll.count)]
    for f in got:
        if f.type != messages.States.TYPE or f.sequence != sequence:
            raise AssertionError(f"type {f.type}, sequence {f.sequence}")
    return [f.payload for f in got]


class Clients(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.daemon = Daemon(product(), listen=("tcp://127.0.0.1:0", f"unix:{WORK}/clients.sock"))
        cls.tcp, cls.unix = cls.daemon.urls
        with orrery.Client(cls.tcp) as client:
            cls.start, cls.end = client.span

    @classmethod
    def tearDownClass(cls):
        status = cls.daemon.stop()
        if status != 0:
            raise AssertionError(f"the service ended with {status}: {''.join(cls.daemon.lines)}")

    def test_caps(self):
        with orrery.Client(self.tcp) as client:
            self.assertEqual(client.satellites, [f"G{n:02d}" for n in range(1, 7)] + ["R01", "R02", "E01", "E02"])
            self.assertEqual((client.caps.major, client.caps.name), (1, "orrery"))
            self.assertEqual(self.end - self.start, 86400 * NS)
            never = (-2**63, -2**63)
            told = [(r.request, r.answer, (r.span.first, r.span.last)) for r in client.caps.requests]
            # Streams, clock and motion have no span of their own; which of them there are is for their tests.
            self.assertEqual([t for t in told if t[0] < messages.Subscribe.TYPE],
                             [(messages.Hello.TYPE, messages.Caps.TYPE, never), (messages.Ping.TYPE, messages.Pong.TYPE, never),
                              (messages.Poll.TYPE, messages.States.TYPE, client.span),
                              (messages.PollElements.TYPE, messages.Elements.TYPE, client.span),
                              (messages.PollNavdata.TYPE, messages.Navdata.TYPE, client.span)])
            for poll in (messages.PollDelays(messages.Epochs(self.start, 0, 1), [math.nan] * 3, [], []),
                         messages.PollImu(messages.Epochs(self.start, 0, 1), 0), messages.PollTruth(messages.Epochs(self.start, 0, 1), 0)):
                with self.assertRaises(orrery.Refused) as refused:  # what CAPS does not list is not answered
                    client._ask(poll, messages.States)
                self.assertEqual(refused.exception.code.name, "NOT_SERVED")
            caps = client.caps
            self.assertEqual((caps.receiver_source, caps.units, caps.navdata_point),
                             (messages.ReceiverSource.NONE, [], messages.OrbitPoint.CENTRE_OF_MASS))
            self.assertTrue(all(map(math.isnan, [*caps.receiver_m, caps.imu_rate_hz])))
            self.assertEqual((caps.leap.gps_utc_s, caps.leap.next_gps_utc_s, caps.leap.next), (18, 18, -2**63))  # 2025
            client.ping(2**64 - 1)

    def test_leap_seconds_are_those_of_the_run(self):
        table = WORK / "leap-seconds.list"
        days = (41317, 41499, 41683, 42048, 42413, 42778, 43144, 43509, 43874, 44239, 44786, 45151, 45516, 46247, 47161, 47892, 48257, 48804,
                49169, 49534, 50083, 50630, 51179, 53736, 54832, 56109, 57204, 57754, 61406)  # the last is 2027-01-01
        table.write_text(f"#@ {(61583 - 15020) * 86400}\n" + "".join(f"{(d - 15020) * 86400} {10 + k}\n" for k, d in enumerate(days)),
                         encoding="ascii")
        with Daemon(product(), "--leap-seconds", table) as daemon, orrery.Client(daemon.urls[0]) as client:
            leap = client.caps.leap
            begin = (61406 - 44244) * 86400 + 19  # seconds of GPS time at 00:00:00 UTC, 19 leap seconds after 1980
            self.assertEqual((leap.gps_utc_s, leap.next_gps_utc_s, leap.next), (18, 19, begin * NS))

    def test_many_clients_agree_to_the_byte(self):
        rng = random.Random(1)
        polls = [messages.Poll(messages.Epochs(rng.randrange(self.start, self.end), 10**8, rng.randrange(1, 30)),
                               [messages.SatId(ord("G"), 3)] if k % 3 == 0 else []) for k in range(12)]
        expected = [raw_poll(self.tcp, p) for p in polls]

        def one_client(number):
            url = (self.tcp, self.unix)[number % 2]
            order = random.Random(number).sample(range(len(polls)), len(polls))
            return all(raw_poll(url, polls[k], sequence=number * 100 + k) == expected[k] for k in order)
        with concurrent.futures.ThreadPoolExecutor(16) as pool:
            self.assertTrue(all(pool.map(one_client, range(32))))

    def test_a_series_is_its_epochs(self):
        t = self.start + 3600 * NS
        series = raw_poll(self.tcp, messages.Poll(messages.Epochs(t, 250_000_000, 20), []))
        for k, payload in enumerate(series):
            alone = raw_poll(self.unix, messages.Poll(messages.Epochs(t + k * 250_000_000, 0, 1), []))[0]
            self.assertEqual((payload[:8], payload[16:]), (alone[:8], alone[16:]))  # all but index and count

    def test_states_move_as_they_say(self):
        # Central differences of the served positions against the served velocities and accelerations: h = 1 s leaves
        # h^2/6 of the third derivative (below 3e-5 m/s) and rounding of positions (1e-8 m / s).
        with orrery.Client(self.tcp) as client:
            t = self.start + 40000 * NS + 123456789
            a, b, c = client.poll(t - NS, 1.0, 3)
            for before, now, after in zip(a.satellites, b.satellites, c.satellites):
                self.assertEqual(now.answer, orrery.Answer.OK)
                self.assertGreater(math.hypot(*now.pos_m), 2.0e7)
                for k in range(3):
                    self.assertAlmostEqual((after.pos_m[k] - before.pos_m[k]) / 2, now.vel_mps[k], delta=1e-4)
                    self.assertAlmostEqual((after.vel_mps[k] - before.vel_mps[k]) / 2, now.acc_mps2[k], delta=1e-7)

    def test_never_a_number_where_there_is_none(self):
        with orrery.Client(self.tcp) as client:
            for t in (self.start - 1, self.end + 1, -2**62, 2**62):
                states = client.states(t)
                self.assertEqual((states.answer, states.satellites), (orrery.Answer.OUTSIDE_SPAN, []))
            self.assertEqual([client.states(t).answer for t in (self.start, self.end)], [orrery.Answer.OK] * 2)
            answers = [s.answer for s in client.poll(self.end - NS, 0.5, 5)]
            self.assertEqual(answers, [0, 0, 0, 1, 1])
            states = client.states(self.start, ["G01", "G32", "C05", "G01"])
            self.assertEqual([orrery.sat_name(s.sat) for s in states.satellites], ["G01", "G32", "C05", "G01"])
            self.assertEqual([s.answer for s in states.satellites], [0, 3, 3, 0])
            lost = states.satellites[1]
            for value in [*lost.pos_m, *lost.vel_mps, *lost.acc_mps2, lost.clock_s, lost.clock_rate_sps, lost.sigma_m]:
                self.assertTrue(math.isnan(value))
            self.assertEqual((lost.flags, lost.valid_from, lost.valid_to), (0, -2**63, -2**63))

    def test_a_satellite_that_nobody_knows_is_not_served(self):
        """It is one satellite's answer, not the refusal of a whole request; the name comes back as it was asked."""
        asked = [(ord("G"), 1), (ord("g"), 1), (ord("X"), 5), (ord("G"), 0), (ord("G"), 200), (0, 0), (255, 255), (ord("R"), 2)]
        ids = [messages.SatId(*a) for a in asked]
        with orrery.Client(self.tcp) as client:
            for poll, kind in ((messages.Poll, messages.States), (messages.PollElements, messages.Elements),
                               (messages.PollNavdata, messages.Navdata)):
                m = client._ask(poll(messages.Epochs(self.start, 0, 1), satellites=ids), kind)
                self.assertEqual(m.answer, orrery.Answer.OK)
                self.assertEqual([(s.sat.system, s.sat.number) for s in m.satellites], asked)
                self.assertEqual([s.answer for s in m.satellites], [0, 3, 3, 3, 3, 3, 3, 0])

    def test_refusals_leave_the_connection_alive(self):
        with orrery.Client(self.tcp) as client:
            for poll, code in ((messages.Poll(messages.Epochs(0, 0, 0), []), "BAD_REQUEST"), (messages.Poll(messages.Epochs(0, 0, 2), []), "BAD_REQUEST"),
                               (messages.Poll(messages.Epochs(0, 1, messages.MAX_EPOCHS + 1), []), "LIMIT"),
                               (messages.Poll(messages.Epochs(2**63 - 1, 1, 2), []), "BAD_REQUEST"),
                               (messages.Poll(messages.Epochs(0, 2**62, 5), []), "BAD_REQUEST")):
                with self.assertRaises(orrery.Refused) as refused:
                    client._ask(poll, messages.States)
                self.assertEqual(refused.exception.code.name, code)
                self.assertGreater(len(str(refused.exception)), 15)
            client._sock.sendall(frame.make(999, 77, b"whatever"))
            client._sequence = 77
            with self.assertRaises(orrery.Refused) as refused:
                client._receive(messages.States)
            self.assertEqual(refused.exception.code, orrery.ErrorCode.UNKNOWN_TYPE)
            client.ping(5)

    def test_garbage_and_broken_connections(self):
        rng = random.Random(5)
        good = frame.make(messages.Poll.TYPE, 1, messages.Poll(messages.Epochs(self.start, 1, 5000), []).encode())
        with orrery.Client(self.tcp) as witness:
            for k in range(40):
                sock = connect((self.tcp, self.unix)[k % 2], PATIENCE_S)
                what = k % 5
                if what == 0:
                    sock.sendall(rng.randbytes(rng.randrange(1, 3000)))
                elif what == 1:
                    sock.sendall(good[:rng.randrange(1, len(good))])
                elif what == 2:  # leaves in the middle of an answer
                    sock.sendall(good)
                    sock.recv(1000)
                elif what == 3:  # with a reset
                    sock.sendall(good + good)
                    sock.recv(10)
                    sock.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
                else:
                    broken = bytearray(good)
                    broken[20] ^= 8
                    sock.sendall(broken)
                    answer = frame.read(lambda n, s=sock: receive_exactly(s, n))
                    self.assertEqual(answer.message().code, messages.ErrorCode.BAD_CRC)
                    self.assertEqual(sock.recv(1), b"")
                sock.close()
                witness.ping(k)
        self.assertTrue(self.daemon.said("BAD_CRC") and self.daemon.said("BAD_MAGIC"))

    def test_a_slow_reader_harms_nobody(self):
        poll = messages.Poll(messages.Epochs(self.start, NS // 10, 20000), [])
        with connect(self.tcp, PATIENCE_S) as lazy, orrery.Client(self.unix) as quick:
            lazy.sendall(frame.make(messages.Poll.TYPE, 1, poll.encode()))
            slowest = 0.0
            for k in range(200):
                begin = time.monotonic()
                quick.states(self.start + k)
                slowest = max(slowest, time.monotonic() - begin)
            for index in range(poll.count):  # the lazy one reads at last, and all of it is there
                payload = frame.read(lambda n: receive_exactly(lazy, n)).payload
                self.assertEqual(struct.unpack_from("<I", payload, 8)[0], index)
        self.assertLess(slowest, PATIENCE_S / 3)  # not a measure of speed: it was not made to wait for the other's end

    def test_firmware_client(self):
        host, port = re.match(r"tcp://(.*):(\d+)$", self.tcp).groups()
        done = subprocess.run([FIRMWARE, host, port], capture_output=True, text=True, timeout=PATIENCE_S, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        lines = done.stdout.splitlines()
        self.assertEqual(lines[0], "satellites 10")
        with orrery.Client(self.tcp) as client:
            expected = [f"{m.t} {orrery.sat_name(s.sat)} {s.pos_m[0].hex()} {s.vel_mps[1].hex()} {s.acc_mps2[2].hex()}"
                        for m in client.poll(self.start, 43200, 2) for s in m.satellites]
            middle = client.elements(self.start + 43200 * NS)
            elements = [f"{orrery.sat_name(s.sat)} {s.a_m.hex()} {s.i_rad.hex()} {s.u_rad.hex()}" for s in middle.satellites]
            pages = [f"{orrery.sat_name(s.sat)} {p.number} {p.data.hex()}"
                     for s in client.navdata(self.start + 43200 * NS).satellites for p in s.pages]
        words = [line.split() for line in lines[1:] if not line.startswith(("elements", "navdata"))]
        self.assertEqual([f"{w[0]} {w[1]} " + " ".join(float.fromhex(x).hex() for x in w[2:]) for w in words], expected)
        words = [line.split() for line in lines if line.startswith("elements")]
        self.assertEqual([f"{w[1]} " + " ".join(float.fromhex(x).hex() for x in w[2:]) for w in words], elements)
        self.assertEqual([line[8:] for line in lines if line.startswith("navdata")], pages)
        self.assertEqual(len(pages), 6 * 5 + 2 * 15 + 2 * 15)  # subframes, strings, pages of I/NAV in 30 s

    def test_the_module_that_polls(self):
        done = subprocess.run(["python3", "-B", "-m", "orrery.poll", self.tcp, "--sat", "G01", "E02", "--rate", "10", "--seconds",
                               "0.3"], cwd=ROOT / "proto/python", capture_output=True, text=True, timeout=PATIENCE_S, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout.count("E02"), 3)
        done = subprocess.run(["python3", "-B", "-m", "orrery.poll", f"unix:{WORK}/nobody"], cwd=ROOT / "proto/python",
                              capture_output=True, text=True, timeout=PATIENCE_S, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("nobody", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=["test_clients"])
