#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""orrery serve and orrery poll as commands: starting, refusing to start, stopping, and what they print."""
import json
import os
import signal
import socket
import subprocess
import time
import unittest

from daemon import ORRERY, PATIENCE_S, ROOT, SAMPLE, WORK, Daemon, Shared, orrery, product  # first: it sets the path

import orrery as client_package
from orrery import frame, messages


def write(name, text):
    path = WORK / name
    path.write_text(text, encoding="utf-8")
    return path


class Starting(unittest.TestCase):
    def refused(self, status, words, what, *args):
        done = orrery("serve", what, *(args or ("--listen", "tcp://127.0.0.1:0")))  # not the port that another test may have
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertNotIn("ready", done.stderr)
        self.assertIn(words, done.stderr)

    def test_scenarios_that_are_none(self):
        self.refused(1, "bad1.yaml:2:3: unknown key 'orbit.prodcut'; did you mean 'orbit.product'?",
                     write("bad1.yaml", "orbit:\n  prodcut: day.nc\n"))
        self.refused(1, "bad2.yaml", write("bad2.yaml", "orbit: [a\nb: c\n"))
        self.refused(1, "not YAML", WORK / "bad2.yaml")
        self.refused(1, "no orbits", write("bad3.yaml", "title: nothing\n"))
        self.refused(1, "nonexistent.yaml", WORK / "nonexistent.yaml")
        self.refused(1, str(WORK / "missing.sp3"), write("bad4.yaml", "orbit: {sp3: missing.sp3}\n"))
        self.refused(1, "bad1.yaml: is no NetCDF file", write("no-product.yaml", "orbit: {product: bad1.yaml}\n"))
        (WORK / "binary").write_bytes(bytes(range(256)))
        self.refused(1, "binary data", WORK / "binary")
        (WORK / "fake.nc").write_bytes(b"\x89HDF\r\n\x1a\n" + bytes(100))
        self.refused(1, "fake.nc", WORK / "fake.nc")
        self.refused(1, "", WORK)

    def test_addresses_that_are_none(self):
        self.refused(2, "is no address", product(), "--listen", "127.0.0.1:80")
        self.refused(2, "at most 65535", product(), "--listen", "tcp://127.0.0.1:99999")
        self.assertEqual(orrery("serve").returncode, 2)
        self.assertEqual(orrery("poll", "nowhere").returncode, 2)

    def test_a_port_in_use(self):
        with Daemon(product(), listen=("tcp://127.0.0.1:0", f"unix:{WORK}/used.sock")) as d:
            for url in d.urls:
                self.refused(1, "another program is listening there", product(), "--listen", url)
            with client_package.Client(d.urls[1]) as c:  # and the first one has not lost its socket
                c.ping()

    def test_a_socket_left_by_a_killed_server(self):
        url = f"unix:{WORK}/left.sock"
        d = Daemon(product(), listen=(url,))
        self.assertNotEqual(d.stop(signal.SIGKILL), 0)
        self.assertTrue((WORK / "left.sock").exists())
        with Daemon(product(), listen=(url,)) as again:
            with client_package.Client(url) as c:
                c.ping()
            self.assertEqual(again.stop(), 0)
        self.assertFalse((WORK / "left.sock").exists())
        write("plain.sock", "not a socket")
        self.refused(1, "no socket", product(), "--listen", f"unix:{WORK}/plain.sock")
        self.assertEqual((WORK / "plain.sock").read_text(), "not a socket")

    def test_a_scenario_of_sp3_files(self):
        here = WORK / "scenarios"
        here.mkdir()
        relative = os.path.relpath(SAMPLE, here)
        path = write("scenarios/day.yaml", f"title: A made day\norbit:\n  sp3: [{relative}]\n  nodes: 3600\n"
                     f"serve:\n  listen: unix:{WORK}/scenario.sock\n")
        with Daemon(path, listen=(), cwd="/") as d:  # paths are the scenario's, wherever the program is started
            self.assertEqual(d.urls, [f"unix:{WORK}/scenario.sock"])
            with client_package.Client(d.urls[0]) as c:
                self.assertEqual((c.caps.title, len(c.satellites)), ("A made day", 80))
                self.assertEqual(sum(s.answer == 0 for s in c.states(c.span[0] + 10**12).satellites), 80)

    def test_help_of_scenarios_stands_in_the_docs(self):
        done = orrery("serve", "--help-scenario")
        self.assertEqual(done.returncode, 0)
        self.assertIn(f"```\n{done.stdout}```", (ROOT / "docs/scenario.md").read_text(encoding="utf-8"))


