# SPDX-License-Identifier: MIT
"""Frames in UDP datagrams, numbered, and sealed where the connection has TLS (docs/protocol.md, Datagrams)."""
from __future__ import annotations

import hashlib
import hmac
import socket
import struct
from typing import Optional

from . import frame, messages

HEAD, SEAL_BYTES, WINDOW, MAGIC = struct.Struct("<4sIQ"), 32, 1024, b"ORRD"


def make(channel: int, number: int, data: bytes, key: bytes = b"") -> bytes:
    """A datagram of a frame's bytes. number: from 1, one more each; key: of the direction, empty without a seal."""
    body = HEAD.pack(MAGIC, channel, number) + data
    return body + (hmac.digest(key, body, hashlib.sha256) if key else b"")


class Reader:
    """A receiver's end of a channel. `taken`, `replayed` and `refused` count what came; `missing` is what has not, or not yet."""

    def __init__(self, channel: int, key: bytes = b"") -> None:
        self.channel, self._key = channel, key
        self.greatest = self.taken = self.replayed = self.refused = 0
        self._seen = 0  # bit k: number greatest - k has come

    @property
    def missing(self) -> int:
        return self.greatest - self.taken

    def take(self, datagram: bytes) -> Optional[frame.Frame]:
        """Its frame; None if it is not of the channel, not sealed as agreed, or has come before."""
        body, seal = (datagram[:-SEAL_BYTES], datagram[-SEAL_BYTES:]) if self._key else (datagram, b"")
        try:
            magic, channel, number = HEAD.unpack_from(body)
            good = magic == MAGIC and channel == self.channel
            if good and self._key:
                good = hmac.compare_digest(hmac.digest(self._key, body, hashlib.sha256), seal)
            got = frame.parse(body[HEAD.size:]) if good else None
        except (struct.error, frame.FrameError):
            got = None
        if got is None:
            self.refused += 1
            return None
        return got if self._is_new(number) else None

    def _is_new(self, number: int) -> bool:
        back = self.greatest - number
        if number == 0 or back >= WINDOW or (back >= 0 and self._seen >> back & 1):
            self.replayed += 1
            return False
        if back < 0:
            self._seen = (self._seen << -back | 1) & ((1 << WINDOW) - 1) if -back < WINDOW else 1
            self.greatest = number
        else:
            self._seen |= 1 << back
        self.taken += 1
        return True


class Port:
    """A UDP socket for a stream's datagrams, at the address by which the connection goes."""

    def __init__(self, connection: socket.socket) -> None:
        family = connection.family if connection.family != socket.AF_UNIX else socket.AF_INET
        host = connection.getsockname()[0] if connection.family != socket.AF_UNIX else "127.0.0.1"
        self.socket = socket.socket(family, socket.SOCK_DGRAM)
        try:
            self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4 << 20)
            self.socket.bind((host, 0))
            self.socket.setblocking(False)
        except OSError:
            self.socket.close()
            raise
        self.number: int = self.socket.getsockname()[1]
        self.reader: Optional[Reader] = None

    def take(self) -> Optional[frame.Frame]:
        """The next new frame that has come; None: there is none."""
        while True:
            try:
                datagram = self.socket.recv(65536)
            except BlockingIOError:
                return None
            got = self.reader.take(datagram) if self.reader is not None else None
            if got is not None:
                return got

    def close(self) -> None:
        self.socket.close()


class MotionSender:
    """Sends motion in datagrams of a connection's channel (Client.motion_datagrams)."""

    def __init__(self, connection: socket.socket, told: messages.Datagrams) -> None:
        if told.port == 0:
            raise ValueError("the server takes no motion by datagrams: serve --motion --motion-udp")
        host = connection.getpeername()[0] if connection.family != socket.AF_UNIX else "127.0.0.1"
        family = connection.family if connection.family != socket.AF_UNIX else socket.AF_INET
        self.channel, self.number, self.to = told.channel, 0, (host, told.port)
        self._key = told.keys[:32] if told.seal == messages.Seal.HMAC_SHA256 else b""
        self._socket = socket.socket(family, socket.SOCK_DGRAM)

    def make(self, sample: messages.Motion) -> bytes:
        """The datagram of a sample, with the next number."""
        self.number += 1
        return make(self.channel, self.number, frame.make(sample.TYPE, self.number % 2**32, sample.encode()), self._key)

    def send(self, sample: messages.Motion) -> None:
        """Makes and sends it."""
        self.send_bytes(self.make(sample))

    def send_bytes(self, datagram: bytes) -> None:
        """Sends what make() gave."""
        self._socket.sendto(datagram, self.to)

    def close(self) -> None:
        self._socket.close()

    def __enter__(self) -> MotionSender:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
