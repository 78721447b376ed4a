# SPDX-License-Identifier: GPL-3.0-or-later
"""What a receiver does with navigation data bits: LNAV by IS-GPS-200, GLONASS FDMA by its ICD (L1, L2, edition 5.1). Written from
the documents, knows nothing of the program's encoders. Bits come as bytes, or as their hex text."""
import math

GM, EARTH_RATE, C = 3.986005e14, 7.2921151467e-5, 299792458.0
PI = 3.1415926535898  # the value that IS-GPS-200 prescribes


class Bits:
    """Bits numbered from 1 as the documents count them."""

    def __init__(self, text):
        self.text = text

    def unsigned(self, *fields):
        """(first, length), ...: parts of one value, highest first."""
        return int("".join(self.text[first - 1:first - 1 + n] for first, n in fields), 2)

    def signed(self, *fields):
        n = sum(length for _, length in fields)
        value = self.unsigned(*fields)
        return value - (1 << n) if value >> (n - 1) else value


def bits_of(data, n):
    """The first n bits in the order of their sending, as text."""
    data = bytes.fromhex(data) if isinstance(data, str) else data
    return "".join(f"{byte:08b}" for byte in data)[:n]


# --- LNAV ---

PARITY = (  # table 20-XIV: which of d1..d24 each of D25..D30 sums, and which of D29*, D30* of the word before
    ("29", (1, 2, 3, 5, 6, 10, 11, 12, 13, 14, 17, 18, 20, 23)),
    ("30", (2, 3, 4, 6, 7, 11, 12, 13, 14, 15, 18, 19, 21, 24)),
    ("29", (1, 3, 4, 5, 7, 8, 12, 13, 14, 15, 16, 19, 20, 22)),
    ("30", (2, 4, 5, 6, 8, 9, 13, 14, 15, 16, 17, 20, 21, 23)),
    ("30", (1, 3, 5, 6, 7, 9, 10, 14, 15, 16, 17, 18, 21, 22, 24)),
    ("29", (3, 5, 6, 8, 9, 10, 11, 13, 15, 19, 22, 23, 24)),
)


def lnav_subframe(data):
    """The data of a subframe as Bits 1..300 (parity bits as sent); raises ValueError where the parity does not hold."""
    sent = bits_of(data, 300)
    d29 = d30 = 0
    clear = ""
    for w in range(10):
        word = [int(b) for b in sent[30 * w:30 * w + 30]]
        source = [b ^ d30 for b in word[:24]]
        for k, (carry, members) in enumerate(PARITY):
            total = (d29 if carry == "29" else d30) + sum(source[m - 1] for m in members)
            if total % 2 != word[24 + k]:
                raise ValueError(f"parity bit {25 + k} of word {w + 1}")
        clear += "".join(map(str, source)) + sent[30 * w + 24:30 * w + 30]
        d29, d30 = word[28], word[29]
    if int(clear[:8], 2) != 0x8B:
        raise ValueError("no preamble")
    if sent[58:60] != "00" or sent[298:300] != "00":
        raise ValueError("words 2 and 10 do not end in 00")
    return Bits(clear)


def lnav_how(subframe):
    """Subframe number, and the time of week at which the next subframe begins."""
    return subframe.unsigned((50, 3)), 6 * subframe.unsigned((31, 17))


def lnav_ephemeris(one, two, three):
    """Subframes 1-3 as Bits -> the record, angles in radians."""
    u, s = (lambda b, *f: b.unsigned(*f)), (lambda b, *f: b.signed(*f))
    return {
        "tow": u(one, (31, 17)) * 6, "week": u(one, (61, 10)), "ura": u(one, (73, 4)), "health": u(one, (77, 6)),
        "iodc": u(one, (83, 2), (211, 8)), "tgd": s(one, (197, 8)) * 2**-31, "toc": u(one, (219, 16)) * 16,
        "af2": s(one, (241, 8)) * 2**-55, "af1": s(one, (249, 16)) * 2**-43, "af0": s(one, (271, 22)) * 2**-31,
        "iode": (u(two, (61, 8)), u(three, (271, 8))), "crs": s(two, (69, 16)) / 32,
        "delta_n": s(two, (91, 16)) * 2**-43 * PI, "m0": s(two, (107, 8), (121, 24)) * 2**-31 * PI,
        "cuc": s(two, (151, 16)) * 2**-29, "e": u(two, (167, 8), (181, 24)) * 2**-33, "cus": s(two, (211, 16)) * 2**-29,
        "sqrt_a": u(two, (227, 8), (241, 24)) * 2**-19, "toe": u(two, (271, 16)) * 16, "fit_flag": u(two, (287, 1)),
        "cic": s(three, (61, 16)) * 2**-29, "omega0": s(three, (77, 8), (91, 24)) * 2**-31 * PI,
        "cis": s(three, (121, 16)) * 2**-29, "i0": s(three, (137, 8), (151, 24)) * 2**-31 * PI,
        "crc": s(three, (181, 16)) / 32, "omega": s(three, (197, 8), (211, 24)) * 2**-31 * PI,
        "omega_dot": s(three, (241, 24)) * 2**-43 * PI, "idot": s(three, (279, 14)) * 2**-43 * PI,
    }


