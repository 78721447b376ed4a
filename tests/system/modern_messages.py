# SPDX-License-Identifier: GPL-3.0-or-later
"""What a receiver does with the symbols of the messages that LDPC codes protect: CNAV-2 of GPS and QZSS (IS-GPS-800J 3.2.3, 3.5) and
BeiDou's B-CNAV1, 2 and 3 (BDS-SIS-ICD-B1C, B2a, B2b 1.0, sections 6 and 7). Written from the documents, knows nothing of the
program's encoders; the parity check matrices alone are read from the program's tables, which unit.orbit.ldpc holds against frames
that were received on the air."""
import pathlib
import re

from messages import bits_of, crc24q, fields, semi

TABLES = pathlib.Path(__file__).resolve().parent.parent.parent / "orbit/navdata"
ARCSECOND = semi(0) / 180 / 3600


def binary_matrix(name):
    """Rows of columns."""
    numbers = [int(n) for n in re.findall(r"(\d+),", re.sub(r"//.*", "", (TABLES / name).read_text(encoding="ascii")))]
    rows = []
    while numbers:
        n = numbers.pop(0)
        rows.append(numbers[:n])
        del numbers[:n]
    return rows


def gf64_matrix(name):
    """Rows of (column, element)."""
    rows = []
    for text in re.findall(r"ROW\(([^)]*)\)", re.sub(r"//.*", "", (TABLES / name).read_text(encoding="ascii"))):
        n = [int(k) for k in text.split(",")]
        rows.append(list(zip(n[:4], n[4:])))
    return rows


CNAV2 = {2: binary_matrix("ldpc_cnav2_subframe2.def"), 3: binary_matrix("ldpc_cnav2_subframe3.def")}
BCNAV = {1.2: gf64_matrix("ldpc_bcnav1_subframe2.def"), 1.3: gf64_matrix("ldpc_bcnav1_subframe3.def"), 2: gf64_matrix("ldpc_bcnav2.def"),
         3: gf64_matrix("ldpc_bcnav3.def")}

POWER = [1]  # of the primitive element of GF(64), a root of x^6 + x + 1
while len(POWER) < 63:
    POWER.append(POWER[-1] << 1 if POWER[-1] < 32 else POWER[-1] << 1 ^ 0b1000011)
LOG = {value: k for k, value in enumerate(POWER)}


def binary_information(rows, text):
    """The information of a codeword of a binary code; raises ValueError where a check or the CRC does not hold."""
    bits = [int(b) for b in text]
    if any(sum(bits[c] for c in row) % 2 for row in rows):
        raise ValueError("a parity check does not hold")
    return with_crc(text[:len(rows)])


def gf64_information(rows, text):
    """Likewise of a code over GF(64): six bits a symbol, the first the highest power."""
    symbols = [int(text[k:k + 6], 2) for k in range(0, len(text), 6)]
    for row in rows:
        total = 0
        for column, element in row:
            if symbols[column]:
                total ^= POWER[(LOG[symbols[column]] + LOG[element]) % 63]
        if total:
            raise ValueError("a parity check does not hold")
    return with_crc(text[:6 * len(rows)])


def with_crc(text):
    if crc24q(text[:-24]) != int(text[-24:], 2):
        raise ValueError("CRC")
    return text


def recurrence_holds(text, powers):
    """Every symbol beyond the first k is the sum of those that the polynomial names among the k before it."""
    k = max(powers)
    bits = [int(b) for b in text]
    return all(sum(bits[at + p] for p in powers) % 2 == 0 for at in range(len(bits) - k))


BCH_51_8, BCH_21_6 = (8, 7, 4, 3, 2, 1, 0), (6, 4, 2, 1, 0)

# --- Fields, without the CRC ---

FIRST = [("delta_a", 26, 2.0**-9, 1), ("a_dot", 25, 2.0**-21, 1), ("delta_n", 17, semi(44), 1), ("n_dot", 23, semi(57), 1),
         ("m0", 33, semi(32), 1), ("e", 33, 2.0**-34, 0), ("omega", 33, semi(32), 1)]
SECOND = [("cis", 16, 2.0**-30, 1), ("cic", 16, 2.0**-30, 1), ("crs", 24, 2.0**-8, 1), ("crc", 24, 2.0**-8, 1), ("cus", 21, 2.0**-30, 1),
          ("cuc", 21, 2.0**-30, 1)]
