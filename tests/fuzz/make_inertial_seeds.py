#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the seeds of the fuzz targets of telemetry, gravity, files of readings, sessions and orbit products: small made files and edits."""
import functools
import operator
import pathlib
import struct

HERE = pathlib.Path(__file__).resolve().parent / "corpus"


def table(n=40, step=0.2, header="t,lat,lon,height,heading,pitch,roll\n", separator=","):
    rows = [(k * step, 50 + 1e-5 * k, 179.999 + 1e-4 * k - 360 * (k > 10), 100 + k % 3, (355 + k) % 360, 1, -k) for k in range(n)]
    return header + "".join(separator.join(f"{v:.6g}" if i != 1 and i != 2 else f"{v:.7f}" for i, v in enumerate(r)) + "\n" for r in rows)


def nmea(n=30):
    out = ""
    for k in range(n):
        bodies = [f"GPGGA,2359{30 + k % 30:02d}.00,4807.{k:03d},N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,",
                  f"GPRMC,2359{30 + k % 30:02d}.00,A,4807.{k:03d},N,01131.000,E,022.4,084.4,230324,003.1,W", f"HEHDT,{90 + k}.5,T"]
        for body in bodies:
            out += f"${body}*{functools.reduce(operator.xor, body.encode()):02X}\r\n"
    return out


def sentences(bodies, stamp=""):
    return "".join(f"{stamp}${body}*{functools.reduce(operator.xor, body.encode()):02X}\r\n" for body in bodies)


def place(clock, k, separation="47.0"):
    return f"GNGGA,{clock}.00,4807.{k:03d},N,01131.000,E,1,08,0.9,545.4,M,{separation},M,,"


def dated(clock, date, status="A"):
    return f"GNRMC,{clock}.00,{status},4807.000,N,01131.000,E,022.4,084.4,{date},003.1,W"


def sessions():
    """Status V, a session, one of the next day, one of an earlier day, one that nothing dates, a contradiction, whole days."""
    for day, (hour, date, status) in enumerate((("10", "060180", "V"), ("11", "150824", "A"), ("09", "160824", "A"), ("08", "010123", "A"),
                                                ("07", "", "A"), ("06", "160824", "A"), ("06", "180824", "A"))):
        for k in range(12):
            yield dated(f"{hour}00{k:02d}", "110203" if k == 5 else date, status)
            yield place(f"{hour}00{k:02d}", k + day, "" if day == 4 else "47.0")
    yield "GPZDA,070020.00,16,08,2024,00,00"


def leap():
    for k, clock in enumerate(("235957", "235958", "235959", "235960", "000000", "000001", "000002", "000003", "000004", "000005", "000006")):
        yield dated(clock, "311216" if k < 4 else "010117")
        yield place(clock, k)


