# SPDX-License-Identifier: GPL-3.0-or-later
"""`orrery orbit` and `orrery compare` on the samples, and what they say to inputs that are wrong."""
import gzip
import pathlib
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import Folder, run, run_json, sample  # noqa: E402

DAYS = [f"ORR0TSTFIN_2025{d:03}0000_01D_15M_ORB.SP3.gz" for d in (79, 80, 81)]
TRUTH = "ORR0TSTFIN_20250800000_01D_05M_ORB.SP3.gz"


def sp3_text(name):
    with gzip.open(sample(name), "rt", encoding="ascii") as f:
        return f.read()


class Orbit(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.product = cls.path("day.nc")
        cls.summary = run_json("orbit", "--format", "json", "-o", cls.product, sample(DAYS[1]))

    def test_summary(self):
        s = self.summary
        self.assertEqual((s["from"], s["to"]), ("2025-03-21T00:00:00", "2025-03-22T00:00:00"))
        self.assertEqual({k: v["satellites"] for k, v in s["systems"].items()}, {"G": 32, "R": 24, "E": 24})
        self.assertEqual(s["systems"]["G"]["nodes"], 32 * 97)
        self.assertEqual(s["node_step_s"], 900)
        self.assertLess(s["segment_error_mm"], 0.1)
        self.assertLess(s["segment_error_mps"], 1e-6)
        for v in s["systems"].values():  # 1 mm rounding is 0.5 mm RMS in space; most of it stays in the residuals
            self.assertTrue(0.1 < v["residual_rms_mm"] < 1)

    def test_compare_with_the_truth(self):
        x = run_json("compare", "--format", "json", self.product, sample(TRUTH))
        self.assertEqual(set(x["systems"]), {"G", "R", "E"})
        for system, places in x["systems"].items():
            with self.subTest(system=system):
                inner, edge = places["inner"], places["edge"]
                # The product's keys, all of them.
                self.assertLessEqual({"n", "rms_mm", "p95_mm", "max_mm", "vel_rms_mps"}, set(inner))
                self.assertEqual(inner["n"], inner["satellites"] * 160)  # 20 h of 8 epochs that are no nodes
                self.assertEqual(edge["n"], edge["satellites"] * 12)
                self.assertEqual(places["gap"]["n"], 0)
                self.assertIsNone(places["gap"]["rms_mm"])
                self.assertLess(inner["rms_mm"], 0.75)
                self.assertLess(inner["max_mm"], 6)
                self.assertLessEqual(inner["rms_mm"], inner["p95_mm"])
                self.assertLess(edge["rms_mm"], 1.2)
                self.assertLess(inner["vel_rms_mps"], 5e-6)
                self.assertLess(max(map(abs, inner["mean_mm"])), 0.1)
        table = run("compare", self.product, sample(TRUTH)).stdout
        for word in ("GPS", "GLONASS", "Galileo", "inner", "edge", "RMS mm"):
            self.assertIn(word, table)

    def test_nodes_is_a_decimation(self):
        thin, five = self.path("thin.nc"), self.path("five.nc")
        a = run_json("orbit", "--format", "json", "-o", thin, "--nodes", "900", "--sat", "G01-G05", sample(TRUTH))
        b = run_json("orbit", "--format", "json", "-o", five, "--sat", "G01-G05", sample(TRUTH))
        self.assertEqual((a["systems"]["G"]["nodes"], b["systems"]["G"]["nodes"]), (5 * 97, 5 * 289))
        self.assertEqual((a["node_step_s"], b["node_step_s"]), (900, 300))
        done = run("compare", five, sample(TRUTH), status=1)  # every epoch was an input
        self.assertIn("1445 are at epochs that the product was made from", done.stderr)

    def test_exclude_makes_a_gap(self):
        gap = self.path("gap.nc")
        s = run_json("orbit", "--format", "json", "-o", gap, "--sat", "G01-G08,R,E", "--exclude", "2025-03-21T12:00/2025-03-21T13:00", sample(DAYS[1]))
        self.assertEqual(s["systems"]["E"]["nodes"], 24 * (97 - 4))  # 12:00 to 12:45; the end is not in the interval
        x = run_json("compare", "--format", "json", gap, sample(TRUTH))
        for system, places in x["systems"].items():
            # 11:45 to 13:00 every 5 min, ends left out; what was excluded is no input and is compared.
            self.assertEqual(places["gap"]["n"], places["gap"]["satellites"] * 14)
            self.assertLess(places["gap"]["rms_mm"], 3, system)
        at = ("--from", "2025-03-21T12:20", "--to", "2025-03-21T12:20", "--sat", "G01")
        flags = [int(run("states", p, *at).stdout.splitlines()[1].split(",")[9]) for p in (self.product, gap)]
        self.assertEqual([f & 32 for f in flags], [0, 32])

    def test_jobs_and_order_do_not_matter(self):
        out = [self.path(f"jobs{i}.nc") for i in range(3)]
        files = [sample(d) for d in DAYS]
        sats = ("--sat", "G01-G04,E14,R01-R03")
        run("orbit", "-q", "-o", out[0], "-j", "1", *sats, *files)
        run("orbit", "-q", "-o", out[1], "-j", "2", *sats, *files)
        run("orbit", "-q", "-o", out[2], "-j", "2", *sats, *reversed(files))
        states = [run("states", p, "--step", "777").stdout for p in out]
        self.assertEqual(states[0], states[1])
        self.assertEqual(states[0], states[2])

    def test_literal_method_is_there_and_worse(self):
        out = self.path("literal.nc")
        run("orbit", "-q", "-o", out, "--method", "literal", "--sat", "G01-G05", sample(DAYS[1]))
        x = run_json("compare", "--format", "json", out, sample(TRUTH))
        self.assertGreater(x["systems"]["G"]["inner"]["rms_mm"], 2)

    def test_product_explains_itself(self):
        done = subprocess.run(["ncdump", "-h", self.product], capture_output=True, text=True, check=True)
        for word in ("Chebyshev", "dx/dt", "clock_max_gap_s", "sample_dimension", DAYS[1], "orrery orbit --format json",
                     "nanoseconds since 1980-01-06", 'reference_frame = "', "input_sha256"):
            self.assertIn(word, done.stdout)

    def test_gaps_tell_what_became_of_them(self):
        args = ("orbit", "-o", self.path("gaps.nc"), "--sat", "G01,G02", "--exclude", "2025-03-21T02:01/2025-03-21T04:00", sample(DAYS[1]))
        told = run(*args).stderr
        self.assertIn("G01: no positions between 2025-03-21T02:00:00 and 2025-03-21T04:00:00: bridged by the smoothed orbit", told)
        self.assertIn("left open, longer than is bridged", run(*args, "--max-gap", "1h").stderr)

    def test_days_of_different_frames(self):
        text = gzip.open(sample(DAYS[2]), "rt", encoding="ascii").read()
        self.assertEqual(text[46:51], "IGS20")
        other = self.path("other.sp3")
        pathlib.Path(other).write_text(text[:46] + "IGb14" + text[51:], encoding="ascii")
        args = ("orbit", "-o", self.path("joined.nc"), "--sat", "G01-G03", sample(DAYS[1]))
        self.assertIn("orbits of different frames are joined", run(*args, other).stderr)
        self.assertNotIn("frames", run(*args, sample(DAYS[2])).stderr)

    def test_nodes_that_the_file_does_not_have(self):
        args = ("orbit", "-o", self.path("nodes.nc"), "--sat", "G01-G03", sample(DAYS[1]), "--nodes")
        self.assertIn("what both have is every 9000 s", run(*args, "1000").stderr)
        self.assertNotIn("warning", run(*args, "1800").stderr)

    def test_a_file_of_another_kind(self):
        for name in ("states", "elements", "eclipses", "satellites", "navfit"):
            self.assertIn("`orrery orbit -o day.nc", run(name, sample(DAYS[1]), status=1).stderr, name)
        self.assertIn("which can be served", run("serve", sample(DAYS[1]), "--listen", "tcp://127.0.0.1:0", status=1).stderr)
        self.assertIn("neither a scenario nor an orbit product", run("serve", sample("ionosphere.ION"), "--listen", "tcp://127.0.0.1:0", status=1).stderr)

    def test_wrong_inputs(self):
        empty, binary, cut, html = (self.path(n) for n in ("empty.sp3", "binary.sp3", "cut.sp3", "page.sp3"))
        text = sp3_text(DAYS[1])
        pathlib.Path(empty).write_bytes(b"")
        pathlib.Path(binary).write_bytes(bytes(range(256)) * 64)
        pathlib.Path(cut).write_text(text[:700], encoding="ascii")
        pathlib.Path(html).write_text("<!DOCTYPE html><html><body>Sign in</body></html>\n", encoding="ascii")
        before = self.left()
        out = self.path("never.nc")
        for name in (empty, binary, cut, html, self.path("absent.sp3"), self.product):
            with self.subTest(name=name):
                done = run("orbit", "-o", out, name, status=1)
                self.assertEqual(done.stdout, "")
                self.assertIn(pathlib.Path(name).name, done.stderr)
                self.assertEqual(self.left(), before)
        for args, status, word in (
                (("orbit", sample(DAYS[1])), 2, "--output FILE is needed"),
                (("orbit", "-o", out), 2, "SP3... is needed"),
                (("orbit", "-o", out, "--nodes", "-5", sample(DAYS[1])), 2, "--nodes"),
                (("orbit", "-o", out, "--exclude", "2025-03-21", sample(DAYS[1])), 2, "FROM/TO"),
                (("orbit", "-o", out, "--sat", "J01", sample(DAYS[1])), 1, ""),
                (("orbit", "-o", out, "--exclude", "2025-03-20/2025-03-23", sample(DAYS[1])), 1, ""),
                (("orbit", "-o", "/nowhere/at/all.nc", "--sat", "G01", sample(DAYS[1])), 1, "/nowhere/at/all.nc"),
                (("compare", self.product, sample(DAYS[1])), 1, "nothing to compare"),
                (("compare", self.product, cut), 1, "cut.sp3"),
                (("compare", sample(TRUTH), self.product), 1, "NetCDF")):
            with self.subTest(args=args):
                done = run(*args, status=status)
                self.assertEqual(done.stdout, "")
                self.assertIn(word, done.stderr)
                self.assertGreater(len(done.stderr), 20)
                self.assertEqual(self.left(), before)


class ThreeDays(Folder):
    """The events that the samples' README plants, found in the product."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.product = cls.path("three.nc")
        cls.summary = run_json("orbit", "--format", "json", "-o", cls.product, "--sat", "G08-G12,R08,R09,E24,E14", *(sample(d) for d in DAYS))

    def state(self, sat, when):
        lines = run("states", "-q", self.product, "--sat", sat, "--from", when, "--to", when).stdout.splitlines()
        return dict(zip(lines[0].split(","), lines[1].split(","))) if len(lines) > 1 else None

    def test_gap_without_positions(self):
        self.assertEqual(int(self.state("R08", "2025-03-20T10:30")["flags"]) & 32, 32)
        self.assertEqual(int(self.state("R08", "2025-03-20T08:40")["flags"]) & 32, 0)
        self.assertEqual(self.summary["systems"]["R"]["gaps"], 1)

    def test_manoeuvre(self):
        self.assertEqual(int(self.state("G10", "2025-03-22T14:10")["flags"]) & 4, 4)
        self.assertEqual(int(self.state("G10", "2025-03-22T13:00")["flags"]) & 4, 0)
        self.assertEqual({k: v["manoeuvres"] for k, v in self.summary["systems"].items()}, {"G": 1, "R": 0, "E": 0})

    def test_events_are_told_one_by_one(self):
        told = {kind: [e for e in self.summary["events"] if e["kind"] == kind] for kind in ("manoeuvre", "gap", "jump")}
        self.assertEqual([e["sat"] for e in told["manoeuvre"]], ["G10"])
        self.assertTrue(told["manoeuvre"][0]["from"] <= "2025-03-22T14:10" <= told["manoeuvre"][0]["to"])
        self.assertGreater(told["manoeuvre"][0]["change_mps"], 0.01)
        self.assertEqual([e["sat"] for e in told["gap"]], ["R08"])
        self.assertEqual(len(told["jump"]), self.summary["day_jumps"]["n"])
        self.assertIn("1 manoeuvre, ", run("inspect", self.product).stdout)

    def test_vanished_satellite(self):
        self.assertIsNotNone(self.state("E24", "2025-03-21T23:59"))
        self.assertIsNone(self.state("E24", "2025-03-22T02:00"))

    def test_days_join(self):
        self.assertEqual(self.summary["day_jumps"]["n"], 2 * 9)
        self.assertGreaterEqual(self.summary["day_jumps"]["max_mm"], self.summary["day_jumps"]["rms_mm"])


if __name__ == "__main__":
    unittest.main()
