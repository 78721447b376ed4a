# SPDX-License-Identifier: GPL-3.0-or-later
"""A bad network between two network namespaces: two veth pairs, and between them a relay of frames whose draws are seeded. It loses, delays,
duplicates and reorders UDP; it delays TCP, cuts its segments in two, and resets a connection when told. No right but that of a user namespace
is needed."""
import ctypes
import fcntl
import heapq
import os
import random
import select
import socket
import struct
import subprocess
import sys
import threading
import time

CLONE_NEWNET, ETH_P_ALL, OUTGOING, SIOCETHTOOL = 0x40000000, 3, 4, 0x8946
OFFLOADS = (0x17, 0x1F, 0x24, 0x2C)  # transmit checksums, TSO, GSO, GRO: frames are to be what goes over a wire
SERVER, CLIENT = "10.77.0.1", "10.77.0.2"
TCP, UDP = 6, 17


def enter_own_namespaces():
    """Begins the program anew as root of a user namespace and a network namespace of its own; returns there. None where the machine has none."""
    if os.environ.get("ORRERY_RELAY") == "1":
        return True
    words = ["unshare", "-Urn", "--"]
    try:
        if subprocess.run(words + ["ip", "link"], capture_output=True, timeout=20, check=False).returncode != 0:
            return False
    except (OSError, subprocess.TimeoutExpired):
        return False
    os.environ["ORRERY_RELAY"] = "1"
    os.execvp(words[0], words + [sys.executable, "-B", *sys.argv])
    return False


def ip(*words, inside=None):
    prefix = ["nsenter", "-t", str(inside), "-n"] if inside else []
    subprocess.run([*prefix, "ip", *words], check=True, timeout=20)


