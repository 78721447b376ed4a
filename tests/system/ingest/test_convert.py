#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""orrery convert: Hatanaka files to plain RINEX, and how RINEX files in odd clothes are read."""
import gzip
import pathlib
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from program import Folder, data, run, run_json  # noqa: E402

KEYS = ("from", "to", "interval_s", "systems", "satellites", "epochs", "gaps")
FILES = ("hatanaka/YEBE00ESP_R_20230891800_01H_30S_MO.crx.gz", "hatanaka/zeck0440.16d.Z", "hatanaka/seat0440.16d.Z",
         "hatanaka/aber0440.16d.Z", "rinex4-nav/KMS300DNK_R_20221591000_01H_30S_MO.crx.gz")


def text_of(path):
    return subprocess.run(["gzip", "-dc", path], check=True, stdout=subprocess.PIPE).stdout


class Convert(Folder):
    def same(self, path, like):
        told = run_json("inspect", "--format", "json", path)
        self.assertEqual([told[k] for k in KEYS], [like[k] for k in KEYS])
        self.assertEqual(told["warning_count"], 0)

    def test_expanded_files_tell_the_same(self):
        for name in FILES:
            with self.subTest(name):
                packed, out = data(name), self.path("out.rnx")
                run("convert", packed, "--force", "-o", out)
                like = run_json("inspect", "--format", "json", packed)
                self.same(out, like)
                self.assertEqual(run("convert", packed).stdout, pathlib.Path(out).read_text(encoding="ascii"))

    def test_odd_clothes(self):
        packed = data(FILES[0])
        plain = run("convert", packed).stdout.encode()
        like = run_json("inspect", "--format", "json", packed)
        half = plain.index(b"\n> ", len(plain) // 2) + 1
        clothes = {
            "crlf": plain.replace(b"\n", b"\r\n"),
            "no newline at the end": plain.rstrip(b"\n"),
            "trailing blanks": plain.replace(b"\n", b"          \n"),
            "two members": gzip.compress(plain[:half]) + gzip.compress(plain[half:]),
            "gzip of gzip": gzip.compress(gzip.compress(plain)),
            "gzip of Hatanaka, CR LF": gzip.compress(text_of(packed).replace(b"\n", b"\r\n")),
            "UTF-8 in a comment": plain.replace(b"MARKER NAME\n", b"MARKER NAME\n" + "São João, Observatório Astronómico à ° é ü".ljust(60).encode() + b"COMMENT\n", 1),
        }
        for name, content in clothes.items():
            with self.subTest(name):
                path = pathlib.Path(self.path("odd.Z"))  # names play no part
                path.write_bytes(content)
                self.same(str(path), like)

    def test_refusals(self):
        out = self.path("no.rnx")
        done = run("convert", data("2010-182/brdc1820.10n.gz"), "-o", out, status=1)
        self.assertIn("Hatanaka", done.stderr)
        cut = pathlib.Path(self.path("cut.crx.gz"))
        whole = pathlib.Path(data(FILES[0])).read_bytes()
        cut.write_bytes(whole[:len(whole) // 2])
        run("convert", cut, "-o", out, status=1)
        run("convert", status=2)
        self.assertFalse(pathlib.Path(out).exists())
        self.assertEqual([n for n in self.left() if n.startswith("no.rnx")], [])


if __name__ == "__main__":
    unittest.main()
