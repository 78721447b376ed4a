#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""DELAYS on the wire: from a made field and a made orbit, through the service, the Python client and orrery poll."""
import json
import math
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "service"))
from daemon import WORK, Daemon, orrery, product  # noqa: E402

import orrery as client_package  # noqa: E402
from orrery import messages  # noqa: E402

NS = 10**9
PLACE = (3738358.596, 1148173.579, 5021815.748)


def maps(path, value=30.0):
    """IONEX maps of one value everywhere, every two hours of the sample's day."""
    head = [("     1.0            IONOSPHERE MAPS     GNSS", "IONEX VERSION / TYPE"), ("MADE", "PGM / RUN BY / DATE"),
            ("  2025     3    21     0     0     0", "EPOCH OF FIRST MAP"), ("  2025     3    22     0     0     0", "EPOCH OF LAST MAP"),
            ("  7200", "INTERVAL"), ("    13", "# OF MAPS IN FILE"), ("  NONE", "MAPPING FUNCTION"), ("     0.0", "ELEVATION CUTOFF"),
            ("MADE", "OBSERVABLES USED"), ("  6371.0", "BASE RADIUS"), ("     2", "MAP DIMENSION"), ("   450.0 450.0   0.0", "HGT1 / HGT2 / DHGT"),
            ("    87.5 -87.5  -2.5", "LAT1 / LAT2 / DLAT"), ("  -180.0 180.0   5.0", "LON1 / LON2 / DLON"), ("    -1", "EXPONENT"),
            ("", "END OF HEADER")]
    lines = [f"{a:<60}{b}" for a, b in head]
    for k in range(13):
        lines.append(f"{k + 1:6d}{'':54}START OF TEC MAP")
        lines.append(f"  2025     3 {21 + k // 12:5d} {2 * (k % 12):5d}     0     0{'':24}EPOCH OF CURRENT MAP")
        for row in range(71):
            lines.append(f"  {87.5 - 2.5 * row:6.1f}-180.0 180.0   5.0 450.0{'':28}LAT/LON1/LON2/DLON/H")
            cells = [f"{round(10 * value):5d}"] * 73
            lines += ["".join(cells[i:i + 16]) for i in range(0, 73, 16)]
        lines.append(f"{k + 1:6d}{'':54}END OF TEC MAP")
    lines.append(f"{'':60}END OF FILE")
    path.write_text("\n".join(lines) + "\n", encoding="ascii")
    return path


def scenario(name, more):
    path = WORK / name
    path.write_text(f"orbit: {{product: {product()}}}\n" + more, encoding="utf-8")
    return path


