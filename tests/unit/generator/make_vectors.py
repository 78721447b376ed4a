#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""make_vectors.py: writes the table of src/generator/kernel/vectors.csv to standard output.

A hundred blocks, the words that a generator makes of them (docs/generator.md, every operation in IEEE doubles and integers,
written from the document and not from the C), and the phases at one sample of each: by the words, and exactly, by rational
arithmetic on the cubics. Numbers of the wire are written as C's %a, so that no digit is lost.
"""
import math
import random
from fractions import Fraction

C = 299792458
BITS = 39
SECOND = 10**9
SIGNALS = [  # carrier of channel 0, step of a channel, sub-chips a second, rates
    (1575420000, 0, 1023000, (2600000, 5000000, 10000000, 25000000)),
    (1575420000, 0, 2046000, (4000000, 5000000, 25000000)),
    (1575420000, 0, 12276000, (25000000, 50000000)),
    (1602000000, 562500, 511000, (10000000, 8000000)),
    (1176450000, 0, 10230000, (12500000, 25000000)),
    (1561098000, 0, 2046000, (5000000, 16368000)),
]


def beyond(c, s):
    return s * (c[1] + s * (c[2] + s * c[3]))


def cubic(c, s):
    return c[0] + s * (c[1] + s * (c[2] + s * c[3]))


def turns(x):
    return int((x - math.floor(x)) * 2.0**64) % 2**64


def since(block, rate, sample):
    s, ns = divmod(block, SECOND)
    return (float(sample - s * rate) * 1e9 - float(ns) * float(rate)) / (1e9 * float(rate))


def words(v):
    """The oscillators of a piece, step by step as docs/generator.md has them."""
    rate, chips = v["rate"], v["chips"]
    s0 = since(v["block"], rate, v["first"])
    s1 = since(v["block"], rate, v["first"] + v["n"])
    length = float(v["n"]) / float(rate)
    product = v["offset"] * (v["first"] % rate) % rate
    carrier = (turns(float(product) / float(rate)) - turns(cubic(v["carrier"], s0))) % 2**64
    phase_rate = (beyond(v["carrier"], s1) - beyond(v["carrier"], s0)) / length
    carrier_step = turns((float(v["offset"]) - phase_rate) / float(rate))
    whole, ns = divmod(v["transmit"], SECOND)
    scaled = ns * chips
    x = (float(scaled % SECOND) / 1e9 + v["rest"] * 1e-9 * float(chips)
         + (s0 - beyond(v["code"], s0) / float(C)) * float(chips))
    word = (scaled // SECOND << BITS) + (math.floor(x) << BITS) + int((x - math.floor(x)) * 2.0**BITS)
    carry, word = divmod(word, chips << BITS)
    stretch = (beyond(v["code"], s1) - beyond(v["code"], s0)) / length / float(C)
    code_step = int((1.0 - stretch) * float(chips) / float(rate) * 2.0**BITS + 0.5)
    return carrier, carrier_step, whole + carry, word, code_step


def exact(v, sample):
    """Carrier in cycles and code in sub-chips since the whole second of words(), as rationals."""
    t = Fraction(sample, v["rate"]) - Fraction(v["block"], SECOND)
    c = [Fraction(x) for x in v["carrier"]]
    r = [Fraction(x) for x in v["code"]]
    phase = Fraction(v["offset"]) * Fraction(sample, v["rate"]) - (c[0] + t * (c[1] + t * (c[2] + t * c[3])))
    sent = Fraction(v["transmit"], SECOND) + Fraction(v["rest"]) / SECOND + t - t * (r[1] + t * (r[2] + t * r[3])) / C
    return phase, sent * v["chips"]


def one(random_, number):
    carrier, step, chips, rates = random_.choice(SIGNALS)
    rate = random_.choice(rates)
    nominal = carrier + step * random_.randint(-7, 6) if step else carrier
    centre = carrier if random_.random() < 0.6 else carrier + random_.choice((-1000000, 420000, 1225000))
    length = random_.choice((1, 2, 5, 10, 20, 50, 100, 1000)) * 1000000
    block = (random_.randint(946684800, 1577836800) * SECOND // length) * length
    moving = length < 1000000000
    acceleration = random_.uniform(-25, 25) if moving else random_.uniform(-0.2, 0.2)
    jerk = random_.uniform(-100, 100) if moving else random_.uniform(-1e-4, 1e-4)
    speed = random_.uniform(-900, 900)
    code = [random_.uniform(2e7, 2.6e7), speed, acceleration / 2, jerk / 6]
    cycles = [random_.random()] + [x * nominal / C for x in code[1:]]
    begin = -(-block * rate // SECOND)  # the first sample of the block
    end = -(-(block + length) * rate // SECOND)
    first = begin if number % 4 == 0 else random_.randint(begin, end - 1) // 4096 * 4096
    first = max(first, begin)
    n = min(4096, end - first, 4096 - first % 4096)
    return {"block": block, "code": code, "carrier": cycles, "transmit": block - int(code[0] / C * 1e9),
            "rest": random_.random(), "rate": rate, "offset": nominal - centre, "chips": chips, "first": first, "n": n}


def main():
    random_ = random.Random(17)
    print("# SPDX-License-Identifier: MIT")
    print("# Written by tests/unit/generator/make_vectors.py; docs/generator.md says what each column is.")
    print("block_ns,code_m0,code_m1,code_m2,code_m3,carrier0,carrier1,carrier2,carrier3,transmit_ns,transmit_rest_ns,"
          "rate_hz,offset_hz,chips_per_s,first,n,carrier,carrier_step,code_s,code,code_step,"
          "sample,carrier_at_sample,code_at_sample,exact_cycles,exact_chips")
    for number in range(100):
        v = one(random_, number)
        carrier, carrier_step, code_s, code, code_step = words(v)
        sample = random_.randint(0, v["n"] - 1)
        phase, chips = exact(v, v["first"] + sample)
        chips -= code_s * v["chips"]
        fields = [v["block"], *(x.hex() for x in v["code"]), *(x.hex() for x in v["carrier"]), v["transmit"],
                  v["rest"].hex(), v["rate"], v["offset"], v["chips"], v["first"], v["n"],
                  *(f"0x{w:016x}" for w in (carrier, carrier_step)), code_s,
                  *(f"0x{w:016x}" for w in (code, code_step)), sample,
                  f"0x{(carrier + sample * carrier_step) % 2**64:016x}", f"0x{code + sample * code_step:016x}",
                  f"{float(phase - math.floor(phase)):.12f}", f"{float(chips):.9f}"]
        print(",".join(str(f) for f in fields))


if __name__ == "__main__":
    main()
