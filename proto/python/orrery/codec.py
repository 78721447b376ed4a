# SPDX-License-Identifier: MIT
"""Encoding and decoding of messages whose layout is a table (see messages.py, which is generated): little-endian, every
access checked. Standard library only."""
from __future__ import annotations

import dataclasses
import enum
import struct
from typing import Any, ClassVar, Optional, Sequence, Type, TypeVar, Union

FORMATS = {"u8": "B", "u16": "H", "u32": "I", "u64": "Q", "i8": "b", "i16": "h", "i32": "i", "i64": "q", "f32": "f",
           "f64": "d"}
R = TypeVar("R", bound="Record")


class CodecError(ValueError):
    """Bytes that are no such message, or a value that cannot be put into one."""


class WireEnum(enum.IntEnum):
    """An enumeration of the wire. A value that this version does not know becomes a member called UNKNOWN_<value>."""

    @classmethod
    def _missing_(cls, value: object) -> Optional["WireEnum"]:
        if not isinstance(value, int) or not 0 <= value < 1 << 64:
            return None
        made = int.__new__(cls, value)
        made._name_ = f"UNKNOWN_{value}"
        made._value_ = value
        return made


@dataclasses.dataclass(frozen=True)
class Field:
    """One field of a layout. kind: scalar, array, struct, string, bytes, list."""

    name: str
    kind: str
    scalar: str = ""
    length: int = 0
    record: Optional[Type["Record"]] = None
    limit: int = 0
    when: Optional[tuple[str, int]] = None  # (field, mask): there only if a bit of an earlier field is set
    since: int = 0                          # minor version that appended it
    enum: Optional[Union[Type[WireEnum], Type[enum.IntFlag]]] = None

    @property
    def inner(self) -> Type["Record"]:
        """The record of a struct or of a list of structs."""
        if self.record is None:
            raise CodecError(f"{self.name} holds no records")
        return self.record


class _Reader:
    def __init__(self, data: Union[bytes, bytearray, memoryview]) -> None:
        self.data, self.at = memoryview(data), 0

    def take(self, n: int) -> memoryview:
        if n > len(self.data) - self.at:
            raise CodecError(f"{n} bytes wanted at byte {self.at}, {len(self.data) - self.at} there")
        self.at += n
        return self.data[self.at - n:self.at]

    def unpack(self, code: str, n: int) -> tuple[Any, ...]:
        return struct.unpack("<" + code, self.take(n))


