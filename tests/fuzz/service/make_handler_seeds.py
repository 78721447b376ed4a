#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the seeds of the fuzz target of the handlers: requests of every kind, as they are usual and at the ends of what a
field can hold.

Usage: make_handler_seeds.py [CORPUS_DIR]; the result is committed, so run it only to change the seeds."""
import math
import pathlib
import struct
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "proto/python"))
from orrery import messages as m  # noqa: E402

NOON = 1391040000 * 10**9 + 3600 * 10**9  # an hour after the made day's midnight
S, FIRST, LAST = 10**9, -2**63, 2**63 - 1
SATS = [m.SatId(*pair) for pair in ((71, 1), (82, 1), (69, 9), (0, 0))]


def request(message):
    payload = message.encode()
    return bytes([message.TYPE]) + struct.pack("<H", len(payload)) + payload


def main():
    out = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "tests/fuzz/corpus/handlers")
    out.mkdir(parents=True, exist_ok=True)
    own = [math.nan] * 3
    spans = {"inside": m.Epochs(NOON, S, 3), "edge": m.Epochs(NOON - 2 * S, S // 2, 20), "first": m.Epochs(FIRST, 0, 1),
             "last": m.Epochs(LAST, 0, 1), "before": m.Epochs(FIRST, S, 2), "beyond": m.Epochs(LAST - S, S, 86400),
             "back": m.Epochs(NOON, -S, 3), "none": m.Epochs(NOON, S, 0), "rate": m.Epochs(NOON, 0, 5),
             "late_rate": m.Epochs(LAST - 10, 0, 5)}
    for name, epochs in spans.items():
        polls = [m.Poll(epochs, []), m.PollNavdata(epochs, SATS), m.PollDelays(epochs, own, [1575.42e6, 1227.6e6], []),
                 m.PollDelays(epochs, [6.378137e6, 0, 0], [], SATS), m.PollImu(epochs, 1), m.PollTruth(epochs, 0)]
        polls += [m.PollElements(epochs, frame, method, SATS) for frame, method in ((0, 0), (1, 1), (2, 2))]
        polls += [m.PollEvents(epochs)]
        for k, poll in enumerate(polls):
            (out / f"{type(poll).__name__.lower()}_{name}_{k}").write_bytes(request(poll) + request(m.Ping(7)))
    long = m.PollImu(m.Epochs(NOON, 300 * S, 2), 0)
    (out / "imu_long").write_bytes(request(m.Hello(1, 1, "seed", "1")) + request(long) + request(long))


main()
