# SPDX-License-Identifier: MIT
"""A blocking client: one socket, one request at a time."""
import socket
from urllib.parse import urlsplit

from . import frame, gpstime, messages

VERSION = "1.0"


class ProtocolError(Exception):
    """The peer broke off, or does not speak this protocol: the connection is of no more use."""


class Refused(Exception):
    """The server answered with ERROR. code: an ErrorCode (or an int that this version does not know)."""

    def __init__(self, code, sentence):
        super().__init__(sentence)
        try:
            self.code = messages.ErrorCode(code)
        except ValueError:
            self.code = code


def sat_id(text):
    """The wire's satellite of "G05"."""
    text = text.strip().upper()
    if len(text) < 2 or not text[0].isalpha() or not text[1:].isdigit() or not 1 <= int(text[1:]) <= 99:
        raise ValueError(f"'{text}' is no satellite: G05 is wanted")
    return messages.SatId(ord(text[0]), int(text[1:]))


def sat_name(sat):
    """"G05" of the wire's satellite."""
    return f"{chr(sat.system)}{sat.number:02d}"


def connect(url, timeout_s):
    """A connected socket for tcp://HOST:PORT or unix:PATH."""
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
    if parts.scheme != "tcp":
        raise ValueError(f"'{url}' is no address: tcp://HOST:PORT or unix:PATH is wanted")
    sock = socket.create_connection((parts.hostname or "127.0.0.1", parts.port or messages.PORT), timeout_s)
    sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    return sock


