# SPDX-License-Identifier: MIT
"""Streams of a client: blocks that come by themselves. An iterator over what a SUBSCRIBE asks for; other requests, and other streams of
the same client, may be used in between."""
from __future__ import annotations

import time
from typing import TYPE_CHECKING, Iterator, Optional, Type

from . import frame, messages
from .asking import Message
from .datagrams import Port
from .ring import Ring

if TYPE_CHECKING:
    from .client import Client

BLOCKS = {messages.Poll.TYPE: messages.States, messages.PollNavdata.TYPE: messages.Navdata, messages.PollChannels.TYPE: messages.Channels,
          messages.PollImu.TYPE: messages.Imu, messages.PollTruth.TYPE: messages.Truth,
          messages.PollEvents.TYPE: messages.Events, messages.GetModes.TYPE: messages.Modes}
AGAIN_S, TAIL_S = 1.0, 0.1  # without a datagram for so long there is credit anew; what is still on its way behind the stream's end


class Stream:
    """Made by Client.subscribe. Iterating gives the blocks, until the stream ends: `end` is then the StreamEnd. `gaps` are the Gap notices so
    far, `payload` the bytes of the last block. With credit of its own accord (window > 0) it lets so many blocks be on their way."""

    def __init__(self, client: Client, number: int, told: messages.Subscribed, request: Message, window: int,
                 ring: Optional[Ring] = None, port: Optional[Port] = None) -> None:
        self.number, self.first, self.step = number, told.first, told.step
        self.gaps: list[messages.Gap] = []
        self.end: Optional[messages.StreamEnd] = None
        self.payload = b""
        self._client, self._window, self._spent = client, window, 0
        self._kind: Type[Message] = BLOCKS[request.TYPE]
        self._ring, self._port, self._paid = ring, port, 0
        self._last: Optional[frame.Frame] = None  # the STREAM_END, while what it has overtaken is waited for
        self._until = 0.0

    def __iter__(self) -> Iterator[Message]:
        while (block := self.next()) is not None:
            yield block

    @property
    def lost(self) -> int:
        """Blocks of a ring that went by unread; datagrams that have not come, or not yet."""
        if self._port is not None and self._port.reader is not None:
            return self._port.reader.missing
        return self._ring.lost if self._ring is not None else 0

    def next(self) -> Optional[Message]:
        """The next block; None behind the last one. TimeoutError if none comes in time: it can be asked on after that."""
        while self.end is None:
            if self._port is not None:
                got = self._from_port(self._port)
            else:
                got = self._client._next_frame(self.number) if self._ring is None else self._from_ring(self._ring)
            block = self._take(got)
            if block is not None:
                return block
        return None

    def _from_ring(self, ring: Ring) -> frame.Frame:
        kind, payload = ring.wait(self._client._sock.gettimeout() or 10.0)
        return frame.Frame(kind, self.number, payload)

    def _from_port(self, port: Port) -> frame.Frame:
        """Datagrams as they come, and notices of the connection in between. The STREAM_END, by whichever way, waits a moment for what it has
        overtaken."""
        give_up = time.monotonic() + (self._client._sock.gettimeout() or 10.0)
        quiet = time.monotonic() + AGAIN_S
        while True:
            notices, got = self._client._inbox.get(self.number), port.take()
            if got is None and notices:
                got = notices.popleft()
            now = time.monotonic()
            if got is not None and got.type == messages.StreamEnd.TYPE:
                if self._last is None:
                    self._last, self._until = got, now + TAIL_S
            elif got is not None:
                return got
            if self._last is not None and (now > self._until or (got is not None and port.reader is not None and port.reader.missing == 0)):
                return self._last
            if now > give_up:
                raise TimeoutError("no datagram came")
            if now > quiet and self._window > 0 and self._last is None:
                self.credit(self._window)  # what was let out may all have been lost
                quiet = now + AGAIN_S
            self._client._wait(port.socket, max(0.0, min(give_up, quiet, self._until or give_up) - now) + 0.001)

    def _take(self, got: frame.Frame) -> Optional[Message]:
        if got.type == messages.Gap.TYPE:
            gap = self._client._decode(got, messages.Gap)
            if all(gap.first != known.first for known in self.gaps):  # of datagrams they come by the connection too
                self.gaps.append(gap)
        elif got.type == messages.StreamEnd.TYPE:
            self.end = self._client._decode(got, messages.StreamEnd)
            self._client._inbox.pop(self.number, None)
            if self._ring is not None:
                self._ring.close()
            if self._port is not None:
                self._port.close()
        else:
            self.payload = bytes(got.payload)
            self._spent += 1
            if self._port is not None and self._port.reader is not None:  # what was lost had its credit too
                self._spent, self._paid = self._spent - 1 + self._port.reader.greatest - self._paid, self._port.reader.greatest
            if 0 < self._window <= 2 * self._spent:
                self.credit(self._spent)
            return self._client._decode(got, self._kind)
        return None

    def credit(self, blocks: int) -> None:
        """Lets so many blocks more be sent."""
        self._spent = 0
        self._client._send(messages.Credit(self.number, blocks))

    def unsubscribe(self) -> messages.StreamEnd:
        """Ends it; what was on its way is read over."""
        if self.end is None:
            self._client._send(messages.Unsubscribe(self.number))
            self._window = 0
            while self.next() is not None:
                pass
        assert self.end is not None
        return self.end

