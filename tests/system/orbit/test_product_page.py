# SPDX-License-Identifier: GPL-3.0-or-later
"""The page docs/product.md says how to evaluate a product by hand: its own Python against the program."""
import csv
import io
import pathlib
import re
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import ROOT, Folder, dump, run, sample  # noqa: E402


class ProductPage(Folder):
    def test_by_hand(self):
        product = self.path("day.nc")
        run("orbit", "-q", "-o", product, "--sat", "G05,G17,R21,E14", "--max-gap", "1h", "--exclude",
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
            for sat in ("G05", "G17", "R21", "E14"):
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