class Client:
    """A conversation with a service. Says HELLO on connecting; `caps` is what the server answered."""

    def __init__(self, url, name="python", timeout_s=10.0):
        self._sock = connect(url, timeout_s)
        self._sequence = 0
        try:
            self.caps = self._ask(messages.Hello(messages.MAJOR, messages.MAJOR, name, VERSION), messages.Caps)
        except BaseException:
            self.close()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        self._sock.close()

    @property
    def span(self):
        """First and last instant served, as time tags."""
        return self.caps.span.first, self.caps.span.last

    @property
    def satellites(self):
        """Names of all satellites served, in the order of the answers."""
        return [sat_name(s) for s in self.caps.satellites]

    def ping(self, token=0):
        """Asks for a sign of life."""
        answer = self._ask(messages.Ping(token), messages.Pong)
        if answer.token != token:
            raise ProtocolError("the PONG is not that of this PING")

    def poll(self, t, step_s=0.0, count=1, satellites=()):
        """Yields the States of `count` epochs from t on, step_s apart (rounded to a nanosecond). t: a time tag (int) or a text
        of GPS time; satellites: names, empty for all. More epochs than one request may ask for are asked in several."""
        if isinstance(t, str):
            t = gpstime.from_text(t)
        step, sats = round(step_s * gpstime.NS_PER_S), [sat_id(s) for s in satellites]
        while count > 0:
            n = min(count, self.caps.max_epochs)
            self._send(messages.Poll(messages.Epochs(t, step, n), sats))
            for index in range(n):
                states = self._receive(messages.States)
                if states.index != index or states.count != n:
                    raise ProtocolError("an epoch of the answer is missing")
                yield states
            t, count = t + n * step, count - n

    def states(self, t, satellites=()):
        """The States of one epoch."""
        return next(iter(list(self.poll(t, satellites=satellites))))

    def poll_elements(self, t, step_s=0.0, count=1, frame="DATE", method="STATE", satellites=()):
        """Yields the Elements of `count` epochs, as poll does. frame: DATE, J2000 or ECEF; method: STATE, THREE_POSITIONS or
        MEAN (names, or values of ElementsFrame and ElementsMethod)."""
        if isinstance(t, str):
            t = gpstime.from_text(t)
        axes = messages.ElementsFrame[frame.upper()] if isinstance(frame, str) else frame
        way = messages.ElementsMethod[method.upper().replace("-", "_")] if isinstance(method, str) else method
        step, sats = round(step_s * gpstime.NS_PER_S), [sat_id(s) for s in satellites]
        while count > 0:
            n = min(count, self.caps.max_epochs)
            self._send(messages.PollElements(messages.Epochs(t, step, n), axes, way, sats))
            for index in range(n):
                elements = self._receive(messages.Elements)
                if elements.index != index or elements.count != n:
                    raise ProtocolError("an epoch of the answer is missing")
                yield elements
            t, count = t + n * step, count - n

    def elements(self, t, frame="DATE", method="STATE", satellites=()):
        """The Elements of one epoch."""
        return next(iter(list(self.poll_elements(t, frame=frame, method=method, satellites=satellites))))

    def poll_navdata(self, t, step_s=0.0, count=1, satellites=()):
        """Yields the Navdata of `count` epochs, as poll does: the broadcast sets on the air, and all subframes or strings of the
        frames that hold each epoch. Asked every 30 s it is the whole of what GPS satellites send, and GLONASS' too (whose frames
        begin at multiples of 30 s of UTC: take those whose frame_from is new)."""
        if isinstance(t, str):
            t = gpstime.from_text(t)
        step, sats = round(step_s * gpstime.NS_PER_S), [sat_id(s) for s in satellites]
        while count > 0:
            n = min(count, self.caps.max_epochs)
            self._send(messages.PollNavdata(messages.Epochs(t, step, n), sats))
            for index in range(n):
                navdata = self._receive(messages.Navdata)
                if navdata.index != index or navdata.count != n:
                    raise ProtocolError("an epoch of the answer is missing")
                yield navdata
            t, count = t + n * step, count - n

    def navdata(self, t, satellites=()):
        """The Navdata of one epoch."""
        return next(iter(list(self.poll_navdata(t, satellites=satellites))))

    def poll_delays(self, t, receiver_m=None, carriers_hz=(), step_s=0.0, count=1, satellites=()):
        """Yields the Delays of `count` epochs, as poll does. receiver_m: x, y, z (ecef), None for the scenario's own (of a
        scenario with a trajectory, where that is at each epoch); carriers_hz: at most four, empty for 1575.42 MHz."""
        if isinstance(t, str):
            t = gpstime.from_text(t)
        step, sats = round(step_s * gpstime.NS_PER_S), [sat_id(s) for s in satellites]
        place = [float("nan")] * 3 if receiver_m is None else [float(x) for x in receiver_m]
        while count > 0:
            n = min(count, self.caps.max_epochs)
            self._send(messages.PollDelays(messages.Epochs(t, step, n), place, [float(f) for f in carriers_hz], sats))
            for index in range(n):
                delays = self._receive(messages.Delays)
                if delays.index != index or delays.count != n:
                    raise ProtocolError("an epoch of the answer is missing")
                yield delays
            t, count = t + n * step, count - n

    def delays(self, t, receiver_m=None, carriers_hz=(), satellites=()):
        """The Delays of one epoch."""
        return next(iter(list(self.poll_delays(t, receiver_m, carriers_hz, satellites=satellites))))

    def poll_imu(self, t, step_s=0.0, count=1, unit=0):
        """Yields the Imu increments over `count` intervals of step_s from t on (0: the scenario's own interval; then one request
        asks for them all)."""
        if isinstance(t, str):
            t = gpstime.from_text(t)
        step = round(step_s * gpstime.NS_PER_S)
        while count > 0:
            n = min(count, self.caps.max_epochs)
            self._send(messages.PollImu(messages.Epochs(t, step, n), unit))
            last = None
            for index in range(n):
                last = self._receive(messages.Imu)
                if last.index != index or last.count != n:
                    raise ProtocolError("an interval of the answer is missing")
                yield last
            t, count = last.t1, count - n

    def poll_truth(self, t, step_s=0.0, count=1, unit=0):
        """Yields the Truth of a unit at `count` epochs, as poll does."""
        if isinstance(t, str):
            t = gpstime.from_text(t)
        step = round(step_s * gpstime.NS_PER_S)
        while count > 0:
            n = min(count, self.caps.max_epochs)
            self._send(messages.PollTruth(messages.Epochs(t, step, n), unit))
            for index in range(n):
                truth = self._receive(messages.Truth)
                if truth.index != index or truth.count != n:
                    raise ProtocolError("an epoch of the answer is missing")
                yield truth
            t, count = t + n * step, count - n

    def _send(self, message):
        self._sequence = self._sequence % (2**32 - 1) + 1  # never 0: that is the server's
        self._sock.sendall(frame.make(message.TYPE, self._sequence, message.encode()))

    def _receive(self, wanted):
        try:
            got = frame.read(self._receive_bytes)
        except frame.FrameError as error:
            raise ProtocolError(str(error)) from None
        if got.type == messages.Error.TYPE and got.sequence in (self._sequence, 0):
            error = got.message()
            raise Refused(error.code, error.sentence)
        if got.type != wanted.TYPE or got.sequence != self._sequence:
            raise ProtocolError(f"a message of type {got.type} that does not answer the request")
        return got.message()

    def _ask(self, message, wanted):
        self._send(message)
        return self._receive(wanted)

    def _receive_bytes(self, n):
        parts = []
        while n > 0:
            part = self._sock.recv(n)
            if not part:
                raise ProtocolError("the server closed the connection")
            parts.append(part)
            n -= len(part)
        return b"".join(parts)
