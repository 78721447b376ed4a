# SPDX-License-Identifier: MIT
"""The generated parts of docs/protocol.md: each stands between <!-- begin NAME --> and <!-- end NAME --> there."""
import re


def field_table(struct):
    out = ["| offset | field | type | unit | meaning |", "|---|---|---|---|---|"]
    at = 0
    for f in struct.fields:
        size = f.type.size
        doc = f.doc
        if f.when:
            doc += f"; there only with `{f.when}`"
        if f.since:
            doc += f"; since minor version {f.since}"
        out.append(f"| {'' if at is None else at} | `{f.name}` | `{f.type.text}` | {f.unit} | {doc} |")
        at = None if at is None or size is None or f.when else at + size
    return out if struct.fields else ["No fields."]


def messages(spec):
    out = ["| type | message | from | answered by |  |", "|---|---|---|---|---|"]
    for name, m in spec.messages.items():
        out.append(f"| {m.type_number} | [{name}](#{name.lower()}) | {m.sender} | {m.answer} | {m.doc} |")
    for name, m in spec.messages.items():
        out += ["", f"### {name}", "", f"Type {m.type_number}, from the {m.sender}" +
                (f", answered by {m.answer}. " if m.answer else ". ") + m.doc, ""]
        out += field_table(m)
    return out


def records(spec):
    out = []
    for name, s in spec.structs.items():
        size = f"{s.size} bytes" if s.size else f"at most {s.largest} bytes"
        out += [f"### `{name}`", "", f"{s.doc} ({size})", ""] + field_table(s) + [""]
    return out[:-1]


def values(spec):
    out = []
    for name, e in spec.enums.items():
        closing = any(v.get("closes") for v in e["values"].values())
        out += [f"### `{name}` ({e['is']})", "", e["doc"], ""]
        out += ["| value | name | meaning |" + (" connection |" if closing else ""), "|---|---|---|" + ("---|" if closing else "")]
        for n, v in e["values"].items():
            row = f"| {v['value']} | {n} | {v['doc']} |"
            if closing:
                row += " closes |" if v.get("closes") else " lives |"
            out.append(row)
        out.append("")
    for name, b in spec.bits.items():
        out += [f"### `{name}` ({b['is']}, bits)", "", b["doc"], "", "| bit | name | meaning |", "|---|---|---|"]
        out += [f"| {v['bit']} | {n} | {v['doc']} |" for n, v in b["values"].items()]
        out.append("")
    return out[:-1]


def limits(spec):
    out = ["| constant | value | meaning |", "|---|---|---|",
           f"| default port | {spec.port} | TCP port of a server that was told none |",
           f"| `MAX_PAYLOAD` | {spec.max_payload} | bytes of payload of any frame |"]
    out += [f"| `{n}` | {c['value']} | {c['doc']} |" for n, c in spec.constants.items()]
    out += ["", "| type by name | is | meaning |", "|---|---|---|"]
    out += [f"| `{n}` | `{a['is']}` | {a['doc']} |" for n, a in spec.aliases.items()]
    return out


def examples(spec):
    out = []
    for e in spec.examples:
        data = bytes.fromhex(e["hex"])
        out += [f"**{e['name']}**: {e['doc']}", "", "```"]
        for at in range(0, len(data), 16):
            out.append(f"{at:04x}  {data[at:at + 16].hex(' ')}")
        out += ["```", ""]
    return out[:-1]


PARTS = {"messages": messages, "records": records, "values": values, "limits": limits, "examples": examples}


def page(spec, text):
    """The page with its generated parts made anew; a part that the page lacks is an error."""
    for name, make in PARTS.items():
        pattern = re.compile(rf"(<!-- begin {name}[^\n]*-->\n).*?(<!-- end {name} -->)", re.S)
        if not pattern.search(text):
            raise SystemExit(f"docs/protocol.md has no part <!-- begin {name} -->")
        text = pattern.sub(lambda m, made="\n".join(make(spec)): f"{m.group(1)}{made}\n{m.group(2)}", text)
    return text


def golden_header(spec, source):
    """The example frames as C arrays, for the tests."""
    out = ["// SPDX-License-Identifier: MIT", f"// Generated from {source} by proto/spec/generate.py: change that, not this.",
           "// clang-format off", "#ifndef ORR_TESTS_GOLDEN_FRAMES_H", "#define ORR_TESTS_GOLDEN_FRAMES_H", "", "#include <stdint.h>", ""]
    for e in spec.examples:
        data = bytes.fromhex(e["hex"])
        out += [f"// {e['doc']}", f"static const uint8_t frame_{e['name']}[{len(data)}] = {{"]
        for at in range(0, len(data), 16):
            out.append("    " + ", ".join(f"0x{b:02x}" for b in data[at:at + 16]) + ",")
        out += ["};", ""]
    return "\n".join(out + ["#endif"]) + "\n"
