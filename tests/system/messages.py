# SPDX-License-Identifier: GPL-3.0-or-later
"""What a receiver does with the symbols of newer navigation messages: Galileo I/NAV and F/NAV (OS SIS ICD 2.1), BeiDou D1 and D2
(BDS-SIS-ICD-B1I 3.0), CNAV (IS-GPS-200N, section 30), NavIC SPS (IRNSS SIS ICD 1.1), SBAS (RTCA DO-229E, appendix A). Written from the documents, knows nothing of the program's encoders."""
import math

from navdata import bits_of, half_week

PI = 3.1415926535898
GALILEO_GM, GALILEO_RATE = 3.986004418e14, 7.2921151467e-5


def crc24q(text):
    """The remainder of the division by G(X) = (1 + X) P(X), bit by bit."""
    p = sum(1 << k for k in (23, 17, 13, 12, 11, 9, 8, 7, 5, 3, 0))
    g = p ^ (p << 1)
    value = int(text, 2) << 24
    while value.bit_length() > 24:
        value ^= g << (value.bit_length() - 25)
    return value


def viterbi_free(symbols, inverted, state=0):
    """The bits of an error-free run of symbols of the code 171, 133 (K = 7): the first symbol of each pair holds the new bit
    itself, the second has to be what the code makes of it. -> (bits, the last six as a number)."""
    bits = []
    for first, second in zip(symbols[::2], symbols[1::2]):
        old = [state >> k & 1 for k in range(6)]  # old[0] is the bit before
        bit = first ^ old[0] ^ old[1] ^ old[2] ^ old[5]
        if second ^ inverted != bit ^ old[1] ^ old[2] ^ old[4] ^ old[5]:
            raise ValueError("the symbols are none of the code's")
        bits.append(bit)
        state = (state << 1 | bit) & 63
    return "".join(map(str, bits)), state


def deinterleaved(text, rows, columns):
    """Received row by row, taken out column by column."""
    return [int(text[r * columns + c]) for c in range(columns) for r in range(rows)]


def fields(text, table):
    """Consecutive fields: (name, bits, scale, signed); scale None leaves them as they are."""
    out, at = {}, 0
    for name, n, scale, signed in table:
        value = int(text[at:at + n], 2)
        at += n
        if signed and value >> (n - 1):
            value -= 1 << n
        if name:
            out[name] = value if scale is None else value * scale
    if at != len(text):
        raise AssertionError(f"{at} bits in the table, {len(text)} in the message")
    return out


def semi(power):
    return PI * 2.0**-power


# --- Galileo ---

INAV = {
    0: [("type", 6, None, 0), ("time", 2, None, 0), ("", 88, None, 0), ("wn", 12, None, 0), ("tow", 20, None, 0)],
    1: [("type", 6, None, 0), ("iod", 10, None, 0), ("toe", 14, 60, 0), ("m0", 32, semi(31), 1), ("e", 32, 2.0**-33, 0),
        ("sqrt_a", 32, 2.0**-19, 0), ("", 2, None, 0)],
    2: [("type", 6, None, 0), ("iod", 10, None, 0), ("omega0", 32, semi(31), 1), ("i0", 32, semi(31), 1), ("omega", 32, semi(31), 1),
        ("idot", 14, semi(43), 1), ("", 2, None, 0)],
    3: [("type", 6, None, 0), ("iod", 10, None, 0), ("omega_dot", 24, semi(43), 1), ("delta_n", 16, semi(43), 1), ("cuc", 16, 2.0**-29, 1),
        ("cus", 16, 2.0**-29, 1), ("crc", 16, 2.0**-5, 1), ("crs", 16, 2.0**-5, 1), ("sisa", 8, None, 0)],
    4: [("type", 6, None, 0), ("iod", 10, None, 0), ("svid", 6, None, 0), ("cic", 16, 2.0**-29, 1), ("cis", 16, 2.0**-29, 1),
        ("toc", 14, 60, 0), ("af0", 31, 2.0**-34, 1), ("af1", 21, 2.0**-46, 1), ("af2", 6, 2.0**-59, 1), ("", 2, None, 0)],
    5: [("type", 6, None, 0), ("ai0", 11, 0.25, 0), ("ai1", 11, 2.0**-8, 1), ("ai2", 14, 2.0**-15, 1), ("flags", 5, None, 0),
        ("bgd_5a", 10, 2.0**-32, 1), ("bgd_5b", 10, 2.0**-32, 1), ("hs_5b", 2, None, 0), ("hs_1", 2, None, 0), ("dvs_5b", 1, None, 0),
        ("dvs_1", 1, None, 0), ("wn", 12, None, 0), ("tow", 20, None, 0), ("", 23, None, 0)],
    6: [("type", 6, None, 0), ("a0", 32, 2.0**-30, 1), ("a1", 24, 2.0**-50, 1), ("leap", 8, None, 1), ("tot", 8, 3600, 0), ("wnot", 8, None, 0),
        ("wnlsf", 8, None, 0), ("dn", 3, None, 0), ("leap_future", 8, None, 1), ("tow", 20, None, 0), ("", 3, None, 0)],
    16: [("type", 6, None, 0), ("a", 5, 2.0**8, 1), ("ex", 13, 2.0**-22, 1), ("ey", 13, 2.0**-22, 1), ("i0", 17, semi(22), 1),
         ("omega0", 23, semi(22), 1), ("lambda0", 23, semi(22), 1), ("af0", 22, 2.0**-26, 1), ("af1", 6, 2.0**-35, 1)],
}


