#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The Wireshark dissector on the example frames, if tshark is here: a frame cut into two segments, two frames in one segment, and
a wrong checksum."""
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile

import yaml

ROOT = pathlib.Path(__file__).resolve().parents[3]
SKIPPED = 77


def capture(path, segments, port):
    """A pcap file of raw IP packets: (0 for the client, 1 for the server; bytes of the segment)."""
    with open(path, "wb") as out:
        out.write(struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 65535, 101))
        sent = [1, 1]
        for side, data in segments:
            ports = (40000, port) if side == 0 else (port, 40000)
            tcp = struct.pack(">HHIIBBHHH", *ports, sent[side], sent[1 - side], 5 << 4, 0x18, 65535, 0, 0)
            sent[side] += len(data)
            size = 40 + len(data)
            ip = struct.pack(">BBHHHBBH4s4s", 0x45, 0, size, 0, 0, 64, 6, 0, b"\x7f\0\0\1", b"\x7f\0\0\1")
            out.write(struct.pack("<IIII", 1, 0, size, size) + ip + tcp + data)


def main():
    tshark = shutil.which("tshark")
    if tshark is None:
        print("skipped: tshark is not installed")
        return SKIPPED
    spec = yaml.safe_load((ROOT / "proto/spec/messages.yaml").read_text(encoding="utf-8"))
    frames = {e["name"]: bytes.fromhex(e["hex"]) for e in spec["examples"]}
    bad = bytearray(frames["ping"])
    bad[18] ^= 1
    states = frames["states"]
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "frames.pcap"
        capture(path, [(0, frames["hello"]), (0, frames["poll"]), (1, states[:100]), (1, states[100:] + frames["error"]),
                       (1, frames["elements"] + frames["navdata"]),
                       (0, bytes(bad))], spec["protocol"]["port"])
        done = subprocess.run([tshark, "-X", f"lua_script:{ROOT}/proto/gen/orrery.lua", "-r", str(path), "-V", "-O", "orrery"],
                              capture_output=True, text=True, timeout=60, check=False)
    wanted = ["Orrery HELLO, sequence 1", "name: gen", "Orrery POLL, sequence 2", "step [ns]: 100000000", "system: 'E'",
              "Orrery STATES, sequence 2", "pos_m: -20100000.5", "answer: NO_ARC (2)", "valid_to [ns]: -9223372036854775808",
              "Orrery ERROR, sequence 3", "code: UNKNOWN_TYPE (5)", "sentence: unknown message type 999",
              "Orrery ELEMENTS, sequence 4", "method: MEAN (2)", "answer: NO_VALUE (5)", "Orrery NAVDATA, sequence 5",
              "message: FDMA (2)", "channel: 5", "bits: 85", "08bbb8c857800ed33ec0a8", "answer: NOT_SERVED (3)", "Orrery PING, sequence 1"]
    at = 0
    for text in wanted:  # in this order
        found = done.stdout.find(text, at)
        if found < 0:
            print(f"'{text}' is missing or out of order in:\n{done.stdout}\n{done.stderr}", file=sys.stderr)
            return 1
        at = found
    if done.stdout.count("(Error/Checksum): checksum does not match") != 1 or "Lua Error" in done.stdout + done.stderr:
        print(f"one wrong checksum was to be told:\n{done.stdout}\n{done.stderr}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