UTC = [("a0", 16, 2.0**-35, 1), ("a1", 13, 2.0**-51, 1), ("a2", 7, 2.0**-68, 1), ("leap", 8, None, 1), ("tot", 16, 16, 0), ("wnot", 13, None, 0),
       ("wnlsf", 13, None, 0)]
ROTATION = [("t_eop", 16, 16, 0), ("xp", 21, ARCSECOND * 2.0**-20, 1), ("xp_rate", 15, ARCSECOND * 2.0**-21, 1), ("yp", 21, ARCSECOND * 2.0**-20, 1),
            ("yp_rate", 15, ARCSECOND * 2.0**-21, 1), ("ut1", 31, 2.0**-24, 1), ("ut1_rate", 19, 2.0**-25, 1)]
OFFSET = [("a0g", 16, 2.0**-35, 1), ("a1g", 13, 2.0**-51, 1), ("a2g", 7, 2.0**-68, 1)]

CNAV2_SUBFRAME2 = [
    ("wn", 13, None, 0), ("itow", 8, 7200, 0), ("top", 11, 300, 0), ("health", 1, None, 0), ("ed", 5, None, 1), ("toe", 11, 300, 0), *FIRST,
    ("omega0", 33, semi(32), 1), ("i0", 33, semi(32), 1), ("delta_omega_dot", 17, semi(44), 1), ("idot", 15, semi(44), 1), *SECOND,
    ("ned0", 5, None, 1), ("ned1", 3, None, 0), ("ned2", 3, None, 0), ("af0", 26, 2.0**-35, 1), ("af1", 20, 2.0**-48, 1), ("af2", 10, 2.0**-60, 1),
    ("tgd", 13, 2.0**-35, 1), ("isc_l1cp", 13, 2.0**-35, 1), ("isc_l1cd", 13, 2.0**-35, 1), ("isf", 1, None, 0), ("wnop", 8, None, 0),
    ("", 2, None, 0)]
CNAV2_HEAD = [("prn", 8, None, 0), ("page", 6, None, 0)]
CNAV2_PAGES = {
    1: [*CNAV2_HEAD, *UTC, ("dn", 4, None, 0), ("leap_future", 8, None, 1), *[(f"alpha{k}", 8, 2.0**p, 1) for k, p in enumerate((-30, -27, -24, -24))],
        *[(f"beta{k}", 8, 2.0**p, 1) for k, p in enumerate((11, 14, 16, 16))],
        *[(f"isc_{s}", 13, 2.0**-35, 1) for s in ("l1ca", "l2c", "l5i", "l5q")], ("", 22, None, 0)],
    2: [*CNAV2_HEAD, ("gnss", 3, None, 0), ("t0g", 16, 16, 0), ("wn0g", 13, None, 0), *OFFSET, *ROTATION, ("", 30, None, 0)],
    3: [*CNAV2_HEAD, ("wna", 13, None, 0), ("toa", 8, 4096, 0),
        *[field for k in range(6) for field in ((f"prn{k}", 8, None, 0), (f"delta_a{k}", 8, 512, 1), (f"omega0{k}", 7, semi(6), 1),
                                               (f"phi0{k}", 7, semi(6), 1), (f"health{k}", 3, None, 0))], ("", 17, None, 0)],
    4: [*CNAV2_HEAD, ("wna", 13, None, 0), ("toa", 8, 4096, 0), ("sat", 8, None, 0), ("health", 3, None, 0), ("e", 11, 2.0**-16, 0),
        ("i", 11, semi(14), 1), ("omega_dot", 11, semi(33), 1), ("sqrt_a", 17, 2.0**-4, 0), ("omega0", 16, semi(15), 1), ("omega", 16, semi(15), 1),
        ("m0", 16, semi(15), 1), ("af0", 11, 2.0**-20, 1), ("af1", 10, 2.0**-37, 1), ("", 85, None, 0)]}

