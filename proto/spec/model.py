# SPDX-License-Identifier: MIT
"""The message specification as objects: reads messages.yaml, resolves its types and refuses what could not be put on the wire."""
import keyword
import re

import yaml

SCALARS = {"u8": 1, "u16": 2, "u32": 4, "u64": 8, "i8": 1, "i16": 2, "i32": 4, "i64": 8, "f32": 4, "f64": 8}
NAME = re.compile(r"^[a-z][a-z0-9_]*$")
RESERVED = set(keyword.kwlist) | set(
    "auto break case char const continue default do double else enum extern float for goto if inline int long register "
    "restrict return short signed sizeof static struct switch typedef union unsigned void volatile while "
    "end function local nil repeat then until "
    "bool catch class delete explicit export friend mutable namespace new operator private protected public template this throw "
    "typename using virtual".split())  # of C, Lua and C++


class SpecError(Exception):
    """A specification that cannot be generated from, with a sentence."""


class Type:
    """What one field holds. kind: scalar, array, struct, string, bytes, list; text: as the specification writes it."""

    def __init__(self, kind, text, scalar=None, length=0, struct=None, limit=0, named=None):
        self.kind, self.text, self.scalar, self.length = kind, text, scalar, length
        self.struct, self.limit, self.named = struct, limit, named  # named: the alias, enum or bit set it was called by

    @property
    def size(self):
        """Bytes on the wire, or None where they vary."""
        if self.kind == "scalar":
            return SCALARS[self.scalar]
        if self.kind == "array":
            return SCALARS[self.scalar] * self.length
        return self.struct.size if self.kind == "struct" else None

    @property
    def record(self):
        """Of a list: size of a record, or None where it varies."""
        return SCALARS[self.scalar] if self.scalar else self.struct.size

    @property
    def largest(self):
        if self.size is not None:
            return self.size
        if self.kind in ("string", "bytes"):
            return 2 + self.limit
        if self.kind == "list":
            return 4 + self.limit * self.record if self.record else 2 + self.limit * (2 + self.struct.largest)
        return self.struct.largest


class Field:
    def __init__(self, owner, raw):
        unknown = set(raw) - {"name", "type", "unit", "doc", "show", "when", "since", "text", "table", "head", "per"}
        if unknown:
            raise SpecError(f"{owner}: unknown key {sorted(unknown)[0]} of a field")
        self.name, self.doc, self.unit = raw["name"], raw.get("doc", ""), raw.get("unit", "")
        self.show, self.when, self.since = raw.get("show", ""), raw.get("when"), raw.get("since", 0)
        self.text, self.table = str(raw.get("text", "")), str(raw.get("table", ""))
        self.head, self.per = raw.get("head"), raw.get("per", "")
        self.raw_type = raw["type"]
        if not NAME.match(self.name) or self.name in RESERVED:
            raise SpecError(f"{owner}.{self.name}: a field's name is lower case and no keyword of C, C++, Python or Lua")
        if not self.doc:
            raise SpecError(f"{owner}.{self.name}: say what it is (doc)")
        self.type = None
        self.when_mask = 0
        self.when_field = ""

    @property
    def plain(self):
        """Always there and of fixed size."""
        return self.type.size is not None and not self.when and not self.since


class Struct:
    """A record or a message: fields in the order of the wire."""

    def __init__(self, name, raw, message=False):
        self.name, self.doc, self.message = name, raw["doc"], message
        self.fields = [Field(name, f) for f in raw.get("fields", [])]
        unknown = set(raw) - {"doc", "fields", "type", "from", "answer", "spread", "show", "built_in", "lane"}
        if unknown:
            raise SpecError(f"{name}: unknown key {sorted(unknown)[0]}")
        self.type_number, self.sender, self.answer = raw.get("type", 0), raw.get("from", ""), raw.get("answer", "")
        self.spread, self.show, self.built_in = raw.get("spread", False), raw.get("show", ""), raw.get("built_in", False)
        self.lane = raw.get("lane", False)

    @property
    def fixed(self):
        return all(f.type.size is not None and not f.when for f in self.fields)

    @property
    def size(self):
        return sum(f.type.size for f in self.fields) if self.fixed else None

    @property
    def epochs(self):
        """The field that says for which instants a request asks; it is answered once for each. None: it is answered once."""
        return next((f for f in self.fields if f.type.struct and f.type.struct.name == "epochs"), None)

    @property
    def older_sizes(self):
        """Bytes of a fixed record as the minor versions before had it, without its present size."""
        minors = sorted({f.since for f in self.fields})
        return [sum(f.type.size for f in self.fields if f.since <= minor) for minor in minors[:-1]]

    @property
    def largest(self):
        return sum(f.type.largest for f in self.fields)


