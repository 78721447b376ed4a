# SPDX-License-Identifier: MIT
"""The frame around every message: magic, version, type, sequence number, length, payload, CRC-32 (docs/protocol.md)."""
import struct
import zlib

from . import messages

HEADER = struct.Struct("<4sBBHII")
OVERHEAD = HEADER.size + 4


class FrameError(Exception):
    """Bytes that are no frame: the stream cannot be followed any further."""


class Frame:
    """A frame's header fields and its payload."""

    __slots__ = ("type", "sequence", "payload", "major", "minor")

    def __init__(self, type, sequence, payload, major=messages.MAJOR, minor=messages.MINOR):
        self.type, self.sequence, self.payload, self.major, self.minor = type, sequence, payload, major, minor

    def message(self):
        """The payload as an object of its message class; KeyError if this version does not know the type."""
        return messages.MESSAGES[self.type].decode(self.payload)


def make(type, sequence, payload):
    """The bytes of a frame."""
    body = HEADER.pack(messages.MAGIC, messages.MAJOR, messages.MINOR, type, sequence, len(payload)) + payload
    return body + struct.pack("<I", zlib.crc32(body))


def check_header(header):
    """(type, sequence, payload length, major, minor) of 16 bytes; FrameError if they begin no frame of ours."""
    magic, major, minor, type_, sequence, size = HEADER.unpack(header)
    if magic != messages.MAGIC:
        raise FrameError(f"not a frame of this protocol: it begins with {magic!r}")
    if major != messages.MAJOR:
        raise FrameError(f"a frame of protocol version {major}, this client speaks {messages.MAJOR}")
    if size > messages.MAX_PAYLOAD:
        raise FrameError(f"a payload of {size} bytes, at most {messages.MAX_PAYLOAD} are allowed")
    return type_, sequence, size, major, minor


def read(receive):
    """Reads one frame. receive(n) returns exactly n bytes or raises."""
    header = receive(HEADER.size)
    type_, sequence, size, major, minor = check_header(header)
    rest = receive(size + 4)
    payload, crc = rest[:size], struct.unpack("<I", rest[size:])[0]
    if zlib.crc32(payload, zlib.crc32(header)) != crc:
        raise FrameError("the checksum of a frame does not match")
    return Frame(type_, sequence, bytes(payload), major, minor)
