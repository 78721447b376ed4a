# SPDX-License-Identifier: MIT
"""What every client can do with a request that has epochs, whatever the message; verbs.py, which is generated, stands on it."""
from __future__ import annotations

import abc
import copy
from typing import ClassVar, Iterable, Iterator, Optional, Protocol, Type, TypeVar, Union

from . import messages
from .codec import WireEnum
from .gpstime import NS_PER_S

E = TypeVar("E", bound=WireEnum)
M = TypeVar("M", bound="Message")


class Message(Protocol):
    """A record with a message type of its own."""

    TYPE: ClassVar[int]

    def encode(self) -> bytes: ...

    @classmethod
    def decode(cls: Type[M], data: Union[bytes, bytearray, memoryview]) -> M: ...


class Request(Message, Protocol):
    """A message that asks for epochs."""

    epochs: messages.Epochs


class Reply(Message, Protocol):
    """A message that answers one of them."""

    epoch: messages.Epoch


A = TypeVar("A", bound=Reply)
Q = TypeVar("Q", bound=Request)


class Asking(abc.ABC):
    """How a client asks."""

    @abc.abstractmethod
    def _series(self, request: Request, reply: Type[A], count: int) -> Iterator[A]:
        """Yields the answers at count epochs: epochs.t of the request, and on by epochs.step. Their index and count are those of the
        whole series, in however many requests it was asked."""

    def _single(self, request: Request, reply: Type[A]) -> A:
        answers = list(self._series(request, reply, 1))
        return answers[0]


def from_epoch(request: Q, t: int, step: int, count: int) -> Q:
    """The request from another epoch on."""
    made = copy.copy(request)
    made.epochs = messages.Epochs(t, step, count)
    return made


def step_ns(step_s: float) -> int:
    return round(step_s * NS_PER_S)


def choice(kind: Type[E], value: Union[E, str]) -> E:
    """A member of an enumeration, by its name too."""
    if not isinstance(value, str):
        return kind(value)
    name = value.upper().replace("-", "_")
    if name not in kind.__members__:
        known = ", ".join(kind.__members__)
        raise ValueError(f"'{value}' is none of {known}")
    return kind[name]


def vector(values: Optional[Iterable[float]], n: int) -> list[float]:
    """So many numbers; NAN for None, which is how a request says that it names none."""
    made = [float("nan")] * n if values is None else [float(x) for x in values]
    if len(made) != n:
        raise ValueError(f"{n} numbers are wanted, not {len(made)}")
    return made


def next_epoch(answer: Reply, step: int) -> int:
    """Where a series goes on after an answer: an interval's end, or step on."""
    end = getattr(answer, "t1", None)
    return end if isinstance(end, int) else answer.epoch.t + step
