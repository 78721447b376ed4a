#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""An archive of days: the same bytes however it came to be (threads, chunks, kills), nothing half, nothing lost, days that join."""
import csv
import functools
import gzip
import hashlib
import http.server
import json
import os
import pathlib
import random
import resource
import shutil
import signal
import sqlite3
import subprocess
import sys
import threading

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import ORRERY, Folder, run, run_json, sample, ultra  # noqa: E402

DAYS = ("079", "080", "081")
KILLS = int(os.environ.get("ORRERY_KILLS", "100" if os.environ.get("ORRERY_LONG") else "10"))


FEW = ("G01", "G02", "G03", "E01", "E02", "R01")  # of the samples' satellites: what is tested here are days, not orbits


def thin(source, target):
    """A day's SP3 file with few satellites."""
    lines = gzip.decompress(pathlib.Path(source).read_bytes()).decode().splitlines()
    plus = [i for i, line in enumerate(lines) if line.startswith("+ ")]
    sats = [line[k:k + 3] for i in plus for line in (lines[i],) for k in range(9, 60, 3)]
    keep = [s for s in sats if s in FEW]
    assert len(keep) >= 5, sats
    names = "".join(keep).ljust(51, " ").replace("   ", "  0")
    for i in plus:
        lines[i] = "+" + (f"{len(keep):5d}" if i == plus[0] else " " * 5) + "   " + (names if i == plus[0] else "  0" * 17)
    out = [line for line in lines if not line.startswith(("P", "V")) or line[1:4] in keep]
    pathlib.Path(target).write_bytes(gzip.compress("\n".join(out).encode() + b"\n", mtime=0))


def content(archive):
    """Hashes of everything in the days of an archive."""
    root = pathlib.Path(archive)
    return {str(p.relative_to(root)): hashlib.sha256(p.read_bytes()).hexdigest()
            for p in sorted(root.glob("2*/**/*")) if p.is_file()}


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *args):
        pass


