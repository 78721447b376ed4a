#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the seeds of the fuzz target of the smoother: short SP3 files of made circular orbits, in the years and time systems
where a difference of times is largest.

Usage: make_smooth_seeds.py [CORPUS_DIR]; the result is committed, so run it only to change the seeds."""
import datetime
import math
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
RADIUS_KM, GM, EARTH = 26560.0, 398600.4415, 7.292115e-5


def position(number, t):
    """A circular orbit of 55 degrees' inclination, in axes that turn with the Earth."""
    u, node = 2 * math.pi * number / 3 + t * math.sqrt(GM / RADIUS_KM**3), number - EARTH * t
    x, y, z = math.cos(u), math.sin(u) * math.cos(0.96), math.sin(u) * math.sin(0.96)
    return [RADIUS_KM * v for v in (x * math.cos(node) - y * math.sin(node), x * math.sin(node) + y * math.cos(node), z)]


def sp3(start, epochs, scale="GPS", step=900, missing=()):
    sats = ["G01", "R02"]
    mjd = (start - datetime.datetime(1858, 11, 17)).days
    out = [f"#cP{start.year:4d} {start.month:2d} {start.day:2d} {start.hour:2d} {start.minute:2d} {start.second:11.8f} "
           f"{epochs:7d} ORBIT IGS14 FIT MADE",
           f"## {(mjd - 44244) // 7:4d} {(mjd - 44244) % 7 * 86400:15.8f} {step:14.8f} {mjd:5d} {0:15.13f}",
           f"+   {len(sats):2d}   {''.join(sats)}{'  0' * (17 - len(sats))}"]
    out += ["+        " + "  0" * 17] * 4 + ["++       " + "  5" * 2 + "  0" * 15] + ["++       " + "  0" * 17] * 4
    out += [f"%c M  cc {scale} ccc cccc cccc cccc cccc ccccc ccccc ccccc ccccc", "%c cc cc ccc ccc cccc cccc cccc cccc ccccc ccccc ccccc ccccc"]
    out += ["%f  1.2500000  1.025000000  0.00000000000  0.000000000000000", "%f  0.0000000  0.000000000  0.00000000000  0.000000000000000"]
    out += ["%i    0    0    0    0      0      0      0      0         0"] * 2 + ["/* MADE"] * 4
    for k in range(epochs):
        t = start + datetime.timedelta(seconds=step * k)
        out.append(f"*  {t.year:4d} {t.month:2d} {t.day:2d} {t.hour:2d} {t.minute:2d} {t.second:11.8f}")
        for number, sat in enumerate(sats):
            x, y, z = position(number, step * k) if (k, sat) not in missing else (0, 0, 0)
            out.append(f"P{sat}{x:14.6f}{y:14.6f}{z:14.6f}{123.456789 + k:14.6f}")
    return "\n".join(out + ["EOF", ""]).encode()


def main():
    out = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "tests/fuzz/corpus/smooth")
    out.mkdir(parents=True, exist_ok=True)
    seeds = {"usual": (0, sp3(datetime.datetime(2024, 2, 4), 12)), "nodes": (1, sp3(datetime.datetime(2024, 2, 4), 12, step=300)),
             "gap": (4, sp3(datetime.datetime(2024, 2, 4), 14, missing=[(k, "G01") for k in (4, 5, 6)])),
             "utc": (2, sp3(datetime.datetime(2016, 12, 31, 23), 10, "UTC")), "y2151": (1, sp3(datetime.datetime(2151, 6, 1), 8)),
             "y2250": (17, sp3(datetime.datetime(2250, 12, 31, 22), 7)), "y1970": (1, sp3(datetime.datetime(1970, 1, 1), 7))}
    first, last = sp3(datetime.datetime(1960, 1, 2), 5), sp3(datetime.datetime(2250, 12, 30), 5)
    seeds["both_ends"] = (1, first[:first.rindex(b"EOF")] + last[last.index(b"*  2250"):])
    for name, (choice, text) in seeds.items():
        (out / name).write_bytes(bytes([choice]) + text)


main()
