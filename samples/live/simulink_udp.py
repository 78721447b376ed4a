#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A scenario as datagrams of one fixed layout, for Simulink's UDP Receive (data type double, size [204 1], little-endian) and whatever else
reads an array of doubles.

    simulink_udp.py URL --to 127.0.0.1:25000 --rate 100

Doubles of a datagram, 204 of them:

    0        its number, from 0: a gap is a datagram that was lost
    1, 2     GPS week (unwrapped) and seconds of it
    3        0: no motion at this instant, all else of 4 to 18 is NaN; 1: motion
    4..6     position of the unit, m (ecef)
    7..9     velocity, m/s (ecef)
    10..12   heading, pitch, roll, rad
    13..15   absolute angular rate, rad/s (right, forward, up)
    16..18   specific force, m/s2 (right, forward, up)
    19       motion state of the antenna's block (motion_state of the protocol)
    20       channels that follow, at most 26
    21       0
    22 + 7 k of channel k: satellite (256 times its letter's code, plus its number), signal, azimuth and elevation (rad), pseudorange (m),
             Doppler (Hz), received power (dBW); NaN beyond the last"""
from __future__ import annotations

import argparse
import math
import pathlib
import socket
import struct
import sys
from typing import Optional

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "proto/python"))
import orrery  # noqa: E402
from orrery import messages  # noqa: E402

NS, WEEK_NS = 10**9, 604800 * 10**9
DOUBLES, CHANNELS, FIRST, EACH = 204, 26, 22, 7


def layout(number: int, truth: Optional[messages.Truth], channels: Optional[messages.Channels], t: int) -> bytes:
    """One datagram for the instant t."""
    v = [math.nan] * DOUBLES
    week, rest = divmod(t, WEEK_NS)
    v[:4] = [number, week, rest / NS, 0.0]
    if truth is not None and truth.answer == messages.Answer.OK:
        v[3:19] = [1.0, *truth.pos_m, *truth.vel_mps, truth.heading_rad, truth.pitch_rad, truth.roll_rad, *truth.rate_radps, *truth.force_mps2]
    there = channels.channels[:CHANNELS] if channels is not None else []
    v[19:22] = [float(channels.motion) if channels is not None else math.nan, len(there), 0.0]
    for k, c in enumerate(there):
        s = (t - channels.block) / NS if channels is not None else 0.0
        code = c.code[0] + s * (c.code[1] + s * (c.code[2] + s * c.code[3]))
        doppler = -(c.carrier[1] + s * (2 * c.carrier[2] + s * 3 * c.carrier[3]))
        v[FIRST + EACH * k:FIRST + EACH * (k + 1)] = [256 * c.sat.system + c.sat.number, c.signal, c.az_rad, c.el_rad, code, doppler, c.power_dbw]
    return struct.pack(f"<{DOUBLES}d", *v)


def run(client: orrery.Client, sock: socket.socket, rate_hz: float, unit: int, antenna: int, signal: Optional[int], count: int) -> None:
    """By the scenario's clock, until it ends."""
    served = {r.request for r in client.caps.requests}
    signals = [] if signal is None else [signal]
    asked = messages.PollChannels(antenna=antenna, signals=signals) if messages.PollChannels.TYPE in served else messages.PollTruth(unit=unit)
    for number, block in enumerate(client.subscribe(asked, None, 1 / rate_hz, count=count, credit=1000)):
        channels = block if isinstance(block, messages.Channels) and block.answer == messages.Answer.OK else None
        truth = block if isinstance(block, messages.Truth) else client.truth(block.t, unit) if messages.PollTruth.TYPE in served else None
        sock.send(layout(number, truth, channels, block.t))


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", maxsplit=1)[0])
    parser.add_argument("url", help="of the service, e.g. tcp://127.0.0.1:15754")
    parser.add_argument("--to", metavar="HOST:PORT", required=True, help="where datagrams go")
    parser.add_argument("--rate", type=float, default=100.0, help="datagrams a second, up to 1000; 100 by default")
    parser.add_argument("--unit", type=int, default=0, help="inertial unit; 0 by default")
    parser.add_argument("--antenna", type=int, default=0, help="antenna; 0 by default")
    parser.add_argument("--signal", type=int, help="one signal of CAPS alone; all by default")
    parser.add_argument("--count", type=int, default=0, help="how many datagrams; until the scenario ends by default")
    args = parser.parse_args()
    host, _, port = args.to.rpartition(":")
    with orrery.Client(args.url, "simulink") as client, socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        sock.connect((host, int(port)))
        run(client, sock, args.rate, args.unit, args.antenna, args.signal, args.count)


if __name__ == "__main__":
    main()
