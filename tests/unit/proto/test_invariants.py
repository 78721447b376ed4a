#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The invariants that docs/protocol.md numbers: each names a test that exists and is run, and the code says where it is upheld."""
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]


class Invariants(unittest.TestCase):
    def test_each_has_its_test_and_its_place(self):
        page = (ROOT / "docs/protocol.md").read_text(encoding="utf-8")
        rows = re.findall(r"^\| I(\d+) \| .* \| `(test_\w+\.c)` `(\w+)` \|$", page, re.M)
        self.assertEqual([int(n) for n, _, _ in rows], list(range(1, len(rows) + 1)))
        self.assertGreater(len(rows), 10)
        code = "".join(p.read_text(encoding="utf-8") for p in sorted((ROOT / "proto").glob("*.[ch]")) + sorted((ROOT / "proto/gen").glob("*.[ch]")))
        marked = {int(n) for mark in re.findall(r"\((I\d+(?:, I\d+)*)\)", code) for n in re.findall(r"\d+", mark)}
        for number, file, name in rows:
            text = (ROOT / "tests/unit/proto" / file).read_text(encoding="utf-8")
            self.assertIn(f"static void {name}(void **state)", text)
            self.assertIn(f"cmocka_unit_test({name})", text)
            self.assertIn(int(number), marked)


if __name__ == "__main__":
    unittest.main()
