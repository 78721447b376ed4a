#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Write the seeds of the wire fuzz target: the example frames of the specification in each of its uses.

Usage: make_wire_seeds.py [CORPUS_DIR]; the result is committed, so run it only to change the seeds."""
import pathlib
import sys

import yaml

ROOT = pathlib.Path(__file__).resolve().parents[3]


def main():
    out = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "tests/fuzz/corpus/wire")
    out.mkdir(parents=True, exist_ok=True)
    spec = yaml.safe_load((ROOT / "proto/spec/messages.yaml").read_text(encoding="utf-8"))
    frames = {e["name"]: bytes.fromhex(e["hex"]) for e in spec["examples"]}
    for name, frame in frames.items():
        payload = frame[16:-4]
        (out / f"payload_{name}").write_bytes(b"\0" + payload)
        (out / f"stream_{name}").write_bytes(b"\x05" + frame + frames["ping"])
        (out / f"answer_{name}").write_bytes(b"\x03" + frame)


main()
