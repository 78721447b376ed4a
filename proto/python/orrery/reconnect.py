# SPDX-License-Identifier: MIT
"""A client that outlives its connection. A poll names its epochs and its answer is the same bytes whenever it is asked, so that
what a lost connection left unanswered can simply be asked again."""
from __future__ import annotations

import logging
import random
import time
from types import TracebackType
from typing import Callable, Iterator, Optional, Type, TypeVar

from . import messages
from .asking import A, Request, from_epoch, next_epoch
from .client import Client, ProtocolError, Refused
from .verbs import Verbs

T = TypeVar("T")
LOG = logging.getLogger("orrery")


class ReconnectingClient(Verbs):
    """As Client, with the same methods; connects when it is first needed, and again whenever the connection is lost. After each failure
    it waits, first_delay_s and twice as long each time, up to longest_delay_s, less up to half of it by chance (so that many clients
    do not come back at once). `attempts` failures without an answer in between end it: the last one is raised. What happens is told
    to the logger "orrery"."""

    def __init__(self, url: str, name: str = "python", timeout_s: float = 10.0, attempts: int = 8, first_delay_s: float = 0.1,
                 longest_delay_s: float = 5.0, sleep: Callable[[float], object] = time.sleep,
                 identity: Optional[str] = None) -> None:
        if attempts < 1:
            raise ValueError("at least one attempt is needed")
        self.url, self.name, self.timeout_s, self.attempts, self.identity = url, name, timeout_s, attempts, identity
        self.first_delay_s, self.longest_delay_s, self._sleep = first_delay_s, longest_delay_s, sleep
        self._client: Optional[Client] = None
        self._caps: Optional[messages.Caps] = None

    def __enter__(self) -> ReconnectingClient:
        return self

    def __exit__(self, kind: Optional[Type[BaseException]], error: Optional[BaseException], trace: Optional[TracebackType]) -> None:
        self.close()

    def close(self) -> None:
        """It can be asked on after this: it would connect again."""
        if self._client is not None:
            self._client.close()
        self._client = None

    @property
    def caps(self) -> messages.Caps:
        """What the server said on the latest connecting."""
        return self._caps if self._caps is not None else self._repeat(lambda client: client.caps)

    @property
    def span(self) -> tuple[int, int]:
        """First and last instant served, as time tags."""
        return self.caps.span.first, self.caps.span.last

    @property
    def satellites(self) -> list[str]:
        """Names of all satellites served, in the order of the answers."""
        return [str(s) for s in self.caps.satellites]

    def ping(self, token: int = 0) -> None:
        """Asks whether the server is alive."""
        self._repeat(lambda client: client.ping(token))

    def _repeat(self, work: Callable[[Client], T]) -> T:
        failures = 0
        while True:
            client: Optional[Client] = None
            try:
                client = self._connected()
                return work(client)
            except (OSError, ProtocolError, Refused) as error:
                failures += 1
                self._lost(client, error, failures)

    def _series(self, request: Request, reply: Type[A], count: int) -> Iterator[A]:
        if count < 0:
            raise ValueError(f"a series of {count} epochs")
        return self._answers(request, reply, count)

    def _answers(self, request: Request, reply: Type[A], count: int) -> Iterator[A]:
        t, step, done, failures = request.epochs.t, request.epochs.step, 0, 0
        while done < count:
            client: Optional[Client] = None
            try:
                client = self._connected()
                rest = from_epoch(request, t, step, 1)
                for answer in client._series(rest, reply, count - done):
                    answer.epoch.index, answer.epoch.count = done, count
                    t, done, failures = next_epoch(answer, step), done + 1, 0
                    yield answer
            except (OSError, ProtocolError, Refused) as error:
                failures += 1
                self._lost(client, error, failures)

    def _connected(self) -> Client:
        if self._client is None:
            self._client = Client(self.url, self.name, self.timeout_s, self.identity)
            LOG.info("%s: connected to %s %s", self.url, self._client.caps.name, self._client.caps.version)
            if self._caps is not None and self._caps != self._client.caps:
                LOG.warning("%s: it serves something else than before; answers may not go together with earlier ones", self.url)
            self._caps = self._client.caps
        return self._client

    def _lost(self, client: Optional[Client], error: Exception, failures: int) -> None:
        """Gets ready for the next attempt, or raises the error: attempts are used up, or another one would not help."""
        if isinstance(error, Refused) and (not error.code.closes or error.code == messages.ErrorCode.BAD_VERSION):
            raise error
        if client is not None:
            client.close()
        if client is self._client:  # and not another one that was made meanwhile
            self._client = None
        if failures >= self.attempts:
            LOG.error("%s: %s; given up after %d attempts", self.url, error, failures)
            raise error
        delay = min(self.longest_delay_s, self.first_delay_s * 2.0**(failures - 1)) * random.uniform(0.5, 1.0)
        LOG.warning("%s: %s; attempt %d of %d in %.2f s", self.url, error, failures + 1, self.attempts, delay)
        self._sleep(delay)
