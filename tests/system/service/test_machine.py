#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What serve asks of the machine: a real-time priority and a processor for the thread that makes blocks, and that alone, and memory that
stays; read back from the kernel. Where the machine does not permit it, a sentence that says what to do."""
import os
import pathlib
import re
import resource
import subprocess
import sys
import unittest

from daemon import ORRERY, PATIENCE_S, Daemon, product  # first: it sets the path

import orrery
from orrery import messages


def may_be_real_time():
    return subprocess.run(["chrt", "-f", "1", "true"], capture_output=True, check=False).returncode == 0


def has_sanitizer():
    """Sanitizers make nothing of mlockall."""
    program = pathlib.Path(ORRERY).read_bytes()
    return b"__asan_init" in program or b"__tsan_init" in program


def without_rights():
    """In the child: no limits that permit anything."""
    resource.setrlimit(resource.RLIMIT_RTPRIO, (0, 0))
    resource.setrlimit(resource.RLIMIT_MEMLOCK, (65536, 65536))


class Machine(unittest.TestCase):
    def serve(self, *args):
        daemon = Daemon(product(), *map(str, args))
        self.addCleanup(lambda: self.assertEqual(daemon.stop(), 0, daemon.lines))
        with orrery.Client(daemon.urls[0]) as client:  # and it streams
            for _ in range(2):
                self.assertIsNotNone(client.subscribe(messages.Poll(), None, 0.01, credit=10).next())
        return daemon.process.pid

    def refused(self, words, *args, rights=True):
        # Root keeps its rights unless they leave the set that a program may have.
        drop = ["setpriv", "--bounding-set=-sys_nice,-ipc_lock"] if not rights and os.geteuid() == 0 else []
        done = subprocess.run([*drop, ORRERY, "serve", str(product()), "--listen", "tcp://127.0.0.1:0", *args], capture_output=True, text=True,
                              timeout=PATIENCE_S, check=False, preexec_fn=None if rights else without_rights)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn(words, done.stderr)
        self.assertNotIn("ready", done.stderr)

    @staticmethod
    def threads(pid):
        return [int(p.name) for p in pathlib.Path(f"/proc/{pid}/task").iterdir()]

    @staticmethod
    def locked_kb(pid):
        return int(re.search(r"VmLck:\s*(\d+)", pathlib.Path(f"/proc/{pid}/status").read_text(encoding="ascii")).group(1))

    def test_processor(self):
        mine = os.sched_getaffinity(0)
        if len(mine) < 2:
            self.skipTest("one processor: any thread runs on that")
        wanted = max(mine)
        pid = self.serve("--processor", wanted)
        where = [os.sched_getaffinity(t) for t in self.threads(pid)]
        self.assertEqual(where.count({wanted}), 1)
        self.assertEqual(where.count(mine), len(where) - 1)
        self.assertEqual(self.locked_kb(pid), 0)
        self.assertEqual({os.sched_getscheduler(t) for t in self.threads(pid)}, {os.SCHED_OTHER})
        self.refused("no such processor", "--processor", "1023")

    def test_priority(self):
        if not may_be_real_time():
            self.skipTest("this machine permits no real-time priority")
        pid = self.serve("--priority", 7)
        how = [(os.sched_getscheduler(t), os.sched_getparam(t).sched_priority) for t in self.threads(pid)]
        self.assertEqual(how.count((os.SCHED_FIFO, 7)), 1)
        self.assertEqual(how.count((os.SCHED_OTHER, 0)), len(how) - 1)

    def test_locked_memory(self):
        if has_sanitizer():
            self.skipTest("a sanitizer locks no memory")
        soft, _ = resource.getrlimit(resource.RLIMIT_MEMLOCK)
        if os.geteuid() != 0 and soft != resource.RLIM_INFINITY:
            self.skipTest("this user may not lock memory")
        pid = self.serve("--lock-memory")
        text = pathlib.Path(f"/proc/{pid}/status").read_text(encoding="ascii")
        resident = int(re.search(r"VmRSS:\s*(\d+)", text).group(1))
        self.assertGreater(self.locked_kb(pid), 0.9 * resident)

    def test_without_the_right(self):
        self.refused("SCHED_FIFO is not permitted (raise the limit: ulimit -r, or CAP_SYS_NICE)", "--priority", "7", rights=False)
        if not has_sanitizer():
            self.refused("memory cannot be locked (raise the limit: ulimit -l, or CAP_IPC_LOCK)", "--lock-memory", rights=False)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
