# SPDX-License-Identifier: MIT
"""A stream's ring in shared memory: one writer, readers by sequence (the layout stands in proto/ring.h). What a reader is too slow for
is lost to it, and counted."""
from __future__ import annotations

import mmap
import os
import struct
import time
from typing import Optional, Tuple

from . import messages

MAGIC, COUNT_AT, SLOTS_AT, SLOT_HEAD = b"ORRYRNG1", 64, 128, 16


class MotionRing:
    """A ring into which this side writes MOTION (Client.motion_ring): its descriptors are of the memory and of the bell that wakes the server.
    The order of stores is kept by processors of the x86 kind alone; on others send motion by the socket."""

    def __init__(self, memory: int, bell: int) -> None:
        self._bell = bell
        try:
            self._map = mmap.mmap(memory, 0, mmap.MAP_SHARED, mmap.PROT_READ | mmap.PROT_WRITE)
        finally:
            os.close(memory)
        self._slots, self._stride = struct.unpack_from("<II", self._map, 8)
        self._words = memoryview(self._map).cast("Q")
        self.written = 0

    def write(self, kind: int, payload: bytes) -> None:
        """One message of a type; ValueError where it is larger than a slot."""
        if len(payload) > self._stride - SLOT_HEAD:
            raise ValueError(f"a payload of {len(payload)} bytes; a slot has {self._stride - SLOT_HEAD}")
        at = SLOTS_AT + self.written % self._slots * self._stride
        self._words[at // 8] = 2 * self.written + 1
        self._words[at // 8 + 1] = len(payload) | kind << 32
        self._map[at + SLOT_HEAD:at + SLOT_HEAD + len(payload)] = payload
        self._words[at // 8] = 2 * self.written + 2
        self.written += 1
        self._words[COUNT_AT // 8] = self.written

    def ring_bell(self) -> None:
        """Tells the server that there is something."""
        os.write(self._bell, (1).to_bytes(8, "little"))

    def send(self, sample: messages.Motion) -> None:
        """Writes a sample and tells the server."""
        self.write(sample.TYPE, sample.encode())
        self.ring_bell()

    def close(self) -> None:
        self._words.release()
        self._map.close()
        os.close(self._bell)

    def __enter__(self) -> MotionRing:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


class Ring:
    """Over a descriptor, which it closes. `lost` counts messages that went by unread."""

    def __init__(self, descriptor: int) -> None:
        try:
            self._map = mmap.mmap(descriptor, 0, mmap.MAP_SHARED, mmap.PROT_READ)
        finally:
            os.close(descriptor)
        head = self._map[:16]
        self._slots, self._stride = struct.unpack_from("<II", head, 8)
        if head[:8] != MAGIC or self._slots == 0 or self._stride % 64 or SLOTS_AT + self._slots * self._stride > len(self._map):
            raise ValueError("no ring is in that memory")
        self._words = memoryview(self._map).cast("Q")  # each read of one is one load
        self.next, self.lost = 0, 0

    def read(self) -> Optional[Tuple[int, bytes]]:
        """Type and payload of the next message; None where it has not been written yet."""
        while True:
            at = SLOTS_AT + self.next % self._slots * self._stride
            stamp = self._words[at // 8]
            if stamp < 2 * self.next + 2:
                return None
            if stamp == 2 * self.next + 2:
                size, kind = struct.unpack_from("<IH", self._map, at + 8)
                data = self._map[at + SLOT_HEAD:at + SLOT_HEAD + min(size, self._stride - SLOT_HEAD)]
                if self._words[at // 8] == stamp:
                    self.next += 1
                    return kind, data
            to = max(0, self._words[COUNT_AT // 8] - self._slots // 2)  # the writer has come round
            if to <= self.next:
                return None
            self.lost += to - self.next
            self.next = to

    def wait(self, timeout_s: float) -> Tuple[int, bytes]:
        """The same, waiting for it; TimeoutError if it does not come in time."""
        end = time.monotonic() + timeout_s
        while (got := self.read()) is None:
            if time.monotonic() > end:
                raise TimeoutError("nothing was written into the ring")
            time.sleep(0.0002)
        return got

    def close(self) -> None:
        self._words.release()
        self._map.close()
