# SPDX-License-Identifier: MIT
"""The Wireshark dissector: one Lua file, no module needed. It is the message set as Lua tables, and dissector.lua behind them."""
import pathlib

RUNTIME = pathlib.Path(__file__).with_name("dissector.lua")


def is_satellite(struct):
    """A letter and a number, which are shown as one word."""
    return getattr(struct, "show", "") == "sat" or [(f.type.scalar, f.show) for f in struct.fields] == [("u8", "char"), ("u8", "")]


class Lua:
    def __init__(self, spec, source):
        self.spec, self.source = spec, source

    def field(self, field):
        t = field.type
        words = [f'name = "{field.name}"', f'kind = "{t.kind}"']
        if t.scalar:
            words.append(f'scalar = "{t.scalar}"')
        if t.struct:
            words.append(f'record = "{t.struct.name}"')
        if t.length:
            words.append(f"length = {t.length}")
        if t.limit:
            words.append(f"limit = {t.limit}")
        if t.named in self.spec.enums:
            words.append(f'enum = "{t.named}"')
        if t.named in self.spec.bits:
            words.append(f'bits = "{t.named}"')
        show = field.show or ("duration" if t.scalar == "i64" and field.unit == "ns" else "")
        if show:
            words.append(f'show = "{show}"')
        if field.unit:
            words.append(f'unit = "{field.unit}"')
        if field.when:
            words.append(f'when = {{"{field.when_field}", {field.when_mask.bit_length() - 1}}}')
        if field.since:
            words.append(f"since = {field.since}")
        return f"    {{{', '.join(words)}}},"

    def record(self, struct):
        head = []
        if struct.fixed:
            head.append(f"size = {struct.size}, smallest = {min([*struct.older_sizes, struct.size])}")
        if is_satellite(struct):
            head.append("satellite = true")
        if getattr(struct, "spread", False):
            head.append("spread = true")
        return [f"records.{struct.name} = {{{''.join(h + ', ' for h in head)}fields = {{"] + \
            [self.field(f) for f in struct.fields] + ["}}"]

    def message(self, name, m):
        answer = f', answer = "{m.answer}"' if m.answer in self.spec.messages else ""
        return f'  [{m.type_number}] = {{name = "{name}", record = "{m.name}", from = "{m.sender}"{answer}}},'

    def module(self):
        s = self.spec
        out = ["-- SPDX-License-Identifier: MIT",
               f"-- Generated from {self.source} and proto/spec/dissector.lua by proto/spec/generate.py: change those, not this.",
               f"-- Wireshark dissector of {s.name}, protocol {s.major}.{s.minor}, TCP port {s.port}.",
               f'local PROTOCOL, MAGIC, MAJOR, PORT, MAX_PAYLOAD = "{s.name}", "{s.magic.decode()}", {s.major}, {s.port}, {s.max_payload}',
               f'local orrery = Proto("orrery", "{s.name} satellite states")', "", "local enums, bitsets, records = {}, {}, {}"]
        for name, e in s.enums.items():
            out += [f"enums.{name} = {{"] + [f'  [{v["value"]}] = "{n}",' for n, v in e["values"].items()] + ["}"]
        for name, b in s.bits.items():
            out += [f"bitsets.{name} = {{"] + [f'  {{name = "{n}", bit = {v["bit"]}}},' for n, v in b["values"].items()] + ["}"]
        for struct in [*s.structs.values(), *s.messages.values()]:
            out += self.record(struct)
        out += ["local messages = {"] + [self.message(n, m) for n, m in s.messages.items()] + ["}"]
        out += ["local message_names = {}", "for number, message in pairs(messages) do message_names[number] = message.name end", ""]
        return "\n".join(out) + "\n" + RUNTIME.read_text(encoding="utf-8").split("\n", 1)[1]  # without its licence line