EPHEMERIS_1 = [("toe", 11, 300, 0), ("sat_type", 2, None, 0), *FIRST]
EPHEMERIS_2 = [("omega0", 33, semi(32), 1), ("i0", 33, semi(32), 1), ("omega_dot", 19, semi(44), 1), ("idot", 15, semi(44), 1), *SECOND]
CLOCK = [("toc", 11, 300, 0), ("af0", 25, 2.0**-34, 1), ("af1", 22, 2.0**-50, 1), ("af2", 11, 2.0**-66, 1)]
BDGIM = [(f"alpha{k}", 10 if k == 1 else 8, -0.125 if k == 5 else 0.125, k in (2, 6, 7, 8, 9)) for k in range(1, 10)]
BDT_UTC = [*UTC, ("dn", 3, None, 0), ("leap_future", 8, None, 1)]
ACCURACY = [("top", 11, 300, 0), ("ocb", 5, None, 0), ("oc1", 3, None, 0), ("oc2", 3, None, 0)]
BGTO = [("gnss", 3, None, 0), ("wn0g", 13, None, 0), ("t0g", 16, 16, 0), *OFFSET]
MIDI = [("sat", 6, None, 0), ("sat_type", 2, None, 0), ("wna", 13, None, 0), ("toa", 8, 4096, 0), ("e", 11, 2.0**-16, 0), ("i", 11, semi(14), 1),
        ("sqrt_a", 17, 2.0**-4, 0), ("omega0", 16, semi(15), 1), ("omega_dot", 11, semi(33), 1), ("omega", 16, semi(15), 1), ("m0", 16, semi(15), 1),
        ("af0", 11, 2.0**-20, 1), ("af1", 10, 2.0**-37, 1), ("health", 8, None, 0)]
REFERENCE = [("wna", 13, None, 0), ("toa", 8, 4096, 0)]


def reduced(n):
    return [field for k in range(n) for field in ((f"prn{k}", 6, None, 0), (f"type{k}", 2, None, 0), (f"delta_a{k}", 8, 512, 1),
                                                  (f"omega0{k}", 7, semi(6), 1), (f"phi0{k}", 7, semi(6), 1), (f"health{k}", 8, None, 0))]


BCNAV1_SUBFRAME2 = [("wn", 13, None, 0), ("how", 8, 3600, 0), ("iodc", 10, None, 0), ("iode", 8, None, 0), *EPHEMERIS_1, *EPHEMERIS_2, *CLOCK,
                    ("tgd_b2ap", 12, 2.0**-34, 1), ("isc_b1cd", 12, 2.0**-34, 1), ("tgd_b1cp", 12, 2.0**-34, 1), ("", 7, None, 0)]
BCNAV1_HEAD = [("page", 6, None, 0), ("hs", 2, None, 0), ("dif", 1, None, 0), ("sif", 1, None, 0), ("aif", 1, None, 0), ("sismai", 4, None, 0)]
BCNAV1_PAGES = {
    1: [*BCNAV1_HEAD, ("oe", 5, None, 0), *ACCURACY, *BDGIM, *BDT_UTC, ("", 27, None, 0)],
    2: [*BCNAV1_HEAD, *ACCURACY, *REFERENCE, *reduced(4), ("", 30, None, 0)],
    3: [*BCNAV1_HEAD, ("oe", 5, None, 0), *ROTATION, *BGTO, ("", 14, None, 0)],
    4: [*BCNAV1_HEAD, *ACCURACY, *MIDI, ("", 47, None, 0)]}
STATUS = [("b2a", 3, None, 0), ("sismai", 4, None, 0), ("b1c", 3, None, 0)]
BCNAV2_HEAD = [("prn", 6, None, 0), ("type", 6, None, 0), ("sow", 18, 3, 0)]
HEALTHY = [*BCNAV2_HEAD, ("hs", 2, None, 0), *STATUS]
ISSUE = ("iodc", 10, None, 0)
BCNAV2 = {
    10: [*BCNAV2_HEAD, ("wn", 13, None, 0), *STATUS, ("iode", 8, None, 0), *EPHEMERIS_1],
    11: [*HEALTHY, *EPHEMERIS_2],
    30: [*HEALTHY, *CLOCK, ISSUE, ("tgd_b2ap", 12, 2.0**-34, 1), ("isc_b2ad", 12, 2.0**-34, 1), *BDGIM, ("tgd_b1cp", 12, 2.0**-34, 1), ("", 33, None, 0)],
    31: [*HEALTHY, *CLOCK, ISSUE, *REFERENCE, *reduced(3), ("", 8, None, 0)],
    32: [*HEALTHY, *CLOCK, ISSUE, *ROTATION, ("", 5, None, 0)],
    33: [*HEALTHY, *CLOCK, *BGTO, *reduced(1), ISSUE, *REFERENCE, ("", 16, None, 0)],
    34: [*HEALTHY, *ACCURACY, *CLOCK, ISSUE, *BDT_UTC, ("", 24, None, 0)],
    40: [*HEALTHY, ("oe", 5, None, 0), *ACCURACY, *MIDI, ("", 39, None, 0)]}
