# SPDX-License-Identifier: GPL-3.0-or-later
"""What ./demo shows, piece by piece: the sample scenario served, and the stand-in for a generator asking it at 10 Hz."""
import os
import pathlib
import re
import signal
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import program  # noqa: E402

GENERATOR = program.ROOT / "samples/generator.py"


def generate(url, *args):
    env = dict(os.environ, PYTHONPATH=str(program.ROOT / "proto/python"))
    return subprocess.run([sys.executable, "-B", str(GENERATOR), url, *args], env=env, capture_output=True, text=True, timeout=120,
                          check=False)


class Scenario(unittest.TestCase):
    """samples/constellation.yaml, smoothed and served once for all tests here."""

    @classmethod
    def setUpClass(cls):
        cls.server = subprocess.Popen([program.ORRERY, "serve", program.sample("constellation.yaml"), "--listen",
                                       "tcp://127.0.0.1:0"], stderr=subprocess.PIPE, text=True)
        cls.said = []
        for line in cls.server.stderr:  # ends with the process; ctest bounds the time
            cls.said.append(line)
            ready = re.search(r"ready on (\S+) \((.*)\)", line)
            if ready:
                cls.url, cls.what = ready.groups()
                return
        cls.server.wait()
        raise RuntimeError("not ready: " + "".join(cls.said))

    @classmethod
    def tearDownClass(cls):
        if cls.server.poll() is None:
            cls.server.kill()
            cls.server.wait()
        cls.server.stderr.close()

    def test_1_all_of_it_is_served(self):
        self.assertEqual(self.what, "80 satellites, 2025-03-20T00:00:00 to 2025-03-23T00:00:00")

    def test_2_generator_shows_states_and_how_prompt_they_were(self):
        done = generate(self.url, "--at", "2025-03-21T12:00:00", "--seconds", "1", "--show", "G05", "R21")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("Made constellation", done.stdout)
        self.assertIn("2025-03-21T12:00:00.9 GPS", done.stdout)
        self.assertRegex(done.stdout, r"10 polls in 0\.\d s, 80 satellites each")
        rows = [line.split() for line in done.stdout.splitlines() if re.match(r"\s+(G05|R21)\s", line)]
        self.assertEqual([r[0] for r in rows], ["G05", "R21", "G05", "R21"])
        for row in rows:
            x, y, z, speed = map(float, row[1:5])
            self.assertTrue(25e3 < (x * x + y * y + z * z) ** 0.5 < 27.2e3)  # km
            self.assertTrue(2e3 < speed < 4e3)  # m/s, ecef
        self.assertEqual(rows[1][5], "-")  # R21 has no clock that day

    def test_3_what_is_not_there_has_no_number(self):
        done = generate(self.url, "--at", "2025-03-22T06:00:00", "--seconds", "0.1", "--show", "E24")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"E24  no arc")
        self.assertIn("79 satellites each", done.stdout)
        done = generate(self.url, "--at", "2030-01-01T00:00:00", "--seconds", "0.1")
        self.assertEqual(done.returncode, 1)

    def test_4_ends_well_when_told(self):
        self.server.send_signal(signal.SIGTERM)
        self.assertEqual(self.server.wait(60), 0)
        done = generate(self.url)
        self.assertEqual(done.returncode, 1)
        self.assertIn(self.url, done.stderr)


class Files(program.Folder):
    def test_samples_are_small(self):
        total = sum(p.stat().st_size for p in (program.ROOT / "samples").rglob("*")
                    if p.is_file() and p.suffix not in (".nc", ".pyc"))
        self.assertLess(total, 3_000_000)

    def test_product_meets_the_truth_file(self):
        days = [program.sample(f"ORR0TSTFIN_20250{d}0000_01D_15M_ORB.SP3.gz") for d in (79, 80, 81)]
        program.run("orbit", "-o", self.path("sample.nc"), *days)
        told = program.run_json("compare", self.path("sample.nc"), program.sample("ORR0TSTFIN_20250800000_01D_05M_ORB.SP3.gz"),
                                "--format", "json")
        for system in "GRE":
            inner = told["systems"][system]["inner"]
            self.assertGreater(inner["n"], 4000)
            # 0.5 mm of this is the truth file's own rounding; 0.4 mm that of the input, smoothed
            self.assertLess(inner["rms_mm"], 0.75)
            self.assertLess(inner["max_mm"], 3)
            self.assertLess(inner["vel_rms_mps"], 5e-6)


if __name__ == "__main__":
    unittest.main(verbosity=1)
