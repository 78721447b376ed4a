#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Receivers' ports live: RTCM, UBX and NMEA over TCP, an NTRIP caster. Bare sockets and RTKLIB's str2str listen; from base and rover, listened to at once,
RTKLIB fixes the baseline."""
import base64
import concurrent.futures
import math
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import sys
import time
import unittest

from daemon import ROOT, WORK, Daemon, orrery  # first: it sets the path

import rtcm

PLACES = {"BASE": "52.28, 17.07, 124", "ROVE": "52.285, 17.08, 130"}
FROM = "2025-03-21T10:00:00"
RTK = {"pos1-posmode": "kinematic", "pos1-frequency": "l1+2", "pos1-elmask": "10", "pos1-navsys": "9", "pos1-ionoopt": "off", "pos1-tropopt": "off",
       "pos1-sateph": "brdc", "pos2-armode": "continuous", "pos2-niter": "3", "out-solformat": "xyz", "out-outhead": "off"}
FAKETIME = next(pathlib.Path("/usr/lib").glob("*/faketime/libfaketime.so.1"), None)
HAS_RTKLIB = all(shutil.which(name) is not None for name in ("str2str", "convbin", "rnx2rtkp"))
HAS_RTKRCV = HAS_RTKLIB and shutil.which("rtkrcv") is not None and FAKETIME is not None


def scenario():
    """Two antennas under the made constellation; made once."""
    path = WORK / "ports.yaml"
    if not path.exists():
        done = orrery("orbit", "-o", WORK / "ports.nc", "--sat", "G,E", ROOT / "samples/ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz")
        assert done.returncode == 0, done.stderr
        antennas = ", ".join(f"{{name: {name}, position: [{place}]}}" for name, place in PLACES.items())
        path.write_text(f"orbit: {{product: ports.nc}}\nsignals: ['G:L1CA', 'G:L2P', 'E:E1']\nmask: {{elevation: 10}}\nantennas: [{antennas}]\n", encoding="ascii")
        (WORK / "login").write_text("user:secret\n", encoding="ascii")
    return path


def port(d, kind):
    """Where the ready line says that a port is."""
    line = next(line for line in d.lines if "ready on" in line)
    return int(re.search(rf" with {kind} on tcp://127\.0\.0\.1:(\d+)", line).group(1))


def listen(number, seconds, ask=b""):
    """What comes from a port within so many seconds."""
    out, end = b"", time.monotonic() + seconds
    with socket.create_connection(("127.0.0.1", number), 10) as s:
        s.sendall(ask)
        while (left := end - time.monotonic()) > 0:
            s.settimeout(left)
            try:
                data = s.recv(65536)
            except TimeoutError:
                break
            if not data:
                break
            out += data
    return out


def whole(data):
    """The whole frames at the begin of RTCM."""
    at = 0
    while at + 6 <= len(data):
        n = 6 + ((data[at + 1] & 3) << 8 | data[at + 2])
        if at + n > len(data):
            break
        at += n
    return data[:at]


def cells(frames):
    """Observations by milliseconds of the week."""
    out = {}
    for number, content in frames:
        if number // 10 in rtcm.SYSTEM:
            head, some = rtcm.msm(content)
            out.setdefault(head["ms"], {}).update({k: {n: v for n, v in c.items() if n != "lock_ms"} for k, c in some.items()})
    return out


def ask(mount, *fields, http="1.0"):
    return "\r\n".join([f"GET /{mount} HTTP/{http}", "User-Agent: NTRIP test/1", *fields, "", ""]).encode()


def login(text):
    return "Authorization: Basic " + base64.b64encode(text.encode()).decode()


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


class Rover:
    """RTKLIB's rtkrcv: the rover's port, the base through str2str, which speaks NTRIP for it. RTCM has no weeks: its clock is set to the scenario's day."""

    def __init__(self, rover, base):
        relay, console = free_port(), free_port()
        options = {"inpstr1-type": "tcpcli", "inpstr1-path": f"127.0.0.1:{rover}", "inpstr1-format": "rtcm3", "inpstr2-type": "tcpcli",
                   "inpstr2-path": f"127.0.0.1:{relay}", "inpstr2-format": "rtcm3", "outstr1-type": "file", "outstr1-path": WORK / "live.pos", "outstr1-format": "xyz",
                   "ant2-postype": "rtcm", "misc-reconnect": "200", **RTK}
        (WORK / "live.conf").write_text("".join(f"{k} ={v}\n" for k, v in options.items()), encoding="ascii")
        quiet = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "cwd": WORK}
        self.relay = subprocess.Popen(["str2str", "-in", base, "-out", f"tcpsvr://:{relay}"], **quiet)
        self.rtkrcv = subprocess.Popen(["rtkrcv", "-p", str(console), "-o", "live.conf"], env={**os.environ, "LD_PRELOAD": str(FAKETIME), "FAKETIME": "@" + FROM.replace("T", " ")},
                                       **quiet)
        for _ in range(100):
            try:
                self.console = socket.create_connection(("127.0.0.1", console), 5)
                break
            except ConnectionRefusedError:
                time.sleep(0.1)
        for line in (b"admin\r\n", b"start\r\n"):
            self.console.sendall(line)
            time.sleep(0.2)

    def end(self):
        """After ten solutions, or twenty seconds."""
        for _ in range(200):
            if (WORK / "live.pos").exists() and (WORK / "live.pos").read_text(encoding="ascii").count("\n") > 10:
                break
            time.sleep(0.1)
        self.console.close()
        for p in (self.rtkrcv, self.relay):
            p.kill()
            p.wait(10)


