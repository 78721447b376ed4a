#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""GNSS-SDR, cold and unassisted, on what orrery serve and orrery-generator make: where it says it is, when it says so first, and
whether the ephemerides that it read are those that were sent. test_receivers.py [CASE...]; each prints what was measured beside its bar."""
import datetime
import math
import pathlib
import re
import sys
import unittest

import gnss_sdr
import recording
from recording import program

STATIC = """
title: Static receiver, made constellation
orbit:
  sp3: [{sp3}]
signals: {signals}
antennas:
  - {{name: ROOF, position: [52.2, 17.07, 100]}}
mask: {{elevation: 5}}
"""

# LSB of each field of an LNAV ephemeris (IS-GPS-200N tables 20-I, 20-III), GNSS-SDR's name and ours, semicircles in radians.
PI = 3.1415926535898
LNAV = [("M_0", "m0_rad", PI * 2**-31), ("delta_n", "delta_n_radps", PI * 2**-43), ("ecc", "e", 2**-33),
        ("sqrtA", "sqrt_a_sqrtm", 2**-19), ("OMEGA_0", "omega0_rad", PI * 2**-31), ("i_0", "i0_rad", PI * 2**-31),
        ("omega", "omega_rad", PI * 2**-31), ("OMEGAdot", "omega_dot_radps", PI * 2**-43), ("idot", "idot_radps", PI * 2**-43),
        ("Cuc", "cuc_rad", 2**-29), ("Cus", "cus_rad", 2**-29), ("Crc", "crc_m", 2**-5), ("Crs", "crs_m", 2**-5),
        ("Cic", "cic_rad", 2**-29), ("Cis", "cis_rad", 2**-29), ("TGD", "tgd_s", 2**-31)]
CLOCK = [("af0", "af0_s", 2**-31), ("af1", "af1_sps", 2**-43), ("af2", "af2_sps2", 2**-55)]
# Those of I/NAV have the same LSB (Galileo OS SIS ICD 2.1 tables 65, 67), without TGD.
INAV = [row for row in LNAV if row[0] != "TGD"]
# And of D1 (BDS-SIS-ICD-B1I-3.0 tables 5-6 to 5-9).
D1_LSB = {"Cuc": 2**-31, "Cus": 2**-31, "Cic": 2**-31, "Cis": 2**-31, "Crc": 2**-6, "Crs": 2**-6}
D1 = [(theirs, ours, D1_LSB.get(theirs, lsb)) for theirs, ours, lsb in INAV]
# And of a GLONASS one (ICD 5.1 table 4.5), GNSS-SDR's in kilometres.
FDMA = [("d_%sn", "pos_m", 2**-11), ("d_V%sn", "vel_mps", 2**-20), ("d_A%sn", "acc_mps2", 2**-30)]
FDMA_CLOCK = [("d_tau_n", "af0_s", -1, 2**-30), ("d_gamma_n", "af1_sps", 1, 2**-40)]


# A satellite that is gone is counted lost within this (measured by test_off).
LOST_S = 6.0


def least_squares(rows, y):
    """Solution of the normal equations by Gauss' elimination."""
    n = len(rows[0])
    a = [[sum(r[i] * r[j] for r in rows) for j in range(n)] + [sum(r[i] * v for r, v in zip(rows, y))] for i in range(n)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda k: abs(a[k][i]))
        a[i], a[pivot] = a[pivot], a[i]
        for k in range(n):
            if k != i:
                f = a[k][i] / a[i][i]
                a[k] = [u - f * v for u, v in zip(a[k], a[i])]
    return [a[i][n] / a[i][i] for i in range(n)]


def parabola(values, u):
    """Between values at 0, 1, 2, ...: through the three about u."""
    k = max(0, min(len(values) - 3, int(u)))
    u -= k
    return values[k] + u * (values[k + 1] - values[k]) + u * (u - 1) / 2 * (values[k + 2] - 2 * values[k + 1] + values[k])


def redated(text, weeks):
    """A RINEX navigation file of GPS and Galileo whole weeks earlier: what Earth-fixed Kepler elements tell of a time of week stays."""
    out, line_of_record = [], 99
    for line in text.splitlines():
        if line[60:].strip() in ("TIME SYSTEM CORR", "LEAP SECONDS"):
            continue
        epoch = re.match(r"[GE]\d\d (\d{4} \d\d \d\d \d\d \d\d \d\d)", line)
        line_of_record = 0 if epoch else line_of_record + 1
        if epoch:
            t = datetime.datetime.strptime(epoch[1], "%Y %m %d %H %M %S") - datetime.timedelta(weeks=weeks)
            line = f"{line[:4]}{t:%Y %m %d %H %M %S}{line[23:]}"
        elif line_of_record == 5:  # its third field is the week
            line = f"{line[:42]}{float(line[42:61]) - weeks:19.12E}{line[61:]}"
        out.append(line)
    return "\n".join(out) + "\n"


