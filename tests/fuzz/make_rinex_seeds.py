#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the seeds of the RINEX fuzz targets (tests/fuzz/corpus): small made files of every version and record kind."""
import pathlib

HERE = pathlib.Path(__file__).resolve().parent / "corpus"


def head(text, label):
    return f"{text:<60.60}{label}\n"


def num(value):
    return " " * 19 if value is None else f"{value:19.12E}".replace("E", "D")


def orbit(*values, indent=4):
    return " " * indent + "".join(num(v) for v in values) + "\n"


KEPLER = [
    (12.0, -88.5, 4.5e-9, 1.25), (2e-6, 0.0123, 7e-6, 5153.7), (7200.0, 1e-7, -2.5, -3e-8),
    (0.97, 250.0, 0.7, -8e-9), (2e-10, 1.0, 2300.0, 0.0), (2.0, 0.0, 4.6e-9, 12.0), (0.0, 4.0, None, None),
]


def kepler(lines=7, indent=4, week=2300.0, sqrt_a=5153.7):
    rows = [list(row) for row in KEPLER] + [[0.0, 2300.0, 0.0, None], [10.0, 0.0, None, 7.0]]
    rows[4][2] = week
    rows[1][3] = sqrt_a
    return "".join(orbit(*row, indent=indent) for row in rows[:lines])


def state(extra=(0.0, -7.0, 1.0), flags=False):
    text = orbit(12000.5, 1.1, 0.0, extra[0]) + orbit(-15000.25, -2.2, 1e-9, extra[1]) + orbit(16000.0, 0.5, -1e-9, extra[2])
    return text + (orbit(179.0, 8e-9, 2.0, 3.0) if flags else "")


def nav_files():
    clock = num(1e-4) + num(-1e-11) + num(0.0)
    v2 = head("     2.11           N: GPS NAV DATA", "RINEX VERSION / TYPE")
    v2 += head("  " + "".join(f"{x:12.4E}".replace("E", "D") for x in (1e-8, 2e-8, -6e-8, 1e-7)), "ION ALPHA")
    v2 += head("  " + "".join(f"{x:12.4E}".replace("E", "D") for x in (9e4, 1e5, -6e4, -2e5)), "ION BETA")
    v2 += head("   " + num(1e-9) + num(1e-14) + f"{61440:9d}{1500:9d}", "DELTA-UTC: A0,A1,T,W")
    v2 += head("    14", "LEAP SECONDS") + head("", "END OF HEADER")
    v2 += " 1 08 10  5  2  0  0.0" + clock + "\n" + kepler(indent=3, week=1500.0)
    yield "v2_gps", v2
    glo = head("     2.10           G: GLONASS NAV DATA", "RINEX VERSION / TYPE")
    glo += head("  2009     4     1   " + num(1.5e-7), "CORR TO SYSTEM TIME") + head("", "END OF HEADER")
    yield "v2_glonass", glo + " 3 09  4  1  0 15  0.0" + num(7e-6) + num(0.0) + num(900.0) + "\n" + state().replace("\n    ", "\n   ")[1:]
    v3 = head("     3.05           N: GNSS NAV DATA    M: MIXED", "RINEX VERSION / TYPE")
    for name in ("GPSA", "GPSB", "GAL ", "BDSA", "BDSB", "QZSA", "QZSB", "IRNA", "IRNB"):
        v3 += head(name + " " + "".join(f"{x:12.4E}" for x in (1e-8, 2e-8, -6e-8, 1e-7)) + " A 05", "IONOSPHERIC CORR")
    for name in ("GPUT", "GAUT", "GLUT", "BDUT", "GPGA"):
        v3 += head(f"{name} {1e-9:17.10E}{1e-15:16.9E} 233472 2300 EGNOS  2", "TIME SYSTEM CORR")
    v3 += head("    18    18  1929     7", "LEAP SECONDS") + head("", "END OF HEADER")
    for sat in ("G07", "E11", "C03", "C30", "J02", "I05"):
        v3 += f"{sat} 2024 02 04 02 00 00" + clock + "\n" + kepler(week=944.0 if sat[0] == "C" else 2300.0)
    v3 += "R07 2024 02 04 00 15 00" + clock + "\n" + state(flags=True)
    v3 += "S20 2024 02 04 00 15 00" + clock + "\n" + state((0.0, 32767.0, 1.0))
    yield "v3_mixed", v3
    v4 = head("     4.02           NAVIGATION DATA     M", "RINEX VERSION / TYPE") + head("", "END OF HEADER")
    for sat, message, lines in (("G07", "LNAV", 7), ("G07", "CNAV", 8), ("G07", "CNV2", 9), ("E11", "INAV", 7), ("E11", "FNAV", 7),
                                ("C03", "D2", 7), ("C30", "D1", 7), ("C30", "CNV1", 9), ("C30", "CNV2", 9), ("C30", "CNV3", 8),
                                ("J02", "LNAV", 7), ("J02", "CNAV", 8), ("I05", "LNAV", 7), ("I05", "L1NV", 8)):
        v4 += f"> EPH {sat} {message}\n{sat} 2024 02 04 02 00 00" + clock + "\n"
        v4 += kepler(lines, week=944.0 if sat[0] == "C" else 2300.0)
    v4 += "> EPH R07 FDMA\nR07 2024 02 04 00 15 00" + clock + "\n" + state(flags=True)
    v4 += "> EPH S20 SBAS\nS20 2024 02 04 00 15 00" + clock + "\n" + state((0.0, 32767.0, 1.0))
    v4 += "> STO G07 LNAV\n    2024 02 04 02 00 00 GPUT               EGNOS              UTC(USNO)\n" + orbit(7200.0, 1e-9, 1e-15, 0.0)
    v4 += "> EOP G07 CNVX\n    2024 02 04 02 00 00" + clock + "\n" + orbit(None, 0.3, 1e-4, 0.0) + orbit(7200.0, -0.01, 1e-4, 0.0)
    epoch = "    2024 02 04 02 00 00"
    v4 += "> ION G07 LNAV\n" + epoch + clock + "\n" + orbit(1e-7, 9e4, 1e5, -6e4) + orbit(-2e5, 0.0, None, None)
    v4 += "> ION E11 IFNV\n" + epoch + clock + "\n" + orbit(0.0, None, None, None)
    v4 += "> ION C30 CNVX\n" + epoch + clock + "\n" + orbit(13.0, -17.0, 1.0, 1.0) + orbit(3.0, 0.4, None, None)
    v4 += "> ION I05 L1NV KLOB\n" + epoch + num(3.0) + "\n" + orbit(1e-8, 1e-8, 1e-8, 1e-8) * 2 + orbit(60.0, 90.0, 0.0, 30.0)
    v4 += "> ION I05 L1NV NEQN\n" + epoch + num(3.0) + "\n" + (orbit(60.0, 0.1, 0.01, 0.0) + orbit(60.0, 90.0, 0.0, 30.0)) * 3
    v4 += "> ION R07 L1OC\n" + epoch + clock + "\n"
    yield "v4_all", v4


