#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Stands in for a signal generator: asks a service for all satellites at a steady rate, shows a few, and tells how prompt the
answers were.

    PYTHONPATH=proto/python python3 samples/generator.py tcp://127.0.0.1:15754 --at 2025-03-21T12:00:00
"""
import argparse
import math
import statistics
import sys
import time

import orrery
from orrery import Answer, StateFlags


def table(states, names):
    print(f"{orrery.to_text(states.t)} GPS")
    print(f"  sat {'x km':>14} {'y km':>14} {'z km':>14} {'speed m/s':>10} {'clock us':>12} {'sigma mm':>9}  flags")
    for s in states.satellites:
        name = orrery.sat_name(s.sat)
        if name not in names:
            continue
        if s.answer != Answer.OK:
            print(f"  {name}  {Answer(s.answer).name.lower().replace('_', ' ')}")
            continue
        clock = f"{s.clock_s * 1e6:12.5f}" if s.flags & StateFlags.CLOCK_VALID else f"{'-':>12}"
        flags = " ".join(f.name.lower() for f in StateFlags if f & s.flags and f != StateFlags.CLOCK_VALID)
        x, y, z = (c * 1e-3 for c in s.pos_m)
        line = f"  {name} {x:14.6f} {y:14.6f} {z:14.6f} {math.hypot(*s.vel_mps):10.4f} {clock} {s.sigma_m * 1e3:9.2f}  {flags}"
        print(line.rstrip())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("url", help="tcp://HOST:PORT or unix:PATH")
    parser.add_argument("--at", help="first epoch, GPS time (default: the start of the served span)")
    parser.add_argument("--rate", type=float, default=10.0, help="polls a second (default 10)")
    parser.add_argument("--seconds", type=float, default=3.0, help="how long (default 3)")
    parser.add_argument("--show", nargs="+", default=["G05", "G17", "R07", "R21", "E11", "E14"], metavar="SAT",
                        help="satellites in the table")
    args = parser.parse_args()
    if not (0 < args.rate <= 1000 and 0 < args.seconds <= 86400):
        parser.error("--rate is up to 1000 a second, --seconds up to a day")
    count = max(1, round(args.rate * args.seconds))
    try:
        with orrery.Client(args.url, name="generator.py") as client:
            first = orrery.from_text(args.at) if args.at else client.span[0]
            print(f"served: {client.caps.title}; {len(client.satellites)} satellites, "
                  f"{orrery.to_text(client.span[0])} to {orrery.to_text(client.span[1])}")
            taken, with_state = [], 0
            start = time.monotonic()
            for k in range(count):
                time.sleep(max(0.0, start + k / args.rate - time.monotonic()))
                asked = time.monotonic()
                states = client.states(first + round(k * 1e9 / args.rate))
                taken.append(time.monotonic() - asked)
                with_state += sum(s.answer == Answer.OK for s in states.satellites)
                if k in (0, count - 1):
                    table(states, args.show)
            took = time.monotonic() - start
            print(f"{count} polls in {took:.1f} s, {with_state / count:.0f} satellites each; question to decoded answer "
                  f"{statistics.median(taken) * 1e3:.1f} ms (median), {max(taken) * 1e3:.1f} ms (longest)")
    except (OSError, ValueError, orrery.ProtocolError, orrery.Refused) as error:
        print(f"{args.url}: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
    return 0 if with_state > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
