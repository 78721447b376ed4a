#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""CONTROL LOAD: another scenario by its name, from one folder alone; one that cannot be served leads back to the one before."""
import re
import socket
import sys
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