def values(n, start=20000000.0):
    return "".join(f"{start + 1000.125 * i:14.3f}{'15'[i % 2]}{i % 9 + 1}" for i in range(n))


def obs_files():
    v2 = head("     2.11           OBSERVATION DATA    M (MIXED)", "RINEX VERSION / TYPE")
    v2 += head("MADE", "MARKER NAME") + head("  3738358.1345  1148174.0090  5021815.9357", "APPROX POSITION XYZ")
    v2 += head("     1     2     2   G 9   G12", "WAVELENGTH FACT L1/2")
    v2 += head("     7    C1    P1    P2    L1    L2    D1    S1", "# / TYPES OF OBSERV")
    v2 += head("  2008    10     5     0     0    0.0000000     GPS", "TIME OF FIRST OBS") + head("", "END OF HEADER")
    sats = ["G%2d" % i for i in range(1, 12)] + ["R03", "E11", "S20"]
    line = values(5) + "\n" + values(2) + "\n"
    v2 += " 08 10  5  0  0  0.0000000  0 14" + "".join(sats[:12]) + "   -.123456789\n" + " " * 32 + "".join(sats[12:]) + "\n" + line * 14
    v2 += " " * 28 + "4  2\n" + head("     2    C1    L1", "# / TYPES OF OBSERV") + head("a new list", "COMMENT")
    v2 += " 08 10  5  0  0 30.0000000  0  2G 9R 3\n" + values(2) + "\n" + values(1) + "\n"
    v2 += " 08 10  5  0  0 40.0000000  6  1G 9\n" + values(2) + "\n"
    yield "v2_mixed", v2
    v3 = head("     3.05           OBSERVATION DATA    M", "RINEX VERSION / TYPE") + head("MADE", "MARKER NAME")
    v3 += head("G   15 C1C L1C D1C S1C C2W L2W D2W S2W C5Q L5Q D5Q S5Q C1L", "SYS / # / OBS TYPES") + head("       L1L S1L", "SYS / # / OBS TYPES")
    v3 += head("R    2 C1C L1C", "SYS / # / OBS TYPES") + head("E    2 C1X L1X", "SYS / # / OBS TYPES")
    v3 += head("G  100   2 C1C L1C", "SYS / SCALE FACTOR") + head("G L1C  0.25000", "SYS / PHASE SHIFT")
    v3 += head("  2 R01  1 R02 -4", "GLONASS SLOT / FRQ #") + head(" C1C    0.000 C2C    0.000", "GLONASS COD/PHS/BIS")
    v3 += head("    30.000", "INTERVAL") + head("  2024    02    04    00    00    0.0000000     GPS", "TIME OF FIRST OBS") + head("", "END OF HEADER")
    v3 += "> 2024 02 04 00 00  0.0000000  0  3      -0.000123456789\nG01" + values(15) + "\nR02" + values(2) + "\nE11" + values(2) + "\n"
    v3 += "> 2024 02 04 00 00 30.0000000  4  2\n" + head("E    1 C5X", "SYS / # / OBS TYPES") + head("R    1 C1P", "SYS / # / OBS TYPES")
    v3 += "> 2024 02 04 00 01  0.0000000  1  2\nE11" + values(1) + "\nR02" + values(1) + "\n>                              5  0\n"
    v3 += "> 2024 02 04 00 01 30.0000000  6  1\nE11" + values(1) + "\n"
    yield "v3_mixed", v3
    yield "v4_pico", v3.replace("     3.05", "     4.02", 1).replace("-0.000123456789", "-0.000123456789 12345")