def almanac_fields(k, last=9):
    return [(f"{name}{k}", n, scale, signed) for name, n, scale, signed in (
        ("sqrt_a", 13, 2.0**-9, 1), ("e", 11, 2.0**-16, 0), ("omega", 16, semi(15), 1), ("i", 11, semi(14), 1), ("omega0", 16, semi(15), 1),
        ("omega_dot", 11, semi(33), 1), ("m0", 16, semi(15), 1), ("af0", 16, 2.0**-19, 1), ("af1", 13, 2.0**-38, 1))][:last]


HEAD = [("type", 6, None, 0), ("ioda", 4, None, 0)]
DATED = [*HEAD, ("wna", 2, None, 0), ("t0a", 10, 600, 0)]
HEALTH = ("hs_5b", 2, None, 0), ("hs_1", 2, None, 0)
INAV[7] = [*DATED, ("sat1", 6, None, 0), *almanac_fields(1, 7), ("", 6, None, 0)]
INAV[8] = [*HEAD, *almanac_fields(1)[7:], *HEALTH, ("sat2", 6, None, 0), *almanac_fields(2, 6), ("", 1, None, 0)]
INAV[9] = [*DATED, *almanac_fields(2)[6:], *HEALTH, ("sat3", 6, None, 0), *almanac_fields(3, 4)]
INAV[10] = [*HEAD, *almanac_fields(3)[4:], *HEALTH, ("a0g", 16, 2.0**-35, 1), ("a1g", 12, 2.0**-51, 1), ("t0g", 8, 3600, 0), ("wn0g", 6, None, 0)]

TIME = [("wn", 12, None, 0), ("tow", 20, None, 0)]
FNAV = {
    1: [("type", 6, None, 0), ("svid", 6, None, 0), ("iod", 10, None, 0), ("toc", 14, 60, 0), ("af0", 31, 2.0**-34, 1), ("af1", 21, 2.0**-46, 1),
        ("af2", 6, 2.0**-59, 1), ("sisa", 8, None, 0), ("ai0", 11, 0.25, 0), ("ai1", 11, 2.0**-8, 1), ("ai2", 14, 2.0**-15, 1),
        ("flags", 5, None, 0), ("bgd_5a", 10, 2.0**-32, 1), ("hs_5a", 2, None, 0), *TIME, ("dvs_5a", 1, None, 0), ("", 26, None, 0)],
    2: [("type", 6, None, 0), ("iod", 10, None, 0), ("m0", 32, semi(31), 1), ("omega_dot", 24, semi(43), 1), ("e", 32, 2.0**-33, 0),
        ("sqrt_a", 32, 2.0**-19, 0), ("omega0", 32, semi(31), 1), ("idot", 14, semi(43), 1), *TIME],
    3: [("type", 6, None, 0), ("iod", 10, None, 0), ("i0", 32, semi(31), 1), ("omega", 32, semi(31), 1), ("delta_n", 16, semi(43), 1),
        ("cuc", 16, 2.0**-29, 1), ("cus", 16, 2.0**-29, 1), ("crc", 16, 2.0**-5, 1), ("crs", 16, 2.0**-5, 1), ("toe", 14, 60, 0), *TIME,
        ("", 8, None, 0)],
    4: [("type", 6, None, 0), ("iod", 10, None, 0), ("cic", 16, 2.0**-29, 1), ("cis", 16, 2.0**-29, 1), ("a0", 32, 2.0**-30, 1),
        ("a1", 24, 2.0**-50, 1), ("leap", 8, None, 1), ("tot", 8, 3600, 0), ("wnot", 8, None, 0), ("wnlsf", 8, None, 0), ("dn", 3, None, 0),
        ("leap_future", 8, None, 1), ("t0g", 8, 3600, 0), ("a0g", 16, 2.0**-35, 1), ("a1g", 12, 2.0**-51, 1), ("wn0g", 6, None, 0),
        ("tow", 20, None, 0), ("", 5, None, 0)],
    5: [*DATED, ("sat1", 6, None, 0), *almanac_fields(1), ("hs1", 2, None, 0), ("sat2", 6, None, 0), *almanac_fields(2, 4), ("omega0_high", 4, None, 0)],
    6: [*HEAD, ("omega0_low", 12, None, 0), *almanac_fields(2)[5:], ("hs2", 2, None, 0), ("sat3", 6, None, 0), *almanac_fields(3), ("hs3", 2, None, 0),
        ("", 3, None, 0)],
}


