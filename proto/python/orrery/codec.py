# SPDX-License-Identifier: MIT
"""Encoding and decoding of messages whose layout is a table (see messages.py, which is generated): little-endian, every
access checked. Standard library only."""
import struct

FORMATS = {"u8": "B", "u16": "H", "u32": "I", "u64": "Q", "i8": "b", "i16": "h", "i32": "i", "i64": "q", "f32": "f",
           "f64": "d"}


class CodecError(ValueError):
    """Bytes that are no such message, or a value that cannot be put into one."""


class Field:
    """One field of a layout. kind: scalar, array, struct, string, bytes, list."""

    __slots__ = ("name", "kind", "scalar", "length", "record", "limit", "when", "since")

    def __init__(self, name, kind, scalar=None, length=0, record=None, limit=0, when=None, since=0):
        self.name, self.kind, self.scalar, self.length = name, kind, scalar, length
        self.record, self.limit, self.when, self.since = record, limit, when, since  # when: (field, mask)


class _Reader:
    def __init__(self, data):
        self.data, self.at = memoryview(data), 0

    def take(self, n):
        if n > len(self.data) - self.at:
            raise CodecError(f"{n} bytes wanted at byte {self.at}, {len(self.data) - self.at} there")
        self.at += n
        return self.data[self.at - n:self.at]

    def unpack(self, code, n):
        return struct.unpack("<" + code, self.take(n))


class Record:
    """Base of all generated classes: fields are attributes; LAYOUT tells how they travel."""

    LAYOUT = ()

    def encode(self):
        out = bytearray()
        for field in self.LAYOUT:
            if field.when is None or getattr(self, field.when[0]) & field.when[1]:
                try:
                    self._put(out, field, getattr(self, field.name))
                except (struct.error, TypeError, AttributeError) as error:
                    raise CodecError(f"{type(self).__name__}.{field.name}: {error}") from None
        return bytes(out)

    @classmethod
    def decode(cls, data):
        """Reads one message or record; bytes after the last known field are of a later version and are ignored."""
        return cls._get(_Reader(data))

    @classmethod
    def fixed_format(cls):
        """The struct format of a record of fixed size, or None."""
        if "_fixed" not in cls.__dict__:
            cls._fixed = cls._make_format()
        return cls._fixed

    @classmethod
    def _make_format(cls):
        code = ""
        for field in cls.LAYOUT:
            if field.when:
                return None
            if field.kind == "scalar":
                code += FORMATS[field.scalar]
            elif field.kind == "array":
                code += str(field.length) + FORMATS[field.scalar]
            elif field.kind == "struct" and field.record.fixed_format() is not None:
                code += field.record.fixed_format()
            else:
                return None
        return code

    def _put(self, out, field, value):
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
    def _put_list(out, field, value, where):
        if len(value) > field.limit:
            raise CodecError(f"{where}: {len(value)} records, at most {field.limit} allowed")
        out += struct.pack("<H", len(value))
        if field.scalar:
            out += struct.pack("<H", struct.calcsize(FORMATS[field.scalar])) + _pack(field.scalar, value)
        elif field.record.fixed_format() is not None:
            out += struct.pack("<H", struct.calcsize("<" + field.record.fixed_format()))
            out += b"".join(record.encode() for record in value)
        else:
            for record in value:
                raw = record.encode()
                out += struct.pack("<H", len(raw)) + raw

    @classmethod
    def _get(cls, reader):
        self = cls()
        for field in cls.LAYOUT:
            if field.when is not None and not getattr(self, field.when[0]) & field.when[1]:
                continue
            if field.since and reader.at == len(reader.data):
                break  # the sender is of an older minor version
            setattr(self, field.name, cls._get_value(reader, field))
        return self

    @classmethod
    def _get_value(cls, reader, field):
        if field.kind == "scalar":
            return reader.unpack(FORMATS[field.scalar], struct.calcsize(FORMATS[field.scalar]))[0]
        if field.kind == "array":
            return list(reader.unpack(str(field.length) + FORMATS[field.scalar], _size(field)))
        if field.kind == "struct":
            return field.record._get(reader)
        if field.kind in ("string", "bytes"):
            size = reader.unpack("H", 2)[0]
            if size > field.limit:
                raise CodecError(f"{cls.__name__}.{field.name}: {size} bytes, at most {field.limit} allowed")
            raw = bytes(reader.take(size))
            return raw.decode("utf-8", "replace") if field.kind == "string" else raw
        return cls._get_list(reader, field)

    @classmethod
    def _get_list(cls, reader, field):
        count = reader.unpack("H", 2)[0]
        if count > field.limit:
            raise CodecError(f"{cls.__name__}.{field.name}: {count} records, at most {field.limit} allowed")
        fixed = field.scalar or field.record.fixed_format() is not None
        if not fixed:
            return [field.record.decode(reader.take(reader.unpack("H", 2)[0])) for _ in range(count)]
        stride = reader.unpack("H", 2)[0]
        raw = reader.take(count * stride)
        if field.scalar:
            if count and stride < struct.calcsize(FORMATS[field.scalar]):
                raise CodecError(f"{cls.__name__}.{field.name}: values of {stride} bytes")
            return [struct.unpack_from("<" + FORMATS[field.scalar], raw, k * stride)[0] for k in range(count)]
        return [field.record.decode(raw[k * stride:(k + 1) * stride]) for k in range(count)]


def _pack(scalar, values):
    if scalar in ("f32", "f64"):  # one NAN for all: equal messages are equal bytes
        values = [float("nan") if v != v else v for v in values]
    return struct.pack(f"<{len(values)}{FORMATS[scalar]}", *values)


def _size(field):
    if field.kind == "struct":
        return struct.calcsize("<" + field.record.fixed_format())
    return struct.calcsize("<" + FORMATS[field.scalar]) * (field.length if field.kind == "array" else 1)