BCNAV3_HEAD = [("type", 6, None, 0), ("sow", 20, None, 0)]
BCNAV3 = {
    10: [*BCNAV3_HEAD, ("", 4, None, 0), *EPHEMERIS_1, *EPHEMERIS_2, ("dif", 1, None, 0), ("sif", 1, None, 0), ("aif", 1, None, 0), ("sismai", 4, None, 0)],
    30: [*BCNAV3_HEAD, ("wn", 13, None, 0), ("", 4, None, 0), *CLOCK, ("tgd_b2bi", 12, 2.0**-34, 1), *BDGIM, *BDT_UTC, *ROTATION, *ACCURACY,
         ("oe", 5, None, 0), ("hs", 2, None, 0)],
    40: [*BCNAV3_HEAD, *BGTO, *MIDI, *REFERENCE, *reduced(5), ("", 1, None, 0)]}

# --- Frames ---


def cnav2_frame(data):
    """1800 symbols of a frame -> (TOI, subframe 2's fields, subframe 3's, all information bits as text)."""
    text = bits_of(data, 1800)
    toi = text[1:52] if text[0] == "0" else "".join("10"[int(b)] for b in text[1:52])
    if not recurrence_holds(toi, BCH_51_8):
        raise ValueError("TOI")
    array = [text[52 + 38 * column:52 + 38 * column + 38] for column in range(46)]  # read column by column
    rows = "".join(array[column][row] for row in range(38) for column in range(46))
    second, third = binary_information(CNAV2[2], rows[:1200]), binary_information(CNAV2[3], rows[1200:])
    page = int(third[8:14], 2)
    head = text[0] + toi[:8]
    return (int(head, 2), fields(second[:-24], CNAV2_SUBFRAME2), fields(third[:-24], CNAV2_PAGES[page]), head + second + third)


def bcnav1_frame(data):
    """1800 symbols of a frame -> (number, seconds of the hour, subframe 2's fields, subframe 3's, all information bits as text)."""
    text = bits_of(data, 1800)
    prn, soh = text[:21], text[21:72]
    if not recurrence_holds(prn, BCH_21_6) or not recurrence_holds(soh, BCH_51_8):
        raise ValueError("subframe 1")
    array = [text[72 + 36 * column:72 + 36 * column + 36] for column in range(48)]
    rows = ["".join(array[column][row] for column in range(48)) for row in range(36)]
    second = gf64_information(BCNAV[1.2], "".join(rows[row] for row in range(36) if row % 3 != 2 or row > 32))
    third = gf64_information(BCNAV[1.3], "".join(rows[2:33:3]))
    return (int(prn[:6], 2), 18 * int(soh[:8], 2), fields(second[:-24], BCNAV1_SUBFRAME2), fields(third[:-24], BCNAV1_PAGES[int(third[:6], 2)]),
            prn[:6] + soh[:8] + second + third)


def bcnav2_message(data):
    """600 symbols of a message -> (its fields, preamble and information as text)."""
    text = bits_of(data, 600)
    if int(text[:24], 2) != 0xE24DE8:
        raise ValueError("no preamble")
    message = gf64_information(BCNAV[2], text[24:])
    return fields(message[:-24], BCNAV2[int(message[6:12], 2)]), text[:24] + message


def bcnav3_message(data):
    """1000 symbols of a message -> (number, its fields, preamble, number and information as text)."""
    text = bits_of(data, 1000)
    if int(text[:16], 2) != 0xEB90 or text[22:28] != "000000":
        raise ValueError("no preamble")
    message = gf64_information(BCNAV[3], text[28:])
    return int(text[16:22], 2), fields(message[:-24], BCNAV3[int(message[:6], 2)]), text[:28] + message


def cnav2_elements(f, a_reference):
    """Subframe 2 as elements (IS-GPS-800J table 3.5-2); toc is toe."""
    return {**f, "a": a_reference + f["delta_a"], "omega_dot": semi(0) * -2.6e-9 + f["delta_omega_dot"], "toc": f["toe"]}


def bcnav_elements(f):
    """BDS-SIS-ICD-B1C 1.0, 7.7."""
    return {**f, "a": (27906100.0 if f["sat_type"] == 3 else 42162200.0) + f["delta_a"]}
