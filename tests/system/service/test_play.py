#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The samples that play a block: C and Python say the same, and it is what the table of true channels says of these instants."""
import csv
import os
import re
import shutil
import subprocess
import sys
import unittest

from daemon import FIRMWARE as PLAY, ORRERY, PATIENCE_S, ROOT, WORK, Daemon, product  # first: it sets the path

import orrery

NS = 10**9
SCENARIO = """
orbit: {product: day.nc}
navdata: {window: none}
ionosphere: {field: ionosphere.ION}
troposphere: {model: saastamoinen}
signals: ["G:L1CA", "E:E1", "R:L2OF", "G:L5"]
trajectory: {kind: survey, start: 2025-03-21T10:00:00, duration: 600, lat: 56, lon: 40, height: 1500, turbulence: {rms: 0.5}}
antennas: [{name: ROVE, up: 1}]
mask: {elevation: 0}
"""


class Play(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        product()
        shutil.copy(ROOT / "samples/ionosphere.ION", WORK)
        (WORK / "play.yaml").write_text(SCENARIO, encoding="utf-8")
        cls.daemon = Daemon(WORK / "play.yaml")
        cls.url = cls.daemon.urls[0]

    @classmethod
    def tearDownClass(cls):
        status = cls.daemon.stop()
        if status != 0:
            raise AssertionError(f"the service ended with {status}: {''.join(cls.daemon.lines)}")

    def by_c(self, first, sat, signal, count, step):
        host, port = re.match(r"tcp://(.*):(\d+)", self.url).groups()
        return subprocess.run([PLAY, host, port, str(first), sat[0], sat[1:], signal, str(count), str(step)], capture_output=True,
                              text=True, timeout=PATIENCE_S, check=False)

    def by_python(self, first, sat, signal, count, step):
        env = dict(os.environ, PYTHONPATH=str(ROOT / "proto/python"))
        return subprocess.run([sys.executable, "-B", ROOT / "samples/block/play.py", self.url, orrery.to_text(first), sat, signal,
                               "--count", str(count), "--step", str(step / NS)], env=env, capture_output=True, text=True,
                              timeout=PATIENCE_S, check=False)

    def test_both_say_what_the_table_of_channels_says(self):
        first, step, count = orrery.from_text("2025-03-21T10:01:40"), 37_000_000, 30  # many to a block, and past its ends
        done = subprocess.run([ORRERY, "simulate", WORK / "play.yaml", "-o", WORK / "run", "--no-imu", "--from",
                               orrery.to_text(first), "--to", "2025-03-21T10:01:42", "--truth-step", "0.037"], capture_output=True,
                              text=True, timeout=PATIENCE_S, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = {}
        for row in csv.DictReader((WORK / "run/ROVE-channels.csv").read_text(encoding="ascii").splitlines()):
            rows[orrery.from_text(row["t_gps"]), row["sat"], row["signal"]] = row
        rates = {"L1CA": (1.023e6, 1023), "E1": (1.023e6, 4092), "L2OF": (0.511e6, 511), "L5": (10.23e6, 10230)}
        seen = {(sat, signal) for t, sat, signal in rows if t == first}
        self.assertEqual({signal for _, signal in seen}, set(rates))
        for signal, (rate, length) in rates.items():
            sat = min(s for s, g in seen if g == signal)
            c, python = (by(first, sat, signal, count, step) for by in (self.by_c, self.by_python))
            self.assertEqual((c.returncode, python.returncode), (0, 0), c.stderr + python.stderr)
            self.assertEqual(c.stdout, python.stdout)
            lines = [line.split() for line in c.stdout.splitlines()]
            self.assertEqual(len(lines), count)
            for k, (t, chips, period, cycles, fraction) in enumerate(lines):
                row = rows[first + k * step, sat, signal]
                self.assertEqual(int(t), first + k * step)
                reading_s = 1e-9 * (int(row["transmit_gps_ns"]) % NS + float(row["transmit_fraction_ns"]))
                # 1e-5 m of the block's cubics are 3.4e-14 s; a second as a double 2e-16 s.
                off_s = (float(chips) + int(period) * length) / rate - reading_s
                self.assertAlmostEqual(off_s, 0, delta=1e-13)
                off = int(cycles) - int(row["carrier_cycles"]) + float(fraction) - float(row["carrier_fraction"])
                self.assertAlmostEqual(off, 0, delta=1e-4)

    def test_what_is_not_there_is_told(self):
        t = orrery.from_text("2025-03-21T10:01:40")
        for sat, signal, words in (("G99", "L1CA", "not in view"), ("G01", "L9", "no signal")):
            for done in (self.by_c(t, sat, signal, 1, NS), self.by_python(t, sat, signal, 1, NS)):
                self.assertEqual(done.returncode, 1)
                self.assertIn(words, done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
