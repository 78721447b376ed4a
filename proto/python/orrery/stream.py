# SPDX-License-Identifier: MIT
"""Streams of a client: blocks that come by themselves. An iterator over what a SUBSCRIBE asks for; other requests, and other streams of
the same client, may be used in between."""
from __future__ import annotations

from typing import TYPE_CHECKING, Iterator, Optional, Type

from . import frame, messages
from .asking import Message, Request

if TYPE_CHECKING:
    from .client import Client

BLOCKS = {messages.Poll.TYPE: messages.States, messages.PollNavdata.TYPE: messages.Navdata, messages.PollChannels.TYPE: messages.Channels,
          messages.PollImu.TYPE: messages.Imu, messages.PollTruth.TYPE: messages.Truth}


class Stream:
    """Made by Client.subscribe. Iterating gives the blocks, until the stream ends: `end` is then the StreamEnd. `gaps` are the Gap notices so
    far, `payload` the bytes of the last block. With credit of its own accord (window > 0) it lets so many blocks be on their way."""

    def __init__(self, client: Client, number: int, told: messages.Subscribed, request: Request, window: int) -> None:
        self.number, self.first, self.step = number, told.first, told.step
        self.gaps: list[messages.Gap] = []
        self.end: Optional[messages.StreamEnd] = None
        self.payload = b""
        self._client, self._window, self._spent = client, window, 0
        self._kind: Type[Message] = BLOCKS[request.TYPE]

    def __iter__(self) -> Iterator[Message]:
        while (block := self.next()) is not None:
            yield block

    def next(self) -> Optional[Message]:
        """The next block; None behind the last one. TimeoutError if none comes in time: it can be asked on after that."""
        while self.end is None:
            got = self._client._next_frame(self.number)
            block = self._take(got)
            if block is not None:
                return block
        return None

    def _take(self, got: frame.Frame) -> Optional[Message]:
        if got.type == messages.Gap.TYPE:
            self.gaps.append(self._client._decode(got, messages.Gap))
        elif got.type == messages.StreamEnd.TYPE:
            self.end = self._client._decode(got, messages.StreamEnd)
            self._client._inbox.pop(self.number, None)
        else:
            self.payload = bytes(got.payload)
            self._spent += 1
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

