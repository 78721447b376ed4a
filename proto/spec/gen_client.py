# SPDX-License-Identifier: MIT
"""The C client's verbs, one pair for each request, and the whole client as one header and one source for firmware."""
import re

from gen_c import HEAD

PARTS_OF_HEADER = ["proto/wire.h", "proto/frame.h", "proto/crc32.h", "proto/gen/messages.h", "proto/client.h", "proto/gen/verbs.h"]
PARTS_OF_SOURCE = ["proto/wire.c", "proto/gen/crc32_table.h", "proto/crc32.c", "proto/frame.c", "proto/gen/messages.c", "proto/client.c",
                   "proto/gen/verbs.c", "proto/client_open.c"]
EXTERN = ["#ifdef __cplusplus", 'extern "C" {', "#endif", ""]
EXTERN_END = ["#ifdef __cplusplus", "}", "#endif"]


class Verbs:
    """What a client says and hears: for a request that is answered once one function that asks and waits; for a request of
    epochs one that asks, and one for each answer; for a request without an answer one that tells."""

    def __init__(self, spec, source):
        self.spec, self.source, self.p, self.up = spec, source, spec.prefix, spec.prefix.upper()

    def prototype(self, m):
        p, words = self.p, f"orr_client *c, const {self.p}_{m.name} *request"
        if m.answer == "none" or m.epochs:
            return f"orr_wire_status orr_client_{m.name}({words})"
        return f"orr_wire_status orr_client_{m.name}({words}, {p}_{m.answer.lower()} *answer)"

    def listen(self, m):
        name = m.answer.lower()
        return f"orr_wire_status orr_client_{name}(orr_client *c, {self.p}_{name} *answer)"

    def requests(self):
        return [m for m in self.spec.messages.values() if m.sender == "client"]

    def answers(self):
        """Requests of epochs, one for each kind of answer."""
        return {m.answer: m for m in self.requests() if m.epochs}.values()

    def header(self):
        out = [line.format(source=self.source) for line in HEAD]
        out += ["// What a client asks and hears. Included by proto/client.h.", "#ifndef ORR_PROTO_GEN_VERBS_H",
                "#define ORR_PROTO_GEN_VERBS_H", ""] + EXTERN
        for m in self.requests():
            out.append(f"// {m.doc}")
            if m.epochs:
                out.append(f"// Then call orr_client_{m.answer.lower()} request->epochs.count times.")
            out += [self.prototype(m) + ";"]
        out.append("")
        for m in self.answers():
            out += [f"// {self.spec.messages[m.answer].doc} ORR_WIRE_UNEXPECTED where an epoch is missing.", self.listen(m) + ";"]
        return "\n".join(out + [""] + EXTERN_END + ["", "#endif"]) + "\n"

    def code(self):
        p, up = self.p, self.up
        out = [line.format(source=self.source) for line in HEAD] + ['#include "proto/client.h"', ""]
        for m in self.requests():
            out += [self.prototype(m), "{", "    orr_wire_writer w;", "    size_t start;"]
            if m.answer == "none":  # another request's answer may be waited for
                out.append("    uint32_t awaited = c->awaited;")
            out += [f"    orr_client_begin(c, {up}_TYPE_{m.name.upper()}, &w, &start);", f"    {p}_{m.name}_encode(request, &w);"]
            if m.answer == "none":
                out.append("    c->awaited = awaited;")
            if m.epochs:
                out.append(f"    orr_client_expect(c, request->{m.epochs.name}.count);")
            if m.epochs or m.answer == "none":
                out += ["    return orr_client_send(c, &w, start);", "}", ""]
                continue
            out += ["    orr_frame f;", "    orr_wire_status s = orr_client_send(c, &w, start);",
                    f"    if (s == ORR_WIRE_OK) s = orr_client_answer(c, {up}_TYPE_{m.answer}, &f);",
                    f"    return s == ORR_WIRE_OK ? {p}_{m.answer.lower()}_decode(f.payload, f.size, answer) : s;", "}", ""]
        for m in self.answers():
            name = m.answer.lower()
            epoch = next(f.name for f in self.spec.messages[m.answer].fields if f.type.text == "epoch")
            out += [self.listen(m), "{", "    orr_frame f;", f"    orr_wire_status s = orr_client_answer(c, {up}_TYPE_{m.answer}, &f);",
                    f"    if (s == ORR_WIRE_OK) s = {p}_{name}_decode(f.payload, f.size, answer);",
                    f"    return s == ORR_WIRE_OK ? orr_client_epoch(c, answer->{epoch}.index, answer->{epoch}.count) : s;", "}", ""]
        return "\n".join(out).rstrip("\n") + "\n"


def body(text):
    """A file without its first comment lines of licence and generator, its guard and its includes of this project."""
    guard = re.search(r"#ifndef (ORR_\w+_H)\n#define \1\n", text)
    if guard:
        text = text.replace(guard.group(0), "", 1)
        text = text[:text.rindex("#endif")]
    lines = [x for x in text.split("\n") if not x.startswith(("// SPDX", "// Generated from", "// clang-format", '#include "proto/'))]
    text = "\n".join(lines).replace("\n".join(EXTERN), "").replace("\n".join(EXTERN_END), "")
    return re.sub(r"\n{3,}", "\n\n", text).strip("\n")


def hoist(parts):
    """The includes of libc once, in front; what a condition guards stays where it is."""
    seen, out = [], []
    for text in parts:
        depth, kept = 0, []
        for line in text.split("\n"):
            depth += line.startswith("#if") - line.startswith("#endif")
            if depth == 0 and line.startswith("#include <"):
                seen += [line] if line not in seen else []
            else:
                kept.append(line)
        out.append("\n".join(kept).strip("\n"))
    return sorted(seen), out


def firmware(read):
    """The client as (header, source): everything that firmware needs. read: the text of a file of the project."""
    head = ["// SPDX-License-Identifier: MIT", "// Made of {files} by proto/spec/generate.py: change those, not this.", "// clang-format off"]
    includes, parts = hoist([body(read(name)) for name in PARTS_OF_HEADER])
    out = [line.format(files="proto/*.h") for line in head]
    out += ["// The client of Orrery's protocol, whole: this header and orrery_client.c. C99 or C++, libc's string.h alone.",
            "#ifndef ORRERY_CLIENT_H", "#define ORRERY_CLIENT_H", ""] + includes + [""] + EXTERN
    header = "\n".join(out) + "\n" + "\n\n".join(parts) + "\n\n" + "\n".join(EXTERN_END) + "\n\n#endif\n"
    includes, parts = hoist([body(read(name)) for name in PARTS_OF_SOURCE])
    out = [line.format(files="proto/*.c") for line in head] + ['#include "orrery_client.h"', ""] + includes
    return header, "\n".join(out) + "\n\n" + "\n\n".join(parts) + "\n"
