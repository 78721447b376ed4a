# SPDX-License-Identifier: GPL-3.0-or-later
"""RTCM 3, UBX and NMEA of `orrery simulate` against its RINEX: by readers written from the formats' documents, and by RTKLIB's convbin. They agree to what the
formats' last bits and RINEX' last digits leave."""
import collections
import csv
import math
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import unittest

SYSTEM = pathlib.Path(__file__).resolve().parent.parent
sys.path[:0] = [str(SYSTEM), str(SYSTEM / "orbit")]
import rtcm  # noqa: E402
from program import Folder, data, run, sample  # noqa: E402
from test_messages import rinex_records  # noqa: E402
from test_navfit_files import agree, rinex_records_any  # noqa: E402

C = 299792458.0
MM = 0.5e-3 + 1e-7  # RINEX' last digit, half of it, and what a double of 1e8 cycles leaves
CODE_LSB_M = {7: 299792.458 / 2**29, 4: 299792.458 / 2**24}
PHASE_LSB_M = {7: 299792.458 / 2**31, 4: 299792.458 / 2**29}
ANTENNAS = """
antennas:
  - {name: BASE, position: [%s]}
mask: {elevation: 5}
"""


class Streams(Folder):
    """One run of `orrery simulate`: `orbit` lines of the scenario, `place` of the antenna, from `day` `first` s on."""

    msm = 7

    @classmethod
    def simulate(cls, scenario, *options):
        path = pathlib.Path(cls.path("scenario.yaml"))
        path.write_text(scenario, encoding="ascii")
        done = run("simulate", path, "-o", cls.folder, "--rtcm", "--msm", cls.msm, "--ubx", "--nmea", "--no-imu", *options)
        cls.said = done.stderr
        cls.types, cls.ours = rtcm.rinex_obs(cls.path("BASE.rnx"))
        cls.rtcm = list(rtcm.frames((cls.folder / "BASE.rtcm3").read_bytes()))
        cls.ubx = list(rtcm.ubx((cls.folder / "BASE.ubx").read_bytes()))
        cls.channels = {line[:3]: int(line[3:6]) for k in re.findall(r"^(.{60})GLONASS SLOT / FRQ #", (cls.folder / "BASE.rnx").read_text(), re.M)
                        for line in (k[4 + 7 * j:10 + 7 * j] for j in range(8)) if line.strip()}

    def judge(self, sat, code, mine, code_m, phase, half_code_m, half_phase_cycles):
        """An observation against RINEX'; returns by how many whole cycles the phase was shifted."""
        self.assertAlmostEqual(code_m, mine["C" + code][0], delta=MM + half_code_m, msg=(sat, code))
        apart = phase - mine["L" + code][0]
        self.assertAlmostEqual(apart, round(apart), delta=MM + half_phase_cycles, msg=(sat, code))
        return round(apart)

    def messages(self):
        """Observations of RTCM by epoch (s of the day), with what each epoch's messages say of their time."""
        epochs, heads = [], []
        for number, content in self.rtcm:
            if number // 10 not in rtcm.SYSTEM:
                continue
            head, cells = rtcm.msm(content)
            self.assertEqual((number % 10, head["station"], head["rest"]), (self.msm, 1, (0,) * 6))
            if not heads or not heads[-1][-1]["more"]:  # the epoch before has ended
                heads.append([])
                epochs.append({})
            heads[-1].append(head)
            self.assertFalse(set(cells) & set(epochs[-1]), "no signal is told twice")
            epochs[-1].update(cells)
        self.assertFalse(heads[-1][-1]["more"])
        return epochs, heads

    def check_rtcm(self):
        epochs, heads = self.messages()
        self.assertEqual(len(epochs), len(self.ours))
        shifts, since, skipped = {}, {}, collections.Counter()
        for (t, ours), cells, told in zip(self.ours.items(), epochs, heads):
            for head in told:  # every system by its own clock
                of_day = t - {"C": 14, "R": 18 - 10800}.get(head["system"], 0)
                self.assertEqual(head["ms"] % 86400000, round(of_day % 86400 * 1000))
                day = head["day"] if head["system"] == "R" else head["ms"] // 86400000
                self.assertEqual(day, (self.weekday * 86400 + of_day) // 86400 % 7)
            seen = {(sat, name[1:]) for sat, values in ours.items() for name in values if name[0] == "C"}
            for missing in seen - set(cells):
                skipped[missing[0][0] + missing[1]] += 1
            self.assertFalse(set(cells) - seen)
            for (sat, code), cell in cells.items():
                mine, hz = ours[sat], rtcm.carrier(sat[0], code, self.channels.get(sat))
                if sat[0] == "R" and self.msm == 7:
                    self.assertEqual(cell["channel"], self.channels[sat])
                self.assertLess(abs(cell["code_m"] - cell["phase_m"]), 1172)
                shift = self.judge(sat, code, mine, cell["code_m"], cell["phase_m"] * hz / C, CODE_LSB_M[self.msm] / 2,
                                   PHASE_LSB_M[self.msm] / 2 * hz / C)
                if mine["L" + code][1] & 1 or since.get((sat, code), (None,))[0] is None:
                    since[sat, code] = (t, shift)
                elif shift != since[sat, code][1]:
                    shifts[sat, code] = t  # brought back near the code: a slip, and told so
                    self.assertEqual(cell["lock_ms"], 0)
                    since[sat, code] = (t, shift)
                lock = 1000 * (t - since[sat, code][0])
                self.assertTrue(cell["lock_ms"] <= lock and lock < max(2 * cell["lock_ms"], 64), (sat, code, cell["lock_ms"], lock))
                self.assertEqual(cell["half"], 0)
                self.assertAlmostEqual(cell["cn0"], mine["S" + code][0], delta=0.0005 + (1 / 32 if self.msm == 7 else 0.5))
                if self.msm == 7:
                    self.assertAlmostEqual(-cell["rate_mps"] * hz / C, mine["D" + code][0], delta=MM + 0.5e-4 * hz / C)
        self.assertEqual(set(skipped), self.without)
        return shifts

    def check_station(self):
        place = next(tuple(map(float, line[:60].split())) for line in (self.folder / "BASE.rnx").read_text().splitlines() if "APPROX POSITION" in line)
        told = collections.Counter(number for number, _ in self.rtcm)
        for number, content in self.rtcm:
            if number in (1005, 1006):
                s = rtcm.station(content)
                self.assertLess(math.dist(s["place_m"], place), 1e-4)
                self.assertEqual((s["station"], s["virtual"], s["one_oscillator"], s["quarter"], s["height_m"] or 0), (1, 0, 1, 1, 0))
                self.assertEqual(s["systems"], tuple(int(x in self.types) for x in "GRE"))
            elif number == 1033:
                s = rtcm.station(content)
                self.assertEqual((s["antenna"], s["receiver"], s["serial"]), ("NONE", "ORRERY SIMULATED", ""))
            elif number == 1230:
                self.assertEqual(rtcm.station(content), {"station": 1, "aligned": 1, "biases_m": {k: 0.0 for k in ("1C", "2C") if "C" + k in self.types["R"]}})
        self.assertEqual({told[k] for k in (1005, 1006, 1033)}, {told[1230] or told[1005]})

    def check_ubx(self):
        messages = [rtcm.rawx(p) for kind, number, p in self.ubx if (kind, number) == (2, 0x15)]
        self.assertEqual(len(messages), len(self.ours))
        for (t, ours), (head, cells) in zip(self.ours.items(), messages):
            self.assertAlmostEqual(head["tow"], self.weekday * 86400 + t, delta=1e-6)
            self.assertEqual((head["week"], head["leap"], head["state"], head["version"]), (self.week, 18, 1, 1))
            for (sat, component), cell in cells.items():
                code = component if "C" + component in ours[sat] else component[0] + "X"
                shift = self.judge(sat, code, ours[sat], cell["code_m"], cell["phase"] + 0.5 * (sat in self.d2), 1e-8, 1e-7)
                self.assertEqual(shift, 0, "phases are RINEX' own")
                self.assertAlmostEqual(cell["doppler"], ours[sat]["D" + code][0], delta=MM + 3e-4)
                self.assertAlmostEqual(cell["cn0"], ours[sat]["S" + code][0], delta=0.5 + MM)
                self.assertEqual((cell["flags"], cell["channel"]), (7, self.channels.get(sat)))
            self.assertEqual({sat for sat, _ in cells} | self.not_in_ubx, set(ours) | self.not_in_ubx)
        self.check_solutions()

    def check_solutions(self):
        """NAV-PVT is the true motion of BASE-track.csv."""
        rows = csv.DictReader((self.folder / "BASE-track.csv").read_text(encoding="ascii").splitlines())
        solutions = [p for kind, number, p in self.ubx if (kind, number) == (1, 7)]
        self.assertEqual(len(solutions), len(self.ours))
        for (t, ours), row, p in zip(self.ours.items(), rows, solutions):
            tow, year, month, day, hour, minute, second, valid, _, nano, fix, flags, _, sats = struct.unpack_from("<IHBBBBBBIiBBBB", p)
            lon, lat, height, _, _, _, north, east, down, speed = struct.unpack_from("<iiiiIIiiii", p, 24)
            self.assertEqual((tow, fix, flags, sats, valid), (1000 * (self.weekday * 86400 + t), 3, 1, len(ours), 7))
            utc = round(t - 18)
            self.assertEqual((f"{year}/{month:02d}/{day:02d}", 3600 * hour + 60 * minute + second, nano), (self.date, utc, 0))
            self.assertAlmostEqual(lat, 1e7 * float(row["lat_deg"]), delta=0.51)
            self.assertAlmostEqual(lon, 1e7 * float(row["lon_deg"]), delta=0.51)
            self.assertAlmostEqual(height, 1e3 * float(row["height_m"]), delta=0.6)
            v = [float(row[k]) for k in ("vx_mps", "vy_mps", "vz_mps")]
            self.assertAlmostEqual(math.hypot(north, east, down), 1e3 * math.hypot(*v), delta=1)
            self.assertAlmostEqual(math.hypot(north, east), speed, delta=1.2)

    def convbin(self, kind, name):
        if shutil.which("convbin") is None:
            self.skipTest("RTKLIB's convbin is not here")
        out = [self.path(f"{kind}.{x}") for x in ("obs", "nav")]
        subprocess.run(["convbin", "-r", kind, "-tr", self.date, "00:00:00", "-od", "-os", "-v", "3.04", "-o", out[0], "-n", out[1], self.path(name)],
                       capture_output=True, check=True, timeout=60)
        return rtcm.rinex_obs(out[0])[1], out[1]

    def check_convbin(self):
        """RTKLIB's reading, of RTCM and of UBX: values, lost locks."""
        for kind, name, code_m in (("rtcm3", "BASE.rtcm3", CODE_LSB_M[self.msm] / 2), ("ubx", "BASE.ubx", 0)):
            theirs, _ = self.convbin(kind, name)
            self.assertEqual(set(theirs), set(self.ours))
            compared = set()
            for t, sats in theirs.items():
                for sat, values in sats.items():
                    for their_code in (n[1:] for n in values if n[0] == "C"):
                        code = their_code if "C" + their_code in self.ours[t][sat] else their_code[0] + "X"
                        hz = rtcm.carrier(sat[0], code, self.channels.get(sat))
                        # RTKLIB writes its doubles to the same digit: one more half of it.
                        shift = self.judge(sat, code, self.ours[t][sat], values["C" + their_code][0], values["L" + their_code][0], MM + code_m,
                                           MM + (PHASE_LSB_M[self.msm] / 2 * hz / C if kind == "rtcm3" else 0))
                        if kind == "ubx":
                            self.assertEqual(shift, 0)
                            self.assertEqual(values["L" + their_code][1] & 1, self.ours[t][sat]["L" + code][1] & 1)
                        compared.add(sat[0] + code)
            self.assertEqual(compared, self.as_read[kind])


    def check_ephemerides(self):
        """Ephemerides as RTKLIB reads them, of RTCM and of UBX' subframes: those of broadcast.rnx, of every satellite in view."""
        ours = rinex_records(self.path("broadcast.rnx"))
        for kind, name in (("rtcm3", "BASE.rtcm3"), ("ubx", "BASE.ubx")):
            _, path = self.convbin(kind, name)
            theirs = rinex_records_any(path)
            for sat, records in theirs.items():
                for epoch, numbers in records:
                    self.assertTrue(any(e == epoch and agree(sat, n, numbers) for e, n in ours[sat]), (kind, sat, epoch, numbers))
            self.assertEqual(set(theirs), {sat for t in self.ours.values() for sat in t})


class Made(Streams):
    """GPS, GLONASS and Galileo, MSM7; the made constellation on a Friday."""

    date, week, weekday = "2025/03/21", 2358, 5
    without, not_in_ubx, d2 = {"R3X"}, set(), ()
    as_read = {"rtcm3": {"G1C", "G1W", "G1X", "G2W", "G2X", "G5X", "R1C", "R2C", "E1X", "E5X", "E6X", "E7X"},
               "ubx": {"G1C", "G2X", "R1C", "R2C", "E1X", "E7X"}}

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        orbit = cls.path("day.nc")
        run("orbit", "-q", "-o", orbit, "--sat", "G05-G16,R03-R11,E16-E24", sample("ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"))
        cls.simulate(f"orbit: {{product: {orbit}}}\nsignals: [G, R, E]\n" + ANTENNAS % "52.28, 17.07, 124", "--from", "2025-03-21T10:00:00", "--to",
                     "2025-03-21T10:00:45", "--noise")

    def test_rtcm(self):
        self.check_rtcm()

    def test_station(self):
        self.check_station()

    def test_ubx(self):
        self.check_ubx()

    def test_convbin(self):
        self.check_convbin()

    def test_ephemerides(self):
        self.check_ephemerides()

    def test_what_is_left_out_is_told(self):
        self.assertIn("--rtcm leaves out R:L3OC, which", self.said)

    def test_nmea(self):
        lines = (self.folder / "BASE.nmea").read_bytes().decode("ascii").split("\r\n")[:-1]
        kinds, clock, seen = collections.Counter(), 10 * 3600 - 18, 0  # UTC is 18 s behind
        for line in lines:
            body, check = line[1:].split("*")
            total = 0
            for c in body:
                total ^= ord(c)
            self.assertEqual((line[0], f"{total:02X}"), ("$", check))
            self.assertLessEqual(len(line), 80)
            f = body.split(",")
            kinds[f[0][2:]] += 1
            if f[0] == "GNGGA":
                self.assertEqual(f[2:7] + f[11:12], ["5216.8000000", "N", "01704.2000000", "E", "1", "0.0"])
                self.assertAlmostEqual(float(f[9]), 124, delta=1e-4)
                self.assertEqual(f[1], f"{clock // 3600:02d}{clock // 60 % 60:02d}{clock % 60:02d}.00")
                clock += 1
            elif f[0].endswith("GSV") and f[2] == "1":
                seen += int(f[3])
            elif f[0] == "GNGST":
                self.assertTrue(all(0 < float(v) < 5 for v in f[6:9]))
        epochs = len(self.ours)
        self.assertEqual({kinds[k] for k in ("GGA", "RMC", "GST", "ZDA")}, {epochs})
        self.assertEqual(seen, sum(len(sats) for sats in self.ours.values()))

    def test_the_same_again(self):
        before = {n: (self.folder / n).read_bytes() for n in ("BASE.rtcm3", "BASE.ubx", "BASE.nmea")}
        self.simulate(pathlib.Path(self.path("scenario.yaml")).read_text(encoding="ascii"), "--from", "2025-03-21T10:00:00", "--to", "2025-03-21T10:00:45",
                      "--noise")  # and files of Orrery's own are replaced without --force
        self.assertEqual(before, {n: (self.folder / n).read_bytes() for n in before})

    def test_epochs_beside_the_millisecond(self):
        said = run("simulate", self.path("scenario.yaml"), "-o", self.path("other"), "--rtcm", "--rate", "3", "--to", "2025-03-21T00:01:00", status=1).stderr
        self.assertIn("RTCM counts whole milliseconds", said)


class Real(Streams):
    """BeiDou (two geostationary satellites among it) and QZSS too, MSM4, over the South China Sea."""

    msm = 4
    date, week, weekday = "2020/06/25", 2111, 4
    without, not_in_ubx, d2 = set(), set(), ("C01", "C03")
    as_read = {"rtcm3": {"G1C", "G2X", "G5X", "E1X", "E7X", "C2I", "C6I", "J1C", "J2X", "J5X"}, "ubx": {"G1C", "G2X", "E1X", "E7X", "C2I", "J1C", "J2X"}}

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        orbit = cls.path("day.nc")
        run("orbit", "-q", "-o", orbit, "--sat", "G05,G12,G15,C01,C03,C06,C11,C30,E11,J01-J03", data("2020-177/Sta21114.sp3.gz"))
        cls.simulate(f"orbit: {{product: {orbit}}}\nsignals: ['G:L1CA', 'G:L2C', 'G:L5', 'E:E1', 'E:E5b', 'C:B1I', 'C:B3I', 'J:L1CA', 'J:L2C', 'J:L5']\n"
                     + ANTENNAS % "10, 110, 50", "--from", "2020-06-25T12:00:00", "--to", "2020-06-25T12:00:45")

    def test_rtcm(self):
        self.check_rtcm()

    def test_ubx(self):
        self.check_ubx()

    def test_convbin(self):
        self.check_convbin()

    def test_ephemerides(self):
        self.check_ephemerides()


class Faulty(Streams):
    """A code that runs away from its phase by 150 m/s, and wrong bits: what the formats make of them."""

    date, week, weekday = "2025/03/21", 2358, 5
    without, not_in_ubx, d2 = set(), set(), ()
    SCENARIO = "orbit: {product: %s}\nsignals: ['G:L1CA', 'E:E1']\n" + ANTENNAS % "52.28, 17.07, 124"
    FAULTS = """
faults:
  divergence: [{sats: G10, from: 2025-03-21T10:00:05, rate: 150}]
  bits: [{sats: G05, message: LNAV, piece: 2, bit: [61, 84], from: 2025-03-21T09:59:00}]
"""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        orbit, span = cls.path("day.nc"), ("--from", "2025-03-21T10:00:00", "--to", "2025-03-21T10:00:40")
        run("orbit", "-q", "-o", orbit, "--sat", "G05,G10,G15,G16,E21", sample("ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"))
        cls.simulate(cls.SCENARIO % orbit, *span)
        cls.right = cls.subframes()
        cls.simulate(cls.SCENARIO % orbit + cls.FAULTS, *span)

    @classmethod
    def subframes(cls):
        """The words of RXM-SFRBX: (satellite, words) in the order of their coming."""
        return [(rtcm.ubx_satellite(p[0], p[1]), struct.unpack(f"<{p[4]}I", p[8:])) for kind, number, p in cls.ubx if (kind, number) == (2, 0x13)]

    def test_phases_are_brought_near(self):
        shifts = self.check_rtcm()
        self.assertEqual({sat for sat, _ in shifts}, {"G10"}, "shifted while it was tracked, and told as a slip")

    def test_ubx(self):
        self.check_ubx()

    def test_wrong_bits(self):
        """Bits 61 to 84 of the second subframe, the third word's data, are inverted; nothing else is."""
        wrong = self.subframes()
        self.assertEqual(len(wrong), len(self.right))
        turned = 0
        for (sat, words), (right_sat, right) in zip(wrong, self.right):
            self.assertEqual(sat, right_sat)
            second = sat == "G05" and right[1] >> 8 & 7 == 2
            self.assertEqual([a ^ b for a, b in zip(words, right)], [0x3FFFFFC0 if second and k == 2 else 0 for k in range(len(words))], sat)
            turned += second
        self.assertGreater(turned, 0)


class Moving(Streams):
    """An antenna in flight: no station of RTCM, and its motion in NMEA and UBX."""

    date, week, weekday = "2025/03/21", 2358, 5
    without, not_in_ubx, d2 = set(), set(), ()

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        orbit = cls.path("day.nc")
        run("orbit", "-q", "-o", orbit, "--sat", "G05,G10,G15,G16,E21", sample("ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"))
        cls.simulate(f"""
orbit: {{product: {orbit}}}
signals: ['G:L1CA', 'E:E1']
trajectory:
  kind: waypoints
  start: 2025-03-21T10:00:00
  speed: 80
  waypoints: [{{lat: -0.02, lon: 17.1, height: 1000}}, {{lat: 0.02, lon: 17.0, height: 1100}}, {{lat: 0.05, lon: 17.1, height: 1000}}]
antennas: [{{name: BASE, unit: 0}}]
mask: {{elevation: 0}}
""", "--from", "2025-03-21T10:00:10", "--to", "2025-03-21T10:00:50")

    def test_rtcm(self):
        self.check_rtcm()
        self.assertFalse({1005, 1006} & {number for number, _ in self.rtcm})

    def test_ubx(self):
        self.check_ubx()

    def test_nmea(self):
        rows = list(csv.DictReader((self.folder / "BASE-track.csv").read_text(encoding="ascii").splitlines()))
        lines = [line.split(",") for line in (self.folder / "BASE.nmea").read_text(encoding="ascii").splitlines()]
        told = [f for f in lines if f[0].endswith("RMC")]
        self.assertEqual(len(told), len(rows))
        for f, row in zip(told, rows):
            self.assertEqual((f[2], f[6], f[9], f[12]), ("A", "E", "210325", "A"))
            lat = (-1 if f[4] == "S" else 1) * (int(f[3][:2]) + float(f[3][2:]) / 60)
            self.assertAlmostEqual(lat, float(row["lat_deg"]), delta=2e-9)
            self.assertAlmostEqual(int(f[5][:3]) + float(f[5][3:]) / 60, float(row["lon_deg"]), delta=2e-9)
        for f, before, after in zip(told[1:], rows, rows[2:]):  # speed and course by differences, near the equator
            north = 110574 * (float(after["lat_deg"]) - float(before["lat_deg"])) / 2
            east = 111320 * (float(after["lon_deg"]) - float(before["lon_deg"])) / 2
            self.assertAlmostEqual(float(f[7]) * 1852 / 3600, math.hypot(north, east), delta=0.2)
            self.assertAlmostEqual((float(f[8]) - math.degrees(math.atan2(east, north)) + 180) % 360, 180, delta=0.3)


if __name__ == "__main__":
    unittest.main()
