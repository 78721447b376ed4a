# SPDX-License-Identifier: MIT
"""Field descriptors: every message and record as a constant table, for code that does the same with all of them."""
import math
import re

from gen_c import CTYPE, HEAD

# What a unit is multiplied by to be another, for text.
FACTORS = {("rad", "deg"): 180 / math.pi, ("s", "us"): 1e6, ("s", "ns"): 1e9, ("m", "mm"): 1e3, ("Hz", "MHz"): 1e-6}
DIGITS = {"m": 4, "m/s": 5, "m/s2": 6, "deg": 5, "TECU": 3, "mGal": 3}
SUFFIX = {"m": "_m", "m/s": "_mps", "m/s2": "_mps2", "rad": "_rad", "s": "_s", "rad/s": "_radps", "Hz": "_hz", "TECU": "_tecu",
          "mGal": "_mgal", "s/s": "_sps"}


def quoted(text):
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def flag(value):
    return "true" if value else "false"


class Fields:
    def __init__(self, spec, source):
        self.spec, self.source, self.p, self.up = spec, source, spec.prefix, spec.prefix.upper()

    def words(self):
        out = []
        for kind, table in (("enum", self.spec.enums), ("bits", self.spec.bits)):
            for name, e in table.items():
                out.append(f"static const orr_field_word words_{name}[] = {{")
                for key, v in e["values"].items():
                    value = v["value"] if kind == "enum" else f"UINT64_C({1 << v['bit']})"
                    words = v.get("words", key.lower().replace("_", " "))
                    out.append(f"    {{{value}, {quoted(key)}, {quoted(words)}, {flag(v.get('counted'))}}},")
                out += ["};", ""]
        return out

    def show(self, f):
        named = f.type.named
        if named == "answer":
            return "ORR_SHOW_ANSWER"
        if named in self.spec.enums:
            return "ORR_SHOW_ENUM"
        if named in self.spec.bits:
            return "ORR_SHOW_BITS"
        return {"char": "ORR_SHOW_CHAR", "hex": "ORR_SHOW_HEX", "time": "ORR_SHOW_TIME", "message": "ORR_SHOW_MESSAGE",
                "place": "ORR_SHOW_PLACE", "polynomial": "ORR_SHOW_POLYNOMIAL"}.get(
            f.show, "ORR_SHOW_NUMBER")

    def row(self, struct, f):
        t = f.type
        kind = {"struct": "STRUCT", "list": "LIST", "string": "STRING", "bytes": "BYTES"}.get(t.kind) or t.scalar.upper()
        cells = [f".name = {quoted(f.name)}", f".unit = {quoted(f.unit)}", f".doc = {quoted(f.doc)}", f".kind = ORR_FIELD_{kind}"]
        if t.kind == "list" and t.scalar:
            cells.append(f".element = ORR_FIELD_{t.scalar.upper()}")
        cells.append(f".show = {self.show(f)}")
        if t.kind == "array":
            suffix = SUFFIX.get(f.unit, "")
            suffix = suffix if f.name.endswith(suffix) else ""
            stem = f.head if f.head is not None and len(f.head) < 2 else f.name[:len(f.name) - len(suffix)] + "_"
            cells += [f".length = {t.length}", f".stem = {quoted(stem)}", f".suffix = {quoted(suffix)}"]
        cells.append(f".offset = offsetof({self.p}_{struct.name}, {f.name})")
        if t.limit:
            cells.append(f".limit = {t.limit}")
        if t.named in self.spec.enums or t.named in self.spec.bits:
            cells += [f".word = words_{t.named}", f".n_words = sizeof words_{t.named} / sizeof words_{t.named}[0]"]
        if t.struct:
            cells.append(f".record = &record_{t.struct.name}")
        if t.kind == "list":
            cells.append(f".next = next_{t.struct.name if t.struct else t.scalar}")
        if f.per:
            cells.append(f".per = {quoted(f.per)}")
        return "    {" + ", ".join(cells + self.text(f) + self.table(f)) + "},"

    def text(self, f):
        hidden = f.text == "none" or f.name == "reserved"
        name, factor = f.name, 1.0
        if f.type.kind == "bytes" and f.text:
            name = f.text
        elif f.text not in ("", "none"):
            factor = FACTORS[f.unit, f.text]
            name = re.sub(f"{SUFFIX[f.unit]}$", f"_{f.text}", name)
        return [f".in_text = {flag(not hidden)}", f".text_name = {quoted(name)}", f".text_factor = {factor!r}"]

    def table(self, f):
        unit = f.text if f.text not in ("", "none", "hex") else f.unit
        words = f.table.split()
        hidden = words == ["none"] or f.text == "none" or f.name == "reserved"
        digits = None
        if words and words[-1].isdigit():
            digits = int(words.pop())
        if words and not hidden:
            unit = words.pop()
        factor = 1.0 if unit == f.unit else FACTORS[f.unit, unit]
        if digits is None:
            digits = DIGITS.get(unit, -1)
        head = f.head
        if head is None:
            suffix = SUFFIX.get(f.unit, "")
            head = (f.name[:-len(suffix)] if suffix and f.name.endswith(suffix) else f.name).replace("_", " ")
        return [f".in_table = {flag(not hidden)}", f".head = {quoted(head)}", f".table_unit = {quoted(unit)}",
                f".table_factor = {factor!r}", f".digits = {digits}"]

    def record(self, struct):
        name = f"{self.p}_{struct.name}"
        out = [f"static const orr_field fields_{struct.name}[] = {{"] + [self.row(struct, f) for f in struct.fields] + ["};"]
        out.append(f"static const orr_record record_{struct.name} = {{{quoted(struct.name)}, fields_{struct.name}, {len(struct.fields)}, "
                   f"sizeof({name}), {flag(struct.spread)}, {flag(struct.show == 'sat')}}};")
        return out + [""]

    def lists(self, struct, done):
        out = []
        for f in struct.fields:
            word = f.type.kind == "list" and (f.type.struct.name if f.type.struct else f.type.scalar)
            if not word or word in done:
                continue
            done.add(word)
            item = f"{self.p}_{word}" if f.type.struct else CTYPE[word]
            out += [f"static bool next_{word}(const void *list, orr_wire_iter *it, void *out)", "{",
                    f"    return {self.p}_{word}_next((const {self.p}_{word}_list *)list, it, ({item} *)out);", "}", ""]
        return out

    def code(self):
        p, up, spec = self.p, self.up, self.spec
        out = [line.format(source=self.source) for line in HEAD] + ['#include "proto/fields.h"', ""] + self.words()
        done = set()
        for struct in spec.structs.values():
            out += self.lists(struct, done) + self.record(struct)
        for m in spec.messages.values():
            out += self.lists(m, done) + self.record(m)
            name = f"{p}_{m.name}"
            out += [f"static orr_wire_status encode_{m.name}(const void *m, orr_wire_writer *w)", "{",
                    f"    return {name}_encode((const {name} *)m, w);", "}",
                    f"static orr_wire_status decode_{m.name}(const uint8_t *payload, size_t size, void *m)", "{",
                    f"    return {name}_decode(payload, size, ({name} *)m);", "}", ""]
        out += ["static const orr_message_info messages[] = {"]
        for n, m in spec.messages.items():
            answer = f"{up}_TYPE_{m.answer}" if m.answer not in ("", "none") else "0"
            out.append(f"    {{{quoted(n)}, {up}_TYPE_{n}, {answer}, {flag(m.sender == 'client')}, &record_{m.name}, "
                       f"encode_{m.name}, decode_{m.name}}},")
        out += ["};", "", "const orr_message_info *orr_message_of(uint16_t type)", "{",
                "    for (size_t i = 0; i < sizeof messages / sizeof messages[0]; i++)",
                "        if (messages[i].type == type) return &messages[i];", "    return NULL;", "}"]
        return "\n".join(out) + "\n"