def inav_page(data, e1):
    """500 symbols of a page -> (the word's 128 bits, SSP); raises ValueError where anything does not hold."""
    text = bits_of(data, 500)
    parts = []
    for k in range(2):
        part = text[250 * k:250 * k + 250]
        if part[:10] != "0101100000":
            raise ValueError("no synchronisation")
        bits, state = viterbi_free(deinterleaved(part[10:], 8, 30), 1)
        if state != 0:
            raise ValueError("no tail")
        parts.append(bits)
    even, odd = parts
    if even[:2] != "00" or odd[:2] != "10":
        raise ValueError("no nominal page, even then odd")
    if crc24q(even[:114] + odd[:82]) != int(odd[82:106], 2):
        raise ValueError("CRC")
    # After coding, the last 16 symbols of the odd part (before interleaving) are one of three patterns (table 38).
    last = "".join(map(str, deinterleaved(text[260:], 8, 30)[-16:]))
    patterns = {"1110100100100101": 1, "0110110001001110": 2, "1101000000111110": 3}
    if e1 != (last in patterns):
        raise ValueError("secondary synchronisation pattern")
    return even[2:114] + odd[2:18], patterns.get(last)


def fnav_page(data):
    """500 symbols of a page -> its 214 bits."""
    text = bits_of(data, 500)
    if text[:12] != "101101110000":
        raise ValueError("no synchronisation")
    bits, state = viterbi_free(deinterleaved(text[12:], 8, 61), 1)
    if state != 0 or crc24q(bits[:214]) != int(bits[214:238], 2):
        raise ValueError("CRC or tail")
    return bits[:214]


def gf256():
    """Powers and logarithms of the field of x^8 + x^4 + x^3 + x^2 + 1."""
    power, log, value = [], {}, 1
    for k in range(255):
        power.append(value)
        log[value] = k
        value <<= 1
        if value & 256:
            value ^= 0x11D
    return power, log


def reed_solomon_holds(words):
    """Words 1-4 and 17-20 (128 bits each, by number): the code's polynomial has its 60 zeros (5.1.12)."""
    one = words[1]
    information = one[:6] + one[14:16] + one[6:14] + one[16:] + "".join(words[k][16:] for k in (2, 3, 4))
    parity = "".join(words[k][6:14] + words[k][16:] for k in (17, 18, 19, 20))
    octets = [int(parity[k:k + 8], 2) for k in range(0, 480, 8)] + [int(information[k:k + 8], 2) for k in range(0, 464, 8)]
    power, log = gf256()
    for root in range(1, 61):
        total = 0
        for k, octet in enumerate(octets):  # coefficient of x^k
            if octet:
                total ^= power[(log[octet] + root * k) % 255]
        if total:
            return False
    return all(words[k][14:16] == one[14:16] for k in (17, 18, 19, 20))


# --- BeiDou D1 ---

