#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A scenario's readings and position fixes for an autopilot in simulation: HIL_SENSOR and HIL_GPS of MAVLink 2.

    mavlink.py URL --udp HOST:PORT       sends datagrams (an autopilot that listens)
    mavlink.py URL --tcp-listen PORT     waits for an autopilot that connects (PX4's simulators: 4560)

Readings are the scenario's (POLL_IMU of a unit, with its errors where the scenario has them), streamed by the scenario's clock; the fix is the
true motion of the unit (POLL_TRUTH), its number of satellites and dilution of precision are those of an antenna (POLL_CHANNELS). Pressure is
the standard atmosphere's at the height above sea level; the magnetic field is a dipole along the Earth's (10 to 20 degrees off the true one).
Both ends on one host: MAVLink knows no encryption, and the service listens on loopback."""
from __future__ import annotations

import argparse
import math
import pathlib
import socket
import struct
import sys
from typing import Dict, Iterable, Optional, Tuple

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "proto/python"))
import orrery  # noqa: E402
from orrery import messages  # noqa: E402

Vector = Tuple[float, float, float]
NS = 10**9
UNIX_OF_GPS_S = 315964800

# Messages as MAVLink's common.xml defines them (protocol.mavlink.io): number, and fields in the order of the wire, largest types first.
TYPES = {"uint64_t": "Q", "int32_t": "i", "uint32_t": "I", "float": "f", "uint16_t": "H", "int16_t": "h", "uint8_t": "B"}
MESSAGES = {
    "HEARTBEAT": (0, "uint32_t custom_mode,uint8_t type,uint8_t autopilot,uint8_t base_mode,uint8_t system_status,uint8_t mavlink_version"),
    "HIL_SENSOR": (107, "uint64_t time_usec,float xacc,float yacc,float zacc,float xgyro,float ygyro,float zgyro,float xmag,float ymag,"
                        "float zmag,float abs_pressure,float diff_pressure,float pressure_alt,float temperature,uint32_t fields_updated"),
    "HIL_GPS": (113, "uint64_t time_usec,int32_t lat,int32_t lon,int32_t alt,uint16_t eph,uint16_t epv,uint16_t vel,int16_t vn,int16_t ve,"
                     "int16_t vd,uint16_t cog,uint8_t fix_type,uint8_t satellites_visible"),
}


def x25(data: Iterable[int], crc: int = 0xFFFF) -> int:
    """CRC-16/MCRF4XX, as MAVLink calls X.25's without the final complement."""
    for byte in data:
        byte ^= crc & 0xFF
        byte ^= byte << 4 & 0xFF
        crc = crc >> 8 ^ byte << 8 ^ byte << 3 ^ byte >> 4
    return crc


def fields_of(name: str) -> list[list[str]]:
    return [field.split(" ") for field in MESSAGES[name][1].split(",")]


def crc_extra(name: str) -> int:
    """The byte by which both ends know that they have the same definition of a message."""
    crc = x25(f"{name} ".encode())
    for kind, field in fields_of(name):
        crc = x25(f"{kind} {field} ".encode(), crc)
    return crc & 0xFF ^ crc >> 8


class Sender:
    """Makes frames of MAVLink 2, not signed."""

    def __init__(self, system: int = 1, component: int = 1) -> None:
        self._sequence, self._system, self._component = 0, system, component

    def frame(self, name: str, **values: float) -> bytes:
        fields = fields_of(name)
        payload = struct.pack("<" + "".join(TYPES[kind] for kind, _ in fields), *(values[field] for _, field in fields))
        payload = payload.rstrip(b"\0") or b"\0"  # zeros at the end are not sent
        head = struct.pack("<BBBBBB", len(payload), 0, 0, self._sequence, self._system, self._component)
        head += MESSAGES[name][0].to_bytes(3, "little")
        self._sequence = (self._sequence + 1) % 256
        return b"\xfd" + head + payload + struct.pack("<H", x25(bytes([crc_extra(name)]), x25(head + payload)))


def frd(v: Vector) -> Vector:
    """Right, forward, up as forward, right, down."""
    return v[1], v[0], -v[2]


def conjugate_turn(q: Tuple[float, float, float, float], v: Vector) -> Vector:
    """conj(q) v q: an ecef vector in body axes."""
    w, x, y, z = q[0], -q[1], -q[2], -q[3]
    t = (2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0]))
    return (v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2], v[2] + w * t[2] + x * t[1] - y * t[0])


