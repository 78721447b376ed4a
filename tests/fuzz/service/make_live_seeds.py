#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the seeds of fuzz_lanes, fuzz_datagrams and fuzz_text_lines into tests/fuzz/corpus."""
import pathlib
import struct
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "proto/python"))
from orrery import datagrams, frame, messages as m  # noqa: E402

CORPUS = ROOT / "tests/fuzz/corpus"
NONE = -2**63


def piece(message):
    if isinstance(message, bytes):
        return message
    data = message.encode()
    return bytes([message.TYPE - 20 if message.TYPE < 40 else 200 + message.TYPE, len(data)]) + data


def poll(t, step, count):
    return m.Poll(m.Epochs(t, step, count)).encode()


def motion(t, **more):
    kind = {"t": t, "order": 2, "pos_m": [3e6, 2e6, 5.2e6], "vel_mps": [10.0, 5, 1]}
    kind.update(more)
    return m.Motion(**kind)


LANES = {
    "free": [m.Subscribe(6, 0, 0, 20, 0, poll(0, 10**6, 30)), m.Credit(1, 20), m.Unsubscribe(1)],
    "clock": [m.Control(4, 0, 0, NONE, NONE, 0), m.Subscribe(6, 1, 0, 1000, 10**7, poll(NONE, 10**6, 0)), m.GetTime(), m.Control(5, 0, 0, NONE, NONE, 0),
              m.Control(6, 0, 0, NONE, NONE, 0)],
    "ring": [m.Subscribe(6, 0, 1, 10, 0, poll(0, 10**6, 5)), m.Subscribe(6, 0, 1, 2, 0, poll(0, 10**6, 0)), m.Credit(2, 5), m.Unsubscribe(2),
             m.Subscribe(6, 0, 2, 2, 0, poll(0, 10**6, 0))],
    "load": [m.Control(1, 0, 0, NONE, NONE, 0, "two"), m.Control(1, 0, 0, 5, NONE, 0, ""), m.Control(4, 0, 0, NONE, NONE, 0, "../x")],
    "modes": [m.Subscribe(m.GetModes.TYPE, 0, 0, 3, 0, m.GetModes(0).encode()), m.Control(4, 0, 0, NONE, NONE, 0), m.GetModes(0), motion(0), m.GetModes(1),
              m.Control(5, 0, 0, NONE, NONE, 0), m.GetModes(2**64 - 1), m.Control(6, 0, 0, NONE, NONE, 0), m.Credit(1, 1), m.Unsubscribe(1)],
    "radio": [m.RadioTime(10**9, 0, 0), m.RadioTime(1002 * 10**6, 0, 0), m.Control(2, 1, 0, 5 * 10**9, NONE, 0), m.Control(3, 1, 0, NONE, NONE, 0),
              m.Control(4, 1, 0, NONE, NONE, 10**7), m.RadioTime(1004 * 10**6, 0, 0)],
    "motion": [m.Control(4, 0, 0, NONE, NONE, 0), motion(0), motion(10**7), motion(2 * 10**7, snap=1, pos_m=[3e6, 2e6, 5.3e6]), m.GetMotionStats(1),
               motion(3 * 10**7, angular_order=4, attitude=[1.0, 0, 0, 0]), motion(4 * 10**7, pos_m=[float("nan"), 0, 0])],
}


def written(slot, message):
    """A message as a client of the ring of motion writes it, the first into each slot."""
    data = message.encode()
    data = struct.pack("<QII", 2 * slot + 2, len(data), message.TYPE) + data
    return bytes([4 * slot, len(data)]) + data


LANES["motion_ring"] = [m.OpenMotionRing(0), m.Control(4, 0, 0, NONE, NONE, 0), written(0, motion(0)), written(1, motion(10**7)), written(2, m.GetTime()),
                        written(3, motion(2 * 10**7, pos_m=[float("nan"), 0, 0]))]
LANES["open"] = [m.OpenDatagrams(0), m.OpenMotionRing(0), m.Subscribe(6, 0, 2, 2, 0, poll(0, 10**6, 5), 4000)]


def datagram(how, number, channel=0, data=b""):
    """A piece of fuzz_datagrams; bit 1 of `how` puts in the number of one of its channels."""
    made = datagrams.make(channel, number, data or frame.make(m.Motion.TYPE, 1, b"x" * 40))
    return bytes([how, len(made)]) + made


DATAGRAMS = {
    "sealed": [datagram(6, 1), datagram(6, 2), datagram(6, 1), datagram(2, 3), datagram(6, 2000), datagram(6, 976), datagram(6, 977)],
    "plain": [datagram(11, 1), datagram(11, 1), datagram(3, 2), datagram(8, 3, 99), datagram(11, 4, data=b"no frame")],
}
LINES = {
    "gsg": b"\x11SCEN:STAR\nSOUR:SCEN:PRY 1,0.1,0.2,0.3;PRYRate 1,-1,2,0;DPRYR IMM,1,2,3;ENUACC 1,1,2,3;POS 1,56,40,150\nEVEN? 2300,5\n"
           b"SCEN:OPEN '../x';OPEN two;LOAD 2300,1\n",
    "scpi": b"\x06*IDN?;*CLS\n:SYST:ERR?;ERR:NEXT?\nSAT:STAT? G05,'2025-03-21';LIST?\nSCEN:ARM;STAR;:TIME?\n*ESE 255;*SRE #H10\n",
    "json": b'\x7f{"request": "POLL", "t": "2025-03-21", "step": 1000000, "count": 3, "satellites": ["G05", "E11"]}\n'
            b'{"request": "CONTROL", "action": "START"}\n{"request": "MOTION", "pos_m": [1, 2, 3], "order": 2}\n',
}


def main():
    for name, messages in LANES.items():
        (CORPUS / "lanes").mkdir(parents=True, exist_ok=True)
        (CORPUS / "lanes" / name).write_bytes(b"".join(piece(x) for x in messages))
    for name, pieces in DATAGRAMS.items():
        (CORPUS / "datagrams").mkdir(parents=True, exist_ok=True)
        (CORPUS / "datagrams" / name).write_bytes(b"".join(pieces))
    for name, data in LINES.items():
        (CORPUS / "text_lines").mkdir(parents=True, exist_ok=True)
        (CORPUS / "text_lines" / name).write_bytes(data)


if __name__ == "__main__":
    main()
