# SPDX-License-Identifier: GPL-3.0-or-later
"""RTCM 3 and UBX read back, by RTCM 10403.3 and u-blox's interface description. Knows nothing of the program's encoders."""
import pathlib
import struct

C_MS = 299792.458  # metres of a light-millisecond
CARRIERS = {"G1": 1575.42e6, "G2": 1227.6e6, "G5": 1176.45e6, "E1": 1575.42e6, "E5": 1176.45e6, "E7": 1207.14e6, "E6": 1278.75e6,
            "C2": 1561.098e6, "C6": 1268.52e6, "C1": 1575.42e6, "C5": 1176.45e6, "C7": 1207.14e6, "J1": 1575.42e6, "J2": 1227.6e6,
            "J5": 1176.45e6, "I5": 1176.45e6, "S1": 1575.42e6, "S5": 1176.45e6}
# Table 3.5-91 and its kin: signal masks from 1.
SIGNALS = {
    "G": {2: "1C", 3: "1P", 4: "1W", 8: "2C", 9: "2P", 10: "2W", 15: "2S", 16: "2L", 17: "2X", 22: "5I", 23: "5Q", 24: "5X", 30: "1S",
          31: "1L", 32: "1X"},
    "R": {2: "1C", 3: "1P", 8: "2C", 9: "2P"},
    "E": {2: "1C", 3: "1A", 4: "1B", 5: "1X", 6: "1Z", 8: "6C", 9: "6A", 10: "6B", 11: "6X", 12: "6Z", 14: "7I", 15: "7Q", 16: "7X",
          18: "8I", 19: "8Q", 20: "8X", 22: "5I", 23: "5Q", 24: "5X"},
    "S": {2: "1C", 22: "5I", 23: "5Q", 24: "5X"},
    "J": {2: "1C", 9: "6S", 10: "6L", 11: "6X", 15: "2S", 16: "2L", 17: "2X", 22: "5I", 23: "5Q", 24: "5X", 30: "1S", 31: "1L", 32: "1X"},
    "C": {2: "2I", 3: "2Q", 4: "2X", 8: "6I", 9: "6Q", 10: "6X", 14: "7I", 15: "7Q", 16: "7X", 22: "5D", 23: "5P", 24: "5X", 25: "7D",
          30: "1D", 31: "1P", 32: "1X"},
    "I": {22: "5A"},
}
SYSTEM = {107: "G", 108: "R", 109: "E", 110: "S", 111: "J", 112: "C", 113: "I"}


def carrier(system, code, channel=None):
    if system == "R":
        return 1602e6 + 562500 * channel if code[0] == "1" else 1246e6 + 437500 * channel
    return CARRIERS[system + code[0]]


def crc24q(data):
    crc = 0
    for byte in data:
        crc ^= byte << 16
        for _ in range(8):
            crc <<= 1
            if crc & 0x1000000:
                crc ^= 0x1864CFB
    return crc


class Bits:
    def __init__(self, data):
        self.value, self.left = int.from_bytes(data, "big"), 8 * len(data)

    def u(self, n):
        self.left -= n
        assert self.left >= 0, "the message is too short"
        return self.value >> self.left & ((1 << n) - 1)

    def s(self, n):
        v = self.u(n)
        return v - (1 << n) if v >> (n - 1) else v


def frames(data):
    """(number, content) of all messages; nothing may stand between them."""
    at = 0
    while at < len(data):
        assert data[at] == 0xD3 and data[at + 1] & 0xFC == 0, f"no preamble at byte {at}"
        n = (data[at + 1] & 3) << 8 | data[at + 2]
        assert crc24q(data[at:at + 3 + n]) == int.from_bytes(data[at + 3 + n:at + 6 + n], "big"), "CRC"
        content = data[at + 3:at + 3 + n]
        yield Bits(content).u(12), content
        at += 6 + n


