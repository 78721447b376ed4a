# SPDX-License-Identifier: MIT
"""python3 -m orrery.poll URL: asks a service as a signal generator would, and prints a table.

    python3 -m orrery.poll tcp://127.0.0.1:15754 --rate 10 --seconds 3 --sat G05 E11
"""
from __future__ import annotations

import argparse
import math
import sys
import time
from typing import Iterator

from . import client, codec, gpstime
from .messages import Answer, Delays, StateFlags, States


def rows(states: States) -> Iterator[str]:
    """Lines of a table, one a satellite."""
    for s in states.satellites:
        if s.answer != Answer.OK:
            yield f"{s.sat}  {s.answer.name.lower().replace('_', ' ')}"
            continue
        flags = ", ".join(str(f.name).lower().replace("_", " ") for f in StateFlags if f & s.flags and f != StateFlags.CLOCK_VALID)
        clock = f"{s.clock_s * 1e6:14.6f}" if s.flags & StateFlags.CLOCK_VALID else f"{'-':>14}"
        yield f"{s.sat} " + " ".join(f"{x:15.4f}" for x in s.pos_m) + " " + " ".join(f"{v:11.5f}" for v in s.vel_mps) + \
            f" {clock}  {flags}"


def show(states: States) -> None:
    print(f"{gpstime.to_text(states.t)} GPS")
    if states.answer != Answer.OK:
        print("  outside the served span")
        return
    print(f"sat {'x m':>15} {'y m':>15} {'z m':>15} {'vx m/s':>11} {'vy m/s':>11} {'vz m/s':>11} {'clock us':>14}")
    for line in rows(states):
        print(line.rstrip())


def show_delays(delays: Delays) -> None:
    print(f"{gpstime.to_text(delays.t)} GPS")
    if delays.answer != Answer.OK:
        print("  outside the served span")
        return
    print("receiver at " + " ".join(f"{x:.4f}" for x in delays.receiver_m) + " m")
    print(f"sat {'az deg':>8} {'el deg':>8} {'TECU':>9} " + " ".join(f"{f'm@{f / 1e6:.2f}':>10}" for f in delays.carriers_hz) + "  from")
    for s in delays.satellites:
        if s.answer != Answer.OK:
            continue  # most are below the horizon
        print(f"{s.sat} {math.degrees(s.az_rad):8.2f} {math.degrees(s.el_rad):8.2f} {s.stec_tecu:9.3f} " +
              " ".join(f"{d:10.4f}" for d, _ in zip(s.delay_m, delays.carriers_hz)) + f"  {s.origin.name.lower()}")


def show_motion(c: client.Client, t: int, step_s: float, unit: int) -> None:
    """Truth at t and the increments that follow."""
    truth, imu = c.truth(t, unit), c.imu(t, step_s, unit)
    print(f"{gpstime.to_text(t)} GPS  unit {unit}")
    if truth.answer != Answer.OK:
        print("  outside the trajectory's span")
        return
    print("  position m     " + " ".join(f"{x:15.4f}" for x in truth.pos_m))
    print("  velocity m/s   " + " ".join(f"{x:15.6f}" for x in truth.vel_mps))
    print("  heading pitch roll deg " + " ".join(f"{math.degrees(a):10.5f}" for a in (truth.heading_rad, truth.pitch_rad, truth.roll_rad)))
    print(f"  gravity disturbance {truth.disturbance_mgal:.3f} mGal, Eotvoes {truth.eotvos_mgal:.3f} mGal")
    if imu.answer == Answer.OK:
        print(f"  increments over {(imu.t1 - imu.t) * 1e-9:g} s: rad " + " ".join(f"{x:.9e}" for x in imu.dtheta_rad) +
              ", m/s " + " ".join(f"{x:.9e}" for x in imu.dv_mps))


def main() -> int:
    parser = argparse.ArgumentParser(prog="python3 -m orrery.poll", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("url", help="tcp://HOST:PORT or unix:PATH")
    parser.add_argument("--at", help="first epoch, GPS time, or with Z or another scale behind it (default: the start of the served span)")
    parser.add_argument("--sat", nargs="+", default=[], metavar="SAT", help="satellites, e.g. G05 E11 (default: all)")
    parser.add_argument("--rate", type=float, default=1.0, help="epochs a second (default 1)")
    parser.add_argument("--seconds", type=float, help="poll in real time for so long (default: one epoch)")
    parser.add_argument("--delays", action="store_true", help="ionospheric delays instead of states")
    parser.add_argument("--receiver", nargs=3, type=float, metavar=("X", "Y", "Z"),
                        help="with --delays: the receiver in metres, ecef (default: the scenario's own, which moves with its trajectory)")
    parser.add_argument("--carrier", nargs="+", type=float, default=[], metavar="MHZ",
                        help="with --delays: up to four carriers (default 1575.42)")
    parser.add_argument("--imu", action="store_true", help="true motion and inertial increments instead of states")
    parser.add_argument("--unit", type=int, default=0, help="with --imu: which inertial unit (default 0)")
    args = parser.parse_args()
    if not 0 < args.rate <= 1e6:
        parser.error("--rate is more than 0")
    try:
        with client.Client(args.url, name="orrery.poll") as c:
            t0 = gpstime.from_text(args.at) if args.at else c.span[0]
            count = max(1, round(args.seconds * args.rate)) if args.seconds else 1
            start = time.monotonic()
            for k in range(count):
                t = t0 + round(k / args.rate * gpstime.NS_PER_S)
                if args.imu:
                    show_motion(c, t, 0.0, args.unit)
                elif args.delays:
                    show_delays(c.delays(t, args.receiver, [1e6 * f for f in args.carrier], args.sat))
                else:
                    show(c.states(t, args.sat))
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
