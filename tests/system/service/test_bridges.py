#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The samples that feed other programs: MAVLink frames read by a stand-in for an autopilot, datagrams for Simulink by a bare array of doubles;
both against what the service says."""
import math
import pathlib
import socket
import struct
import subprocess
import sys
import unittest

from daemon import ROOT, Served  # first: it sets the path

import orrery
from test_streams import SCENARIO

NS = 10**9
LIVE = ROOT / "samples/live"


def check_x25(data):
    """CRC-16/MCRF4XX bit by bit, by its polynomial."""
    crc = 0xFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ (0x8408 if crc & 1 else 0)
    return crc


class Autopilot:
    """Takes MAVLink 2 apart: sequence, checksum with the byte of the message's definition, fields by their published layout."""
    KNOWN = {0: (50, "<IBBBBB"), 107: (108, "<Q13fI"), 113: (124, "<QiiiHHHhhhHBB")}

    def __init__(self):
        self.sequence, self.got = None, {0: [], 107: [], 113: []}

    def take(self, data):
        """How many bytes are a whole frame; 0: not yet."""
        if len(data) < 12 or len(data) < 12 + data[1]:
            return 0
        assert data[0] == 0xFD and data[2] == data[3] == 0, "no frame of MAVLink 2"
        n, number = data[1], int.from_bytes(data[7:10], "little")
        extra, layout = self.KNOWN[number]
        assert check_x25(data[1:10 + n] + bytes([extra])) == int.from_bytes(data[10 + n:12 + n], "little"), "wrong checksum"
        assert self.sequence is None or data[4] == (self.sequence + 1) % 256, "a frame is missing"
        self.sequence = data[4]
        payload = data[10:10 + n].ljust(struct.calcsize(layout), b"\0")
        self.got[number].append(struct.unpack(layout, payload))
        return 12 + n


class Bridges(Served):
    SCENARIO = SCENARIO
    OPTIONS = ("--from", "2025-03-21T10:01:00")

    def run_sample(self, name, *args, **kwargs):
        return subprocess.Popen([sys.executable, "-B", str(LIVE / name), self.daemon.urls[0], *map(str, args)], text=True, **kwargs)

    def judge(self, pilot):
        """A second of readings at 50 Hz, fixes at 10 Hz: each against the service's own truth and readings."""
        self.assertEqual((len(pilot.got[107]), len(pilot.got[113])), (50, 10))
        self.assertGreater(len(pilot.got[0]), 0)
        leap = self.client.time().leap.gps_utc_s
        for us, *values in pilot.got[107]:
            t1 = (us - (315964800 - leap) * 10**6) * 1000
            imu = self.client.imu(t1 - NS // 50, 0.02)
            want = [imu.dv_mps[1] * 50, imu.dv_mps[0] * 50, -imu.dv_mps[2] * 50, imu.dtheta_rad[1] * 50, imu.dtheta_rad[0] * 50, -imu.dtheta_rad[2] * 50]
            for got, true in zip(values, want):
                self.assertAlmostEqual(got, true, delta=1e-6 * max(1.0, abs(true)))
            field, pressure = values[6:9], values[9]
            self.assertTrue(0.2 < math.hypot(*field) < 0.7)
            self.assertGreater(field[2], 0.3)  # steep, and down in the North
            self.assertTrue(830 < pressure < 860)  # 1500 m
        for us, lat, lon, alt, eph, _, vel, vn, ve, vd, _, fix, seen in pilot.got[113]:
            truth = self.client.truth((us - (315964800 - leap) * 10**6) * 1000)
            # Back to ecef, by the closed form of the other direction.
            phi, lam, h = math.radians(lat * 1e-7), math.radians(lon * 1e-7), alt * 1e-3
            n = 6378137.0 / math.sqrt(1 - 0.0066943799901413165 * math.sin(phi)**2)
            place = ((n + h) * math.cos(phi) * math.cos(lam), (n + h) * math.cos(phi) * math.sin(lam), (n * (1 - 0.0066943799901413165) + h) * math.sin(phi))
            self.assertLess(math.dist(place, truth.pos_m), 0.01)  # 1e-7 degree
            self.assertAlmostEqual(vel, 100 * math.hypot(vn, ve) / 100, delta=2)
            self.assertAlmostEqual(math.hypot(vn, ve, vd) / 100, math.hypot(*truth.vel_mps), delta=0.02)
            channels = self.client.channels((us - (315964800 - leap) * 10**6) * 1000)
            self.assertEqual((seen, fix), (len({str(c.sat) for c in channels.channels}), 3))
            self.assertTrue(100 * 0.5 < eph < 65500)

    def test_an_autopilot_that_listens(self):
        pilot = Autopilot()
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
            sock.bind(("127.0.0.1", 0))
            sock.settimeout(30)
            sample = self.run_sample("mavlink.py", "--udp", f"127.0.0.1:{sock.getsockname()[1]}", "--rate", 50, "--seconds", 1)
            while len(pilot.got[107]) < 50 or len(pilot.got[113]) < 10:
                data = sock.recv(2048)
                self.assertEqual(pilot.take(data), len(data))
            self.assertEqual(sample.wait(30), 0)
        self.judge(pilot)

    def test_an_autopilot_that_connects(self):
        pilot, data = Autopilot(), b""
        sample = self.run_sample("mavlink.py", "--tcp-listen", 0, "--rate", 50, "--seconds", 1, stderr=subprocess.PIPE)
        port = int(sample.stderr.readline().rpartition(":")[2])
        with socket.create_connection(("127.0.0.1", port), 30) as sock:
            while part := sock.recv(4096):
                data += part
                while used := pilot.take(data):
                    data = data[used:]
        self.assertEqual((sample.wait(30), data), (0, b""))
        sample.stderr.close()
        self.judge(pilot)

    def test_an_array_of_doubles(self):
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
            sock.bind(("127.0.0.1", 0))
            sock.settimeout(30)
            sample = self.run_sample("simulink_udp.py", "--to", f"127.0.0.1:{sock.getsockname()[1]}", "--rate", 100, "--count", 40)
            for number in range(40):
                v = struct.unpack("<204d", sock.recv(4096))
                t = round(v[1]) * 604800 * NS + round(v[2] * 1e9)
                truth, channels = self.client.truth(t), self.client.channels(t)
                self.assertEqual((v[0], v[3], v[21]), (number, 1, 0))
                self.assertEqual(v[4:10], (*truth.pos_m, *truth.vel_mps))
                self.assertEqual(v[16:19], tuple(truth.force_mps2))
                self.assertEqual(v[20], len(channels.channels))
                for k, c in enumerate(channels.channels):
                    one = v[22 + 7 * k:29 + 7 * k]
                    self.assertEqual(one[:2], (256 * c.sat.system + c.sat.number, c.signal))
                    s = (t - channels.block) / NS
                    rate = c.code[1] + s * (2 * c.code[2] + s * 3 * c.code[3])
                    self.assertAlmostEqual(rate, -one[5] * 299792458 / c.carrier_hz, delta=0.1)  # but for the ionosphere and wind-up
                    self.assertAlmostEqual(one[4], c.code[0] + s * rate, delta=0.1)
                self.assertTrue(all(map(math.isnan, v[22 + 7 * len(channels.channels):])))
            self.assertEqual(sample.wait(30), 0)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
