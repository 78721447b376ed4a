# SPDX-License-Identifier: MIT
"""python3 -m orrery.poll URL: asks a service as a signal generator would, and prints a table.

    python3 -m orrery.poll tcp://127.0.0.1:15754 --rate 10 --seconds 3 --sat G05 E11
"""
import argparse
import sys
import time

from . import client, codec, gpstime
from .messages import Answer, StateFlags


def rows(states):
    """Lines of a table, one a satellite."""
    for s in states.satellites:
        name = client.sat_name(s.sat)
        if s.answer != Answer.OK:
            yield f"{name}  {Answer(s.answer).name.lower().replace('_', ' ')}"
            continue
        flags = ", ".join(f.name.lower().replace("_", " ") for f in StateFlags if f & s.flags and f != StateFlags.CLOCK_VALID)
        clock = f"{s.clock_s * 1e6:14.6f}" if s.flags & StateFlags.CLOCK_VALID else f"{'-':>14}"
        yield f"{name} " + " ".join(f"{x:15.4f}" for x in s.pos_m) + " " + " ".join(f"{v:11.5f}" for v in s.vel_mps) + \
            f" {clock}  {flags}"


def show(states):
    print(f"{gpstime.to_text(states.t)} GPS")
    if states.answer != Answer.OK:
        print("  outside the served span")
        return
    print(f"sat {'x m':>15} {'y m':>15} {'z m':>15} {'vx m/s':>11} {'vy m/s':>11} {'vz m/s':>11} {'clock us':>14}")
    for line in rows(states):
        print(line.rstrip())


def main():
    parser = argparse.ArgumentParser(prog="python3 -m orrery.poll", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("url", help="tcp://HOST:PORT or unix:PATH")
    parser.add_argument("--at", help="first epoch, GPS time (default: the start of the served span)")
    parser.add_argument("--sat", nargs="+", default=[], metavar="SAT", help="satellites, e.g. G05 E11 (default: all)")
    parser.add_argument("--rate", type=float, default=1.0, help="epochs a second (default 1)")
    parser.add_argument("--seconds", type=float, help="poll in real time for so long (default: one epoch)")
    args = parser.parse_args()
    if not 0 < args.rate <= 1e6:
        parser.error("--rate is more than 0")
    try:
        with client.Client(args.url, name="orrery.poll") as c:
            t0 = gpstime.from_text(args.at) if args.at else c.span[0]
            count = max(1, round(args.seconds * args.rate)) if args.seconds else 1
            start = time.monotonic()
            for k in range(count):
                show(c.states(t0 + round(k / args.rate * gpstime.NS_PER_S), args.sat))
                if k + 1 < count:
                    time.sleep(max(0.0, start + (k + 1) / args.rate - time.monotonic()))
    except (OSError, ValueError, client.ProtocolError, client.Refused, codec.CodecError) as error:
        print(f"{args.url}: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
