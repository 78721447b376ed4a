#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What befalls a service in a laboratory, through which its answers stay the same bytes: its product deleted, cut or replaced, no descriptors
left, killed and started again under load, polls without end. A hundred thousand polls by default, ten million with ORRERY_LONG."""
import os
import resource
import signal
import socket
import sys
import threading
import time
import unittest

from daemon import PATIENCE_S, WORK, Daemon, product  # first: it sets the path

import orrery
from orrery.client import connect
from orrery.messages import Epochs, Poll, States

WHEN = "2025-03-21T12:00:00"
FAILED = (OSError, orrery.ProtocolError, orrery.Refused)
POLLS = 10000000 if os.environ.get("ORRERY_LONG") else 100000
BATCH = 250  # polls on the way at once: both sides' sockets hold them


def ask(client, count=20):
    return [m.encode() for m in client.poll(WHEN, step_s=0.5, count=count)]


def memory_kb(process):
    with open(f"/proc/{process.pid}/status", encoding="ascii") as f:
        return next(int(line.split()[1]) for line in f if line.startswith("VmRSS"))


class Endurance(unittest.TestCase):
    def test_product_is_deleted_cut_and_replaced(self):
        original = product().read_bytes()
        other = WORK / "other.nc"

        def truncate(path):
            with open(path, "r+b") as f:
                f.truncate(len(original) // 3)

        def replace(path):
            other.write_bytes(original[::-1])
            other.rename(path)

        for harm in (os.unlink, truncate, replace):
            with self.subTest(harm=harm.__name__):
                path = WORK / "served.nc"
                path.write_bytes(original)
                with Daemon(path) as daemon, orrery.Client(daemon.urls[0]) as client:
                    before = ask(client)
                    harm(path)
                    self.assertEqual(ask(client), before)
                    with orrery.Client(daemon.urls[0]) as newcomer:
                        self.assertEqual(ask(newcomer), before)
                    self.assertEqual(daemon.stop(), 0)

    def test_killed_and_started_again(self):
        """Clients that come again are told the same bytes by the new process, at the same address."""
        with socket.socket() as s:
            s.bind(("127.0.0.1", 0))
            port = s.getsockname()[1]
        told, over = [[] for _ in range(4)], threading.Event()
        url = f"tcp://127.0.0.1:{port}"

        def visit(mine):
            while not over.is_set():
                try:
                    with orrery.Client(url, timeout_s=PATIENCE_S) as client:
                        while not over.is_set():
                            mine.append(ask(client))
                except FAILED:
                    time.sleep(0.02)

        visitors = [threading.Thread(target=visit, args=(mine,), daemon=True) for mine in told]
        for v in visitors:
            v.start()
        try:
            for _ in range(3):
                have = [len(mine) for mine in told]
                with Daemon(product(), listen=(url,)) as daemon:
                    end = time.monotonic() + PATIENCE_S
                    while min(len(mine) - n for mine, n in zip(told, have)) < 3 and time.monotonic() < end:
                        time.sleep(0.01)
                    self.assertEqual(daemon.stop(signal.SIGKILL), -signal.SIGKILL)
                self.assertGreaterEqual(min(len(mine) - n for mine, n in zip(told, have)), 3, "somebody was not served again")
        finally:
            over.set()
        for v in visitors:
            v.join(PATIENCE_S)
        for mine in told:
            self.assertTrue(all(answer == told[0][0] for answer in mine))

    def test_no_descriptors_left(self):
        """Who was connected is served on; who comes when there is room again is served too."""
        before = resource.getrlimit(resource.RLIMIT_NOFILE)
        with Daemon(product()) as daemon, orrery.Client(daemon.urls[0]) as client:
            answer = ask(client)
            used = len(os.listdir(f"/proc/{daemon.process.pid}/fd"))
            resource.prlimit(daemon.process.pid, resource.RLIMIT_NOFILE, (used + 3, before[1]))
            host, port = daemon.urls[0][6:].rsplit(":", 1)
            crowd = [socket.create_connection((host, int(port)), PATIENCE_S) for _ in range(12)]
            self.assertTrue(daemon.said("[N01]"))
            self.assertEqual(ask(client), answer)
            for s in crowd:
                s.close()
            end = time.monotonic() + PATIENCE_S
            while True:
                try:
                    with orrery.Client(daemon.urls[0], timeout_s=5) as newcomer:
                        self.assertEqual(ask(newcomer), answer)
                    break
                except FAILED:
                    self.assertLess(time.monotonic(), end, "nobody is served any more")
                    time.sleep(0.05)
            self.assertEqual(daemon.stop(), 0)

    def test_memory_is_flat(self):
        """Within 1 MB, from when the first tenth has been answered; each poll a request of its own, each reply the same bytes."""
        with Daemon(product()) as daemon, orrery.Client(daemon.urls[0]) as client:
            request = Poll(Epochs(orrery.from_text(WHEN), 0, 1), [orrery.messages.SatId(ord("G"), 1)])
            reply = orrery.frame.make(States.TYPE, 1, client.states(WHEN, ["G01"]).encode())
            asked, told = BATCH * orrery.frame.make(Poll.TYPE, 1, request.encode()), BATCH * reply
            with connect(daemon.urls[0], PATIENCE_S) as s, s.makefile("rb", buffering=len(told)) as answers:

                def tenth():
                    for _ in range(POLLS // 10 // BATCH):
                        s.sendall(asked)
                        self.assertEqual(answers.read(len(told)), told)
                    return memory_kb(daemon.process)

                first = tenth()
                last = [tenth() for _ in range(9)]
            print(f"{POLLS} polls: {first} kB, then {last}")
            self.assertLess(max(last) - first, 1024, f"{first} kB, then {last}")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