TELEMETRY = {
    "table.csv": table(), "seven.txt": table(header="", separator=" "), "semicolons.csv": table(separator=";", header="t;lat;lon;height;yaw;pitch;roll\n"),
    "declared.txt": "@t[s],lat[deg],lon,h[m],heading[-deg],-,-\n" + table(header=""),
    "columns.csv": "# columns: t,lat,lon,height,heading,pitch,roll\n" + table(header=""),
    "weeks.csv": "week,tow_ms,lat,lon,alt,fix\n" + "".join(f"2300,{200 * k},50.{k:04d},20,100,{3 if k % 7 else 1}\n" for k in range(40)),
    "far-clock.csv": "week,tow,t,lat,lon,alt\n" + "".join(f"2300,{k},{1e15 if k == 0 else k},50.{k:04d},20,100\n" for k in range(20)),
    "iso.csv": "time[utc],x,y,z\n" + "".join(f"2024-02-04T00:00:{k:02d}.5,{3.8e6 + 50 * k},1.1e6,4.98e6\n" for k in range(40)),
    "motion.csv": "".join(f"{k / 10:.1f},{-3813477.954 + k:.3f},3554276.552,3662785.237\n" for k in range(40)),
    "gps.nmea": nmea(), "sessions.nmea": sentences(sessions()), "leap.nmea": "4.5,W*7A\n\n" + sentences(leap(), "2016 "),
    "instants.csv": "date;time;lat;lon;height_msl;geoid\n" + "".join(f'2024-08-15;"23:59:{30 + k}+02:00";50,{k:04d};20;1;40\n' for k in range(30)),
    "unix.csv": "time_utc_usec,lat,lon,alt\n" + "".join(f"{1723716000000000 + 200000 * k},520000{k:03d},130000000,100000\n" for k in range(30)),
    "px4.csv": "timestamp,time_utc_usec,lat,lon,alt,alt_ellipsoid,fix_type,heading\n"
               + "".join(f"{200000 * k},{1723716000000000 + 200000 * k},520000{k:03d},130000000,100,{147000 + k},3,nan\n" for k in range(30)),
    "ardupilot.csv": "TimeUS,Status,GMS,GWk,Lat,Lng,Alt,Yaw\n" + "".join(f"{200000 * k + k % 3},3,{200 * k},1770,50.{k:04d},20,100,0\n" for k in range(30)),
    "quaternion.csv": "t,lat,lon,h,q[0],q[1],q[2],q[3]\n" + "".join(f"{k / 5},50.{k:04d},20,1,0.8,0,0,0.6\n" for k in range(30)),
    "clocks.csv": "week,tow,t,lat,lon,alt,yaw\n" + "".join(f"2300,{k},{1.001 * k + 40 + 0.1 * (k % 3)},50.{k:04d},20,100,{k}\n" for k in range(90)),
    "wraps.csv": "t,lat,lon,alt\n" + "".join(f"{(86380 + k) % 86400},50.{k:04d},20,100\n" for k in range(40)),
    "week-wraps.csv": "tow,lat,lon,alt\n" + "".join(f"{(604780 + k) % 604800},50.{k:04d},20,100\n" for k in range(40)),
    "own.csv": "# t in seconds after 2024-02-04T10:00:00 GPS\n" + table(),
    "gap.csv": table(20) + table(40).split("\n", 30)[-1].replace("\n5", "\n25"),
    "pole.csv": "t,lat,lon,h\n" + "".join(f"{k},{89.9999 + 1e-5 * min(k, 20 - k):.6f},{20 if k < 10 else -160},0\n" for k in range(20)),
}
GRAVITY = {
    "profile.csv": "distance_m,mgal\n" + "".join(f"{500 * k},{k * k % 17}\n" for k in range(12)),
    "map.csv": "lat,lon,mgal\n" + "".join(f"{50 + i},{20 + k},{i - 2 * k}\n" for i in range(5) for k in range(4)),
    "blanks.txt": "# map\n" + "".join(f"{-2 + 0.5 * i} {178 + k}\t{i + k}\n" for i in range(4) for k in range(6)),
}


def edit(do, what, entry, at=0, value=b""):
    return struct.pack("<BBH8s", do + 4 * what, entry, at, value)


def number(x):
    return struct.pack("<d", x)


EDITS = {
    "none": b"", "value": edit(0, 0, 3, 2, number(1e9)), "nan": edit(0, 1, 2, 1, b"\4"), "all-zero": edit(0, 2, 4, 0, b"\0"),
    "scaled": edit(0, 3, 1, 1, b"\7"), "same": edit(0, 4, 0, 1), "gone": edit(0, 5, 5), "rank": edit(0, 5, 2, 0, b"\1"),
    "attribute": edit(2, 0, 4, 0, number(-3.5)), "attribute-nan": edit(2, 1, 6, 0, b"\4"), "attribute-far": edit(2, 2, 12, 0, b"\1"),
    "text": edit(2, 3, 2, 0, b"\3\0x"), "no-attribute": edit(2, 4, 3), "short": edit(3, 0, 0, 2), "long": edit(3, 0, 1, 200),
    "huge": edit(3, 1, 2, 0, struct.pack("<Q", 99999999)),
}


def main():
    for name, text in TELEMETRY.items():
        write("telemetry", name, text.encode())
    for name, text in GRAVITY.items():
        write("gravity", name, text.encode())
    for target, kinds in (("imu", 4), ("session", 3), ("product", 3), ("gravity_map", 3)):
        for k in range(kinds):
            for name, edits in EDITS.items():
                if k == 0 or name in ("none", "value", "long"):
                    write(target, f"{name}-{k}", bytes([k]) + edits)
        write(target, "many", bytes([1]) + b"".join(EDITS.values()))
    for name, first in (("day", 23), ("zero-clocks", 25), ("four-hours", 49)):
        write("product", name, bytes([first]))  # the kind, and what broadcast data are asked for


def write(target, name, data):
    folder = HERE / target
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_bytes(data)


if __name__ == "__main__":
    main()
