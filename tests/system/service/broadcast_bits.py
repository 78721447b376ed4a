# SPDX-License-Identifier: GPL-3.0-or-later
"""A receiver's side of GPS LNAV and GLONASS, written from the ICDs alone: bits to numbers, numbers to positions."""
import math

C = 299792458.0


class Parity(Exception):
    """Bits that a receiver would not use."""


def bits_of(data, n):
    """The first n bits, in the order of their sending."""
    return [data[k // 8] >> (7 - k % 8) & 1 for k in range(n)]


def number(bits, signed=False):
    value = int("".join(map(str, bits)), 2)
    return value - (1 << len(bits)) if signed and bits[0] else value


# --- GPS: IS-GPS-200, 20.3.3 and tables 20-I, 20-III, 20-IV, 20-X, 20-XIV ---

PARITY = ((29, 1, 2, 3, 5, 6, 10, 11, 12, 13, 14, 17, 18, 20, 23), (30, 2, 3, 4, 6, 7, 11, 12, 13, 14, 15, 18, 19, 21, 24),
          (29, 1, 3, 4, 5, 7, 8, 12, 13, 14, 15, 16, 19, 20, 22), (30, 2, 4, 5, 6, 8, 9, 13, 14, 15, 16, 17, 20, 21, 23),
          (30, 1, 3, 5, 6, 7, 9, 10, 14, 15, 16, 17, 18, 21, 22, 24), (29, 3, 5, 6, 8, 9, 10, 11, 13, 15, 19, 22, 23, 24))


def lnav_words(data):
    """Ten lists of 24 data bits; each word's parity is looked at, with the two last bits of the word before."""
    sent, last, words = bits_of(data, 300), {29: 0, 30: 0}, []
    for k in range(10):
        word = sent[30 * k:30 * k + 30]
        source = [bit ^ last[30] for bit in word[:24]]
        for j, terms in enumerate(PARITY):
            if (last[terms[0]] + sum(source[i - 1] for i in terms[1:])) % 2 != word[24 + j]:
                raise Parity(f"word {k + 1}")
        words.append(source)
        last = {29: word[28], 30: word[29]}
    if number(words[0][:8]) != 0b10001011 or sent[58:60] != [0, 0] or sent[298:300] != [0, 0]:
        raise Parity("preamble, or a word that does not end in 00")
    return words


def how(words):
    """Subframe number, and the time of week at which the next subframe begins."""
    return number(words[1][19:22]), 6 * number(words[1][:17])


def field(words, *parts, scale=0, signed=True):
    """(word, first bit, last bit) from 1, most significant part first."""
    return number([b for w, i, j in parts for b in words[w - 1][i - 1:j]], signed) * 2.0**scale


def lnav_set(one, two, three):
    """What subframes 1 to 3 say, in semicircles as they are sent."""
    def u(w, *parts, scale=0):
        return field(w, *parts, scale=scale, signed=False)
    s = {
        "week": u(one, (3, 1, 10)), "health": u(one, (3, 17, 22)), "iodc": u(one, (3, 23, 24), (8, 1, 8)),
        "tgd": field(one, (7, 17, 24), scale=-31), "toc": u(one, (8, 9, 24), scale=4), "af2": field(one, (9, 1, 8), scale=-55),
        "af1": field(one, (9, 9, 24), scale=-43), "af0": field(one, (10, 1, 22), scale=-31),
        "iode2": u(two, (3, 1, 8)), "crs": field(two, (3, 9, 24), scale=-5), "delta_n": field(two, (4, 1, 16), scale=-43),
        "m0": field(two, (4, 17, 24), (5, 1, 24), scale=-31), "cuc": field(two, (6, 1, 16), scale=-29),
        "e": u(two, (6, 17, 24), (7, 1, 24), scale=-33), "cus": field(two, (8, 1, 16), scale=-29),
        "sqrt_a": u(two, (8, 17, 24), (9, 1, 24), scale=-19), "toe": u(two, (10, 1, 16), scale=4), "fit": u(two, (10, 17, 17)),
        "cic": field(three, (3, 1, 16), scale=-29), "omega0": field(three, (3, 17, 24), (4, 1, 24), scale=-31),
        "cis": field(three, (5, 1, 16), scale=-29), "i0": field(three, (5, 17, 24), (6, 1, 24), scale=-31),
        "crc": field(three, (7, 1, 16), scale=-5), "omega": field(three, (7, 17, 24), (8, 1, 24), scale=-31),
        "omega_dot": field(three, (9, 1, 24), scale=-43), "iode3": u(three, (10, 1, 8)), "idot": field(three, (10, 9, 22), scale=-43),
    }
    return s


def klobuchar(page18):
    """alpha and beta of subframe 4 page 18."""
    places = ((3, 9), (3, 17), (4, 1), (4, 9), (4, 17), (5, 1), (5, 9), (5, 17))
    values = [field(page18, (w, i, i + 7), scale=k) for (w, i), k in zip(places, (-30, -27, -24, -24, 11, 14, 16, 16))]
    return values[:4], values[4:]


def since(sow, reference):
    """Seconds from a reference of the week to a time of the week, by the nearest way."""
    return (sow - reference + 302400) % 604800 - 302400


def lnav_position(s, sow):
    """Table 20-IV."""
    pi, gm, rate = 3.1415926535898, 3.986005e14, 7.2921151467e-5
    a, t = s["sqrt_a"]**2, since(sow, s["toe"])
    m = s["m0"] * pi + (math.sqrt(gm / a**3) + s["delta_n"] * pi) * t
    anomaly = m
    for _ in range(30):
        anomaly += (m - anomaly + s["e"] * math.sin(anomaly)) / (1 - s["e"] * math.cos(anomaly))
    phi = math.atan2(math.sqrt(1 - s["e"]**2) * math.sin(anomaly), math.cos(anomaly) - s["e"]) + s["omega"] * pi
    sine, cosine = math.sin(2 * phi), math.cos(2 * phi)
    u = phi + s["cus"] * sine + s["cuc"] * cosine
    r = a * (1 - s["e"] * math.cos(anomaly)) + s["crs"] * sine + s["crc"] * cosine
    i = s["i0"] * pi + s["idot"] * pi * t + s["cis"] * sine + s["cic"] * cosine
    node = s["omega0"] * pi + (s["omega_dot"] * pi - rate) * t - rate * s["toe"]
    x, y = r * math.cos(u), r * math.sin(u)
    return (x * math.cos(node) - y * math.cos(i) * math.sin(node), x * math.sin(node) + y * math.cos(i) * math.cos(node),
            y * math.sin(i))


# --- GLONASS: ICD L1, L2, edition 5.1, tables 4.5 and 4.13, appendix 3.1.2 ---

HAMMING = dict(zip(range(9, 86), (n for n in range(3, 100) if n & (n - 1))))  # bit of the string -> position in the code


def glonass_string(data):
    """bit[85] (sent first) to bit[1], after a look at the check bits."""
    sent = bits_of(data, 85)
    bit = {85 - k: sent[k] for k in range(85)}
    for c in range(7):
        if (bit[c + 1] + sum(bit[k] for k, place in HAMMING.items() if place >> c & 1)) % 2:
            raise Parity(f"C{c + 1}")
    if sum(sent) % 2:
        raise Parity("C sigma")
    if bit[85]:
        raise Parity("the idle bit")
    return bit


def word(bit, high, low):
    return number([bit[k] for k in range(high, low - 1, -1)])


def signed(bit, high, low, scale):
    """Sign and magnitude."""
    return (-1)**bit[high] * word(bit, high - 1, low) * 2.0**scale


def glonass_set(strings):
    """What strings 1 to 4 say, SI units; t_b in seconds of the day in Moscow."""
    one, two, three, four = strings
    km = 1e3
    return {
        "pos": [signed(s, 35, 9, -11) * km for s in (one, two, three)],
        "vel": [signed(s, 64, 41, -20) * km for s in (one, two, three)],
        "acc": [signed(s, 40, 36, -30) * km for s in (one, two, three)],
        "t_k": 3600 * word(one, 76, 72) + 60 * word(one, 71, 66) + 30 * one[65], "t_b": 900 * word(two, 76, 70),
        "gamma": signed(three, 79, 69, -40), "tau": signed(four, 80, 59, -30), "delta_tau": signed(four, 58, 54, -30),
        "slot": word(four, 15, 11), "unfit": two[80] or three[65],
    }


def glonass_position(s, dt):
    """Position dt after t_b: Runge-Kutta of the fourth order, steps of at most 30 s."""
    gm, ae, j2, rate = 398600.4418e9, 6378136.0, 1082625.75e-9, 7.292115e-5

    def slope(y):
        x, v = y[:3], y[3:]
        r2 = sum(c * c for c in x)
        r = math.sqrt(r2)
        k, flat = -gm / r**3, 1.5 * j2 * gm * ae**2 / r**5
        z2 = 5 * x[2]**2 / r2
        return [*v, k * x[0] - flat * x[0] * (1 - z2) + rate**2 * x[0] + 2 * rate * v[1] + s["acc"][0],
                k * x[1] - flat * x[1] * (1 - z2) + rate**2 * x[1] - 2 * rate * v[0] + s["acc"][1],
                k * x[2] - flat * x[2] * (3 - z2) + s["acc"][2]]
    y, n = [*s["pos"], *s["vel"]], max(1, math.ceil(abs(dt) / 30))
    h = dt / n
    for _ in range(n):
        k1 = slope(y)
        k2 = slope([a + h / 2 * b for a, b in zip(y, k1)])
        k3 = slope([a + h / 2 * b for a, b in zip(y, k2)])
        k4 = slope([a + h * b for a, b in zip(y, k3)])
        y = [a + h / 6 * (p + 2 * q + 2 * r + t) for a, p, q, r, t in zip(y, k1, k2, k3, k4)]
    return y[:3]
