# SPDX-License-Identifier: MIT
"""The C codec: messages.h and messages.c (C99, libc alone, no allocation), and the tables of the checksum."""
from model import SCALARS

CTYPE = {"u8": "uint8_t", "u16": "uint16_t", "u32": "uint32_t", "u64": "uint64_t", "i8": "int8_t", "i16": "int16_t",
         "i32": "int32_t", "i64": "int64_t", "f32": "float", "f64": "double"}
HEAD = ["// SPDX-License-Identifier: MIT", "// Generated from {source} by proto/spec/generate.py: change that, not this.",
        "// clang-format off"]


def crc_tables(count=16):
    """table[k][b]: remainder of byte b followed by k zero bytes, polynomial 0xEDB88320 (reflected)."""
    first = []
    for byte in range(256):
        value = byte
        for _ in range(8):
            value = (value >> 1) ^ (0xEDB88320 if value & 1 else 0)
        first.append(value)
    tables = [first]
    for _ in range(count - 1):
        tables.append([first[v & 0xFF] ^ (v >> 8) for v in tables[-1]])
    return tables


def fold_constant(power):
    """x^power mod the polynomial, as a carry-less multiplication of reflected words wants it: reflected, shifted by one."""
    value = 1
    for _ in range(power):
        value = (value << 1) ^ (0x104C11DB7 if value & 0x80000000 else 0)
    return int(f"{value & 0xFFFFFFFF:032b}"[::-1], 2) << 1


def crc_header():
    out = [line.format(source="the polynomial 0xEDB88320") for line in HEAD]
    out += ["#ifndef ORR_PROTO_GEN_CRC32_TABLE_H", "#define ORR_PROTO_GEN_CRC32_TABLE_H", "", "#include <stdint.h>", "",
            "#ifdef ORR_CRC32_SMALL", "#define ORR_CRC32_TABLES 1", "#else", "#define ORR_CRC32_TABLES 16", "#endif", "",
            "static const uint32_t orr_crc32_table[ORR_CRC32_TABLES][256] = {"]
    for k, table in enumerate(crc_tables()):
        if k == 1:
            out.append("#if ORR_CRC32_TABLES > 1")
        out.append("    {")
        for at in range(0, 256, 8):
            out.append("        " + ", ".join(f"0x{v:08x}" for v in table[at:at + 8]) + ",")
        out.append("    },")
    out += ["#endif", "};", "", "// x^n mod the polynomial, reflected and shifted by one, for folding by carry-less multiplication."]
    out += [f"#define ORR_CRC32_FOLD_{n} UINT64_C(0x{fold_constant(n):09x})" for n in (2080, 2016, 544, 480, 160, 96)]
    out += ["", "#endif"]
    return "\n".join(out) + "\n"


