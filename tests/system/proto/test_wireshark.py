#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The Wireshark dissector in tshark, on captures that are written by this test: every kind of message, frames that share a segment or are
cut across segments, requests and their answers, and damaged frames of every sort, none of which may raise a Lua error."""
import pathlib
import random
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

import yaml

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "proto/python"))
from orrery import codec, frame, messages  # noqa: E402

SCRIPT = ROOT / "proto/gen/orrery.lua"
SPEC = yaml.safe_load((ROOT / "proto/spec/messages.yaml").read_text(encoding="utf-8"))
EXAMPLES = {e["name"]: bytes.fromhex(e["hex"]) for e in SPEC["examples"]}
NAMES = {m["type"]: name for name, m in SPEC["messages"].items()}
PORT = SPEC["protocol"]["port"]
CLIENT, SERVER = 0, 1
MALFORMED = "(Error/Malformed)"


class Capture:
    """A pcap file of raw IP packets; every TCP connection has a client's port of its own."""

    def __init__(self, folder, port=PORT):
        self.path, self.port = pathlib.Path(folder) / "frames.pcap", port
        self.out = open(self.path, "wb")
        self.out.write(struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 65535, 101))
        self.sent, self.packets = {}, 0

    def add(self, side, data, connection=0, at_us=0, flags=0x18, snap=None):
        """A segment; snap: so many bytes of its data are captured, of all that were sent."""
        self.packets += 1
        client = 20000 + connection
        sent = self.sent.setdefault(connection, [1, 1])
        ports = (client, self.port) if side == CLIENT else (self.port, client)
        tcp = struct.pack(">HHIIBBHHH", *ports, sent[side], sent[1 - side], 5 << 4, flags, 65535, 0, 0)
        sent[side] += len(data)
        size = 40 + len(data)
        ip = struct.pack(">BBHHHBBH4s4s", 0x45, 0, size, self.packets % 65536, 0, 64, 6, 0, b"\x7f\0\0\1", b"\x7f\0\0\1")
        packet = ip + tcp + data
        kept = packet if snap is None else packet[:40 + snap]
        self.out.write(struct.pack("<IIII", 1, at_us, len(kept), len(packet)) + kept)

    def tshark(self, *args):
        """What tshark prints; a Lua error is a failure whatever the test looks for."""
        self.out.close()
        done = subprocess.run([TSHARK, "-X", f"lua_script:{SCRIPT}", "-n", "-r", str(self.path), *args], capture_output=True,
                              text=True, errors="replace", timeout=120, check=False)  # labels are cut at 240 bytes, within a character too
        if done.returncode != 0 or re.search(r"Lua[ :]|\.lua:\d", done.stdout + done.stderr):
            raise AssertionError(f"tshark ended with {done.returncode}:\n{done.stdout[-4000:]}\n{done.stderr[-4000:]}")
        return done.stdout

    def details(self):
        """The protocol's part of each packet, by packet number."""
        parts = re.split(r"^Frame \d+:.*\n", self.tshark("-V", "-O", "orrery"), flags=re.M)[1:]
        return [part[part.find("Orrery "):] if "Orrery " in part else "" for part in parts]

    def info(self):
        return self.tshark("-o", 'gui.column.format:"Info","%i"').splitlines()

    def fields(self, *names):
        """Rows of fields, after both passes."""
        words = [word for name in names for word in ("-e", name)]
        return [line.split("\t") for line in self.tshark("-2", "-T", "fields", *words).splitlines()]


def reframe(data, payload=None, **header):
    """A frame with another payload or other header fields, and a checksum that is right."""
    magic, major, minor, kind, sequence, size = frame.HEADER.unpack(data[:16])
    payload = data[16:-4] if payload is None else payload
    body = frame.HEADER.pack(magic, header.get("major", major), header.get("minor", minor), header.get("type", kind),
                             header.get("sequence", sequence), header.get("size", len(payload))) + payload
    return body + struct.pack("<I", zlib.crc32(body))


