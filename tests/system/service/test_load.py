#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""CONTROL LOAD: another scenario by its name, from one folder alone; one that cannot be served leads back to the one before. SIGHUP: the
same scenario read again, exchanged as a whole or not at all."""
import re
import signal
import socket
import sys
import threading
import time
import unittest

from daemon import WORK, Daemon, product  # first: it sets the path

import orrery
from orrery.messages import ClockState, ErrorCode

FLIGHT = """
title: {title}
trajectory: {{kind: analytic, start: {start}, duration: 60, lat: 10, lon: 20, height: 100}}
"""


class Load(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = WORK / "scenarios"
        cls.folder.mkdir()
        for name, start in (("one", "2025-03-21T10:00:00"), ("two", "2026-01-01T00:00:00")):
            (cls.folder / f"{name}.yaml").write_text(FLIGHT.format(title=name, start=start), encoding="utf-8")
        (cls.folder / "broken.yaml").write_text("title: broken\norbit: {product: missing.nc}\n", encoding="utf-8")
        (WORK / "secret.yaml").write_text(FLIGHT.format(title="secret", start="2026-01-01T00:00:00"), encoding="utf-8")

    def served(self, url, title, timeout_s=60):
        """A client once that title is served."""
        end = time.monotonic() + timeout_s
        while True:
            try:
                client = orrery.Client(url)
                if client.caps.title == title:
                    return client
                client.close()
            except (OSError, orrery.ProtocolError, orrery.Refused):
                pass
            self.assertLess(time.monotonic(), end, f"'{title}' is not served")
            time.sleep(0.05)

    def test_another_scenario(self):
        with Daemon(self.folder / "one.yaml", "--scenarios", self.folder, "--text", "tcp://127.0.0.1:0") as daemon:
            url = daemon.urls[0]
            client = self.served(url, "one")
            for name in ("../secret", "/etc/passwd", "three", "one.yaml", "..", "a b"):
                with self.assertRaises(orrery.Refused) as refusal:
                    client.control("load", scenario=name)
                self.assertEqual(refusal.exception.code, ErrorCode.BAD_REQUEST)
            with self.assertRaises(orrery.Refused):
                client.control("start", scenario="two")
            client.control("load", t="2026-01-01T00:00:10", scenario="two")
            client.close()
            client = self.served(url, "two")
            self.assertEqual((client.time().state, client.time().t), (ClockState.STOPPED, orrery.from_text("2026-01-01T00:00:10")))
            self.assertEqual(next(client.poll_truth("2026-01-01T00:00:10")).answer, 0)
            self.assertEqual(client.control("start").state, ClockState.RUNNING)
            client.control("load", scenario="broken")
            client.close()
            self.served(url, "two").close()
            self.assertTrue(daemon.said("going back to"))
            port = int(re.findall(r"as text on tcp://127\.0\.0\.1:(\d+)", "".join(daemon.lines))[-1])
            with socket.create_connection(("127.0.0.1", port), 20) as text:
                text.sendall(b"SCEN:OPEN '../one'\nSYST:ERR?\nSCEN:OPEN one\nSYST:ERR?\n")
                lines = text.makefile("r", encoding="ascii")
                self.assertTrue(lines.readline().startswith("-222"))
                self.assertTrue(lines.readline().startswith("0,"))
            self.served(url, "one").close()
            self.assertEqual(daemon.stop(), 0)

    def write(self, path, title, lat):
        """A flight of two hours about now, so that the clock is inside of it. Written beside it and renamed, as editors do."""
        text = FLIGHT.format(title=title, start="2026-01-01T00:00:00").replace("duration: 60", "duration: 7200").replace("lat: 10", f"lat: {lat}")
        beside = path.with_suffix(".new")
        beside.write_text(text, encoding="utf-8")
        beside.rename(path)

    def test_read_again(self):
        path = WORK / "again.yaml"
        self.write(path, "first", 10)
        with Daemon(path, "-v", "--from", "2026-01-01T00:10:00") as daemon:
            url = daemon.urls[0]
            client = self.served(url, "first")
            path.write_text("title: second\ntrajectory: {kind: none}\n", encoding="utf-8")
            daemon.process.send_signal(signal.SIGHUP)
            self.assertTrue(daemon.said("[R11]"))
            self.assertRegex("".join(daemon.lines), r"again\.yaml:2:.*the scenario before is served on")
            self.assertEqual(client.caps.title, "first")
            client.ping()  # nobody was disconnected

            self.write(path, "second", 20)
            before = client.time()
            daemon.process.send_signal(signal.SIGHUP)
            other = self.served(url, "second")
            after = other.time()
            self.assertEqual((before.state, after.state), (ClockState.RUNNING, ClockState.RUNNING))
            # It goes on as it went: by the same reading of the host's clock.
            self.assertAlmostEqual((after.t - before.t) / 1e9, (after.host - before.host) / 1e9, delta=1e-6)
            with self.assertRaises((OSError, orrery.ProtocolError, orrery.Refused)):
                client.ping()
            # Files that are as they were: nobody is disconnected.
            said = sum("[R05]" in line for line in daemon.lines)
            daemon.process.send_signal(signal.SIGHUP)
            end = time.monotonic() + 20
            while sum("[R05]" in line for line in daemon.lines) == said and time.monotonic() < end:
                time.sleep(0.02)
            time.sleep(0.5)  # two sweeps of the service: by then it would have been exchanged
            other.ping()
            self.assertEqual(sum("[R10]" in line for line in daemon.lines), 1)
            client.close()
            other.close()
            # The end is the end, also while a scenario is read.
            self.write(path, "third", 30)
            daemon.process.send_signal(signal.SIGHUP)
            self.assertEqual(daemon.stop(), 0)

    def test_whole_answers_of_one(self):
        """Under load each answer is, byte for byte, that of the old scenario or that of the new one, and never the old after the new."""
        path = WORK / "swap.yaml"
        where = "2026-01-01T00:20:00"

        def ask(client):
            return [t.encode() for t in client.poll_truth(where, step_s=0.01, count=20)]

        wanted = []
        for lat in (10, 20):
            self.write(path, f"lat {lat}", lat)
            with Daemon(path) as daemon, orrery.Client(daemon.urls[0]) as client:
                wanted.append(ask(client))
        self.assertNotEqual(wanted[0], wanted[1])
        self.write(path, "lat 10", 10)
        with Daemon(path) as daemon:
            told, over = [[], []], threading.Event()

            def visit(mine):
                while not over.is_set():
                    try:
                        with orrery.Client(daemon.urls[0], timeout_s=30) as client:
                            while not over.is_set():
                                mine.append(ask(client))
                    except (OSError, orrery.ProtocolError, orrery.Refused):
                        time.sleep(0.01)  # closed between two answers: it comes again

            visitors = [threading.Thread(target=visit, args=(mine,), daemon=True) for mine in told]
            for v in visitors:
                v.start()
            end = time.monotonic() + 30
            while min(map(len, told)) < 3 and time.monotonic() < end:
                time.sleep(0.01)
            self.write(path, "lat 20", 20)
            daemon.process.send_signal(signal.SIGHUP)
            self.served(daemon.urls[0], "lat 20").close()
            have = [len(mine) for mine in told]
            while min(len(mine) - n for mine, n in zip(told, have)) < 3 and time.monotonic() < end:
                time.sleep(0.01)
            over.set()
            for v in visitors:
                v.join()
        for mine in told:
            which = [wanted.index(answer) for answer in mine]  # an answer that is neither's is not found
            self.assertEqual(which, sorted(which))
            self.assertEqual({0, 1}, set(which))

    def test_not_without_a_folder(self):
        with Daemon(product(), "--read-only", "--scenarios", self.folder) as daemon, orrery.Client(daemon.urls[0]) as client:
            with self.assertRaises(orrery.Refused) as refusal:
                client.control("load", scenario="one")
            self.assertEqual(refusal.exception.code, ErrorCode.NOT_PERMITTED)
        with Daemon(product()) as daemon, orrery.Client(daemon.urls[0]) as client:
            with self.assertRaises(orrery.Refused) as refusal:
                client.control("load", scenario="one")
            self.assertEqual(refusal.exception.code, ErrorCode.NOT_SERVED)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