BEIDOU_GM, BEIDOU_RATE = 3.986004418e14, 7.2921150e-5
D1_HEAD = [("pre", 11, None, 0), ("", 4, None, 0), ("fraid", 3, None, 0), ("sow", 20, None, 0)]
D1 = {
    1: [*D1_HEAD, ("health", 1, None, 0), ("aodc", 5, None, 0), ("urai", 4, None, 0), ("wn", 13, None, 0), ("toc", 17, 8, 0), ("tgd1", 10, 1e-10, 1),
        ("tgd2", 10, 1e-10, 1), *[(f"alpha{k}", 8, 2.0**p, 1) for k, p in enumerate((-30, -27, -24, -24))],
        *[(f"beta{k}", 8, 2.0**p, 1) for k, p in enumerate((11, 14, 16, 16))], ("af2", 11, 2.0**-66, 1), ("af0", 24, 2.0**-33, 1),
        ("af1", 22, 2.0**-50, 1), ("iod", 5, None, 0)],
    2: [*D1_HEAD, ("delta_n", 16, semi(43), 1), ("cuc", 18, 2.0**-31, 1), ("m0", 32, semi(31), 1), ("e", 32, 2.0**-33, 0), ("cus", 18, 2.0**-31, 1),
        ("crc", 18, 2.0**-6, 1), ("crs", 18, 2.0**-6, 1), ("sqrt_a", 32, 2.0**-19, 0), ("toe_high", 2, None, 0)],
    3: [*D1_HEAD, ("toe_low", 15, None, 0), ("i0", 32, semi(31), 1), ("cic", 18, 2.0**-31, 1), ("omega_dot", 24, semi(43), 1), ("cis", 18, 2.0**-31, 1),
        ("idot", 14, semi(43), 1), ("omega0", 32, semi(31), 1), ("omega", 32, semi(31), 1), ("", 1, None, 0)],
    "almanac": [*D1_HEAD, ("", 1, None, 0), ("page", 7, None, 0), ("sqrt_a", 24, 2.0**-11, 0), ("af1", 11, 2.0**-38, 1), ("af0", 11, 2.0**-20, 1),
                ("omega0", 24, semi(23), 1), ("e", 17, 2.0**-21, 0), ("i", 16, semi(19), 1), ("toa", 8, 4096, 0), ("omega_dot", 17, semi(38), 1),
                ("omega", 24, semi(23), 1), ("m0", 24, semi(23), 1), ("am_id", 2, None, 0)],
    "utc": [*D1_HEAD, ("", 1, None, 0), ("page", 7, None, 0), ("leap", 8, None, 1), ("leap_future", 8, None, 1), ("wnlsf", 8, None, 0),
            ("a0", 32, 2.0**-30, 1), ("a1", 24, 2.0**-50, 1), ("dn", 8, None, 0), ("", 90, None, 0)],
}


def bch_holds(bits):
    """Fifteen bits as a polynomial are a multiple of x^4 + x + 1."""
    value = int("".join(bits), 2)
    while value.bit_length() > 4:
        value ^= 0b10011 << (value.bit_length() - 5)
    return value == 0


def d1_subframe(data):
    """300 bits as sent -> 224 bits of information; raises ValueError where a block does not hold."""
    return bch_subframe(bits_of(data, 300))


def bch_subframe(text):
    if text[:11] != "11100010010":
        raise ValueError("no preamble")
    if not bch_holds(text[15:30]):
        raise ValueError("word 1")
    out = text[:26]
    for w in range(1, 10):
        word = text[30 * w:30 * w + 30]
        halves = word[::2], word[1::2]
        if not all(map(bch_holds, halves)):
            raise ValueError(f"word {w + 1}")
        out += halves[0][:11] + halves[1][:11]
    return out