def least_lock_ms(indicator, msm):
    """The least lock time of an indicator: tables 3.5-74 and 3.5-75."""
    if msm == 4:
        return 0 if indicator == 0 else 1 << (indicator + 4)
    if indicator < 64:
        return indicator
    step = (indicator - 32) // 32
    return (indicator - 32 * step) << step


def msm(content):
    """A multiple signal message: head, and cells by (satellite, code)."""
    b = Bits(content)
    number = b.u(12)
    system, kind = SYSTEM[number // 10], number % 10
    head = {"number": number, "system": system, "station": b.u(12)}
    if system == "R":
        head["day"], head["ms"] = b.u(3), b.u(27)
    else:
        head["ms"] = b.u(30)
    head["more"] = b.u(1)
    head["rest"] = (b.u(3), b.u(7), b.u(2), b.u(2), b.u(1), b.u(3))
    sats = [k + 1 for k in range(64) if b.u(1)]
    codes = [SIGNALS[system][k + 1] for k in range(32) if b.u(1)]
    assert len(sats) * len(codes) <= 64
    cells = [(sat, code) for sat in sats for code in codes if b.u(1)]
    whole = [b.u(8) for _ in sats]
    extended = [b.u(4) if kind == 7 else None for _ in sats]
    rough = {sat: w + b.u(10) / 1024 if w != 255 else None for sat, w in zip(sats, whole)}
    rate = {sat: b.s(14) if kind == 7 else None for sat in sats}
    code_bits, code_power, phase_bits, phase_power = (20, 29, 24, 31) if kind == 7 else (15, 24, 22, 29)
    fine = [b.s(code_bits) for _ in cells]
    phase = [b.s(phase_bits) for _ in cells]
    lock = [b.u(10 if kind == 7 else 4) for _ in cells]
    half = [b.u(1) for _ in cells]
    cn0 = [b.u(10) / 16 if kind == 7 else b.u(6) for _ in cells]
    fine_rate = [b.s(15) if kind == 7 else None for _ in cells]
    assert b.left < 8 and b.u(b.left) == 0, "more than the message has"
    out = {}
    for k, (sat, code) in enumerate(cells):
        channel = extended[sats.index(sat)]
        name = f"{system}{sat + 19 if system == 'S' else sat:02d}"
        cell = {"lock_ms": least_lock_ms(lock[k], kind), "half": half[k], "cn0": cn0[k], "channel": channel - 7 if system == "R" and kind == 7 else None}
        cell["code_m"] = None if fine[k] == -1 << (code_bits - 1) or rough[sat] is None else C_MS * (rough[sat] + fine[k] / 2**code_power)
        cell["phase_m"] = None if phase[k] == -1 << (phase_bits - 1) or rough[sat] is None else C_MS * (rough[sat] + phase[k] / 2**phase_power)
        cell["rate_mps"] = rate[sat] + 1e-4 * fine_rate[k] if kind == 7 and rate[sat] != -8192 and fine_rate[k] != -16384 else None
        out[name, code] = cell
    return head, out


def station(content):
    """1005 and 1006, 1033, 1230."""
    b = Bits(content)
    number, out = b.u(12), {"station": b.u(12)}
    if number in (1005, 1006):
        out["itrf"], out["systems"], out["virtual"] = b.u(6), (b.u(1), b.u(1), b.u(1)), b.u(1)
        x, out["one_oscillator"], _, y, out["quarter"], z = b.s(38), b.u(1), b.u(1), b.s(38), b.u(2), b.s(38)
        out["place_m"] = (1e-4 * x, 1e-4 * y, 1e-4 * z)
        out["height_m"] = 1e-4 * b.u(16) if number == 1006 else None
    elif number == 1033:
        text = lambda: bytes(b.u(8) for _ in range(b.u(8))).decode("ascii")  # noqa: E731
        out["antenna"], out["setup"] = text(), b.u(8)
        out["serial"], out["receiver"], out["version"], out["receiver_serial"] = text(), text(), text(), text()
    else:
        out["aligned"], _, mask = b.u(1), b.u(3), b.u(4)
        out["biases_m"] = {name: 0.02 * b.s(16) for k, name in enumerate(("1C", "1P", "2C", "2P")) if mask >> (3 - k) & 1}
    return out


# --- UBX ---

UBX_SYSTEM = {0: "G", 1: "S", 2: "E", 3: "C", 5: "J", 6: "R", 7: "I"}
UBX_SIGNAL = {("G", 0): "1C", ("G", 3): "2L", ("G", 4): "2S", ("G", 6): "5I", ("G", 7): "5Q", ("S", 0): "1C", ("E", 0): "1C", ("E", 1): "1B",
              ("E", 3): "5I", ("E", 4): "5Q", ("E", 5): "7I", ("E", 6): "7Q", ("C", 0): "2I", ("C", 1): "2I", ("C", 4): "6I", ("C", 10): "6I",
              ("C", 5): "1P", ("C", 6): "1D", ("C", 7): "5P", ("C", 8): "5D", ("J", 0): "1C", ("J", 4): "2S", ("J", 5): "2L", ("J", 8): "5I",
              ("J", 9): "5Q", ("R", 0): "1C", ("R", 2): "2C", ("I", 0): "5A"}


def ubx(data):
    """(class, number, payload) of all messages; nothing may stand between them."""
    at = 0
    while at < len(data):
        assert data[at:at + 2] == b"\xb5b", f"no message at byte {at}"
        kind, number, n = struct.unpack_from("<BBH", data, at + 2)
        a = b = 0
        for byte in data[at + 2:at + 6 + n]:
            a = (a + byte) & 255
            b = (b + a) & 255
        assert bytes((a, b)) == data[at + 6 + n:at + 8 + n], "checksum"
        yield kind, number, data[at + 6:at + 6 + n]
        at += 8 + n


def ubx_satellite(system, number):
    system = UBX_SYSTEM[system]
    return f"{system}{number - 100 if system == 'S' else number:02d}"


def rawx(payload):
    """RXM-RAWX: head, and measurements by (satellite, code)."""
    tow, week, leap, n, state, version = struct.unpack_from("<dHbBBB", payload)
    assert len(payload) == 16 + 32 * n
    out = {}
    for k in range(n):
        code, phase, doppler, system, sat, signal, channel, lock, cn0, *sigma, flags = struct.unpack_from("<ddfBBBBHBBBBB", payload, 16 + 32 * k)
        name = ubx_satellite(system, sat)
        out[name, UBX_SIGNAL[name[0], signal]] = {"code_m": code, "phase": phase, "doppler": doppler, "channel": channel - 7 if name[0] == "R" else None,
                                                  "lock_ms": lock, "cn0": cn0, "sigma": sigma, "flags": flags}
    return {"tow": tow, "week": week, "leap": leap, "state": state, "version": version}, out


# --- RINEX 3 observations, ours and RTKLIB's ---


def rinex_obs(path):
    """Types by system, and by epoch (seconds of the day) satellite's values by type with the digit of lost lock."""
    lines = pathlib.Path(path).read_text(encoding="ascii").splitlines()
    types, epochs, row, system = {}, {}, 0, ""
    while "END OF HEADER" not in lines[row]:
        if "SYS / # / OBS TYPES" in lines[row]:
            system = lines[row][0] if lines[row][0] != " " else system
            types.setdefault(system, []).extend(lines[row][7:60].split())
        row += 1
    epoch = None
    for line in lines[row + 1:]:
        if line[0] == ">":
            h, m, s = line[13:29].split()
            epoch = epochs.setdefault(round(3600 * int(h) + 60 * int(m) + float(s), 6), {})
            continue
        values = epoch.setdefault(line[:3], {})
        for k, name in enumerate(types[line[0]]):
            field = line[3 + 16 * k:19 + 16 * k]
            if field[:14].strip():
                values[name] = (float(field[:14]), int(field[14:15].strip() or 0))
    return types, epochs