class Record:
    """Base of all generated classes: fields are attributes; LAYOUT tells how they travel. Two of a class are equal if they say the same,
    where NAN is equal to NAN."""

    __slots__ = ()
    LAYOUT: ClassVar[tuple[Field, ...]] = ()

    def encode(self) -> bytes:
        """The payload's bytes; CodecError if a value does not fit its field."""
        out = bytearray()
        for field in self.LAYOUT:
            if self._holds(field):
                try:
                    self._put(out, field, getattr(self, field.name))
                except (struct.error, TypeError, AttributeError) as error:
                    raise CodecError(f"{type(self).__name__}.{field.name}: {error}") from None
        return bytes(out)

    @classmethod
    def decode(cls: Type[R], data: Union[bytes, bytearray, memoryview]) -> R:
        """Reads one message or record; bytes after the last known field are of a later version and are ignored."""
        return cls._get(_Reader(data))

    def __eq__(self, other: object) -> bool:
        if type(self) is not type(other):
            return NotImplemented
        return all(_same(getattr(self, f.name), getattr(other, f.name)) for f in self.LAYOUT
                   if self._holds(f) or other._holds(f))  # type: ignore[attr-defined]

    @classmethod
    def fixed_format(cls) -> Optional[str]:
        """The struct format of a record of fixed size, or None."""
        code = ""
        for field in cls.LAYOUT:
            if field.when:
                return None
            if field.kind == "scalar":
                code += FORMATS[field.scalar]
            elif field.kind == "array":
                code += str(field.length) + FORMATS[field.scalar]
            else:
                inner = field.inner.fixed_format() if field.kind == "struct" else None
                if inner is None:
                    return None
                code += inner
        return code

    def _holds(self, field: Field) -> bool:
        return field.when is None or bool(getattr(self, field.when[0]) & field.when[1])

    def _put(self, out: bytearray, field: Field, value: Any) -> None:
        where = f"{type(self).__name__}.{field.name}"
        if field.kind == "scalar":
            out += _pack(field.scalar, [value])
        elif field.kind == "array":
            if len(value) != field.length:
                raise CodecError(f"{where}: {field.length} values wanted, not {len(value)}")
            out += _pack(field.scalar, value)
        elif field.kind == "struct":
            out += value.encode()
        elif field.kind in ("string", "bytes"):
            raw = value.encode("utf-8") if field.kind == "string" else bytes(value)
            if len(raw) > field.limit:
                raise CodecError(f"{where}: {len(raw)} bytes, at most {field.limit} allowed")
            out += struct.pack("<H", len(raw)) + raw
        else:
            self._put_list(out, field, value, where)

    @staticmethod
    def _put_list(out: bytearray, field: Field, value: Sequence[Any], where: str) -> None:
        if len(value) > field.limit:
            raise CodecError(f"{where}: {len(value)} records, at most {field.limit} allowed")
        out += struct.pack("<H", len(value))
        if field.scalar:
            out += struct.pack("<H", struct.calcsize(FORMATS[field.scalar])) + _pack(field.scalar, value)
            return
        code = field.inner.fixed_format()
        if code is not None:
            out += struct.pack("<H", struct.calcsize("<" + code))
            out += b"".join(record.encode() for record in value)
        else:
            for record in value:
                raw = record.encode()
                out += struct.pack("<H", len(raw)) + raw

    @classmethod
    def _get(cls: Type[R], reader: _Reader) -> R:
        self = cls()
        for field in cls.LAYOUT:
            if not self._holds(field):
                continue
            if field.since and reader.at == len(reader.data):
                break  # the sender is of an older minor version
            setattr(self, field.name, cls._get_value(reader, field))
        return self

    @classmethod
    def _get_value(cls, reader: _Reader, field: Field) -> Any:
        if field.kind == "scalar":
            value = reader.unpack(FORMATS[field.scalar], struct.calcsize(FORMATS[field.scalar]))[0]
            return field.enum(value) if field.enum else value
        if field.kind == "array":
            return list(reader.unpack(str(field.length) + FORMATS[field.scalar], _size(field)))
        if field.kind == "struct":
            return field.inner._get(reader)
        if field.kind in ("string", "bytes"):
            size = reader.unpack("H", 2)[0]
            if size > field.limit:
                raise CodecError(f"{cls.__name__}.{field.name}: {size} bytes, at most {field.limit} allowed")
            raw = bytes(reader.take(size))
            return raw.decode("utf-8", "replace") if field.kind == "string" else raw
        return cls._get_list(reader, field)

    @classmethod
    def _get_list(cls, reader: _Reader, field: Field) -> list[Any]:
        count = reader.unpack("H", 2)[0]
        if count > field.limit:
            raise CodecError(f"{cls.__name__}.{field.name}: {count} records, at most {field.limit} allowed")
        if not field.scalar and field.inner.fixed_format() is None:
            return [field.inner.decode(reader.take(reader.unpack("H", 2)[0])) for _ in range(count)]
        stride = reader.unpack("H", 2)[0]
        raw = reader.take(count * stride)
        if field.scalar:
            if count and stride < struct.calcsize(FORMATS[field.scalar]):
                raise CodecError(f"{cls.__name__}.{field.name}: values of {stride} bytes")
            return [struct.unpack_from("<" + FORMATS[field.scalar], raw, k * stride)[0] for k in range(count)]
        return [field.inner.decode(raw[k * stride:(k + 1) * stride]) for k in range(count)]


def _pack(scalar: str, values: Sequence[Any]) -> bytes:
    if scalar in ("f32", "f64"):  # one NAN for all: equal messages are equal bytes
        values = [float("nan") if v != v else v for v in values]
    return struct.pack(f"<{len(values)}{FORMATS[scalar]}", *values)


def _size(field: Field) -> int:
    return struct.calcsize("<" + FORMATS[field.scalar]) * field.length


def _same(a: Any, b: Any) -> bool:
    if isinstance(a, (list, tuple)) and isinstance(b, (list, tuple)):
        return len(a) == len(b) and all(map(_same, a, b))
    return bool(a == b or (a != a and b != b))
