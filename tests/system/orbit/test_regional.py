# SPDX-License-Identifier: GPL-3.0-or-later
"""NavIC's SPS message and SBAS' messages. No centre publishes precise orbits of either: other satellites of a real day stand for them under their
names, three in inclined geosynchronous orbits for NavIC's, of which J03's has an eccentricity that a NavIC almanac cannot hold, and a geostationary
one for an SBAS satellite."""
import collections
import gzip
import math
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import messages  # noqa: E402
from program import Folder, data, run, run_json  # noqa: E402
from test_messages import WEEK, pages  # noqa: E402
from test_navfit import seconds, states, text_of  # noqa: E402

NAMES = {"C06": "I01", "J03": "I02", "C10": "I03", "J07": "S37"}


class Regional(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        with gzip.open(data("2020-177/Sta21114.sp3.gz"), "rt", encoding="ascii") as f:
            text = f.read()
        for own, other in NAMES.items():
            text = text.replace(own, other)
        sp3, cls.product = cls.path("renamed.sp3"), cls.path("regional.nc")
        pathlib.Path(sp3).write_text(text, encoding="ascii")
        run("orbit", "-q", "-o", cls.product, "--sat", "G05,G12,G31,I01,I02,I03,S37", sp3)
        cls.from_s = seconds("2020-06-25T12:58:00")
        cls.to_s = cls.from_s + 600
        run("navfit", "-q", cls.product, "--bits", cls.path("bits.csv"), "--symbols", cls.path("symbols.csv"), "--sat", "G,I,S", "--from",
            text_of(cls.from_s), "--to", text_of(cls.to_s))
        cls.bits, cls.symbols = pages(cls.path("bits.csv")), pages(cls.path("symbols.csv"))
        cls.claims = collections.defaultdict(list)
        for s in run_json("navfit", cls.product, "--format", "json")["sets"]:
            cls.claims[s["sat"]].append(s)
        cls.truth = states(cls.product, "G,I,S", cls.from_s, cls.to_s, 10)

    def claim_at(self, sat, t):
        return next(s for s in self.claims[sat] if s["message"] != "CNAV" and seconds(s["from"]) <= t < seconds(s["to"]))

    def check_rhythm(self, key, length):
        for stream in (self.bits[key], self.symbols[key]):
            for a, b in zip(stream, stream[1:]):
                self.assertEqual((a["length"], b["t"]), (length, a["t"] + length))
        self.assertEqual([p["t"] for p in self.bits[key]], [p["t"] for p in self.symbols[key]])

    def test_navic(self):
        keys = [k for k in self.symbols if k[0][0] == "I"]
        self.assertEqual(keys, [(f"I0{k}", "LNAV", "L5 S") for k in (1, 2, 3)])
        for key in keys:
            self.check_rhythm(key, 12.0)
            f, told, sets, kinds, toes = {}, {}, 0, set(), set()
            for page, plain in zip(self.symbols[key], self.bits[key]):
                word, t = messages.navic_subframe(page["hex"]), page["t"]
                self.assertEqual((page["bits"], plain["bits"]), (600, 292))
                self.assertEqual(word, messages.bits_of(plain["hex"], 262))
                kind = int(word[27:29], 2) + 1
                self.assertEqual((kind, int(word[8:25], 2) * 12, int(t) % 48 // 12 + 1), (page["number"], (t + 12) % WEEK, kind))
                if kind <= 2:
                    f = {} if kind == 1 else f
                    f[kind] = messages.fields(word, messages.NAVIC[kind])
                else:
                    number = int(word[30:36], 2)
                    kinds.add((kind, number))
                    self.assertEqual(int(word[256:262], 2), int(key[0][1:]))
                    if number == 7:
                        a = messages.fields(word, messages.NAVIC["almanac"])
                        told[a["number"]] = a
                    elif number == 9:
                        utc = messages.fields(word, messages.NAVIC["utc"])
                        self.assertEqual((utc["leap"], utc["leap_future"], utc["wnlsf"], utc["dn"], utc["a0"]), (18, 18, 1929 % 1024, 7, 0))
                    else:
                        self.assertEqual(messages.fields(word, messages.NAVIC["ionosphere"])["eop"], 0)
                if kind != 2 or 1 not in f:
                    continue
                eph = {**f[1], **f[2]}
                self.assertEqual((eph["toe"], eph["ura"], eph["l5"], eph["s"], eph["wn"]), (eph["toc"], 0, 0, 0, t // WEEK % 1024))
                toes.add((eph["toe"], eph["iodec"]))
                t -= t % 10
                claim = self.claim_at(key[0], page["t"])
                error = math.dist(messages.kepler_position(eph, t, 3.986005e14, 7.2921151467e-5), self.truth[key[0], t][0])
                self.assertLess(error, 1.1 * claim["max_m"] + 0.002, (key, t))
                self.assertLess(claim["max_m"], 0.1)
                self.assertLess(abs(messages.clock_of(eph, t) - self.truth[key[0], t][1]), 3e-9)
                sets += 1
            self.assertGreater(sets, 10)
            self.assertEqual(len(toes), 2)  # an update at 13:00
            self.assertEqual(kinds, {(3, 7), (4, 9), (4, 11)})
            self.assertEqual(set(told), {1, 3})
            for sat, a in told.items():
                t = self.from_s + 60
                error = math.dist(messages.kepler_position(a, t, 3.986005e14, 7.2921151467e-5), self.truth[f"I{sat:02d}", t][0])
                print(f"almanac of I{sat:02d}: {error:.0f} m")
                self.assertLess(error, 20000)

    def sbas_messages(self):
        """(t, fields) of every message; symbols, CRC, preambles and bits agree."""
        key, state = ("S37", "SBAS", "L1CA"), None
        self.check_rhythm(key, 1.0)
        for page, plain in zip(self.symbols[key], self.bits[key]):
            direct, text = messages.bits_of(plain["hex"], 250), messages.bits_of(page["hex"], 500)
            if state is None:
                state = int(direct[-6:], 2)
            else:
                bits, state = messages.viterbi_free([int(b) for b in text], 0, state)
                self.assertEqual(bits, direct)
            self.assertEqual(messages.crc24q(direct[:226]), int(direct[226:], 2))
            kind = int(direct[8:14], 2)
            own = messages.fields(direct[:226], messages.SBAS[kind])
            self.assertEqual((own["pre"], kind), ((0x53, 0x9A, 0xC6)[int(page["t"]) % 3], page["number"]))
            yield page["t"], kind, own

    def test_sbas_ranging(self):
        nines, almanacs, worst = [], [], 0.0
        for t, kind, m in self.sbas_messages():
            if kind == 9:
                nines.append((t, m))
            elif kind == 17:
                almanacs.append((t, m))
        self.assertGreaterEqual(len(nines), 10)  # one a minute
        self.assertGreaterEqual(len({m["t0"] for _, m in nines}), 3)
        for t, nine in nines:
            self.assertEqual(nine["ura"], 0)
            claim = self.claim_at("S37", t)
            for ahead in range(0, 130, 10):
                at = t - t % 10 + ahead
                if abs(at % 86400 - nine["t0"]) > 150 or ("S37", at) not in self.truth:
                    continue
                true, clock = self.truth["S37", at]
                error = math.dist(messages.sbas_position(nine, at % 86400), true)
                worst = max(worst, error)
                self.assertLess(error, 1.1 * claim["max_m"] + 0.01)
                self.assertLess(abs(nine["af0"] + nine["af1"] * (at % 86400 - nine["t0"]) - clock), 1e-9)  # periodic relativity is 1e-10 s there
        print(f"SBAS: {worst:.3f} m at most")
        self.assertLess(worst, 0.4)  # half of the LSB of z is 0.2 m, and of vz over 150 s 0.3 m
        self.assertGreaterEqual(len(almanacs), 9)
        for t, a in almanacs:
            self.assertEqual((a["prn0"], a["health0"], a["prn1"], a["prn2"]), (137, 0x20, 0, 0))  # of MSAS, healthy
            self.assertEqual(a["t0"], t % 86400 // 64 * 64)
            true = self.truth["S37", t - t % 10][0]
            self.assertLess(math.dist((a["x0"], a["y0"], a["z0"]), true), math.hypot(1300, 1300, 13000) + 2000)

    def test_sbas_corrections(self):
        """Zero or none, and as often as RTCA DO-229E table A-25 demands."""
        seen, masks, longest = collections.defaultdict(list), [], {0: 0, 1: 120, 2: 6, 3: 6, 4: 6, 7: 120, 9: 120, 10: 120, 17: 300, 18: 300, 27: 300}
        places, blocks, issue = set(), set(), {}
        for t, kind, m in self.sbas_messages():
            seen[kind].append(t)
            if kind == 1:
                masks.append([k for k in range(1, 211) if m[f"prn{k}"]])
            elif kind in (2, 3, 4):
                self.assertEqual([m[f"prc{k}"] for k in range(13)], [0.0] * 13)
                self.assertEqual([m[f"udrei{k}"] for k in range(13)], [0, 0, 0] + [14] * 10 if kind == 2 else [14] * 13)
                self.assertEqual(m["iodf"], t // 6 % 3)
                issue[kind] = m["iodf"]
            elif kind == 6:
                self.assertEqual([m[f"udrei{k}"] for k in range(51)], [0, 0, 0] + [14] * 48)
                if len(issue) == 3:
                    self.assertEqual([m[f"iodf{k}"] for k in (2, 3, 4)], [issue[k] for k in (2, 3, 4)])
            elif kind == 10:
                self.assertEqual(m["all"], 0)
            elif kind == 18:
                self.assertEqual((m["bands"], m["mask"].bit_count()), (1, 201))
                band = m["band"]
            elif kind == 26:
                self.assertEqual({(m[f"delay{k}"], m[f"givei{k}"]) for k in range(15)}, {(511, 15)})
                blocks.add((m["band"], m["block"]))
            elif kind == 25:
                for h in "ab":
                    for k in "01":
                        self.assertEqual([m[f"{n}{h}{k}"] for n in ("dx", "dy", "dz", "daf0")], [0] * 4)
                        if m[f"place{h}{k}"]:
                            places.add(m[f"place{h}{k}"])
                            sat = ("G05", "G12", "G31")[m[f"place{h}{k}"] - 1]
                            self.assertEqual(m[f"iod{h}{k}"], self.claim_at(sat, t)["iode"])
        self.assertEqual(set(map(tuple, masks)), {(5, 12, 31)})
        self.assertEqual(set(seen), {1, 2, 3, 4, 6, 7, 9, 10, 17, 18, 25, 26, 27})
        for kind, limit in longest.items():
            for a, b in zip(seen[kind], seen[kind][1:]):
                self.assertLessEqual(b - a, limit, kind)
        self.assertEqual(places, {1, 2, 3})
        self.assertEqual(blocks, {(band, k) for k in range(14)})
        self.assertEqual(band, int((math.degrees(math.atan2(*self.truth["S37", self.from_s][0][1::-1])) + 180) // 40))


del Folder
if __name__ == "__main__":
    unittest.main(verbosity=2)
