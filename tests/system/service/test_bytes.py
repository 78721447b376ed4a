# SPDX-License-Identifier: GPL-3.0-or-later
"""What docs/protocol.md promises about bytes on other machines: the same product evaluated with glibc's functions for processors without
FMA, on this machine."""
import os
import platform
import unittest

from daemon import Daemon, product

import orrery as client

OTHER = "glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4,-AVX2_Usable,-FMA_Usable"


def frames(request, answer):
    """The bytes of a series of answers, from a service with these processor functions and one with those."""
    told = []
    for tunables in (None, OTHER):
        before = os.environ.pop("GLIBC_TUNABLES", None)
        try:
            if tunables:
                os.environ["GLIBC_TUNABLES"] = tunables
            with Daemon(product()) as daemon, client.Client(daemon.urls[0]) as c:
                told.append([m for m in c._answers(request, answer, 200)])
        finally:
            os.environ.pop("GLIBC_TUNABLES", None)
            if before is not None:
                os.environ["GLIBC_TUNABLES"] = before
    return told


@unittest.skipUnless(platform.machine() == "x86_64" and platform.libc_ver()[0] == "glibc", "glibc on x86-64 has such variants")
class Bytes(unittest.TestCase):
    def epochs(self):
        return client.messages.Epochs(client.from_text("2025-03-21T06:00:00"), 60 * 10**9, 200)

    def test_states(self):
        """STATES: the same to the bit."""
        one, two = frames(client.messages.Poll(self.epochs(), []), client.messages.States)
        self.assertEqual([m.encode() for m in one], [m.encode() for m in two])

    def test_elements(self):
        """ELEMENTS pass through sines and arctangents: last digits, nothing that could be seen."""
        one, two = frames(client.messages.PollElements(self.epochs()), client.messages.Elements)
        for a, b in zip(one, two):
            for x, y in zip(a.satellites, b.satellites):
                self.assertEqual((x.sat, x.answer), (y.sat, y.answer))
                self.assertAlmostEqual(x.a_m, y.a_m, delta=1e-6)
                self.assertAlmostEqual(x.u_rad, y.u_rad, delta=1e-13)
                self.assertAlmostEqual(x.i_rad, y.i_rad, delta=1e-13)


if __name__ == "__main__":
    unittest.main(argv=["test_bytes"])
