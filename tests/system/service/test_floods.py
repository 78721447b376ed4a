#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Floods of handshakes and of KeyUpdates against the service itself (invariants S6 and S7 of docs/security.md): whoever is connected is answered
all the while, and afterwards others come in as before. ORRERY_HARD_S seconds each at least, 1 by default."""
import contextlib
import ctypes
import os
import pathlib
import socket
import ssl
import threading
import time
import unittest

from daemon import PATIENCE_S, Shared, laboratory, product  # first: it sets the path

import orrery

SECONDS = float(os.environ.get("ORRERY_HARD_S", "1"))
POLLS = 20  # at least, however slow the machine
WHEN = "2025-03-21T12:00:00"


class Library:
    """OpenSSL by its own face: Python's has no KeyUpdate."""

    def __init__(self):
        self.lib = ctypes.CDLL("libssl.so.3")
        for name in ("TLS_client_method", "SSL_CTX_new", "SSL_new"):
            getattr(self.lib, name).restype = ctypes.c_void_p

    def context(self, identity):
        """A client's, with the certificate and the key of a file."""
        made = ctypes.c_void_p(self.lib.SSL_CTX_new(ctypes.c_void_p(self.lib.TLS_client_method())))
        path = os.fsencode(identity)
        if self.lib.SSL_CTX_use_certificate_chain_file(made, path) != 1 or self.lib.SSL_CTX_use_PrivateKey_file(made, path, 1) != 1:
            raise RuntimeError(f"OpenSSL does not take {identity}")
        return made

    def updates(self, context, place, most):
        """Connects and sends KeyUpdates, each to be answered by another, until it is cut off: how many were sent."""
        with socket.create_connection(place, PATIENCE_S) as s:
            s.settimeout(None)
            link = ctypes.c_void_p(self.lib.SSL_new(context))
            try:
                sent = 0
                if self.lib.SSL_set_fd(link, s.fileno()) == 1 and self.lib.SSL_connect(link) == 1:
                    while sent < most and self.lib.SSL_key_update(link, 1) == 1 and self.lib.SSL_do_handshake(link) == 1:
                        sent += 1
                return sent
            finally:
                self.lib.SSL_free(link)


class Floods(Shared):
    @classmethod
    def setUpClass(cls):
        cls.lab = laboratory("lab", "generator")
        rules = cls.lab / "floods.yaml"
        rules.write_text("certificate: server.pem\nkey: server.key\nauthority: ca.pem\nclients:\n  - {name: generator, may: read}\n"
                         "limits: {handshakes: 8, handshake_s: 0.3}\n", encoding="utf-8")
        cls.serve(product(), "--access", rules, listen=("tls://127.0.0.1:0",))
        host, port = cls.url[6:].rsplit(":", 1)
        cls.place = (host, int(port))

    def client(self):
        return orrery.Client(self.url, identity=str(self.lab / "generator.pem"), timeout_s=PATIENCE_S)

    def resident_kb(self):
        status = pathlib.Path(f"/proc/{self.daemon.process.pid}/status").read_text(encoding="ascii")
        return int(status.split("VmRSS:")[1].split()[0])

    def beside(self, *floods):
        """Polls all through the floods, each a function that is called again and again by a thread of its own: how many polls."""
        over, failed, polls = threading.Event(), [], 0

        def again(flood):
            while not over.is_set():
                try:
                    flood()
                except Exception as error:  # pylint: disable=broad-except # told by the test's own thread
                    failed.append(error)
                    return

        with self.client() as client:
            want = client.states(WHEN)
            threads = [threading.Thread(target=again, args=(f,), daemon=True) for f in floods]
            for t in threads:
                t.start()
            end = time.monotonic() + SECONDS
            while time.monotonic() < end or polls < POLLS:
                self.assertEqual(client.states(WHEN), want)
                polls += 1
            over.set()
            for t in threads:
                t.join(PATIENCE_S)
            self.assertEqual(failed, [])
            self.assertEqual(client.states(WHEN), want)
        end = time.monotonic() + PATIENCE_S
        while True:  # handshakes that are still under way end in their time; then who comes is let in
            try:
                with self.client() as late:
                    self.assertEqual(late.states(WHEN), want)
                return polls
            except (OSError, EOFError):
                if time.monotonic() > end:
                    raise
                time.sleep(0.05)

    def test_handshakes(self):
        """Begun and left, begun and broken off, and whole ones without a certificate, as fast as they can."""
        nobody = ssl.create_default_context(cafile=str(self.lab / "ca.pem"))
        nobody.check_hostname = False
        count = {"left": 0, "broken": 0, "whole": 0}

        def left():
            with contextlib.ExitStack() as held:
                for _ in range(50):
                    with contextlib.suppress(OSError):
                        held.enter_context(socket.create_connection(self.place, PATIENCE_S)).sendall(b"\x16\x03\x01\x02\x00\x01")
                        count["left"] += 1
                time.sleep(0.02)

        def broken():
            with contextlib.suppress(OSError), socket.create_connection(self.place, PATIENCE_S) as s:
                s.sendall(b"\x16\x03\x01\x02\x00" + bytes(512))
                count["broken"] += 1

        def whole():
            with contextlib.suppress(OSError), socket.create_connection(self.place, PATIENCE_S) as s, nobody.wrap_socket(s) as t:
                count["whole"] += 1
                self.assertEqual(t.recv(1), b"")  # nothing is answered: an end or, as an alert, an error

        before = self.resident_kb()
        polls = self.beside(left, broken, whole, whole)
        print(f"{polls} polls beside handshakes: {count}")
        self.assertGreater(min(count.values()), 0)
        self.assertGreater(sum(count.values()), 100)
        self.assertTrue(self.daemon.said("as many TLS handshakes are under way as may be"))
        self.assertLess(len(self.daemon.lines), 300)  # a flood does not fill the log
        self.assertLess(self.resident_kb() - before, 8192)

    def test_key_updates(self):
        library, most = Library(), 100000
        context = library.context(self.lab / "generator.pem")
        sent = []
        before = self.resident_kb()
        polls = self.beside(*[lambda: sent.append(library.updates(context, self.place, most))] * 3)
        print(f"{polls} polls beside {sum(sent)} KeyUpdates by {len(sent)} clients, {max(sent)} by one")
        self.assertGreater(sum(n > 16 for n in sent), 3)  # those that got in; they were cut off, each of them
        self.assertLess(max(sent), most)
        self.assertLess(self.resident_kb() - before, 8192)


if __name__ == "__main__":
    unittest.main(argv=["test_floods"])