# Where D2's pages of subframe 1 hold a field: (page, first bit of information counted from 0, bits), highest part first (figures 5-21 ff.).
D2 = {
    "health": ([(1, 42, 1)], None, 0), "aodc": ([(1, 43, 5)], None, 0), "urai": ([(1, 48, 4)], None, 0), "wn": ([(1, 52, 13)], None, 0),
    "toc": ([(1, 65, 17)], 8, 0), "tgd1": ([(1, 82, 10)], 1e-10, 1), "tgd2": ([(1, 92, 10)], 1e-10, 1),
    **{f"alpha{k}": ([(2, 42 + 8 * k, 8)], 2.0**p, 1) for k, p in enumerate((-30, -27, -24, -24))},
    **{f"beta{k}": ([(2, 74 + 8 * k, 8)], 2.0**p, 1) for k, p in enumerate((11, 14, 16, 16))},
    "af0": ([(3, 80, 24)], 2.0**-33, 1), "af1": ([(3, 104, 4), (4, 42, 18)], 2.0**-50, 1), "af2": ([(4, 60, 11)], 2.0**-66, 1),
    "iod": ([(4, 71, 5)], None, 0), "delta_n": ([(4, 76, 16)], semi(43), 1), "cuc": ([(4, 92, 14), (5, 42, 4)], 2.0**-31, 1),
    "m0": ([(5, 46, 32)], semi(31), 1), "cus": ([(5, 78, 18)], 2.0**-31, 1), "e": ([(5, 96, 10), (6, 42, 22)], 2.0**-33, 0),
    "sqrt_a": ([(6, 64, 32)], 2.0**-19, 0), "cic": ([(6, 96, 10), (7, 42, 8)], 2.0**-31, 1), "cis": ([(7, 50, 18)], 2.0**-31, 1),
    "toe": ([(7, 68, 17)], 8, 0), "i0": ([(7, 85, 21), (8, 42, 11)], semi(31), 1), "crc": ([(8, 53, 18)], 2.0**-6, 1),
    "crs": ([(8, 71, 18)], 2.0**-6, 1), "omega_dot": ([(8, 89, 19), (9, 42, 5)], semi(43), 1), "omega0": ([(9, 47, 32)], semi(31), 1),
    "omega": ([(9, 79, 27), (10, 42, 5)], semi(31), 1), "idot": ([(10, 47, 14)], semi(43), 1),
}


def d2_frame(data):
    """1500 bits as sent -> the information of five subframes; raises ValueError where a block does not hold."""
    text = bits_of(data, 1500)
    return [bch_subframe(text[k:k + 300]) for k in range(0, 1500, 300)]


def d2_set(pages):
    """The ten pages of subframe 1, by number -> the record, with the mark that its axes are tilted."""
    out = {"geo": True}
    for name, (places, scale, signed) in D2.items():
        bits = "".join(pages[page][first:first + n] for page, first, n in places)
        value = int(bits, 2) - (1 << len(bits) if signed and bits[0] == "1" else 0)
        out[name] = value if scale is None else value * scale
    return out


# --- CNAV ---

CNAV_HEAD = [("pre", 8, None, 0), ("prn", 6, None, 0), ("type", 6, None, 0), ("tow", 17, 6, 0), ("alert", 1, None, 0)]
CNAV_CLOCK = [*CNAV_HEAD, ("top", 11, 300, 0), ("ned0", 5, None, 1), ("ned1", 3, None, 0), ("ned2", 3, None, 0), ("toc", 11, 300, 0),
              ("af0", 26, 2.0**-35, 1), ("af1", 20, 2.0**-48, 1), ("af2", 10, 2.0**-60, 1)]
