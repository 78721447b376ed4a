#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every kind of NetCDF file that the program writes keeps the rules of the CF conventions (cf_rules.py), and xarray opens it."""
import pathlib
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import Folder, run, sample  # noqa: E402

RULES = pathlib.Path(__file__).with_name("cf_rules.py")
DAY = "ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"


class Conventions(Folder):
    def rules(self, *args):
        python = next((p for p in ("/usr/bin/python3", sys.executable)
                       if subprocess.run([p, "-c", "import xarray, netCDF4"], capture_output=True, check=False).returncode == 0), None)
        if python is None or shutil.which("udunits2") is None:
            self.skipTest("python3-xarray, python3-netcdf4 or udunits-bin is not installed")
        return subprocess.run([python, str(RULES), *map(str, args)], capture_output=True, text=True, check=True).stdout

    def test_every_kind_of_file(self):
        made = {name: pathlib.Path(self.path(name + ".nc")) for name in ("orbit", "states", "elements", "delays", "readings", "session", "study")}
        run("orbit", "-q", "-o", made["orbit"], "--sat", "G01-G05,E01,E02", sample(DAY))
        run("states", made["orbit"], "--step", "900", "--format", "netcdf", "-o", made["states"])
        run("elements", made["orbit"], "--step", "900", "--format", "nc", "-o", made["elements"])
        run("delays", made["orbit"], "--field", sample("ionosphere.ION"), "--receiver", "52,17,100", "--step", "900", "-o", made["delays"])
        run("imu", sample("still.yaml"), "-q", "-o", made["readings"])
        run("aiding", sample("studies/aiding.yaml"), "-q", "-o", made["study"])
        scene = pathlib.Path(self.path("scene.yaml"))
        scene.write_text(f"orbit: {{product: {made['orbit']}}}\nionosphere: {{field: {sample('ionosphere.ION')}}}\nsignals: [G:L1CA, G:L5]\n"
                         "antennas: [{name: BASE, position: [52, 17, 100]}]\nmask: {elevation: 5}\n", encoding="utf-8")
        run("simulate", scene, "-q", "-o", self.path("seen"), "--no-imu", "--step", "120s", "--from", "2025-03-21T09:00:00", "--to", "2025-03-21T11:00:00")
        run("iono", pathlib.Path(self.path("seen")) / "BASE.rnx", "-q", "--field", sample("ionosphere.ION"), "--orbit", made["orbit"], "-o", made["session"])
        self.assertEqual(self.rules(*made.values()), "")

    def test_a_breach_is_found(self):
        """The judge is judged: a breach of each rule, planted in a good file, is told."""
        good = self.path("good.nc")
        run("orbit", "-q", "-o", good, "--sat", "G01-G05", sample(DAY))
        told = self.rules("--plant", good).splitlines()
        self.assertEqual(len(told), 8)
        for line in told:
            self.assertRegex(line, r"^[\d.]+ found$")


if __name__ == "__main__":
    import unittest
    unittest.main(argv=[__file__])
