#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Products of every version that was released are read for ever, and tell what they told. A file here is added with a version, never replaced."""
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "system"))
from program import Folder, run  # noqa: E402


class Products(Folder):
    def test_orbits(self):
        files = sorted(HERE.glob("orbit-*.nc"))
        self.assertEqual([f.name for f in files], [f"orbit-{k + 1}.nc" for k in range(len(files))])  # none was taken away
        for file in files:
            told = run("states", file, "--step", "1777").stdout.splitlines()
            kept = file.with_suffix(".csv").read_text(encoding="ascii").splitlines()
            self.assertEqual(told[0], kept[0])
            self.assertEqual(len(told), len(kept))
            for a, b in zip(told[1:], kept[1:]):
                a, b = a.split(","), b.split(",")
                self.assertEqual(a[:2], b[:2])
                for x, y in zip(a[2:], b[2:]):  # to the last digit that is printed, for other processors' sake
                    self.assertAlmostEqual(float(x or 0), float(y or 0), delta=2.5 * 10.0 ** -len(y.partition(".")[2]))

    def test_readings(self):
        for file in sorted(HERE.glob("readings-*.nc")):
            told = run("export", file, "--to", "pyins").stdout
            self.assertEqual(told, file.with_suffix(".csv").read_text(encoding="ascii"))

    def test_later_versions_are_refused_by_name(self):
        if shutil.which("ncgen") is None:
            self.skipTest("netcdf-bin is not installed")
        newest = sorted(HERE.glob("orbit-*.nc"))[-1]
        text = subprocess.run(["ncdump", newest], capture_output=True, text=True, check=True).stdout
        for version, words in (("99LL", "of version 99, which a newer program has made"), ("0LL", "of version 0; this program reads versions 1 to")):
            other = self.path("other.nc")
            cdl = text.replace(":product_version = 1LL", f":product_version = {version}")
            self.assertNotEqual(cdl, text)
            subprocess.run(["ncgen", "-4", "-o", other, "-"], input=cdl, text=True, check=True)
            self.assertIn(words, run("states", other, status=1).stderr)


if __name__ == "__main__":
    import unittest
    unittest.main()
