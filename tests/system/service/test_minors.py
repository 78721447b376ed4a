#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Clients and servers one minor version apart, both ways (docs/protocol.md, "Versions"). The minor version after this one is made here, by
appending to the specification what a minor version may append: fields of messages and of records in lists, a value of an enum, a message.
Its client asks the real service; clients of this version, in Python and in C, ask the service through a relay that makes its answers the next
version's."""
import importlib
import os
import shlex
import shutil
import socket
import subprocess
import sys
import threading
import unittest

from daemon import FIRMWARE, PATIENCE_S, ROOT, WORK, Shared  # first: it sets the path

import yaml

import orrery
from orrery.client import connect
from orrery.messages import ErrorCode

WHEN = "2025-03-21T12:00:00"
UNIT = {"type": "f64", "since": 1, "doc": "of the next version"}


def next_package():
    """The Python client of the minor version after this one, as the package `orrery_next`."""
    with open(ROOT / "proto/spec/messages.yaml", encoding="utf-8") as f:
        spec = yaml.safe_load(f)
    spec["protocol"]["minor"] += 1
    spec.pop("examples", None)  # frames of this version
    for name in ("HELLO", "CAPS", "POLL", "STATES", "TIME"):
        spec["messages"][name]["fields"].append({"name": "appended", **UNIT})
    spec["structs"]["sat_state"]["fields"].append({"name": "appended", **UNIT})
    spec["enums"]["answer"]["values"]["LATER"] = {"value": 77, "doc": "an answer of the next version"}
    spec["messages"]["LATER_QUESTION"] = {"type": 900, "from": "client", "answer": "PONG", "built_in": True, "doc": "Asks something new.",
                                          "fields": [{"name": "token", "type": "u64", "doc": "anything"}]}
    folder = WORK / "orrery_next"
    shutil.copytree(ROOT / "proto/python/orrery", folder, ignore=shutil.ignore_patterns("__pycache__"))
    (WORK / "messages.yaml").write_text(yaml.safe_dump(spec, sort_keys=False), encoding="utf-8")
    made = subprocess.run([sys.executable, "-B", ROOT / "proto/spec/generate.py", "--spec", WORK / "messages.yaml", "--out", folder, "--client"],
                          capture_output=True, text=True, check=False)
    if made.returncode != 0:
        raise RuntimeError(made.stderr)
    sys.path.insert(0, str(WORK))
    return importlib.import_module("orrery_next")


def next_firmware():
    """Firmware's client of that version, in C, compiled: its program's path."""
    folder, program = WORK / "orrery_next", WORK / "firmware_next"
    made = subprocess.run([*shlex.split(os.environ.get("CC", "cc")), "-std=c99", "-D_POSIX_C_SOURCE=200809L", f"-I{folder}", folder / "orrery_client.c",
                           ROOT / "tests/system/proto/firmware.c", "-o", program], capture_output=True, text=True, check=False)
    if made.returncode != 0:
        raise RuntimeError(made.stderr)
    return program


def told(program, url):
    """What firmware's client prints of a service."""
    return subprocess.run([program, "127.0.0.1", url.rsplit(":", 1)[1]], capture_output=True, text=True, timeout=PATIENCE_S, check=True).stdout


class Later:
    """A relay in front of a service, which thereby speaks the next minor version: `with Later(next, url) as url:`."""

    def __init__(self, package, url):
        self.package, self.behind = package, url
        self.door = socket.create_server(("127.0.0.1", 0))
        self.changed = 0

    def __enter__(self):
        threading.Thread(target=self.serve, daemon=True).start()
        return f"tcp://127.0.0.1:{self.door.getsockname()[1]}"

    def __exit__(self, *_):
        self.door.close()

    def serve(self):
        while True:
            try:
                client, _ = self.door.accept()
            except OSError:
                return
            threading.Thread(target=self.converse, args=(client,), daemon=True).start()

    def converse(self, client):
        frame = self.package.frame
        service = connect(self.behind, PATIENCE_S)
        threading.Thread(target=self.pass_on, args=(client, service), daemon=True).start()
        answers = service.makefile("rb")

        def receive(n):
            data = answers.read(n)
            if len(data) < n:
                raise EOFError
            return data
        try:
            while True:
                got = frame.read(receive)
                client.sendall(frame.make(got.type, got.sequence, self.grown(got)))
        except (EOFError, OSError):
            pass
        finally:
            answers.close()
            service.close()
            client.close()

    @staticmethod
    def pass_on(client, service):
        try:
            while data := client.recv(65536):
                service.sendall(data)
            service.shutdown(socket.SHUT_WR)
        except OSError:
            pass

    def grown(self, got):
        """The payload as the next version would have it."""
        m = self.package.messages
        if got.type not in (m.Caps.TYPE, m.States.TYPE, m.Time.TYPE):
            return got.payload
        message = got.message()
        message.appended = 1.5
        for k, state in enumerate(getattr(message, "satellites", [])):
            if isinstance(state, m.SatState):
                state.appended = 100.0 + k
        if got.type == m.Caps.TYPE:
            message.minor = m.MINOR
            message.requests.append(m.ServedRequest(900, m.Pong.TYPE))
        self.changed += 1
        return message.encode()


