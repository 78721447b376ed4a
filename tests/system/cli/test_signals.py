# SPDX-License-Identifier: GPL-3.0-or-later
"""SIGINT, SIGTERM and SIGHUP in the middle of every command's work: it ends by the signal and leaves nothing behind."""
import errno
import os
import pathlib
import signal
import socket
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import ORRERY, Folder, run, sample  # noqa: E402

SOON = 60  # seconds; a command needs milliseconds, but machines under test may be busy


def until(true, what):
    """Polls until true() is; fails after a generous time."""
    end = time.monotonic() + SOON
    while time.monotonic() < end:
        value = true()
        if value:
            return value
        time.sleep(0.01)
    raise AssertionError(f"not within {SOON} s: {what}")


def writer_of(fifo):
    """The writing end of a FIFO that somebody has opened for reading, or None as long as nobody has."""
    try:
        return os.open(fifo, os.O_WRONLY | os.O_NONBLOCK)
    except OSError as e:
        if e.errno != errno.ENXIO:
            raise
        return None


CALLERS = ("poll", "watch", "record")  # they call a service, and read nothing
MAKERS = ("make-days",)  # they read nothing at all


class Signals(Folder):
    took = []  # seconds from a signal to the end, command, signal

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.product = cls.path("day.nc")
        run("orbit", "-q", "-o", cls.product, sample("ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"))
        cls.fifo = cls.path("fifo")
        os.mkfifo(cls.fifo)
        # An archive whose record, a folder of samples whose scenario, are what nobody writes.
        day = pathlib.Path(cls.path("archive")) / "2025/080"
        day.mkdir(parents=True)
        (day / "day.json").symlink_to(cls.fifo)
        (day.parent.parent / "survey.yaml").symlink_to(cls.fifo)
        (day.parent.parent / "day.sp3.gz").symlink_to(sample("ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"))
        pathlib.Path(cls.path("figures")).mkdir()
        cls.silent = socket.create_server(("127.0.0.1", 0))
        cls.silent_url = f"tcp://127.0.0.1:{cls.silent.getsockname()[1]}"

    @classmethod
    def tearDownClass(cls):
        cls.silent.close()
        if cls.took:
            seconds, command, number = max(cls.took)
            print(f"{len(cls.took)} commands ended by a signal; the slowest, {command} by {signal.Signals(number).name}, "
                  f"within {seconds:.3f} s (0.3 s are promised of an idle machine)")
        super().tearDownClass()

    def end(self, args, busy, number):
        """Starts a command, sends the signal once busy(process) is true, checks how it ended."""
        before = self.left()
        process = subprocess.Popen([ORRERY, *args], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        held = None
        try:
            held = until(lambda: process.poll() is not None or busy(), f"{args}: in the middle of its work")
            self.assertIsNone(process.poll(), f"{args} ended by itself: {process.stderr.read() if process.poll() else ''}")
            sent = time.monotonic()
            process.send_signal(number)
            self.assertEqual(process.wait(SOON), -number)
            type(self).took.append((time.monotonic() - sent, args[0], number))
        finally:
            process.kill()
            process.wait()
            process.stderr.close()
            if isinstance(held, int) and not isinstance(held, bool):
                os.close(held)
            elif isinstance(held, socket.socket):
                held.close()
        self.assertEqual(self.left(), before)

    def cases(self):
        """Command lines that block on an input that nobody writes."""
        out = self.path("out")
        fifo = self.fifo
        os.makedirs(self.path("lab"), exist_ok=True)
        if not os.path.lexists(self.path("lab/ca.pem")):
            os.symlink(fifo, self.path("lab/ca.pem"))
        return {
            "orbit": [fifo, "-o", out],
            "states": [fifo, "-o", out],
            "satellites": [self.product, "--antex", fifo, "-o", out],
            "eclipses": [fifo, "-o", out],
            "compare": [self.product, fifo],
            "elements": [self.product, "--erp", fifo, "-o", out],
            "sisre": [fifo, sample("ORR0TSTFIN_20250800000_01D_05M_ORB.SP3.gz")],
            "navfit": [self.product, "--antex", fifo, "-o", out],
            "tec": [fifo, "--grid", "-o", out],
            "iono": [fifo, "--field", fifo, "--orbit", self.product, "-o", out],
            "imu": [fifo, "-o", out],
            "nulltest": [fifo],
            "alignment": [fifo],
            "aiding": [fifo],
            "calibration": [fifo],
            "crossovers": [fifo],
            "error-equations": [fifo],
            "export": [fifo, "--to", "pyins"],
            "vibration": [fifo],
            "allan": [fifo],
            "gravimetry": [fifo],
            "track": ["--telemetry", fifo, "-o", out],
            "delays": [fifo, "-o", out],
            "check": [fifo],
            "iq": [fifo, "-o", out],
            "simulate": [fifo, "-o", out],
            "serve": [fifo, "--listen", "tcp://127.0.0.1:0"],
            "batch": ["--archive", self.path("archive"), "--inputs", self.path("archive"), "--erp", fifo],
            "archive": ["verify", self.path("archive")],
            "figures": ["-o", self.path("figures"), "--samples", self.path("archive"), "--only", "fig3"],
            "replay": [fifo],
            "tls": ["client", self.path("lab"), "name"],
            "inspect": [fifo],
            "convert": [fifo, "-o", out],
            "fetch": ["2024-02-04", "--archives", fifo, "--cache", self.path("cache")],
        }

    def test_reading_what_nobody_writes(self):
        names = [line.split()[0] for line in run("--help").stdout.splitlines()
                 if line.startswith("  ") and not line.startswith("   ")]
        cases = self.cases()
        self.assertEqual(set(names) - {"help", *CALLERS, *MAKERS}, set(cases))
        for name, args in cases.items():
            for number in (signal.SIGINT, signal.SIGTERM):
                with self.subTest(command=name, signal=number):
                    self.end([name, *args], lambda: writer_of(self.fifo), number)

    def test_poll_of_a_silent_server(self):
        def accepted():
            self.silent.settimeout(0.01)
            try:
                return self.silent.accept()[0]
            except TimeoutError:
                return None

        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.subTest(signal=number):
                for command in CALLERS:
                    more = ["-o", self.path("out"), "--count", "5"] if command == "record" else []
                    self.end([command, self.silent_url, *more], accepted, number)

    def test_in_the_middle_of_writing(self):
        """Temporary outputs are there, and gone afterwards."""
        out = self.path("out.csv")
        for args in (["states", self.product, "--step", "0.001", "-o", out],
                     ["states", self.product, "--step", "0.001", "--format", "json", "-o", out],
                     ["elements", self.product, "--step", "0.000001", "-o", out],
                     ["elements", self.product, "--step", "0.000001", "--format", "json", "-o", out]):
            for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                with self.subTest(command=args[0], signal=number):
                    self.end(args, lambda: any(".part-" in name for name in self.left()), number)

    def test_in_the_middle_of_days(self):
        """Days that are done stay, whole."""
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            days = pathlib.Path(self.path(f"days{number}"))
            days.mkdir()
            with self.subTest(signal=number):
                self.end(["make-days", "-q", "-o", days, "--from", "2000-01-01", "--to", "2099-12-31", "--sat", "G01,G02"],
                         lambda days=days: len(os.listdir(days)) > 2, number)
                self.assertFalse([p for p in days.iterdir() if p.suffix != ".SP3" or p.read_text(encoding="ascii")[-4:] != "EOF\n"])

    def test_in_the_middle_of_computing(self):
        """Before a file is begun: readings at a high rate, maps at many instants."""
        for args in (["imu", "-q", sample("survey.yaml"), "--rate", "2000", "-o", self.path("imu.nc")],
                     ["tec", sample("ionosphere.ION"), "--grid", "--from", "2025-03-21T00:00", "--to", "2025-03-21T20:00",
                      "--step", "5", "-o", self.path("maps.csv")]):
            for number in (signal.SIGINT, signal.SIGTERM):
                with self.subTest(command=args[0], signal=number):
                    begin = time.monotonic()
                    self.end(args, lambda b=begin: time.monotonic() - b > 0.3, number)

    def test_a_service_survives_its_terminal(self):
        """SIGHUP while it prepares changes nothing, as later when it serves; the socket's file goes with it."""
        scenario = self.path("fifo.yaml")
        path = self.path("service.sock")
        pathlib.Path(scenario).write_text(f"orbit: {{sp3: [{self.fifo}]}}\nserve: {{listen: ['unix:{path}']}}\n", encoding="utf-8")
        before = self.left()
        p = subprocess.Popen([ORRERY, "serve", scenario], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        try:
            writer = until(lambda: writer_of(self.fifo), "serve reads its orbits")
            self.assertTrue(os.path.exists(path))
            p.send_signal(signal.SIGHUP)
            with self.assertRaises(subprocess.TimeoutExpired):
                p.wait(0.5)
            p.send_signal(signal.SIGTERM)
            self.assertEqual(p.wait(SOON), -signal.SIGTERM)
            os.close(writer)
        finally:
            p.kill()
            p.wait()
            p.stderr.close()
        self.assertEqual(self.left(), before)

    def test_ignored_signals_stay_ignored(self):
        """nohup and a shell's background jobs have them ignored."""
        old = signal.signal(signal.SIGHUP, signal.SIG_IGN)
        try:
            p = subprocess.Popen([ORRERY, "convert", self.fifo], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            try:
                writer = until(lambda: writer_of(self.fifo), "convert reads")
                p.send_signal(signal.SIGHUP)
                os.write(writer, b"no format at all\n")
                os.close(writer)
                p.communicate(timeout=SOON)
                self.assertEqual(p.returncode, 1)
            finally:
                p.kill()
                p.wait()
        finally:
            signal.signal(signal.SIGHUP, old)


if __name__ == "__main__":
    unittest.main()