CNAV = {
    10: [*CNAV_HEAD, ("wn", 13, None, 0), ("health", 3, None, 0), ("top", 11, 300, 0), ("ed", 5, None, 1), ("toe", 11, 300, 0),
         ("delta_a", 26, 2.0**-9, 1), ("a_dot", 25, 2.0**-21, 1), ("delta_n", 17, semi(44), 1), ("n_dot", 23, semi(57), 1), ("m0", 33, semi(32), 1),
         ("e", 33, 2.0**-34, 0), ("omega", 33, semi(32), 1), ("", 5, None, 0)],
    11: [*CNAV_HEAD, ("toe", 11, 300, 0), ("omega0", 33, semi(32), 1), ("i0", 33, semi(32), 1), ("delta_omega_dot", 17, semi(44), 1),
         ("idot", 15, semi(44), 1), ("cis", 16, 2.0**-30, 1), ("cic", 16, 2.0**-30, 1), ("crs", 24, 2.0**-8, 1), ("crc", 24, 2.0**-8, 1),
         ("cus", 21, 2.0**-30, 1), ("cuc", 21, 2.0**-30, 1), ("", 7, None, 0)],
    30: [*CNAV_CLOCK, ("tgd", 13, 2.0**-35, 1), ("isc_l1ca", 13, 2.0**-35, 1), ("isc_l2c", 13, 2.0**-35, 1), ("isc_l5i", 13, 2.0**-35, 1),
         ("isc_l5q", 13, 2.0**-35, 1), *[(f"alpha{k}", 8, 2.0**p, 1) for k, p in enumerate((-30, -27, -24, -24))],
         *[(f"beta{k}", 8, 2.0**p, 1) for k, p in enumerate((11, 14, 16, 16))], ("wnop", 8, None, 0), ("", 12, None, 0)],
    33: [*CNAV_CLOCK, ("a0", 16, 2.0**-35, 1), ("a1", 13, 2.0**-51, 1), ("a2", 7, 2.0**-68, 1), ("leap", 8, None, 1), ("tot", 16, 16, 0),
         ("wnot", 13, None, 0), ("wnlsf", 13, None, 0), ("dn", 4, None, 0), ("leap_future", 8, None, 1), ("", 51, None, 0)],
    35: [*CNAV_CLOCK, ("t", 16, 16, 0), ("wn", 13, None, 0), ("gnss", 3, None, 0), ("a0", 16, 2.0**-35, 1), ("a1", 13, 2.0**-51, 1),
         ("a2", 7, 2.0**-68, 1), ("", 81, None, 0)],
    12: [*CNAV_HEAD, ("wna", 13, None, 0), ("toa", 8, 4096, 0), *[field for k in range(7) for field in (
        (f"prn{k}", 6, None, 0), (f"delta_a{k}", 8, 512, 1), (f"omega0{k}", 7, semi(6), 1), (f"phi0{k}", 7, semi(6), 1), (f"health{k}", 3, None, 0))]],
    32: [*CNAV_CLOCK, ("t_eop", 16, 16, 0), ("xp", 21, 2.0**-20, 1), ("xp_rate", 15, 2.0**-21, 1), ("yp", 21, 2.0**-20, 1),
         ("yp_rate", 15, 2.0**-21, 1), ("ut1", 31, 2.0**-24, 1), ("ut1_rate", 19, 2.0**-25, 1), ("", 11, None, 0)],
    37: [*CNAV_CLOCK, ("wna", 13, None, 0), ("toa", 8, 4096, 0), ("sat", 6, None, 0), ("l1l2l5", 3, None, 0), ("e", 11, 2.0**-16, 0),
         ("i", 11, semi(14), 1), ("alm_omega_dot", 11, semi(33), 1), ("sqrt_a", 17, 2.0**-4, 0), ("omega0", 16, semi(15), 1),
         ("omega", 16, semi(15), 1), ("m0", 16, semi(15), 1), ("alm_af0", 11, 2.0**-20, 1), ("alm_af1", 10, 2.0**-37, 1)],
}


# --- NavIC ---