class Stopping(unittest.TestCase):
    def test_signals(self):
        for number in (signal.SIGTERM, signal.SIGINT):
            d = Daemon(product(), listen=("tcp://127.0.0.1:0", f"unix:{WORK}/stop.sock"))
            with client_package.Client(d.urls[0]):
                self.assertEqual(d.stop(number), 0)
            self.assertFalse((WORK / "stop.sock").exists())

    def ends_by(self, number, scenario, is_busy):
        """Starts a service, waits until it is being prepared, and sends the signal: it ends by it, and nothing is left."""
        place = WORK / "early.sock"
        with subprocess.Popen([ORRERY, "serve", "-v", str(scenario), "--listen", f"unix:{place}"], stderr=subprocess.PIPE,
                              text=True) as process:
            try:
                is_busy(process)
                process.send_signal(number)
                said = process.stderr.read()
                self.assertEqual(process.wait(PATIENCE_S), -number, said)
            finally:
                process.kill()
        self.assertNotIn("ready on", said)
        self.assertFalse(place.exists())

    def test_signals_during_the_preparation(self):
        """While orbits are being smoothed, and while the broadcast data wait for a file: a signal need not wait for either. It ends
        the program as it ends any other (a shell's status 128 + n), and is no success: nothing was served."""
        days = write("days.yaml", "orbit:\n  sp3:\n" + "".join(f"    - {ROOT}/samples/ORR0TSTFIN_2025{d:03}0000_01D_15M_ORB.SP3.gz\n"
                                                    for d in (79, 80, 81)))

        def smoothing(process):
            for line in process.stderr:
                if "smoothing 3 files" in line:
                    return
            self.fail("it ended by itself")
        waiting = write("waiting.yaml", f"orbit: {{product: {product()}}}\nnavdata: {{nav: nav.pipe}}\n")
        os.mkfifo(WORK / "nav.pipe")
        ends = []

        def fitting(process):
            while process.poll() is None:
                try:
                    ends.append(os.open(WORK / "nav.pipe", os.O_WRONLY | os.O_NONBLOCK))  # kept open: the reader waits
                    return
                except OSError:  # nobody reads it yet
                    time.sleep(0.01)
            self.fail(process.stderr.read())
        for number in (signal.SIGTERM, signal.SIGINT):
            self.ends_by(number, days, smoothing)
            self.ends_by(number, waiting, fitting)
        for end in ends:
            os.close(end)

    def test_an_address_in_use_is_told_before_the_preparation(self):
        """The scenario cannot be prepared: nobody writes to its pipe. The address is refused all the same."""
        if not (WORK / "unheard.pipe").exists():
            os.mkfifo(WORK / "unheard.pipe")
        waits = write("unheard.yaml", f"orbit: {{product: {product()}}}\nnavdata: {{nav: unheard.pipe}}\n")
        with socket.create_server(("127.0.0.1", 0)) as other:
            done = orrery("serve", waits, "--listen", f"tcp://127.0.0.1:{other.getsockname()[1]}")
            self.assertEqual(done.returncode, 1)
            self.assertIn("another program is listening there", done.stderr)
        done = orrery("serve", waits, "--listen", "tcp://127.0.0.1:x")
        self.assertEqual(done.returncode, 2)

    def rude(self, url, times):
        """Connections that send one wrong byte: each makes the service say something."""
        host, port = url.removeprefix("tcp://").split(":")
        for _ in range(times):
            with socket.create_connection((host, int(port)), timeout=PATIENCE_S) as s:
                s.sendall(b"X")
                while s.recv(1000):
                    pass

    def serving(self, stderr, *args):
        return subprocess.Popen([ORRERY, "serve", str(product()), "--listen", "tcp://127.0.0.1:0", *args], stderr=stderr)

    def test_whoever_reads_its_log_may_leave(self):
        reader, writer = os.pipe()
        process = self.serving(writer)
        os.close(writer)
        try:
            with os.fdopen(reader) as lines:
                url = lines.readline().split(" on ")[1].split()[0]
            self.rude(url, 3)  # nobody reads any more
            with client_package.Client(url) as c:
                c.ping()
            process.terminate()
            self.assertEqual(process.wait(PATIENCE_S), 0)
        finally:
            process.kill()
            process.wait()

    def test_whoever_reads_its_log_may_stop_reading(self):
        """A pipe holds 64 KiB: with -v every connection is a line or two, and there are more of them than that."""
        reader, writer = os.pipe()
        process = self.serving(writer, "-v")
        os.close(writer)
        try:
            text = b""
            while b" on " not in text or not text.endswith(b"\n"):
                text += os.read(reader, 4096)
            url = text.decode().split(" on ")[1].split()[0]
            self.rude(url, 900)
            with client_package.Client(url) as c:
                c.ping()
            process.terminate()
            self.assertEqual(process.wait(PATIENCE_S), 0)
            with os.fdopen(reader, "rb") as rest:
                self.assertGreater(len(rest.read()), 60000)
        finally:
            process.kill()
            process.wait()

    def test_hanging_up_does_not_end_it(self):
        d = Daemon(product(), listen=(f"unix:{WORK}/hup.sock",))
        d.process.send_signal(signal.SIGHUP)
        with client_package.Client(d.urls[0]) as c:
            c.ping()
        self.assertEqual(d.stop(), 0)
        self.assertFalse((WORK / "hup.sock").exists())

    def test_every_address(self):
        with Daemon(product(), "--insecure-listen", listen=("tcp://*:0",)) as d:
            self.assertRegex(d.urls[0], r"^tcp://\*:[0-9]+$")
            with client_package.Client(d.urls[0].replace("*", "127.0.0.1")) as c:
                c.ping()

    def test_answers_under_way_are_finished(self):
        d = Daemon(product())
        with client_package.Client(d.urls[0], timeout_s=PATIENCE_S) as c:
            c._send(messages.Poll(messages.Epochs(c.span[0], 10**8, 8000), []))  # 10 MB: more than the buffers of a socket hold
            c._read_frame()
            d.process.send_signal(signal.SIGTERM)
            time.sleep(0.1)
            self.assertIsNone(d.process.poll())
            rest = [c._read_frame() for _ in range(7999)]
            self.assertTrue(all(f.type == messages.States.TYPE for f in rest))
            with self.assertRaises((client_package.Refused, client_package.ProtocolError, OSError)):
                c.ping()
        self.assertEqual(d.stop(), 0)

    def test_a_client_that_does_not_read_does_not_hold_it(self):
        d = Daemon(product())
        with client_package.Client(d.urls[0]) as c:
            c._send(messages.Poll(messages.Epochs(c.span[0], 1, 80000), []))
            time.sleep(0.2)
            begin = time.monotonic()
            self.assertEqual(d.stop(), 0)
            self.assertLess(time.monotonic() - begin, PATIENCE_S / 2)
        self.assertTrue(d.said("did not take their answers"))


