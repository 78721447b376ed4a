# SPDX-License-Identifier: GPL-3.0-or-later
"""An orbit ephemeris message in keyword = value notation, read as CCSDS 502.0-B-3, section 5, has it: which keywords there are, in which
order, which are needed, and the interpolation that a segment names. It knows nothing of the program that wrote the message."""
import datetime
import pathlib

HEADER = ("CCSDS_OEM_VERS", "CLASSIFICATION", "CREATION_DATE", "ORIGINATOR", "MESSAGE_ID")  # table 5-2
META = ("OBJECT_NAME", "OBJECT_ID", "CENTER_NAME", "REF_FRAME", "REF_FRAME_EPOCH", "TIME_SYSTEM", "START_TIME", "USEABLE_START_TIME", "USEABLE_STOP_TIME",
        "STOP_TIME", "INTERPOLATION", "INTERPOLATION_DEGREE")  # table 5-3
NEEDED = {"OBJECT_NAME", "OBJECT_ID", "CENTER_NAME", "REF_FRAME", "TIME_SYSTEM", "START_TIME", "STOP_TIME"}
LONGEST = 254  # characters of a line, 7.3.2


class Segment:
    def __init__(self, meta, rows):
        self.meta, self.rows = meta, rows
        self.epochs = [t for t, _, _ in rows]
        start, stop = instant(meta["START_TIME"]), instant(meta["STOP_TIME"])
        if not rows or self.epochs[0] < start or self.epochs[-1] > stop:
            raise ValueError("epochs beyond START_TIME or STOP_TIME")
        if any(b <= a for a, b in zip(self.epochs, self.epochs[1:])):
            raise ValueError("epochs that do not ascend")
        if ("INTERPOLATION" in meta) != ("INTERPOLATION_DEGREE" in meta):
            raise ValueError("INTERPOLATION and its degree go together")

    def at(self, t):
        """Position, km, and velocity, km/s, by the segment's own interpolation: Hermite's polynomial through the nearest nodes."""
        if self.meta["INTERPOLATION"] != "HERMITE":
            raise ValueError("another interpolation than this reader's")
        n = (int(self.meta["INTERPOLATION_DEGREE"]) + 1) // 2
        first = min(max(sum(e <= t for e in self.epochs) - n // 2, 0), len(self.rows) - n)
        nodes = self.rows[first:first + n]
        x = [(e - t).total_seconds() for e, _, _ in nodes]
        pairs = [hermite(x, [p[k] for _, p, _ in nodes], [v[k] for _, _, v in nodes]) for k in range(3)]
        return [p for p, _ in pairs], [v for _, v in pairs]


def hermite(x, y, dy):
    """Value and slope at 0 of the polynomial with values y and slopes dy at x: divided differences over doubled nodes."""
    z = [v for v in x for _ in (0, 1)]
    column = [v for v in y for _ in (0, 1)]
    coefficient = [column[0]]
    for order in range(1, len(z)):
        column = [dy[i // 2] if order == 1 and z[i] == z[i + 1] else (column[i + 1] - column[i]) / (z[i + order] - z[i])
                  for i in range(len(z) - order)]
        coefficient.append(column[0])
    value = slope = 0.0
    for c, node in zip(reversed(coefficient), reversed(z)):
        slope = slope * -node + value
        value = value * -node + c
    return value, slope


def instant(text):
    return datetime.datetime.fromisoformat(text)


def take(line, known, into):
    """A line "KEYWORD = value", after those that stand before it in the table."""
    key, sign, value = (part.strip() for part in line.partition("="))
    if not sign or key not in known:
        raise ValueError(f"{line!r} is no line of this part (META_STOP or a keyword is missing)")
    if into and known.index(key) <= max(map(known.index, into)):
        raise ValueError(f"{key} is out of order")
    if not value:
        raise ValueError(f"{key} has no value")
    into[key] = value


def read(path):
    lines = pathlib.Path(path).read_text(encoding="ascii").splitlines()
    if any(len(line) > LONGEST for line in lines):
        raise ValueError("a line that is too long")
    header, segments, meta, rows, part = {}, [], {}, [], "header"
    for line in lines:
        if not line.strip():
            continue
        if line.startswith("COMMENT "):
            if part == "meta" and meta:
                raise ValueError("a comment between keywords of META")
        elif line == "META_START":
            if part == "data":
                segments.append(Segment(meta, rows))
            if set(header) < {"CCSDS_OEM_VERS", "CREATION_DATE", "ORIGINATOR"}:
                raise ValueError("a header without what it needs")
            meta, rows, part = {}, [], "meta"
        elif line == "META_STOP" and part == "meta":
            if not NEEDED <= set(meta):
                raise ValueError(f"a META without {sorted(NEEDED - set(meta))}")
            part = "data"
        elif part == "header":
            take(line, HEADER, header)
        elif part == "meta":
            take(line, META, meta)
        else:
            word = line.split()
            if len(word) not in (7, 10):
                raise ValueError(f"{line!r} is no state")
            numbers = [float(x) for x in word[1:]]
            rows.append((instant(word[0]), numbers[:3], numbers[3:6]))
    if header.get("CCSDS_OEM_VERS") not in ("1.0", "2.0", "3.0"):
        raise ValueError("a version that there is none of")
    segments.append(Segment(meta, rows))
    return segments