def geodetic(p: Vector) -> Vector:
    """Latitude, longitude (rad) and height over WGS84, by Bowring's formula, which is good to a nanometre near the ground."""
    a, f = 6378137.0, 1 / 298.257223563
    b, e2 = a * (1 - f), f * (2 - f)
    d = math.hypot(p[0], p[1])
    beta = math.atan2(p[2] * a, d * b)
    lat = math.atan2(p[2] + e2 / (1 - e2) * b * math.sin(beta)**3, d - e2 * a * math.cos(beta)**3)
    n = a / math.sqrt(1 - e2 * math.sin(lat)**2)
    return lat, math.atan2(p[1], p[0]), d * math.cos(lat) + p[2] * math.sin(lat) - a * a / n


def enu(lat: float, lon: float, v: Vector) -> Vector:
    s, c = math.sin(lon), math.cos(lon)
    east, along = -s * v[0] + c * v[1], c * v[0] + s * v[1]
    return east, math.cos(lat) * v[2] - math.sin(lat) * along, math.cos(lat) * along + math.sin(lat) * v[2]


def dipole(p: Vector) -> Vector:
    """The magnetic field (gauss, ecef) of the first three coefficients of IGRF-14 for 2025."""
    g11, h11, g10 = -1410.3e-5, 4545.5e-5, -29350.0e-5
    r = math.sqrt(sum(x * x for x in p))
    u = [x / r for x in p]
    k = (6371200.0 / r)**3
    along = g11 * u[0] + h11 * u[1] + g10 * u[2]
    return tuple(k * (3 * along * x - m) for x, m in zip(u, (g11, h11, g10)))  # type: ignore[return-value]


def standard_atmosphere(h: float) -> Tuple[float, float]:
    """Pressure (hPa) and temperature (deg C) of ISO 2533 below 11 km."""
    t = 288.15 - 0.0065 * min(h, 11000.0)
    return 1013.25 * (t / 288.15)**5.255877, t - 273.15


def dilution(m: messages.Channels) -> Tuple[int, float, float]:
    """Satellites seen, horizontal and vertical dilution of precision; 99.99 where they are too few."""
    seen: Dict[str, Tuple[float, float]] = {str(c.sat): (c.az_rad, c.el_rad) for c in m.channels}
    n = [[0.0] * 8 for _ in range(4)]  # the normal matrix, and behind it the unit matrix
    for az, el in seen.values():
        row = (math.sin(az) * math.cos(el), math.cos(az) * math.cos(el), math.sin(el), 1.0)
        for i in range(4):
            for j in range(4):
                n[i][j] += row[i] * row[j]
    for i in range(4):
        n[i][4 + i] = 1.0
    for i in range(4):
        if n[i][i] < 1e-9:
            return len(seen), 99.99, 99.99
        n[i] = [x / n[i][i] for x in n[i]]
        for j in range(4):
            if j != i:
                n[j] = [x - n[j][i] * y for x, y in zip(n[j], n[i])]
    return len(seen), math.sqrt(n[0][4] + n[1][5]), math.sqrt(n[2][6])


class Bridge:
    """What the autopilot gets, made from the service's messages."""

    def __init__(self, undulation_m: float = 0.0) -> None:
        self._sender, self._undulation_m = Sender(), undulation_m
        self.seen, self.hdop, self.vdop = 0, 99.99, 99.99

    def unix_us(self, t: int, leap_s: int) -> int:
        return t // 1000 + (UNIX_OF_GPS_S - leap_s) * 10**6

    def sensor(self, imu: messages.Imu, truth: messages.Truth, time_usec: int) -> bytes:
        dt = (imu.t1 - imu.t) / NS
        acc, gyro = frd(tuple(x / dt for x in imu.dv_mps)), frd(tuple(x / dt for x in imu.dtheta_rad))
        mag = frd(conjugate_turn(tuple(truth.attitude), dipole(tuple(truth.pos_m))))
        height = geodetic(tuple(truth.pos_m))[2] - self._undulation_m
        pressure, temperature = standard_atmosphere(height)
        return self._sender.frame("HIL_SENSOR", time_usec=time_usec, xacc=acc[0], yacc=acc[1], zacc=acc[2], xgyro=gyro[0], ygyro=gyro[1],
                                  zgyro=gyro[2], xmag=mag[0], ymag=mag[1], zmag=mag[2], abs_pressure=pressure, diff_pressure=0.0,
                                  pressure_alt=height, temperature=temperature, fields_updated=0x1BFF)

    def gps(self, truth: messages.Truth, time_usec: int) -> bytes:
        lat, lon, height = geodetic(tuple(truth.pos_m))
        e, n, u = enu(lat, lon, tuple(truth.vel_mps))
        speed, fix = math.hypot(e, n), 3 if self.seen >= 4 else 0
        return self._sender.frame("HIL_GPS", time_usec=time_usec, lat=round(math.degrees(lat) * 1e7), lon=round(math.degrees(lon) * 1e7),
                                  alt=round((height - self._undulation_m) * 1e3), eph=round(100 * min(self.hdop, 655.0)),
                                  epv=round(100 * min(self.vdop, 655.0)), vel=min(round(100 * speed), 65535), vn=clip(100 * n), ve=clip(100 * e),
                                  vd=clip(-100 * u), cog=round(math.degrees(math.atan2(e, n)) * 100) % 36000, fix_type=fix,
                                  satellites_visible=min(self.seen, 254))

    def heartbeat(self) -> bytes:
        return self._sender.frame("HEARTBEAT", custom_mode=0, type=0, autopilot=8, base_mode=0, system_status=4, mavlink_version=3)

    def look(self, channels: messages.Channels) -> None:
        self.seen, self.hdop, self.vdop = dilution(channels)


