# SPDX-License-Identifier: GPL-3.0-or-later
"""CNAV-2 and B-CNAV: a receiver that is written from the documents alone (tests/system/modern_messages.py) takes the symbols, finds every
parity check fulfilled, the bits that `--bits` writes, and in them times, almanacs and the orbit within what the report claims."""
import collections
import math
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import messages  # noqa: E402
import modern_messages as modern  # noqa: E402
from program import Folder, data, run, run_json  # noqa: E402
from test_messages import pages  # noqa: E402
from test_navfit import seconds, states, text_of  # noqa: E402

WEEK = 604800
BDT = 14  # seconds behind GPS time
ELEMENTS = [name for name, *_ in modern.FIRST + modern.SECOND] + ["omega0", "i0", "idot", "toe", "af0", "af1", "af2"]


class ModernMessages(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.product = cls.path("all.nc")
        run("orbit", "-q", "-o", cls.product, "--sat", "G05,G12,J02,C06,C19,C38", data("2020-177/Sta21114.sp3.gz"))
        cls.from_s = seconds("2020-06-25T12:22:00")  # BeiDou's and QZSS' sets change at 12:30
        cls.to_s = cls.from_s + 720
        run("navfit", "-q", cls.product, "--message", "D1,CNAV,CNV1,CNV2,CNV3", "--bits", cls.path("bits.csv"), "--symbols", cls.path("symbols.csv"),
            "--from", text_of(cls.from_s), "--to", text_of(cls.to_s))
        cls.bits, cls.symbols = pages(cls.path("bits.csv")), pages(cls.path("symbols.csv"))
        cls.claims = collections.defaultdict(list)
        for s in run_json("navfit", cls.product, "--format", "json")["sets"]:
            cls.claims[s["sat"], s["message"]].append(s)
        cls.truth = states(cls.product, "G,C,J", cls.from_s, cls.to_s, 60)

    def both(self, key, length):
        """Pages as symbols and as bits: one behind the other, none missing."""
        bits, symbols = self.bits[key], self.symbols[key]
        self.assertEqual([(p["t"], p["number"]) for p in bits], [(p["t"], p["number"]) for p in symbols])
        self.assertGreater(len(bits), (self.to_s - self.from_s) / length - 2)
        for a, b in zip(bits, bits[1:]):
            self.assertEqual((a["length"], b["t"]), (length, a["t"] + length))
        return zip(symbols, bits)

    def check_orbit(self, key, eph, sent, system_s, gm, rate):
        """Of the set that was sent: orbit and clock at the whole minutes about it, within what the report claims."""
        t = sent - sent % 60
        if t <= self.from_s:
            return False
        claim = next(s for s in self.claims[key[:2]] if seconds(s["from"]) <= sent < seconds(s["to"]))
        true, clock = self.truth[key[0], t]
        self.assertLess(math.dist(messages.kepler_position(eph, t - system_s, gm, rate), true), 1.1 * claim["max_m"] + 0.002, (key, t))
        if clock is not None:
            self.assertLess(abs(messages.clock_of(eph, t - system_s) - clock), 3e-9, (key, t))
        return True

    def check_midi(self, a, system, numbers):
        """A midi almanac tells where the satellite is to 0.01 deg, as its fields allow."""
        self.assertIn(a["sat"], numbers)
        sat, t = f"{system}{a['sat']:02d}", self.from_s + 60
        system_s = BDT if system == "C" else 0
        gm, rate = (messages.BEIDOU_GM, messages.BEIDOU_RATE) if system == "C" else (3.986005e14, messages.GALILEO_RATE)
        eph = {**a, "i0": a["i"] + 0.3 * messages.PI, "toe": a["toa"]}
        true, clock = self.truth[sat, t]
        self.assertLess(math.dist(messages.kepler_position(eph, t - system_s, gm, rate), true), 12000, sat)
        self.assertLess(abs(a["af0"] + a["af1"] * messages.half_week(t - system_s - a["toa"]) - clock), 2e-6)
        return a["sat"]

    def check_reduced(self, f, n, system, references):
        """Reduced almanacs: circular orbits of the nominal inclination, within half an LSB of both angles (0.025 rad each) and
        2 e (0.02)."""
        found = set()
        for k in range(n):
            number = f[f"prn{k}"]
            if number == 0:
                continue
            t, system_s = self.from_s + 60, BDT if system == "C" else 0
            a = references[number] + f[f"delta_a{k}"]
            eph = {"a": a, "e": 0.0, "m0": f[f"phi0{k}"], "omega": 0.0, "i0": math.radians(55), "omega0": f[f"omega0{k}"],
                   "omega_dot": -2.6e-9 * messages.PI if system == "G" else 0.0, "toe": f["toa"]}
            true = self.truth[f"{system}{number:02d}", t][0]
            place = messages.kepler_position(eph, t - system_s, messages.BEIDOU_GM, messages.BEIDOU_RATE)
            self.assertLess(math.dist(place, true) / a, 0.07, (system, number))
            self.assertEqual(f[f"health{k}"], 0)
            found.add(number)
        return found

    def check_rotation(self, f):
        """The pole of that day by IERS' C04 series, and UT1: (0.1393, 0.4368) arc seconds, UT1 - UTC = -0.2346 s; a product without a
        file of rotation knows the secular pole and UT1 to 0.4 s."""
        self.assertLess(abs(f["xp"] / modern.ARCSECOND - 0.139), 0.1)
        self.assertLess(abs(f["yp"] / modern.ARCSECOND - 0.437), 0.1)
        self.assertLess(abs(f["ut1"] + 0.2346), 0.5)

    def test_cnav2(self):
        keys = [k for k in self.symbols if k[1:] == ("CNV2", "L1C")]
        self.assertEqual({k[0] for k in keys}, {"G05", "G12", "J02"})
        for key in keys:
            number = int(key[0][1:]) + (192 if key[0][0] == "J" else 0)
            seen, told, sets, tops = collections.Counter(), {"midi": set(), "reduced": set()}, 0, set()
            for page, plain in self.both(key, 18.0):
                toi, f, third, text = modern.cnav2_frame(page["hex"])
                self.assertEqual(text, messages.bits_of(plain["hex"], 883))
                t = page["t"]
                self.assertEqual((f["wn"], f["itow"], 18 * toi), (t // WEEK, t % WEEK // 7200 * 7200, (t + 18) % 7200))
                self.assertEqual((f["health"], f["ed"], f["wnop"], third["prn"], third["page"]), (0, 0, t // WEEK % 256, number, page["number"]))
                tops.add((f["top"], f["toe"]))
                seen[third["page"]] += 1
                sets += self.check_orbit(key, modern.cnav2_elements(f, 26559710.0 if key[0][0] == "G" else 42164200.0), t, 0, 3.986005e14,
                                         messages.GALILEO_RATE)
                if third["page"] == 1:
                    self.assertEqual((third["leap"], third["leap_future"], third["wnlsf"], third["dn"], third["a0"]), (18, 18, 1929, 7, 0))
                elif third["page"] == 2:
                    self.check_rotation(third)
                    self.assertEqual((third["gnss"], third["a0g"]), (0, 0))
                elif third["page"] == 3:
                    told["reduced"] |= self.check_reduced(third, 6, "G", dict.fromkeys((5, 12), 26559710.0))
                else:
                    told["midi"].add(self.check_midi(third, "G", (5, 12)))
            self.assertGreater(sets, 30)
            self.assertEqual(set(seen), {1, 2, 3, 4} if key[0][0] == "G" else {1, 2})
            if key[0][0] == "G":
                self.assertEqual(told, {"midi": {5, 12}, "reduced": {5, 12}})
            self.assertEqual(len(tops), 2 if key[0][0] == "J" else 1)

    def beidou_keys(self, message, signals):
        keys = [k for k in self.symbols if k[1:] == (message, signals)]
        self.assertEqual({k[0] for k in keys}, {"C19", "C38"})  # C06 is a BeiDou-2 satellite
        return keys

    def check_beidou_orbit(self, key, f, t):
        self.assertEqual(f["sat_type"], 3 if key[0] == "C19" else 2)
        return self.check_orbit(key, modern.bcnav_elements(f), t, BDT, messages.BEIDOU_GM, messages.BEIDOU_RATE)

    def check_beidou_utc(self, f):
        self.assertEqual((f["leap"], f["leap_future"], f["wnlsf"], f["dn"], f["a0"]), (4, 4, 1929 - 1356, 6, 0))

    REFERENCES = {6: 42162200.0, 19: 27906100.0, 38: 42162200.0}

    def test_bcnav1(self):
        for key in self.beidou_keys("CNV1", "B1C"):
            seen, midi, few, sets, issues, offsets = collections.Counter(), set(), set(), 0, [], set()
            for page, plain in self.both(key, 18.0):
                number, soh, f, third, text = modern.bcnav1_frame(page["hex"])
                self.assertEqual(text, messages.bits_of(plain["hex"], 878))
                t = page["t"] - BDT
                self.assertEqual((number, f["how"] + soh, f["wn"]), (int(key[0][1:]), t % WEEK, t // WEEK - 1356))
                self.assertEqual((third["page"], third["hs"], third["dif"], f["iodc"] % 256), (page["number"], 0, 0, f["iode"]))
                if (f["iodc"], f["toe"], f["toc"]) not in issues:
                    issues.append((f["iodc"], f["toe"], f["toc"]))
                seen[third["page"]] += 1
                sets += self.check_beidou_orbit(key, f, page["t"])
                if third["page"] == 1:
                    self.check_beidou_utc(third)
                elif third["page"] == 2:
                    few |= self.check_reduced(third, 4, "C", self.REFERENCES)
                elif third["page"] == 3:
                    self.check_rotation(third)
                    offsets.add(third["gnss"])
                else:
                    midi.add(self.check_midi(third, "C", (6, 19, 38)))
            self.assertGreater(sets, 30)
            self.assertEqual((set(seen), midi, few, offsets), ({1, 2, 3, 4}, {6, 19, 38}, {6, 19, 38}, {1, 2, 3}))
            self.assertEqual([b[1] - a[1] for a, b in zip(issues, issues[1:])], [3600])
            self.assertNotEqual(issues[0][0], issues[1][0])

    def test_bcnav2(self):
        for key in self.beidou_keys("CNV2", "B2a"):
            seen, midi, few, sets, f, kinds, offsets = collections.Counter(), set(), set(), 0, {}, [], set()
            for page, plain in self.both(key, 3.0):
                own, text = modern.bcnav2_message(page["hex"])
                self.assertEqual(text, messages.bits_of(plain["hex"], 312))
                t, kind = page["t"] - BDT, own["type"]
                self.assertEqual((own["prn"], own["sow"], kind), (int(key[0][1:]), t % WEEK, page["number"]))
                self.assertEqual((own["b2a"], own["b1c"], own.get("hs", 0)), (0, 0, 0))
                seen[kind] += 1
                kinds.append(kind)
                if kind == 10:
                    f = {}
                    self.assertEqual(own["wn"], t // WEEK - 1356)
                if 30 <= kind <= 34 and "iode" in f:  # every clock with the elements of its issue
                    self.assertEqual(own["iodc"] % 256, f["iode"])
                    if "toc" in f:
                        self.assertEqual([own[n] for n in ("toc", "af0", "af1", "iodc")], [f[n] for n in ("toc", "af0", "af1", "iodc")])
                if kind in (10, 11, 30):
                    f.update(own)
                if kind == 30 and "omega0" in f and "iode" in f:
                    sets += self.check_beidou_orbit(key, f, page["t"])
                elif kind == 31:
                    few |= self.check_reduced(own, 3, "C", self.REFERENCES)
                elif kind == 32:
                    self.check_rotation(own)
                elif kind == 33:
                    few |= self.check_reduced(own, 1, "C", self.REFERENCES)
                    offsets.add(own["gnss"])
                elif kind == 34:
                    self.check_beidou_utc(own)
                elif kind == 40:
                    midi.add(self.check_midi(own, "C", (6, 19, 38)))
            self.assertGreater(sets, 50)
            self.assertEqual((set(seen), midi, few, offsets), ({10, 11, 30, 31, 32, 33, 34, 40}, {6, 19, 38}, {6, 19, 38}, {1, 2, 3}))
            self.assertTrue(all(b == 11 for a, b in zip(kinds, kinds[1:]) if a == 10))  # the halves follow one another (6.2.3)

    def test_bcnav3(self):
        for key in self.beidou_keys("CNV3", "B2b"):
            seen, midi, few, sets, f, offsets = collections.Counter(), set(), set(), 0, {}, set()
            for page, plain in self.both(key, 1.0):
                number, own, text = modern.bcnav3_message(page["hex"])
                self.assertEqual(text, messages.bits_of(plain["hex"], 514))
                t, kind = page["t"] - BDT, own["type"]
                self.assertEqual((number, own["sow"], kind), (int(key[0][1:]), t % WEEK, page["number"]))
                seen[kind] += 1
                if kind == 10:
                    f = own
                    self.assertEqual((own["dif"], own["sif"], own["aif"]), (0, 0, 0))
                elif kind == 30 and f:
                    self.assertEqual((own["wn"], own["toc"], own["hs"]), (t // WEEK - 1356, f["toe"], 0))
                    self.check_beidou_utc(own)
                    self.check_rotation(own)
                    sets += self.check_beidou_orbit(key, {**f, **own}, page["t"])
                elif kind == 40:
                    midi.add(self.check_midi(own, "C", (6, 19, 38)))
                    few |= self.check_reduced(own, 5, "C", self.REFERENCES)
                    offsets.add(own["gnss"])
            self.assertGreater(sets, 200)
            self.assertEqual((set(seen), midi, few, offsets), ({10, 30, 40}, {6, 19, 38}, {6, 19, 38}, {1, 2, 3}))

    def test_one_set_in_all_messages(self):
        """At one instant every message of a satellite tells the same elements and clock, to the last bit."""
        t = self.from_s + 300

        def at(sat, message, signals, kinds):
            stream = self.symbols[sat, message, signals]
            return [next(p for p in reversed(stream) if p["t"] <= t and (k is None or p["number"] == k)) for k in kinds]

        for sat in ("C19", "C38"):
            one = modern.bcnav1_frame(at(sat, "CNV1", "B1C", [None])[0]["hex"])[2]
            two, three = {}, {}
            for page in at(sat, "CNV2", "B2a", [10, 11, 30]):
                two.update(modern.bcnav2_message(page["hex"])[0])
            for page in at(sat, "CNV3", "B2b", [10, 30]):
                three.update(modern.bcnav3_message(page["hex"])[1])
            for name in [*ELEMENTS, "toc", "omega_dot"]:
                self.assertEqual((two[name], three[name]), (one[name], one[name]), (sat, name))
            self.assertEqual((two["iodc"], two["iode"]), (one["iodc"], one["iode"]))
        for sat in ("G05", "G12", "J02"):
            two, c = modern.cnav2_frame(at(sat, "CNV2", "L1C", [None])[0]["hex"])[1], {}
            for page in at(sat, "CNAV", "L5", [10, 11, 30]):
                plain = next(p for p in self.bits[sat, "CNAV", "L5"] if p["t"] == page["t"])
                c.update(messages.fields(messages.bits_of(plain["hex"], 276), messages.CNAV[page["number"]]))
            for name in [*ELEMENTS, "delta_omega_dot", "top", "tgd"]:
                self.assertEqual(two[name], c[name], (sat, name))

    def test_a_wrong_symbol_is_found(self):
        for (_, message, signals), read in {("C19", "CNV1", "B1C"): modern.bcnav1_frame, ("C19", "CNV2", "B2a"): modern.bcnav2_message,
                                            ("C19", "CNV3", "B2b"): modern.bcnav3_message, ("G05", "CNV2", "L1C"): modern.cnav2_frame}.items():
            page = next(iter(self.symbols[next(k for k in self.symbols if k[1:] == (message, signals))]))
            wrong = bytearray.fromhex(page["hex"])
            for at in (5, 20, len(wrong) - 1):
                wrong[at] ^= 1
                with self.assertRaises(ValueError):
                    read(bytes(wrong))
                wrong[at] ^= 1


del Folder  # a base class is no test
if __name__ == "__main__":
    unittest.main(verbosity=2)