class Batch(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.inputs = cls.path("inputs")
        (pathlib.Path(cls.inputs) / "deeper").mkdir(parents=True)
        for k, day in enumerate(DAYS):
            thin(sample(f"ORR0TSTFIN_2025{day}0000_01D_15M_ORB.SP3.gz"),
                 pathlib.Path(cls.inputs) / ("deeper" if k == 1 else ".") / f"day{k}.anything")
        (pathlib.Path(cls.inputs) / "README").write_text("no orbits\n", encoding="utf-8")
        cls.whole = cls.path("whole")
        run("batch", "-q", "--archive", cls.whole, "--inputs", cls.inputs, "-j", 1)
        cls.bytes = content(cls.whole)

    def batch(self, archive, *more, **kwargs):
        return run("batch", "--archive", archive, "--inputs", self.inputs, *more, **kwargs)

    def test_days_are_there_and_again_nothing_is_made(self):
        self.assertEqual(sorted(self.bytes), [f"2025/{d}/{f}" for d in DAYS for f in ("day.json", "orbit.nc")])
        told = json.loads(self.batch(self.whole, "-q", "--format", "json").stdout)
        self.assertEqual((told["made"], told["fresh"], told["failed"]), (0, 3, 0))
        self.assertEqual(content(self.whole), self.bytes)
        record = json.loads((pathlib.Path(self.whole) / "2025/080/day.json").read_text(encoding="utf-8"))
        self.assertEqual([f["name"] for f in record["inputs"]], ["day0.anything", "day1.anything", "day2.anything"])
        product = pathlib.Path(self.whole) / "2025/080/orbit.nc"
        self.assertEqual(record["products"], [{"name": "orbit.nc", "sha256": hashlib.sha256(product.read_bytes()).hexdigest(),
                                               "bytes": product.stat().st_size}])

    def test_any_number_of_jobs_and_chunks(self):
        for jobs in (2, 5):
            other = self.path(f"jobs{jobs}")
            self.batch(other, "-q", "-j", jobs)
            self.assertEqual(content(other), self.bytes, jobs)
        plan, other = self.path("plan.txt"), self.path("chunks")
        self.batch(other, "-q", "--plan", plan, "--chunks", 2)
        self.assertFalse(pathlib.Path(other).exists())  # a plan makes nothing
        tasks = [subprocess.Popen([ORRERY, "batch", "-q", "--archive", other, "--inputs", self.inputs, "--chunk", f"{plan}:{n}"])
                 for n in (2, 1, 1)]
        self.assertEqual([t.wait(60) for t in tasks], [0, 0, 0])
        self.assertEqual(content(other), self.bytes)
        self.assertIn("has 2 chunks", self.batch(other, "--chunk", f"{plan}:3", status=1).stderr)
        text = pathlib.Path(plan).read_text(encoding="utf-8")
        pathlib.Path(plan).write_text(text.replace("by orrery ", "by orrery 0.0."), encoding="utf-8")
        self.assertIn("plan of another program", self.batch(other, "--chunk", f"{plan}:1", status=1).stderr)

    def test_killed_at_any_moment(self):
        """kill -9 of the batch at random moments: the next one goes on, and in the end there is what an undisturbed one makes."""
        other = pathlib.Path(self.path("killed"))
        luck = random.Random(3)
        killed = 0
        while killed < KILLS:
            task = subprocess.Popen([ORRERY, "batch", "-q", "--archive", other, "--inputs", self.inputs, "-j", "2"])
            try:
                task.wait(luck.uniform(0.0, 0.4))
            except subprocess.TimeoutExpired:
                task.kill()
                task.wait(10)
                killed += 1
                for name, digest in content(other).items():
                    if ".part-" not in name:
                        self.assertEqual(digest, self.bytes[name])
            else:
                killed += 1  # it was done before: from the begin
                shutil.rmtree(other)
        self.batch(other, "-q")
        self.assertEqual(content(other), self.bytes)
        self.assertEqual(sorted(p.name for p in (other / "2025").iterdir()), list(DAYS))

    def test_interrupted(self):
        other = self.path("interrupted")
        for _ in range(20):  # a batch may be done before a busy machine lets this test go on
            shutil.rmtree(other, ignore_errors=True)
            task = subprocess.Popen([ORRERY, "batch", "--archive", other, "--inputs", self.inputs, "-j", "1"],
                                    stderr=subprocess.PIPE, text=True)
            line = task.stderr.readline()
            task.send_signal(signal.SIGINT)
            told = line + task.communicate(timeout=60)[1]
            if task.returncode != 0:
                break
        self.assertEqual(task.returncode, -signal.SIGINT, told)
        self.assertIn("interrupted: ", told)
        for name, digest in content(other).items():
            self.assertEqual(digest, self.bytes[name])
        self.batch(other, "-q")
        self.assertEqual(content(other), self.bytes)

    def test_days_that_fail(self):
        """A missing day, a day twice, a file cut short: the others are made, and what failed is told."""
        inputs = pathlib.Path(self.path("gappy"))
        inputs.mkdir()
        thin(sample("ORR0TSTFIN_20250790000_01D_15M_ORB.SP3.gz"), inputs / "a.SP3.gz")
        thin(sample("ORR0TSTFIN_20250810000_01D_15M_ORB.SP3.gz"), inputs / "c.SP3.gz")
        other = self.path("gappy-archive")
        done = run("batch", "--archive", other, "--inputs", inputs, status=1)
        self.assertIn("2025-080: not made: there is no SP3 file of 2025-080", done.stderr)
        self.assertIn("2 days made, 0 were there, 1 not made", done.stderr)
        self.assertEqual(run_json("archive", "stats", other, "--format", "json")["without_a_neighbour"], 2)
        thin(sample("ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"), inputs / "b15.SP3.gz")
        thin(sample("ORR0TSTFIN_20250800000_01D_05M_ORB.SP3.gz"), inputs / "b05.SP3.gz")
        done = run("batch", "--archive", other, "--inputs", inputs, status=1)
        self.assertIn("several SP3 files are of 2025-080: b05.SP3.gz and b15.SP3.gz", done.stderr)
        (inputs / "b05.SP3.gz").unlink()
        self.assertIn("3 days made", run("batch", "--archive", other, "--inputs", inputs).stderr)  # neighbours have come
        cut = inputs / "b15.SP3.gz"
        cut.write_bytes(cut.read_bytes()[:4000])
        done = run("batch", "--archive", other, "--inputs", inputs, status=1)
        self.assertIn("b15.SP3.gz", done.stderr)
        self.assertEqual(run_json("archive", "stats", other, "--format", "json")["days"], 3)  # what was made before stays

    def test_damage_is_found(self):
        other = self.path("damaged")
        shutil.copytree(self.whole, other)
        product = pathlib.Path(other) / "2025/080/orbit.nc"
        product.write_bytes(product.read_bytes()[:-7])
        self.assertIn("080/orbit.nc", run("archive", "verify", other, status=1).stdout)
        (pathlib.Path(other) / "2025/081/day.json").write_text("{", encoding="utf-8")
        self.assertIn("081/day.json", run("archive", "verify", other, status=1).stdout)
        self.assertEqual([d["state"] for d in run_json("archive", "ls", other, "--format", "json")], ["ok", "ok", "format error"])
        run("batch", "-q", "--archive", other, "--inputs", self.inputs, "--again")
        self.assertEqual(content(other), self.bytes)
        leftover = pathlib.Path(other) / f"2025/.part-080-{os.uname().nodename.replace('-', '_')}-999999999"
        leftover.mkdir()
        (leftover / "orbit.nc").write_bytes(b"half")
        (pathlib.Path(other) / "notes.txt").write_text("mine", encoding="utf-8")
        told = run("archive", "gc", other).stdout
        self.assertIn("left by a batch that ended; removed", told)
        self.assertIn("notes.txt: is nothing that an archive has", told)
        self.assertFalse(leftover.exists())

    def test_report_and_catalogue(self):
        other = self.path("reported")
        shutil.copytree(self.whole, other)
        told = run_json("batch", "--archive", other, "--report", "--format", "json")
        joints = [d["joint_max_mm"] for d in told["days"]]
        self.assertIsNone(joints[0])
        self.assertLess(max(joints[1:]), 0.01)  # both take it from one solution; Chebyshev segments are fitted to 0.1 mm and better
        catalogue = pathlib.Path(other) / "catalogue.sqlite"
        with sqlite3.connect(catalogue) as db:
            self.assertEqual(db.execute("SELECT day, state FROM day ORDER BY day").fetchall(),
                             [(f"2025-{d}", "ok") for d in DAYS])
            db.execute("PRAGMA user_version=77")
        again = run("batch", "--archive", other, "--report", "--format", "json")
        self.assertIn("made anew", again.stderr)
        self.assertEqual(json.loads(again.stdout), told)
        catalogue.write_bytes(b"no database at all" * 100)
        self.assertEqual(json.loads(run("batch", "--archive", other, "--report", "--format", "json").stdout), told)
        catalogue.unlink()
        self.assertEqual(run_json("batch", "--archive", other, "--report", "--format", "json"), told)

    def test_elements_of_an_archive(self):
        """Rows of all days, one after the other, as of the products by name; the orbit goes on over midnight."""
        products = [f"{self.whole}/2025/{d}/orbit.nc" for d in DAYS]
        how = ("--sat", "G01", "--step", "900", "--frame", "j2000")
        rows = run("elements", "--archive", self.whole, *how).stdout
        self.assertEqual(rows, run("elements", *products, *how).stdout)
        self.assertEqual(len(rows.splitlines()), 1 + 3 * 96 + 1)
        part = run("elements", "--archive", self.whole, *how, "--from", "2025-03-21T12:00", "--to", "2025-03-22T12:00").stdout
        self.assertEqual(part.splitlines()[1:], [r for r in rows.splitlines() if "2025-03-21T12" <= r[:13] <= "2025-03-22T11"
                                                 or r.startswith("2025-03-22T12:00:00")])
        incl = [float(r.split(",")[4]) for r in rows.splitlines()[1:]]
        self.assertLess(max(abs(b - a) for a, b in zip(incl, incl[1:])), 4e-4)  # degrees: 2 n 900 s of J2's 3/8 J2 (R/a)^2 sin 2i = 1.3e-3
        # The oblateness turns the plane twice a revolution: the largest period of the inclination is half of 11.97 h.
        spectrum = self.path("periods.csv")
        told = run("elements", "--archive", self.whole, *how, "--periods", spectrum).stderr
        table = [r for r in csv.DictReader(pathlib.Path(spectrum).read_text(encoding="utf-8").splitlines()) if r["element"] == "i_deg"]
        peak = max((r for r in table if float(r["period_d"]) < 1), key=lambda r: float(r["amplitude"]))
        self.assertAlmostEqual(float(peak["period_d"]), 11.967 / 48, delta=0.005)
        self.assertIn(f"G01: inclination swings by {float(peak['amplitude']):.3g} deg in {float(peak['period_d']):.4g} days", told)
        self.assertIn("--periods needs", run("elements", "--archive", self.whole, *how, "--to", "2025-03-20T02:00", "--periods", spectrum, status=1).stderr)
        self.assertIn("one of them is needed", run("elements", *how, status=2).stderr)
        self.assertIn("has no day of the span", run("elements", "--archive", self.whole, "--from", "2026-01-01", status=1).stderr)

    def test_two_batches_on_one_archive(self):
        other = self.path("two")
        first = subprocess.Popen([ORRERY, "batch", "--archive", other, "--inputs", self.inputs, "-j", "1"],
                                 stderr=subprocess.PIPE, text=True)
        self.assertIn("made", first.stderr.readline())
        second = run("batch", "--archive", other, "--inputs", self.inputs, status=1)
        self.assertIn(f"another batch (process {first.pid}) works on this archive", second.stderr)
        first.communicate(timeout=60)
        self.assertEqual(first.returncode, 0)
        self.assertEqual(content(other), self.bytes)

    def test_wrong_use(self):
        for args, words in ((("--archive", "x"), "--inputs DIR is needed"),
                            (("--archive", "x", "--inputs", self.inputs, "--from", "2026-01-01"), "no file from the first day on"),
                            (("--archive", "x", "--inputs", self.inputs, "--chunk", "7"), "FILE:N")):
            self.assertIn(words, run("batch", *args, status=2, cwd=self.folder).stderr)
        self.assertIn("cannot be read", run("batch", "--archive", self.path("x"), "--inputs", self.path("none"), status=1).stderr)
        self.assertIn("none of ls", run("archive", "list", self.whole, status=2).stderr)
        self.assertIn("cannot be read", run("archive", "ls", self.path("none"), status=1).stderr)

    def test_mean_elements_across_midnights(self):
        """The method `mean` goes over midnights, where days meet, and tells what the three days smoothed jointly tell."""
        def rows(*args):
            table = csv.DictReader(run("elements", *args, "--sat", "G01", "--method", "mean", "--step", "3600").stdout.splitlines())
            return {r["t_gps"]: r for r in table}

        joint = self.path("joint.nc")
        run("orbit", "-q", "-o", joint, *sorted(map(str, pathlib.Path(self.inputs).rglob("*.anything"))))
        days, whole = rows("--archive", self.whole), rows(joint)
        self.assertEqual(sorted(days), sorted(whole))
        for hour in ("2025-03-20T22:00:00", "2025-03-21T00:00:00", "2025-03-21T03:00:00", "2025-03-21T23:00:00"):
            self.assertIn(hour, days)
        for t, row in days.items():
            self.assertAlmostEqual(float(row["a_m"]), float(whole[t]["a_m"]), delta=0.1)
            self.assertAlmostEqual(float(row["i_deg"]), float(whole[t]["i_deg"]), delta=1e-6)
            # The Earth's rotation of a day alone begins anew: 10 us of UT1 turn the node by 4e-8 deg a us.
            self.assertAlmostEqual(float(row["raan_deg"]), float(whole[t]["raan_deg"]), delta=1e-5)
        gappy = pathlib.Path(self.path("two-days"))
        shutil.copytree(self.whole, gappy)
        shutil.rmtree(gappy / "2025/080")
        self.assertNotIn("2025-03-20T22:00:00", rows("--archive", gappy))  # the day after is missing: nothing to go over to

    def test_beside_the_orbits(self):
        """Broadcast data, the TEC field and a station's session: the same bytes by any number of jobs; what is missing is noted, and
        what is wanted decides what is stale."""
        inputs = pathlib.Path(self.path("with-more"))
        shutil.copytree(self.inputs, inputs)
        shutil.copy(sample("ionosphere.ION"), inputs)
        scene = pathlib.Path(self.path("scene.yaml"))
        scene.write_text(f"orbit: {{sp3: [{sample('ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz')}]}}\n"
                         f"ionosphere: {{field: {sample('ionosphere.ION')}}}\nsignals: [G:L1CA, G:L5, E:E1, E:E5a]\n"
                         "antennas: [{name: BASE, position: [52, 17, 100]}]\nmask: {elevation: 5}\n", encoding="utf-8")
        made = self.path("made")
        run("simulate", scene, "-q", "-o", made, "--no-imu", "--step", "120s", "--from", "2025-03-21T09:00:00", "--to", "2025-03-21T12:00:00")
        shutil.copy(pathlib.Path(made) / "BASE.rnx", inputs)
        one = ("--inputs", inputs, "--from", "2025-03-21", "--to", "2025-03-21")
        ask = (*one, "--navdata", "--tec", "*.ION", "--stations", "base,NONE")
        archives = []
        for jobs in (1, 3):
            archives.append(pathlib.Path(self.path(f"more{jobs}")))
            run("batch", "-q", "--archive", archives[-1], *ask, "-j", jobs)
        self.assertEqual(content(archives[0]), content(archives[1]))
        day = archives[0] / "2025/080"
        record = json.loads((day / "day.json").read_text(encoding="utf-8"))
        self.assertEqual([p["name"] for p in record["products"]], ["orbit.nc", "broadcast.rnx", "field.ION", "session-BASE.nc"])
        self.assertIn("session-NONE.nc: not made: there are no observations of the day", record["notes"])
        self.assertEqual([st["station"] for st in record["stations"]], ["BASE"])
        self.assertGreater(record["stations"][0]["samples"], 100)
        run("archive", "verify", archives[0])
        # An independent judge: the broadcast data against the SP3 file that the orbit was made of.
        told = json.loads(run("sisre", day / "broadcast.rnx", sample("ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"), "--format", "json").stdout)
        self.assertTrue(told)
        self.assertIn("0 days made", run("batch", "--archive", archives[0], *ask).stderr)
        self.assertIn("1 days made", run("batch", "--archive", archives[0], *one).stderr)
        self.assertIn("is no list", run("batch", "--archive", archives[0], *one, "--tec", "*", "--stations", "A,,B", status=2).stderr)

    def test_a_disk_that_is_full(self):
        """Writes fail in the middle of a product: each day is told with its reason, nothing half is left, and later all is made."""
        other = pathlib.Path(self.path("full"))

        def no_room():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)  # then a write beyond the limit fails, as on a full disk
            resource.setrlimit(resource.RLIMIT_FSIZE, (60000, 60000))

        done = run("batch", "--archive", other, "--inputs", self.inputs, "-j", 2, status=1, preexec_fn=no_room)
        self.assertIn("0 days made, 0 were there, 3 not made", done.stderr)
        for day in DAYS:
            self.assertRegex(done.stderr, rf"2025-{day}: not made: .*orbit.nc.*: [A-Z]")
        self.assertEqual([p for p in other.rglob("*") if p.is_file() and p.name != ".lock"], [])
        self.batch(other, "-q")
        self.assertEqual(content(other), self.bytes)
        done = run("batch", "--archive", other, "--inputs", self.inputs, "--again", status=1, preexec_fn=no_room)
        self.assertIn("3 not made", done.stderr)
        self.assertEqual(content(other), self.bytes)  # the days that were there stand

    def test_a_product_that_was_cut(self):
        other = pathlib.Path(self.path("cut"))
        shutil.copytree(self.whole, other)
        product = other / "2025/080/orbit.nc"
        product.write_bytes(product.read_bytes()[:1000])
        self.assertRegex(run("states", product, status=1).stderr, "orbit.nc: .*[a-z]")
        self.assertIn("1 days made, 2 were there", self.batch(other).stderr)
        self.assertEqual(content(other), self.bytes)

    def test_a_plan_older_than_its_archive(self):
        """Days that came since are not the plan's, and those that are there already are left as they are."""
        other, plan = self.path("older"), self.path("older-plan.txt")
        run("batch", "-q", "--archive", other, "--inputs", self.inputs, "--to", "2025-03-21", "--plan", plan, "--chunks", 1)
        self.batch(other, "-q")
        before = content(other)
        self.assertIn("0 days made, 2 were there, 0 not made", self.batch(other, "--chunk", f"{plan}:1").stderr)
        self.assertEqual(content(other), before)
        pathlib.Path(plan).write_text("2025-079 2025-080\n", encoding="utf-8")
        self.assertIn("is no plan", self.batch(other, "--chunk", f"{plan}:1", status=1).stderr)

    def test_a_neighbour_that_failed(self):
        """The days beside one that cannot be read are made without it, say so, and are made again when it can be."""
        inputs = pathlib.Path(self.path("neighbour"))
        shutil.copytree(self.inputs, inputs)
        middle = next(inputs.rglob("day1.anything"))
        good = middle.read_bytes()
        middle.write_bytes(good[:4000])
        other = pathlib.Path(self.path("neighbours"))
        done = run("batch", "--archive", other, "--inputs", inputs, status=1)
        self.assertIn("2 days made, 0 were there, 1 not made", done.stderr)
        self.assertRegex(done.stderr, "2025-080: not made: .*day1.anything")
        record = json.loads((other / "2025/079/day.json").read_text(encoding="utf-8"))
        self.assertFalse(record["day_after"])
        self.assertTrue(any("day1.anything: is left aside" in note for note in record["notes"]), record["notes"])
        middle.write_bytes(good)
        self.assertIn("3 days made", run("batch", "--archive", other, "--inputs", inputs).stderr)
        self.assertEqual(content(other), self.bytes)

    def test_the_present(self):
        """--now: today's day from the newest ultra-rapids, made anew when newer ones come, and never in the place of an observed day."""
        cache, other = pathlib.Path(self.path("ultra")), pathlib.Path(self.path("present"))
        (cache / "2025/080").mkdir(parents=True)
        text = gzip.decompress(next(pathlib.Path(self.inputs).rglob("day1.anything")).read_bytes()).decode()
        env = {**os.environ, "ORRERY_CACHE": str(cache)}

        def now(at, *more, status=0):
            return run("batch", "--archive", other, "--now", "--present", f"2025-03-21T{at}", *more, env=env, status=status).stderr

        self.assertIn("no ultra-rapid orbits", now("13:00", status=1))
        (cache / "2025/080/TST0OPSULT_20250791200_01D_15M_ORB.SP3").write_text(ultra(text, "11:45"), encoding="ascii")
        self.assertIn("2025-080: made, observed until 2025-03-21T11:45:00", now("13:00"))
        first = content(other)
        self.assertIn("2025-080: is there", now("13:59"))
        self.assertEqual(content(other), first)
        (cache / "2025/080/TST0OPSULT_20250791800_01D_15M_ORB.SP3").write_text(ultra(text, "17:45"), encoding="ascii")
        self.assertIn("is there", now("17:00"))  # what is observed later than the present is not there yet
        told = now("20:10")
        for day in ("080", "081"):  # the next day begins within six hours
            self.assertIn(f"2025-{day}: made, observed until 2025-03-21T17:45:00", told)
        self.assertNotEqual(content(other)["2025/080/orbit.nc"], first["2025/080/orbit.nc"])
        rows = list(csv.DictReader(run("states", other / "2025/080/orbit.nc", "--sat", "G01", "--step", "900").stdout.splitlines()))
        self.assertEqual({r["t_gps"][11:16] for r in rows if not int(r["flags"]) & 2} - {"24:00"}, {f"{q // 4:02}:{q % 4 * 15:02}" for q in range(71)})
        # A prediction of six hours is near what was observed then, and by its own sigma.
        apart = [r for r in csv.DictReader(self.compared(other)) if r["t_gps"] > "2025-03-21T18"]
        self.assertGreater(len(apart), 5)
        self.assertLess(max(abs(float(r["radial_m"])) for r in apart), 0.5)
        self.assertEqual([d["state"] for d in run_json("archive", "ls", other, "--format", "json")], ["predicted", "predicted"])
        self.assertEqual(run_json("batch", "--archive", other, "--report", "--format", "json")["unusual"], 0)  # nobody takes its sigma for a fault
        run("archive", "verify", other)
        # The observed days take its place, and stay.
        self.assertIn("3 days made", self.batch(other).stderr)
        self.assertEqual(content(other), self.bytes)
        self.assertEqual(now("20:10").count("is there"), 2)
        self.assertEqual(content(other), self.bytes)
        self.assertIn("--now", run("batch", "--archive", other, "--now", "--report", status=2).stderr)

    def compared(self, archive):
        """Radial differences of an archive's middle day from the file that it was not made of."""
        table = self.path("compared.csv")
        run("compare", archive / "2025/080/orbit.nc", sample("ORR0TSTFIN_20250800000_01D_05M_ORB.SP3.gz"), "--sat", "G01", "--csv", table)
        return pathlib.Path(table).read_text(encoding="utf-8").splitlines()

    def test_days_that_are_fetched(self):
        """From a mirror on loopback: the same days as from the folder that it serves; what it does not have is told; again by the cache alone."""
        served, other, direct = (pathlib.Path(self.path(n)) for n in ("served", "fetched", "direct"))
        served.mkdir()
        for k, day in enumerate(DAYS):
            shutil.copy(next(pathlib.Path(self.inputs).rglob(f"day{k}.anything")), served / f"T{day}.SP3.gz")
        run("batch", "-q", "--archive", direct, "--inputs", served)
        handler = functools.partial(Quiet, directory=str(served))
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        try:
            table = pathlib.Path(self.path("table.txt"))
            table.write_text(f"name sp3 COD final - - T{{doy}}.SP3.gz\nmirror here * http://127.0.0.1:{server.server_port}/\n", encoding="utf-8")
            env = {**os.environ, "ORRERY_ARCHIVES": str(table), "ORRERY_CACHE": self.path("cache")}
            ask = ("batch", "--archive", other, "--fetch", "--from", "2025-03-20", "--to", "2025-03-22")
            told = run(*ask, env=env).stderr
            self.assertIn("3 days made", told)
            for day in ("078", "082"):
                self.assertIn(f"2025-{day}: no sp3: ", told)
            self.assertEqual(content(other), content(direct))
        finally:
            server.shutdown()
            server.server_close()
        self.assertIn("0 days made, 3 were there", run(*ask, "--offline", env=env).stderr)
        self.assertIn("--from and --to", run("batch", "--archive", other, "--fetch", status=2).stderr)
        self.assertIn("no orbits of these days", run("batch", "--archive", other, "--fetch", "--offline", "--from", "2001-01-01", "--to", "2001-01-02", env=env, status=1).stderr)


if __name__ == "__main__":
    import unittest
    unittest.main(argv=[__file__])
