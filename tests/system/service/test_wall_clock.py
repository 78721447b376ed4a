#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The wall's clock is set under a running service (libfaketime): the scenario's clock, streams, sessions and limits go by the monotonic clock and
do not notice; that the wall was set is counted; only certificates, which expire by the wall, go by it."""
import os
import pathlib
import subprocess
import sys
import time
import unittest

from daemon import ORRERY, PATIENCE_S, WORK, Daemon, orrery as run, product  # first: it sets the path

import orrery
from orrery import messages

FAKETIME = next(pathlib.Path("/usr/lib").glob("*/faketime/libfaketimeMT.so.1"), None)
NS = 10**9
WHEN = "2025-03-21T12:00:00"
OFFSET = WORK / "offset"  # what libfaketime adds to the wall, in seconds
# Steps of the wall: an hour on, back beyond the start, a month on, a year back, and home.
STEPS = (3600, -7200, 2592000, -31536000, 0)


def fake():
    """The environment of a program whose wall is ours to set, its monotonic clock not."""
    return {**os.environ, "LD_PRELOAD": str(FAKETIME), "FAKETIME_TIMESTAMP_FILE": str(OFFSET), "FAKETIME_NO_CACHE": "1",
            "FAKETIME_DONT_FAKE_MONOTONIC": "1", "DONT_FAKE_MONOTONIC": "1"}


def step_to(seconds):
    beside = OFFSET.with_suffix(".new")
    beside.write_text(f"{seconds:+d}\n", encoding="ascii")
    beside.rename(OFFSET)


def runs():
    """Whether the program can be run so: not where a sanitizer wants to be loaded first."""
    if FAKETIME is None:
        return False
    step_to(0)
    return subprocess.run([ORRERY, "--version"], env=fake(), capture_output=True, timeout=PATIENCE_S, check=False).returncode == 0


@unittest.skipUnless(runs(), "libfaketime is not here, or a sanitizer is")
class WallClock(unittest.TestCase):
    def serve(self, *args, **kwargs):
        step_to(0)
        daemon = Daemon(product(), *args, env=fake(), **kwargs)
        self.addCleanup(lambda: self.assertEqual(daemon.stop(), 0, "".join(daemon.lines)))
        return daemon

    def test_steps(self):
        daemon = self.serve("--from", WHEN)
        with orrery.Client(daemon.urls[0], timeout_s=PATIENCE_S) as client:
            answer = [m.encode() for m in client.poll(WHEN, step_s=1, count=5)]
            first = client.time()
            stream = client.subscribe(messages.Poll(messages.Epochs(), [orrery.sat_id("G01")]), None, 0.02, credit=1000)
            last = stream.next().t
            for n, offset in enumerate(STEPS):
                step_to(offset)
                for _ in range(12):
                    t = stream.next().t
                    self.assertEqual((t > last, (t - last) % (NS // 50)), (True, 0))  # a machine that is too busy leaves some out
                    last = t
                now, end = client.time(), time.monotonic() + PATIENCE_S
                while now.sets < first.sets + n + 1 and time.monotonic() < end:  # the thread that makes blocks sees it at its next turn
                    now = client.time()
                self.assertLessEqual(last, now.t)  # none came before its time
                self.assertLess(now.t - last, PATIENCE_S * NS)
                self.assertEqual((now.t - first.t), (now.host - first.host))
                self.assertAlmostEqual((now.wall - first.wall - (now.host - first.host)) / NS, offset, delta=1)
                self.assertEqual((now.state, now.sets, now.suspends), (messages.ClockState.RUNNING, first.sets + n + 1, first.suspends))
                self.assertEqual([m.encode() for m in client.poll(WHEN, step_s=1, count=5)], answer)
            client.ping(5)

    def test_a_start_at_an_instant(self):
        """A start by the wall follows the wall that was set, as the instant that was asked for is one of it."""
        daemon = self.serve("--start", "command", "--from", WHEN)
        with orrery.Client(daemon.urls[0], timeout_s=PATIENCE_S) as client:
            at = client.time().wall + 3600 * NS
            self.assertEqual(client.control("start", at=at).state, messages.ClockState.WAITING)
            step_to(3598)
            end = time.monotonic() + PATIENCE_S
            while (m := client.time()).state != messages.ClockState.RUNNING and time.monotonic() < end:
                time.sleep(0.05)
            self.assertEqual(m.state, messages.ClockState.RUNNING)
            self.assertAlmostEqual(((m.t - orrery.from_text(WHEN)) - (m.wall - at)) / NS, 0, delta=0.2)

    def test_certificates(self):
        """Who is connected stays so; a newcomer's certificate is looked at by the wall: a year ago there was none."""
        lab = WORK / "lab"
        self.assertEqual(run("tls", "init", lab, "generator", "--host", "127.0.0.1").returncode, 0)
        daemon = self.serve("--access", lab / "access.yaml", listen=("tls://127.0.0.1:0",))
        identity = str(lab / "generator.pem")
        with orrery.Client(daemon.urls[0], timeout_s=PATIENCE_S, identity=identity) as client:
            answer = client.states(WHEN)
            step_to(-31536000)
            with self.assertRaises((OSError, orrery.ProtocolError)):
                orrery.Client(daemon.urls[0], timeout_s=PATIENCE_S, identity=identity)
            self.assertEqual(client.states(WHEN), answer)
            step_to(0)
            with orrery.Client(daemon.urls[0], timeout_s=PATIENCE_S, identity=identity) as other:
                self.assertEqual(other.states(WHEN), answer)
            self.assertEqual(client.states(WHEN), answer)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
