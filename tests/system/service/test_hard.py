#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Hard use for ORRERY_HARD_S seconds (2 by default; a minute, ten minutes and an hour beside stress-ng by ./check --long): 64 clients at 100 Hz
whose every reply is compared, beside others who connect by the thousand, send garbage as fast as they can, send half a frame, nothing at all, or
read nothing; and a stream of 1 kHz of which no block is missed."""
import collections
import contextlib
import heapq
import os
import random
import resource
import select
import socket
import sys
import threading
import time
import unittest

from daemon import PATIENCE_S, Shared  # first: it sets the path

import orrery
from orrery import frame, messages
from orrery.client import connect

SECONDS = float(os.environ.get("ORRERY_HARD_S", "2"))
CLIENTS, RATE_HZ, QUESTIONS = 64, 100, 40
WHEN = orrery.from_text("2025-03-21T12:00:00")
NS = 10**9


def questions(url):
    """Polls of one epoch each, and the bytes that answer them, asked of a client alone."""
    asked = []
    with orrery.Client(url, timeout_s=PATIENCE_S) as client:
        for k in range(QUESTIONS):
            poll = messages.Poll(messages.Epochs(WHEN + k * 77 * NS // 10, 0, 1), [orrery.sat_id(s) for s in client.satellites[:k % 10]])
            reply = next(client._answers(poll, messages.States, 1)).encode()
            asked.append((frame.make(messages.Poll.TYPE, k + 1, poll.encode()), frame.make(messages.States.TYPE, k + 1, reply)))
    return asked


class Rude:
    """Peers who behave badly, all through the block: `with Rude(url):`."""

    def __init__(self, url):
        host, port = url[6:].rsplit(":", 1)
        self.place, self.url, self.over = (host, int(port)), url, threading.Event()
        self.held, self.connected = contextlib.ExitStack(), 0
        self.threads = [threading.Thread(target=t, daemon=True) for t in (self.garbage, self.thousand, self.half_a_frame)]

    def __enter__(self):
        for _ in range(4):  # eight streams of which nothing is read
            client = self.held.enter_context(orrery.Client(self.url, timeout_s=PATIENCE_S))
            for _ in range(2):
                client.subscribe(messages.Poll(), WHEN, 0.001, credit=100000, pacing="free")
        for t in self.threads:
            t.start()
        return self

    def __exit__(self, *_):
        self.over.set()
        for t in self.threads:
            t.join(PATIENCE_S)
        self.held.close()

    def garbage(self):
        bytes_ = random.Random(1).randbytes(1 << 16)
        while not self.over.is_set():
            with contextlib.suppress(OSError), socket.create_connection(self.place, PATIENCE_S) as s:
                for k in range(64):  # the first wrong byte closes it: sometimes the wrong bytes come behind a right header
                    s.sendall((b"ORRY\1\0\6\0\1\0\0\0\34\0\0\0" if k == 0 and bytes_[self.connected % 999] & 1 else b"") + bytes_)
            self.connected += 1
            time.sleep(0.001)

    def thousand(self):
        """A thousand connections that say nothing, opened again as they are closed."""
        mine = collections.deque()
        while not self.over.is_set():
            with contextlib.suppress(OSError):
                mine.append(socket.create_connection(self.place, PATIENCE_S))
                self.connected += 1
            if len(mine) > 1000:
                mine.popleft().close()
            if len(mine) % 50 == 0:
                time.sleep(0.01)
        for s in mine:
            s.close()

    def half_a_frame(self):
        poll = frame.make(messages.Poll.TYPE, 1, messages.Poll(messages.Epochs(WHEN, 0, 1), []).encode())
        mine = []
        with contextlib.suppress(OSError):
            mine = [socket.create_connection(self.place, PATIENCE_S) for _ in range(20)]
        at = 0
        while not self.over.wait(0.05) and at < len(poll) - 1:
            for s in mine:
                with contextlib.suppress(OSError):
                    s.send(poll[at:at + 1])
            at += 1
        for s in mine:
            s.close()


class Crowd:
    """Clients in one loop, each asking at its rate whatever the others do, and told what it ought to be told."""

    def __init__(self, url, asked):
        self.asked, self.replies, self.wrong, self.lost = asked, 0, 0, 0
        self.socks = [connect(url, PATIENCE_S) for _ in range(CLIENTS)]
        self.waiting = {s: collections.deque() for s in self.socks}
        self.read = {s: b"" for s in self.socks}
        self.latest_s = 0.0

    def run(self, seconds):
        begin = time.monotonic()
        due = [(begin + k / CLIENTS / RATE_HZ, k, 0) for k in range(CLIENTS)]
        count = int(seconds * RATE_HZ)
        poll = select.poll()
        by_fd = {s.fileno(): s for s in self.socks}
        for fd in by_fd:
            poll.register(fd, select.POLLIN)
        heard = time.monotonic()
        while due or any(self.waiting.values()):
            now = time.monotonic()
            while due and due[0][0] <= now:
                at, k, n = heapq.heappop(due)
                question, answer = self.asked[(k * 7 + n) % QUESTIONS]
                self.waiting[self.socks[k]].append((answer, at))
                self.socks[k].sendall(question)
                if n + 1 < count:
                    heapq.heappush(due, (at + 1 / RATE_HZ, k, n + 1))
            for fd, _ in poll.poll(max(0.0, 1e3 * (due[0][0] - now)) if due else 100):
                self.take(by_fd[fd])
                heard = time.monotonic()
            if time.monotonic() - heard > PATIENCE_S:
                raise AssertionError(f"{sum(map(len, self.waiting.values()))} polls are not answered")
        for s in self.socks:
            s.close()

    def take(self, s):
        data = s.recv(1 << 16)
        if not data:
            raise AssertionError("a client that asked well was closed")
        self.read[s] += data
        waiting = self.waiting[s]
        while waiting and len(self.read[s]) >= len(waiting[0][0]):
            answer, at = waiting.popleft()
            self.wrong += not self.read[s].startswith(answer)
            self.read[s] = self.read[s][len(answer):]
            self.replies += 1
            self.latest_s = max(self.latest_s, time.monotonic() - at)


class Hard(Shared):
    @classmethod
    def setUpClass(cls):
        soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
        resource.setrlimit(resource.RLIMIT_NOFILE, (min(hard, max(soft, 4096)), hard))
        super().setUpClass()

    def test_crowd_among_the_rude(self):
        asked = questions(self.url)
        crowd = Crowd(self.url, asked)
        with Rude(self.url) as rude:
            crowd.run(SECONDS)
        print(f"{crowd.replies} replies to {CLIENTS} clients at {RATE_HZ} Hz for {SECONDS:g} s, {crowd.wrong} wrong, the latest {1e3 * crowd.latest_s:.0f} ms "
              f"after it was due; {rude.connected} connections of others")
        self.assertEqual(crowd.replies, CLIENTS * int(SECONDS * RATE_HZ))
        self.assertEqual(crowd.wrong, 0)
        self.assertGreater(rude.connected, 50)
        with orrery.Client(self.url, timeout_s=PATIENCE_S) as client:  # who comes afterwards is served
            client.ping(1)

    def test_no_block_is_missed(self):
        """At 1 kHz, paced by the clock, 20 ms ahead: every instant once and in order."""
        with orrery.Client(self.url, timeout_s=PATIENCE_S) as client:
            stream = client.subscribe(messages.Poll(messages.Epochs(), [orrery.sat_id("G01")]), None, 0.001, lead_s=0.02, credit=20000)
            begin, last, blocks = time.monotonic(), stream.next().t, int(1000 * SECONDS)
            for _ in range(blocks):  # as many as the seconds have: a machine that is busy may hand some of them over late
                t = stream.next().t
                self.assertEqual(t - last, NS // 1000)
                last = t
            print(f"{blocks} blocks at 1 kHz in {time.monotonic() - begin:.2f} s, {stream.lost} lost")
            self.assertEqual(stream.lost, 0)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
