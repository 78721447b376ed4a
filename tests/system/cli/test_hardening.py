# SPDX-License-Identifier: GPL-3.0-or-later
"""What the compiler and the linker were to put into the programs against errors that nobody has found, looked for in the built files; and
that a build does not tell where it was made."""
import platform
import pathlib
import re
import subprocess
import sys
import unittest

ORRERY, BUILD_TYPE, SANITIZE, SOURCE = sys.argv[1:5]
PROGRAMS = [p for p in (pathlib.Path(ORRERY), pathlib.Path(ORRERY).with_name("orrery-generator")) if p.exists()]
RELEASE = BUILD_TYPE == "Release" and not SANITIZE


def readelf(option, path):
    return subprocess.run(["readelf", "-W", option, path], capture_output=True, text=True, check=True).stdout


class Hardening(unittest.TestCase):
    def test_linked(self):
        """Independent of position, relocations read-only before main, no stack that can be executed."""
        for path in PROGRAMS:
            self.assertIn("Position-Independent Executable", readelf("-h", path))
            dynamic, segments = readelf("-d", path), readelf("-l", path)
            self.assertRegex(dynamic, r"BIND_NOW|FLAGS_1.*NOW")
            self.assertIn("GNU_RELRO", segments)
            self.assertRegex(segments, r"GNU_STACK.* RW ")
            self.assertNotRegex(segments, r"LOAD.* RWE ")
            self.assertNotRegex(dynamic, r"RPATH|RUNPATH")

    @unittest.skipUnless(RELEASE, "of a release build")
    def test_compiled(self):
        """Stack protector, FORTIFY_SOURCE, marks for CET."""
        for path in PROGRAMS:
            symbols = readelf("--dyn-syms", path)
            self.assertIn("__stack_chk_fail", symbols)
            self.assertRegex(symbols, r"__(memcpy|snprintf|vsnprintf|fprintf|printf)_chk")
            if platform.machine() == "x86_64":
                self.assertRegex(readelf("-n", path), r"IBT, SHSTK")

    @unittest.skipUnless(RELEASE, "of a release build")
    def test_no_paths(self):
        """No folder of the machine that built it."""
        for path in PROGRAMS:
            self.assertIsNone(re.search(re.escape(SOURCE.encode()), path.read_bytes()))


if __name__ == "__main__":
    unittest.main(argv=["test_hardening"])
