# SPDX-License-Identifier: GPL-3.0-or-later
"""What `orrery navfit` writes beside bits: RINEX 4.02, RTCM 3, almanacs as YUMA and SEM; read by readers of others or by the formats' documents."""
import collections
import math
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import messages  # noqa: E402
import navdata  # noqa: E402
from program import Folder, data, run, run_json  # noqa: E402
from test_messages import rinex_records  # noqa: E402
from test_navfit import seconds, states  # noqa: E402

WEEK = 604800
# Lines of an ephemeris record of RINEX 4.02 behind its "> EPH" line (tables A6 to A29).
LINES = {"LNAV": 8, "CNAV": 9, "CNV1": 10, "CNV2": 10, "CNV3": 9, "INAV": 8, "FNAV": 8, "D1": 8, "D2": 8, "FDMA": 5, "SBAS": 4}


def records4(path):
    """(kind, sat, message) -> records: the epoch's text, what follows it on its line, and the numbers of all lines in order."""
    head, body = pathlib.Path(path).read_text(encoding="ascii").split("END OF HEADER", 1)
    out = collections.defaultdict(list)
    for block in body.split("\n> ")[1:]:
        first, *lines = block.rstrip("\n").split("\n")
        kind, sat, message = first.split()
        numbers = []
        for k, line in enumerate(lines):
            if kind == "STO" and k == 0:
                continue
            numbers += [float(line[c:c + 19]) if line[c:c + 19].strip() else None for c in range(23 if k == 0 else 4, len(line), 19)]
        out[kind, sat, message].append((lines[0][4:23], lines[0][23:], numbers, len(lines)))
    return head, out


