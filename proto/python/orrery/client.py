# SPDX-License-Identifier: MIT
"""A blocking client over one socket. Answers may be read in any order: a loop over poll() may ask for something else in its
body, and may be left early."""
from __future__ import annotations

import collections
import os
import select
import socket
import ssl
from types import TracebackType
from typing import Deque, Dict, Iterator, Optional, Type, Union
from urllib.parse import urlsplit

from . import frame, messages
from ._version import __version__
from .asking import A, M, Message, Request, choice, from_epoch, next_epoch, step_ns
from .codec import CodecError
from .datagrams import MotionSender, Port, Reader
from .gpstime import NONE, Time, time_tag
from .ring import MotionRing, Ring
from .satellite import sat_id, sat_name
from .stream import Stream
from .verbs import Verbs

__all__ = ["Client", "ProtocolError", "Refused", "connect", "sat_id", "sat_name"]

EPOCHS_A_REQUEST = 500  # a longer series is asked in several requests, so that what is left of one is soon read over


class ProtocolError(Exception):
    """The peer broke off, or does not speak this protocol: the connection is of no more use."""


class Refused(Exception):
    """The server answered with ERROR. code: an ErrorCode."""

    def __init__(self, code: int, sentence: str) -> None:
        super().__init__(sentence)
        self.code = messages.ErrorCode(code)


def _secure(sock: socket.socket, host: str, identity: Optional[str]) -> socket.socket:
    """TLS 1.3 over a connected socket, with certificates of both sides."""
    identity = identity or os.environ.get("ORRERY_IDENTITY")
    if not identity:
        raise ValueError("tls:// wants an identity: NAME.pem, as 'orrery tls init' makes it")
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
    context.minimum_version = ssl.TLSVersion.TLSv1_3
    context.load_verify_locations(os.path.join(os.path.dirname(identity), "ca.pem"))
    context.load_cert_chain(identity)
    return context.wrap_socket(sock, server_hostname=host)


def connect(url: str, timeout_s: float, identity: Optional[str] = None) -> socket.socket:
    """A connected socket for tcp://HOST:PORT, tls://HOST:PORT or unix:PATH. identity: for tls://, a file with the client's certificate and
    key, with ca.pem beside it; the environment variable ORRERY_IDENTITY by default."""
    if url.startswith("unix:"):
        path = url[5:]
        if path.startswith("///"):
            path = path[2:]
        sock = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        sock.settimeout(timeout_s)
        try:
            sock.connect(path)
        except OSError:
            sock.close()
            raise
        return sock
    parts = urlsplit(url)
    if parts.scheme not in ("tcp", "tls"):
        raise ValueError(f"'{url}' is no address: tcp://HOST:PORT, tls://HOST:PORT or unix:PATH is wanted")
    host = parts.hostname or "127.0.0.1"
    sock = socket.create_connection((host, parts.port or messages.PORT), timeout_s)
    try:
        sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        return _secure(sock, host, identity) if parts.scheme == "tls" else sock
    except BaseException:
        sock.close()
        raise