class Delays(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        maps(WORK / "made.INX")
        cls.daemon = Daemon(scenario("field.yaml", "ionosphere: {field: made.INX}\nreceiver: {position: [52.277, 17.073, 124]}\n"))
        cls.url = cls.daemon.urls[0]

    @classmethod
    def tearDownClass(cls):
        if cls.daemon.stop() != 0:
            raise AssertionError("".join(cls.daemon.lines))

    def test_numbers(self):
        with client_package.Client(self.url) as c:
            t = c.span[0] + 3600 * NS
            d = c.delays(t, carriers_hz=(1575.42e6, 1176.45e6))
            self.assertEqual(d.answer, messages.Answer.OK)
            self.assertEqual([client_package.client.sat_name(s.sat) for s in d.satellites], c.satellites)
            seen = [s for s in d.satellites if s.answer == messages.Answer.OK]
            below = [s for s in d.satellites if s.answer == messages.Answer.BELOW_HORIZON]
            self.assertTrue(seen and below and len(seen) + len(below) == len(d.satellites))
            for s in seen:
                self.assertEqual(s.origin, messages.TecOrigin.FIELD)
                self.assertGreaterEqual(s.el_rad, 0)
                # 30 TECU everywhere, MSLM: R 6371, H 506.7, alpha 0.9782.
                z = 0.9782 * (math.pi / 2 - s.el_rad)
                want = 30 / math.sqrt(1 - (6371 / 6877.7 * math.sin(z))**2)
                self.assertAlmostEqual(s.stec_tecu, want, delta=1e-6 * want)
                self.assertAlmostEqual(s.delay_m[0], 40.3e16 * s.stec_tecu / 1575.42e6**2, places=9)
                self.assertAlmostEqual(s.delay_m[1] / s.delay_m[0], (1575.42 / 1176.45)**2, places=9)  # 1/f^2, code sign
                self.assertGreater(s.delay_m[0], 0)
                self.assertTrue(math.isnan(s.delay_m[2]))
                # The pierce point lies on the shell: its central angle from the receiver follows from the elevation.
                r = math.hypot(*d.receiver_m)
                angle = math.acos(sum(a * b for a, b in zip(d.receiver_m, (
                    math.cos(s.pierce_lat_rad) * math.cos(s.pierce_lon_rad), math.cos(s.pierce_lat_rad) * math.sin(s.pierce_lon_rad),
                    math.sin(s.pierce_lat_rad)))) / r)
                zenith = math.pi / 2 - s.el_rad
                self.assertAlmostEqual(angle, zenith - math.asin(r / 6821e3 * math.sin(zenith)), delta=0.004)  # geodetic zenith
            for s in below:
                self.assertTrue(math.isnan(s.stec_tecu) and math.isnan(s.delay_m[0]))

    def test_same_bytes(self):
        with client_package.Client(self.url) as a, client_package.Client(self.url) as b:
            t = a.span[0] + 1234567891011
            one = [d.encode() for d in a.poll_delays(t, 0.1, 5, PLACE)]
            two = [d.encode() for d in b.poll_delays(t, 0.1, 5, PLACE)]
            alone = a.delays(t + 3 * NS // 10, PLACE).encode()
            self.assertEqual(one, two)
            self.assertEqual(one[3][:8], alone[:8])
            self.assertEqual(one[3][16:], alone[16:])  # but for index and count

    def test_refusals(self):
        with client_package.Client(self.url) as c:
            t = c.span[0]
            nan, inf = float("nan"), float("inf")
            for wrong, words in (({"receiver_m": (1, 2, 3)}, "a receiver 0.00374166 km from the Earth's centre"),
                                 ({"receiver_m": (6e8, 0, 0)}, "a receiver 600000 km from"),
                                 ({"receiver_m": (inf, 0, 0)}, "no finite number"), ({"receiver_m": (4e6, nan, 5e6)}, "no finite number"),
                                 ({"receiver_m": (3e300, 4e300, 0)}, r"a receiver 5e\+297 km from"), ({"carriers_hz": (0.0,)}, "carrier"),
                                 ({"carriers_hz": (nan,)}, "carrier"), ({"carriers_hz": (-1575.42e6,)}, "carrier")):
                with self.assertRaisesRegex(client_package.client.Refused, words) as e:
                    c.delays(t, **wrong)
                self.assertEqual(e.exception.code, messages.ErrorCode.BAD_REQUEST)
            # In space: what is behind the Earth is not there, and who is above the shell has nothing above.
            high = [s for x, y in ((1, 0), (0, 1), (-1, 0), (0, -1)) for s in c.delays(t, (7e6 * x, 7e6 * y, 0)).satellites
                    if s.answer == messages.Answer.OK]
            self.assertTrue(all(s.stec_tecu == 0 for s in high if s.el_rad > 0))
            self.assertTrue(any(s.stec_tecu > 0 for s in high if s.el_rad < -0.23))  # the shell is 0.227 below the level
            self.assertEqual(c.delays(t - 3600 * NS).answer, messages.Answer.OUTSIDE_SPAN)
            self.assertEqual(c.delays(t, satellites=["G40"]).satellites[0].answer, messages.Answer.NOT_SERVED)
            odd = c._ask(messages.PollDelays(messages.Epochs(t, 0, 1), [nan] * 3, [], [messages.SatId(ord("x"), 7)]), messages.Delays)
            self.assertEqual([(s.sat.system, s.sat.number, s.answer) for s in odd.satellites], [(ord("x"), 7, messages.Answer.NOT_SERVED)])
            c.ping(1)  # the conversation lives on
        with Daemon(product()) as plain, client_package.Client(plain.urls[0]) as c:
            with self.assertRaises(client_package.client.Refused) as e:
                c.delays(c.span[0], PLACE)
            self.assertEqual(e.exception.code, messages.ErrorCode.NOT_SERVED)
        with Daemon(scenario("homeless.yaml", "ionosphere: {field: made.INX}\n")) as d, client_package.Client(d.urls[0]) as c:
            with self.assertRaises(client_package.client.Refused) as e:
                c.delays(c.span[0])
            self.assertIn("receiver", str(e.exception))

    def test_command(self):
        done = orrery("poll", self.url, "--delays", "--at", "2025-03-21T01:00", "--carrier", "1575.42", "--carrier", "1227.6", "--format", "json")
        self.assertEqual(done.returncode, 0, done.stderr)
        got = json.loads(done.stdout)
        seen = [s for s in got["satellites"] if s["answer"] == "OK"]
        self.assertTrue(seen)
        for s in seen:
            self.assertEqual(s["origin"], "FIELD")
            self.assertAlmostEqual(s["delay_m"][1] / s["delay_m"][0], (1575.42 / 1227.6)**2, places=9)
        table = orrery("poll", self.url, "--delays", "--at", "2025-03-21T01:00", "--receiver", "-33,151,20")
        self.assertEqual(table.returncode, 0, table.stderr)
        self.assertIn("receiver at -33.000000, 151.000000", table.stdout)
        self.assertIn("field", table.stdout)
        for wrong in (["--receiver", "1"], ["--carrier", "x"], ["--receiver", "95,0,0"]):
            self.assertEqual(orrery("poll", self.url, "--delays", *wrong).returncode, 2)
        self.assertEqual(orrery("poll", self.url, "--carrier", "1575").returncode, 2)

    def test_scenarios_that_are_wrong(self):
        for more, words in (("ionosphere: {field: a, session: b}\n", "cannot stand beside ionosphere.session"),
                            ("receiver: {position: [1, 2, 0]}\n", "has no effect without ionosphere"),
                            ("ionosphere: {field: missing.INX}\n", "missing.INX"),
                            ("ionosphere: {session: made.INX}\n", "made.INX"),
                            (f"ionosphere: {{session: {product()}}}\n", "no ionospheric session"),
                            ("ionosphere: {field: made.INX}\nreceiver: {position: [1, 2]}\n", "3 are wanted"),
                            ("ionosphere: {field: made.INX}\nreceiver: {position: [91, 2, 0]}\n", "no place")):
            done = orrery("serve", scenario("wrong.yaml", more), "--listen", "tcp://127.0.0.1:0")
            self.assertEqual(done.returncode, 1, more)
            self.assertIn(words, done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