class CWriter:
    def __init__(self, spec, source, header_name):
        self.spec, self.source, self.header_name = spec, source, header_name
        self.p, self.up = spec.prefix, spec.prefix.upper()

    def record_name(self, record):
        return f"{self.p}_{record[1].name}" if record[0] == "struct" else CTYPE[record[1]]

    def list_name(self, type_):
        return f"{self.p}_{type_.struct.name if type_.struct else type_.scalar}_list"

    # ---- header -----------------------------------------------------------------------------------------------------
    def member(self, field):
        t = field.type
        if t.kind == "scalar":
            text = f"{CTYPE[t.scalar]} {field.name};"
        elif t.kind == "array":
            text = f"{CTYPE[t.scalar]} {field.name}[{t.length}];"
        elif t.kind == "struct":
            text = f"{self.p}_{t.struct.name} {field.name};"
        elif t.kind == "list":
            text = f"{self.list_name(t)} {field.name};"
        else:
            text = f"orr_wire_bytes {field.name};"
        note = field.doc
        if field.unit and field.unit not in field.name:
            note = f"[{field.unit}] {note}"
        if field.when:
            note += f" (with {field.when})"
        return f"    {text} // {note}"

    def struct(self, s):
        out = [f"// {s.doc}", f"typedef struct {self.p}_{s.name} {{"]
        out += [self.member(f) for f in s.fields] or ["    uint8_t nothing; // no fields: C wants a member"]
        out += [f"}} {self.p}_{s.name};"]
        if s.fixed:
            out.append(f"#define {self.up}_{s.name.upper()}_SIZE {s.size}u")
        out += [f"#define {self.up}_{s.name.upper()}_LARGEST {s.largest}u", ""]
        return out

    def list_type(self, record):
        name = self.record_name(record)
        base = f"{self.p}_{record[1].name if record[0] == 'struct' else record[1]}"
        fixed = record[0] == "scalar" or record[1].fixed
        out = [f"// To encode: count items at `item`. Decoded: `item` is NULL, the records are in `wire` (borrowed); read",
               f"// either kind with {base}_next" + (f" or {base}_at." if fixed else "."),
               f"typedef struct {base}_list {{", "    uint16_t count;", f"    const {name} *item;",
               "    orr_wire_records wire;", f"}} {base}_list;",
               f"bool {base}_next(const {base}_list *list, orr_wire_iter *it, {name} *out); // false at the end"]
        if record[0] == "struct":
            stride = f", wire.stride {self.up}_{record[1].name.upper()}_SIZE" if fixed else ""
            out += ["// Records alone. A message whose last member is such a list can be encoded in pieces: first with the `count`",
                    f"// of all, no item and no bytes (wire.size 0, wire.data not NULL{stride}), then these.",
                    f"orr_wire_status {base}_records_encode(const {base}_list *piece, orr_wire_writer *w);"]
        if fixed:
            out.append(f"bool {base}_at(const {base}_list *list, uint16_t index, {name} *out);   // false beyond the end")
        return out + [""]

    def header(self):
        s, up, p = self.spec, self.up, self.p
        guard = f"{up}_GENERATED_H"
        out = [line.format(source=self.source) for line in HEAD]
        out += [f"// Messages of {s.name}, protocol {s.major}.{s.minor}.", f"#ifndef {guard}", f"#define {guard}", "",
                "#include <stdbool.h>", "", '#include "proto/wire.h"', "", "#ifdef __cplusplus", 'extern "C" {', "#endif", ""]
        for k, byte in enumerate(s.magic):
            out.append(f"#define {up}_MAGIC_{k} 0x{byte:02x}u")
        out += [f"#define {up}_MAJOR {s.major}u", f"#define {up}_MINOR {s.minor}u", f"#define {up}_PORT {s.port}u",
                f"#define {up}_MAX_PAYLOAD {s.max_payload}u"]
        for name, c in s.constants.items():
            out.append(f"#define {up}_{name} {c['value']}u // {c['doc']}")
        out += ["", "enum { // message types"]
        out += [f"    {up}_TYPE_{n} = {m.type_number}," for n, m in s.messages.items()]
        out += ["};", ""]
        for name, e in s.enums.items():
            out += [f"enum {{ // {name} ({e['is']}): {e['doc']}"]
            out += [f"    {up}_{name.upper()}_{n} = {v['value']}, // {v['doc']}" for n, v in e["values"].items()]
            out += ["};", ""]
        for name, b in s.bits.items():
            out += [f"// {name} ({b['is']}): {b['doc']}"]
            out += [f"#define {up}_{name.upper()}_{n} (({CTYPE[b['is']]})(UINT64_C(1) << {v['bit']})) // {v['doc']}"
                    for n, v in b["values"].items()]
            out.append("")
        out += ["// (I8) Names as in the specification; NULL for a value that it does not know.",
                f"const char *{p}_type_name(uint16_t type);"]
        out += [f"const char *{p}_{n}_name({CTYPE[e['is']]} value);" for n, e in s.enums.items()]
        out += [f"const char *{p}_{n}_name(unsigned bit);" for n in s.bits]
        for n in self.closing():
            out += ["// Whether the connection closes after it.", f"bool {p}_{n}_closes({CTYPE[s.enums[n]['is']]} value);"]
        out += ["", "// Bytes of the largest payload of all messages.", f"#define {up}_LARGEST {max(m.largest for m in s.messages.values())}u"]
        out.append("")
        done = set()
        for struct in s.structs.values():
            out += self.lists_before(struct, done)
            out += self.struct(struct)
            record = ("struct", struct)
            if record in s.list_records:
                out += self.list_type(record)
                done.add(record)
        out += ["// Encoding appends the payload to the writer and returns its status. Decoding reads a payload; strings, blobs",
                "// and lists borrow its bytes; bytes after the last known field are of a later minor version and are ignored.", ""]
        for message in s.messages.values():
            out += self.lists_before(message, done)
            out += self.struct(message)
            name = f"{p}_{message.name}"
            out += [f"orr_wire_status {name}_encode(const {name} *m, orr_wire_writer *w);",
                    f"orr_wire_status {name}_decode(const uint8_t *payload, size_t size, {name} *m);", ""]
        names = " ".join(f"X({m.name})" for m in s.messages.values())
        out += ["// All messages, for code that does the same with each.", f"#define {up}_EACH(X) {names}", "",
                "// Room for any of them.", f"typedef union {p}_any {{"] + [f"    {p}_{m.name} {m.name};" for m in s.messages.values()] + [f"}} {p}_any;", "", "#ifdef __cplusplus", "}", "#endif", "", "#endif"]
        return "\n".join(out) + "\n"

    def lists_before(self, struct, done):
        """Lists of scalars have no struct to stand behind: they are declared where they are first needed."""
        out = []
        for f in struct.fields:
            record = ("scalar", f.type.scalar)
            if f.type.kind == "list" and f.type.scalar and record not in done:
                out += self.list_type(record)
                done.add(record)
        return out

    def closing(self):
        """Enums some values of which close a connection."""
        return [n for n, e in self.spec.enums.items() if any(v.get("closes") for v in e["values"].values())]

    # ---- code -------------------------------------------------------------------------------------------------------
    def move(self, field, at, store):
        """Lines that store or load a field of fixed size at p + at."""
        t, name, verb = field.type, field.name, "store" if store else "load"
        if t.kind == "scalar":
            if store:
                return [f"    orr_wire_store_{t.scalar}(p + {at}, m->{name});"]
            return [f"    m->{name} = orr_wire_load_{t.scalar}(p + {at});"]
        if t.kind == "struct":
            return [f"    {verb}_{t.struct.name}(p + {at}, &m->{name});"]
        step = SCALARS[t.scalar]
        lines = []
        for k in range(t.length):
            if store:
                lines.append(f"    orr_wire_store_{t.scalar}(p + {at + k * step}, m->{name}[{k}]);")
            else:
                lines.append(f"    m->{name}[{k}] = orr_wire_load_{t.scalar}(p + {at + k * step});")
        return lines

    def fixed_struct(self, s):
        name = f"{self.p}_{s.name}"
        out = []
        for store in (True, False):
            const_p, const_m = ("", "const ") if store else ("const ", "")
            out += [f"static inline void {'store' if store else 'load'}_{s.name}({const_p}uint8_t *p, {const_m}{name} *m)",
                    "{"]
            at = 0
            for f in s.fields:
                out += self.move(f, at, store)
                at += f.type.size
            out += ["}", ""]
        return out

    def runs(self, s):
        """Fields grouped: a list of plain fields shares one check of the bounds; others stand alone."""
        group = []
        for f in s.fields:
            if f.plain:
                group.append(f)
                continue
            if group:
                yield group
                group = []
            yield [f]
        if group:
            yield group

    def put_field(self, f):
        t = f.type
        if t.kind in ("string", "bytes"):
            return [f"    orr_wire_put_bytes(w, m->{f.name}, {t.limit});"]
        if t.kind == "list":
            return [f"    put_{t.struct.name if t.struct else t.scalar}_list(w, &m->{f.name}, {t.limit});"]
        return [f"    put_{t.struct.name}(w, &m->{f.name});"]

    def get_field(self, f):
        t = f.type
        if t.kind in ("string", "bytes"):
            return [f"    m->{f.name} = orr_wire_get_bytes(r, {t.limit});"]
        if t.kind == "list":
            return [f"    get_{t.struct.name if t.struct else t.scalar}_list(r, &m->{f.name}, {t.limit});"]
        return [f"    get_{t.struct.name}(r, &m->{f.name});"]

    def variable(self, s):
        name = f"{self.p}_{s.name}"
        out = []
        for put in (True, False):
            verb, stream, const = ("put", "orr_wire_writer *w", "const ") if put else ("get", "orr_wire_reader *r", "")
            out += [f"static void {verb}_{s.name}({stream}, {const}{name} *m)", "{"]
            groups = list(self.runs(s))
            if any(f.type.size is not None for g in groups for f in g):
                out.append(f"    {'' if put else 'const '}uint8_t *p;")
            if not groups:
                out.append(f"    (void){'w' if put else 'r'};")
                out.append("    (void)m;")
            for group in groups:
                lines = []
                if group[0].type.size is not None:
                    size = sum(f.type.size for f in group)
                    lines.append(f"    p = {'orr_wire_room(w' if put else 'orr_wire_take(r'}, {size});")
                    lines.append("    if (p == NULL) return;")
                    at = 0
                    for f in group:
                        lines += self.move(f, at, put)
                        at += f.type.size
                else:
                    lines += self.put_field(group[0]) if put else self.get_field(group[0])
                f = group[0]
                if f.since and not put:
                    out.append(f"    if (r->at == r->size) return; // the sender is older than minor version {f.since}")
                if f.when:
                    out.append(f"    if ((m->{f.when_field} & UINT64_C({f.when_mask})) != 0) {{")
                    out += ["    " + line for line in lines] + ["    }"]
                else:
                    out += lines
            out += ["}", ""]
        return out

    def list_code(self, record):
        scalar = record[0] == "scalar"
        word = record[1] if scalar else record[1].name
        item, name = self.record_name(record), f"{self.p}_{word}_list"
        fixed = scalar or record[1].fixed
        size = SCALARS[record[1]] if scalar else record[1].size
        older = [] if scalar or not fixed else record[1].older_sizes  # what senders of earlier minor versions may send
        store = f"orr_wire_store_{word}(p + {size} * (size_t)i, list->item[i])" if scalar else \
            f"store_{word}(p + {size} * (size_t)i, &list->item[i])"
        load = f"*out = orr_wire_load_{word}(p)" if scalar else f"load_{word}(p, out)"
        out = [f"static void put_{word}_records(orr_wire_writer *w, const {name} *list)", "{",
               "    if (list->item == NULL) {", "        orr_wire_put_raw(w, list->wire.data, list->wire.size);",
               "        return;", "    }"]
        if fixed:
            out += [f"    uint8_t *p = orr_wire_room(w, {size} * (size_t)list->count);",
                    "    if (p == NULL) return;", f"    for (uint16_t i = 0; i < list->count; i++) {store};"]
        else:
            out += ["    for (uint16_t i = 0; i < list->count; i++) {",
                    "        size_t start = w->size;", "        if (orr_wire_room(w, 2) == NULL) return;",
                    f"        put_{word}(w, &list->item[i]);", "        if (w->status != ORR_WIRE_OK) return;",
                    "        orr_wire_store_u16(w->data + start, (uint16_t)(w->size - start - 2));", "    }"]
        out += ["}", ""]
        if not scalar:
            out += [f"orr_wire_status {self.p}_{word}_records_encode(const {name} *piece, orr_wire_writer *w)", "{",
                    f"    put_{word}_records(w, piece);", "    return w->status;", "}", ""]
        out += [f"static void put_{word}_list(orr_wire_writer *w, const {name} *list, uint16_t max)", "{",
               "    if (w->status == ORR_WIRE_OK && list->count > max) w->status = ORR_WIRE_LIMIT;",
               "    if (list->count > 0 && list->item == NULL && list->wire.data == NULL) w->status = ORR_WIRE_SHORT; // our caller's bug",
               f"    uint8_t *p = orr_wire_room(w, {4 if fixed else 2});", "    if (p == NULL) return;",
               "    orr_wire_store_u16(p, list->count);"]
        if fixed:
            out += [f"    orr_wire_store_u16(p + 2, list->item != NULL || list->count == 0 ? {size} : list->wire.stride);"]
        out += [f"    put_{word}_records(w, list);"]
        out += ["}", "", f"static void get_{word}_list(orr_wire_reader *r, {name} *list, uint16_t max)", "{",
                f"    const uint8_t *p = orr_wire_take(r, {4 if fixed else 2});", "    if (p == NULL) return;",
                "    uint16_t count = orr_wire_load_u16(p);", "    if (count > max) {",
                "        r->status = ORR_WIRE_LIMIT;", "        return;", "    }"]
        if fixed:
            out += ["    uint16_t stride = orr_wire_load_u16(p + 2); // (I7)", f"    if (count > 0 && {' && '.join([f'stride < {size}'] + [f'stride != {n}' for n in older])}) {{",
                    "        r->status = ORR_WIRE_SHORT;", "        return;", "    }",
                    "    p = orr_wire_take(r, (size_t)count * stride);", "    if (p == NULL) return;",
                    "    list->wire.size = (size_t)count * stride;", "    list->wire.stride = stride;"]
        else:
            out += ["    size_t start = r->at;", "    p = r->data + r->at;",
                    "    for (uint16_t i = 0; i < count; i++) { // (I6) every record is read once, so that reading it later cannot fail",
                    "        const uint8_t *q = orr_wire_take(r, 2);", "        if (q == NULL) return;",
                    "        uint16_t size = orr_wire_load_u16(q);", "        q = orr_wire_take(r, size);",
                    "        if (q == NULL) return;", "        orr_wire_reader one = {q, size, 0, ORR_WIRE_OK};",
                    f"        {item} record;", "        memset(&record, 0, sizeof record);",
                    f"        get_{word}(&one, &record);", "        if (one.status != ORR_WIRE_OK) {",
                    "            r->status = one.status;", "            return;", "        }", "    }",
                    "    list->wire.size = r->at - start;", "    list->wire.stride = 0;"]
        out += ["    list->wire.data = p;", "    list->count = count;", "}", "",
                f"bool {self.p}_{word}_next(const {name} *list, orr_wire_iter *it, {item} *out)", "{"]
        if fixed:
            out += [f"    return {self.p}_{word}_at(list, it->index, out) ? (it->index++, true) : false;", "}", "",
                    f"bool {self.p}_{word}_at(const {name} *list, uint16_t index, {item} *out)", "{",
                    "    if (index >= list->count) return false;", "    if (list->item != NULL) {",
                    "        *out = list->item[index];", "        return true;", "    }",
                    "    size_t stride = list->wire.stride;", "    const uint8_t *p = list->wire.data + index * stride;"]
            if older:
                out += [f"    uint8_t whole[{size}] = {{0}}; // an older sender's record is shorter: what it lacks reads as zero",
                        f"    if (stride < {size}) {{", "        memcpy(whole, p, stride);", "        p = whole;", "    }"]
            out += [f"    {load};", "    return true;", "}", ""]
        else:
            out += ["    if (it->index >= list->count) return false;", "    memset(out, 0, sizeof *out);",
                    "    if (list->item != NULL) {", "        *out = list->item[it->index++];", "        return true;", "    }",
                    "    const uint8_t *p = list->wire.data + it->at;", "    uint16_t size = orr_wire_load_u16(p);",
                    "    orr_wire_reader one = {p + 2, size, 0, ORR_WIRE_OK};", f"    get_{word}(&one, out);",
                    "    it->at += (size_t)2 + size;", "    it->index++;", "    return one.status == ORR_WIRE_OK;", "}", ""]
        return out

    def names(self):
        s, p = self.spec, self.p
        out = [f"const char *{p}_type_name(uint16_t type)", "{", "    switch (type) {"]
        out += [f"    case {m.type_number}: return \"{n}\";" for n, m in s.messages.items()]
        out += ["    default: return NULL;", "    }", "}", ""]
        for n, e in s.enums.items():
            out += [f"const char *{p}_{n}_name({CTYPE[e['is']]} value)", "{", "    switch (value) {"]
            out += [f"    case {v['value']}: return \"{k}\";" for k, v in e["values"].items()]
            out += ["    default: return NULL;", "    }", "}", ""]
        for n in self.closing():
            cases = " || ".join(f"value == {v['value']}" for v in s.enums[n]["values"].values() if v.get("closes"))
            out += [f"bool {p}_{n}_closes({CTYPE[s.enums[n]['is']]} value)", "{", f"    return {cases};", "}", ""]
        for n, b in s.bits.items():
            out += [f"const char *{p}_{n}_name(unsigned bit)", "{", "    switch (bit) {"]
            out += [f"    case {v['bit']}: return \"{k}\";" for k, v in b["values"].items()]
            out += ["    default: return NULL;", "    }", "}", ""]
        return out

    def code(self):
        out = [line.format(source=self.source) for line in HEAD]
        out += [f'#include "{self.header_name}"', ""] + self.names()
        done = set()
        inline = {f.type.struct.name for s in list(self.spec.structs.values()) + list(self.spec.messages.values())
                  for f in s.fields if f.type.kind == "struct"}
        listed = {r[1].name for r in self.spec.list_records if r[0] == "struct"}

        def lists_of(struct):
            lines = []
            for f in struct.fields:
                if f.type.kind == "list":
                    record = ("scalar", f.type.scalar) if f.type.scalar else ("struct", f.type.struct)
                    if record not in done:
                        done.add(record)
                        lines += self.list_code(record)
            return lines

        for struct in self.spec.structs.values():
            if struct.name not in inline | listed:
                continue  # nothing on the wire uses it yet
            out += lists_of(struct)
            out += self.fixed_struct(struct) if struct.fixed else self.variable(struct)
        for message in self.spec.messages.values():
            out += lists_of(message)
            out += self.variable(message)
            name = f"{self.p}_{message.name}"
            out += [f"orr_wire_status {name}_encode(const {name} *m, orr_wire_writer *w)", "{",
                    f"    put_{message.name}(w, m);", "    return w->status;", "}", "",
                    f"orr_wire_status {name}_decode(const uint8_t *payload, size_t size, {name} *m)", "{",
                    "    orr_wire_reader r = {payload, size, 0, ORR_WIRE_OK};", "    memset(m, 0, sizeof *m);",
                    f"    get_{message.name}(&r, m);", "    return r.status;", "}", ""]
        return "\n".join(out).rstrip("\n") + "\n"
