#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python codec (frames that are written down, malformed bytes, growth by minor versions) and what the specification's
checker refuses. Argument: the folder with the toy message set."""
import importlib.util
import math
import pathlib
import random
import struct
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
TOY = pathlib.Path(sys.argv.pop(1))
sys.path[:0] = [str(ROOT / "proto/python"), str(ROOT / "proto/spec")]
import yaml  # noqa: E402
import gen_client  # noqa: E402
import gen_handlers  # noqa: E402
from model import Spec, SpecError  # noqa: E402
from orrery import codec, frame, messages  # noqa: E402


def load_toy():
    """toy.py is written as a member of the package: it is loaded as one."""
    spec = importlib.util.spec_from_file_location("orrery.toy", TOY / "toy.py")
    module = importlib.util.module_from_spec(spec)
    sys.modules["orrery.toy"] = module
    spec.loader.exec_module(module)
    return module


toy = load_toy()


def sample():
    point = toy.Point(x=-7, y=0.5)
    return toy.Everything(
        v_u8=255, v_i8=-128, v_u16=65535, v_i16=-32768, v_u32=2**32 - 1, v_i32=-2**31, v_u64=2**64 - 1, v_i64=-2**63, v_f32=1.5,
        v_f64=5e-324, when_ns=-1, matrix=[1, 2, 3, 4], corner=point, parts=toy.Parts.NOTE | toy.Parts.RUN, note="nöte",
        run=[1, 2, 65535], grown=[toy.Grown(1, 2, [3.0, 4.0])],
        loose=[toy.Loose(7, "ab", b"\0\1", [1.5], [point], 9), toy.Loose(99, late=8)], memo=toy.Memo(6, "memo"), tail=123,
        tail_text="end")


class Codec(unittest.TestCase):
    def test_golden_states(self):
        examples = {e["name"]: e for e in yaml.safe_load((ROOT / "proto/spec/messages.yaml").read_text())["examples"]}
        data = bytes.fromhex(examples["states"]["hex"])
        at = [0]

        def receive(n):
            at[0] += n
            return data[at[0] - n:at[0]]
        f = frame.read(receive)
        m = f.message()
        self.assertEqual((f.type, f.sequence, m.t, m.index, m.count), (7, 2, 1391040900 * 10**9, 0, 2))
        g05, e11 = m.satellites
        self.assertEqual((chr(g05.sat.system), g05.sat.number, g05.answer, g05.flags), ("G", 5, 0, 1))
        self.assertEqual(g05.pos_m, [15600000.25, -20100000.5, 7250000.125])
        self.assertEqual((g05.clock_s, g05.clock_rate_sps, g05.sigma_m, g05.clock_sigma_s),
                         (-0.0001220703125, 2.0**-37, 0.0078125, 2.0**-33))
        self.assertEqual(e11.answer, messages.Answer.NO_ARC)
        self.assertTrue(math.isnan(e11.pos_m[0]) and math.isnan(e11.clock_s))
        self.assertEqual(frame.make(7, 2, m.encode()), data)

    def test_every_field_survives(self):
        m = sample()
        raw = m.encode()
        d = toy.Everything.decode(raw)
        self.assertEqual(d.encode(), raw)
        self.assertEqual((d.v_i8, d.v_i64, d.note, d.run, d.tail, d.tail_text), (-128, -2**63, "nöte", [1, 2, 65535], 123, "end"))
        self.assertEqual((d.place.x, d.loose[0].raw, d.loose[0].points[0].y, d.loose[1].late), (0, b"\0\1", 0.5, 8))

    def test_prefixes(self):
        raw = sample().encode()
        for n in range(len(raw)):
            if n in (len(raw) - 5, len(raw) - 9):  # what minor versions 1 and 0 would have sent
                d = toy.Everything.decode(raw[:n])
                self.assertEqual(d.tail_text, "")
            else:
                with self.assertRaises(codec.CodecError):
                    toy.Everything.decode(raw[:n])

    def test_damage(self):
        raw = sample().encode()
        rng = random.Random(7)
        for _ in range(3000):
            bad = bytearray(raw)
            for _ in range(3):
                bad[rng.randrange(len(bad))] = rng.randrange(256)
            try:
                toy.Everything.decode(bytes(bad))
            except codec.CodecError:
                pass

    def test_older_and_newer_records(self):
        raw = struct.pack("<HHHHH", 2, 4, 1, 2, 3)
        field = next(f for f in toy.Everything.LAYOUT if f.name == "grown")
        with self.assertRaises(codec.CodecError):  # four bytes cut a field in two
            toy.Everything._get_list(codec._Reader(raw + b"\0\0"), field)
        old = toy.Everything._get_list(codec._Reader(struct.pack("<HHHH", 2, 2, 1, 2)), field)
        self.assertEqual([(g.a, g.b, g.c) for g in old], [(1, 0, [0.0, 0.0]), (2, 0, [0.0, 0.0])])
        new = toy.Everything._get_list(codec._Reader(struct.pack("<HHHIddI", 1, 26, 1, 2, 3, 4, 5)), field)
        self.assertEqual((new[0].b, new[0].c), (2, [3.0, 4.0]))

    def test_values_that_do_not_fit(self):
        for change in ({"v_u8": 256}, {"matrix": [1, 2]}, {"note": "x" * 21}, {"run": [1] * 5}, {"v_u8": "a"}):
            m = sample()
            for name, value in change.items():
                setattr(m, name, value)
            with self.assertRaises(codec.CodecError):
                m.encode()

    def test_broken_frames(self):
        good = frame.make(messages.Ping.TYPE, 1, messages.Ping(5).encode())
        for byte in range(len(good)):
            bad = bytearray(good)
            bad[byte] ^= 1
            stream = bytes(bad) + bytes(300)
            at = [0]

            def receive(n):
                if at[0] + n > len(stream):
                    raise EOFError
                at[0] += n
                return stream[at[0] - n:at[0]]
            with self.assertRaises((frame.FrameError, EOFError)):
                frame.read(receive)


class Specification(unittest.TestCase):
    BASE = {
        "protocol": {"name": "T", "magic": "TTTT", "major": 1, "minor": 1, "port": 1, "max_payload": 1000, "c_prefix": "t"},
        "structs": {"s": {"doc": "d", "fields": [{"name": "a", "type": "u8", "doc": "d"}]}},
        "messages": {"M": {"type": 1, "from": "server", "doc": "d", "fields": [{"name": "a", "type": "u8", "doc": "d"}]}},
    }

    def refused(self, words, fields=None, **message):
        raw = yaml.safe_load(yaml.safe_dump(self.BASE))
        raw["messages"]["M"].update(message)
        if fields is not None:
            raw["messages"]["M"]["fields"] = [{"doc": "d", **f} for f in fields]
        with tempfile.NamedTemporaryFile("w", suffix=".yaml") as file:
            yaml.safe_dump(raw, file)
            file.flush()
            with self.assertRaisesRegex(SpecError, words):
                Spec(file.name)

    def test_refusals(self):
        self.refused("no type called", [{"name": "a", "type": "u9"}])
        self.refused("twice", [{"name": "a", "type": "u8"}, {"name": "a", "type": "u8"}])
        self.refused("keyword", [{"name": "from", "type": "u8"}])
        self.refused("unknown key", [{"name": "a", "type": "u8", "units": "m"}])
        self.refused("1 to 65535", [{"name": "a", "type": "string<70000>"}])
        self.refused("stand last", [{"name": "a", "type": "u8", "since": 1}, {"name": "b", "type": "u8"}])
        self.refused("minor version is", [{"name": "a", "type": "u8", "since": 2}])
        self.refused("earlier bit set", [{"name": "a", "type": "u8", "when": "b.C"}])
        self.refused("above max_payload", [{"name": "a", "type": "bytes<2000>"}])
        self.refused("number of its own", type=0)
        self.refused("names its answer", **{"from": "client"})
        self.refused("unknown key", answers="M")

    def test_a_message_without_an_answer(self):
        """What only goes one way (motion, credit) needs no special case: a verb that sends, and no handler that answers."""
        raw = yaml.safe_load(yaml.safe_dump(self.BASE))
        raw["messages"]["N"] = {"type": 2, "from": "client", "answer": "none", "doc": "d", "fields": [{"name": "a", "type": "u8", "doc": "d"}]}
        with tempfile.NamedTemporaryFile("w", suffix=".yaml") as file:
            yaml.safe_dump(raw, file)
            file.flush()
            spec = Spec(file.name)
        self.assertIn("orr_client_n(orr_client *c, const t_n *request);", gen_client.Verbs(spec, "s").header())
        self.assertNotIn("begin_n", gen_handlers.Handlers(spec, "s").header())


if __name__ == "__main__":
    unittest.main()