class Polling(Shared):
    def test_json(self):
        done = orrery("poll", self.url, "--at", "2025-03-21T06:00:00.5", "--step", "0.1", "--count", 3, "--sat", "G02,E,C05", "--format", "json")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        epochs = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual([e["t_gps"] for e in epochs], [f"2025-03-21T06:00:00.{k}" for k in (5, 6, 7)])
        self.assertEqual([s["sat"] for s in epochs[0]["satellites"]], ["G02", "E01", "E02", "C05"])
        self.assertEqual(epochs[0]["satellites"][3], {"sat": "C05", "answer": "NOT_SERVED"})
        with client_package.Client(self.url) as c:
            for e, m in zip(epochs, c.poll("2025-03-21T06:00:00.5", 0.1, 3, ["G02", "E01", "E02"])):
                for j, s in zip(e["satellites"], m.satellites):
                    self.assertEqual((j["pos_m"], j["vel_mps"], j["acc_mps2"]), (s.pos_m, s.vel_mps, s.acc_mps2))
                    self.assertEqual((j["clock_s"], j["sigma_m"], j["clock_sigma_s"]), (s.clock_s, s.sigma_m, s.clock_sigma_s))
                    self.assertTrue(0 < s.clock_sigma_s < 1e-8)
                    self.assertIn("CLOCK_VALID", j["flags"])

    def test_table(self):
        done = orrery("poll", self.url)  # the start of the span
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        lines = done.stdout.splitlines()
        self.assertTrue(lines[0].startswith("2025-03-21T00:00:00 GPS"))
        self.assertEqual([line[:3] for line in lines[2:]], ["G01", "G02", "G03", "G04", "G05", "G06", "R01", "R02", "E01", "E02"])

    def test_where_there_is_nothing(self):
        done = orrery("poll", self.url, "--at", "2030-01-01")
        self.assertEqual(done.returncode, 1)
        self.assertIn("outside the served span", done.stdout)
        self.assertIn("serves 2025-03-21T00:00:00 to 2025-03-22T00:00:00", done.stderr)
        self.assertEqual(orrery("poll", self.url, "--sat", "C").returncode, 1)
        self.assertEqual(orrery("poll", self.url, "--count", 2).returncode, 2)
        self.assertEqual(orrery("poll", f"unix:{WORK}/nobody.sock").returncode, 1)

    def test_real_time(self):
        begin = time.monotonic()
        done = orrery("poll", self.url, "--realtime", "--step", "0.1", "--count", 6, "--sat", "G01", "--format", "json")
        self.assertEqual((done.returncode, len(done.stdout.splitlines())), (0, 6))
        self.assertGreater(time.monotonic() - begin, 0.49)

    def test_options_that_do_not_go_together(self):
        for words, sentence in (
                (("--imu", "--sat", "G01"), "--sat does not apply with --imu"),
                (("--truth", "--sat", "G01"), "--sat does not apply with --truth"),
                (("--imu", "--truth"), "--imu does not apply with --truth"),
                (("--delays", "--elements"), "--delays does not apply with --elements"),
                (("--receiver", "52,17,0"), "--receiver applies only with --delays"),
                (("--carrier", "1575.42"), "--carrier applies only with --delays"),
                (("--frame", "j2000"), "--frame applies only with --elements"),
                (("--unit", "1"), "--unit applies only with --imu or --truth"),
                (("--navdata", "--pages", "--format", "json"), "--pages does not apply with --format json"),
                (("--delays", "--receiver", "52"), "neither LAT,LON"),
                (("--delays", "--receiver", "ecef:1,2,3"), "not on the Earth"),
                (("--delays", "--carrier", "99"), "between 100 and 30000")):
            done = orrery("poll", self.url, *words)
            self.assertEqual((done.returncode, done.stdout), (2, ""), words)
            self.assertIn(sentence, done.stderr)

    def test_a_server_of_another_kind(self):
        with socket.create_server(("127.0.0.1", 0)) as server:
            process = subprocess.Popen([ORRERY, "poll", f"tcp://127.0.0.1:{server.getsockname()[1]}", "--timeout", "5"],
                                       stderr=subprocess.PIPE, text=True)
            peer, _ = server.accept()
            with peer:
                peer.recv(1000)
                peer.sendall(b"HTTP/1.1 400 Bad Request\r\n\r\n")
                _, talk = process.communicate(timeout=PATIENCE_S)
        self.assertEqual(process.returncode, 1)
        self.assertIn("no Orrery service", talk)

    def test_a_silent_server(self):
        with socket.create_server(("127.0.0.1", 0)) as server:
            done = orrery("poll", f"tcp://127.0.0.1:{server.getsockname()[1]}", "--timeout", "0.3")
        self.assertEqual(done.returncode, 1)
        self.assertIn("no answer", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=["test_command"])