def crinex_files():
    v3 = head("3.0                 COMPACT RINEX FORMAT", "CRINEX VERS   / TYPE") + head("RNX2CRX", "CRINEX PROG / DATE")
    v3 += head("     3.05           OBSERVATION DATA    M", "RINEX VERSION / TYPE") + head("MADE", "MARKER NAME")
    v3 += head("G    3 C1C L1C S1C", "SYS / # / OBS TYPES") + head("R    2 C1C L1C", "SYS / # / OBS TYPES")
    v3 += head("  2024    02    04    00    00    0.0000000     GPS", "TIME OF FIRST OBS") + head("", "END OF HEADER")
    first = "> 2024 02 04 00 00  0.0000000  0  2      G01R02\n3&-123456\n3&20000000000 3&105000000000 3&45000 &7&7&\n2&21000000000  &7\n"
    v3 += first + "                   3\n12\n-1000 -5000 0  1\n500 3&99\n" + "                 1 0\n\n-10 3 5\n20 7\n"
    v3 += "> 2024 02 04 00 02  0.0000000  4  2\n" + head("G    1 C1C", "SYS / # / OBS TYPES") + head("note", "COMMENT")
    v3 += "> 2024 02 04 00 02 30.0000000  0  1      G05\n\n3&123\n"
    yield "v3", v3
    v1 = head("1.0                 COMPACT RINEX FORMAT", "CRINEX VERS   / TYPE") + head("RNX2CRX", "CRINEX PROG / DATE")
    v1 += head("     2.11           OBSERVATION DATA    M", "RINEX VERSION / TYPE") + head("MADE", "MARKER NAME")
    v1 += head("     6    C1    L1    L2    P1    P2    S1", "# / TYPES OF OBSERV")
    v1 += head("  2008    10     5     0     0    0.0000000     GPS", "TIME OF FIRST OBS") + head("", "END OF HEADER")
    v1 += "&08 10  5  0  0  0.0000000  0  2G01R02\n\n3&20000000000 3&105000000000 3&45000    7 7\n2&21000000000\n"
    v1 += "                3\n3&5\n-1000 -5000 0    1\n500 3&99\n" + "&                           4  1\n" + head("note", "COMMENT")
    v1 += "&08 10  5  0  1 30.0000000  0  1G05\n\n3&123\n"
    yield "v1", v1


def main():
    for target, files in (("rinex_nav", nav_files()), ("rinex_obs", obs_files()), ("crinex", crinex_files())):
        folder = HERE / target
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in files:
            (folder / name).write_text(text, encoding="ascii")
    for name, text in crinex_files():
        (HERE / "rinex_obs" / f"crinex_{name}").write_text(text, encoding="ascii")


if __name__ == "__main__":
    main()