NAVIC_HEAD = [("tlm", 8, None, 0), ("towc", 17, 12, 0), ("alert", 1, None, 0), ("autonav", 1, None, 0), ("id", 2, None, 0), ("", 1, None, 0)]
NAVIC = {
    1: [*NAVIC_HEAD, ("wn", 10, None, 0), ("af0", 22, 2.0**-31, 1), ("af1", 16, 2.0**-43, 1), ("af2", 8, 2.0**-55, 1), ("ura", 4, None, 0),
        ("toc", 16, 16, 0), ("tgd", 8, 2.0**-31, 1), ("delta_n", 22, semi(41), 1), ("iodec", 8, None, 0), ("", 10, None, 0), ("l5", 1, None, 0),
        ("s", 1, None, 0), ("cuc", 15, 2.0**-28, 1), ("cus", 15, 2.0**-28, 1), ("cic", 15, 2.0**-28, 1), ("cis", 15, 2.0**-28, 1),
        ("crc", 15, 2.0**-4, 1), ("crs", 15, 2.0**-4, 1), ("idot", 14, semi(43), 1), ("", 2, None, 0)],
    2: [*NAVIC_HEAD, ("m0", 32, semi(31), 1), ("toe", 16, 16, 0), ("e", 32, 2.0**-33, 0), ("sqrt_a", 32, 2.0**-19, 0), ("omega0", 32, semi(31), 1),
        ("omega", 32, semi(31), 1), ("omega_dot", 22, semi(41), 1), ("i0", 32, semi(31), 1), ("", 2, None, 0)],
    "almanac": [*NAVIC_HEAD, ("type", 6, None, 0), ("wna", 10, None, 0), ("e", 16, 2.0**-21, 0), ("toe", 16, 16, 0), ("i0", 24, semi(23), 1),
                ("omega_dot", 16, semi(38), 1), ("sqrt_a", 24, 2.0**-11, 0), ("omega0", 24, semi(23), 1), ("omega", 24, semi(23), 1),
                ("m0", 24, semi(23), 1), ("af0", 11, 2.0**-20, 1), ("af1", 11, 2.0**-38, 1), ("number", 6, None, 0), ("isc", 8, 2.0**-31, 1),
                ("", 6, None, 0), ("prn", 6, None, 0)],
    "utc": [*NAVIC_HEAD, ("type", 6, None, 0), ("a0", 16, 2.0**-35, 1), ("a1", 13, 2.0**-51, 1), ("a2", 7, 2.0**-68, 1), ("leap", 8, None, 1),
            ("tot", 16, 16, 0), ("wnot", 10, None, 0), ("wnlsf", 10, None, 0), ("dn", 4, None, 0), ("leap_future", 8, None, 1),
            ("a0g", 16, 2.0**-35, 1), ("a1g", 13, 2.0**-51, 1), ("a2g", 7, 2.0**-68, 1), ("totg", 16, 16, 0), ("wng", 10, None, 0),
            ("gnss", 3, None, 0), ("", 63, None, 0), ("prn", 6, None, 0)],
    "ionosphere": [*NAVIC_HEAD, ("type", 6, None, 0), ("eop", 138, None, 0), *[(f"alpha{k}", 8, 2.0**p, 1) for k, p in enumerate((-30, -27, -24, -24))],
                   *[(f"beta{k}", 8, 2.0**p, 1) for k, p in enumerate((11, 14, 16, 16))], ("", 18, None, 0), ("prn", 6, None, 0)],
}


def navic_subframe(data):
    """600 symbols -> the 262 bits ahead of the CRC; raises ValueError where anything does not hold."""
    text = bits_of(data, 600)
    if text[:16] != f"{0xEB90:016b}":
        raise ValueError("no synchronisation")
    bits, state = viterbi_free(deinterleaved(text[16:], 8, 73), 0)
    if state != 0 or crc24q(bits[:262]) != int(bits[262:286], 2):
        raise ValueError("CRC or tail")
    return bits[:262]


# --- SBAS ---

SBAS_HEAD = [("pre", 8, None, 0), ("type", 6, None, 0)]
SBAS = {
    1: [*SBAS_HEAD, *[(f"prn{k}", 1, None, 0) for k in range(1, 211)], ("iodp", 2, None, 0)],
    **{n: [*SBAS_HEAD, ("iodf", 2, None, 0), ("iodp", 2, None, 0), *[(f"prc{k}", 12, 0.125, 1) for k in range(13)],
           *[(f"udrei{k}", 4, None, 0) for k in range(13)]] for n in (0, 2, 3, 4)},
    6: [*SBAS_HEAD, *[(f"iodf{k}", 2, None, 0) for k in range(2, 6)], *[(f"udrei{k}", 4, None, 0) for k in range(51)]],
    7: [*SBAS_HEAD, ("latency", 4, None, 0), ("iodp", 2, None, 0), ("", 2, None, 0), *[(f"ai{k}", 4, None, 0) for k in range(51)]],
    9: [*SBAS_HEAD, ("", 8, None, 0), ("t0", 13, 16, 0), ("ura", 4, None, 0), ("x", 30, 0.08, 1), ("y", 30, 0.08, 1), ("z", 25, 0.4, 1),
        ("vx", 17, 0.000625, 1), ("vy", 17, 0.000625, 1), ("vz", 18, 0.004, 1), ("ax", 10, 0.0000125, 1), ("ay", 10, 0.0000125, 1),
        ("az", 10, 0.0000625, 1), ("af0", 12, 2.0**-31, 1), ("af1", 8, 2.0**-40, 1)],
    10: [*SBAS_HEAD, ("all", 131, None, 0), ("", 81, None, 0)],
    17: [*SBAS_HEAD, *[(f"{name}{k}", n, scale, signed) for k in range(3) for name, n, scale, signed in (
        ("id", 2, None, 0), ("prn", 8, None, 0), ("health", 8, None, 0), ("x", 15, 2600, 1), ("y", 15, 2600, 1), ("z", 9, 26000, 1), ("vx", 3, 10, 1),
        ("vy", 3, 10, 1), ("vz", 4, 60, 1))], ("t0", 11, 64, 0)],
    18: [*SBAS_HEAD, ("bands", 4, None, 0), ("band", 4, None, 0), ("iodi", 2, None, 0), ("mask", 201, None, 0), ("", 1, None, 0)],
    25: [*SBAS_HEAD, *[field for h in "ab" for field in (
        (f"code{h}", 1, None, 0), *[(f"{name}{h}{k}", n, None, signed) for k in range(2) for name, n, signed in (
            ("place", 6, 0), ("iod", 8, 0), ("dx", 9, 1), ("dy", 9, 1), ("dz", 9, 1), ("daf0", 10, 1))], (f"iodp{h}", 2, None, 0), ("", 1, None, 0))]],
    26: [*SBAS_HEAD, ("band", 4, None, 0), ("block", 4, None, 0), *[(f"{name}{k}", n, None, 0) for k in range(15) for name, n in (("delay", 9), ("givei", 4))],
         ("iodi", 2, None, 0), ("", 7, None, 0)],
    27: [*SBAS_HEAD, ("iods", 3, None, 0), ("messages", 3, None, 0), ("message", 3, None, 0), ("regions", 3, None, 0), ("priority", 2, None, 0),
         ("inside", 4, None, 0), ("outside", 4, None, 0), ("", 190, None, 0)],
}