def switch_off(names):
    """Offloads of interfaces of this thread's namespace."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as s:
        for name in names:
            for command in OFFLOADS:
                value = ctypes.create_string_buffer(struct.pack("=II", command, 0))
                try:
                    fcntl.ioctl(s, SIOCETHTOOL, struct.pack("=16sQ", name.encode(), ctypes.addressof(value)))
                except OSError:
                    pass  # what there is not need not be switched off


def join(pid):
    """This thread's sockets are those of another process's network from now on."""
    with open(f"/proc/{pid}/ns/net", encoding="ascii") as ns:
        if ctypes.CDLL(None, use_errno=True).setns(ns.fileno(), CLONE_NEWNET) != 0:
            raise OSError(ctypes.get_errno(), "setns")


def checksum(data):
    if len(data) % 2:
        data += b"\0"
    total = sum(struct.unpack(f"!{len(data) // 2}H", data))
    while total >> 16:
        total = (total & 0xFFFF) + (total >> 16)
    return ~total & 0xFFFF


class Segment:
    """A TCP segment in an Ethernet frame over IPv4."""

    def __init__(self, frame):
        self.eth, self.ip_size = frame[:14], (frame[14] & 15) * 4
        self.ip = frame[14:14 + self.ip_size]
        total = struct.unpack_from("!H", self.ip, 2)[0]
        body = frame[14 + self.ip_size:14 + total]
        self.size = (body[12] >> 4) * 4
        self.tcp, self.payload = body[:self.size], body[self.size:]
        self.seq, self.ack = struct.unpack_from("!II", self.tcp, 4)
        self.flags = self.tcp[13]
        self.ports = struct.unpack_from("!HH", self.tcp, 0)

    def made(self, seq, flags, payload):
        """The frame of this segment with other contents."""
        head = bytearray(self.ip)
        struct.pack_into("!H", head, 2, self.ip_size + self.size + len(payload))
        struct.pack_into("!H", head, 10, 0)
        struct.pack_into("!H", head, 10, checksum(bytes(head)))
        tcp = bytearray(self.tcp)
        struct.pack_into("!I", tcp, 4, seq)
        tcp[13] = flags
        struct.pack_into("!H", tcp, 16, 0)
        pseudo = self.ip[12:20] + struct.pack("!BBH", 0, TCP, len(tcp) + len(payload))
        struct.pack_into("!H", tcp, 16, checksum(pseudo + bytes(tcp) + payload))
        return self.eth + bytes(head) + bytes(tcp) + payload

    def back(self, seq):
        """A reset to whom it comes from."""
        s = Segment(self.made(seq, 0x14, b""))
        s.eth = s.eth[6:12] + s.eth[:6] + s.eth[12:]
        s.ip = s.ip[:12] + s.ip[16:20] + s.ip[12:16] + s.ip[20:]
        s.tcp = s.tcp[2:4] + s.tcp[:2] + s.tcp[4:]
        return s.made(seq, 4, b"")


class Relay:
    """`with Relay(seed) as r:` joins the namespaces of r.server (a process) and this thread, which becomes the client's. Rates may be changed at
    any time; `dropped`, `doubled`, `cut`, `resets` count."""

    def __init__(self, seed):
        self._draw = random.Random(seed)
        self.loss = self.double = self.cutting = 0.0
        self.jitter_s = self.tcp_delay_s = 0.0
        self.dropped, self.doubled, self.cut, self.resets = {SERVER: 0, CLIENT: 0}, {SERVER: 0, CLIENT: 0}, 0, 0
        self._reset = threading.Event()
        self._stop = threading.Event()
        self._late, self._order = [], 0
        self._next = {}  # by the ports of what a client sends: the number that its server expects
        self._last = {0: 0.0, 1: 0.0}  # when the last TCP segment of a direction goes on

    def __enter__(self):
        self._holders = [subprocess.Popen(["unshare", "-n", "sleep", "600"]) for _ in range(2)]
        self.server = self._holders[0].pid
        own = os.readlink("/proc/self/ns/net")
        for holder, name, address in zip(self._holders, ("s", "c"), (SERVER, CLIENT)):
            while os.readlink(f"/proc/{holder.pid}/ns/net") == own:
                time.sleep(0.01)
            ip("link", "add", f"{name}0", "type", "veth", "peer", "name", f"{name}1")
            switch_off((f"{name}0", f"{name}1"))
            ip("link", "set", f"{name}0", "netns", str(holder.pid))
            ip("link", "set", f"{name}1", "up")
            for words in (("addr", "add", f"{address}/24", "dev", f"{name}0"), ("link", "set", "lo", "up"), ("link", "set", f"{name}0", "up")):
                ip(*words, inside=holder.pid)
        self._sockets = []
        for name in ("s1", "c1"):
            s = socket.socket(socket.AF_PACKET, socket.SOCK_RAW, socket.htons(ETH_P_ALL))
            s.bind((name, 0))
            s.setblocking(False)
            self._sockets.append(s)
        self._thread = threading.Thread(target=self._run)
        self._thread.start()
        join(self._holders[1].pid)
        return self

    def __exit__(self, *_):
        self._stop.set()
        self._thread.join()
        for s in self._sockets:
            s.close()
        for holder in self._holders:
            holder.kill()
            holder.wait()

    def reset(self):
        """The next TCP data on its way to the client becomes a reset, to both ends."""
        self._reset.set()

    def _run(self):
        while not self._stop.is_set():
            wait = max(0.0, min(0.05, self._late[0][0] - time.monotonic())) if self._late else 0.05
            for s in select.select(self._sockets, [], [], wait)[0]:
                self._take(self._sockets.index(s))
            while self._late and self._late[0][0] <= time.monotonic():
                _, _, side, frame = heapq.heappop(self._late)
                self._deliver(side, frame)

    def _take(self, side):
        while True:
            try:
                frame, address = self._sockets[side].recvfrom(65536)
            except BlockingIOError:
                return
            if address[2] == OUTGOING:
                continue
            kind = frame[23] if frame[12:14] == b"\x08\x00" else 0
            if kind == UDP:
                self._take_datagram(side, frame)
            elif kind == TCP:
                self._take_segment(side, frame)
            else:
                self._deliver(side, frame)

    def _later(self, side, frame, due):
        self._order += 1
        heapq.heappush(self._late, (due, self._order, side, frame))

    def _take_datagram(self, side, frame):
        source = socket.inet_ntoa(frame[26:30])
        if self._draw.random() < self.loss:
            self.dropped[source] += 1
            return
        twice = self._draw.random() < self.double
        self.doubled[source] += twice
        for _ in range(1 + twice):
            self._later(side, frame, time.monotonic() + self._draw.random() * self.jitter_s)

    def _take_segment(self, side, frame):
        """In their order: what TCP would see of another is not what is looked for."""
        due = self._last[side] = max(self._last[side], time.monotonic() + self._draw.random() * self.tcp_delay_s)
        s = Segment(frame)
        if len(s.payload) < 2 or s.flags & 7 or self._draw.random() >= self.cutting:  # FIN, SYN, RST
            self._later(side, frame, due)
            return
        at = self._draw.randrange(1, len(s.payload))
        self.cut += 1
        self._later(side, s.made(s.seq, s.flags & ~8, s.payload[:at]), due)
        self._later(side, s.made((s.seq + at) % 2**32, s.flags, s.payload[at:]), due)

    def _deliver(self, side, frame):
        if frame[12:14] == b"\x08\x00" and frame[23] == TCP:
            s = Segment(frame)
            if side == 1:  # what the server has had
                self._next[s.ports] = (s.seq + len(s.payload) + (s.flags & 3 != 0)) % 2**32
            elif self._reset.is_set() and s.payload:
                self._reset.clear()
                self.resets += 1
                self._put(0, s.back(self._next.get(s.ports[::-1], s.ack)))
                frame = s.made(s.seq, 0x14, b"")
        self._put(1 - side, frame)

    def _put(self, side, frame):
        try:
            self._sockets[side].send(frame)
        except OSError:
            pass  # a full queue loses as any network does
