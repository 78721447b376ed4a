#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Products as others read them: each opens in xarray with its times decoded; and the batch command gives what the service
answers."""
import csv
import datetime
import json
import os
import pathlib
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "service"))
from daemon import ROOT, WORK, Daemon, orrery  # noqa: E402

import orrery as client_package  # noqa: E402

SAMPLES = ROOT / "samples"
SP3 = SAMPLES / "ORR0TSTFIN_20250800000_01D_05M_ORB.SP3.gz"
ION = SAMPLES / "ionosphere.ION"
DAY = pathlib.Path(os.environ.get("ORRERY_DATA", "")) / "2024-035"

# Run by the interpreter that has xarray: what each file's variables of time begin with, and its product.
READER = """
import json, sys, xarray
told = {}
for path in sys.argv[1:]:
    with xarray.open_dataset(path) as data:
        data.load()
        told[path] = {"product": data.attrs.get("product"), "conventions": data.attrs["Conventions"], "sizes": dict(data.sizes),
                      "times": {k: str(v.values.min()) for k, v in data.variables.items() if v.dtype.kind == "M" and v.size}}
print(json.dumps(told))
"""


def with_xarray():
    """The system's Python, whose packages come with the distribution, or this one."""
    for python in ("/usr/bin/python3", sys.executable):
        if subprocess.run([python, "-c", "import xarray, netCDF4"], capture_output=True, check=False).returncode == 0:
            return python
    return None


class Products(unittest.TestCase):
    def made(self, path, *args):
        if not path.exists():
            done = orrery(*args, "-o", path)
            self.assertEqual(done.returncode, 0, done.stderr)
        return path

    def orbit(self):
        return self.made(WORK / "sample.nc", "orbit", SP3)

    def sky(self):
        return self.made(WORK / "sky.nc", "delays", self.orbit(), "--field", ION, "--receiver", "52.28,17.07,124", "--step", 1800,
                         "--from", "2025-03-21T08:00", "--to", "2025-03-21T12:00")

    def test_xarray(self):
        python = with_xarray()
        if python is None:
            self.skipTest("python3-xarray is not installed")
        paths = [self.orbit(), self.sky(),
                 self.made(WORK / "elements.nc", "elements", self.orbit(), "--sat", "G05", "--step", 900, "--format", "nc"),
                 self.made(WORK / "imu.nc", "imu", SAMPLES / "survey.yaml", "--duration", 60)]
        if DAY.exists():
            paths.append(self.made(WORK / "xsession.nc", "iono", DAY / "BOR100POL_R_20240350000_01D_30S_MO.crx.gz", "--field",
                                   DAY / "COD0OPSFIN_20240350000_01D_01H_GIM.INX.gz", "--orbit",
                                   DAY / "BRDC00CNE_R_20240350000_01D_GN.rnx.gz", "--sat", "G", "--to", "2024-02-04T02:00", "-q"))
        done = subprocess.run([python, "-c", READER, *map(str, paths)], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        told = json.loads(done.stdout)
        want = {"sample.nc": ("arc_start", "2025-03-2"), "sky.nc": ("time", "2025-03-21T08:00:00"),
                "elements.nc": ("time", "2025-03-2"), "xsession.nc": ("t", "2024-02-04T00:00:00")}
        for path in paths:
            got = told[str(path)]
            self.assertTrue(got["conventions"].startswith("CF-"), path)
            if path.name in want:
                name, start = want[path.name]
                self.assertTrue(got["times"][name].startswith(start), got["times"])

    def test_batch_is_what_the_service_answers(self):
        table = self.made(WORK / "sky.csv", "delays", self.orbit(), "--field", ION, "--receiver", "52.28,17.07,124", "--step", 1800,
                          "--from", "2025-03-21T08:00", "--to", "2025-03-21T12:00")
        with open(table, newline="", encoding="utf-8") as f:
            rows = list(csv.DictReader(f))
        self.assertGreater(len(rows), 9 * 15)
        scenario = WORK / "sky.yaml"
        scenario.write_text(f"orbit: {{product: {self.orbit()}}}\nnavdata: {{window: none}}\nionosphere: {{field: {ION}}}\n"
                            "receiver: {position: [52.28, 17.07, 124]}\n")
        seen = 0
        with Daemon(scenario) as d, client_package.Client(d.urls[0]) as c:
            for t in sorted({r["t_gps"] for r in rows}):
                answer = {client_package.client.sat_name(s.sat): s for s in c.delays(t).satellites if s.answer == 0}
                here = [r for r in rows if r["t_gps"] == t]
                self.assertEqual({r["sat"] for r in here}, set(answer))
                for r in here:
                    self.assertAlmostEqual(float(r["stec_tecu"]), answer[r["sat"]].stec_tecu, places=4)
                    self.assertAlmostEqual(float(r["delay_m"]), 40.3e16 / 1575.42e6**2 * answer[r["sat"]].stec_tecu, places=4)
                    self.assertTrue(1.9e7 < float(r["range_m"]) < 4.3e7)
                    seen += 1
        self.assertEqual(seen, len(rows))
        # A scenario says the same as the options; its flight is followed.
        again = orrery("delays", scenario, "--step", 1800, "--from", "2025-03-21T08:00", "--to", "2025-03-21T12:00")
        self.assertEqual(again.stdout, table.read_text(encoding="utf-8"))
        flight = orrery("delays", SAMPLES / "gravimetry-flight.yaml", "--step", 600)
        self.assertEqual(flight.returncode, 0, flight.stderr)
        times = [datetime.datetime.fromisoformat(r["t_gps"]) for r in csv.DictReader(flight.stdout.splitlines())]
        self.assertGreater(len(set(times)), 2)

    def test_refusals(self):
        for words, *args in (["where is the receiver?", self.orbit(), "--field", ION], ["no ionosphere", SAMPLES / "survey.yaml"],
                             ["do not cover", self.orbit(), "--field", ION, "--receiver", "0,0,0", "--from", "2031-01-01T00:00",
                              "--to", "2031-01-01T01:00"]):
            done = orrery("delays", *args)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn(words, done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
