#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python client against a real service: answers in any order, a connection that is lost, times as the program reads them."""
import datetime
import itertools
import logging
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from daemon import ORRERY, PATIENCE_S, ROOT, WORK, Daemon, Shared, product  # first: it sets the path

import orrery
from orrery import gpstime, messages

NS = 10**9


class Answers(Shared):
    def test_a_series_may_be_left_early(self):
        with orrery.Client(self.url) as c, orrery.Client(self.url) as other:
            t = c.span[0]
            left = c.poll(t, 1.0, 400)
            first = [next(left) for _ in range(3)]
            left.close()
            self.assertEqual([s.epoch.index for s in first], [0, 1, 2])
            c.ping(7)
            self.assertEqual(c.states(t + 5 * NS), other.states(t + 5 * NS))

    def test_two_series_at_once(self):
        with orrery.Client(self.url) as c:
            t = c.span[0]
            pairs = list(zip(c.poll(t, 1.0, 20, ["G01"]), c.poll(t + 3600 * NS, 2.0, 20, ["E02"])))
            self.assertEqual([a.t for a, _ in pairs], [t + k * NS for k in range(20)])
            self.assertEqual([b.t for _, b in pairs], [t + (3600 + 2 * k) * NS for k in range(20)])
            self.assertEqual({str(s.sat) for a, b in pairs for s in a.satellites + b.satellites}, {"G01", "E02"})

    def test_a_long_series_is_one_series(self):
        with orrery.Client(self.url) as c:
            got = list(c.poll(c.span[0], 0.1, 1203, ["G02"]))
            self.assertEqual([(s.epoch.index, s.epoch.count) for s in got], [(k, 1203) for k in range(1203)])
            self.assertEqual([s.t for s in got], [c.span[0] + k * NS // 10 for k in range(1203)])

    def test_records_are_values(self):
        with orrery.Client(self.url) as c:
            a, b = c.states(c.span[0], ["G01"]), c.states(c.span[0], ["G01"])
            self.assertEqual(a, b)
            self.assertIn("States(", repr(a))
            self.assertIs(a.satellites[0].answer, orrery.Answer.OK)
            self.assertIsInstance(a.satellites[0].flags, orrery.StateFlags)
            b.satellites[0].pos_m[0] += 1.0
            self.assertNotEqual(a, b)

    def test_a_refusal_leaves_the_connection_usable(self):
        with orrery.Client(self.url) as c:
            with self.assertRaises(orrery.Refused):
                next(c.poll_truth(c.span[0]))
            c.ping()


class Reconnecting(unittest.TestCase):
    def setUp(self):
        logging.disable(logging.CRITICAL)
        self.addCleanup(logging.disable, logging.NOTSET)

    def test_a_service_that_starts_again(self):
        where = f"unix:{WORK}/again.sock"
        daemon, waited = Daemon(product(), listen=(where,)), []
        with orrery.Client(where) as c:
            whole = [s.encode()[16:] for s in c.poll(c.span[0], 1.0, 1100)]

        def sleep(seconds):
            nonlocal daemon
            waited.append(seconds)
            if len(waited) == 2:
                daemon = Daemon(product(), listen=(where,))

        with orrery.ReconnectingClient(where, sleep=sleep) as c:
            series = c.poll(c.span[0], 1.0, 1100)
            got = list(itertools.islice(series, 10))
            daemon.process.kill()
            daemon.process.wait()
            got += series
        daemon.stop()
        self.assertGreaterEqual(len(waited), 2)
        self.assertEqual([s.epoch.index for s in got], list(range(1100)))
        self.assertEqual([s.encode()[16:] for s in got], whole)  # but for index and count, which stand before

    def test_attempts_are_bounded(self):
        waited = []
        with orrery.ReconnectingClient(f"unix:{WORK}/nobody.sock", attempts=4, sleep=waited.append) as c:
            with self.assertRaises(OSError):
                c.ping()
        self.assertEqual(len(waited), 3)
        for k, seconds in enumerate(waited):
            self.assertTrue(0.05 * 2**k <= seconds <= 0.1 * 2**k)


class Times(unittest.TestCase):
    def test_the_table_of_leap_seconds_is_the_programs(self):
        text = (ROOT / "core/leap.c").read_text(encoding="utf-8")
        table = tuple((int(a), int(b)) for a, b in re.findall(r"\{(\d{5}), (\d+)\}", text))
        self.assertEqual(gpstime.LEAP_SECONDS, table)

    def test_texts_mean_what_the_program_says(self):
        """states --from prints the instant that it understood, in GPS time."""
        for text in ("2025-03-21", "2025-03-21T12:00", "2025-03-21T12:00:00.25", "2025-03-21T12:00:00Z", "2025-03-21 12:00:00 UTC",
                     "2025-080T12:00", "2358:475200.5", "2025-03-21T12:00:00 TAI", "2025-03-21T12:00:00 BDT", "2025-03-21T12:00:00 TT"):
            with self.subTest(text=text):
                done = subprocess.run([ORRERY, "states", "-q", str(product()), "--from", text, "--to", text, "--sat", "G01"],
                                      capture_output=True, text=True, timeout=PATIENCE_S, check=True)
                rows = [line for line in done.stdout.splitlines() if line and line[0].isdigit()]
                self.assertEqual(len(rows), 1, done.stdout)
                self.assertEqual(gpstime.from_text(rows[0].split(",")[0]), gpstime.from_text(text))

    def test_there_and_back(self):
        for t in (0, 1, -1, 10**18 + 123456789, 1167264017 * NS, 1167264016 * NS + 5):
            self.assertEqual(gpstime.from_text(gpstime.to_text(t)), t)
            self.assertEqual(gpstime.from_text(gpstime.to_text(t, "UTC")), t)
        self.assertEqual(gpstime.to_text(gpstime.from_text("2016-12-31T23:59:60Z"), "UTC"), "2016-12-31T23:59:60Z")
        aware = datetime.datetime(2024, 2, 4, 15, tzinfo=datetime.timezone(datetime.timedelta(hours=3)))
        self.assertEqual(gpstime.time_tag(aware), gpstime.from_text("2024-02-04T12:00:00Z"))

    def test_what_is_no_time(self):
        for text in ("", "noon", "2024-02-30", "2023-366T00", "2024-02-04T25:00", "2017-06-30T23:59:60Z", "2024-02-04T12:00 XYZ",
                     "2300:604800"):
            with self.subTest(text=text), self.assertRaises(ValueError):
                gpstime.from_text(text)


class Package(unittest.TestCase):
    def test_installed_without_network(self):
        """The folder that `cmake --install` copies is the whole package."""
        with tempfile.TemporaryDirectory() as folder:
            code = "import orrery, sys; print(orrery.__version__, orrery.__file__.startswith(sys.argv[1]))"
            (pathlib.Path(folder) / "orrery").symlink_to(ROOT / "proto/python/orrery")
            done = subprocess.run([sys.executable, "-B", "-I", "-c", f"import sys; sys.path.insert(0, sys.argv[1]); {code}", folder],
                                  capture_output=True, text=True, timeout=PATIENCE_S, check=True)
        version = re.search(r"project\(orrery VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")).group(1)
        self.assertEqual(done.stdout.split(), [version, "True"])
        self.assertTrue((ROOT / "proto/python/orrery/py.typed").exists())
        self.assertEqual(messages.MAJOR, 1)


if __name__ == "__main__":
    unittest.main(argv=["test_python"])