def lnav_klobuchar(page18):
    """alpha and beta of subframe 4 page 18."""
    first, power = (69, 77, 91, 99, 107, 121, 129, 137), (-30, -27, -24, -24, 11, 14, 16, 16)
    values = [page18.signed((f, 8)) * 2.0**p for f, p in zip(first, power)]
    return values[:4], values[4:]


def half_week(seconds):
    """The week's crossover (20.3.3.3.3.1)."""
    return (seconds + 302400) % 604800 - 302400


def lnav_position(eph, tow):
    """Table 20-IV: ecef position (m) at `tow`, and the clock (s) with its periodic relativity apart."""
    tk = half_week(tow - eph["toe"])
    a = eph["sqrt_a"]**2
    m = eph["m0"] + (math.sqrt(GM / a**3) + eph["delta_n"]) * tk
    anomaly = m
    for _ in range(30):
        anomaly += (m - anomaly + eph["e"] * math.sin(anomaly)) / (1 - eph["e"] * math.cos(anomaly))
    nu = math.atan2(math.sqrt(1 - eph["e"]**2) * math.sin(anomaly), math.cos(anomaly) - eph["e"])
    phi = nu + eph["omega"]
    c2, s2 = math.cos(2 * phi), math.sin(2 * phi)
    u = phi + eph["cus"] * s2 + eph["cuc"] * c2
    r = a * (1 - eph["e"] * math.cos(anomaly)) + eph["crs"] * s2 + eph["crc"] * c2
    i = eph["i0"] + eph["idot"] * tk + eph["cis"] * s2 + eph["cic"] * c2
    node = eph["omega0"] + (eph["omega_dot"] - EARTH_RATE) * tk - EARTH_RATE * eph["toe"]
    x, y = r * math.cos(u), r * math.sin(u)
    position = (x * math.cos(node) - y * math.cos(i) * math.sin(node), x * math.sin(node) + y * math.cos(i) * math.cos(node),
                y * math.sin(i))
    dt = half_week(tow - eph["toc"])
    relativity = -4.442807633e-10 * eph["e"] * eph["sqrt_a"] * math.sin(anomaly)
    return position, eph["af0"] + eph["af1"] * dt + eph["af2"] * dt * dt, relativity


def lnav_almanac(page):
    """A page of table 20-VI; None where no satellite is told of."""
    number = page.unsigned((63, 6))
    if not 1 <= number <= 32:
        return None
    return {
        "number": number, "e": page.unsigned((69, 16)) * 2**-21, "toe": page.unsigned((91, 8)) * 4096,
        "i0": (0.30 + page.signed((99, 16)) * 2**-19) * PI, "omega_dot": page.signed((121, 16)) * 2**-38 * PI,
        "health": page.unsigned((137, 8)), "sqrt_a": page.unsigned((151, 24)) * 2**-11,
        "omega0": page.signed((181, 24)) * 2**-23 * PI, "omega": page.signed((211, 24)) * 2**-23 * PI,
        "m0": page.signed((241, 24)) * 2**-23 * PI, "af0": page.signed((271, 8), (290, 3)) * 2**-20,
        "af1": page.signed((279, 11)) * 2**-38, "af2": 0.0, "toc": page.unsigned((91, 8)) * 4096,
        **dict.fromkeys(("delta_n", "idot", "cuc", "cus", "crc", "crs", "cic", "cis"), 0.0),
    }


# --- GLONASS ---

# Table 4.13: the bits that each of C1..C7 sums; C_sigma sums all.
CHECKS = (
    (1, {9, 10, 12, 13, 15, 17, 19, 20, 22, 24, 26, 28, 30, 32, 34, 35, 37, 39, 41, 43, 45, 47, 49, 51, 53, 55, 57, 59, 61,
         63, 65, 66, 68, 70, 72, 74, 76, 78, 80, 82, 84}),
    (2, {9, 11, 12, 14, 15, 18, 19, 21, 22, 25, 26, 29, 30, 33, 34, 36, 37, 40, 41, 44, 45, 48, 49, 52, 53, 56, 57, 60, 61,
         64, 65, 67, 68, 71, 72, 75, 76, 79, 80, 83, 84}),
    (3, {10, 11, 12} | set(range(16, 20)) | set(range(23, 27)) | set(range(31, 35)) | {38, 39, 40, 41} | {46, 47, 48, 49}
     | {54, 55, 56, 57} | {62, 63, 64, 65} | {69, 70, 71, 72} | {77, 78, 79, 80} | {85}),
    (4, {13, 14, 15, 16, 17, 18, 19} | set(range(27, 35)) | set(range(42, 50)) | set(range(58, 66)) | set(range(73, 81))),
    (5, set(range(20, 35)) | set(range(50, 66)) | set(range(81, 86))),
    (6, set(range(35, 66))),
    (7, set(range(66, 86))),
)


