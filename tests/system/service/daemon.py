# SPDX-License-Identifier: GPL-3.0-or-later
"""A real service for tests: started on loopback, waited for by its ready line, stopped by its pid."""
import atexit
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT / "proto/python"), str(ROOT / "tests/system")]
import orrery as wire  # noqa: E402 # the path to it is set above

ORRERY, FIRMWARE = sys.argv[1:3]
SAMPLE = ROOT / "samples/ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"
PATIENCE_S = 90  # sanitizers are slow; nothing waits for it when all is well

WORK = pathlib.Path(tempfile.mkdtemp(prefix="orrery-service-"))
atexit.register(shutil.rmtree, WORK, True)


def orrery(*args, **kwargs):
    """Runs the program to its end."""
    return subprocess.run([ORRERY, *map(str, args)], capture_output=True, text=True, timeout=PATIENCE_S, check=False, **kwargs)


def product():
    """An orbit product of ten satellites of the made constellation, made once."""
    path = WORK / "day.nc"
    if not path.exists():
        done = orrery("orbit", "-o", path, "--sat", "G01-G06,R01-R02,E01-E02", SAMPLE)
        if done.returncode != 0:
            raise RuntimeError(f"orrery orbit: {done.stderr}")
    return path


def laboratory(name, *clients):
    """The folder of an authority with these clients."""
    folder = WORK / name
    if not folder.exists():
        done = orrery("tls", "init", folder, *clients, "--host", "127.0.0.1", "--host", "localhost")
        if done.returncode != 0:
            raise RuntimeError(done.stderr)
    return folder


class Daemon:
    """`with Daemon(product()) as d:` serves on d.urls until the end of the block."""

    def __init__(self, what, *args, listen=("tcp://127.0.0.1:0",), cwd=None, inside=None, env=None):
        words = ["nsenter", "-t", str(inside), "-n"] if inside else []  # of that process's network
        words += [ORRERY, "serve", str(what), *args]
        for url in listen:
            words += ["--listen", url]
        self.process = subprocess.Popen(words, stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True, cwd=cwd, env=env)
        self.lines, self.urls = [], []
        self._ready = threading.Event()
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()
        if not self._ready.wait(PATIENCE_S) or not self.urls:
            self.process.kill()
            self.process.wait()
            raise RuntimeError("the service did not become ready: " + "".join(self.lines))

    def _read(self):
        for line in self.process.stderr:
            self.lines.append(line)
            match = re.match(r"orrery serve: ready on (.*) \(", line)
            if match:
                self.urls = match.group(1).split(" ")
                self._ready.set()
        self._ready.set()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.stop()

    def stop(self, with_signal=signal.SIGTERM):
        """Its exit status."""
        self.process.send_signal(with_signal)
        try:
            status = self.process.wait(PATIENCE_S)
        except subprocess.TimeoutExpired:
            self.process.kill()
            status = self.process.wait()
        self._reader.join(PATIENCE_S)
        self.process.stderr.close()
        self.process.stdout.close()
        return status

    def said(self, words):
        """Whether its log has the words; what it does at this moment may take a while to get there."""
        return self.said_since(0, words)

    def said_since(self, n, words):
        """The same, behind the first n lines."""
        end = time.monotonic() + PATIENCE_S / 3
        while not any(words in line for line in self.lines[n:]):
            if time.monotonic() > end:
                return False
            time.sleep(0.02)
        return True


def scenario(name, text):
    """A scenario's file beside the product and the map of the ionosphere that it names."""
    product()
    shutil.copy(ROOT / "samples/ionosphere.ION", WORK)
    path = WORK / name
    path.write_text(text, encoding="utf-8")
    return path


class Shared(unittest.TestCase):
    """Tests of one service, which has to end well: cls.daemon at cls.url. A class calls serve() in its setUpClass, or names its scenario's
    text in SCENARIO and the service's options in OPTIONS."""

    SCENARIO, OPTIONS = "", ()

    @classmethod
    def setUpClass(cls):
        cls.serve(scenario(f"{cls.__name__.lower()}.yaml", cls.SCENARIO) if cls.SCENARIO else product(), *cls.OPTIONS)

    @classmethod
    def serve(cls, what, *args, **kwargs):
        cls.daemon = Daemon(what, *args, **kwargs)
        cls.url = cls.daemon.urls[0]

    @classmethod
    def tearDownClass(cls):
        status = cls.daemon.stop()
        if status != 0:
            raise AssertionError(f"the service ended with {status}: {''.join(cls.daemon.lines)}")


class Served(Shared):
    """Tests of one service and one client of it: cls.client."""

    @classmethod
    def serve(cls, what, *args, **kwargs):
        super().serve(what, *args, **kwargs)
        cls.client = wire.Client(cls.url, timeout_s=PATIENCE_S)

    @classmethod
    def tearDownClass(cls):
        cls.client.close()
        super().tearDownClass()

    def connect(self, url=None, **kwargs):
        """Another client, for one test."""
        client = wire.Client(url or self.url, **kwargs)
        self.addCleanup(client.close)
        return client
