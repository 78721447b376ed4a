# SPDX-License-Identifier: MIT
"""The Python client's message classes: tables that orrery/codec.py encodes and decodes by."""


def class_name(name):
    return "".join(part.capitalize() for part in name.split("_"))


def default(field):
    t = field.type
    if t.kind == "scalar":
        return "0.0" if t.scalar[0] == "f" else "0"
    if t.kind == "array":
        return f"[{'0.0' if t.scalar[0] == 'f' else '0'}] * {t.length}"
    if t.kind == "struct":
        return f"{class_name(t.struct.name)}()"
    return {"string": '""', "bytes": 'b""', "list": "[]"}[t.kind]


def layout(field):
    t = field.type
    args = [f'"{field.name}"', f'"{t.kind}"']
    if t.scalar:
        args.append(f'scalar="{t.scalar}"')
    if t.length:
        args.append(f"length={t.length}")
    if t.struct:
        args.append(f"record={class_name(t.struct.name)}")
    if t.limit:
        args.append(f"limit={t.limit}")
    if field.when:
        args.append(f'when=("{field.when_field}", {field.when_mask})')
    if field.since:
        args.append(f"since={field.since}")
    return f"        Field({', '.join(args)}),"


def record(struct):
    name = class_name(struct.name)
    out = ["", "", f"class {name}(Record):", f'    """{struct.doc}', ""]
    for f in struct.fields:
        unit = f" [{f.unit}]" if f.unit else ""
        out.append(f"    {f.name}{unit}: {f.doc}")
    out.append('    """')
    out.append("")
    if struct.message:
        out.append(f"    TYPE = {struct.type_number}")
    out += ["    LAYOUT = ("] + [layout(f) for f in struct.fields] + ["    )", ""]
    wants_none = {f.name for f in struct.fields if f.type.kind in ("array", "struct", "list")}
    args = ", ".join(f"{f.name}={'None' if f.name in wants_none else default(f)}" for f in struct.fields)
    out.append(f"    def __init__(self, {args}):" if args else "    def __init__(self):")
    for f in struct.fields:
        if f.name in wants_none:
            out.append(f"        self.{f.name} = {default(f)} if {f.name} is None else {f.name}")
        else:
            out.append(f"        self.{f.name} = {f.name}")
    if not struct.fields:
        out.append("        pass")
    for f in struct.fields:
        if f.type.struct and f.type.struct.spread:
            out += spread(f)
    return out


def spread(field):
    """The members of a record that is read as if they were the message's own."""
    out = []
    for member in field.type.struct.fields:
        out += ["", "    @property", f"    def {member.name}(self):", f'        """{member.doc}"""',
                f"        return self.{field.name}.{member.name}"]
    return out


def module(spec, source):
    out = ["# SPDX-License-Identifier: MIT", f"# Generated from {source} by proto/spec/generate.py: change that, not this.",
           "# pylint: skip-file", f'"""Messages of {spec.name}, protocol {spec.major}.{spec.minor}."""', "import enum", "",
           "from .codec import Field, Record", "", f"MAGIC = {spec.magic!r}", f"MAJOR = {spec.major}", f"MINOR = {spec.minor}",
           f"PORT = {spec.port}", f"MAX_PAYLOAD = {spec.max_payload}"]
    out += [f"{name} = {c['value']}  # {c['doc']}" for name, c in spec.constants.items()]
    for name, e in spec.enums.items():
        out += ["", "", f"class {class_name(name)}(enum.IntEnum):", f'    """{e["doc"]}"""', ""]
        out += [f"    {n} = {v['value']}  # {v['doc']}" for n, v in e["values"].items()]
    for name, b in spec.bits.items():
        out += ["", "", f"class {class_name(name)}(enum.IntFlag):", f'    """{b["doc"]}"""', ""]
        out += [f"    {n} = {1 << v['bit']}  # {v['doc']}" for n, v in b["values"].items()]
    for s in list(spec.structs.values()) + list(spec.messages.values()):
        out += record(s)
    out += ["", "", "MESSAGES = {cls.TYPE: cls for cls in ("]
    out += [f"    {class_name(m.name)}," for m in spec.messages.values()]
    out += [")}", ""]
    return "\n".join(out)
