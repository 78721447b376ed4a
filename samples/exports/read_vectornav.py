#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads VectorNav binary messages back (groups Time: TimeGps, IMU: DeltaTheta, DeltaVel) and prints a CSV of nanoseconds of GPS time, length,
increments of angle in degrees and of velocity in m/s along forward, right, down:

    read_vectornav.py IMU.bin
"""
import struct
import sys


def crc16(data):
    crc = 0
    for byte in data:
        crc ^= byte << 8
        for _ in range(8):
            crc = ((crc << 1) ^ (0x1021 if crc & 0x8000 else 0)) & 0xFFFF
    return crc


def messages(data):
    """(time in ns, length in s, three angles in deg, three velocities in m/s) of each message."""
    size = 44
    for at in range(0, len(data), size):
        one = data[at:at + size]
        if one[:6] != b"\xfa\x06\x02\x00\xc0\x00":
            raise SystemExit(f"byte {at}: another message")
        if crc16(one[1:]) != 0:
            raise SystemExit(f"byte {at}: the CRC is wrong")
        ns, length, *rest = struct.unpack_from("<Q7f", one, 6)
        yield ns, length, tuple(rest[:3]), tuple(rest[3:])


if __name__ == "__main__":
    with open(sys.argv[1], "rb") as file:
        print("ns,length_s,dtheta_x_deg,dtheta_y_deg,dtheta_z_deg,dv_x_mps,dv_y_mps,dv_z_mps")
        for ns, length, angle, velocity in messages(file.read()):
            print(ns, f"{length:.9g}", *(f"{v:.9g}" for v in angle + velocity), sep=",")
