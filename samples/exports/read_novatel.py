#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads RAWIMUSX messages back (OEM7 manual, short binary header, message 1462; scale of an ISA-100C) and prints a CSV of time of week,
increments of angle and velocity along right, forward, up:

    read_novatel.py IMU.bin
"""
import struct
import sys


def crc32(data):
    crc = 0
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = (crc >> 1) ^ (0xEDB88320 if crc & 1 else 0)
    return crc


def messages(data):
    """(week, seconds, three angles in rad, three velocities in m/s) of each message."""
    at = 0
    while at + 12 <= len(data):
        if data[at:at + 3] != b"\xaa\x44\x13":
            raise SystemExit(f"byte {at}: no sync")
        length, number = struct.unpack_from("<BH", data, at + 3)
        end = at + 12 + length
        if crc32(data[at:end]) != struct.unpack_from("<I", data, end)[0]:
            raise SystemExit(f"byte {at}: the CRC is wrong")
        if number == 1462:
            _, kind, week, seconds, _, az, ay, ax, gz, gy, gx = struct.unpack_from("<BBHdIiiiiii", data, at + 12)
            if kind != 26:
                raise SystemExit(f"IMU type {kind}, whose scale is not known here")
            yield week, seconds, (gx * 1e-9, -gy * 1e-9, gz * 1e-9), (ax * 2e-8, -ay * 2e-8, az * 2e-8)
        at = end + 4


if __name__ == "__main__":
    with open(sys.argv[1], "rb") as file:
        print("week,seconds,dtheta_x_rad,dtheta_y_rad,dtheta_z_rad,dv_x_mps,dv_y_mps,dv_z_mps")
        for week, seconds, angle, velocity in messages(file.read()):
            print(week, f"{seconds:.6f}", *(f"{v:.9g}" for v in angle + velocity), sep=",")
