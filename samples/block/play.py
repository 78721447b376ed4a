#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a signal generator does with a block: code phase, whole code periods and carrier phase of one satellite's signal at any
instant of the block, from its two cubics.

    PYTHONPATH=proto/python python3 samples/block/play.py tcp://127.0.0.1:15754 2025-03-21T10:01:40 G05 L1CA --step 0.001

A line an instant: t_ns, chips, period, cycles, fraction. play.c does the same for firmware.
"""
import argparse
import math
import sys

import orrery

LIGHT_MPS = 299792458.0
NS = 10**9


def cubic(c, s):
    return c[0] + s * (c[1] + s * (c[2] + s * c[3]))


def code_phase(channel, signal, s):
    """Position in the ranging code `s` seconds after the block's begin: chips in [0, period), and how many periods of it the second
    has had. The code is read off the satellite's clock, which shows t - code / c: the reading at the begin stands in the block, to a
    fraction of a nanosecond, and from there it advances by s less what the pseudorange grows. A second holds whole periods."""
    since_second = 1e-9 * (channel.transmit % NS + channel.transmit_fraction_ns)
    advance = s - (cubic(channel.code, s) - channel.code[0]) / LIGHT_MPS
    chips = math.fmod(since_second + advance, 1) * signal.chips_per_s  # the block may reach into the next second
    period = math.floor(chips / signal.chips)
    return chips - period * signal.chips, period


def carrier_phase(channel, s):
    """Phase of the carrier's range then, cycles: whole ones, and the rest in [0, 1). What the antenna receives has the phase f t less
    this; its frequency is carrier_hz plus the Doppler, -(c1 + 2 c2 s + 3 c3 s^2)."""
    phase = cubic(channel.carrier, s)
    whole = math.floor(phase)
    return channel.carrier_cycles + whole, phase - whole


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("url", help="tcp://HOST:PORT or unix:PATH")
    parser.add_argument("at", help="first instant, GPS time")
    parser.add_argument("sat", help="G05")
    parser.add_argument("signal", help="as CAPS names it: L1CA")
    parser.add_argument("--antenna", type=int, default=0)
    parser.add_argument("--count", type=int, default=10)
    parser.add_argument("--step", type=float, default=0.001, help="seconds (default 0.001)")
    args = parser.parse_args()
    try:
        with orrery.Client(args.url, name="play.py") as client:
            signal = next((s for s in client.caps.signals if (chr(s.system), s.name) == (args.sat[0], args.signal)), None)
            if signal is None:
                sys.exit(f"play.py: the scenario sends no signal {args.signal} of {args.sat[0]}")
            first, block = orrery.from_text(args.at), None
            for k in range(args.count):
                t = first + round(k * args.step * NS)
                if block is None or t >= block.block + block.length:  # the next one: values and rates go on from this one's
                    block = client.channels(t, args.antenna, signals=[signal.signal])
                    channel = next((c for c in block.channels if orrery.sat_name(c.sat) == args.sat), None)
                    if channel is None:
                        sys.exit(f"play.py: {args.sat} is not in view at {orrery.to_text(t)}")
                s = (t - block.block) / NS
                chips, period = code_phase(channel, signal, s)
                cycles, fraction = carrier_phase(channel, s)
                print(f"{t} {chips:.9f} {period} {cycles} {fraction:.9f}")
    except (OSError, ValueError, orrery.ProtocolError, orrery.Refused) as error:
        sys.exit(f"play.py: {error}")


if __name__ == "__main__":
    main()