def clip(cms: float) -> int:
    return max(-32768, min(32767, round(cms)))


def link(udp: Optional[str], port: Optional[int]) -> socket.socket:
    if udp is not None:
        host, _, number = udp.rpartition(":")
        sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        sock.connect((host, int(number)))
        return sock
    with socket.create_server(("127.0.0.1", port)) as server:
        print(f"waiting for an autopilot on 127.0.0.1:{server.getsockname()[1]}", file=sys.stderr, flush=True)
        return server.accept()[0]


def run(client: orrery.Client, sock: socket.socket, rate_hz: float, gps_hz: float, unit: int, antenna: int, undulation_m: float,
        seconds: float) -> None:
    """By the scenario's clock until it ends; a fix every so many readings."""
    bridge, step = Bridge(undulation_m), round(NS / rate_hz)
    every = max(1, round(rate_hz / gps_hz))
    leap_s = client.time().leap.gps_utc_s
    has_channels = any(r.request == messages.PollChannels.TYPE for r in client.caps.requests)
    count = round(seconds * rate_hz) if seconds > 0 else 0
    stream = client.subscribe(messages.PollImu(unit=unit), None, step / NS, count=count, lead_s=0.0, credit=1000)
    for k, imu in enumerate(stream):
        if imu.answer != messages.Answer.OK:
            continue
        truth = client.truth(imu.t1, unit)
        if truth.answer != messages.Answer.OK:
            continue
        stamp = bridge.unix_us(imu.t1, leap_s)
        if k % (every * max(1, round(gps_hz))) == 0:
            if has_channels:
                bridge.look(client.channels(imu.t1, antenna))
            sock.sendall(bridge.heartbeat())
        sock.sendall(bridge.sensor(imu, truth, stamp))
        if k % every == 0:
            sock.sendall(bridge.gps(truth, stamp))


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", maxsplit=1)[0])
    parser.add_argument("url", help="of the service, e.g. tcp://127.0.0.1:15754")
    to = parser.add_mutually_exclusive_group(required=True)
    to.add_argument("--udp", metavar="HOST:PORT", help="send datagrams there")
    to.add_argument("--tcp-listen", metavar="PORT", type=int, help="wait for the autopilot on this port of 127.0.0.1 (0: any free one)")
    parser.add_argument("--rate", type=float, default=250.0, help="readings a second, 1 to 1000; 250 by default")
    parser.add_argument("--gps-rate", type=float, default=10.0, help="fixes a second; 10 by default")
    parser.add_argument("--unit", type=int, default=0, help="inertial unit; 0 by default")
    parser.add_argument("--antenna", type=int, default=0, help="whose satellites are counted; 0 by default")
    parser.add_argument("--undulation", type=float, default=0.0, help="height of the geoid over the ellipsoid there, m; 0 by default")
    parser.add_argument("--seconds", type=float, default=0.0, help="how long; until the scenario ends by default")
    args = parser.parse_args()
    with orrery.Client(args.url, "mavlink") as client, link(args.udp, args.tcp_listen) as sock:
        try:
            run(client, sock, args.rate, args.gps_rate, args.unit, args.antenna, args.undulation, args.seconds)
        except (BrokenPipeError, ConnectionResetError):
            print("the autopilot has gone", file=sys.stderr)


if __name__ == "__main__":
    main()
