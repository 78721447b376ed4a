#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures and their page: tables, drawings and commands belong together, and what cannot be made is said."""
import csv
import html
import html.parser
import math
import os
import pathlib
import re
import shutil
import sys
import unittest
import xml.etree.ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import ROOT, Folder, run, sample  # noqa: E402


class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.links, self.ids, self.outside = [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        if "id" in attrs:
            self.ids.append(attrs["id"])
        if tag == "a":
            self.links.append(attrs["href"])
        if tag in ("script", "link", "img", "iframe"):
            self.outside.append(tag)


def judgement(text):
    """What was processed, how good it is, what is suspicious: the page's sentences."""
    part = re.search(r'<section id="judgement">(.*?)</section>', text, re.S).group(1)
    return tuple([html.unescape(s) for s in re.findall(r"<li>(.*?)</li>", heading)] for heading in re.split(r"<h2>.*?</h2>", part)[1:])


class Figures(Folder):
    def make(self, name, *args, status=0):
        folder = pathlib.Path(self.path(name))
        told = run("figures", "-o", folder, "--samples", ROOT / "samples", *args, status=status)
        return folder, told

    def test_figures_and_page(self):
        folder, _ = self.make("some", "--only", "fig3", "--only", "fig4", "--only", "fig8-archive")
        text = (folder / "report.html").read_text(encoding="utf-8")
        page = Page(text)
        self.assertEqual(page.outside, [])  # one file, which needs no other
        self.assertEqual(page.ids, ["judgement", "fig3", "fig4", "fig8-archive"])  # in words first
        self.assertEqual(judgement(text), (["2 figures of 3, of the made data of the samples; no real files were named (--data)."],
                                           ["Nothing here is measured against something known."], ["Nothing."]))
        for link in page.links:
            self.assertTrue(link[1:] in page.ids if link.startswith("#") else (folder / link).is_file(), link)
        self.assertIn("Not made: is made of an archive: --archive DIR", text)
        self.assertIn("orrery track samples/survey.yaml --transfer 90,0 -o fig4.csv", text)
        for name in ("fig3", "fig4"):
            svg = (folder / f"{name}.svg").read_text(encoding="utf-8")
            xml.etree.ElementTree.fromstring(svg)
            self.assertIn("latitude, deg", svg)
            rows = (folder / f"{name}.csv").read_text(encoding="utf-8").splitlines()
            self.assertGreater(len(rows), 1000)
        # The line is the table: its points are as many as the table's, less one wherever it crosses the date line.
        points = len(re.findall(r"[ML]\d", re.search(r'class="line"[^>]*d="([^"]*)"', svg).group(1)))
        lon = [float(row.split(",")[2]) for row in rows[1:]]
        self.assertEqual(points, len(lon) - sum(abs(b - a) > 180 for a, b in zip(lon, lon[1:])))
        again, _ = self.make("some", "--only", "fig3", "--only", "fig4", "--only", "fig8-archive")  # over what is there
        self.assertEqual((again / "report.html").read_text(encoding="utf-8"), text)

    def test_kinds(self):
        """A map, a sky, one channel's terms: what is drawn is in the tables, and gnuplot makes the same figures as pixels."""
        folder, _ = self.make("kinds", "--only", "tec", "--only", "sky")
        picture = {}
        for name in ("tec", "sky"):
            picture[name] = (folder / f"{name}.svg").read_text(encoding="utf-8")
            xml.etree.ElementTree.fromstring(picture[name])
            self.assertIn("gnuplot", (folder / f"{name}.gp").read_text(encoding="utf-8"))
            if shutil.which("gnuplot"):
                self.assertEqual((folder / f"{name}.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        cells = len(re.findall(r'fill="#[0-9a-f]{6}"/>', picture["tec"]))
        rows = len((folder / "tec.csv").read_text(encoding="utf-8").splitlines()) - 1
        self.assertEqual(cells, rows + 64)  # and the scale beside it
        # Every point of the sky lies within the horizon's ring, at the radius of its elevation.
        ring = max(float(r) for r in re.findall(r'<circle cx="[\d.]+" cy="[\d.]+" r="([\d.]+)" fill="none"', picture["sky"]))
        cx, cy = map(float, re.search(r'<circle cx="([\d.]+)" cy="([\d.]+)" r="[\d.]+" fill="none"', picture["sky"]).groups())
        points = [tuple(map(float, p)) for p in re.findall(r"[ML](-?[\d.]+) (-?[\d.]+)", " ".join(re.findall(r'class="line"[^>]*d="(M[^"H]*)"', picture["sky"])))]
        self.assertGreater(len(points), 300)
        self.assertLess(max(((x - cx) ** 2 + (y - cy) ** 2) ** 0.5 for x, y in points), ring + 0.1)
        lowest = min(float(line.split(",")[3]) for line in (folder / "sky.csv").read_text(encoding="utf-8").splitlines()[1:])
        self.assertAlmostEqual(max(((x - cx) ** 2 + (y - cy) ** 2) ** 0.5 for x, y in points), ring * (90 - lowest) / 90, delta=3)

    def test_latency(self):
        """A service and its polls: the histogram counts every answer, and the figure is its stairs; the service is gone afterwards."""
        folder, _ = self.make("latency", "--only", "latency")
        for name in ("states", "channels"):
            with open(folder / f"latency-{name}.csv", encoding="ascii") as f:
                rows = list(csv.DictReader(f))
            self.assertEqual(sum(int(r["count"]) for r in rows), 300)
            self.assertAlmostEqual(sum(float(r["share"]) for r in rows), 1, delta=1e-3)
            middles = [float(r["latency_us"]) for r in rows]
            for a, b in zip(middles, middles[1:]):
                self.assertAlmostEqual(b / a, 2 ** 0.125, delta=2e-3)  # eight bins an octave, none left out
        svg = (folder / "latency.svg").read_text(encoding="utf-8")
        path = re.findall(r'class="line"[^>]*d="(M[^"H]*)"', svg)[1]  # the channels: each bin from its begin to its end
        self.assertEqual(len(re.findall(r"[ML]", path)), 2 * len(rows))
        self.assertFalse((folder / "latency.sock").exists())
        self.assertIn("orrery serve samples/rooftop.yaml -q --listen unix:latency.sock &amp;", (folder / "report.html").read_text(encoding="utf-8"))

    def test_fusion_finds_what_maps_lack(self):
        """The made station's phases are nearer to the truth of its channels than the maps, by the wave that they do not know."""
        folder, _ = self.make("fusion", "--only", "fusion", "--only", "terms")  # one simulation for both
        per_m = 1575.42e6 ** 2 / 40.3e16  # TECU
        with open(folder / "disturbed/STAT-channels.csv", encoding="ascii") as f:
            truth = {r["t_gps"]: (float(r["ionosphere_m"]) + float(r["disturbance_m"])) * per_m for r in csv.DictReader(f)
                     if (r["sat"], r["signal"]) == ("G05", "L1CA")}
        with open(folder / "fusion.csv", encoding="ascii") as f:
            rows = [r for r in csv.DictReader(f) if r["t_gps"] in truth]
        self.assertGreater(len(rows), 700)
        error = {k: math.sqrt(sum((float(r[k]) - truth[r["t_gps"]]) ** 2 for r in rows) / len(rows)) for k in ("stec_tecu", "model_stec_tecu")}
        self.assertLess(error["stec_tecu"], 0.4 * error["model_stec_tecu"], error)
        self.assertEqual((folder / "terms.svg").read_text(encoding="utf-8").count('class="line" stroke'), 2 * 7)  # each and its key

    def test_logarithmic_axes(self):
        """gnuplot takes scripts of every kind of axes: a picture is whole, or not there."""
        if not shutil.which("gnuplot"):
            self.skipTest("gnuplot is not installed")
        folder, _ = self.make("logarithmic", "--only", "methods", "--only", "allan")
        for name in ("methods", "allan"):
            self.assertEqual((folder / f"{name}.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n", name)
            self.assertEqual((folder / f"{name}.png").read_bytes()[-8:-4], b"IEND", name)

    def test_archive_of_days(self):
        archive = self.path("archive")
        inputs = pathlib.Path(self.path("inputs"))
        inputs.mkdir()
        for day in ("079", "080"):
            name = f"ORR0TSTFIN_2025{day}0000_01D_15M_ORB.SP3.gz"
            (inputs / name).symlink_to(sample(name))
        run("batch", "-q", "--archive", archive, "--inputs", inputs)
        folder, _ = self.make("by-archive", "--only", "fig8-archive", "--archive", archive)
        self.assertTrue((folder / "fig8-archive.svg").is_file())
        processed, good, suspicious = judgement((folder / "report.html").read_text(encoding="utf-8"))
        self.assertIn("An archive of 2 days, 2025-079 to 2025-080; 0 are missing between.", processed)
        self.assertRegex(good[-1], r"^Days join within 0\.00\d mm at 1 midnights \(wanted: 0\.1 mm\)\.$")
        self.assertEqual(suspicious, ["Nothing."])
        # A record that somebody damaged is told at the top.
        (pathlib.Path(archive) / "2025/079/day.json").write_text("{", encoding="ascii")
        folder, _ = self.make("by-archive", "--only", "fig8-archive", "--archive", archive)
        self.assertEqual(judgement((folder / "report.html").read_text(encoding="utf-8"))[2], ["2025-079: its record cannot be read (format error)."])

    @unittest.skipUnless(os.environ.get("ORRERY_LONG"), "a year of days takes half a minute of processor time: ORRERY_LONG=1")
    def test_made_year(self):
        """Figure 8 without real data: the Moon's and the Sun's periods stand in the inclination, and the manoeuvre in the semi-major axis."""
        folder, _ = self.make("year", "--only", "fig8", "--only", "periods", "--only", "resonance")
        peaks = {}
        with open(folder / "year-periods.csv", encoding="ascii") as f:
            for row in csv.DictReader(f):
                if row["element"] == "i_deg":
                    for column, least, most in (("explained", 100, 250), ("windowed", 10, 20)):
                        if least < float(row["period_d"]) < most:
                            key, value = (row["sat"], column), (float(row[column]), float(row["period_d"]))
                            peaks[key] = max(peaks.get(key, value), value)
        self.assertEqual(len(peaks), 6)
        for (_, column), (_, period) in peaks.items():
            # Half a tropical year and half a tropical month against the node, which goes by -0.039 deg a day: 175.7 and 13.62 days.
            self.assertAlmostEqual(period, 175.7 if column == "explained" else 13.62, delta=8 if column == "explained" else 0.25)
        with open(folder / "year.csv", encoding="ascii") as f:
            a_m = {r["t_gps"][:13]: float(r["a_m"]) for r in csv.DictReader(f) if r["sat"] == "G06"}
        self.assertAlmostEqual(a_m["2024-07-02T00"] - a_m["2024-06-30T00"], 2 * 0.05 * math.sqrt(26.56e6 ** 3 / 3.986004415e14), delta=30)

    def test_judgement_is_of_the_tables(self):
        """The figures told are those of the tables, reckoned here anew; and a figure beyond what it ought to be is suspicious."""
        folder, _ = self.make("judged", "--only", "sigma")
        with open(folder / "gap.csv", encoding="ascii") as a, open(folder / "gap-states.csv", encoding="ascii") as b:
            sigma = {r["t_gps"]: float(r["sigma_radial_m"]) for r in csv.DictReader(b)}
            within = [abs(float(r["radial_m"])) <= math.hypot(sigma[r["t_gps"]], 1e-3 / math.sqrt(12)) for r in csv.DictReader(a)]
        _, good, suspicious = judgement((folder / "report.html").read_text(encoding="utf-8"))
        self.assertRegex(good[0], rf"reckoned with: {100 * sum(within) / len(within):.3g} % \(of {len(within)} values")
        self.assertEqual(suspicious, ["Nothing."])

    def test_what_cannot_be_made(self):
        empty = pathlib.Path(self.path("empty"))
        empty.mkdir()
        told = run("figures", "-o", self.path("none"), "--samples", empty, "--only", "fig3", status=1).stderr
        self.assertIn("survey.yaml", told)
        self.assertIn("1 figures could not be made", told)
        self.assertIn("survey.yaml", (pathlib.Path(self.path("none")) / "report.html").read_text(encoding="utf-8"))
        self.assertIn("there is no figure 'fig99'", run("figures", "-o", self.path("x"), "--only", "fig99", status=2).stderr)
        self.assertIn("--samples DIR", run("figures", "-o", self.path("x"), cwd=empty, status=1).stderr)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
