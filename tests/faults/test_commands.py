# SPDX-License-Identifier: GPL-3.0-or-later
"""Every command with one call after the other failing: the right status and a sentence, or the very same outputs; no crash, no leak, no
half file. Some numbers of calls by default, every one with ORRERY_LONG."""
import functools
import http.server
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
RUN, ORRERY = sys.argv[1:3]
LONG = bool(os.environ.get("ORRERY_LONG"))
SAMPLES = ROOT / "samples"
DAY = SAMPLES / "ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"
WORK = pathlib.Path(tempfile.mkdtemp(prefix="orrery-faults-"))
SOME = int(os.environ.get("ORRERY_FAULTS", "8"))  # numbers tried of a command
LEAK = 23  # exit status of the leak checker


STUDIES = {
    "error-equations": f"""manoeuvres: [{{name: rest, scenario: flight.yaml, duration: 20s}}]
errors: {SAMPLES}/sensors/navigation.yaml
initial: {{position: [20, -30, 0], velocity: [0.1, 0.2, 0], attitude: [20, -20, 60]}}
sizes: [1, 10]
steps: [1]
methods: [euler]
rate: 5
""",
    "alignment": f"""scenario: flight.yaml
errors: {SAMPLES}/sensors/navigation.yaml
seeds: 1
self: {{method: inertial, window: 15s}}
""",
    "aiding": """scenario: flight.yaml
duration: 20s
rate: 1
barometer: {bias_sigma: 5, sigma: 3, time: 600, white: 0.3, scale: 10000, lag: 0.5}
magnetometer: {hard_iron: [200, -150, 300], soft_iron: 5000, white: 50}
""",
    "vibration": """readings: 100
products: [1e-5]
duration: 2
ratios: {low: 1, high: 10, points: 2}
methods: [1-step]
""",
    "calibration": f"""stand: {{lat: 56, lon: 38, height: 150, azimuth: 25, elevation: 0}}
rate: 50
arms: [0.021, -0.013, 0.008, -0.011, 0.025, 0.017, 0.009, -0.006, -0.031]
profile: {{segments: [{{for: 2}}, {{for: 1, rate: 30}}, {{for: 12, rate: 30}}, {{for: 1}}, {{for: 2}}]}}
cycles:
  - {{along: right, mounting: [0.23, -0.11, 0.17], offset: [0.10, 0.03, -0.04], start: -1.1}}
  - {{along: forward, mounting: [-0.06, 0.12, 0.29], offset: [0.08, 0.08, -0.04], start: 0.6}}
  - {{along: up, mounting: [0.17, 0.06, -0.12], offset: [0.06, 0.13, -0.04], start: 2.3}}
errors: {SAMPLES}/studies/calibration-sensors.yaml
block: 2
seeds: 1
""",
    "crossovers": f"""scenario: lines.yaml
errors: {SAMPLES}/studies/drape-sensors.yaml
receiver: {{rate: 2, white: 0.003, wander: 0.02, wander_time: 600}}
alignment: {{tilt: 3, heading: 60}}
filter: {{kind: fir, length: 20}}
lines: {{margin: 20}}
seeds: 1
""",
}