class Ports(unittest.TestCase):
    """One service; all that listens to it does so at the same time."""

    @classmethod
    def setUpClass(cls):
        words = ["--from", FROM, "--port-rate", "10", "--noise", "--seed", "3", "--ntrip-login", WORK / "login"]
        for kind, address in (("rtcm", "ROVE@tcp://127.0.0.1:0"), ("ubx", "ROVE@tcp://127.0.0.1:0"), ("nmea", "BASE@tcp://127.0.0.1:0"),
                              ("ntrip", "BASE@tcp://127.0.0.1:0/BASE")):
            words += ["--" + kind, address]
        path, began = scenario(), time.monotonic()
        cls.daemon = Daemon(path, *map(str, words))
        cls.frozen = socket.socket()
        cls.frozen.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        cls.frozen.connect(("127.0.0.1", port(cls.daemon, "ubx")))
        caster = port(cls.daemon, "ntrip")
        asks = {"rtcm": (port(cls.daemon, "rtcm"), b""), "ubx": (port(cls.daemon, "ubx"), b""), "nmea": (port(cls.daemon, "nmea"), b""),
                "ntrip 1": (caster, ask("BASE", login("user:secret"))),
                "ntrip 2": (caster, ask("BASE", "Host: here", "Ntrip-Version: Ntrip/2.0", login("user:secret"), http="1.1"))}
        ins = {"base": f"ntrip://user:secret@127.0.0.1:{caster}/BASE", "rove": f"tcpcli://127.0.0.1:{port(cls.daemon, 'rtcm')}"} if HAS_RTKLIB else {}
        with concurrent.futures.ThreadPoolExecutor() as pool:
            came = {name: pool.submit(listen, number, 1.5, words) for name, (number, words) in asks.items()}
            streams = [subprocess.Popen(["str2str", "-in", url, "-out", str(WORK / f"{name}.rtcm3")], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                       for name, url in ins.items()]
            rover = Rover(port(cls.daemon, "rtcm"), ins["base"]) if HAS_RTKRCV else None
            cls.came = {name: data.result() for name, data in came.items()}
            time.sleep(4)
            if rover is not None:
                rover.end()
            for p in streams:
                p.send_signal(signal.SIGINT)
                p.wait(10)
        # The same epochs as files.
        last = 0.1 * math.ceil(10 * (time.monotonic() - began) + 10)
        done = orrery("simulate", scenario(), "-o", WORK / "run", "--from", FROM, "--to", f"2025-03-21T10:{int(last // 60):02d}:{last % 60:04.1f}", "--rate", "10",
                      "--rtcm", "--ubx", "--noise", "--seed", "3", "--no-imu", "--truth-step", "60")
        assert done.returncode == 0, done.stderr

    @classmethod
    def tearDownClass(cls):
        cls.frozen.close()
        assert cls.daemon.stop(signal.SIGINT) == 0, "SIGINT ends it cleanly"

    def same_as_the_file(self, live, name):
        """Epochs that came live are those of `orrery simulate`."""
        file = cells(rtcm.frames((WORK / "run" / f"{name}.rtcm3").read_bytes()))
        got = cells(live)
        full = [ms for ms in got if len(got[ms]) == len(file[ms])]
        self.assertGreaterEqual(len(full), 5)
        self.assertGreaterEqual(len(full), len(got) - 1)
        shifts = {}
        for ms in full:
            self.assertEqual(set(got[ms]), set(file[ms]))
            for key, cell in got[ms].items():
                theirs = file[ms][key]
                # Phases far from their codes are brought near when an arc begins, which is not the same epoch: by one whole number of cycles.
                wave_m = 299792458 / rtcm.carrier(key[0][0], key[1])
                shift = (cell["phase_m"] - theirs["phase_m"]) / wave_m
                self.assertAlmostEqual(shift, shifts.setdefault(key, round(shift)), delta=2**-31 * 299792.458 / wave_m + 1e-9)
                self.assertEqual({**cell, "phase_m": 0}, {**theirs, "phase_m": 0})

    def test_rtcm(self):
        frames = list(rtcm.frames(whole(self.came["rtcm"])))
        self.assertEqual([n for n, _ in frames[:3]], [1005, 1006, 1033], "what a base station tells now and then comes at once")
        self.assertGreaterEqual({n for n, _ in frames}, {1019, 1045, 1046, 1077, 1097})
        self.same_as_the_file(frames, "ROVE")

    def test_ubx(self):
        data, file = self.came["ubx"], (WORK / "run/ROVE.ubx").read_bytes()
        found, at = 0, 0
        while (at := data.find(b"\xb5b\x02\x15", at)) >= 0 and at + 8 + (n := int.from_bytes(data[at + 4:at + 6], "little")) <= len(data):
            _, mine = rtcm.rawx(data[at + 6:at + 6 + n])
            start = file.find(data[at:at + 14])  # of the same epoch
            self.assertGreater(start, 0)
            theirs = rtcm.rawx(file[start + 6:start + 6 + n])[1]
            for key, cell in mine.items():
                self.assertEqual({**cell, "lock_ms": 0}, {**theirs[key], "lock_ms": 0})
            found, at = found + 1, at + 1
        self.assertGreaterEqual(found, 5)

    def test_nmea(self):
        lines = self.came["nmea"].decode("ascii").split("\r\n")
        self.assertTrue(any(re.match(r"\$GNGGA,(0959|100[0-3])", line) and ",5216.8000000,N,01704.2000000,E,1," in line for line in lines), lines[:3])

    def test_ntrip(self):
        data = self.came["ntrip 1"]
        self.assertTrue(data.startswith(b"ICY 200 OK\r\n\r\n\xd3"), data[:80])
        self.same_as_the_file(rtcm.frames(whole(data[14:])), "BASE")
        head, body = self.came["ntrip 2"].split(b"\r\n\r\n", 1)
        self.assertRegex(head, rb"^HTTP/1\.1 200 OK\r\n")
        for field in (b"Ntrip-Version: Ntrip/2.0", b"Content-Type: gnss/data", b"Transfer-Encoding: chunked"):
            self.assertIn(field, head.split(b"\r\n"))
        stream = b""
        while b"\r\n" in body:
            size, rest = body.split(b"\r\n", 1)
            n = int(size, 16)
            if len(rest) < n + 2:
                break
            self.assertEqual(rest[n:n + 2], b"\r\n")
            stream, body = stream + rest[:n], rest[n + 2:]
        self.same_as_the_file(rtcm.frames(stream), "BASE")

    def test_refused(self):
        number = port(self.daemon, "ntrip")
        table = listen(number, 5, ask(""))
        self.assertRegex(table, rb"^SOURCETABLE 200 OK\r\n(?s:.*)\r\n\r\nSTR;BASE;BASE;RTCM 3\.3;1005\(10\),1006\(10\),1033\(10\),1077\(0\.1\),1097\(0\.1\);2;GPS\+GAL;"
                                rb"none;;52\.28;17\.07;0;0;Orrery [\d.]+;none;B;N;9600;simulated\r\nENDSOURCETABLE\r\n$")
        self.assertEqual(listen(number, 5, ask("OTHER", login("user:secret"))), table, "revision 1 is answered so")
        second = "Ntrip-Version: Ntrip/2.0"
        for request, status in ((ask("OTHER", second), b"HTTP/1.1 404 "), (ask("BASE", second), b"HTTP/1.1 401 "), (ask("BASE"), b"HTTP/1.0 401 "),
                                (ask("BASE", login("user:secreT")), b"HTTP/1.0 401 "), (b"SOURCE secret /BASE\r\n\r\n", b"HTTP/1.1 405 "),
                                (b"\x16\x03\x01\x02\x00\n", b"HTTP/1.1 400 "), (b"GET /" + 5000 * b"x", b"HTTP/1.1 400 ")):
            self.assertTrue(listen(number, 5, request).startswith(status), request[:40])
        said = lambda: "".join(self.daemon.lines)  # noqa: E731
        for _ in range(50):
            if "none of NTRIP" in said():
                break
            time.sleep(0.1)
        for reason in ("it names another mountpoint", "it gives no login", "its login is wrong", "it does not ask for data", "its request is none of NTRIP"):
            self.assertRegex(said(), rf"client 127\.0\.0\.1:\d+ refused at tcp://127\.0\.0\.1:{number}/BASE: {reason}.* \[P01\]")

    def streamed(self, name):
        """What str2str has written, whole frames; it passes the empty line behind ICY 200 OK on."""
        if not HAS_RTKLIB:
            self.skipTest("RTKLIB is not here")
        return list(rtcm.frames(whole((WORK / f"{name}.rtcm3").read_bytes().lstrip(b"\r\n"))))

    def test_str2str(self):
        self.same_as_the_file(self.streamed("base"), "BASE")
        self.same_as_the_file(self.streamed("rove"), "ROVE")

    def test_rtk_is_fixed(self):
        """Base and rover, listened to at once: from the first common epochs on the baseline is fixed, and right to 1 cm."""
        base, place = (next(rtcm.station(c)["place_m"] for n, c in self.streamed(name) if n == 1005) for name in ("base", "rove"))
        for name in ("base", "rove"):
            subprocess.run(["convbin", "-r", "rtcm3", "-tr", "2025/03/21", "10:00:00", "-v", "3.04", "-od", "-os", "-o", f"{name}.obs", "-n", f"{name}.nav", f"{name}.rtcm3"],
                           cwd=WORK, check=True, capture_output=True, timeout=60)
        options = {**RTK, "ant2-postype": "xyz"}
        options.update({f"ant2-pos{k + 1}": f"{base[k]:.4f}" for k in range(3)})
        (WORK / "rtk.conf").write_text("".join(f"{k} ={v}\n" for k, v in options.items()), encoding="ascii")
        subprocess.run(["rnx2rtkp", "-k", "rtk.conf", "-o", "rtk.pos", "rove.obs", "base.obs", "rove.nav"], cwd=WORK, check=True, capture_output=True, timeout=60)
        self.judge("rtk.pos", place, 1)

    def judge(self, name, place, first):
        """The solutions of a file from the `first` on: fixed, and right."""
        rows = [line.split() for line in (WORK / name).read_text(encoding="ascii").splitlines() if line[0] != "%"][first:]
        fixed = [tuple(map(float, r[2:5])) for r in rows if r[5] == "1"]
        apart = max((math.dist(place, f) for f in fixed), default=math.inf)
        mean = [sum(f[k] for f in fixed) / max(len(fixed), 1) for k in range(3)]
        print(f"{name}: {len(rows)} epochs, {len(fixed)} of them fixed, {1e3 * apart:.1f} mm at most, {1e3 * math.dist(place, mean):.1f} mm on average")
        self.assertGreaterEqual(len(rows), 5)
        self.assertGreaterEqual(len(fixed), 0.8 * len(rows))
        self.assertLess(apart, 0.02)  # phases of 45 dB-Hz have 1.2 mm of noise each, four times in a double difference
        self.assertLess(math.dist(place, mean), 0.01)

    def test_rtk_is_fixed_live(self):
        """rtkrcv, while base and rover run."""
        if not HAS_RTKRCV:
            self.skipTest("RTKLIB's rtkrcv or faketime is not here")
        place = next(rtcm.station(c)["place_m"] for n, c in self.streamed("rove") if n == 1005)
        self.judge("live.pos", place, 1)

    def test_a_frozen_client_is_dropped(self):
        for _ in range(300):
            if any("[P02]" in line for line in self.daemon.lines):
                break
            time.sleep(0.1)
        self.assertRegex("".join(self.daemon.lines), r"client 127\.0\.0\.1:\d+ closed at tcp://127\.0\.0\.1:\d+: it has taken nothing for 5 s \[P02\]")


class Asked(unittest.TestCase):
    """What cannot be served is told before it begins."""

    def refused(self, *words, because, status=1):
        done = orrery("serve", scenario(), "--listen", "tcp://127.0.0.1:0", *words)
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertRegex(done.stderr, because)

    def test_bad_asks(self):
        self.refused("--rtcm", "ROOF@tcp://127.0.0.1:0", because=r"--rtcm ROOF@tcp://127\.0\.0\.1:0: ANTENNA@ADDRESS is wanted, with one of the antennas BASE, ROVE")
        self.refused("--ubx", "tcp://127.0.0.1:0", because="ANTENNA@ADDRESS is wanted")
        self.refused("--ntrip", "BASE@tcp://127.0.0.1:0", because="no address of a caster: tcp://HOST:PORT/MOUNT is wanted")
        self.refused("--ntrip", "BASE@tcp://127.0.0.1:0/a;b", because="a mountpoint has 1 to 63 letters")
        self.refused("--ntrip", "BASE@tcp://0.0.0.0:0/B", because="tls://|insecure")
        (WORK / "bad").write_text("nobody\n", encoding="ascii")
        self.refused("--ntrip", "BASE@tcp://127.0.0.1:0/B", "--ntrip-login", WORK / "bad", because=r"bad:1: USER:PASSWORD")
        self.refused("--rtcm", "BASE@tcp://127.0.0.1:0", "--port-rate", "3", because="whole milliseconds")
        self.refused("--port-rate", "3", because="port-rate", status=2)
        with socket.socket() as s:
            s.bind(("127.0.0.1", 0))
            s.listen()
            self.refused("--rtcm", f"BASE@tcp://127.0.0.1:{s.getsockname()[1]}", because="another program is listening there")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
