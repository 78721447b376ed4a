#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The text twin: SCPI and JSON lines over its own port, by netcat, by PyVISA and by bare sockets, against the binary protocol."""
import json
import math
import re
import shutil
import socket
import subprocess
import sys
import time
import unittest

from daemon import ORRERY, ROOT, WORK, Daemon, product  # first: it sets the path

import orrery
from orrery import messages
from test_streams import SCENARIO

NS = 10**9
T = "2025-03-21T10:02:00"

VISA = """
import pyvisa, sys
tool = pyvisa.ResourceManager("@py").open_resource(f"TCPIP0::127.0.0.1::{sys.argv[1]}::SOCKET", read_termination="\\n", write_termination="\\n")
tool.timeout = 20000
print(tool.query("*IDN?"))
print(tool.query("SAT:LIST?"))
print(len(tool.query_ascii_values("TRUT? 0,'%s'", converter="s")))
tool.write("NONSENSE")
print(tool.query("SYST:ERR?"))
""" % T


class Wire:
    def __init__(self, port):
        self.sock = socket.create_connection(("127.0.0.1", port), 20)
        self.file = self.sock.makefile("r", encoding="ascii", newline="\n")

    def write(self, line):
        self.sock.sendall(line.encode() + b"\n")

    def query(self, line):
        self.write(line)
        return self.file.readline().rstrip("\n")

    def error(self):
        return int(self.query("SYST:ERR?").split(",")[0])

    def close(self):
        self.file.close()
        self.sock.close()