class Minors(Shared):
    @classmethod
    def setUpClass(cls):
        cls.next = next_package()
        super().setUpClass()

    def test_next_client(self):
        """It is answered what a client of this version is; what it appended is passed over, what it misses reads as zero, what it asks anew
        is refused, and it goes on."""
        m = self.next.messages
        self.assertEqual(m.MINOR, orrery.messages.MINOR + 1)
        with orrery.Client(self.url) as now, self.next.Client(self.url, timeout_s=PATIENCE_S) as later:
            self.assertEqual((later.caps.minor, later.caps.appended), (orrery.messages.MINOR, 0.0))
            self.assertEqual(later.caps.satellites[0].number, now.caps.satellites[0].number)
            asked = m.Poll(m.Epochs(orrery.from_text(WHEN), 10**9, 3), [], 7.25)
            self.assertGreater(len(asked.encode()), len(orrery.messages.Poll(orrery.messages.Epochs(), []).encode()))
            answers = list(later._answers(asked, m.States, 3))
            wanted = list(now.poll(WHEN, step_s=1, count=3))
            self.assertEqual(len(answers), 3)
            for got, want in zip(answers, wanted):
                self.assertEqual(got.appended, 0.0)
                self.assertEqual({s.appended for s in got.satellites}, {0.0})
                self.assertEqual([(s.pos_m, s.clock_s, s.sigma_m) for s in got.satellites],
                                 [(s.pos_m, s.clock_s, s.sigma_m) for s in want.satellites])
            with self.assertRaises(self.next.Refused) as refusal:
                later._ask(m.LaterQuestion(5), m.Pong)
            self.assertEqual(refusal.exception.code, ErrorCode.UNKNOWN_TYPE)
            later.ping(9)
            self.assertEqual(later.time().appended, 0.0)

    @unittest.skipUnless(shutil.which(shlex.split(os.environ.get("CC", "cc"))[0]), "no C compiler")
    def test_next_client_in_c(self):
        """Firmware built from the next version's client reads this service, and that one, as today's does."""
        program = next_firmware()
        self.assertIn(f"#define ORR_MSG_MINOR {self.next.messages.MINOR}u", (WORK / "orrery_next/orrery_client.h").read_text(encoding="utf-8"))
        want = told(FIRMWARE, self.url)
        self.assertGreater(len(want.splitlines()), 20)
        self.assertEqual(told(program, self.url), want)
        with Later(self.next, self.url) as url:
            self.assertEqual(told(program, url), want)

    def test_next_server(self):
        """Clients of this version read its answers as those of this one, whatever was appended."""
        later = Later(self.next, self.url)
        with later as url:
            with orrery.Client(self.url) as direct, orrery.Client(url, timeout_s=PATIENCE_S) as client:
                self.assertEqual(client.caps.minor, orrery.messages.MINOR + 1)
                self.assertEqual(client.caps.requests[-1].request, 900)
                self.assertEqual(list(client.poll(WHEN, step_s=1, count=5)), list(direct.poll(WHEN, step_s=1, count=5)))
                client.ping(3)
                self.assertEqual(client.time().state, direct.time().state)
            now, grown = told(FIRMWARE, self.url), told(FIRMWARE, url)
            self.assertGreater(len(now.splitlines()), 20)
            self.assertEqual(now, grown)
        self.assertGreater(later.changed, 8)  # it was the next version indeed

    def test_answer_of_later(self):
        """An answer that this version does not know is passed on as a number, beside the others."""
        m = self.next.messages
        states = m.States(m.Epoch(), [m.SatState(m.SatId(ord("G"), 1), m.Answer.LATER), m.SatState(m.SatId(ord("G"), 2))], 1.0)
        got = orrery.messages.States.decode(states.encode())
        self.assertEqual([s.answer for s in got.satellites], [77, 0])
        self.assertEqual(got.satellites[0].answer.name, "UNKNOWN_77")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
