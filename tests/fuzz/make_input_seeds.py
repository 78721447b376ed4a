#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the seeds of the input, lzw, sp3 and text fuzz targets: small made files, nobody's data.

Usage: make_input_seeds.py [CORPUS_DIR]; the result is committed, so run it only to change the seeds."""
import gzip
import math
import pathlib
import sys


def lzw(data, width=16, block=True, clear_at=None):
    """Unix compress: codes of 9..width bits, low bits first, in groups of eight."""
    bits, used, group = 0, 0, 0
    table = {bytes([i]): i for i in range(256)}
    first = next_code = 257 if block else 256
    size, word = 9, b""

    def put(code):
        nonlocal bits, used
        bits |= code << used
        used += size

    def end_group():
        nonlocal used, group
        used += -(used - group) % (8 * size)
        group = used

    for i, byte in enumerate(data):
        longer = word + bytes([byte])
        if longer in table:
            word = longer
            continue
        put(table[word])
        if next_code < 1 << width:
            table[longer] = next_code
            next_code += 1
            if next_code - 1 > (1 << size) - 1 and size < width:
                end_group()
                size += 1
        word = bytes([byte])
        if clear_at and i >= clear_at:
            put(256)
            end_group()
            size, next_code, clear_at = 9, first, None
            table = {bytes([k]): k for k in range(256)}
    if word:
        put(table[word])
    return bytes([0x1F, 0x9D, width | (0x80 if block else 0)]) + bits.to_bytes((used + 7) // 8, "little")


def sp3(version, sats, epochs, scale="GPS", velocity=False, extra=False):
    ids = [(f"{int(s[1:]):3d}" if version == "a" else s) for s in sats]
    lines = [f"#{version}{'V' if velocity else 'P'}2024  2  4  0  0  0.00000000 {epochs:7d}   d+D  TEST FIT TEST",
             "## 2300      0.00000000   900.00000000 60344 0.0000000000000"]
    rows = max(5, (len(ids) + 16) // 17)
    for r in range(rows):
        part = ids[17 * r:17 * r + 17]
        lines.append((f"+  {len(ids):3d}   " if r == 0 else "+        ") + "".join(part + ["  0"] * (17 - len(part))))
    for r in range(rows):
        lines.append("++       " + "".join(f"{7 if 17 * r + i < len(ids) else 0:3d}" for i in range(17)))
    rest = "ccc cccc cccc cccc cccc ccccc ccccc ccccc ccccc"
    lines += [f"%c {'cc' if version == 'a' else 'M '} cc {'ccc' if version == 'a' else scale} {rest}", f"%c cc cc ccc {rest}",
              "%f  1.2500000  1.025000000  0.00000000000  0.000000000000000",
              "%f  0.0000000  0.000000000  0.00000000000  0.000000000000000"]
    lines += ["%i    0    0    0    0      0      0      0      0         0"] * 2 + ["/* MADE FOR TESTS"] * 4
    for e in range(epochs):
        lines.append(f"*  2024  2  4 {e // 4:2d} {e % 4 * 15:2d}  0.00000000")
        for k, s in enumerate(ids):
            a = 0.13 * e + k
            p = [26000 * math.cos(a), 26000 * math.sin(a) * 0.6, 26000 * math.sin(a) * 0.8]
            tail = " 18 18 18 219 EP  MP"[:13 + 7 * (k % 2)] if extra else ""
            clock = 999999.999999 if k == 1 else 12.5 * k - 3.000001 * e
            lines.append(f"P{s}{p[0]:14.6f}{p[1]:14.6f}{p[2]:14.6f}{clock:14.6f}{tail}".rstrip())
            if extra:
                lines.append("EP    55   55   55     223  1234567 -5000000        0 10000000       -1       12")
            if velocity:
                lines.append(f"V{s}{30000 * math.sin(a):14.6f}{18000 * math.cos(a):14.6f}{0:14.6f}{999999.999999:14.6f}"
                             + (" 14 14 14 191" if extra else ""))
                if extra:
                    lines.append("EV    22   22   22     111  1234567 -5000000        0 10000000       -1       12")
    return ("\n".join(lines + ["EOF", ""])).encode()


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent / "corpus")
    g = [f"G{i:02d}" for i in range(1, 4)]
    many = [f"{s}{i:02d}" for s in "GREC" for i in range(1, 31)]
    files = {"sp3/a": sp3("a", g, 2), "sp3/b": sp3("b", ["G01", "R24"], 2, "UTC"),
             "sp3/c": sp3("c", g, 3, "GPS", False, True), "sp3/c_velocity": sp3("c", g, 2, "BDT", True, True),
             "sp3/d": sp3("d", many, 1, "TAI"), "sp3/d_velocity": sp3("d", ["L51"], 3, "GLO", True)}
    repeated = sp3("d", g, 2) + sp3("d", g, 2)
    files["sp3/unordered"] = files["sp3/a"].replace(b"0 15  0.0", b"0  0  0.0").replace(b"P  2", b"P  9")
    text = files["sp3/c"]
    files |= {"input/plain": text, "input/gzip": gzip.compress(text, mtime=0),
              "input/two_members": gzip.compress(text[:500], mtime=0) + gzip.compress(text[500:], mtime=0) + b"\0" * 16,
              "input/gzip_twice": gzip.compress(gzip.compress(text, mtime=0), mtime=0),
              "input/lzw": lzw(text), "input/lzw_of_gzip": lzw(gzip.compress(text, mtime=0)),
              "input/html": b"<!DOCTYPE html><html><title>404</title></html>\n", "input/two_files": repeated}
    for name, width, block, clear in (("w16", 16, True, None), ("w12", 12, False, None), ("w10", 10, True, None),
                                      ("cleared", 16, True, 700), ("run", 16, True, None)):
        data = b"x" * 3000 if name == "run" else text
        z = lzw(data, width, block, clear)
        files[f"lzw/{name}"] = bytes([(0x80 if block else 0) | (width - 9)]) + z[3:]
    files |= {"text/numbers": b" 1.5D 02 -4.440892098501D-16 .5 5. 1e-300,1.7976931348623157e308\n12345678901234567890.5\n"
                              b"  9007199254740993 1e23 8.5e-30 123456789012345678 1e-22\r\n\t-0.0\t+7E+0\n",
              "text/heads": b"     3.05           OBSERVATION DATA    M                   RINEX VERSION / TYPE\n",
              "text/erp": b"VERSION 2\n MJD X Y UT1\n", "text/nmea": b"$GPGGA,1,2\n$GPRMC,3\n",
              "text/table": b"t,lat,lon\n0,52.1,16.2\n1,52.2,16.3\n"}
    for name, data in files.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)


if __name__ == "__main__":
    main()