class Text(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        product()
        shutil.copy(ROOT / "samples/ionosphere.ION", WORK)
        (WORK / "text.yaml").write_text(SCENARIO, encoding="utf-8")
        cls.daemon, cls.port = cls.serve()

    @classmethod
    def serve(cls, *args):
        daemon = Daemon(WORK / "text.yaml", "--start", "command", "--from", T, "--motion", "--text", "tcp://127.0.0.1:0", *args)
        line = next(x for x in daemon.lines if "as text on" in x)
        return daemon, int(re.search(r"as text on tcp://127\.0\.0\.1:(\d+)", line).group(1))

    @classmethod
    def tearDownClass(cls):
        status = cls.daemon.stop()
        if status != 0:
            raise AssertionError(f"the service ended with {status}: {''.join(cls.daemon.lines)}")

    def wire(self, port=None):
        wire = Wire(port or self.port)
        self.addCleanup(wire.close)
        return wire

    def binary(self):
        client = orrery.Client(self.daemon.urls[0])
        self.addCleanup(client.close)
        return client

    def test_values_are_those_of_the_protocol(self):
        wire, client = self.wire(), self.binary()
        self.assertRegex(wire.query("*IDN?"), r"^Orrery,GNSS simulator,0,")
        self.assertEqual(wire.query("SAT:LIST?").split(","), client.satellites)
        s = client.states(T, ["G05"]).satellites[0]
        for ask in (f"SAT:STAT? G05,'{T}'", f'satellite:state? g05,"{T}"', "SAT:STAT? G05,%d,%d.0" % divmod(s_time(T), 604800)):
            v = wire.query(ask).split(",")
            self.assertEqual((v[0], v[1]), ("G05", "OK"))
            at = next(k for k in range(len(v)) if v[k] and is_number(v[k]) and abs(float(v[k])) > 1e6)
            self.assertEqual([float(x) for x in v[at:at + 6]], list(s.pos_m) + list(s.vel_mps))
        self.assertIn("NOT_SERVED", wire.query(f"SAT:STAT? C30,'{T}'"))
        channels = client.channels(T, 1)
        v = wire.query(f"CHAN? 1,'{T}'").split(",")
        self.assertEqual(int(v[0]), len(channels.channels))
        self.assertIn(str(channels.channels[0].sat), v)
        self.assertIn(repr(channels.channels[0].code[0]).rstrip("0"), ",".join(v))
        m = client.time()
        v = wire.query("TIME?").split(",")
        self.assertIn("STOPPED", v)
        self.assertIn(str(m.week), v)
        self.assertEqual(len(wire.query("MOT:STAT?").split(",")), 22)
        self.assertEqual(wire.error(), 0)

    def test_mistakes(self):
        wire = self.wire()
        for line, number in (("SAT:STAT?", -109), ("SAT:STAT? G05,1,2,3", -108), ("SAT:STAT? XYZ", -224), ("NO:SUCH?", -113),
                             ("SAT:STAT? G05,'yesterday'", -222), ("CHAN? 9", -222), ("CHAN? x", -224), ("TRUT? 99", -222),
                             ("CHAN? 70000", -222), ("SCEN:PAUS", -221)):
            wire.write(line)
            self.assertEqual(wire.error(), number, line)
        wire.write("A" * 1000000)
        self.assertEqual(wire.error(), -363)
        self.assertEqual(wire.error(), 0)
        for _ in range(30):
            wire.write("X")
        numbers = [wire.error() for _ in range(17)]
        self.assertEqual(numbers, [-113] * 15 + [-350, 0])

    def test_control(self):
        daemon, port = self.serve()
        wire = self.wire(port)
        self.assertEqual(wire.query("STAT:OPER:COND?"), "0")
        wire.write(f"SCEN:ARM '{T}'")
        self.assertEqual(wire.query("STAT:OPER:COND?"), "32")
        wire.write("SCEN:STAR")
        self.assertEqual(wire.query("STAT:OPER:COND?"), "256")
        self.assertIn("RUNNING", wire.query("TIME?"))
        wire.write("SCEN:PAUS;STOP")
        self.assertIn("STOPPED", wire.query("TIME?"))
        self.assertEqual(wire.error(), 0)
        self.assertEqual(daemon.stop(), 0)
        daemon, port = self.serve("--read-only")
        wire = self.wire(port)
        for line in ("SCEN:STAR", "*RST", "MOT:STAT:RES"):
            wire.write(line)
            self.assertEqual(wire.error(), -203)
        self.assertEqual(json.loads(wire.query('{"request": "CONTROL", "action": "START"}'))["error"], "NOT_PERMITTED")
        self.assertEqual(daemon.stop(), 0)

    def test_other_instruments_words(self):
        daemon, port = self.serve()
        wire, client = self.wire(port), orrery.Client(daemon.urls[0])
        lat, lon, e2 = math.radians(56), math.radians(40), 6.69437999014e-3
        n = 6378137 / math.sqrt(1 - e2 * math.sin(lat)**2)
        p = [(n + 1500) * math.cos(lat) * math.cos(lon), (n + 1500) * math.cos(lat) * math.sin(lon), (n * (1 - e2) + 1500) * math.sin(lat)]
        wire.write("SOUR1:BB:GNSS:RT:REC:V1:HILP:MODE:A 0.1,%r,%r,%r" % tuple(p))
        self.assertEqual(wire.error(), -222)  # nothing is armed
        wire.write("SCEN:STAR")
        wire.write("SOUR1:BB:GNSS:RT:REC:V1:HILP:MODE:A 0.1,%r,%r,%r,1,0,0,0,1,0" % tuple(p))
        wire.write(":BB:GNSS:RT:RECeiver:HILPosition:MODE:B 0.2,56,40,1500,1,2,3,0,0,0,0,0,0,0.1,0.2,0.3")
        wire.write("SOUR:SCEN:ENUVEL IMM,1,0,0")
        wire.write("SOURce:SCENario:PRYattitude IMMediate,1,2,3")
        wire.write("SOUR:SCEN:ECEFPOS 0.9,%r,%r,%r" % tuple(p))
        self.assertEqual(wire.error(), 0)
        self.assertEqual(wire.query("SOUR1:BB:GNSS:RT:REC:V1:HILP:LAT:STAT?").split(",")[5], "4")
        self.assertEqual(client.motion_stats().received, 4)
        self.assertEqual(client.motion_stats().dropped, 1)
        self.assertGreater(float(wire.query("SOUR1:BB:GNSS:RT:HWT?")), 0)
        float(wire.query("SOURce1:BB:GNSS:RECeiver:V1:HIL:SLATency?"))
        for line, number in (("BB:GNSS:RT:REC:HILP:MODE:A 1,2,3,4,5", -109), ("BB:GNSS:RT:REC:HILP:MODE:A 1,2,3,x", -224),
                             ("SOUR:SCEN:ECEFPOS 1,2,3", -109), ("SOUR:SCEN:ECEFPOS LATER,1,2,3", -224),
                             ("SOUR:SCEN:ECEFPOS 3,0,0,0", -222)):
            wire.write(line)
            self.assertEqual(wire.error(), number, line)
        client.close()
        self.assertEqual(daemon.stop(), 0)

    def test_json_lines(self):
        wire, client = self.wire(), self.binary()
        wire.write(json.dumps({"request": "POLL", "t": T, "step": NS, "count": 3, "satellites": ["G05", "E01"]}))
        for k in range(3):
            m, s = json.loads(wire.file.readline()), client.states(s_time(T) * NS + k * NS, ["G05", "E01"])
            self.assertEqual([x["sat"] for x in m["satellites"]], ["G05", "E01"])
            self.assertEqual(m["satellites"][0]["pos_m"], list(s.satellites[0].pos_m))
        m = json.loads(wire.query('{"request": "POLL_CHANNELS", "t": "%s", "antenna": 1, "signals": [0]}' % T))
        self.assertEqual([c["code"] for c in m["channels"]], [c.code for c in client.channels(T, 1, signals=[0]).channels])
        self.assertEqual(json.loads(wire.query('{"request": "GET_TIME"}'))["state"], "STOPPED")
        self.assertIn("attitude", json.loads(wire.query('{"request": "POLL_TRUTH", "t": "%s"}' % T)))
        for line, name in (("{", "BAD_PAYLOAD"), ("{}", "UNKNOWN_TYPE"), ('{"request": "STATES"}', "UNKNOWN_TYPE"),
                           ('{"request": "POLL", "sat": 3}', "BAD_PAYLOAD"), ('{"request": "POLL", "count": -1}', "BAD_PAYLOAD"),
                           ('{"request": "POLL", "count": 99999}', "LIMIT"), ('{"request": "POLL", "t": []}', "BAD_PAYLOAD"),
                           ('{"request": "POLL_ELEMENTS", "frame": "UP"}', "BAD_PAYLOAD"), ('{"request": "HELLO"}', "NOT_SERVED"),
                           ('{"request": "POLL_TRUTH", "unit": 77}', "BAD_REQUEST"), ('{"request": "UNSUBSCRIBE"}', "NOT_SERVED")):
            self.assertEqual(json.loads(wire.query(line))["error"], name, line)

    def test_netcat(self):
        if shutil.which("nc") is None:
            self.skipTest("no netcat")
        nc = subprocess.run(["nc", "-w", "2", "127.0.0.1", str(self.port)], input="*IDN?\nSAT:LIST?;*OPC?\n", capture_output=True, text=True,
                            timeout=60, check=False)
        first, second = nc.stdout.splitlines()
        self.assertTrue(first.startswith("Orrery,") and second.endswith(";1"))

    def test_pyvisa(self):
        python = next((p for p in (sys.executable, "/usr/bin/python3")
                       if subprocess.run([p, "-c", "import pyvisa, pyvisa_py"], capture_output=True, check=False).returncode == 0), None)
        if python is None:
            self.skipTest("no PyVISA (python3-pyvisa, python3-pyvisa-py)")
        done = subprocess.run([python, "-c", VISA, str(self.port)], capture_output=True, text=True, timeout=120, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = done.stdout.splitlines()
        self.assertTrue(lines[0].startswith("Orrery,"))
        self.assertIn("G05", lines[1])
        self.assertGreater(int(lines[2]), 20)
        self.assertTrue(lines[3].startswith("-113,"))

    def test_only_this_machine(self):
        done = subprocess.run([ORRERY, "serve", str(WORK / "text.yaml"), "--listen", "tcp://127.0.0.1:0",
                               "--text", "tcp://*:0"], capture_output=True, text=True, timeout=60, check=False)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("can be reached from other machines", done.stderr)

    def test_who_takes_nothing_harms_nobody(self):
        lazy, other = self.wire(), self.wire()
        lazy.sock.setblocking(False)
        try:
            for _ in range(20000):
                lazy.sock.send(b"SAT:LIST?;TIME?;SAT:STAT? G05\n" * 20)
        except (BlockingIOError, ConnectionError):
            pass
        begin = time.monotonic()
        for _ in range(50):
            self.assertEqual(other.query("*OPC?"), "1")
        self.assertLess(time.monotonic() - begin, 20)


def s_time(text):
    return orrery.from_text(text) // NS


def is_number(text):
    return re.fullmatch(r"[-+0-9.e]+", text) is not None


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
