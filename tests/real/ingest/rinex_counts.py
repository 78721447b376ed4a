#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every well-formed RINEX file of the data folder is accepted by `orrery inspect`, and its counts of epochs, satellites
and ephemerides are those of a plain count of the file's lines that knows nothing of our readers.

usage: rinex_counts.py ORRERY DATA_FOLDER
"""
import json
import pathlib
import re
import subprocess
import sys


def text_of(path):
    """The file's text; gzip's own program opens .gz and .Z."""
    return subprocess.run(["gzip", "-dc", path], check=True, stdout=subprocess.PIPE).stdout.decode("latin-1")


def canonical(sat, blank):
    letter, number = sat[0], sat[1:].replace(" ", "0")
    return (letter if letter != " " else blank) + number


def body(lines):
    at = next(i for i, line in enumerate(lines) if line[60:].startswith("END OF HEADER"))
    return lines[:at], lines[at + 1:]


def count_nav(lines):
    head, data = body(lines)
    version = float(head[0][:9])
    if version >= 4:
        tags = [line.split() for line in data if line.startswith("> EPH")]
        return None, {t[2] for t in tags}, len(tags)
    if version >= 3:
        first = [line[:3] for line in data if re.match(r"[GRECJIS]\d\d \d{4} ", line)]
    else:
        letter = "R" if head[0][20] == "G" else "G"
        first = [letter + line[:2].replace(" ", "0") for line in data if re.match(r"[ \d]\d [ \d]\d [ \d]\d", line)]
    return None, set(first), len(first)


def contradictions(lines):
    """Whether some records of one issue (satellite, message, time of clock, issue of data, time of ephemeris) of GPS LNAV, I/NAV
    or F/NAV differ in clock or orbit. Only files of versions 3 and 4 hold what several receivers heard."""
    head, data = body(lines)
    if float(head[0][:9]) < 3:
        return False
    seen, tag = {}, ""
    for i, line in enumerate(data):
        if line.startswith(">"):
            tag = line.split()[-1]
        elif re.match(r"[GE]\d\d \d{4} ", line) and tag not in ("CNAV", "CNV2"):
            rows = data[i:i + 8]
            f_nav = line[0] == "E" and int(float(rows[5][23:42].replace("D", "E"))) & 2
            key = (line[:23], bool(f_nav), rows[1][4:23], rows[3][4:23])
            says = [line[23:]] + [row[4:] for row in rows[1:5]] + [rows[5][4:23]]
            if seen.setdefault(key, says) != says:
                return True
    return False


def count_v3(data):
    epochs = sum(1 for line in data if re.match(r"> \d{4}.{25}[01]", line))
    return epochs, {line[:3].replace(" ", "0") for line in data if re.match(r"[GRECJIS][ \d]\d", line)}, None


def types_v2(head):
    return int(next(line for line in head if line[60:].startswith("# / TYPES OF OBSERV"))[:6])


def count_v2(head, data):
    """Walks: an epoch line tells how many lines follow it."""
    per_sat, blank = (types_v2(head) + 4) // 5, head[0][40] if head[0][40] not in " M" else "G"
    epochs, sats, i = 0, set(), 0
    while i < len(data):
        flag, n = int(data[i][28:29] or 0), int(data[i][29:32])
        if 2 <= flag <= 5:
            i += 1 + n
            continue
        ids = []
        for k in range(0, n, 12):
            ids += [data[i + k // 12][32 + 3 * j:35 + 3 * j] for j in range(min(12, n - k))]
        epochs += flag < 2
        sats |= {canonical(s, blank) for s in ids} if flag < 2 else set()
        i += (n + 11) // 12 + n * per_sat
    return epochs, sats, None


def count_hatanaka(lines):
    """Epoch lines of Compact RINEX are character differences; nothing else need be decoded to count."""
    v3, (head, data) = lines[0].startswith("3"), body(lines)
    head, blank = head[2:], "G"
    if not v3 and head[0][40] not in " M":
        blank = head[0][40]
    old, epochs, sats, i = "", 0, set(), 0
    while i < len(data):
        line = data[i]
        if line[:1] == (">" if v3 else "&"):
            old = line
        else:
            size = max(len(old), len(line))
            pairs = zip(old.ljust(size), line.ljust(size))
            old = "".join(a if b == " " else " " if b == "&" else b for a, b in pairs)
        flag, n = old[31 if v3 else 28], int(old[32:35] if v3 else old[29:32])
        i += 1
        if flag in "2345":
            i += n
            continue
        at = 41 if v3 else 32
        epochs += 1
        sats |= {canonical(old[at + 3 * k:at + 3 * k + 3].ljust(3), blank) for k in range(n)}
        i += 1 + n
    return epochs, sats, None


def count(text):
    lines = text.splitlines()
    first = lines[0]
    if first[60:].startswith("CRINEX"):
        return count_hatanaka(lines)
    if first[20] == "O":
        head, data = body(lines)
        return count_v3(data) if float(first[:9]) >= 3 else count_v2(head, data)
    return count_nav(lines)


def main():
    orrery, data = sys.argv[1], pathlib.Path(sys.argv[2])
    if not data.is_dir():
        print(f"skipped: {data} is not here (set ORRERY_DATA)")
        return 77
    wrong, looked_at = [], 0
    for path in sorted(p for p in data.rglob("*") if p.suffix in (".gz", ".Z") and "odd" not in p.parts):
        text = text_of(path)
        label = text[60:80]
        if not (label.startswith("RINEX VERSION") or label.startswith("CRINEX VERS")) or text[20] == "C" and label[0] == "R":
            continue
        looked_at += 1
        run = subprocess.run([orrery, "inspect", "--format", "json", path], stdout=subprocess.PIPE, check=False)
        if run.returncode != 0:
            wrong.append(f"{path.name}: refused")
            continue
        told = json.loads(run.stdout)
        epochs, sats, records = count(text)
        warnings = int(text[20] == "N" and contradictions(text.splitlines()))
        for key, value in (("epochs", epochs), ("satellites", len(sats)), ("records", records), ("warning_count", warnings)):
            if told[key] != value:
                wrong.append(f"{path.name}: {key} {told[key]}, a plain count says {value}")
    for line in wrong:
        print(line, file=sys.stderr)
    print(f"{looked_at} RINEX files, {len(wrong)} differences")
    return 1 if wrong or looked_at == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
