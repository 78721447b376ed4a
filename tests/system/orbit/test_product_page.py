# SPDX-License-Identifier: GPL-3.0-or-later
"""The page docs/product.md says how to evaluate a product by hand: its own Python against the program."""
import csv
import io
import pathlib
import re
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import ROOT, Folder, run, sample  # noqa: E402


def dump(path):
    """Variables and numeric global attributes of a NetCDF file as nested lists, through ncdump."""
    text = subprocess.run(["ncdump", "-p", "9,17", path], capture_output=True, text=True, check=True).stdout
    head, body = text.split("\ndata:\n")
    dims = {k: int(v) for k, v in re.findall(r"^\t(\w+) = (\d+) ;", head, re.M)}
    shapes = {k: [dims[d.strip()] for d in v.split(",")] for k, v in re.findall(r"^\t\w+ (\w+)\(([^)]*)\) ;", head, re.M)}
    out = {k: float(v) for k, v in re.findall(r"^\t\t:(\w+) = (-?[\d.e+-]+)L* ;", head, re.M)}
    for name, values in re.findall(r"^ (\w+) =(.*?) ;$", body, re.M | re.S):
        if '"' in values:
            out[name] = re.findall(r'"([^"]*)"', values)
            continue
        items = [v.strip() for v in values.split(",")]
        flat = [float(v) if re.search(r"[.en]", v) else int(v) for v in items]
        for n in reversed(shapes[name][1:]):
            flat = [flat[i:i + n] for i in range(0, len(flat), n)]
        out[name] = flat
    return out


class ProductPage(Folder):
    def test_by_hand(self):
        product = self.path("day.nc")
        run("orbit", "-q", "-o", product, "--sat", "G17,R21,E14", "--max-gap", "1h", "--exclude",
            "2025-03-21T14:01/2025-03-21T15:59", sample("ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"))
        page = (ROOT / "docs/product.md").read_text(encoding="utf-8")
        by_hand = {}
        exec(re.search(r"```python\n(.*?)```", page, re.S).group(1), by_hand)  # pylint: disable=exec-used
        p = dump(product)
        for variable in re.findall(r"`([a-z0-9_]+)`", page.split("## Layout")[1].split("Global attributes")[0]):
            self.assertIn(variable, p)
        begin = p["arc_start"][0]
        rows = csv.DictReader(io.StringIO(run("states", "-q", product, "--step", "250").stdout))
        by = {(r["t_gps"], r["sat"]): r for r in rows}
        with_clock = 0
        for i in range(24 * 3600 // 250 + 1):
            s = 250 * i
            text = f"2025-03-21T{s // 3600:02}:{s // 60 % 60:02}:{s % 60:02}" if s < 86400 else "2025-03-22T00:00:00"
            for sat in ("G17", "R21", "E14"):
                state, row = by_hand["orbit"](p, sat, begin + s * 10**9), by.pop((text, sat), None)
                self.assertEqual(state is None, row is None)
                if row is None:
                    continue
                for k, (value, slope) in enumerate(zip(*state)):
                    self.assertAlmostEqual(value, float(row["xyz"[k] + "_m"]), delta=1e-6)
                    self.assertAlmostEqual(slope, float(row["v" + "xyz"[k] + "_mps"]), delta=2e-9)
                clock = by_hand["clock"](p, sat, begin + s * 10**9)
                self.assertEqual(clock is None, row["clock_s"] == "", (text, sat))
                if clock is not None:
                    with_clock += 1
                    self.assertAlmostEqual(clock, float(row["clock_s"]), delta=1e-15)
        self.assertEqual(by, {})
        self.assertGreater(with_clock, 500)


if __name__ == "__main__":
    unittest.main()
