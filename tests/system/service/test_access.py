# SPDX-License-Identifier: GPL-3.0-or-later
"""TLS from the command line and from Python: a laboratory made by `orrery tls init`, a service that takes it, SIGHUP, other machines."""
import pathlib
import signal
import socket
import ssl
import stat
import unittest

import yaml

from daemon import PATIENCE_S, ROOT, WORK, Daemon, laboratory, orrery, product, scenario

import orrery as client
from test_streams import SCENARIO


class Access(unittest.TestCase):
    def setUp(self):
        self.lab = laboratory("lab", "generator", "cockpit")

    def serve(self, *args, listen=("tls://127.0.0.1:0",), access=None):
        daemon = Daemon(product(), "--access", access or self.lab / "access.yaml", *args, listen=listen)
        self.addCleanup(daemon.__exit__)
        return daemon

    def rules(self, text):
        """An access file beside the certificates."""
        path = self.lab / "other.yaml"
        path.write_text("certificate: server.pem\nkey: server.key\nauthority: ca.pem\nclients:\n" + text)
        return path

    def test_files(self):
        for name in ("ca.key", "server.key", "generator.pem", "cockpit.pem"):
            self.assertEqual(stat.S_IMODE((self.lab / name).stat().st_mode), 0o600, name)
        self.assertIn("name: cockpit", (self.lab / "access.yaml").read_text())
        again = orrery("tls", "init", self.lab)
        self.assertEqual(again.returncode, 2)
        self.assertIn("there is an authority already", again.stderr)

    def test_same_answers(self):
        """TLS carries the same bytes, from the command line and from Python, of one epoch and of a long series."""
        daemon = self.serve(listen=("tls://127.0.0.1:0", "tcp://127.0.0.1:0"))
        tls, tcp = daemon.urls
        ask = ("--at", "2025-03-21T12:00:00", "--step", "0.1", "--count", "40", "--format", "csv")
        secret = orrery("poll", tls, "--identity", self.lab / "generator.pem", *ask)
        self.assertEqual(secret.returncode, 0, secret.stderr)
        self.assertEqual(secret.stdout, orrery("poll", tcp, *ask).stdout)
        with client.Client(tls, identity=str(self.lab / "generator.pem")) as one, client.Client(tcp) as two:
            self.assertEqual(one.caps.access, 0)
            for a, b in zip(one.poll("2025-03-21T12:00:00", step_s=0.1, count=3000), two.poll("2025-03-21T12:00:00", step_s=0.1, count=3000)):
                self.assertEqual(a, b)

    def test_streams(self):
        """Streams beside polls, as fast as they are taken."""
        daemon = self.serve()
        with client.Client(daemon.urls[0], identity=str(self.lab / "generator.pem")) as c:
            stream = c.subscribe(client.messages.Poll(), t="2025-03-21T12:00:00", step_s=0.1, count=2000, pacing="free", credit=500)
            blocks = 0
            for block in stream:
                blocks += 1
                if blocks % 500 == 0:
                    self.assertEqual(c.states(block.t), block)
            self.assertEqual(blocks, 2000)

    def test_permissions(self):
        rules = self.rules("  - {name: generator, may: read}\n  - {name: cockpit, may: motion}\n")
        daemon = self.serve("--start", "command", "--verbose", access=rules)
        url = daemon.urls[0]
        with client.Client(url, identity=str(self.lab / "generator.pem")) as c:
            self.assertEqual(c.caps.access, client.messages.Access.NO_MOTION | client.messages.Access.NO_CONTROL)
            c.states("2025-03-21T12:00:00")
            with self.assertRaises(client.Refused) as refused:
                c.control("start")
            self.assertEqual(refused.exception.code, client.messages.ErrorCode.NOT_PERMITTED)
        with client.Client(url, identity=str(self.lab / "cockpit.pem")) as c:
            with self.assertRaises(client.Refused):
                c.states("2025-03-21T12:00:00")
            with self.assertRaises(client.Refused):
                c.subscribe(client.messages.Poll(), t="2025-03-21T12:00:00", step_s=1, count=1, pacing="free")
            # The clock is who has been told it may be: SIGHUP makes it so, and the connection lives on.
            self.rules("  - {name: generator, may: read}\n  - {name: cockpit, may: [motion, control]}\n")
            daemon.process.send_signal(signal.SIGHUP)
            self.assertTrue(daemon.said("read again"))
            c.control("start")
            rules.write_text("clients: 3\n")
            daemon.process.send_signal(signal.SIGHUP)
            self.assertTrue(daemon.said("still holds"))
            c.time()

    def test_strangers(self):
        other = laboratory("elsewhere", "generator")
        daemon = self.serve()
        wrong = orrery("poll", daemon.urls[0], "--identity", other / "generator.pem")
        self.assertEqual(wrong.returncode, 1)
        self.assertIn("certificate verify failed", wrong.stderr)
        none = orrery("poll", daemon.urls[0])
        self.assertEqual(none.returncode, 2)
        self.assertIn("wants a certificate", none.stderr)
        more = orrery("tls", "client", self.lab, "stranger")
        self.assertEqual(more.returncode, 0, more.stderr)
        stranger = orrery("poll", daemon.urls[0], "--identity", self.lab / "stranger.pem")
        self.assertEqual(stranger.returncode, 1)
        self.assertIn("does not know the name", stranger.stderr)
        # Who speaks without TLS is told nothing.
        host, port = daemon.urls[0][6:].rsplit(":", 1)
        with socket.create_connection((host, int(port)), 10) as plain:
            plain.sendall(b"ORRY" + bytes(100))
            try:
                told = plain.recv(1000)
            except ConnectionResetError:
                told = b""
            self.assertNotIn(b"ORRY", told)

    def test_other_machines(self):
        refused = orrery("serve", product(), "--listen", "tcp://*:0")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("--insecure-listen", refused.stderr)
        daemon = Daemon(product(), "--insecure-listen", listen=("tcp://*:0",))
        self.addCleanup(daemon.__exit__)
        self.assertTrue(daemon.said("without authentication"))
        port = daemon.urls[0].rsplit(":", 1)[1]
        with client.Client(f"tcp://127.0.0.1:{port}") as c:
            self.assertEqual(c.caps.access, client.messages.Access.INSECURE)

    def secret(self, url, name):
        """A bare connection by TLS as this client."""
        context = ssl.create_default_context(cafile=str(self.lab / "ca.pem"))
        context.load_cert_chain(self.lab / f"{name}.pem")
        host, port = url[6:].rsplit(":", 1)
        s = context.wrap_socket(socket.create_connection((host, int(port)), PATIENCE_S), server_hostname=host)
        self.addCleanup(s.close)
        return s

    def ends(self, s):
        """The peer closes, whatever it sends before."""
        try:
            while s.recv(1 << 16):
                pass
        except (ssl.SSLEOFError, ConnectionResetError):
            pass

    def test_every_door(self):
        """Rules that are read again hold at the text twin and at receivers' ports too, for who is there already."""
        rules = self.rules("  - {name: generator, may: [read, motion, control]}\n")
        daemon = Daemon(scenario("doors.yaml", SCENARIO), "--access", rules, "--text", "tls://127.0.0.1:0", "--rtcm", "BASE@tls://127.0.0.1:0", "--verbose", "--start", "command",
                        listen=("tls://127.0.0.1:0",))
        self.addCleanup(daemon.__exit__)
        _, text, port = [word.rstrip(",") for word in daemon.urls if word.startswith("tls://")]
        one, two = self.secret(text, "generator"), self.secret(port, "generator")
        lines = one.makefile("rw", encoding="ascii", newline="\n")

        def query(line):
            lines.write(line + "\n")
            lines.flush()
            return lines.readline()

        self.assertTrue(query("SCEN:STAR;:SYST:ERR?").startswith("0,"))
        for may in ("read", None):
            self.rules(f"  - {{name: generator, may: {may}}}\n" if may else "  - {name: other, may: read}\n")
            before = len(daemon.lines)
            daemon.process.send_signal(signal.SIGHUP)
            self.assertTrue(daemon.said_since(before, "[R05]"))
            if may:
                self.assertTrue(query("SCEN:PAUS;:SYST:ERR?").startswith("-203,"))
                self.assertIn("NOT_PERMITTED", query('{"request": "CONTROL", "action": "STOP"}'))
                self.assertIn("RUNNING", query('{"request": "GET_TIME"}'))
        self.ends(one)
        self.ends(two)
        self.assertTrue(daemon.said("may not read any more [N14]"))
        self.assertTrue(daemon.said("does not name it any more [N14]"))

    def test_every_door_in_the_open(self):
        """Each address that other machines reach without TLS is warned of, and SIGHUP cannot leave one open that the rules no longer allow."""
        rules = WORK / "open.yaml"
        rules.write_text("insecure_listen: true\n")
        daemon = Daemon(scenario("doors.yaml", SCENARIO), "--access", rules, "--text", "tcp://*:0", "--rtcm", "BASE@tcp://0.0.0.0:0", "--verbose", listen=("tcp://*:0",))
        self.addCleanup(daemon.__exit__)
        self.assertEqual(sum("[R09]" in line for line in daemon.lines), 3, daemon.lines)
        rules.write_text("limits: {clients: 8}\n")
        daemon.process.send_signal(signal.SIGHUP)
        self.assertTrue(daemon.said("insecure_listen any more"))
        rules.write_text("insecure_listen: true\n")
        daemon.process.send_signal(signal.SIGHUP)
        self.assertTrue(daemon.said("[R05]"))

    def test_no_files(self):
        """No request has a text but HELLO, which names the client, and CONTROL, which may name a scenario of the folder of --scenarios by
        letters, digits, _ and - alone (system.service.load tries others): nothing that could be a path goes to the server."""
        spec = yaml.safe_load((ROOT / "proto/spec/messages.yaml").read_text())
        texts = [f"{name}.{field['name']}" for name, m in spec["messages"].items() if m["from"] == "client"
                 for field in m.get("fields", []) if field["type"].startswith("string")]
        self.assertEqual(texts, ["HELLO.name", "HELLO.version", "CONTROL.scenario"])

    def test_unix_mode(self):
        path = pathlib.Path(WORK / "socket")
        daemon = Daemon(product(), listen=(f"unix:{path}",))
        self.addCleanup(daemon.__exit__)
        self.assertEqual(stat.S_IMODE(path.stat().st_mode), 0o660)


if __name__ == "__main__":
    unittest.main(argv=["test_access"])
