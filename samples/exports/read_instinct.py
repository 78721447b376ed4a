#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""INSTINCT (github.com/UniStuttgart-INS/INSTINCT) opens the CSV in a flow's ImuFile node and needs no script; this one checks what that node looks for,
and prints the mean force and rate:

    read_instinct.py IMU.csv
"""
import csv
import sys

WANTED = ["GpsCycle", "GpsWeek", "GpsToW [s]", "TimeStartup [ns]"] + [f"UnCompAcc{a} [m/s^2]" for a in "XYZ"] + [f"UnCompGyro{a} [rad/s]" for a in "XYZ"]
with open(sys.argv[1]) as file:
    rows = csv.DictReader(file)
    missing = [name for name in WANTED if name not in rows.fieldnames]
    if missing:
        raise SystemExit(f"no columns {', '.join(missing)}")
    sums, n = [0.0] * 6, 0
    for row in rows:
        n += 1
        for k, name in enumerate(WANTED[4:]):
            sums[k] += float(row[name])
print(f"{n} readings; mean force {' '.join(f'{v / n:.6f}' for v in sums[:3])} m/s2, mean rate {' '.join(f'{v / n:.9f}' for v in sums[3:])} rad/s, forward right down")
