# SPDX-License-Identifier: GPL-3.0-or-later
"""CSV of all commands by one rule: a line of names, then rows of as many fields, nothing else. So numpy, pandas and gnuplot
read it as it is; each is tried where it is installed."""
import csv
import pathlib
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import Folder, run, sample  # noqa: E402

DAY = sample("ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz")
WITH_PANDAS = """
import sys, numpy, pandas
for path in sys.argv[1:]:
    frame = pandas.read_csv(path)
    table = numpy.genfromtxt(path, delimiter=",", names=True, dtype=None, encoding="utf-8")
    assert list(frame.columns) == list(table.dtype.names), path
    assert len(frame) == table.size > 0, path
    for name in table.dtype.names:
        if table.dtype[name].kind == "f" and frame[name].dtype.kind == "f":
            a, b = numpy.atleast_1d(table[name]), frame[name].to_numpy()
            assert numpy.allclose(a, b, rtol=1e-14, equal_nan=True), (path, name)
"""


def interpreter(modules):
    """One that has the modules, or None."""
    for python in (sys.executable, "/usr/bin/python3"):
        if shutil.which(python) and subprocess.run([python, "-c", f"import {modules}"], capture_output=True, check=False).returncode == 0:
            return python
    return None


class Csv(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.made, orbit, readings = {}, cls.path("day.nc"), cls.path("imu.nc")
        run("orbit", "-q", "-o", orbit, "--sat", "G01-G06,R01-R02", DAY)
        run("imu", "-q", sample("survey.yaml"), "--duration", "60", "-o", readings)
        noisy = cls.path("noisy.nc")
        run("imu", "-q", sample("still.yaml"), "--duration", "600", "--errors", sample("sensors/tactical.yaml"), "-o", noisy)
        tec = ("--at", "2025-03-21T12:00", "--point", "50,10")
        for name, args in {
                "states": ("states", orbit, "--format", "csv", "--step", "2h"),
                "satellites": ("satellites", orbit, "--at", "2025-03-21T12:00", "--format", "csv"),
                "eclipses": ("eclipses", orbit, "--format", "csv"),
                "elements": ("elements", orbit, "--format", "csv", "--step", "6h"),
                "compare": ("compare", "-q", orbit, sample("ORR0TSTFIN_20250800000_01D_05M_ORB.SP3.gz"), "--csv", "-"),
                "bits": ("navfit", "-q", orbit, "--zero-clocks", "--from", "2025-03-21T12:00", "--to", "2025-03-21T12:01", "--bits", "-"),
                "tec": ("tec", sample("ionosphere.ION"), *tec, "--format", "csv"),
                "track": ("track", "-q", sample("survey.yaml"), "--duration", "20"),
                "track-frd": ("track", "-q", sample("survey.yaml"), "--duration", "20", "--axes", "frd"),
                "imu": ("imu", "-q", sample("survey.yaml"), "--duration", "2", "--instantaneous", "-o", "-"),
                "nulltest": ("nulltest", "-q", readings, "--csv", "-"),
                "allan": ("allan", "-q", noisy, "--csv", "-")}.items():
            text = run(*args).stdout
            cls.made[name] = cls.path(name + ".csv")
            pathlib.Path(cls.made[name]).write_text(text, encoding="ascii")

    def test_the_rule(self):
        for name, path in self.made.items():
            with open(path, encoding="ascii", newline="") as f:
                rows = list(csv.reader(f))
            self.assertGreater(len(rows), 1, name)
            for word in rows[0]:
                self.assertRegex(word, r"^[A-Za-z][A-Za-z0-9_]*$", name)
            self.assertEqual(len(set(rows[0])), len(rows[0]), name)
            for row in rows[1:]:
                self.assertEqual(len(row), len(rows[0]), (name, row))
                self.assertNotIn("#", "".join(row), name)

    def test_numpy_and_pandas(self):
        python = interpreter("numpy, pandas")
        if python is None:
            self.skipTest("numpy and pandas are not installed")
        done = subprocess.run([python, "-c", WITH_PANDAS, *self.made.values()], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_gnuplot(self):
        if shutil.which("gnuplot") is None:
            self.skipTest("gnuplot is not installed")
        with open(self.made["track"], encoding="ascii", newline="") as f:
            rows = list(csv.DictReader(f))
        script = ("set datafile separator ','; stats '{0}' using 1:4 name 'A' nooutput; print A_records, A_max_y;"
                  "set xdata time; set timefmt '%Y-%m-%dT%H:%M:%S'; set terminal dumb; set output '/dev/null';"
                  "plot '{0}' using 't_gps':'height_m' with lines").format(self.made["track"])
        done = subprocess.run(["gnuplot", "-e", script], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        records, highest = done.stderr.split()[:2]
        self.assertEqual(int(float(records)), len(rows))
        self.assertAlmostEqual(float(highest), max(float(r["height_m"]) for r in rows), delta=1e-3)


if __name__ == "__main__":
    unittest.main()