# It is a Hamming code: bit k of the string has the k-th place that is no power of 2, and C1..C7 sum by the places' digits.
PLACES = dict(zip(range(9, 86), (n for n in range(3, 100) if n & (n - 1))))
if any(members != {k for k, place in PLACES.items() if place >> (c - 1) & 1} for c, members in CHECKS):
    raise AssertionError("table 4.13 is not typed as it is")


def glonass_string(data):
    """The 85 bits, indexed by the ICD's numbers 85 (first) down to 1; raises ValueError where a check fails."""
    sent = bits_of(data, 85)
    bit = {85 - k: int(b) for k, b in enumerate(sent)}
    for number, members in CHECKS:
        if (bit[number] + sum(bit[m] for m in members)) % 2:
            raise ValueError(f"check C{number}")
    if sum(bit.values()) % 2:
        raise ValueError("check C sigma")
    if bit[85]:
        raise ValueError("the idle bit")
    return bit


def glonass_unsigned(bit, high, low):
    return int("".join(str(bit[k]) for k in range(high, low - 1, -1)), 2)


def glonass_signed(bit, high, low):
    """Sign and magnitude."""
    value = glonass_unsigned(bit, high - 1, low)
    return -value if bit[high] else value


def glonass_immediate(strings):
    """Strings 1-4 (by number) -> the record in SI units; t_b in seconds of the day in Moscow."""
    s1, s2, s3, s4 = (strings[k] for k in (1, 2, 3, 4))
    km = 1000.0
    return {
        "t_k": (glonass_unsigned(s1, 76, 72) * 60 + glonass_unsigned(s1, 71, 66)) * 60 + s1[65] * 30,
        "t_b": glonass_unsigned(s2, 76, 70) * 900, "unhealthy": s2[80] | s3[65],
        "pos": tuple(glonass_signed(s, 35, 9) * 2**-11 * km for s in (s1, s2, s3)),
        "vel": tuple(glonass_signed(s, 64, 41) * 2**-20 * km for s in (s1, s2, s3)),
        "acc": tuple(glonass_signed(s, 40, 36) * 2**-30 * km for s in (s1, s2, s3)),
        "gamma": glonass_signed(s3, 79, 69) * 2**-40, "tau": glonass_signed(s4, 80, 59) * 2**-30,
        "delta_tau": glonass_signed(s4, 58, 54) * 2**-30, "n_t": glonass_unsigned(s4, 26, 16),
        "slot": glonass_unsigned(s4, 15, 11),
    }


def glonass_position(eph, dt):
    """Runge-Kutta of ICD A.3.1.2 over dt seconds from t_b, steps of at most 30 s."""
    mu, radius, j2, rate = 398600.4418e9, 6378136.0, 1082625.75e-9, 7.292115e-5

    def derivative(y):
        x, v = y[:3], y[3:]
        r = math.sqrt(sum(c * c for c in x))
        k = 1.5 * j2 * mu * radius**2 / r**5
        z2 = 5 * x[2]**2 / r**2
        a = (-mu / r**3 * x[0] - k * x[0] * (1 - z2) + rate**2 * x[0] + 2 * rate * v[1] + eph["acc"][0],
             -mu / r**3 * x[1] - k * x[1] * (1 - z2) + rate**2 * x[1] - 2 * rate * v[0] + eph["acc"][1],
             -mu / r**3 * x[2] - k * x[2] * (3 - z2) + eph["acc"][2])
        return list(v) + list(a)

    y = list(eph["pos"]) + list(eph["vel"])
    n = max(1, math.ceil(abs(dt) / 30))
    h = dt / n
    for _ in range(n):
        k1 = derivative(y)
        k2 = derivative([a + h / 2 * b for a, b in zip(y, k1)])
        k3 = derivative([a + h / 2 * b for a, b in zip(y, k2)])
        k4 = derivative([a + h * b for a, b in zip(y, k3)])
        y = [a + h / 6 * (p + 2 * q + 2 * s + t) for a, p, q, s, t in zip(y, k1, k2, k3, k4)]
    return tuple(y[:3])