class Client(Verbs):
    """A conversation with a service. Says HELLO on connecting; `caps` is what the server answered. OSError (TimeoutError among them),
    ProtocolError and Refused are what its methods raise; after a timeout and after most refusals it can be asked on."""

    def __init__(self, url: str, name: str = "python", timeout_s: float = 10.0, identity: Optional[str] = None) -> None:
        self._sequence = 0
        self._read = bytearray()  # received, and not yet a whole frame
        self._inbox: Dict[int, Deque[frame.Frame]] = {}  # of requests whose answers somebody still waits for
        self._motions: Deque[int] = collections.deque(maxlen=4096)  # samples that were sent last, by their sequence numbers
        self.motion_refusals: Deque[Refused] = collections.deque(maxlen=256)  # of samples, as far as they have come: the last of them
        self._closed = ""  # why it is of no more use
        self._descriptors: list[int] = []  # that came along with bytes, of rings
        self._sock = connect(url, timeout_s, identity)
        try:
            self.caps = self._ask(messages.Hello(messages.MAJOR, messages.MAJOR, name, __version__), messages.Caps)
        except BaseException:
            self.close()
            raise

    def __enter__(self) -> Client:
        return self

    def __exit__(self, kind: Optional[Type[BaseException]], error: Optional[BaseException], trace: Optional[TracebackType]) -> None:
        self.close()

    def close(self) -> None:
        self._closed = self._closed or "it was closed"
        self._sock.close()
        while self._descriptors:
            os.close(self._descriptors.pop())

    @property
    def span(self) -> tuple[int, int]:
        """First and last instant served, as time tags."""
        return self.caps.span.first, self.caps.span.last

    @property
    def satellites(self) -> list[str]:
        """Names of all satellites served, in the order of the answers."""
        return [sat_name(s) for s in self.caps.satellites]

    def ping(self, token: int = 0) -> None:
        """Asks whether the server is alive."""
        if self._ask(messages.Ping(token), messages.Pong).token != token:
            raise self._broken("the PONG is not that of this PING")

    def subscribe(self, request: Union[Request, messages.GetModes], t: Optional[Time] = None, step_s: float = 0.0, count: int = 0,
                  pacing: Union[messages.Pacing, str] = messages.Pacing.CLOCK, lead_s: float = 0.0, credit: int = 64,
                  window: Optional[int] = None, ring: bool = False, datagrams: bool = False) -> Stream:
        """A stream of the blocks that answer `request` (a Poll, PollChannels, ...; its epochs are those given here): from t on (None: the
        next one), step_s apart (0: every block of channels once), `count` of them (0: without end). pacing: "clock", each lead_s before
        the scenario clock shows its instant, or "free". credit: how many may come before there is more; the stream renews it as they
        are read, up to `window` (that of `credit` if None; 0: you call Stream.credit). ring: they come in shared memory, over a Unix socket
        alone; datagrams: they come by UDP to this machine's address, sealed where the connection has TLS. Of both a reader that is too slow,
        or out of luck, loses blocks (Stream.lost). GetModes has neither t nor step: what it tells comes when modes change."""
        if ring and datagrams:
            raise ValueError("a stream comes in a ring or as datagrams, not both")
        port = Port(self._sock) if datagrams else None
        try:
            return self._subscribe(request, t, step_s, count, choice(messages.Pacing, pacing), lead_s, credit, window, ring, port)
        except BaseException:
            if port is not None:
                port.close()
            raise

    def _subscribe(self, request: Union[Request, messages.GetModes], t: Optional[Time], step_s: float, count: int, pacing: messages.Pacing, lead_s: float, credit: int,
                   window: Optional[int], ring: bool, port: Optional[Port]) -> Stream:
        delivery = messages.Delivery.RING if ring else messages.Delivery.DATAGRAMS if port is not None else messages.Delivery.FRAMES
        key = self.datagrams().keys[32:] if port is not None and isinstance(self._sock, ssl.SSLSocket) else b""
        poll = request if isinstance(request, messages.GetModes) else from_epoch(request, NONE if t is None else time_tag(t), step_ns(step_s), count)
        asked = messages.Subscribe(request=request.TYPE, pacing=pacing, delivery=delivery, credit=credit, lead=step_ns(lead_s),
                                   poll=poll.encode(), port=port.number if port is not None else 0)
        number = self._send(asked)
        self._inbox[number] = collections.deque()
        try:
            told = self._decode(self._next_frame(number), messages.Subscribed)
        except BaseException:
            self._inbox.pop(number, None)
            raise
        memory = Ring(self._descriptors.pop(0)) if ring else None
        if port is not None:
            port.reader = Reader(told.channel, key)
        return Stream(self, number, told, request, credit if window is None else window, memory, port)

    def datagrams(self) -> messages.Datagrams:
        """The connection's channel of datagrams: its keys, and what has become of what was sent in it."""
        return self._ask(messages.OpenDatagrams(), messages.Datagrams)

    def motion_ring(self) -> MotionRing:
        """Sends motion through shared memory, over a Unix socket alone; once a connection. It is the caller's to close."""
        self.motion_ring_counts()
        if len(self._descriptors) < 2:
            raise ValueError("this connection has its ring of motion already")
        return MotionRing(self._descriptors.pop(0), self._descriptors.pop(0))

    def motion_ring_counts(self) -> messages.MotionRing:
        """What has become of what was written into the ring of motion."""
        return self._ask(messages.OpenMotionRing(), messages.MotionRing)

    def motion_datagrams(self) -> MotionSender:
        """Sends motion by UDP, sealed where the connection has TLS; it is the caller's to close, and ends with the connection."""
        return MotionSender(self._sock, self.datagrams())

    def modes(self, after: int = 0) -> messages.Modes:
        """Mode changes of the service (clock, what paces it, lock to a generator, live motion) behind number `after`, at most 100; `last` is
        what to ask on from. They can be subscribed to as well: subscribe(messages.GetModes(after))."""
        return self._ask(messages.GetModes(after), messages.Modes)

    def time(self) -> messages.Time:
        """What the scenario's clock shows."""
        return self._ask(messages.GetTime(), messages.Time)

    def control(self, action: Union[messages.ControlAction, str], t: Optional[Time] = None, at: Optional[Time] = None,
                delay_s: float = 0.0, reference: Union[messages.ClockReference, str] = messages.ClockReference.WALL,
                scenario: str = "") -> messages.Time:
        """Controls the scenario's clock: "load", "arm", "wait_pps", "start", "pause", "stop" (CONTROL in docs/protocol.md). With "load"
        and the name of another scenario the server closes all connections, and serves that one when it is ready."""
        asked = messages.Control(choice(messages.ControlAction, action), choice(messages.ClockReference, reference), 0,
                                 NONE if t is None else time_tag(t), NONE if at is None else time_tag(at), step_ns(delay_s), scenario)
        return self._ask(asked, messages.Time)

    def radio_time(self, elapsed_ns: int, stamp_ns: int = 0,
                   clock: Union[messages.StampClock, str] = messages.StampClock.ARRIVAL) -> messages.Pace:
        """Tells the generator's elapsed time, and what a clock of the server's host showed then."""
        return self._ask(messages.RadioTime(elapsed_ns, stamp_ns, choice(messages.StampClock, clock)), messages.Pace)

    def motion(self, sample: messages.Motion, check: bool = False) -> None:
        """Sends a sample of the live motion. It does not wait for what the server thinks of it: a refusal comes to motion_refusals while this
        client sends further samples or reads anything, and is counted by the server (motion_stats). check: waits, and raises it (Refused)."""
        number = self._send(sample)
        self._motions.append(number)
        if check:
            self._inbox[number] = collections.deque()
            try:
                self.time()  # the server answers both in their order
                if self._inbox[number]:
                    self._decode(self._inbox[number].popleft(), messages.Pong)
            finally:
                del self._inbox[number]
        else:
            self._take_in()

    def _take_in(self) -> None:
        """Takes what has come already."""
        pending = isinstance(self._sock, ssl.SSLSocket) and self._sock.pending() > 0
        if pending or select.select([self._sock], [], [], 0)[0]:
            self._fill(len(self._read) + 1)
        while self._has_frame():
            self._keep(self._read_frame())

    def motion_stats(self, reset: bool = False) -> messages.MotionStats:
        """What became of the samples of motion."""
        return self._ask(messages.GetMotionStats(int(reset)), messages.MotionStats)

    def _series(self, request: Request, reply: Type[A], count: int) -> Iterator[A]:
        if count < 0:
            raise ValueError(f"a series of {count} epochs")
        return self._answers(request, reply, count)

    def _answers(self, request: Request, reply: Type[A], count: int) -> Iterator[A]:
        t, step, done = request.epochs.t, request.epochs.step, 0
        while done < count:
            n = min(count - done, self.caps.max_epochs, EPOCHS_A_REQUEST)
            sequence = self._send(from_epoch(request, t, step, n))
            self._inbox[sequence] = collections.deque()
            try:
                for index in range(n):
                    answer = self._decode(self._next_frame(sequence), reply)
                    if answer.epoch.index != index or answer.epoch.count != n:
                        raise self._broken("an epoch of the answer is missing")
                    answer.epoch.index, answer.epoch.count = done, count
                    t, done = next_epoch(answer, step), done + 1
                    yield answer
            finally:
                del self._inbox[sequence]  # what still comes of it is read over

    def _send(self, message: Message) -> int:
        """The sequence number that it was sent with."""
        if self._closed:
            raise ProtocolError(f"the connection is of no more use: {self._closed}")
        data = message.encode()
        self._sequence = self._sequence % (2**32 - 1) + 1  # never 0: that is the server's
        try:
            self._sock.sendall(frame.make(message.TYPE, self._sequence, data))
        except OSError as error:  # part of it may have been sent
            self._broken(str(error))
            raise
        return self._sequence

    def _ask(self, message: Message, wanted: Type[M]) -> M:
        return self._decode(self._next_frame(self._send(message)), wanted)

    def _receive(self, wanted: Type[M]) -> M:
        """The next answer to the request that was sent last."""
        return self._decode(self._next_frame(self._sequence), wanted)

    def _decode(self, got: frame.Frame, wanted: Type[M]) -> M:
        try:
            if got.type == messages.Error.TYPE:
                error = messages.Error.decode(got.payload)
                refusal = Refused(error.code, error.sentence)
                if refusal.code.closes:
                    self._broken(error.sentence)
                raise refusal
            if got.type != wanted.TYPE:
                raise self._broken(f"a message of type {got.type} that does not answer the request")
            return wanted.decode(got.payload)
        except CodecError as error:
            raise self._broken(str(error)) from None

    def _next_frame(self, sequence: int) -> frame.Frame:
        """The next frame that answers a request."""
        if self._inbox.get(sequence):
            return self._inbox[sequence].popleft()
        while True:
            got = self._read_frame()
            if got.sequence == sequence or (got.sequence == 0 and got.type == messages.Error.TYPE):
                return got
            self._keep(got)

    def _keep(self, got: frame.Frame) -> None:
        """Frames of other requests are kept for whom waits for them, or read over."""
        if got.sequence in self._inbox:
            self._inbox[got.sequence].append(got)
        elif got.type == messages.Error.TYPE and got.sequence in self._motions:
            error = messages.Error.decode(got.payload)
            self.motion_refusals.append(Refused(error.code, error.sentence))
        elif not 0 < got.sequence <= self._sequence:
            raise self._broken(f"an answer to request {got.sequence}, which was never sent")

    def _wait(self, other: socket.socket, timeout_s: float) -> None:
        """Waits until another socket has something, or the connection has; frames of that are kept."""
        buffered = isinstance(self._sock, ssl.SSLSocket) and self._sock.pending() > 0
        ready = select.select([other, self._sock], [], [], 0 if buffered or self._has_frame() else timeout_s)[0]
        if buffered or self._sock in ready:
            self._fill(len(self._read) + 1)
        while self._has_frame():
            self._keep(self._read_frame())

    def _has_frame(self) -> bool:
        head = frame.HEADER.size
        return len(self._read) >= head and len(self._read) >= frame.OVERHEAD + frame.HEADER.unpack_from(self._read)[5]

    def _read_frame(self) -> frame.Frame:
        try:
            self._fill(frame.HEADER.size)
            total = frame.OVERHEAD + frame.check_header(bytes(self._read[:frame.HEADER.size]))[2]
            self._fill(total)
            data = bytes(self._read[:total])
            del self._read[:total]
            return frame.parse(data)
        except frame.FrameError as error:
            raise self._broken(str(error)) from None

    def _fill(self, n: int) -> None:
        """Receives until n bytes are there. What was received before a timeout stays."""
        while len(self._read) < n:
            if self._closed:
                raise ProtocolError(f"the connection is of no more use: {self._closed}")
            try:
                part = self._receive_part(max(65536, n - len(self._read)))
            except TimeoutError:
                raise
            except OSError as error:
                self._broken(str(error))
                raise
            if not part:
                raise self._broken("the server closed the connection")
            self._read += part

    def _receive_part(self, n: int) -> bytes:
        if self._sock.family != socket.AF_UNIX:
            return self._sock.recv(n)
        part, descriptors, _, _ = socket.recv_fds(self._sock, n, 4)
        self._descriptors += descriptors
        return part

    def _broken(self, why: str) -> ProtocolError:
        self._closed = self._closed or why
        self._sock.close()
        return ProtocolError(why)