class Files(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.product = cls.path("day.nc")
        run("orbit", "-q", "-o", cls.product, "--sat", "G05,G12,C01,C06,C30,E11,J02,R07", data("2020-177/Sta21114.sp3.gz"))
        cls.three, cls.four = cls.path("three.rnx"), cls.path("four.rnx")
        nav = data("2020-177/ESBC00DNK_R_20201770000_01D_MN.rnx.gz")
        cls.said = run("navfit", cls.product, "-o", cls.four, "--rinex", "4", "--nav", nav, "--rtcm", cls.path("sets.rtcm"), "--yuma", cls.path("yuma.txt"),
                       "--sem", cls.path("sem.txt"), "--bits", cls.path("bits.csv"), "--from", "2020-06-25T12:00:00", "--to", "2020-06-25T12:12:30").stderr
        cls.of_three = run("navfit", cls.product, "-o", cls.three, "--nav", nav).stderr
        cls.head, cls.records = records4(cls.four)
        cls.sets = collections.Counter((s["sat"], s["message"]) for s in run_json("navfit", cls.product, "--format", "json")["sets"])

    def test_version_4_has_every_set(self):
        self.assertRegex(self.head, r"^     4\.02 {11}N: GNSS NAV DATA {4}M: Mixed")
        self.assertNotIn("IONOSPHERIC CORR", self.head)
        self.assertEqual({(sat, message): len(r) for (kind, sat, message), r in self.records.items() if kind == "EPH"}, dict(self.sets))
        for (kind, _, message), found in self.records.items():
            if kind == "EPH":
                self.assertEqual({r[3] for r in found}, {LINES[message]}, message)
        three = rinex_records(self.three)
        for sat in three:  # what both versions hold is the same to the last digit
            ours = [[r[0], r[2]] for (kind, s, message), found in self.records.items() if (kind, s) == ("EPH", sat) for r in found
                    if message not in ("CNAV", "CNV1", "CNV2", "CNV3")]
            self.assertEqual(sorted(map(str, ours)), sorted(map(str, three[sat])))
        self.assertRegex(self.of_three, r"RINEX 3\.05 has no records of \d+ sets \(CNAV and its kin\); --rinex 4 writes them")
        self.assertNotIn("has no records", self.said)

    def test_version_4_orbits(self):
        """CNAV and B-CNAV evaluated from their records: 4 mm over their windows."""
        truth = states(self.product, "G,C,J", seconds("2020-06-25T11:00:00"), seconds("2020-06-25T13:00:00"), 600)
        names = ("af0", "af1", "af2", "a_dot", "crs", "delta_n", "m0", "cuc", "e", "cus", "sqrt_a", "toe", "cic", "omega0", "cis", "i0", "crc", "omega", "omega_dot",
                 "idot", "n_dot")
        seen = set()
        for (kind, sat, message), found in self.records.items():
            if kind != "EPH" or message not in ("CNAV", "CNV1", "CNV2", "CNV3"):
                continue
            for epoch, _, numbers, _ in found:
                eph = dict(zip(names, numbers))
                toc = seconds("{}-{}-{}T{}:{}:{}".format(*epoch.split()))
                if sat[0] != "C":
                    eph["toe"] = toc % WEEK  # the field is top's
                gm, shift = (messages.BEIDOU_GM, 14) if sat[0] == "C" else (3.986005e14, 0)
                rate = messages.BEIDOU_RATE if sat[0] == "C" else messages.GALILEO_RATE
                for (s, t), (position, _) in truth.items():
                    if s == sat and abs(t - shift - toc) <= 1800:
                        self.assertLess(math.dist(messages.kepler_position(eph, t - shift, gm, rate), position), 0.03, (sat, message, t))
                        seen.add((sat[0], message))
        self.assertEqual(seen, {("G", "CNAV"), ("G", "CNV2"), ("J", "CNAV"), ("J", "CNV2"), ("C", "CNV1"), ("C", "CNV2"), ("C", "CNV3")})

    def test_version_4_other_records(self):
        codes = {r[1].split()[0] for (kind, _, _), found in self.records.items() if kind == "STO" for r in found}
        self.assertEqual(codes, {"GPUT", "GLUT", "GAUT", "BDUT", "QZUT", "GAGP", "GLGP", "BDGP", "QZGP"})
        self.assertEqual({k[1:] for k in self.records if k[0] == "ION"}, {("G05", "LNAV"), ("E11", "IFNV")})
        self.assertEqual(self.records["ION", "G05", "LNAV"][0][2][:4], [4.6566e-09, 1.4901e-08, -5.9605e-08, -1.1921e-07])
        (_, _, (xp, xp_rate, _, _, yp, *_), _), = self.records["EOP", "G05", "CNVX"]
        self.assertTrue(0.1 < xp < 0.2 and 0.4 < yp < 0.45 and abs(xp_rate) < 0.01)  # arc seconds on 2020-06-25
        text = run("inspect", self.four).stdout
        self.assertIn("time offsets 9", text)
        self.assertIn("Earth orientation 3", text)
        # Our own reader finds CNAV's orbits in it.
        judged = run_json("sisre", self.four, data("2020-177/Sta21114.sp3.gz"), "--message", "CNAV", "--format", "json")
        self.assertLess(judged["systems"]["G"]["orbit_3d_m"], 0.03)

    def test_rtcm_as_rtklib_reads_it(self):
        if shutil.which("convbin") is None:
            self.skipTest("RTKLIB's convbin is not here")
        out = self.path("rtcm.nav")
        subprocess.run(["convbin", "-r", "rtcm3", "-tr", "2020/06/25", "00:00:00", "-od", "-os", "-v", "3.04", "-n", out, self.path("sets.rtcm")],
                       capture_output=True, check=True, timeout=60)
        theirs, ours = rinex_records_any(out), rinex_records(self.three)
        self.assertEqual({s: len(r) for s, r in theirs.items()}, {s: len(r) for s, r in ours.items()})
        for sat, records in ours.items():
            # GLONASS' message holds a time of the day alone, and convbin knows the day by its option.
            from_column = 11 if sat[0] == "R" else 0
            for epoch, numbers in records:
                self.assertTrue(any(e[from_column:] == epoch[from_column:] and agree(sat, numbers, n) for e, n in theirs[sat]), (sat, epoch, numbers))

    def almanacs_sent(self):
        """The almanacs of GPS as the bits have them."""
        told = {}
        for line in pathlib.Path(self.path("bits.csv")).read_text(encoding="ascii").splitlines()[1:]:
            _, sat, message, _, number, *_, code = line.split(",")
            if sat == "G05" and message == "LNAV" and number in "45":
                a = navdata.lnav_almanac(navdata.lnav_subframe(code))
                if a is not None:
                    told[a["number"]] = a
        self.assertEqual(set(told), {5, 12})
        return told

    def test_yuma(self):
        text = pathlib.Path(self.path("yuma.txt")).read_text(encoding="ascii")
        sent, found = self.almanacs_sent(), {}
        for block in text.strip().split("\n\n"):
            title, *lines = block.split("\n")
            self.assertRegex(title, r"^\*{8} Week +\d+ almanac for PRN-\d+ \*{8}$")
            values = {name: float(value) for name, value in (line.split(":") for line in lines)}
            found[int(values["ID"])] = values
        self.assertEqual(set(found), {5, 12, 194})
        for prn, a in sent.items():
            v = found[prn]
            for name, value in (("Eccentricity", a["e"]), ("Rate of Right Ascen(r/s)", a["omega_dot"]), ("SQRT(A)  (m 1/2)", a["sqrt_a"]),
                                ("Right Ascen at Week(rad)", a["omega0"]), ("Argument of Perigee(rad)", a["omega"]), ("Mean Anom(rad)", a["m0"]),
                                ("Af0(s)", a["af0"]), ("Af1(s/s)", a["af1"]), ("Orbital Inclination(rad)", a["i0"]), ("Time of Applicability(s)", a["toe"])):
                self.assertAlmostEqual(v[name], value, delta=2e-9 * max(abs(value), 1e-12), msg=(prn, name))
            self.assertEqual((v["week"], v["Health"]), (2111 % 1024, 0))
        j = found[194]
        eph = {"sqrt_a": j["SQRT(A)  (m 1/2)"], "e": j["Eccentricity"], "omega": j["Argument of Perigee(rad)"], "m0": j["Mean Anom(rad)"],
               "i0": j["Orbital Inclination(rad)"], "omega0": j["Right Ascen at Week(rad)"], "omega_dot": j["Rate of Right Ascen(r/s)"],
               "toe": j["Time of Applicability(s)"]}
        t = seconds("2020-06-25T12:00:00")
        position = states(self.product, "J02", t, t + 60, 60)["J02", t][0]
        self.assertLess(math.dist(messages.kepler_position(eph, t, 3.986005e14, messages.GALILEO_RATE), position), 5000)

    def test_sem(self):
        lines = pathlib.Path(self.path("sem.txt")).read_text(encoding="ascii").split("\n")
        n, title = lines[0].split()
        week, toa = map(int, lines[1].split())
        self.assertEqual((int(n), title, week), (2, "CURRENT.ALM", 2111 % 1024))
        blocks = re.split(r"\n\n", "\n".join(lines[3:]).strip())
        sent = self.almanacs_sent()
        self.assertEqual([int(b.split()[0]) for b in blocks], [5, 12])
        for block in blocks:
            v = [float(x) for x in block.split()]
            a, pi = sent[int(v[0])], navdata.PI
            for value, told in zip(v[3:12], (a["e"], a["i0"] / pi - 0.30, a["omega_dot"] / pi, a["sqrt_a"], a["omega0"] / pi, a["omega"] / pi, a["m0"] / pi,
                                             a["af0"], a["af1"]), strict=True):
                self.assertAlmostEqual(value, told, delta=1e-11 * max(1.0, abs(told)))
            self.assertEqual((toa, v[12]), (a["toe"], 0))

    def test_bad_asks(self):
        said = run("navfit", self.product, "--rinex", "4", status=2).stderr
        self.assertIn("--rinex", said)
        said = run("navfit", self.product, "--rtcm", self.path("none.rtcm"), "--sat", "G", "--message", "CNAV", status=1).stderr
        self.assertIn("RTCM 3 has messages for none of the sets", said)
        said = run("navfit", self.product, "--sem", self.path("none.sem"), "--sat", "R", status=1).stderr
        self.assertIn("no satellite of GPS has an almanac on that day", said)
        self.assertFalse(pathlib.Path(self.path("none.sem")).exists())


def rinex_records_any(path):
    """RTKLIB's RINEX 3, whose numbers have no digit ahead of the point."""
    text = pathlib.Path(path).read_text(encoding="ascii").split("END OF HEADER")[1].replace("D", "E").splitlines()[1:]
    records, current = collections.defaultdict(list), None
    for line in text:
        if line[0] != " ":
            current = [line[4:23], [float(line[k:k + 19]) for k in range(23, 80, 19)]]
            records[line[:3]].append(current)
        else:
            current[1] += [float(line[k:k + 19]) if line[k:k + 19].strip() else None for k in range(4, len(line), 19)]
    return records


def agree(sat, ours, theirs):
    """All that a message of RTCM holds, to the twelve digits that RTKLIB writes; its own are transmission times (the frames have none) and what
    it fills in: GLONASS' frame time, the week's flags."""
    system = sat[0]
    places = range(14 if system == "R" else 28)
    own = {"G": {27}, "J": {22, 27, 28}, "E": {20, 23, 27}, "C": {23, 27}, "R": {2, 13, 14}}[system]
    for k in places:
        if k in own or k >= len(theirs) or ours[k] is None or theirs[k] is None:
            continue
        if abs(ours[k] - theirs[k]) > 6e-12 * abs(ours[k]) + 1e-18:
            return False
    return True


del Folder
if __name__ == "__main__":
    unittest.main(verbosity=2)
