# SPDX-License-Identifier: GPL-3.0-or-later
"""Outputs never destroy inputs: what is read, read-only or somebody else's is not overwritten, whatever it is called."""
import hashlib
import os
import pathlib
import shutil
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import ORRERY, Folder, run, sample  # noqa: E402

DAY = "ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"
SEAL = 80  # bytes of the line at a product's end


class Outputs(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.sp3 = cls.path("day.SP3.gz")
        shutil.copyfile(sample(DAY), cls.sp3)
        cls.product = cls.path("day.nc")
        run("orbit", "-q", "--sat", "G01-G04", "-o", cls.product, cls.sp3)

    def kept(self, path, words, *args, status):
        """The command is refused with a sentence, and the file keeps its bytes."""
        before = hashlib.sha256(pathlib.Path(path).read_bytes()).hexdigest()
        self.assertIn(words, run(*args, status=status).stderr)
        self.assertEqual(hashlib.sha256(pathlib.Path(path).read_bytes()).hexdigest(), before)

    def test_an_input_is_no_output(self):
        hard, soft = self.path("hard"), self.path("soft")
        os.link(self.sp3, hard)
        os.symlink(self.sp3, soft)
        for name in (self.sp3, hard, soft, os.path.join(self.folder, ".", "day.SP3.gz")):
            for command in (["orbit", self.sp3], ["convert", self.sp3], ["orbit", self.sp3, "--force"]):
                self.kept(self.sp3, "which is read", *command, "-o", name, status=2)
        for command in ("states", "elements", "eclipses", "satellites", "navfit"):
            self.kept(self.product, "which is read", command, self.product, "-o", self.product, status=2)
        self.kept(self.sp3, "which is read", "navfit", self.product, "--nav", self.sp3, "--bits", self.sp3, status=2)

    def test_two_outputs_are_two_files(self):
        one = self.path("one")
        self.assertIn("are one file", run("navfit", self.product, "-o", one, "--bits", one, status=2).stderr)
        self.assertIn("are one file", run("navfit", self.product, "-o", "one", "--bits", "./one", status=2, cwd=self.folder).stderr)
        self.assertFalse(os.path.exists(one))

    def test_what_is_somebody_else_s(self):
        """Notes, published files, other programs' NetCDF; what Orrery wrote is replaced again and again."""
        notes = self.path("notes.txt")
        pathlib.Path(notes).write_text("t,lat,lon\n0,1,2\n", encoding="ascii")
        other = self.path("other.SP3.gz")
        shutil.copyfile(sample(DAY), other)
        foreign = self.path("foreign.nc")
        pathlib.Path(foreign).write_bytes(pathlib.Path(self.product).read_bytes()[:-SEAL])
        for path in (notes, other, foreign):
            self.kept(path, "--force replaces it", "states", self.product, "--step", "6h", "-o", path, status=1)
            self.kept(path, "--force replaces it", "orbit", "-q", "--sat", "G01", "-o", path, self.sp3, status=1)
            run("states", self.product, "--step", "6h", "-o", path, "--force")
        outputs = (("orbit", "-q", "--sat", "G01", self.sp3, "-o"), ("states", self.product, "--step", "6h", "-o"),
                   ("states", self.product, "--step", "6h", "--format", "json", "-o"),
                   ("states", self.product, "--step", "6h", "--format", "sp3", "-o"),
                   ("eclipses", self.product, "--format", "csv", "-o"), ("satellites", self.product, "--step", "6h", "-o"),
                   ("elements", self.product, "--step", "6h", "-o"),
                   ("elements", self.product, "--step", "6h", "--format", "nc", "-o"),
                   ("navfit", self.product, "-q", "-o"),
                   ("navfit", self.product, "-q", "--from", "2025-03-21T12:00", "--to", "2025-03-21T12:05", "--bits"),
                   ("tec", sample("ionosphere.ION"), "--at", "2025-03-21T12:00", "--point", "50,10", "-o"),
                   ("tec", sample("ionosphere.ION"), "--at", "2025-03-21T12:00", "--grid", "--format", "ionex", "-o"),
                   ("imu", sample("survey.yaml"), "-q", "--duration", "10", "-o"),
                   ("imu", sample("survey.yaml"), "-q", "--duration", "10", "--rate", "10", "--unit", "0", "-o"),
                   ("track", sample("survey.yaml"), "-q", "--duration", "10", "-o"))
        for k, words in enumerate(outputs):
            path = self.path(f"again{k}.nc" if words[0] in ("orbit", "imu") else f"again{k}")
            with self.subTest(words=words):
                run(*words, path)
                run(*words, path)

    def test_inputs_that_a_scenario_names(self):
        """What a scenario reads is an input as much as what the command line names: by its inode, whatever it is called."""
        log, readings = self.path("flight.csv"), self.path("readings.nc")
        run("track", "-q", sample("survey.yaml"), "--duration", "30", "-o", log)
        before = pathlib.Path(log).read_bytes()
        scenario = self.path("log.yaml")
        pathlib.Path(scenario).write_text("trajectory: {kind: telemetry, telemetry: [{file: flight.csv}]}\n", encoding="ascii")
        other = self.path("link.csv")
        os.link(log, other)
        for command in ("track", "imu"):
            for path in (log, other):
                self.assertIn("would overwrite", run(command, scenario, "-o", path, "--force", status=1).stderr)
        self.assertEqual(pathlib.Path(log).read_bytes(), before)
        run("imu", "-q", scenario, "-o", readings)
        # The files of `simulate` have names of its own.
        orbit, folder = self.path("orbit.nc"), pathlib.Path(self.path("simulated"))
        run("orbit", "-q", "-o", orbit, "--sat", "G01-G08", self.sp3)
        folder.mkdir()
        nav = folder / "broadcast.rnx"
        run("navfit", "-q", orbit, "--zero-clocks", "-o", nav)
        before = nav.read_bytes()
        whole = self.path("whole.yaml")
        pathlib.Path(whole).write_text(f"orbit: {{product: {orbit}}}\nnavdata: {{nav: [{nav}]}}\nsignals: ['G:L1CA']\n"
                                       "antennas: [{name: A, position: [52, 17, 124]}]\n", encoding="ascii")
        span = ("--from", "2025-03-21T12:00", "--to", "2025-03-21T12:00:02")
        self.assertIn("which is read: name another folder", run("simulate", "-q", whole, "-o", folder, *span, "--force", status=1).stderr)
        self.assertEqual(nav.read_bytes(), before)
        pathlib.Path(whole).write_text(pathlib.Path(whole).read_text(encoding="ascii").replace(f"navdata: {{nav: [{nav}]}}\n", ""), encoding="ascii")
        nav.write_text("mine\n", encoding="ascii")
        self.assertIn("was not written by Orrery", run("simulate", "-q", whole, "-o", folder, *span, status=1).stderr)
        run("simulate", "-q", whole, "-o", folder, *span, "--force")
        run("simulate", "-q", whole, "-o", folder, *span)  # its own files it replaces

    def test_extensions_in_any_case(self):
        path = self.path("readings.CSV")
        run("imu", sample("survey.yaml"), "-q", "--duration", "3", "-o", path)
        self.assertIn("dtheta_x_rad", pathlib.Path(path).read_text(encoding="ascii").splitlines()[0])

    def test_read_only(self):
        path = self.path("kept.nc")
        shutil.copyfile(self.product, path)
        os.chmod(path, 0o444)
        self.kept(path, "is read-only; --force", "orbit", "-q", "--sat", "G01", "-o", path, self.sp3, status=1)
        run("orbit", "-q", "--sat", "G01", "-o", path, self.sp3, "--force")
        self.assertNotEqual(pathlib.Path(path).read_bytes(), pathlib.Path(self.product).read_bytes())

    def test_places_that_cannot_be_written(self):
        """The system's reason, before anything is computed."""
        self.assertIn("No such file or directory", run("orbit", "-o", self.path("no/such.nc"), self.sp3, status=1).stderr)
        self.assertIn("is a folder", run("states", self.product, "-o", self.folder, status=1).stderr)
        with open("/dev/full", "w", encoding="ascii") as full:
            done = subprocess.run([ORRERY, "states", self.product], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("No space left on device", done.stderr)
        self.assertIn("No space left on device", run("states", self.product, "-o", "/dev/full", status=1).stderr)
        for words in (("states", self.product), ("satellites", self.product), ("states", self.product, "--format", "sp3"),
                      ("elements", self.product, "--step", "60"), ("elements", self.product, "--step", "60", "--format", "nc"),
                      ("orbit", self.sp3), ("imu", sample("survey.yaml"), "--duration", "60", "--rate", "1000"),
                      ("tec", sample("ionosphere.ION"), "--grid", "--from", "2025-03-21T00:00", "--step", "3600")):
            done = subprocess.run(["bash", "-c", 'ulimit -f 8; exec "$@"', "bash", ORRERY, *words, "-q", "-o", self.path("big")],
                                  capture_output=True, text=True, check=False)
            with self.subTest(words=words):
                self.assertEqual(done.returncode, 1)
                self.assertIn("File too large", done.stderr)
                self.assertFalse(any("big" in name for name in os.listdir(self.folder)))

    def test_left_by_a_killed_process(self):
        """What kill -9 leaves beside an output goes with the next run; a living process' file stays."""
        path = self.path("killed.csv")
        args = [ORRERY, "states", self.product, "--step", "0.0001", "-o", path]
        parts = lambda: sorted(n for n in os.listdir(self.folder) if n.startswith("killed.csv.part-"))  # noqa: E731
        with subprocess.Popen(args) as dead, subprocess.Popen(args) as alive:
            try:
                while len(parts()) < 2:
                    self.assertIsNone(dead.poll() or alive.poll())
                    time.sleep(0.01)
                dead.kill()
                dead.wait()
                self.assertEqual(len(parts()), 2)
                run("states", self.product, "--step", "6h", "-o", path)
                self.assertEqual(parts(), [f"killed.csv.part-{alive.pid}-0"])
            finally:
                dead.kill()
                alive.terminate()
        self.assertEqual(parts(), [])

    def test_large_files_of_no_format(self):
        """Refused by their first lines, before the rest is read."""
        big = self.path("plain.txt")
        pathlib.Path(big).write_bytes(b"no format at all, line by line\n" * (1 << 20))
        for words in (("orbit", big, "-o", self.path("none.nc")), ("orbit", self.sp3, "--erp", big, "-o", self.path("none.nc")),
                      ("tec", big, "--grid"), ("satellites", self.product, "--antex", big), ("navfit", self.product, "--antex", big),
                      ("elements", self.product, "--erp", big), ("compare", big, big), ("sisre", big, big)):
            with self.subTest(words=words):
                self.assertIn("first lines are of no format", run(*words, status=1).stderr)
        self.assertIn("a table of archives", run("fetch", "2024-02-04", "--archives", big, "--cache", self.path("cache"), status=1).stderr)

    def test_force_needs_a_file(self):
        self.assertIn("--force has no effect", run("states", self.product, "--force", status=2).stderr)
        self.assertIn("no option --force", run("inspect", self.product, "--force", status=2).stderr)

    def test_seals(self):
        """A part of a seal is an error; none is told, and the file is used."""
        cut = self.path("cut.nc")
        whole = pathlib.Path(self.product).read_bytes()
        for n in range(1, SEAL):
            pathlib.Path(cut).write_bytes(whole[:-n])
            if n in (1, 2, 40, SEAL - 14, SEAL - 1):
                self.assertIn("is cut", run("states", cut, status=1).stderr, n)
        pathlib.Path(cut).write_bytes(whole[:-SEAL])
        done = run("states", cut, "--at", "2025-03-21T12:00")
        self.assertIn("warning", done.stderr)
        self.assertIn("no seal", done.stderr)
        self.assertNotIn("seal", run("states", self.product, "--at", "2025-03-21T12:00").stderr)


if __name__ == "__main__":
    unittest.main()
