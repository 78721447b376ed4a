# SPDX-License-Identifier: GPL-3.0-or-later
"""A service and the generator beside it: recordings of a scenario, and what is true of them, asked from the same service."""
import contextlib
import json
import os
import pathlib
import signal
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "system"))
import program  # noqa: E402

GENERATOR = os.environ.get("ORRERY_GENERATOR", str(pathlib.Path(program.ORRERY).parent / "orrery-generator"))
GPS_EPOCH = 315964800  # of Unix time


def gps_s(text):
    """Seconds since 1980-01-06T00:00:00 of an instant as text."""
    import datetime
    t = datetime.datetime.fromisoformat(text).replace(tzinfo=datetime.timezone.utc)
    return t.timestamp() - GPS_EPOCH


class Service:
    """orrery serve on a Unix socket, for a while."""

    def __init__(self, scenario, folder):
        self.url = f"unix:{folder}/service.sock"
        self.log = pathlib.Path(folder, "service.log")
        with self.log.open("wb") as log:
            self.process = subprocess.Popen([program.ORRERY, "serve", str(scenario), "--listen", self.url], stderr=log)
        until = time.monotonic() + 300
        while "ready on" not in self.log.read_text():
            if self.process.poll() is not None or time.monotonic() > until:
                raise AssertionError(f"the service did not start:\n{self.log.read_text()}")
            time.sleep(0.1)

    def stop(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGTERM)
            self.process.wait(30)

    def poll(self, *args):
        """JSON of each epoch."""
        done = program.run("poll", self.url, *args, "--format", "json", timeout=600)
        return [json.loads(line) for line in done.stdout.splitlines()]

    def generate(self, *args, status=0, timeout=1200, **kwargs):
        """Runs the generator; what it said."""
        done = subprocess.run(["nice", GENERATOR, self.url, *map(str, args)], capture_output=True, text=True, timeout=timeout,
                              check=False, **kwargs)
        if done.returncode != status:
            raise AssertionError(f"orrery-generator: status {done.returncode}, not {status}\n{done.stderr}")
        return done.stderr

    def navdata(self, at, system):
        """{number: set} of a system at an instant."""
        epoch = self.poll("--navdata", "--at", at)[0]
        return {int(s["sat"][1:]): s for s in epoch["satellites"] if s["sat"][0] == system and s["answer"] == "OK"}

    def truth(self, start, seconds, antenna=0):
        """Position of the antenna as a function of the time of week, through positions and velocities of the blocks."""
        rows = self.poll("--channels", "--antenna", antenna, "--at", start, "--step", "0.5", "--count", int(2 * seconds) + 2)
        nodes = sorted({gps_s(r["block"]): (r["pos_m"], r["vel_mps"]) for r in rows if r["answer"] == "OK"}.items())

        def at(tow):
            t = tow + nodes[0][0] // 604800 * 604800
            if t < nodes[0][0] - 302400:
                t += 604800
            k = max(0, min(len(nodes) - 2, sum(n[0] <= t for n in nodes) - 1)) if len(nodes) < 50 else bisect(nodes, t)
            (t0, (p0, v0)), (t1, (p1, v1)) = nodes[k], nodes[k + 1]
            h = t1 - t0
            u = (t - t0) / h
            return [(1 + 2 * u) * (1 - u) ** 2 * a + u * (1 - u) ** 2 * h * va + u * u * (3 - 2 * u) * b + u * u * (u - 1) * h * vb
                    for a, va, b, vb in zip(p0, v0, p1, v1)]
        return at


def bisect(nodes, t):
    low, high = 0, len(nodes) - 2
    while low < high:
        middle = (low + high + 1) // 2
        if nodes[middle][0] <= t:
            low = middle
        else:
            high = middle - 1
    return low


@contextlib.contextmanager
def service(scenario, folder):
    s = Service(scenario, folder)
    try:
        yield s
    finally:
        s.stop()


def satellites(recording, signal_name):
    """Numbers of the satellites whose signal is in a recording, from its metadata."""
    meta = json.loads(pathlib.Path(f"{recording}.sigmf-meta").read_text())
    found = {a["core:label"].split()[0] for a in meta["annotations"] if a["core:label"].split()[1] == signal_name}
    return sorted(int(s[1:]) for s in found)


def endings(recording, signal_name):
    """Seconds from its begin at which satellites' signals end before the recording does: they set."""
    meta = json.loads(pathlib.Path(f"{recording}.sigmf-meta").read_text())
    ends = {a["core:sample_start"] + a["core:sample_count"] for a in meta["annotations"] if a["core:label"].split()[1] == signal_name}
    return sorted(end / meta["global"]["core:sample_rate"] for end in ends if end < meta["global"]["orrery:samples"])