class Receivers(program.Folder):
    def make(self, scenario, start, seconds, rate, centre, signals, cn0, change=None):
        """A recording; the service stays for questions."""
        path = self.folder / "scenario.yaml"
        path.write_text(scenario)
        self.start, self.rate, self.seconds = start, rate, seconds
        self.service = recording.Service(path, self.folder)
        self.addCleanup(self.service.stop)
        self.samples = self.path("recording")
        self.addCleanup(lambda: pathlib.Path(f"{self.samples}.sigmf-data").unlink(missing_ok=True))
        self.service.generate("-o", self.samples, "--rate", rate, "--centre", centre, "--signals", signals, "--from", start,
                              "--seconds", seconds, "--noise", "--cn0", cn0)

    def seen(self, signal):
        """As many channels as satellites: which they are is for the receiver to find out; one more would search for ever."""
        return len(recording.satellites(self.samples, signal))

    def receive(self, channels, pinned=(), name="receiver", **how):
        """What the receiver makes of the recording, in a folder of this name; otherwise as gnss_sdr.configuration."""
        self.out = self.folder / name
        self.log = gnss_sdr.run(self.out, f"{self.samples}.sigmf-data", self.rate, channels, pinned=pinned, **how)
        self.found = gnss_sdr.fixes(self.out)
        self.assertTrue(self.found, f"no fix\n{self.log[-2000:]}")

    def judge(self, name, fix_s, rms_m, truth=None):
        truth = truth or self.service.truth(self.start, self.seconds)
        first = self.found[0][0] - recording.gps_s(self.start) % 604800
        rms, worst, n = gnss_sdr.errors(self.found, truth, 20)
        satellites = max(f[3] for f in self.found)
        print(f"{name}: first fix {first:.1f} s (bar {fix_s}), 3-D RMS after 20 s {rms:.2f} m (bar {rms_m}), largest {worst:.2f} m, "
              f"{n} fixes with up to {satellites} satellites")
        self.assertGreater(n, 50)
        self.assertLessEqual(first, fix_s)
        self.assertLessEqual(rms, rms_m)

    def judge_lnav(self, at, least):
        """Ephemerides that were read against the sets that were sent, in LSB."""
        read = gnss_sdr.ephemerides(self.out, "gps_ephemeris.xml")
        sent = self.service.navdata(at, "G")
        worst = 0.0
        for prn, e in read.items():
            s = sent[prn]
            for theirs, ours, lsb in LNAV:
                worst = max(worst, abs(e[theirs] - s["kepler"][ours]) / lsb)
            for theirs, ours, lsb in CLOCK:
                worst = max(worst, abs(e[theirs] - s[ours]) / lsb)
            self.assertEqual(e["toe"], recording.gps_s(s["toe"]) % 604800)
            self.assertEqual(e["IODC"], s["iodc"])
            self.assertEqual(e["SV_health"], s["health"])
        print(f"  ephemerides of {len(read)} satellites read back: largest difference {worst:.3f} LSB (bar 0)")
        self.assertGreaterEqual(len(read), least)
        self.assertLess(worst, 0.01)  # printed decimals

    def judge_inav(self, at, least):
        """Likewise of I/NAV; GNSS-SDR names fields as it does GPS'."""
        read = {k: e for k, e in gnss_sdr.ephemerides(self.out, "gal_ephemeris.xml").items() if k > 0}
        sent = self.service.navdata(at, "E")
        worst = 0.0
        for number, e in read.items():
            s = sent[number]
            for theirs, ours, lsb in INAV:
                worst = max(worst, abs(e[theirs] - s["kepler"][ours]) / lsb)
            for theirs, ours, lsb in (("af0", "af0_s", 2**-34), ("af1", "af1_sps", 2**-46), ("af2", "af2_sps2", 2**-59)):
                worst = max(worst, abs(e[theirs] - s[ours]) / lsb)
            self.assertEqual(e["toe"], recording.gps_s(s["toe"]) % 604800)
            self.assertEqual(e["IOD_nav"], s["iode"])
        print(f"  I/NAV of {len(read)} satellites read back: largest difference {worst:.3f} LSB (bar 0)")
        self.assertGreaterEqual(len(read), least)
        self.assertLess(worst, 0.01)

    def judge_d1(self, at, least):
        """Likewise of BeiDou's D1, whose times are 14 s behind those of GPS."""
        read = {k: e for k, e in gnss_sdr.ephemerides(self.out, "bds_dnav_ephemeris.xml").items() if k > 0}
        sent = self.service.navdata(at, "C")
        worst = 0.0
        for number, e in read.items():
            s = sent[number]
            for theirs, ours, lsb in D1:
                worst = max(worst, abs(e[theirs] - s["kepler"][ours]) / lsb)
            for theirs, ours, lsb in (("af0", "af0_s", 2**-33), ("af1", "af1_sps", 2**-50), ("af2", "af2_sps2", 2**-66)):
                worst = max(worst, abs(e[theirs] - s[ours]) / lsb)
            self.assertEqual(e["toe"], (recording.gps_s(s["toe"]) - 14) % 604800)
            self.assertEqual(e["AODE"], s["iode"])
        print(f"  D1 of {len(read)} satellites read back: largest difference {worst:.3f} LSB (bar 0)")
        self.assertGreaterEqual(len(read), least)
        self.assertLess(worst, 0.01)

    def judge_glonass(self, at, least):
        """Likewise of GLONASS."""
        read = gnss_sdr.ephemerides(self.out, "glo_gnav_ephemeris.xml")
        sent = self.service.navdata(at, "R")
        worst = 0.0
        for slot, e in read.items():
            s = sent[slot]
            for theirs, ours, lsb in FDMA:
                for k, axis in enumerate("XYZ"):
                    worst = max(worst, abs(e[theirs % axis] - s["glonass"][ours][k] / 1000) / lsb)
            for theirs, ours, sign, lsb in FDMA_CLOCK:
                worst = max(worst, abs(e[theirs] - sign * s[ours]) / lsb)
        print(f"  ephemerides of {len(read)} satellites read back: largest difference {worst:.3f} LSB (bar 0)")
        self.assertGreaterEqual(len(read), least)
        self.assertLess(worst, 0.01)

    @staticmethod
    def made(signals):
        return STATIC.format(sp3=program.sample("ORR0TSTFIN_20250800000_01D_05M_ORB.SP3.gz"), signals=signals)

    @staticmethod
    def flight(signals):
        """The gravimetry flight of samples/, its delays left out."""
        text = pathlib.Path(program.sample("gravimetry-flight.yaml")).read_text()
        text = re.sub(r"^ionosphere:\n(  .*\n)+", "", text, flags=re.M)
        text = re.sub(r"^troposphere:.*\n", "", text, flags=re.M)
        text = re.sub(r"^signals:.*$", f"signals: {signals}", text, flags=re.M)
        return text.replace("- ORR0", f"- {program.ROOT}/samples/ORR0")

    def test_gps(self):
        """GPS L1 C/A, static."""
        start = "2025-03-21T12:00:00"
        self.make(self.made('["G:L1CA"]'), start, 120, 2600000, 1575420000, "G:L1CA", 51)
        self.receive({"1C": self.seen("L1CA")})
        self.judge("GPS L1 C/A, 2.6 Msps, 51 dB-Hz", 45, 2.0)
        self.judge_lnav(start, 8)

    def test_short(self):
        """The same, no longer than it takes to see the first fixes: part of ./check."""
        start = "2025-03-21T12:00:00"
        self.make(self.made('["G:L1CA"]'), start, 52, 2600000, 1575420000, "G:L1CA", 51)
        self.receive({"1C": 10}, at_once=10, work=None)
        first = self.found[0][0] - recording.gps_s(start) % 604800
        rms, worst, n = gnss_sdr.errors(self.found, self.service.truth(start, 52))
        print(f"GPS L1 C/A, short: first fix {first:.1f} s (bar 45), {n} fixes, 3-D RMS {rms:.2f} m, largest {worst:.2f} m")
        self.assertLessEqual(first, 45)
        self.assertLess(rms, 4.0)  # fixes of the first seconds, with as few as four satellites
        self.judge_lnav(start, 4)

    def test_glonass(self):
        """GLONASS L1OF at its own centre: strings, relative code, meander, time mark."""
        start = "2025-03-21T12:00:18"  # a frame begins: 12:00:00 UTC
        self.make(self.made('["R:L1OF"]'), start, 80, 10000000, 1602000000, "R:L1OF", 51)
        slots = recording.satellites(self.samples, "L1OF")
        self.receive({"1G": len(slots)}, [("1G", s) for s in slots])
        self.judge("GLONASS L1OF, 10 Msps, 51 dB-Hz", 45, 4.0)
        self.judge_glonass(start, 6)

    def test_galileo(self):
        """Galileo E1, I/NAV on B, tracked on C: 44 dB-Hz a component in the stream, which has their BOC(1,1) parts, 10/11 of 47.4."""
        start = "2025-03-21T12:00:01"  # a frame of I/NAV begins
        self.make(self.made('["E:E1"]'), start, 120, 5000000, 1575420000, "E:E1", 47.4)
        self.receive({"1B": self.seen("E1")})
        self.judge("Galileo E1, 5 Msps, 44 dB-Hz a component", 45, 0.8)
        self.judge_inav(start, 6)

    def test_beidou(self):
        """BeiDou B1I, D1 with its Neumann-Hoffman code; real orbits of CNES."""
        start = "2024-02-04T12:00:14"  # a frame begins: 12:00:00 BDT
        orbits = program.data("2024-035/GRG0MGXFIN_20240350000_01D_05M_ORB.SP3.gz")
        self.make(STATIC.format(sp3=orbits, signals='["C:B1I"]'), start, 120, 5000000, 1561098000, "C:B1I", 51)
        self.receive({"B1": self.seen("B1I")}, [("B1", s) for s in recording.satellites(self.samples, "B1I")], at_once=4)
        self.judge("BeiDou B1I, 5 Msps, 51 dB-Hz", 100, 2.0)
        self.judge_d1(start, 5)

    def test_flight(self):
        """The gravimetry flight: an aircraft in turbulence, turning on to its next line."""
        start = "2025-03-21T10:07:00"
        self.make(self.flight('["G:L1CA"]'), start, 120, 2600000, 1575420000, "G:L1CA", 51)
        self.receive({"1C": self.seen("L1CA")})
        self.judge("GPS L1 C/A, gravimetry flight, 2.6 Msps, 51 dB-Hz", 45, 2.5)
        self.judge_lnav(start, 7)

    def test_both(self):
        """GPS L1 C/A and Galileo E1 in one recording."""
        start = "2025-03-21T12:00:00"
        self.make(self.made('["G:L1CA", "E:E1"]'), start, 90, 5000000, 1575420000, "G:L1CA,E:E1", 51)
        self.receive({"1C": self.seen("L1CA"), "1B": self.seen("E1")}, at_once=4, tracked=gnss_sdr.NARROW)
        self.judge("GPS L1 C/A and Galileo E1, 5 Msps, 51 dB-Hz", 45, 0.6)
        self.judge_lnav(start, 8)
        self.judge_inav(start, 6)

    def test_flight_both(self):
        """The flight again, by GPS and Galileo."""
        start = "2025-03-21T10:07:00"
        self.make(self.flight('["G:L1CA", "E:E1"]'), start, 90, 5000000, 1575420000, "G:L1CA,E:E1", 51)
        self.receive({"1C": self.seen("L1CA"), "1B": self.seen("E1")}, at_once=4, tracked=gnss_sdr.NARROW)
        self.judge("GPS L1 C/A and Galileo E1, gravimetry flight, 5 Msps, 51 dB-Hz", 45, 1.0)

    def test_rooftop(self):
        """README's example, a minute by one command from where the scenario begins. A subframe of GPS is under way there, and Galileo gives the first fix."""
        scenario = program.sample("rooftop.yaml")
        program.run("iq", scenario, "-o", str(self.folder), "--seconds", 60, "--rate", "5M")
        self.start, self.rate, self.seconds, self.samples = "2025-03-21T00:00:01", 5000000, 60, self.path("rooftop")
        self.service = recording.Service(scenario, self.folder)
        self.addCleanup(self.service.stop)
        self.receive({"1C": self.seen("L1CA"), "1B": self.seen("E1")}, at_once=4, tracked=gnss_sdr.NARROW)
        self.judge("README's example, GPS and Galileo", 45, 1.0)
        self.assertEqual(max(f[3] for f in self.found), self.seen("L1CA") + self.seen("E1"))

    def test_step(self):
        """A range step of 60 m of one satellite, after 60 s: the receiver's own ranges show it, and its message goes on."""
        start, at, step, prn = "2025-03-21T12:00:00", "2025-03-21T12:01:00", 60.0, 5
        text = self.made('["G:L1CA"]') + f"faults: {{range: [{{sats: G{prn:02d}, from: {at}, step: {step}}}]}}\n"
        self.make(text, start, 90, 2600000, 1575420000, "G:L1CA", 51)
        seen = recording.satellites(self.samples, "L1CA")
        self.assertIn(prn, seen)
        self.receive({"1C": len(seen)})
        jump = self.jump_of(gnss_sdr.ranges(self.out, len(seen)), prn, recording.gps_s(at) % 604800)
        print(f"GPS L1 C/A, a range step of {step:.0f} m of G{prn:02d}: {jump:.1f} m in the receiver's ranges (bar 1.5 m apart)")
        self.assertLess(abs(jump - step), 1.5)

    def jump_of(self, ranges, prn, tow):
        """By how much a satellite's range less the mean of the others' jumps at an instant: parabolas through 15 s to either side, from
        2 s on (the jerk of ranges is below 1e-4 m/s3: 0.06 m)."""
        others = [s for s in ranges if s != prn and min(ranges[s]) < tow - 15]
        t = [t for t in sorted(ranges[prn]) if 2 <= abs(t - tow) <= 15 and all(t in ranges[s] for s in others)]
        self.assertGreater(len(t), 1000)  # of 1300: every 20 ms
        y = [ranges[prn][k] - sum(ranges[s][k] for s in others) / len(others) for k in t]
        rows = [[1.0, u, u * u, float(u > 0)] for u in (k - tow for k in t)]
        return least_squares(rows, y)[3]

    def test_unhealthy(self):
        """A satellite that its message marks as not to be used: read so, and left out of the fixes."""
        start, prn = "2025-03-21T12:00:00", 5
        text = self.made('["G:L1CA"]') + f"satellites: {{unhealthy: G{prn:02d}}}\n"
        self.make(text, start, 80, 2600000, 1575420000, "G:L1CA", 51)
        seen = self.seen("L1CA")
        self.assertIn(prn, recording.satellites(self.samples, "L1CA"))
        self.receive({"1C": seen})
        self.judge("GPS L1 C/A, G05 unhealthy", 45, 2.0)
        self.judge_lnav(start, 8)
        self.assertNotEqual(gnss_sdr.ephemerides(self.out, "gps_ephemeris.xml")[prn]["SV_health"], 0)
        self.assertEqual(max(f[3] for f in self.found), seen - 1)

    def test_l5(self):
        """GPS L5 I with CNAV, of the satellites whose codes GNSS-SDR makes right. It takes the rates of the mean motion and of the semi-major axis for
        0, which costs 1.8 cm of height a second from the sets' reference at 11:30 on: the fixes that are judged lie to both sides of it."""
        start = "2025-03-21T11:28:42"
        self.make(self.made('["G:L5"]'), start, 100, 12500000, 1176450000, "G:L5", 53)
        satellites = [s for s in recording.satellites(self.samples, "L5") if s in gnss_sdr.L5_HEARD]
        self.receive({"L5": len(satellites)}, [("L5", s) for s in satellites], at_once=len(satellites))
        self.judge("GPS L5, 12.5 Msps, 53 dB-Hz", 45, 1.0)

    def test_update(self):
        """Across the hour at which satellites change to their next ephemerides."""
        self.make(self.made('["G:L1CA"]'), "2025-03-21T12:58:54", 140, 2600000, 1575420000, "G:L1CA", 51)
        self.receive({"1C": self.seen("L1CA")})
        self.judge("GPS L1 C/A, ephemerides change after 66 s", 45, 2.0)
        self.judge_lnav("2025-03-21T13:00:30", 8)  # those of the end

    def test_week(self):
        """From Saturday to Sunday: time of week 604800 is 0, the week another; real orbits of CODE."""
        files = [program.data(f"2024-035/COD0OPSFIN_2024{d}0000_01D_05M_ORB.SP3.gz") for d in ("034", "035")]
        text = STATIC.format(sp3=", ".join(files), signals='["G:L1CA"]')
        self.make(text, "2024-02-03T23:58:54", 140, 2600000, 1575420000, "G:L1CA", 51)
        self.receive({"1C": self.seen("L1CA")})
        # Until the first subframe of the week GNSS-SDR counts its time of week beyond 604800 and takes its clock for 20 ms wrong.
        truth = self.service.truth("2024-02-03T23:59:00", 60)
        parts = {"before": [f for f in self.found if f[0] > 604700 and f[0] < 604800], "first 7 s": [f for f in self.found if f[0] < 7],
                 "after": [f for f in self.found if 7 <= f[0] < 604700]}
        rms = {name: gnss_sdr.errors(part, truth) for name, part in parts.items()}
        print("GPS L1 C/A, into a new week after 66 s, 2.6 Msps, 51 dB-Hz, real orbits: 3-D RMS " +
              ", ".join(f"{name} {r[0]:.2f} m of {r[2]} fixes" for name, r in rms.items()) + " (bar: after at most 2.0 and 1.25 of before)")
        for r in rms.values():
            self.assertGreater(r[2], 100)
        self.assertLessEqual(rms["after"][0], min(2.0, 1.25 * rms["before"][0]))
        self.assertLess(rms["first 7 s"][1], 40)

    def leap_second(self, signal):
        """A made constellation at the end of 2016: its broadcast data, 429 weeks earlier, are the orbits."""
        days = [program.sample(f"ORR0TSTFIN_2025{d}0000_01D_15M_ORB.SP3.gz") for d in ("080", "081")]
        product, sets = self.path("days.nc"), self.folder / "sets.rnx"
        program.run("orbit", "-q", "--predict", "3h", "-o", product, *days)
        program.run("navfit", product, "--sat", signal[0], "-o", str(sets))
        sets.write_text(redated(sets.read_text(), 429))
        return STATIC.format(sp3="", signals=f'["{signal}"]').replace("sp3: []", f"nav: {sets}")

    def utc_model(self, name):
        """What the receiver read of UTC: leap seconds now and to come, week of 8 bits and day at whose end."""
        text = (self.out / name).read_text()
        return [int(re.search(rf"<{key}>(\d+)<", text)[1]) for key in ("Delta\\w*LS", "Delta\\w*LSF", "WN_LSF", "DN")]

    def test_leap(self):
        """Galileo through the leap second at the end of 2016, which ends a week as well: 23:59:60 UTC began at 2017-01-01T00:00:17."""
        start = "2016-12-31T23:59:01"
        self.make(self.leap_second("E:E1"), start, 120, 5000000, 1575420000, "E:E1", 47.4)
        channels = {"1B": self.seen("E1")}
        self.receive(channels, name="until", seconds=50)  # to 23:59:51, half a minute before
        self.assertEqual(self.utc_model("gal_utc_model.xml"), [17, 18, 1929 % 256, 7])
        self.receive(channels)
        self.judge("Galileo E1 through the leap second", 45, 0.8)
        self.assertEqual(self.utc_model("gal_utc_model.xml"), [18, 18, 1929 % 256, 7])
        self.judge_inav("2017-01-01T00:00:30", 6)
        # What it takes UTC to be at whole seconds. From the end of the week until a word tells it the new one it takes itself to be a week earlier.
        clock = gnss_sdr.clock_readings(self.log)
        seconds = [round(t) for t in sorted({round(f[0], 3) for f in self.found}, key=lambda t: (t < 302400, t)) if t == round(t)]
        self.assertEqual(len(clock), len(seconds))
        behind = [(t, day, (t - s) % 86400) for t, (day, s) in zip(seconds, clock)]
        before = [d for t, day, d in behind if day == "2016-Dec-31"]
        after = [d for t, day, d in behind if day == "2017-Jan-01" and 18 <= t < 302400]
        print(f"  it read 17 s of leap seconds, and that there will be 18, then 18; its UTC is {set(before)} s behind until 23:59:59 "
              f"({len(before)} fixes) and {set(after)} s in the new year ({len(after)} fixes; {len(behind) - len(before) - len(after)} of the week unknown)")
        self.assertEqual((set(before), set(after)), ({17}, {18}))
        self.assertGreater(min(len(before), len(after)), 20)

    def test_leap_gps(self):
        """GPS through it, from page 18 of subframe 4 on, which comes nine minutes before."""
        self.make(self.leap_second("G:L1CA"), "2016-12-31T23:50:50", 590, 2600000, 1575420000, "G:L1CA", 51)
        self.receive({"1C": self.seen("L1CA")}, at_once=4)
        truth = self.service.truth("2016-12-31T23:51:00", 30)
        # A satellite sets on the way. Fixes in which GNSS-SDR goes on with the loops of a signal that is gone are not judged (see test_off).
        begin = recording.gps_s(self.start) % 604800
        sets = recording.endings(self.samples, "L1CA")
        found = [f for f in self.found if not any(0 <= f[0] - begin - s < LOST_S for s in sets)]
        parts = {"before": [f for f in found if f[0] > 302400 and f[0] < 604800], "after": [f for f in found if 17 <= f[0] < 302400]}
        rms = {name: gnss_sdr.errors(part, truth, 20 if name == "before" else 0) for name, part in parts.items()}
        print(f"GPS L1 C/A through the leap second, 2.6 Msps, 51 dB-Hz, {len(sets)} satellite sets: 3-D RMS " +
              ", ".join(f"{name} {r[0]:.2f} m of {r[2]} fixes" for name, r in rms.items()) + " (bar 2.0)")
        for r in rms.values():
            self.assertGreater(r[2], 100)
            self.assertLessEqual(r[0], 2.0)
        self.assertEqual(self.utc_model("gps_utc_model.xml"), [17, 18, 1929 % 256, 7])

    def test_tunnel(self):
        """A road into a tunnel and out of it: when signals go, when the receiver says so, when it has them again."""
        start, speed, mouths = "2025-03-21T12:00:00", 20.0, (52.20989, 52.21348)
        text = self.made('["G:L1CA"]').replace("position: [52.2, 17.07, 100]", "up: 1.5")
        text += (f"trajectory: {{kind: analytic, start: {start}, duration: 120, lat: 52.2, lon: 17.07, height: 100, "
                 f"motions: [{{kind: straight, north: {speed}}}]}}\n"
                 f"obstacles: {{tunnels: [{{from: [{mouths[0]}, 17.07], to: [{mouths[1]}, 17.07]}}]}}\n")
        self.make(text, start, 80, 2600000, 1575420000, "G:L1CA", 51)
        self.receive({"1C": self.seen("L1CA")}, at_once=self.seen("L1CA"), loops=True)
        # Seconds from the begin to either mouth along the meridian, whose radius of curvature there is 6375.6 km (WGS 84).
        e2, latitude = 0.00669438, math.radians(52.205)
        radius = 6378137 * (1 - e2) / (1 - e2 * math.sin(latitude) ** 2) ** 1.5 + 100
        into, out = (math.radians(m - 52.2) * radius / speed for m in mouths)
        gone, told, back = [], [], []
        for periods in gnss_sdr.loops(self.out).values():
            gone.append(self.silent_from(periods) - into)
            times = [sample / self.rate for sample, _, _ in periods]
            told.append(max(t for t in times if t < out) - into)
            back.append(min(t for t in times if t > out) - out)
        fixes = [f[0] - recording.gps_s(start) % 604800 for f in self.found]
        last = max(t for t in fixes if t < out) - into
        print(f"GPS L1 C/A, {len(gone)} satellites, into a tunnel after {into:.2f} s: signals gone {min(gone):.2f} to {max(gone):.2f} s behind its mouth "
              f"(bar 0 to 0.122: a block, a bit, a correlation), last fix {last:.2f} s, loss of lock told {max(told):.2f} s behind it "
              f"(bar {LOST_S:.0f}); out after {out:.2f} s: tracked again {min(back):.2f} to {max(back):.2f} s later (bar 1)")
        self.assertGreaterEqual(len(gone), 8)
        self.assertTrue(0 < min(gone) and max(gone) < 0.122, gone)
        # Until GNSS-SDR counts lock as lost it computes fixes from loops that run on noise, as long as their ranges agree.
        self.assertTrue(0 < last < max(told))
        self.assertLess(max(told), LOST_S)
        self.assertTrue(0 < min(back) and max(back) < 1, back)

    def test_ground(self):
        """Level ground 60 m below the antenna: C/N0 of each satellite beats with its echo, 2 h sin(elevation) behind."""
        start, height = "2025-03-21T12:00:00", 60.0
        self.make(self.made('["G:L1CA"]') + f"multipath: {{ground: {{height: {height:.0f}}}}}\n", start, 100, 2600000, 1575420000, "G:L1CA", 51)
        self.receive({"1C": self.seen("L1CA")}, at_once=self.seen("L1CA"), loops=True)
        elevation = {}
        for row in self.service.poll("--channels", "--at", start, "--step", "10", "--count", 11):
            for c in row["channels"]:
                if c["echo"] == 0:
                    elevation.setdefault(int(c["sat"][1:]), []).append(math.radians(c["el_deg"]))
        judged = []
        for prn, periods in gnss_sdr.loops(self.out).items():
            cycles = [2 * height * math.sin(e) * 1575.42e6 / 299792458 for e in elevation[prn]]
            t, y = self.strengths(periods)
            turns = abs(parabola(cycles, 9.9) - parabola(cycles, 1.5))
            if t[-1] - t[0] > 80 and turns > 2:
                scale, explained = self.beat(t, y, cycles)
                judged.append((prn, turns, scale))
                print(f"GPS L1 C/A, ground {height:.0f} m below, G{prn:02d}: period {84 / turns / scale:.2f} s, predicted {84 / turns:.2f} s "
                      f"(bar 3 %), {100 * explained:.0f} % of C/N0's variance")
                self.assertLess(abs(scale - 1), 0.03)
                self.assertGreater(explained, 0.7)
        self.assertGreaterEqual(len(judged), 6)

    def strengths(self, periods):
        """Times and amplitudes, by C/N0, of fifths of a second from 15 s on."""
        bins = {}
        for sample, _, cn0 in periods:
            if sample > 15 * self.rate:
                bins.setdefault(5 * sample // self.rate, []).append(cn0)
        return [(k + 0.5) / 5 for k in sorted(bins)], [10 ** (sum(bins[k]) / len(bins[k]) / 20) for k in sorted(bins)]

    @staticmethod
    def beat(t, y, cycles):
        """By how much faster than predicted an amplitude beats, 0.5 to 1.7 times, beside a straight line; and the share of variance that is it."""
        mean = sum(y) / len(y)
        best = (math.inf, 0)
        for k in range(121):
            scale = 0.5 + 0.01 * k
            angle = [2 * math.pi * scale * (parabola(cycles, u / 10) - cycles[5]) for u in t]
            rows = [[1.0, (u - 50) / 50, math.cos(a), math.sin(a)] for u, a in zip(t, angle)]
            x = least_squares(rows, y)
            best = min(best, (sum((v - sum(a * b for a, b in zip(x, r))) ** 2 for v, r in zip(y, rows)), scale))
        return best[1], 1 - best[0] / sum((v - mean) ** 2 for v in y)

    def test_off(self):
        """A satellite that is switched off in the middle of a word: when the receiver's correlator has it no more; fixes go on without it."""
        start, off, prn = "2025-03-21T12:00:00", 70.35, 5
        text = self.made('["G:L1CA"]') + f"faults: {{off: [{{sats: G{prn:02d}, from: 2025-03-21T12:01:{off - 60:05.2f}}}]}}\n"
        self.make(text, start, 90, 2600000, 1575420000, "G:L1CA", 51)
        seen = self.seen("L1CA")
        self.receive({"1C": seen}, at_once=seen, loops=True)
        # It goes on with the loops of a signal that is gone until it counts it as lost; the fixes with it are not judged.
        week = recording.gps_s(start) // 604800 * 604800
        since = [(f, f[0] + week - recording.gps_s(start)) for f in self.found]
        lost = next(t for f, t in since if t > off and f[3] < seen)
        self.found = [f for f, t in since if not off < t < lost]
        self.judge(f"GPS L1 C/A, G{prn:02d} off after {off} s, lost {lost - off:.1f} s later (bar {LOST_S:.0f})", 45, 2.0)
        self.assertLess(lost - off, LOST_S)
        self.judge_lnav(start, 8)
        gone = {s: self.silent_from(periods) for s, periods in gnss_sdr.loops(self.out).items()}
        counts = [max(f[3] for f, t in since if t < off), max(f[3] for f, t in since if t > lost)]
        print(f"  its signal is gone {gone[prn] - off:.3f} s behind it (bar 0 to 0.022), no other is; "
              f"fixes with {counts[0]} satellites, then {counts[1]}")
        # Once a bit of 20 ms GNSS-SDR writes down the last correlation, of 1 ms, with the sample at its end.
        self.assertTrue(0 < gone[prn] - off < 0.022, gone[prn])
        self.assertEqual([s for s, t in gone.items() if t is not None], [prn])
        self.assertEqual(counts, [seen, seen - 1])

    def silent_from(self, periods):
        """Seconds at which a fifth of a second of silence begins: less than a tenth of the power before; None where there is none."""
        periods = sorted((sample / self.rate, power) for sample, power, _ in periods if sample > 30 * self.rate)
        mean = sum(p for _, p in periods[:500]) / len(periods[:500])
        for k in range(len(periods) - 10):
            if all(p < 0.1 * mean for _, p in periods[k:k + 10]):
                return periods[k][0]
        return None


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *(f"Receivers.test_{a}" for a in sys.argv[1:])], verbosity=0)
