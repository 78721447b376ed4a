# SPDX-License-Identifier: GPL-3.0-or-later
"""The service under load with one call after the other failing: it lives on, who comes next is answered the same bytes as before, and at the
end it stops well and has lost nothing. Some calls of a visit by default, every one with ORRERY_LONG."""
import mmap
import os
import pathlib
import shutil
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "proto/python")]
import orrery  # pylint: disable=wrong-import-position

RUN, ORRERY = sys.argv[1:3]
LONG = bool(os.environ.get("ORRERY_LONG"))
SOME = int(os.environ.get("ORRERY_FAULTS", "12"))
DAY = ROOT / "samples/ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"
T = "2025-03-21T12:00:00"
PATIENCE_S = 30


class Service:
    """A service whose calls fail on request."""

    def __init__(self, work, *args):
        self.memory_file = work / "faults"
        self.memory_file.write_bytes(bytes(4096))
        with open(self.memory_file, "r+b") as f:
            self.memory = mmap.mmap(f.fileno(), 4096)
        env = {**os.environ, "ORRERY_FAULTS_FILE": str(self.memory_file), "LSAN_OPTIONS": "exitcode=23",
               "ASAN_OPTIONS": "allocator_may_return_null=1"}
        self.process = subprocess.Popen([RUN, "serve", *map(str, args)], stderr=subprocess.PIPE, text=True, env=env, cwd=work)
        self.lines = []
        self.ready = threading.Event()
        threading.Thread(target=self.read, daemon=True).start()
        if not self.ready.wait(120):
            raise RuntimeError("not ready: " + "".join(self.lines))

    def read(self):
        for line in self.process.stderr:
            self.lines.append(line)
            if "ready on " in line:
                self.urls = line.split("ready on ")[1].split(" (")[0].split()
                self.text = next((w for k, w in enumerate(self.urls) if self.urls[k - 1] == "on" and k > 1), None)
                self.ready.set()

    def calls(self):
        return struct.unpack_from("<q", self.memory, 0)[0]

    def fail(self, after):
        """The call `after` calls from now fails; 0: none."""
        struct.pack_into("<q", self.memory, 8, self.calls() + after if after else 0)

    def last(self):
        """How many have failed, and which was the last."""
        hits, name = struct.unpack_from("<i32s", self.memory, 16)
        return hits, name.split(b"\0")[0].decode(), struct.unpack_from("<Q", self.memory, 56)[0]


class Faults(unittest.TestCase):
    def setUp(self):
        self.work = pathlib.Path(tempfile.mkdtemp(prefix="orrery-faults-"))
        self.addCleanup(shutil.rmtree, self.work, True)
        self.run_orrery("orbit", "-q", "-o", "day.nc", "--sat", "G01-G04", DAY)
        self.run_orrery("tls", "init", "lab", "--host", "127.0.0.1")

    def run_orrery(self, *args):
        subprocess.run([ORRERY, *map(str, args)], cwd=self.work, check=True, capture_output=True)

    def visit(self, url):
        """What a client does: polls, a stream, the clock. Returns all that it was told."""
        with orrery.Client(url, timeout_s=PATIENCE_S, identity=str(self.work / "lab/client.pem")) as c:
            told = [c.states(T), *c.poll(T, step_s=0.5, count=5)]
            stream = c.subscribe(orrery.messages.Poll(), t=T, step_s=1, count=5, pacing="free", credit=16)
            told += list(stream)
            c.time()
            c.ping()
        return told

    def ask_text(self, address):
        host, port = address[6:].rsplit(":", 1)
        with socket.create_connection((host, int(port)), PATIENCE_S) as s:
            s.sendall(b"*IDN?\nSAT:LIST?\n")
            s.settimeout(3)  # a question that failed has no answer (SCPI), and an error in its queue
            data = b""
            while data.count(b"\n") < 2:
                part = s.recv(4096)
                if not part:
                    raise OSError("closed")
                data += part
        return data

    def undisturbed(self, service, what, visit, reference):
        """Who comes behind a fault is served as before."""
        end = time.monotonic() + PATIENCE_S
        while True:
            self.assertIsNone(service.process.poll(), f"{what}: the service ended with {service.process.poll()}: {''.join(service.lines[-40:])}")
            try:
                self.assertEqual(visit(), reference, what)
                return
            except (OSError, orrery.ProtocolError, orrery.Refused) as e:
                # A listener that ran out of descriptors looks again at the next sweep.
                if time.monotonic() > end:
                    self.fail(f"{what}: the next client gets {e!r}: {''.join(service.lines[-20:])}")
                time.sleep(0.1)

    def through(self, service, visit, answered=True):
        """Each call fails once. `answered`: who asks is answered, refused or closed, never left waiting for its own patience to end."""
        reference = visit()
        before = service.calls()
        visit()
        calls = service.calls() - before
        numbers = range(1, calls + 1) if LONG or calls <= SOME else sorted({1 + k * calls // SOME for k in range(SOME)})
        failed = 0
        for n in numbers:
            hits = service.last()[0]
            service.fail(n)
            began = time.monotonic()
            left_waiting = False
            try:
                visit()
            except TimeoutError:
                left_waiting = True
            except (OSError, orrery.ProtocolError, orrery.Refused):
                pass
            service.fail(0)
            now, name, where = service.last()
            if answered:
                self.assertFalse(left_waiting, f"call {n} of {calls}, {name} at {where:#x}: the client was left waiting")
            failed += now - hits
            if os.environ.get("ORRERY_VERBOSE"):
                print(f"call {n}: {name} at {where:#x}, {time.monotonic() - began:.1f} s", flush=True)
            self.undisturbed(service, f"call {n} of {calls}, {name} at {where:#x}", visit, reference)
        print(f"{calls} calls a visit, {failed} failed", flush=True)
        self.assertGreater(failed, 0)
        service.process.send_signal(signal.SIGTERM)
        status = service.process.wait(60)
        self.assertEqual(status, 0, "".join(service.lines[-60:]))

    def test_plain(self):
        service = Service(self.work, self.work / "day.nc", "--listen", "tcp://127.0.0.1:0")
        self.addCleanup(service.process.kill)
        self.through(service, lambda: self.visit(service.urls[0]))

    def test_tls(self):
        service = Service(self.work, self.work / "day.nc", "--listen", "tls://127.0.0.1:0", "--access", self.work / "lab/access.yaml")
        self.addCleanup(service.process.kill)
        self.through(service, lambda: self.visit(service.urls[0]))

    def test_text(self):
        service = Service(self.work, self.work / "day.nc", "--listen", "tcp://127.0.0.1:0", "--text", "tcp://127.0.0.1:0")
        self.addCleanup(service.process.kill)
        address = next(w for w in service.urls[::-1] if w.startswith("tcp://"))
        self.through(service, lambda: self.ask_text(address), answered=False)  # SCPI: what failed has no answer


if __name__ == "__main__":
    unittest.main(argv=["test_service", *sys.argv[3:]])
