#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""orrery record, replay and watch: a log is the frames of a stream, given out again bit for bit, and what polls answer."""
import io
import json
import sys
import unittest

from daemon import ROOT, WORK, Served, orrery as run  # first: it sets the path

import orrery
from orrery import frame, messages
from test_streams import SCENARIO

NS = 10**9


class Record(Served):
    SCENARIO = SCENARIO
    OPTIONS = ("--from", "2025-03-21T10:02:00", "--motion")

    def record(self, name, *args):
        log = WORK / name
        done = run("record", self.url, "-o", log, *args)
        self.assertEqual(done.returncode, 0, done.stderr)
        return log

    def test_a_log_is_what_polls_answer(self):
        for name, args in (("channels.log", ("--channels", "--count", 40, "--free", "--from", "2025-03-21T10:03:00")),
                           ("paced.log", ("--step", 0.01, "--count", 30, "--lead", 0.1)),
                           ("truth.log", ("--truth", "--step", 0.5, "--count", 20, "--free"))):
            log = self.record(name, *args)
            done = run("replay", log, "--check", self.url)
            self.assertEqual((done.returncode, done.stderr), (0, ""), name)
            self.assertIn(" 0 unlike", done.stdout)

    def test_bit_for_bit_and_as_text(self):
        log = self.record("states.log", "--step", 1, "--count", 5, "--free", "--from", "2025-03-21T10:03:00")
        raw = __import__("subprocess").run([__import__("daemon").ORRERY, "replay", str(log), "--raw"], capture_output=True, check=True).stdout
        whole = log.read_bytes()
        self.assertTrue(whole.startswith(b"ORRYLOG1") and whole.endswith(raw))
        stream, kinds = io.BytesIO(raw), []
        while stream.tell() < len(raw):
            kinds.append(frame.read(stream.read).type)
        self.assertEqual(kinds, [messages.States.TYPE] * 5 + [messages.StreamEnd.TYPE])
        lines = [json.loads(x) for x in run("replay", log, "--format", "json").stdout.splitlines()]
        self.assertEqual([x["t_gps"] for x in lines], [f"2025-03-21T10:03:0{k}.000000000" for k in range(5)] if "." in lines[0]["t_gps"]
                         else [f"2025-03-21T10:03:0{k}" for k in range(5)])
        damaged = WORK / "damaged.log"
        damaged.write_bytes(whole[:200] + bytes([whole[200] ^ 1]) + whole[201:])
        for path, words in ((damaged, "damaged"), (ROOT / "README.md", "no log"), (WORK / "none", "cannot be opened")):
            done = run("replay", path)
            self.assertEqual(done.returncode, 1)
            self.assertIn(words, done.stderr)

    def test_watch(self):
        done = run("watch", self.url, "--count", 1, "--antenna", 1)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("running by the wall", done.stdout)
        self.assertIn("motion: 0 received", done.stdout)
        rows = [x.split() for x in done.stdout.splitlines() if x[:1] in "GRE" and x[1:3].isdigit()]
        self.assertGreater(len(rows), 2)
        for row in rows:
            self.assertTrue(0 <= float(row[3]) <= 90 and 30 < float(row[4]) < 60 and 1.8e7 < float(row[5]) < 3e7, row)
        self.assertEqual(done.stdout.count("\x1b"), 0)

    def test_usage(self):
        self.assertIn("--count", run("record", self.url).stderr)
        self.assertIn("can be streamed", run("record", self.url, "--elements", "--count", 1).stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
