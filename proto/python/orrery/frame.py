# SPDX-License-Identifier: MIT
"""The frame around every message: magic, version, type, sequence number, length, payload, CRC-32 (docs/protocol.md)."""
from __future__ import annotations

import dataclasses
import struct
import zlib
from typing import Callable

from . import messages
from .codec import Record

HEADER = struct.Struct("<4sBBHII")
OVERHEAD = HEADER.size + 4


class FrameError(Exception):
    """Bytes that are no frame: the stream cannot be followed any further."""


@dataclasses.dataclass
class Frame:
    """A frame's header fields and its payload."""

    type: int
    sequence: int
    payload: bytes
    major: int = messages.MAJOR
    minor: int = messages.MINOR

    def message(self) -> Record:
        """The payload as an object of its message class; KeyError if this version does not know the type."""
        return messages.MESSAGES[self.type].decode(self.payload)


def make(type: int, sequence: int, payload: bytes) -> bytes:
    """The bytes of a frame."""
    body = HEADER.pack(messages.MAGIC, messages.MAJOR, messages.MINOR, type, sequence, len(payload)) + payload
    return body + struct.pack("<I", zlib.crc32(body))


def check_header(header: bytes) -> tuple[int, int, int, int, int]:
    """(type, sequence, payload length, major, minor) of 16 bytes; FrameError if they begin no frame of ours."""
    magic, major, minor, type_, sequence, size = HEADER.unpack(header)
    if magic != messages.MAGIC:
        raise FrameError(f"not a frame of this protocol: it begins with {magic!r}")
    if major != messages.MAJOR:
        raise FrameError(f"a frame of protocol version {major}, this client speaks {messages.MAJOR}")
    if size > messages.MAX_PAYLOAD:
        raise FrameError(f"a payload of {size} bytes, at most {messages.MAX_PAYLOAD} are allowed")
    return type_, sequence, size, major, minor


def parse(data: bytes) -> Frame:
    """The frame of exactly its bytes; FrameError if they are damaged."""
    type_, sequence, size, major, minor = check_header(data[:HEADER.size])
    if len(data) != OVERHEAD + size:
        raise FrameError(f"a frame of {OVERHEAD + size} bytes, {len(data)} are given")
    if zlib.crc32(data[:-4]) != int.from_bytes(data[-4:], "little"):
        raise FrameError("the checksum of a frame does not match")
    return Frame(type_, sequence, bytes(data[HEADER.size:-4]), major, minor)


def read(receive: Callable[[int], bytes]) -> Frame:
    """Reads one frame. receive(n) returns exactly n bytes or raises."""
    header = receive(HEADER.size)
    size = check_header(header)[2]
    return parse(header + receive(size + 4))