def sbas_position(nine, seconds_of_day):
    """Message 9's parabola (A.4.4.11)."""
    dt = (seconds_of_day - nine["t0"] + 43200) % 86400 - 43200
    return tuple(nine[c] + nine["v" + c] * dt + 0.5 * nine["a" + c] * dt * dt for c in "xyz")


def cnav_elements(ten, eleven, a_reference):
    """The sum of both messages as elements (table 30-II)."""
    return {**ten, **eleven, "a": a_reference + ten["delta_a"], "omega_dot": -2.6e-9 * PI + eleven["delta_omega_dot"]}


def kepler_position(eph, t, gm, rate):
    """ecef position at t (seconds of the system's week, or the same far from it) by the documents' common algorithm."""
    tk = half_week(t - eph["toe"])
    a0 = eph["a"] if "a" in eph else eph["sqrt_a"]**2
    a = a0 + eph.get("a_dot", 0.0) * tk
    n = math.sqrt(gm / a0**3) + eph.get("delta_n", 0.0) + 0.5 * eph.get("n_dot", 0.0) * tk
    m = eph["m0"] + n * tk
    anomaly = m
    for _ in range(40):
        anomaly += (m - anomaly + eph["e"] * math.sin(anomaly)) / (1 - eph["e"] * math.cos(anomaly))
    nu = math.atan2(math.sqrt(1 - eph["e"]**2) * math.sin(anomaly), math.cos(anomaly) - eph["e"])
    phi = nu + eph["omega"]
    c2, s2 = math.cos(2 * phi), math.sin(2 * phi)
    u = phi + eph.get("cus", 0.0) * s2 + eph.get("cuc", 0.0) * c2
    r = a * (1 - eph["e"] * math.cos(anomaly)) + eph.get("crs", 0.0) * s2 + eph.get("crc", 0.0) * c2
    i = eph["i0"] + eph.get("idot", 0.0) * tk + eph.get("cis", 0.0) * s2 + eph.get("cic", 0.0) * c2
    tilted = eph.get("geo", False)
    node = eph["omega0"] + (eph["omega_dot"] - (0 if tilted else rate)) * tk - rate * eph["toe"]
    x, y = r * math.cos(u), r * math.sin(u)
    p = (x * math.cos(node) - y * math.cos(i) * math.sin(node), x * math.sin(node) + y * math.cos(i) * math.cos(node), y * math.sin(i))
    if not tilted:
        return p
    c, s = math.cos(math.radians(-5)), math.sin(math.radians(-5))
    p = (p[0], c * p[1] + s * p[2], -s * p[1] + c * p[2])
    c, s = math.cos(rate * tk), math.sin(rate * tk)
    return (c * p[0] + s * p[1], -s * p[0] + c * p[1], p[2])


def clock_of(eph, t):
    dt = half_week(t - eph["toc"])
    return eph["af0"] + eph["af1"] * dt + eph["af2"] * dt * dt