def prepare():
    """What commands read, made by the program itself."""
    def made(*args):
        done = subprocess.run([ORRERY, *map(str, args)], cwd=WORK, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise RuntimeError(f"{args}: {done.stderr}")
    made("orbit", "-q", "-o", "day.nc", "--sat", "G01,R01", DAY)
    (WORK / "flight.yaml").write_text("""trajectory:
  {kind: phases, start: 2025-03-21T10:00:00, lat: 55, lon: 37, height: 100, speed: 20, phases: [{kind: rest, duration: 20}]}
imu: {rate: 10}
""")
    (WORK / "sky.yaml").write_text("""orbit: {product: day.nc}
receiver: {position: [55, 37, 100]}
signals: ["G:L1CA"]
""")
    made("simulate", "sky.yaml", "-o", "sky", "--from", "2025-03-21T12:00:00", "--to", "2025-03-21T12:00:10", "-q")
    made("imu", "-q", "flight.yaml", "-o", "imu.nc")
    made("navfit", "-q", "day.nc", "--sat", "G01", "-o", "day.rnx", "-j", "1")
    # Studies as short as they may be.
    (WORK / "long.yaml").write_text((WORK / "flight.yaml").read_text().replace("duration: 20", "duration: 80"))
    made("imu", "-q", "long.yaml", "-o", "long.nc")
    (WORK / "lines.yaml").write_text("""trajectory:
  {kind: survey, start: 2024-02-04T10:00:00, lat: 56, lon: 40, height: 1500, lead: 3000, speed: 65, bank: 20,
   survey: {azimuth: 0, length: 6000, spacing: 2000, lines: 2, tie_lines: 1, tie_spacing: 2000}}
imu: {rate: 10}
""")
    for name, text in STUDIES.items():
        (WORK / f"{name}.yaml").write_text(text)
    (WORK / "station.yaml").write_text(f"""orbit: {{product: day.nc}}
ionosphere: {{field: {SAMPLES}/ionosphere.ION}}
signals: ["G:L1CA", "G:L1P", "G:L2P"]
antennas: [{{name: STAT, position: [52.2, 17.07, 100]}}]
mask: {{elevation: 10}}
""")
    made("simulate", "station.yaml", "-o", "station", "--from", "2025-03-21T12:30:00", "--to", "2025-03-21T14:00:00", "--step", "60", "-q")


class Commands(unittest.TestCase):
    """A command in a folder of its own, again and again."""

    def sequence(self, calls):
        """The numbers that are tried: the first ones, where commands begin, and others spread evenly over the rest."""
        if LONG or calls <= SOME:
            return range(1, calls + 1)
        first = SOME // 2
        return [*range(1, first + 1), *sorted({first + (calls - first) * k // (SOME - first) for k in range(1, SOME - first + 1)})]

    def place(self, where):
        """The line of an address that is told relative to main."""
        if "MAIN" not in globals():
            names = subprocess.run(["nm", RUN], capture_output=True, text=True, check=False).stdout
            globals()["MAIN"] = next((int(n.split()[0], 16) for n in names.splitlines() if n.endswith(" T main")), 0)
        line = subprocess.run(["addr2line", "-e", RUN, hex((MAIN + int(where, 16)) % 2**64)], capture_output=True, text=True, check=False).stdout
        return line.strip()

    def files(self, folder):
        return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file() and p.name not in ("stdout", "stderr")}

    def try_all(self, *args, status=(1,), same=True, clock=False, resumes=False):
        """`status`: what a command that failed may say. `same`: it makes the same bytes each time. `clock`: it prints what a clock says.
        `resumes`: what it leaves is what it goes on with the next time."""
        folder = pathlib.Path(tempfile.mkdtemp(dir=WORK))
        self.addCleanup(shutil.rmtree, folder, True)
        words = [str(w) for w in args]
        run = subprocess.Popen([RUN, *words], cwd=folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                               env={**os.environ, "LSAN_OPTIONS": f"exitcode={LEAK}", "ASAN_OPTIONS": "allocator_may_return_null=1", "SOURCE_DATE_EPOCH": "1742515200"})
        self.addCleanup(run.stdout.close)
        self.addCleanup(run.wait)
        self.addCleanup(run.stdin.close)

        def once(n):
            run.stdin.write(f"{n}\n")
            run.stdin.flush()
            code, calls, hits, name, where = run.stdout.readline().split()
            return int(code), int(calls), int(hits), f"{name} ({self.place(where)}), call {n} of {' '.join(words)}"

        code, calls, _, _ = once(0)
        self.assertEqual(code, 0, (folder / "stderr").read_text())
        files, out, said = self.files(folder), (folder / "stdout").read_bytes(), (folder / "stderr").read_text()
        tried, faults = 0, []
        for n in self.sequence(calls):
            for p in folder.iterdir():
                p.unlink() if p.is_file() else shutil.rmtree(p)
            code, _, hits, what = once(n)
            now, talk = self.files(folder), (folder / "stderr").read_text(errors="replace")
            tried += hits
            if hits == 0 and code == 0:
                continue  # threads: there were fewer calls this time
            if code == 0:
                if sorted(now) != sorted(files) or same and now != files or not clock and (folder / "stdout").read_bytes() != out:
                    faults.append(f"{what}: status 0 and other outputs than without a fault: {talk[:300]!r}")
            elif code == LEAK:
                faults.append(f"{what}: leaks\n{talk[-2500:]}")
            elif code not in status:
                faults.append(f"{what}: status {code}\n{talk[-2500:]}")
            elif not talk.startswith("orrery ") and talk == said:
                faults.append(f"{what}: status {code} without a sentence")
            if code != 0 and not resumes and (any(".part-" in name for name in now) or same and any(now[name] != files.get(name) for name in now)):
                faults.append(f"{what}: left behind: {sorted(now)}")
            if len(faults) > 5:
                break
        print(f"{' '.join(words[:2])}: {calls} calls, {tried} failed", flush=True)
        if faults:
            self.fail("\n".join(faults))

    def test_version(self):
        self.try_all("--version", "--verbose")

    def test_help(self):
        self.try_all("help", "serve")

    def test_inspect(self):
        self.try_all("inspect", DAY)

    def test_inspect_product(self):
        self.try_all("inspect", WORK / "day.nc")

    def test_orbit(self):
        self.try_all("orbit", "-o", "out.nc", "--sat", "G01", "-j", "1", DAY)

    def test_states(self):
        self.try_all("states", WORK / "day.nc", "--from", "2025-03-21T12:00:00", "--to", "2025-03-21T12:01:00", "--step", "10", "-o", "states.csv")

    def test_states_json(self):
        self.try_all("states", WORK / "day.nc", "--from", "2025-03-21T12:00:00", "--to", "2025-03-21T12:00:10", "--step", "10", "--format", "json")

    def test_elements(self):
        self.try_all("elements", WORK / "day.nc", "--sat", "G01", "--from", "2025-03-21T12:00:00", "--to", "2025-03-21T12:10:00", "--step", "300", "-o", "e.csv")

    def test_compare(self):
        self.try_all("compare", WORK / "day.nc", SAMPLES / "ORR0TSTFIN_20250800000_01D_05M_ORB.SP3.gz")

    def test_eclipses(self):
        self.try_all("eclipses", WORK / "day.nc", "-o", "e.csv")

    def test_satellites(self):
        self.try_all("satellites", WORK / "day.nc", "-o", "s.csv")

    def test_navfit(self):
        self.try_all("navfit", WORK / "day.nc", "--sat", "G01", "-o", "day.rnx", "-j", "1")

    def test_imu(self):
        self.try_all("imu", WORK / "flight.yaml", "-o", "imu.nc")

    def test_track(self):
        self.try_all("track", WORK / "flight.yaml", "-o", "track.csv")

    def test_nulltest(self):
        self.try_all("nulltest", WORK / "imu.nc")

    def test_allan(self):
        self.try_all("allan", WORK / "imu.nc")

    def test_export(self):
        self.try_all("export", WORK / "imu.nc", "--to", "pyins", "-o", "out")

    def test_delays(self):
        self.try_all("delays", WORK / "day.nc", "--field", SAMPLES / "ionosphere.ION", "--from", "2025-03-21T12:00:00", "--to", "2025-03-21T12:00:10", "--receiver", "55,37,100", "-o", "d.csv")

    def test_simulate(self):
        self.try_all("simulate", WORK / "sky.yaml", "-o", "sky", "--from", "2025-03-21T12:00:00", "--to", "2025-03-21T12:00:02")

    def test_navfit_bits(self):
        self.try_all("navfit", WORK / "day.nc", "--sat", "G01", "--bits", "bits.csv", "-j", "1")

    def test_make_days(self):
        self.try_all("make-days", "-o", "days", "--from", "2025-03-21", "--sat", "G01", "--step", "6h", "--push", "G01,2025-03-21T01:00:00,0.1", "-j", "1")

    @unittest.skipUnless(LONG, "a day of 80 satellites, again and again")
    def test_batch(self):
        self.try_all("batch", "--archive", "archive", "--inputs", SAMPLES, "--name", "*_05M_ORB.SP3.gz", "-j", "1", same=False)

    def test_check(self):
        self.try_all("check", WORK / "sky.yaml")

    def test_studies(self):
        for name in STUDIES:
            with self.subTest(name):
                self.try_all(name, WORK / f"{name}.yaml", "-o", "out.csv")

    def test_gravimetry(self):
        self.try_all("gravimetry", WORK / "long.nc", "--csv", "gravity.csv", "--filter", "10")

    def test_sisre(self):
        self.try_all("sisre", WORK / "day.rnx", DAY)

    def test_tec(self):
        self.try_all("tec", SAMPLES / "ionosphere.ION", "--at", "2025-03-21T12:00:00", "--point", "52,17")

    def test_tec_maps(self):
        self.try_all("tec", SAMPLES / "ionosphere.ION", "--grid", "--at", "2025-03-21T12:00:00", "--format", "ionex", "-o", "out.inx")

    def test_iono(self):
        self.try_all("iono", WORK / "station/STAT.rnx", "--field", SAMPLES / "ionosphere.ION", "--orbit", WORK / "day.nc", "-o", "session.nc")

    def test_convert(self):
        self.try_all("convert", ROOT / "tests/fuzz/corpus/crinex/v3", "-o", "out.rnx")

    def test_archive(self):
        subprocess.run([ORRERY, "batch", "-q", "--archive", WORK / "archive", "--inputs", SAMPLES, "--name", DAY.name, "-j", "1"], check=True)
        for what in ("ls", "verify", "stats", "gc"):
            with self.subTest(what):
                self.try_all("archive", what, WORK / "archive")

    def test_fetch(self):
        """Of a server on loopback, into a cache of its own."""
        quiet = type("Quiet", (http.server.SimpleHTTPRequestHandler,), {"log_message": lambda *_: None})
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(quiet, directory=SAMPLES))
        threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.05}, daemon=True).start()
        self.addCleanup(server.server_close)
        self.addCleanup(server.shutdown)
        table = WORK / "archives.txt"
        table.write_text(f"name sp3 COD final - - {DAY.name}\nmirror here * http://127.0.0.1:{server.server_port}/\n")
        self.try_all("fetch", "2025-03-21", "--products", "sp3", "--cache", "cache", "--archives", table, "--backoff", "0.01", "--attempts", "1",
                     resumes=True)

    def test_serve_help(self):
        self.try_all("serve", "--help-scenario")

    def test_clients(self):
        """Of a service that goes well."""
        service = subprocess.Popen([ORRERY, "serve", WORK / "day.nc", "--listen", f"unix:{WORK}/socket"], stderr=subprocess.PIPE, text=True)
        self.addCleanup(service.stderr.close)
        self.addCleanup(service.wait)
        self.addCleanup(service.terminate)
        for line in service.stderr:
            if "ready on " in line:
                break
        url, at = f"unix:{WORK}/socket", "2025-03-21T12:00:00"
        log = WORK / "some.log"
        subprocess.run([ORRERY, "record", "-q", url, "-o", log, "--from", at, "--count", "3", "--free"], check=True)
        for args in (["poll", url, "--at", at, "--count", "3", "--step", "1"], ["record", url, "-o", "out.log", "--from", at, "--count", "3", "--free"],
                     ["replay", log, "--format", "csv"], ["replay", log, "--check", url],
                     ["watch", url, "--count", "1"]):
            with self.subTest(args[0]):
                self.try_all(*args, clock=args[0] == "watch")

    def test_tls(self):
        """Keys and certificates are other ones each time: what is left is not compared, but an authority without its key is none."""
        self.try_all("tls", "init", "lab", same=False)


if __name__ == "__main__":
    try:
        prepare()
        unittest.main(argv=["test_commands", *sys.argv[3:]])
    finally:
        shutil.rmtree(WORK, True)
