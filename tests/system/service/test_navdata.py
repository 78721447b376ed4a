#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Broadcast data over the wire. A receiver that is written from the ICDs alone (tests/system/navdata.py) decodes the bits; where it then
believes the satellites to be is compared with what STATES says of them. On made data, and on a real day where there is one."""
import csv
import io
import json
import math
import os
import pathlib
import threading
import unittest

from daemon import PATIENCE_S, ROOT, WORK, Daemon, Served, orrery as program, product  # first: it sets the path

import messages as messages_of_receivers
import navdata as receiver
import orrery
from orrery import frame, messages
from orrery.client import connect
from test_clients import receive_exactly

NS = 10**9
WEEK = 604800 * NS
DATA = pathlib.Path(os.environ.get("ORRERY_DATA") or ROOT / "../shared/data")
LEAP_S = 18  # GPS - UTC in 2024 and 2025


def no_value(x):
    return math.isnan(x)


class Decoded:
    """What a receiver makes of one satellite of a NAVDATA."""

    def __init__(self, sat):
        data = {p.number: p for p in sat.pages}
        self.sat = sat
        if sat.message == orrery.NavMessage.LNAV:
            subframes = [receiver.lnav_subframe(data[k].data) for k in range(1, 6)]
            for k, bits in enumerate(subframes):
                subframe, next_begins = receiver.lnav_how(bits)
                if subframe != k + 1 or (data[k + 1].t // NS + 6) % 604800 != next_begins % 604800:
                    raise AssertionError(f"HOW says subframe {subframe}, next at {next_begins}")
            self.set = receiver.lnav_ephemeris(*subframes[:3])
        else:
            strings = {k: receiver.glonass_string(data[k].data) for k in range(1, 16)}
            if any(receiver.glonass_unsigned(bit, 84, 81) != k for k, bit in strings.items()):
                raise AssertionError("the strings are not 1 to 15")
            self.set = receiver.glonass_immediate(strings)

    def moscow(self, t):
        return (t - (LEAP_S - 3 * 3600) * NS) % (86400 * NS) / NS

    def position(self, t):
        if self.sat.message == orrery.NavMessage.LNAV:
            return receiver.lnav_position(self.set, t % WEEK / NS)[0]
        return receiver.glonass_position(self.set, self.moscow(t) - self.set["t_b"])

    def clock(self, t, state):
        """Clock against the system's time, without periodic relativity; GLONASS' contains that."""
        if self.sat.message == orrery.NavMessage.LNAV:
            return receiver.lnav_position(self.set, t % WEEK / NS)[1]
        r_dot_v = sum(a * b for a, b in zip(state.pos_m, state.vel_mps))
        return -self.set["tau"] + self.set["gamma"] * (self.moscow(t) - self.set["t_b"]) + 2 * r_dot_v / receiver.C**2


class OnTheWire:
    """The tests; the classes below say on which product."""

    @classmethod
    def serve(cls, path):
        super().serve(path)
        cls.path = path
        cls.start, cls.end = cls.client.span
        cls.noon = cls.start + 43200 * NS

    def sent(self, t):
        """Legacy messages of GPS and GLONASS; system.orbit.messages decodes the others."""
        return [s for s in self.client.navdata(t).satellites
                if s.answer == orrery.Answer.OK and s.message in (orrery.NavMessage.LNAV, orrery.NavMessage.FDMA)]

    def test_all_messages_as_symbols(self):
        """What POLL_NAVDATA gives of all messages is what `orrery navfit --symbols` writes."""
        at, n = self.noon + 12 * NS, 3
        path = WORK / f"{type(self).__name__}-symbols.csv"
        done = program("navfit", "-q", self.path, "--symbols", path, "--from", orrery.to_text(at - 50 * NS), "--to", orrery.to_text(at + 50 * (n + 1) * NS))
        self.assertEqual(done.returncode, 0, done.stderr)
        with path.open(encoding="ascii") as f:
            direct = {(r["t_gps"], r["sat"], r["message"], r["signals"]): r for r in csv.DictReader(x for x in f if x[0] != "#")}
        seen = set()
        for m in self.client.poll_navdata(at, 30, n, kinds=0xffffffff, form=orrery.NavForm.SYMBOLS):
            for s in m.satellites:
                self.assertEqual(s.form, orrery.NavForm.SYMBOLS)
                message = orrery.NavMessage(s.message).name
                seen.add((message, s.signals))
                for p in s.pages:
                    row = direct[orrery.to_text(p.t), orrery.sat_name(s.sat), message, s.signals]
                    self.assertEqual((p.data.hex(), p.bits, p.number, p.page), (row["hex"], int(row["bits"]), int(row["number"]), int(row["page"])))
                    self.assertEqual(p.length / NS, float(row["length_s"]))
        self.assertLessEqual({("LNAV", "L1CA"), ("FDMA", "L1OF L2OF"), ("INAV", "E1"), ("INAV", "E5b"), ("FNAV", "E5a")}, seen)
        galileo = next(s.sat for s in m.satellites if chr(s.sat.system) == "E")
        one, = self.client.navdata(at, [galileo], kinds=orrery.NavMessages.FNAV).satellites
        self.assertEqual((one.message, len(one.pages)), (orrery.NavMessage.FNAV, 5))
        with self.assertRaisesRegex(orrery.Refused, "form"):
            self.client._ask(messages.PollNavdata(messages.Epochs(at, 0, 1), [], 0, 7), messages.Navdata)

    def test_bits_say_what_the_set_says(self):
        for s in self.sent(self.noon + 5 * NS):
            d = Decoded(s).set
            if s.message == orrery.NavMessage.LNAV:
                k, = s.kepler
                self.assertEqual((s.glonass, len(s.pages)), ([], 5))
                self.assertEqual((d["iodc"], d["iode"], d["iodc"] % 256), (s.iodc, (s.iode, s.iode), s.iode))
                self.assertEqual((d["toe"], d["toc"], d["week"]), (s.toe % WEEK / NS, s.toc % WEEK / NS, s.frame_from // WEEK % 1024))
                self.assertEqual((d["af0"], d["af1"], d["af2"], d["health"]), (s.af0_s, s.af1_sps, s.af2_sps2, s.health))
                self.assertEqual((d["sqrt_a"], d["e"], d["crs"], d["crc"]), (k.sqrt_a_sqrtm, k.e, k.crs_m, k.crc_m))
                self.assertEqual((d["cuc"], d["cus"], d["cic"], d["cis"], d["tgd"]), (k.cuc_rad, k.cus_rad, k.cic_rad, k.cis_rad, k.tgd_s))
                for name, value in (("m0", k.m0_rad), ("i0", k.i0_rad), ("omega0", k.omega0_rad), ("omega", k.omega_rad),
                                    ("delta_n", k.delta_n_radps), ("idot", k.idot_radps), ("omega_dot", k.omega_dot_radps)):
                    self.assertAlmostEqual(d[name], value, delta=1e-12 * abs(value))  # the ICD's pi has 14 digits
            else:
                g, = s.glonass
                self.assertEqual((s.kepler, len(s.pages), s.iode, s.iodc, s.week), ([], 15, -1, -1, -1))
                self.assertEqual([list(d[k]) for k in ("pos", "vel", "acc")], [g.pos_m, g.vel_mps, g.acc_mps2])
                self.assertEqual((d["t_b"], -d["tau"], d["gamma"]), ((s.toe // NS - LEAP_S + 10800) % 86400, s.af0_s, s.af1_sps))
                self.assertEqual((d["slot"], d["unhealthy"], d["delta_tau"]), (s.sat.number, s.health, g.delta_tau_s))
                self.assertEqual(d["t_k"], (s.frame_from // NS - LEAP_S + 10800) % 86400)

    def test_a_receiver_finds_the_satellites_where_states_says(self):
        """Within the largest distance that the set reports. The report looks every 5 minutes, the receiver in between too: a
        twentieth more; RINEX' and the ICD's pi, RK4's step and 8 um of the states' own fit: a millimetre."""
        seen = set()
        for t in range(self.start + 7 * NS, self.end, 5000 * NS + 123456789):
            states = {orrery.sat_name(s.sat): s for s in self.client.states(t).satellites}
            for s in self.sent(t):
                self.assertTrue(s.set_from <= t < s.set_to and s.frame_from <= t < s.frame_to)
                name, decoded = orrery.sat_name(s.sat), Decoded(s)
                state = states[name]
                if state.answer != orrery.Answer.OK:
                    continue
                self.assertLess(math.dist(decoded.position(t), state.pos_m), 1.05 * s.fit_max_m + 1e-3, f"{name} at {orrery.to_text(t)}")
                self.assertLess(s.fit_rms_m, 0.2 if s.message == orrery.NavMessage.LNAV else 0.7)
                if state.flags & orrery.StateFlags.CLOCK_VALID and not s.notes & orrery.NavNotes.CLOCK_JUMP:
                    # a straight line through a clock of white frequency noise: six of its RMS, and the last digit sent
                    self.assertLess(abs(decoded.clock(t, state) - state.clock_s), 6 * s.clock_rms_s + 1e-9)
                seen.add(name[0])
        self.assertEqual(seen, {"G", "R"})

    def test_every_half_minute_is_the_whole_stream(self):
        last = {}
        for m in self.client.poll_navdata(self.noon + 17 * NS, 30, 40):
            for s in m.satellites:
                for p in s.pages:
                    if s.message == orrery.NavMessage.FDMA:
                        self.assertEqual(p.length, 17 * NS // 10)
                    length = 2 * NS if s.message == orrery.NavMessage.FDMA else p.length
                    name = orrery.sat_name(s.sat)
                    if name in last:
                        self.assertEqual(p.t, last[name] + length)
                    last[name] = p.t
        self.assertGreater(len(last), 4)

    def test_the_program_says_the_same(self):
        at, n = self.noon + 12 * NS, 6
        done = program("poll", self.url, "--navdata", "--pages", "--at", orrery.to_text(at), "--step", 30, "--count", n)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        over = set(done.stdout.splitlines())
        bits = WORK / f"{type(self).__name__}.csv"
        fitted = program("navfit", self.path, "--bits", bits, "--from", orrery.to_text(at - 30 * NS), "--to",
                         orrery.to_text(at + 30 * n * NS))
        self.assertEqual(fitted.returncode, 0, fitted.stderr)
        direct = set(bits.read_text().splitlines())
        pages = [p for m in self.client.poll_navdata(at, 30, n) for s in m.satellites for p in s.pages]
        self.assertEqual(len(over), len(pages) + 1)
        self.assertEqual(over - direct, set())  # every bit of them
        rows = list(csv.DictReader(io.StringIO(program("poll", self.url, "--navdata", "--format", "csv", "--at", orrery.to_text(at)).stdout)))
        line = program("poll", self.url, "--navdata", "--format", "json", "--at", orrery.to_text(at)).stdout
        for s, row, j in zip(self.client.navdata(at).satellites, rows, json.loads(line)["satellites"], strict=True):
            self.assertEqual((row["sat"], j["sat"]), (orrery.sat_name(s.sat),) * 2)
            self.assertEqual(j["answer"], orrery.Answer(s.answer).name)
            if s.answer != orrery.Answer.OK:
                self.assertEqual(row["answer"], orrery.Answer(s.answer).name)
                self.assertEqual(set(row.values()) - {row["t_gps"], row["sat"], row["answer"]}, {""})
                continue
            self.assertEqual((float(row["af0_s"]), j["af0_s"], float(row["fit_max_m"])), (s.af0_s, s.af0_s, s.fit_max_m))
            self.assertEqual([p["hex"] for p in j["pages"]], [p.data.hex() for p in s.pages])
            if s.kepler:
                self.assertEqual((float(row["omega0_rad"]), j["kepler"]["cis_rad"]), (s.kepler[0].omega0_rad, s.kepler[0].cis_rad))
            else:
                self.assertEqual((float(row["z_m"]), int(row["channel"])), (s.glonass[0].pos_m[2], s.glonass[0].channel))

    def test_zero_has_no_sign(self):
        """Rates and accelerations below half of their last digit are sent as zero, and shown as that."""
        done = program("poll", self.url, "--navdata", "--format", "csv", "--at", orrery.to_text(self.start + 60 * NS), "--step", 1800, "--count", 46)
        cells = [x for row in csv.reader(io.StringIO(done.stdout)) for x in row]
        self.assertIn("0", cells)
        self.assertEqual([x for x in cells if x.startswith("-") and float(x) == 0], [])

    def test_the_same_question_gets_the_same_bytes(self):
        many = [s.sat for s in self.client.navdata(self.noon).satellites] * 800
        poll = messages.PollNavdata(messages.Epochs(self.noon, 3600 * NS, 3), many[:800])  # frames far above the usual output buffer

        def payloads():
            with connect(self.url, PATIENCE_S) as sock:
                sock.sendall(frame.make(messages.PollNavdata.TYPE, 5, poll.encode()))
                return [frame.read(lambda n: receive_exactly(sock, n)).payload for _ in range(poll.count)]
        one, got = payloads(), {}
        self.assertGreater(len(one[0]), 200000)
        threads = [threading.Thread(target=lambda k=k: got.update({k: payloads()})) for k in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual([got[k] for k in range(4)], [one] * 4)


class Made(OnTheWire, Served):
    def test_never_a_number_where_there_is_none(self):
        m = self.client.navdata(self.noon, ["C01", "G31", "R01"])
        self.assertEqual([s.answer for s in m.satellites], [orrery.Answer.NOT_SERVED, orrery.Answer.NOT_SERVED, orrery.Answer.OK])
        for s in m.satellites[:2]:
            self.assertTrue(all(map(no_value, (s.accuracy_m, s.fit_rms_m, s.fit_max_m, s.clock_rms_s, s.af0_s, s.af1_sps, s.af2_sps2))))
            self.assertEqual((s.kepler, s.glonass, s.pages, s.message, s.notes), ([], [], [], 0, 0))
            self.assertEqual({s.set_from, s.set_to, s.toe, s.toc, s.frame_from, s.frame_to}, {-2**63})
            self.assertEqual((s.week, s.iode, s.iodc), (-1, -1, -1))
        m = self.client.navdata(self.end + 1)
        self.assertEqual((m.answer, m.satellites), (orrery.Answer.OUTSIDE_SPAN, []))
        self.assertEqual(program("poll", self.url, "--navdata", "--sat", "C01").returncode, 1)
        self.assertEqual(program("poll", self.url, "--pages").returncode, 2)
        with self.assertRaisesRegex(orrery.Refused, "step is 0"):
            self.client._ask(messages.PollNavdata(messages.Epochs(0, 0, 2), []), messages.Navdata)


class RealDay(OnTheWire, Served):
    @classmethod
    def setUpClass(cls):
        sp3 = DATA / "2024-035/COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz"
        if not sp3.exists():
            raise unittest.SkipTest("2024-035 is not here (set ORRERY_DATA)")
        path = WORK / "real.nc"
        made = program("orbit", "-o", path, "--nodes", 900, "--sat", "G01,G05,G14,G25,G32,R01,R07,R24,E11", sp3)
        if made.returncode != 0:
            raise RuntimeError(made.stderr)
        cls.serve(path)


class Scenarios(unittest.TestCase):
    def served(self, name, text):
        product()
        (WORK / name).write_text(text, encoding="utf-8")
        return Daemon(WORK / name)

    def refused(self, words, daemon):
        with daemon as d, orrery.Client(d.urls[0]) as client:
            with self.assertRaisesRegex(orrery.Refused, words) as refused:
                client.navdata(client.span[0])
            self.assertEqual(refused.exception.code, orrery.ErrorCode.NOT_SERVED)
            self.assertEqual(client.states(client.span[0]).answer, orrery.Answer.OK)  # the rest is served

    def test_scenarios_without(self):
        self.refused("navdata.window", self.served("none.yaml", "orbit: {product: day.nc}\nnavdata: {window: none}\n"))
        done = program("orbit", "-o", WORK / "galileo.nc", "--sat", "E", ROOT / "samples/ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz")
        self.assertEqual(done.returncode, 0, done.stderr)
        with Daemon(WORK / "galileo.nc") as d, orrery.Client(d.urls[0]) as client:
            self.assertEqual({s.message for s in client.navdata(client.span[0]).satellites}, {orrery.NavMessage.INAV})

    def test_scenarios_that_are_none(self):
        for text, words in (("navdata: {window: 3h}", "none of 2h, 4h, none"), ("navdata: {window: none, zero_clocks: yes}", "has no effect with navdata.window none"),
                            ("navdata: {antex: missing.atx}", "missing.atx"), ("navdata: {nav: [day.nc]}", "day.nc"),
                            ("navdata: {bias: day.nc}", "day.nc")):
            product()
            (WORK / "bad.yaml").write_text("orbit: {product: day.nc}\n" + text + "\n", encoding="utf-8")
            done = program("serve", WORK / "bad.yaml", "--listen", "tcp://127.0.0.1:0")
            self.assertEqual(done.returncode, 1, text)
            self.assertIn(words, done.stderr)

    def test_window(self):
        """Sets for 4 hours describe them; their fit is worse, and they are sent from two hours before toe on."""
        with self.served("four.yaml", "orbit: {product: day.nc}\nnavdata: {window: 4h}\n") as d, orrery.Client(d.urls[0]) as client:
            t = client.span[0] + 43205 * NS
            s, = client.navdata(t, ["G03"]).satellites
            self.assertEqual((s.toe - s.set_from, s.set_to - s.set_from), (7200 * NS, 7200 * NS))
            self.assertLess(math.dist(Decoded(s).position(t), client.states(t, ["G03"]).satellites[0].pos_m), 1.05 * s.fit_max_m + 1e-3)

    def test_klobuchar_of_the_ionosphere_is_broadcast(self):
        """A navigation file as ionosphere.field gives POLL_DELAYS its model and page 18 its coefficients; navdata.nav overrules."""
        alpha, beta = [2**-26, -2**-25, 2**-23, -3 * 2**-24], [2.0**16, -2.0**15, 3 * 2.0**16, -2.0**18]
        fitted = program("navfit", product(), "-o", WORK / "sets.rnx", "--sat", "G")
        self.assertEqual(fitted.returncode, 0, fitted.stderr)
        lines = [x for x in (WORK / "sets.rnx").read_text().splitlines(keepends=True) if "IONOSPHERIC CORR" not in x]

        def header(name, scale):
            return "".join(f"{k} " + "".join(f"{v * scale:12.4E}" for v in x).ljust(55) + "IONOSPHERIC CORR\n"
                           for k, x in (("GPSA", alpha), ("GPSB", beta)))
        for name, scale in (("field.rnx", 1), ("other.rnx", 2)):
            (WORK / name).write_text("".join([lines[0], header(name, scale), *lines[1:]]), encoding="utf-8")
        for more, scale in (("", 1), ("navdata: {nav: other.rnx}\n", 2), ("navdata: {nav: sets.rnx}\n", 1)):
            with self.served("klobuchar.yaml", "orbit: {product: day.nc}\nionosphere: {field: field.rnx}\n" + more) as d, \
                    orrery.Client(d.urls[0]) as client:
                t = next(t for t in range(client.span[0], client.span[1], 30 * NS) if t % WEEK // (30 * NS) % 25 == 17)
                m, = client.navdata(t, ["G01"]).satellites
                self.assertEqual(m.answer, orrery.Answer.OK)
                four = next(p for p in m.pages if p.number == 4)
                self.assertEqual(four.page, 18)
                got = receiver.lnav_klobuchar(receiver.lnav_subframe(four.data))
            for value, want, step in zip([*got[0], *got[1]], [*alpha, *beta], (-30, -27, -24, -24, 11, 14, 16, 16)):
                self.assertAlmostEqual(value, scale * want, delta=0.6 * 2.0**step)  # RINEX has five digits of it


    def test_sbas_at_a_longitude(self):
        """A satellite that the scenario places over the Equator sends its place; fifteen messages of a second follow one another."""
        with self.served("geo.yaml", "orbit:\n  product: day.nc\n  geo:\n    - {sat: S23, longitude: 31.5}\n") as d, orrery.Client(d.urls[0]) as client:
            t = client.span[0] + 40000 * NS
            last, nines, pages = None, [], 0
            for k in range(4):
                s, = client.navdata(t + 15 * k * NS, ["S23"], form=orrery.NavForm.BITS).satellites
                self.assertEqual((s.answer, s.message, s.signals, s.health), (orrery.Answer.OK, orrery.NavMessage.SBAS, "L1CA", 0))
                self.assertEqual((s.kepler, len(s.pages), s.af0_s), ([], 15, 0))
                state, = client.states(t, ["S23"]).satellites
                self.assertLess(math.dist(s.glonass[0].pos_m, state.pos_m), 0.1)  # half an LSB of x and y: 0.04 m
                self.assertLess(abs(math.degrees(math.atan2(s.glonass[0].pos_m[1], s.glonass[0].pos_m[0])) - 31.5), 1e-6)
                for p in s.pages:
                    self.assertEqual((p.bits, p.length), (250, NS))
                    self.assertTrue(last is None or p.t == last + NS)
                    last, pages = p.t, pages + 1
                    text = receiver.bits_of(p.data, 250)
                    self.assertEqual(messages_of_receivers.crc24q(text[:226]), int(text[226:], 2))
                    if p.number == 9:
                        nines.append(messages_of_receivers.fields(text[:226], messages_of_receivers.SBAS[9]))
            self.assertEqual((pages, len(nines)), (60, 1))
            self.assertLess(math.dist((nines[0]["x"], nines[0]["y"], nines[0]["z"]), state.pos_m), 0.1)
            self.assertEqual([nines[0][k] for k in ("vx", "vy", "vz", "ax", "ay", "az", "af0", "af1")], [0] * 8)

    def test_navic_by_its_records(self):
        """NavIC's satellites come from a navigation file; their message is fitted to what is served of them."""
        nav = DATA / "rinex4-nav/BRD400DLR_S_20230710000_01D_MN.rnx.gz"
        if not nav.exists():
            self.skipTest("rinex4-nav is not here (set ORRERY_DATA)")
        with self.served("navic.yaml", f"orbit: {{nav: {nav}}}\n") as d, orrery.Client(d.urls[0]) as client:
            t = client.span[0] + (client.span[1] - client.span[0]) // 2
            sent = [s for s in client.navdata(t, kinds=orrery.NavMessages.LNAV, form=orrery.NavForm.SYMBOLS).satellites
                    if chr(s.sat.system) == "I" and s.answer == orrery.Answer.OK]
            self.assertGreater(len(sent), 3)
            for s in sent:
                words = [messages_of_receivers.navic_subframe(p.data) for p in s.pages]
                f = {**messages_of_receivers.fields(words[0], messages_of_receivers.NAVIC[1]), **messages_of_receivers.fields(words[1], messages_of_receivers.NAVIC[2])}
                state, = client.states(t, [s.sat]).satellites
                position = messages_of_receivers.kepler_position(f, t % WEEK / NS, 3.986005e14, 7.2921151467e-5)
                self.assertLess(math.dist(position, state.pos_m), 1.1 * s.fit_max_m + 0.01, orrery.sat_name(s.sat))


if __name__ == "__main__":
    unittest.main(argv=[__file__])
