# SPDX-License-Identifier: GPL-3.0-or-later
"""Every command with one call after the other failing: the right status and a sentence, or the very same outputs; no crash, no leak, no
half file. Some numbers of calls by default, every one with ORRERY_LONG."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
RUN, ORRERY = sys.argv[1:3]
LONG = bool(os.environ.get("ORRERY_LONG"))
SAMPLES = ROOT / "samples"
DAY = SAMPLES / "ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"
WORK = pathlib.Path(tempfile.mkdtemp(prefix="orrery-faults-"))
SOME = int(os.environ.get("ORRERY_FAULTS", "8"))  # numbers tried of a command
LEAK = 23  # exit status of the leak checker


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

    def try_all(self, *args, status=(1,), same=True):
        """`status`: what a command that failed may say. `same`: it makes the same bytes each time."""
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
                if sorted(now) != sorted(files) or same and now != files or (folder / "stdout").read_bytes() != out:
                    faults.append(f"{what}: status 0 and other outputs than without a fault: {talk[:300]!r}")
            elif code == LEAK:
                faults.append(f"{what}: leaks\n{talk[-2500:]}")
            elif code not in status:
                faults.append(f"{what}: status {code}\n{talk[-2500:]}")
            elif not talk.startswith("orrery ") and talk == said:
                faults.append(f"{what}: status {code} without a sentence")
            if code != 0 and (any(".part-" in name for name in now) or same and any(now[name] != files.get(name) for name in now)):
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

    @unittest.skipUnless(LONG, "a day of 80 satellites, again and again")
    def test_make_days(self):
        self.try_all("make-days", "-o", "days", "--from", "2025-03-21", "--sat", "G01", "--step", "6h", "--push", "G01,2025-03-21T01:00:00,0.1", "-j", "1")

    def test_batch(self):
        self.try_all("batch", "--archive", "archive", "--inputs", SAMPLES, "--name", "*_05M_ORB.SP3.gz", "-j", "1", same=False)

    def test_check(self):
        self.try_all("check", WORK / "sky.yaml")

    def test_tls(self):
        """Keys and certificates are other ones each time: what is left is not compared, but an authority without its key is none."""
        self.try_all("tls", "init", "lab", same=False)


if __name__ == "__main__":
    try:
        prepare()
        unittest.main(argv=["test_commands", *sys.argv[3:]])
    finally:
        shutil.rmtree(WORK, True)
