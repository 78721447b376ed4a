# SPDX-License-Identifier: GPL-3.0-or-later
"""orrery-generator on a service: the same bytes whatever the threads, the begin and the service's restarts; what it says of a
recording; and what cannot be is told in a sentence, with metadata of what is there."""
import json
import os
import pathlib
import signal
import socket
import subprocess
import sys
import threading
import time
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE.parent.parent / "receivers")]
sys.path.insert(0, str(HERE.parent.parent.parent / "proto/python"))
import recording  # noqa: E402
from orrery import frame, messages  # noqa: E402
from program import Folder, ORRERY, run, sample  # noqa: E402

START = "2025-03-21T12:00:00"
SCENARIO = """
orbit: {{product: {product}}}
signals: ["G:L1CA", "G:L2C", "G:L5", "R:L1OF", "E:E1", "E:E5a"]
antennas:
  - {{name: ROOF, position: [52.2, 17.07, 100]}}
"""


def meta(name):
    return json.loads(pathlib.Path(f"{name}.sigmf-meta").read_text())


def data(name):
    return pathlib.Path(f"{name}.sigmf-data").read_bytes()


class Generator(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        product = cls.path("day.nc")
        run("orbit", "-q", "-o", product, sample("ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"))
        cls.scenario = cls.folder / "scenario.yaml"
        cls.scenario.write_text(SCENARIO.format(product=product))
        cls.service = recording.Service(cls.scenario, cls.folder)

    @classmethod
    def tearDownClass(cls):
        cls.service.stop()
        super().tearDownClass()

    def make(self, name, *options, **kwargs):
        path = self.path(name)
        self.service.generate("-o", path, "--rate", "4M", "--centre", "1575.42M", "--signals", "G:L1CA,E:E1", "--from", START,
                              "--seconds", "1.2", "--noise", *options, **kwargs)
        return path

    def refused(self, sentence, *options, status=1):
        said = self.service.generate(*options, status=status)
        self.assertIn(sentence, said)
        self.assertEqual(said.count("orrery-generator: "), 1, said)

    def test_same_bytes(self):
        """Of one and of three threads; from another instant on, in the middle of a block and of a piece."""
        whole = data(self.make("one", "--threads", "1"))
        self.assertEqual(len(whole), 4800000 * 2)
        self.assertEqual(whole, data(self.make("three", "--threads", "3")))
        late = self.path("late")
        self.service.generate("-o", late, "--rate", "4M", "--centre", "1575.42M", "--signals", "G:L1CA,E:E1", "--from",
                              "2025-03-21T12:00:00.333337", "--seconds", "0.5", "--noise")
        first = 1333348  # 0.333337 s of 4 Msps
        self.assertEqual(data(late), whole[2 * first:2 * first + 4000000])
        self.assertNotEqual(whole, data(self.make("other", "--seed", "2")))

    def test_streams_and_metadata(self):
        """Two bands from one time base; every format; SigMF's own schema."""
        import jsonschema
        schema = jsonschema.Draft202012Validator(json.loads((HERE / "sigmf-schema-1.2.5.json").read_text()))
        low, high = self.path("low"), self.path("high")
        self.service.generate("--stream", f"output={low};rate=25M;centre=1176.45M;format=i16", "--stream",
                              f"output={high};rate=10M;centre=1602M;format=i2", "--from", START, "--seconds", "0.1", "--noise")
        for name, size, samples, kind in ((low, 10000000, 2500000, "ci16_le"), (high, 500000, 1000000, "ru8")):
            m = meta(name)
            schema.validate(m)
            self.assertEqual(len(data(name)), size)
            self.assertEqual(m["global"]["orrery:samples"], samples)
            self.assertTrue(m["global"]["orrery:complete"])
            self.assertEqual(m["global"]["core:datatype"], kind)
            self.assertEqual(m["captures"][0]["core:datetime"], "2025-03-21T11:59:42.000000000Z")
        labels = {a["core:label"].split()[1] for a in meta(low)["annotations"]}
        self.assertEqual(labels, {"L5", "E5a"})
        self.assertEqual({a["core:label"].split()[1] for a in meta(high)["annotations"]}, {"L1OF"})
        floats = self.path("floats")
        self.service.generate("-o", f"{floats}.sigmf-data", "--rate", "2M", "--signals", "G:L2C", "--format", "f32", "--from", START,
                              "--seconds", "0.01")
        schema.validate(meta(floats))
        self.assertEqual(meta(floats)["captures"][0]["core:frequency"], 1227600000)
        self.assertEqual(len(data(floats)), 20000 * 8)

    def test_pipe(self):
        """Standard output has the same samples as a file, and nothing else."""
        done = subprocess.run([recording.GENERATOR, self.service.url, "-o", "-", "--rate", "4M", "--centre", "1575.42M", "--signals",
                               "G:L1CA,E:E1", "--from", START, "--seconds", "1.2", "--noise", "--quiet"],
                              capture_output=True, check=True, timeout=120)
        self.assertEqual(done.stdout, data(self.make("file")))
        self.assertEqual(done.stderr, b"")

    def test_restart(self):
        """A service that goes in the middle and comes back: the samples are those of one that stayed."""
        folder = self.folder / "restart"
        folder.mkdir()
        service = recording.Service(self.scenario, folder)
        whole = self.path("whole")
        args = ["--rate", "2600000", "--signals", "G:L1CA", "--from", START, "--seconds", "16"]
        service.generate("-o", whole, *args)
        process = subprocess.Popen([recording.GENERATOR, service.url, "-o", "-", *args], stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE)
        try:
            head = process.stdout.read(2600000 * 2)  # a second; the pipe and two buffers hold a few more, blocks on the way 6.4 s
            service.stop()
            again = None
            rest = []

            def read():
                while chunk := process.stdout.read(1 << 20):
                    rest.append(chunk)
            reader = threading.Thread(target=read)
            reader.start()
            time.sleep(0.3)
            again = recording.Service(self.scenario, folder)
            reader.join(120)
            said = process.stderr.read().decode()
            self.assertEqual(process.wait(60), 0, said)
        finally:
            process.kill()
            process.wait()
            process.stdout.close()
            process.stderr.close()
            service.stop()
            if again is not None:
                again.stop()
        self.assertIn("the service is back", said)
        self.assertTrue(head + b"".join(rest) == data(whole), "samples differ after a restart of the service")

    def refuse_streams(self, listener, refused):
        """One connection passed on to the service, but for each SUBSCRIBE, which is refused as by a service that knows none."""
        near = listener.accept()[0]
        with near, socket.socket(socket.AF_UNIX) as far:
            far.connect(self.service.url.removeprefix("unix:"))

            def back():
                while chunk := far.recv(1 << 20):
                    near.sendall(chunk)
            answers = threading.Thread(target=back)
            answers.start()

            def receive(n):
                got = near.recv(n, socket.MSG_WAITALL)
                if len(got) < n:
                    raise EOFError
                return got
            try:
                while True:
                    f = frame.read(receive)
                    if f.type == messages.Subscribe.TYPE:
                        refused.append(f.message().request)
                        error = messages.Error(messages.ErrorCode.UNKNOWN_TYPE, f.type, "no streams here")
                        near.sendall(frame.make(messages.Error.TYPE, f.sequence, error.encode()))
                    else:
                        far.sendall(frame.make(f.type, f.sequence, f.payload))
            except (EOFError, ConnectionError):
                far.shutdown(socket.SHUT_RDWR)
                answers.join()

    def test_without_streams(self):
        """A service that knows no streams is polled for blocks and symbols; the samples are the same."""
        path, refused, name = self.path("no-streams.sock"), [], self.path("polled")
        with socket.socket(socket.AF_UNIX) as listener:
            listener.bind(path)
            listener.listen()
            relay = threading.Thread(target=self.refuse_streams, args=(listener, refused))
            relay.start()
            subprocess.run([recording.GENERATOR, f"unix:{path}", "-o", name, "--rate", "4M", "--centre", "1575.42M", "--signals", "G:L1CA,E:E1",
                            "--from", START, "--seconds", "1.2", "--noise", "-q"], check=True, timeout=120)
            relay.join(60)
        self.assertEqual(sorted(refused), [messages.PollNavdata.TYPE, messages.PollChannels.TYPE])
        self.assertEqual(data(name), data(self.make("subscribed")))

    def test_gone(self):
        """A service that does not come back ends it, with metadata of what is there."""
        folder = self.folder / "gone"
        folder.mkdir()
        service = recording.Service(self.scenario, folder)
        name = self.path("gone-file")
        process = subprocess.Popen([recording.GENERATOR, service.url, "-o", name, "--rate", "2600000", "--signals", "G:L1CA", "--from",
                                    START, "--seconds", "3000", "--pace", "--patience", "0.2"], stderr=subprocess.PIPE, text=True)
        try:
            until = time.monotonic() + 60
            while not (pathlib.Path(f"{name}.sigmf-data").exists() and len(data(name)) > 0) and time.monotonic() < until:
                time.sleep(0.02)
            service.stop()
            said = process.communicate(timeout=60)[1]
        finally:
            process.kill()
            process.wait()
            service.stop()
        self.assertEqual(process.returncode, 1)
        self.assertIn("did not come back", said)
        self.assertFalse(meta(name)["global"]["orrery:complete"])
        self.assertEqual(meta(name)["global"]["orrery:samples"], len(data(name)) // 2)

    def test_pace(self):
        """At the pace of the clock: a second takes a second."""
        began = time.monotonic()
        m = meta(self.make("paced", "--pace"))
        self.assertGreater(time.monotonic() - began, 1.15)
        self.assertIn("orrery:underruns", m["global"])
        self.assertTrue(m["global"]["orrery:complete"])

    def playing(self, name, *options):
        """A generator at the pace of the clock, some of whose samples are written."""
        process = subprocess.Popen([recording.GENERATOR, self.service.url, "-o", self.path(name), "--rate", "2600000", "--signals", "G:L1CA",
                                    "--from", START, "--pace", *options], stderr=subprocess.PIPE, text=True)
        self.addCleanup(lambda: (process.kill(), process.communicate()))
        written, until = pathlib.Path(self.path(f"{name}.sigmf-data")), time.monotonic() + 60
        while not (written.exists() and written.stat().st_size > 0) and time.monotonic() < until:
            time.sleep(0.02)
        return process

    def test_late(self):
        """A generator that the machine leaves no time: slices that left late are counted and told."""
        process = self.playing("late-one", "--seconds", "0.8")
        os.kill(process.pid, signal.SIGSTOP)
        time.sleep(0.4)
        os.kill(process.pid, signal.SIGCONT)
        said = process.communicate(timeout=60)[1]
        self.assertEqual(process.returncode, 0)
        late = meta(self.path("late-one"))["global"]["orrery:underruns"]
        self.assertGreater(late, 10)  # slices of 10 ms
        self.assertIn(f"{late} underruns, at most 0.", said)

    def test_killed(self):
        """A generator that is killed leaves metadata of no more than what is there, and that it is not all."""
        process = self.playing("killed", "--seconds", "60")
        process.kill()
        process.wait()
        m = meta(self.path("killed"))["global"]
        self.assertFalse(m["orrery:complete"])
        self.assertLessEqual(m["orrery:samples"], len(data(self.path("killed"))) // 2)

    def test_full_disk(self):
        name = self.path("full")
        os.symlink("/dev/full", f"{name}.sigmf-data")
        self.refused("No space left on device", "-o", name, "--from", START, "--seconds", "1", "--signals", "G:L1CA", "-q")
        self.assertEqual(meta(name)["global"]["orrery:samples"], 0)
        self.assertFalse(meta(name)["global"]["orrery:complete"])

    def left(self, name, reason, wrap=(), **how):
        """A generator that ends with a sentence: metadata of what is there, to the sample."""
        done = subprocess.run([*wrap, recording.GENERATOR, self.service.url, "-o", name, "--rate", "2600000", "--signals", "G:L1CA", "--from",
                               START, "--seconds", "4", "-q"], capture_output=True, text=True, check=False, timeout=120, **how)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertIn(reason, done.stderr)

    def judge_left(self, name, least):
        written, m = data(name), meta(name)
        self.assertGreater(len(written), least)
        self.assertEqual(m["global"]["orrery:samples"], len(written) // 2)
        self.assertFalse(m["global"]["orrery:complete"])
        self.assertEqual({a["core:sample_count"] for a in m["annotations"]}, {len(written) // 2})
        whole = self.path("four")
        self.service.generate("-o", whole, "--rate", "2600000", "--signals", "G:L1CA", "--from", START, "--seconds", "4")
        self.assertEqual(written, data(whole)[:len(written)])

    def test_file_limit(self):
        import resource
        name = self.path("limited")
        self.left(name, "File too large after 2999999 bytes", preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (2999999,) * 2))
        self.judge_left(name, 2999998)

    def test_disk_that_fills(self):
        """Samples that fill the disk give room to their metadata."""
        if subprocess.run(["unshare", "-Urm", "true"], capture_output=True, check=False).returncode != 0:
            self.skipTest("a file system of one's own may not be mounted here (unshare -Urm)")
        disk = self.folder / "disk"
        disk.mkdir()
        kept = self.folder / "kept"
        kept.mkdir()
        script = 'kept=$1; shift; mount -t tmpfs -o size=3m none "$0" && { "$@"; status=$?; cp "$0"/* "$kept"; exit $status; }'
        self.left(f"{disk}/full", "No space left on device", wrap=("unshare", "-Urm", "sh", "-c", script, str(disk), str(kept)))
        self.judge_left(f"{kept}/full", 2900000)

    def test_closed_pipe(self):
        process = subprocess.Popen([recording.GENERATOR, self.service.url, "-o", "-", "--from", START, "--seconds", "60", "--signals",
                                    "G:L1CA", "-q"], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        process.stdout.read(1000)
        process.stdout.close()
        said = process.stderr.read().decode()
        process.stderr.close()
        self.assertEqual(process.wait(60), 1)
        self.assertIn("closed the pipe", said)
        self.assertEqual(said.count("\n"), 1, said)

    def test_refused(self):
        base = ("-o", self.path("no"), "--from", START, "--seconds", "1", "-q")
        self.refused("8/7 of its chips", *base, "--rate", "1100000", "--signals", "G:L1CA")
        self.refused("beyond the stream's edges", *base, "--rate", "5M", "--centre", "1590M", "--signals", "G:L1CA")
        self.refused("no signal that is served fits", *base, "--rate", "1M", "--centre", "1400M")
        self.refused("sends no signal G:L1C:", *base, "--signals", "G:L1C")
        self.refused("there is no antenna DECK", *base, "--antenna", "DECK")
        self.refused("do not lie in it", "-o", self.path("no"), "--from", "2025-03-23T00:00:00", "-q")
        self.refused("is no rate", *base, "--rate", "5.5", status=2)
        self.refused("is no instant", "-o", self.path("no"), "--from", "noon", status=2)
        self.refused("where the samples go", status=2)
        self.refused("eight streams", *(x for k in range(9) for x in ("--stream", f"output={self.path(str(k))}")), status=2)
        self.assertFalse(pathlib.Path(self.path("no.sigmf-data")).exists())

    def test_nobody(self):
        done = subprocess.run([recording.GENERATOR, f"unix:{self.folder}/nobody", "-o", "-", "--patience", "0"], capture_output=True,
                              text=True, check=False, timeout=60)
        self.assertEqual(done.returncode, 1)
        self.assertIn("cannot be reached", done.stderr)

    def test_one_command(self):
        """orrery iq: the same samples as of service and generator apart."""
        run("iq", str(self.scenario), "-o", self.path("iq"), "--seconds", "1.2", "--rate", "4M", "--centre", "1575.42M", "--signals",
            "G:L1CA,E:E1", "--from", START)
        self.assertEqual(data(self.path("iq/scenario")), data(self.make("apart")))
        self.assertFalse([p for p in pathlib.Path("/tmp").glob("orrery-iq-*") if p.stat().st_mtime > time.time() - 5])
        run("iq", str(self.scenario), "-o", self.path("iq"), "--seconds", "1", "--rate", "1k", status=2)


if __name__ == "__main__":
    unittest.main()
