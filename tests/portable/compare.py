# SPDX-License-Identifier: GPL-3.0-or-later
"""compare.py PROGRAM OTHER...: the same product and scenario evaluated by the service of two builds, OTHER with whatever it is run in
(qemu-aarch64-static -L ROOT .../orrery): what docs/protocol.md, "The same bytes", promises of each answer, and what was seen."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "proto/python")]
import orrery  # noqa: E402  pylint: disable=wrong-import-position
from orrery import messages as m  # noqa: E402  pylint: disable=wrong-import-position

ONE, OTHER = sys.argv[1:2], sys.argv[2:]
T = orrery.from_text("2025-03-21T06:00:00")
MINUTE = 60 * 10**9
SCENARIO = """
title: the same bytes
orbit: {product: day.nc}
trajectory: {kind: survey, start: "2025-03-21T06:00:00", duration: 7200, lat: 56, lon: 40, height: 1500, speed: 65, bank: 20,
  survey: {azimuth: 0, length: 30000, spacing: 2000, lines: 4, tie_lines: 0}, turbulence: {rms: 0.5, low: 0.02, high: 0.25}, seed: 1}
units: [{name: one}]
antennas: [{name: top}]
signals: ["G:L1CA", "E:E1"]
"""
# Answer, request, and by how much its numbers may differ, relative to themselves or to 1; 0: the same to the bit. Positions of 6.4e6 m are
# rounded to 1e-9 m; forces are their second derivatives over nodes of a tenth of a second, and carriers' cubics their third in cycles.
ASKED = [("STATES", m.Poll(m.Epochs(T, MINUTE, 60), []), m.States, 0),
         ("ELEMENTS", m.PollElements(m.Epochs(T, MINUTE, 60)), m.Elements, 1e-10),
         ("NAVDATA", m.PollNavdata(m.Epochs(T, 30 * MINUTE, 2)), m.Navdata, 1e-7),
         ("CHANNELS", m.PollChannels(m.Epochs(T, MINUTE, 10)), m.Channels, 1e-5),
         ("IMU", m.PollImu(m.Epochs(T, 10**9, 100)), m.Imu, 1e-7),
         ("TRUTH", m.PollTruth(m.Epochs(T, 10**9, 100)), m.Truth, 1e-7)]


def answers(program, folder):
    """Of a service of that program, kind by kind."""
    words = [*program, "serve", str(folder / "scenario.yaml"), "--listen", "tcp://127.0.0.1:0"]
    with subprocess.Popen(words, stderr=subprocess.PIPE, text=True) as service:
        try:
            for line in service.stderr:
                ready = re.search(r"ready on (\S+)", line)
                if ready:
                    break
                print("   ", line, end="")
            else:
                raise SystemExit(f"{' '.join(words)}: ended")
            with orrery.Client(ready.group(1), timeout_s=300) as c:
                return [list(c._answers(request, reply, request.epochs.count)) for _, request, reply, _ in ASKED]
        finally:
            service.terminate()


def numbers(x, where=""):
    """All numbers of a message, by their fields."""
    if isinstance(x, orrery.codec.Record):
        for f in x.LAYOUT:
            yield from numbers(getattr(x, f.name), f.name)
    elif isinstance(x, (list, tuple)):
        for y in x:
            yield from numbers(y, where)
    else:
        yield where, x


def apart(a, b):
    """What two numbers differ by, relative to the larger or to 1."""
    if isinstance(a, float):
        return 0 if a == b or (a != a and b != b) else abs(a - b) / max(abs(a), abs(b), 1.0)
    return 0 if a == b else float("inf")


def main():
    folder = pathlib.Path(tempfile.mkdtemp(prefix="orrery-portable-"))
    try:
        subprocess.run([*ONE, "orbit", "-q", "-o", folder / "day.nc", "--sat", "G01-G06,R01-R02,E01-E02",
                        ROOT / "samples/ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"], check=True)
        (folder / "scenario.yaml").write_text(SCENARIO, encoding="utf-8")
        both = [answers(program, folder) for program in (ONE, OTHER)]
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    good = True
    for (name, _, _, most), one, other in zip(ASKED, *both):
        same = [a.encode() for a in one] == [b.encode() for b in other]
        worst, field = 0.0, ""
        for a, b in zip(one, other):
            pairs = list(zip(numbers(a), numbers(b), strict=True))
            for (what, x), (_, y) in pairs:
                if apart(x, y) > worst:
                    worst, field = apart(x, y), what
        print(f"    {name}: {'the same bytes' if same else f'apart by {worst:.1e} of itself or of 1 ({field})'}"
              f", promised: {f'below {most:.0e}' if most > 0 else 'the same bytes'}")
        good = good and (worst < most if most > 0 else same)
    return 0 if good else 1


if __name__ == "__main__":
    os.environ["PYTHONDONTWRITEBYTECODE"] = "1"
    sys.exit(main())