class Spec:
    def __init__(self, path):
        with open(path, encoding="utf-8") as stream:
            raw = yaml.safe_load(stream)
        protocol = raw["protocol"]
        self.name, self.magic, self.port = protocol["name"], protocol["magic"].encode("ascii"), protocol["port"]
        self.major, self.minor = protocol["major"], protocol["minor"]
        self.max_payload, self.prefix = protocol["max_payload"], protocol["c_prefix"]
        self.constants = raw.get("constants", {})
        self.aliases, self.enums, self.bits = raw.get("aliases", {}), raw.get("enums", {}), raw.get("bits", {})
        self.structs, self.messages = {}, {}
        self.list_records = []  # distinct records of lists, in order of need: ("struct", Struct) or ("scalar", name)
        for name, value in (raw.get("structs") or {}).items():
            self.structs[name] = Struct(name, value)
            self._resolve(self.structs[name])  # a struct may use those above it alone: no recursion
        for name, value in raw["messages"].items():
            self.messages[name] = Struct(name.lower(), value, message=True)
            self._resolve(self.messages[name])
        self._check()
        self.examples = raw.get("examples", [])

    def _limit(self, text, where):
        value = self.constants[text]["value"] if text in self.constants else int(text)
        if not 0 < value <= 65535:
            raise SpecError(f"{where}: a limit is 1 to 65535")
        return value

    def _type(self, text, where):
        text = text.strip()
        match = re.match(r"^(string|bytes)<(\w+)>$", text)
        if match:
            return Type(match.group(1), text, limit=self._limit(match.group(2), where))
        match = re.match(r"^list<(\w+),\s*(\w+)>$", text)
        if match:
            limit = self._limit(match.group(2), where)
            element = self._type(match.group(1), where)
            if element.kind == "scalar":
                record = ("scalar", element.scalar)
                made = Type("list", text, scalar=element.scalar, limit=limit, named=element.named)
            elif element.kind == "struct":
                record = ("struct", element.struct)
                made = Type("list", text, struct=element.struct, limit=limit)
            else:
                raise SpecError(f"{where}: a list holds structs or scalars")
            if record not in self.list_records:
                self.list_records.append(record)
            return made
        match = re.match(r"^(\w+)\[(\d+)\]$", text)
        if match and match.group(1) in SCALARS:
            return Type("array", text, scalar=match.group(1), length=int(match.group(2)))
        if text in SCALARS:
            return Type("scalar", text, scalar=text)
        for table in (self.aliases, self.enums, self.bits):
            if text in table:
                return Type("scalar", text, scalar=table[text]["is"], named=text)
        if text in self.structs:
            return Type("struct", text, struct=self.structs[text])
        raise SpecError(f"{where}: no type called {text} (structs must stand above their use)")

    def _resolve(self, struct):
        since, names = 0, set()
        for field in struct.fields:
            where = f"{struct.name}.{field.name}"
            if field.name in names:
                raise SpecError(f"{where}: twice")
            names.add(field.name)
            field.type = self._type(field.raw_type, where)
            if field.type.kind == "struct" and any(f.since for f in field.type.struct.fields):
                raise SpecError(f"{where}: a struct that has grown cannot stand inline")
            if field.since < since:
                raise SpecError(f"{where}: fields of a later minor version stand last")
            if field.since > self.minor:
                raise SpecError(f"{where}: since {field.since}, but the minor version is {self.minor}")
            since = field.since
            if field.when:
                self._condition(struct, field, where)
            if not field.show and field.type.named in self.aliases:
                field.show = self.aliases[field.type.named].get("show", "")
            if not field.unit and field.type.named in self.aliases:
                field.unit = self.aliases[field.type.named].get("unit", "")

    def _condition(self, struct, field, where):
        name, _, bit = field.when.partition(".")
        earlier = {f.name: f for f in struct.fields[:struct.fields.index(field)]}
        if name not in earlier or earlier[name].type.named not in self.bits or earlier[name].when:
            raise SpecError(f"{where}: 'when' names FIELD.BIT of an earlier bit set")
        values = self.bits[earlier[name].type.named]["values"]
        if bit not in values:
            raise SpecError(f"{where}: no bit {bit} in {earlier[name].type.named}")
        field.when_field, field.when_mask = name, 1 << values[bit]["bit"]

    def _check(self):
        if len(self.magic) != 4:
            raise SpecError("the magic has four bytes")
        numbers = set()
        for name, message in self.messages.items():
            if not 0 < message.type_number <= 65535 or message.type_number in numbers:
                raise SpecError(f"{name}: a message type is a number of its own, 1 to 65535")
            numbers.add(message.type_number)
            if message.largest > self.max_payload:
                raise SpecError(f"{name}: may take {message.largest} bytes, above max_payload {self.max_payload}")
            if message.sender == "client" and message.answer not in {*self.messages, "none"}:
                raise SpecError(f"{name}: a client's message names its answer")
            if message.epochs and (message.answer == "none" or not any(f.type.text == "epoch" for f in self.messages[message.answer].fields)):
                raise SpecError(f"{name}: asks for epochs, but its answer has no field of type epoch")
        for name, struct in self.structs.items():
            if ("struct", struct) in self.list_records and struct.largest > 65535:
                raise SpecError(f"{name}: a record of a list takes at most 65535 bytes, this one up to {struct.largest}")
