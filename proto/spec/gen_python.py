# SPDX-License-Identifier: MIT
"""The Python client: message classes (tables that orrery/codec.py encodes and decodes by) and the methods that ask for them."""
import textwrap

WIDTH = 131


def class_name(name):
    return "".join(part.capitalize() for part in name.split("_"))


def wrapped(text, indent, first=""):
    """Lines of a comment or docstring."""
    return textwrap.wrap(first + text, WIDTH - 4, initial_indent=indent, subsequent_indent=indent, break_long_words=False,
                         break_on_hyphens=False)


def folded(begin, rest):
    """A call or definition whose arguments may take several lines, under the first of them: broken behind commas outside of square
    brackets alone."""
    text, depth = "", 0
    for k, c in enumerate(rest):
        depth += (c == "[") - (c == "]")
        text += "\0" if c == " " and (depth > 0 or rest[k - 1] != ",") else c
    lines = textwrap.wrap(begin.replace(" ", "\0") + text, WIDTH, subsequent_indent="\0" * len(begin), break_long_words=False,
                          break_on_hyphens=False)
    return [line.replace("\0", " ") for line in lines]


class Python:
    def __init__(self, spec, source):
        self.spec, self.source = spec, source

    def is_named(self, field):
        """Of an enum or a bit set."""
        return field.type.named in self.spec.enums or field.type.named in self.spec.bits

    def element(self, field):
        t = field.type
        if self.is_named(field) and t.kind == "scalar":
            return class_name(t.named)
        if t.struct:
            return class_name(t.struct.name)
        return "float" if t.scalar[0] == "f" else "int"

    def hint(self, field):
        kind = field.type.kind
        if kind in ("array", "list"):
            return f"list[{self.element(field)}]"
        return {"string": "str", "bytes": "bytes"}.get(kind) or self.element(field)

    def default(self, field):
        t = field.type
        if t.kind == "array":
            return f"dataclasses.field(default_factory=lambda: [{'0.0' if t.scalar[0] == 'f' else '0'}] * {t.length})"
        if t.kind == "list":
            return "dataclasses.field(default_factory=list)"
        if t.kind == "struct":
            return f"dataclasses.field(default_factory={class_name(t.struct.name)})"
        if t.kind in ("string", "bytes"):
            return '""' if t.kind == "string" else 'b""'
        return f"{self.element(field)}(0)" if self.is_named(field) else "0.0" if t.scalar[0] == "f" else "0"

    def layout(self, field):
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
        if t.kind == "scalar" and self.is_named(field):
            args.append(f"enum={class_name(t.named)}")
        return f"        Field({', '.join(args)}),"

    def record(self, struct):
        out = ["", "", "@dataclasses.dataclass(eq=False, slots=True)", f"class {class_name(struct.name)}(Record):"]
        out += wrapped(struct.doc, "    ", '"""')
        if struct.fields:
            out.append("")
        for f in struct.fields:
            out += wrapped(f.doc, "    ", f"{f.name}{f' [{f.unit}]' if f.unit else ''}: ")
        out += ['    """', ""]
        if struct.message:
            out.append(f"    TYPE: ClassVar[int] = {struct.type_number}")
        out += ["    LAYOUT: ClassVar[tuple[Field, ...]] = ("] + [self.layout(f) for f in struct.fields] + ["    )", ""]
        out += [f"    {f.name}: {self.hint(f)} = {self.default(f)}" for f in struct.fields]
        if getattr(struct, "show", "") == "sat":
            letter, number = (f.name for f in struct.fields)
            out += ["", "    def __str__(self) -> str:", f'        return f"{{chr(self.{letter})}}{{self.{number}:02d}}"']
        for f in struct.fields:
            if f.type.struct and getattr(f.type.struct, "spread", False):
                for member in f.type.struct.fields:
                    out += ["", "    @property", f"    def {member.name}(self) -> {self.hint(member)}:"]
                    out += wrapped(member.doc + '"""', "        ", '"""') + [f"        return self.{f.name}.{member.name}"]
        if out[-1] == "":
            out.pop()
        return out

    def head(self, doc):
        return ["# SPDX-License-Identifier: MIT", f"# Generated from {self.source} by proto/spec/generate.py: change that, not this.",
                "# pylint: skip-file", f'"""{doc}"""']

    def module(self):
        s = self.spec
        out = self.head(f"Messages of {s.name}, protocol {s.major}.{s.minor}.")
        out += ["import dataclasses", "import enum", "from typing import ClassVar, Type", "",
                "from .codec import Field, Record, WireEnum", "", f"MAGIC = {s.magic!r}", f"MAJOR = {s.major}", f"MINOR = {s.minor}",
                f"PORT = {s.port}", f"MAX_PAYLOAD = {s.max_payload}"]
        out += [f"{name} = {c['value']}  # {c['doc']}" for name, c in s.constants.items()]
        for name, e in s.enums.items():
            out += ["", "", f"class {class_name(name)}(WireEnum):", *wrapped(e["doc"] + '"""', "    ", '"""'), ""]
            out += [f"    {n} = {v['value']}  # {v['doc']}" for n, v in e["values"].items()]
            closing = [str(v["value"]) for v in e["values"].values() if v.get("closes")]
            if closing:
                out += ["", "    @property", "    def closes(self) -> bool:", '        """Whether the server closes the connection with it."""',
                        f"        return self.value in ({', '.join(closing)},)"]
        for name, b in s.bits.items():
            out += ["", "", f"class {class_name(name)}(enum.IntFlag):", *wrapped(b["doc"] + '"""', "    ", '"""'), ""]
            out += [f"    {n} = {1 << v['bit']}  # {v['doc']}" for n, v in b["values"].items()]
        for struct in [*s.structs.values(), *s.messages.values()]:
            out += self.record(struct)
        out += ["", "", "MESSAGES: dict[int, Type[Record]] = {"]
        out += [f"    {m.type_number}: {class_name(m.name)}," for m in s.messages.values()]
        out += ["}", ""]
        return "\n".join(out)

    def argument(self, field):
        """(parameter, expression of the request's field) of a method that asks."""
        t, name = field.type, field.name
        if t.kind == "list" and t.struct and getattr(t.struct, "show", "") == "sat":
            return f"{name}: Iterable[Satellite] = ()", f"[sat_id(s) for s in {name}]"
        if t.kind == "list" and t.scalar:
            kind = self.element(field)
            return f"{name}: Iterable[{kind}] = ()", f"[{kind}(x) for x in {name}]"
        if t.kind == "array" and t.scalar[0] == "f":
            return f"{name}: Optional[Iterable[float]] = None", f"vector({name}, {t.length})"
        if t.kind == "scalar" and t.named in self.spec.enums:
            kind = f"messages.{class_name(t.named)}"
            return f"{name}: Union[{kind}, str] = {kind}(0)", f"choice({kind}, {name})"
        if t.kind == "scalar" and t.named in self.spec.bits:
            kind = f"messages.{class_name(t.named)}"
            return f"{name}: {kind} = {kind}(0)", name
        if t.kind == "scalar":
            return f"{name}: {self.element(field)} = {'0.0' if t.scalar[0] == 'f' else '0'}", name
        raise NotImplementedError(f"a request with {name}: {t.text} has no Python method yet")

    def verb(self, name, m):
        """Two methods: for a series of epochs, and for one."""
        answer = class_name(self.spec.messages[m.answer].name)
        own = [f for f in m.fields if f is not m.epochs]
        parameters = [self.argument(f) for f in own]
        args = ", ".join(f"{f.name}={text}" for f, (_, text) in zip(own, parameters))
        request = f"messages.{class_name(m.name)}(messages.Epochs({{}}){', ' if args else ''}{args})"
        tail = "".join(", " + p for p, _ in parameters)
        doc = []
        for f in own:
            doc += wrapped(f.doc, "        ", f"{f.name}{f' [{f.unit}]' if f.unit else ''}: ")
        intervals = any(f.name == "t1" for f in self.spec.messages[m.answer].fields)
        when = f"t, step_s, count: {m.epochs.doc}. " if m.epochs.doc != "when" else ""
        series = folded(f"    def {m.name}(", f"self, t: Time, step_s: float = 0.0, count: int = 1{tail}) -> Iterator[messages.{answer}]:")
        series += wrapped(f"Yields the {answer} of `count` epochs from t on, step_s apart (rounded to a nanosecond). {when}{m.doc}", "        ",
                          '"""')
        series += [""] + doc + ['        """']
        series += folded("        return self._series(", f"{request.format('time_tag(t), step_ns(step_s), 1')}, messages.{answer}, count)")
        first, call = ("t: Time, step_s: float = 0.0", "time_tag(t), step_ns(step_s), 1") if intervals else ("t: Time", "time_tag(t), 0, 1")
        single = folded(f"    def {self.spec.messages[m.answer].name}(", f"self, {first}{tail}) -> messages.{answer}:")
        single += [f'        """The {answer} of one epoch; {m.name} says more."""',
                   *folded("        return self._single(", f"{request.format(call)}, messages.{answer})")]
        return ["", *series, "", *single]

    def verbs(self):
        out = self.head(f"What a client of {self.spec.name} can ask for: two methods a message with epochs.")
        out += ["from __future__ import annotations", "", "from typing import Iterable, Iterator, Optional, Union", "",
                "from . import messages", "from .asking import Asking, choice, step_ns, vector", "from .gpstime import Time, time_tag",
                "from .satellite import Satellite, sat_id", "", "", "class Verbs(Asking):",
                '    """Methods by message. t: a time tag, a text or a datetime (orrery.gpstime); satellites: names, empty for all."""']
        for name, m in self.spec.messages.items():
            if m.sender == "client" and m.answer in self.spec.messages and m.epochs:
                out += self.verb(name, m)
        return "\n".join(out) + "\n"


def module(spec, source):
    return Python(spec, source).module()


def verbs(spec, source):
    return Python(spec, source).verbs()