def sample(record, rng):
    """A message or record with something in every field."""
    made = record()
    for field in record.LAYOUT:
        if field.kind == "struct":
            value = sample(field.record, rng)
        elif field.kind == "string":
            value = "text"
        elif field.kind == "bytes":
            value = b"\1\2\3"
        elif field.kind == "array":
            value = [rng.randrange(100) for _ in range(field.length)]
        elif field.kind == "list":
            value = [sample(field.record, rng) if field.record else rng.randrange(100) for _ in range(min(3, field.limit))]
        elif field.name == "system":
            value = ord(rng.choice("GREC"))
        elif field.scalar in ("i64", "u64"):
            value = rng.randrange(10**18, 2 * 10**18)
        else:
            value = 1
        setattr(made, field.name, value)
    return made


def every_kind(seed=1):
    """A valid frame of each message kind, by name."""
    rng = random.Random(seed)
    return {NAMES[number]: frame.make(number, 7, sample(cls, rng).encode()) for number, cls in sorted(messages.MESSAGES.items())}


class Dissector(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.capture = Capture(folder.name)

    def shown(self, *frames, side=SERVER):
        """Details of frames, each in a connection of its own."""
        for k, data in enumerate(frames):
            self.capture.add(side, data, connection=k)
        return self.capture.details()

    def assert_in_order(self, text, wanted):
        at = 0
        for words in wanted:
            found = text.find(words, at)
            self.assertGreaterEqual(found, 0, f"'{words}' is missing or out of order in:\n{text}")
            at = found

    def test_examples(self):
        text = "".join(self.shown(*EXAMPLES.values()))
        self.assert_in_order(text, [
            "Orrery PING, sequence 1", "token: 0x0123456789abcdef", "Orrery HELLO, sequence 1", "name: gen", "Orrery POLL, sequence 2",
            "t: 2024-02-04T00:15:00 GPS (1391040900000000000 ns)", "step: 0.1 s (100000000 ns)", "satellites: 2", "satellites 1: G05",
            "satellites 2: E11", "Orrery STATES, sequence 2", "satellites 1: G05", "flags: 0x00000001 (CLOCK_VALID)",
            ".0.. = MANOEUVRE: False", "pos_m: -20100000.5", "satellites 2: E11, NO_ARC", "answer: NO_ARC (2)",
            "valid_to: no instant (-9223372036854775808 ns)", "Orrery ERROR, sequence 3", "code: UNKNOWN_TYPE (5)",
            "sentence: unknown message type 999", "Orrery POLL_ELEMENTS", "satellites 1: R07", "Orrery ELEMENTS, sequence 4",
            "method: MEAN (2)", "flags: 0x00000011 (CLOCK_VALID, ECLIPSE)", "answer: NO_VALUE (5)", "Orrery NAVDATA, sequence 5",
            "satellites 1: R07", "message: FDMA (10)", "notes: 0x00000020 (NOMINAL_CHANNEL)", "channel: 5", "bits: 85",
            "08bbb8c857800ed33ec0a8", "satellites 2: E11, NOT_SERVED"])
        self.assertNotIn("(Error/", text)

    def test_every_kind_of_message(self):
        kinds = every_kind()
        for name, text in zip(kinds, self.shown(*kinds.values())):
            self.assertIn(f"Orrery {name}, sequence 7", text)
            self.assertIn("CRC-32: 0x", text)
            for line in re.findall(r"Expert Info.*", text):
                self.assertRegex(line, r"\((Note/Sequence|Warning/Response|Note/Undecoded)\)", f"{name}: {line}")
            self.assertNotIn("after the last known field", text)
            for field in messages.MESSAGES[frame.HEADER.unpack(kinds[name][:16])[3]].LAYOUT:
                if field.kind in ("scalar", "array", "string", "list"):
                    self.assertRegex(text, rf"\b{field.name}\b", name)

    def test_frames_that_share_and_cross_segments(self):
        frames = [*EXAMPLES.values(), *every_kind().values()]
        alone = [re.sub(r"Expert Info.*|\[.*\n", "", t) for t in self.shown(*frames)]
        stream, rng = b"".join(frames), random.Random(3)
        together = Capture(self.folder)
        for connection, sizes in enumerate(((1, 1), (2, 40), (100, 1400), (8000, 30000))):
            at = 0
            while at < len(stream):
                n = rng.randint(*sizes)
                together.add(SERVER, stream[at:at + n], connection)
                at += n
        text = re.sub(r"Expert Info.*|\[.*\n", "", "".join(together.details()))
        self.assertEqual(text.count("Orrery "), 4 * len(frames))
        for one in set(alone):
            self.assertEqual(text.count(one.strip()), 4 * sum(a == one for a in alone), one)

    def test_damaged_headers(self):
        ping = EXAMPLES["ping"]
        damaged = bytearray(ping)
        damaged[18] ^= 1
        cases = (
            (bytes(damaged), "(Error/Checksum): checksum does not match"),
            (reframe(ping, size=0xFFFFFFFF), f"{MALFORMED}: a payload of 4294967295 bytes, at most 4194304 are allowed"),
            (reframe(ping, size=4194305), f"{MALFORMED}: a payload of 4194305 bytes"),
            (reframe(ping, major=2), "(Error/Protocol): major version 2: this dissector knows 1"),
            (reframe(ping, type=999), "(Warning/Undecoded): unknown message type"),
            (b"GET / HTTP/1.1\r\n\r\n", f"{MALFORMED}: bytes that are no frame of this protocol"),
            (b"\0\0\0" + ping, f"{MALFORMED}: bytes that are no frame of this protocol"),
        )
        shown = self.shown(*(data for data, _ in cases))
        for (data, wanted), text in zip(cases, shown):
            self.assertIn(wanted, text, data)
        self.assertIn("Major version: 2", shown[3])
        self.assertNotIn("token", shown[3])  # nothing is read by a layout that it may not have
        self.assertIn("Orrery PING, sequence 1", shown[6])  # found again behind what is no frame
        self.assertNotIn(MALFORMED, "".join(self.shown_again(reframe(ping, minor=9))))

    def shown_again(self, *frames):
        self.capture = Capture(self.folder)
        return self.shown(*frames)

    def test_after_an_impossible_length_the_next_frame_is_found(self):
        self.capture.add(CLIENT, reframe(EXAMPLES["ping"], size=0xFFFFFFFF) + EXAMPLES["hello"])
        self.assert_in_order(self.capture.details()[0], ["4294967295 bytes, at most", "no frame", "Orrery HELLO, sequence 1"])

    def test_damaged_payloads(self):
        states, poll, error = EXAMPLES["states"], EXAMPLES["poll"], EXAMPLES["error"]
        list_at = poll[16:-4].index(b"\2\0\2\0G\5")
        states_at = states[16:-4].index(b"\2\0\x78\0")

        def with_bytes(data, at, new):
            payload = bytearray(data[16:-4])
            payload[at:at + len(new)] = new
            return reframe(data, bytes(payload))
        cases = (
            (reframe(EXAMPLES["ping"], b"\1\2\3"), f"{MALFORMED}: token is cut: 8 bytes wanted, 3 there"),
            (reframe(poll, b""), "is cut: 8 bytes wanted, 0 there"),
            (with_bytes(poll, list_at, b"\xff\xff"), f"{MALFORMED}: satellites: 65535 of them, at most 800 are allowed"),
            (with_bytes(poll, list_at, b"\3\0"), f"{MALFORMED}: satellites: 3 of 2 bytes, but 4 bytes are left"),
            (with_bytes(poll, list_at + 2, b"\1\0"), f"{MALFORMED}: satellites: records of 1 bytes, 2 are wanted"),
            (with_bytes(poll, list_at + 2, b"\0\0"), f"{MALFORMED}: satellites: records of 0 bytes, 2 are wanted"),
            (with_bytes(states, states_at + 2, b"\x70\0"), f"{MALFORMED}: satellites: records of 112 bytes, 120 are wanted"),
            (reframe(error, error[16:20] + b"\1\2" + bytes(513)), f"{MALFORMED}: sentence: 513 bytes, at most 512 are allowed"),
            (reframe(error, error[16:20] + b"\5\0abc"), f"{MALFORMED}: sentence is cut: 5 bytes wanted, 3 there"),
            (reframe(poll, poll[16:-4] + b"\0" * 5), "(Note/Undecoded): 5 bytes after the last known field of poll"),
            (with_bytes(poll, list_at + 4, b"\7"), "(Warning/Protocol): satellites 1: a letter and a number of 1 to 99 are wanted"),
            (with_bytes(poll, list_at + 5, b"\0"), "(Warning/Protocol): satellites 1: a letter and a number of 1 to 99 are wanted"),
            (with_bytes(states, states_at + 4 + 2, b"\x63"), "(Note/Undecoded): answer 99 is not known"),
            (with_bytes(states, states_at + 4 + 7, b"\x80"), "(Note/Undecoded): bit 31 is not known"),
        )
        for (data, wanted), text in zip(cases, self.shown(*(data for data, _ in cases))):
            self.assertIn(wanted, text, data)
            self.assertNotIn("(Error/Checksum)", text)

    def test_longer_records_of_a_later_version(self):
        states = EXAMPLES["states"]
        at = states.index(b"\2\0\x78\0")
        longer = states[16:at] + b"\2\0\x7c\0" + states[at + 4:at + 124] + b"new!" + states[at + 124:at + 244] + b"new!"
        text = self.shown(reframe(states, longer, minor=1))[0]
        self.assertEqual(text.count("(Note/Undecoded): 4 bytes after the last known field of sat_state"), 2)
        self.assertIn("satellites 2: E11, NO_ARC", text)
        self.assertNotIn(MALFORMED, text)

    def test_every_cut_is_marked(self):
        # A payload that ends anywhere before its end, in a frame that is otherwise sound: the fields of minor version 0 are all
        # needed, so each must be marked.
        kinds = {k: v for k, v in every_kind().items() if len(v) > 20}
        cases = []
        for name, data in kinds.items():
            size = len(data) - 20
            for n in sorted({*range(0, min(size, 40)), *range(40, size, 37), size - 1}):
                cases.append((name, n, reframe(data, data[16:16 + n])))
        for (name, n, _), text in zip(cases, self.shown(*(c[2] for c in cases))):
            self.assertIn(MALFORMED, text, f"{name} cut to {n} bytes")
            self.assertIn(f"Orrery {name}", text)

    def test_captures_that_lack_bytes(self):
        poll = EXAMPLES["poll"]
        self.capture.add(CLIENT, poll, 0, snap=30)  # the capture keeps the beginning of each packet alone
        self.capture.add(CLIENT, poll, 1, snap=7)
        self.capture.add(CLIENT, poll[:20], 2)      # and this one ends with its connection
        self.capture.add(CLIENT, b"", 2, flags=0x11)
        shown = self.capture.details()
        self.assertIn(f"{MALFORMED}: the frame is cut: 48 bytes wanted, 30 there", shown[0])
        self.assertIn("t: 2024-02-04T00:15:00 GPS", shown[0])
        self.assertIn(MALFORMED, shown[1])

    def test_times(self):
        field = 16 + EXAMPLES["poll"][16:].index(struct.pack("<q", 1391040900 * 10**9))
        cases = ((0, "1980-01-06T00:00:00 GPS"), (-1, "1980-01-05T23:59:59.999999999 GPS"), (1, "1980-01-06T00:00:00.000000001 GPS"),
                 (1261872000 * 10**9, "2020-01-01T00:00:00 GPS"), (1266969599 * 10**9 + 5 * 10**8, "2020-02-28T23:59:59.5 GPS"),
                 (1266969600 * 10**9, "2020-02-29T00:00:00 GPS"), (2**63 - 1, "2272-04-15T23:47:16.854775807 GPS"),
                 (-2**63 + 1, "1687-09-26T00:12:43.145224193 GPS"), (-2**63, "no instant"))
        steps = ((1, "0.000000001 s"), (-1, "-0.000000001 s"), (-15 * 10**8, "-1.5 s"), (3600 * 10**9, "3600 s"), (0, "0 s"))
        frames = []
        for t, step in [(t, 1) for t, _ in cases] + [(0, s) for s, _ in steps]:
            data = bytearray(EXAMPLES["poll"])
            data[field:field + 16] = struct.pack("<qq", t, step)
            frames.append(reframe(bytes(data)))
        shown = self.shown(*frames)
        for (t, wanted), text in zip(cases, shown):
            self.assertIn(f"t: {wanted} ({t} ns)", text)
        for (step, wanted), text in zip(steps, shown[len(cases):]):
            self.assertIn(f"step: {wanted} ({step} ns)", text)

    def test_info(self):
        damaged = bytearray(EXAMPLES["ping"])
        damaged[18] ^= 1
        self.capture.add(CLIENT, EXAMPLES["hello"] + EXAMPLES["poll"])
        self.capture.add(SERVER, EXAMPLES["states"])
        self.capture.add(SERVER, EXAMPLES["error"])
        self.capture.add(CLIENT, bytes(damaged))
        self.capture.add(CLIENT, reframe(EXAMPLES["ping"], type=999))
        self.capture.add(CLIENT, reframe(EXAMPLES["ping"], major=2))
        self.capture.add(CLIENT, reframe(EXAMPLES["poll"], b"\0"))
        self.assertEqual(self.capture.info(), [
            "HELLO seq=1 | POLL seq=2, 2024-02-04T00:15:00 GPS, 2 epochs, step 0.1 s, 2 satellites",
            "STATES seq=2, 2024-02-04T00:15:00 GPS, 1 of 2, 2 satellites", "ERROR seq=3, UNKNOWN_TYPE: unknown message type 999",
            "PING seq=1, [checksum]", "type 999 seq=1, [unknown message type]", "PING seq=1, [major version 2]",
            "POLL seq=2, [malformed]"])

    def test_requests_and_answers_are_linked(self):
        poll, states, error = EXAMPLES["poll"], EXAMPLES["states"], EXAMPLES["error"]
        capture = self.capture
        capture.add(CLIENT, reframe(poll, sequence=5) + reframe(poll, sequence=6), at_us=1000)       # 1
        capture.add(SERVER, reframe(states, sequence=5), at_us=1250)                                 # 2
        capture.add(SERVER, reframe(states, sequence=5), at_us=2000)                                 # 3
        capture.add(SERVER, reframe(error, sequence=6), at_us=3000)                                  # 4
        capture.add(CLIENT, reframe(poll, sequence=5), connection=1, at_us=4000)                     # 5: another conversation
        capture.add(CLIENT, reframe(poll, sequence=5), at_us=5000)                                   # 6: the number comes again
        capture.add(SERVER, reframe(states, sequence=5), at_us=5500)                                 # 7
        capture.add(SERVER, reframe(states, sequence=9), at_us=6000)                                 # 8: never asked for
        capture.add(SERVER, reframe(error, sequence=0), at_us=7000)                                  # 9: answers no request
        capture.add(CLIENT, reframe(EXAMPLES["ping"], sequence=8), at_us=8000)                       # 10
        capture.add(SERVER, reframe(states, sequence=8), at_us=8001)                                 # 11: no answer to that
        rows = capture.fields("orrery.response_in", "orrery.last_response_in", "orrery.responses", "orrery.request_in",
                              "orrery.response_time", "_ws.expert.message")
        self.assertEqual([row[:4] for row in rows], [
            ["2,4", "3", "2", ""], ["", "", "", "1"], ["", "", "", "1"], ["", "", "", "1"], ["", "", "", ""], ["7", "", "", ""],
            ["", "", "", "6"], ["", "", "", ""], ["", "", "", ""], ["11", "", "", ""], ["", "", "", "10"]])
        self.assertEqual([float(row[4] or "nan") for row in rows if row[4]], [0.00025, 0.001, 0.002, 0.0005, 0.000001])
        marks = {k + 1: row[5] for k, row in enumerate(rows) if row[5]}
        self.assertEqual(marks[5], "its answer is not in this capture")
        self.assertEqual(marks[8], "its request is not in this capture")
        self.assertIn("a request that PONG answers has this sequence number", marks[11])
        self.assertEqual(sorted(marks), [4, 5, 8, 9, 11])  # 4 and 9 are refusals

    def test_display_filters(self):
        self.capture.add(CLIENT, EXAMPLES["hello"])
        self.capture.add(SERVER, EXAMPLES["states"])
        self.capture.add(SERVER, EXAMPLES["elements"])
        self.capture.add(SERVER, EXAMPLES["error"])
        self.capture.out.flush()
        for display, wanted in (('orrery.sat == "G05"', ["2"]), ('orrery.sat == "E11"', ["2", "3"]), ("orrery.sequence == 4", ["3"]),
                                ("orrery.sat_elements.flags.eclipse == 1", ["3"]), ("orrery.expert.refused", ["4"]),
                                ('orrery.time == "2024-02-04T00:15:00"', ["2", "3"]), ("orrery && _ws.expert", ["1", "2", "3", "4"])):
            found = self.capture.tshark("-2", "-Y", display, "-T", "fields", "-e", "frame.number").split()
            self.assertEqual(found, wanted, display)

    def test_any_port(self):
        capture = Capture(self.folder, port=40123)
        capture.add(CLIENT, EXAMPLES["poll"][:20])
        capture.add(CLIENT, EXAMPLES["poll"][20:])
        capture.add(SERVER, EXAMPLES["states"])
        self.assertEqual([line[:12] for line in capture.info()][1:], ["POLL seq=2, ", "STATES seq=2"])

    def test_damage_of_all_sorts_raises_no_error(self):
        rng, frames = random.Random(11), [*EXAMPLES.values(), *every_kind().values()]
        made = 0
        for k in range(1200):
            data = bytearray(rng.choice(frames))
            for _ in range(rng.randrange(1, 6)):
                at = rng.randrange(len(data))
                data[at] = rng.choice((0, 1, 0x7F, 0x80, 0xFF, rng.randrange(256)))
            if k % 3 == 1:
                data = data[:rng.randrange(1, len(data) + 1)]
            if k % 2 == 0 and len(data) > 20:  # with a header that is right: the payload alone is damaged
                data = bytearray(reframe(bytes(rng.choice(frames)[:16] + data[16:])))
            cut = rng.randrange(len(data) + 1)
            for part in (data[:cut], data[cut:]):
                if part:
                    self.capture.add(rng.choice((CLIENT, SERVER)) if k % 5 == 0 else SERVER, bytes(part), connection=k)
                    made += 1
        shown = self.capture.details()
        self.assertEqual(len(shown), made)
        text = "".join(shown)
        for words in (MALFORMED, "(Error/Checksum)", "(Error/Protocol)", "(Warning/Undecoded)", "(Note/Undecoded)"):
            self.assertIn(words, text)
        self.assertNotIn("Malformed Packet", text)  # Wireshark's own words for a dissector that reads past the end
        again = Capture(self.folder)
        for k in range(60):  # in the way that a listener attaches anywhere in a stream
            stream = b"".join(rng.sample(frames, 3))
            again.add(SERVER, stream[rng.randrange(len(stream)):], connection=k)
        self.assertEqual(len(again.details()), 60)


if __name__ == "__main__":
    TSHARK = shutil.which("tshark")
    if TSHARK is None:
        sys.exit("tshark is not installed: cmake/setup check installs it")
    unittest.main(argv=["test_wireshark"])
