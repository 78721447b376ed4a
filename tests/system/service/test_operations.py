# SPDX-License-Identifier: GPL-3.0-or-later
"""What operators and their programs see: ids of lines, JSON, the supervisor's messages and sockets, metrics, the unit file."""
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import time
import unittest
import urllib.request

from daemon import ORRERY, PATIENCE_S, ROOT, WORK, Daemon, orrery, product

import orrery as client


class Lines(unittest.TestCase):
    def test_table(self):
        """Each id of the sources has one row of the table, each row an id."""
        used = set()
        for folder in ("src/service", "src/cli/service"):
            for path in (ROOT / folder).rglob("*.[ch]"):
                used |= set(re.findall(r'ORR_ID\("([A-Z][0-9]{2})"\)', path.read_text()))
        rows = re.findall(r"^\| ([A-Z][0-9]{2}) \|", (ROOT / "docs/operations.md").read_text(), re.M)
        self.assertEqual(sorted(rows), sorted(used))

    def test_text_and_json(self):
        with Daemon(product(), "--log", "text") as daemon:
            with socket.create_connection(("127.0.0.1", int(daemon.urls[0].rsplit(":", 1)[1])), 10) as s:
                s.sendall(b"nonsense that is no frame at all")
                s.recv(1000)
            self.assertTrue(daemon.said("[N11]"))
            self.assertTrue(daemon.said("[R01]"))
        process = subprocess.Popen([ORRERY, "serve", str(product()), "--listen", "tcp://127.0.0.1:0", "--log", "json"], stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        ready = json.loads(process.stderr.readline())
        self.assertEqual((ready["id"], ready["level"]), ("R01", "info"))
        port = int(re.search(r"127\.0\.0\.1:(\d+)", ready["message"]).group(1))
        with socket.create_connection(("127.0.0.1", port), 10) as s:
            s.sendall(b"\xffnonsense\"\n" + bytes(40))
            s.recv(1000)
        nonsense = json.loads(process.stderr.readline())
        self.assertEqual((nonsense["id"], nonsense["level"]), ("N11", "warning"))
        self.assertRegex(nonsense["time"], r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z$")
        process.terminate()
        self.assertEqual([json.loads(line)["id"] for line in process.stderr][-1], "R03")
        process.stderr.close()


class Supervisor(unittest.TestCase):
    def serve(self, *args, fds=(), **env):
        where = WORK / "notify"
        if where.exists():
            where.unlink()
        told = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
        told.bind(str(where))
        told.settimeout(PATIENCE_S)
        self.addCleanup(told.close)
        handed = [(fd.fileno(), 3 + k) for k, fd in enumerate(fds)]

        def prepare():
            os.environ["LISTEN_PID"] = str(os.getpid())
            for fd, to in handed:
                os.dup2(fd, to)
                os.set_inheritable(to, True)
            if handed:
                os.environ.update(LISTEN_FDS=str(len(handed)))
            os.environ.update({**env, "NOTIFY_SOCKET": str(where)})
            os.execv(ORRERY, [ORRERY, "serve", str(product()), *args])

        pid = os.fork()
        if pid == 0:
            try:
                prepare()
            finally:
                os._exit(127)
        self.addCleanup(self.end, pid)
        return pid, told

    def end(self, pid):
        try:
            os.kill(pid, signal.SIGKILL)
            os.waitpid(pid, 0)
        except (ProcessLookupError, ChildProcessError):
            pass

    def test_messages(self):
        pid, told = self.serve("--listen", "tcp://127.0.0.1:0", "--quiet", WATCHDOG_USEC="900000")
        seen = [told.recv(1000).decode()]
        self.assertIn("READY=1", seen[0])
        end = time.monotonic() + PATIENCE_S
        while sum(m == "WATCHDOG=1" for m in seen) < 3 and time.monotonic() < end:
            seen.append(told.recv(1000).decode())
        self.assertGreaterEqual(sum(m == "WATCHDOG=1" for m in seen), 3)
        os.kill(pid, signal.SIGHUP)
        while "RELOADING=1" not in seen[-1] and time.monotonic() < end:
            seen.append(told.recv(1000).decode())
        self.assertRegex(seen[-1], r"MONOTONIC_USEC=\d+")
        while seen[-1] != "READY=1" and time.monotonic() < end:
            seen.append(told.recv(1000).decode())
        os.kill(pid, signal.SIGTERM)
        while seen[-1] != "STOPPING=1" and time.monotonic() < end:
            seen.append(told.recv(1000).decode())
        self.assertEqual(seen[-1], "STOPPING=1")
        self.assertEqual(os.waitpid(pid, 0)[1], 0)

    def test_sockets(self):
        """Sockets that were handed over are served, and no other; the service leaves their files alone."""
        path = WORK / "handed"
        unix, tcp = socket.socket(socket.AF_UNIX), socket.socket()
        self.addCleanup(unix.close)
        self.addCleanup(tcp.close)
        unix.bind(str(path))
        tcp.bind(("127.0.0.1", 0))
        unix.listen()
        tcp.listen()
        pid, told = self.serve("--quiet", fds=(unix, tcp))
        self.assertIn("READY=1", told.recv(1000).decode())
        for url in (f"unix:{path}", f"tcp://127.0.0.1:{tcp.getsockname()[1]}"):
            with client.Client(url) as c:
                c.ping()
        os.kill(pid, signal.SIGTERM)
        self.assertEqual(os.waitpid(pid, 0)[1], 0)
        self.assertTrue(path.exists())


class Monitors(unittest.TestCase):
    def test_metrics(self):
        with Daemon(product(), "--http", "127.0.0.1:0") as daemon:
            page = next(w for line in daemon.lines for w in line.split() if w.startswith("http://"))
            with client.Client(daemon.urls[0]) as c:
                c.ping()
                text = urllib.request.urlopen(page + "metrics", timeout=PATIENCE_S).read().decode()
            values = dict(line.split() for line in text.splitlines() if not line.startswith("#"))
            self.assertEqual(values["orrery_clients"], "1")
            self.assertEqual(values["orrery_requests_total"], "2")  # HELLO and PING
            for line in text.splitlines():
                self.assertRegex(line, r"^(# (HELP|TYPE) orrery_[a-z_]+ .+|orrery_[a-z_]+(\{[a-z]+=\"[^\"]*\"\})? [-+0-9.e]+)$")
            self.assertEqual(urllib.request.urlopen(page + "healthz", timeout=PATIENCE_S).read(), b"ok\n")

    @unittest.skipUnless(shutil.which("systemd-analyze"), "there is no systemd-analyze")
    def test_unit(self):
        done = subprocess.run(["systemd-analyze", "security", "--offline=true", "--threshold=20", str(ROOT / "packaging/orrery.service")],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main(argv=["test_operations"])
