# SPDX-License-Identifier: GPL-3.0-or-later
"""The gravimetry flight of samples/: signals to files, RTKLIB's kinematic track from the files, and from track and readings the
anomalies that were put in."""
import csv
import math
import pathlib
import re
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import ROOT, Folder, run, run_json  # noqa: E402

RTK = {"pos1-posmode": "kinematic", "pos1-frequency": "l1+2", "pos1-elmask": "7", "pos1-ionoopt": "off", "pos1-tropopt": "saas",
       "pos1-sateph": "precise", "pos1-navsys": "5", "pos2-armode": "continuous", "pos2-gloarmode": "off",
       "ant2-postype": "rinexhead", "out-solformat": "xyz", "out-outhead": "off", "out-timesys": "gpst"}
SIGMA_S = 27  # a Gaussian of 160 s from -3 to +3 sigma


class Flight(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        text = (ROOT / "samples/gravimetry-flight.yaml").read_text(encoding="ascii")
        for name in re.findall(r"ORR0TST\S+|ionosphere\.ION", text):
            text = text.replace(name, str(ROOT / "samples" / name))
        # The frequencies and antennas that RTKLIB needs here; the rest of the sample would only cost time.
        text = re.sub(r"^signals: .*$", "signals: ['G:L1P', 'G:L2P', 'R:L1OF', 'R:L2OF']", text, flags=re.M)
        text = re.sub(r"^  - \{name: BAS2.*\n", "", text, flags=re.M)
        pathlib.Path(cls.path("flight.yaml")).write_text(text, encoding="ascii")
        run("simulate", cls.path("flight.yaml"), "-o", cls.path("flight"))
        cls.files = cls.folder / "flight"
        (cls.files / "conf").write_text("".join(f"{k} ={v}\n" for k, v in RTK.items()), encoding="ascii")
        subprocess.run(["rnx2rtkp", "-k", "conf", "-o", "out.pos", "ROVE.rnx", "BASE.rnx", "broadcast.rnx", "truth.sp3", "truth.clk"],
                       cwd=cls.files, check=True, capture_output=True, timeout=200)
        cls.arm = re.search(r"name: ROVE, right: ([\d.]+), forward: ([\d.]+), up: ([\d.]+)", text).groups()

    def test_track_and_readings_return_the_anomalies(self):
        rows = [line.split() for line in (self.files / "out.pos").read_text(encoding="ascii").splitlines() if line[0] != "%"]
        self.assertGreater(len(rows), 3500)
        with open(self.path("rtk.csv"), "w", encoding="ascii") as f:
            f.write("# columns: t[gps],x[m],y[m],z[m]\n")
            for r in rows:
                f.write(f"{r[0].replace('/', '-')}T{r[1]},{r[2]},{r[3]},{r[4]}\n")
        recovered = run_json("gravimetry", self.files / "imu-0.nc", "--track", self.path("rtk.csv"), "--arm", ",".join(self.arm),
                             "--filter", SIGMA_S, "--format", "json")
        rms = recovered["difference"]["filtered_rms_mgal"]
        print(f"anomalies of {recovered['true']['min_mgal']:.0f} to {recovered['true']['max_mgal']:.0f} mGal returned to "
              f"{rms:.3f} mGal RMS by RTKLIB's track")
        self.assertLess(rms, 0.5)
        self.assertGreater(rms, 1e-4)  # it is the receiver's track that was used, not the truth

    def test_the_true_track_returns_them_better(self):
        with open(self.files / "ROVE-track.csv", encoding="ascii", newline="") as f, open(self.path("true.csv"), "w", encoding="ascii") as to:
            to.write("# columns: t[gps],x[m],y[m],z[m]\n")
            for r in csv.DictReader(f):
                to.write(f"{r['t_gps']},{r['x_m']},{r['y_m']},{r['z_m']}\n")
        args = ("--track", self.path("true.csv"), "--filter", SIGMA_S, "--format", "json")
        arm = run_json("gravimetry", self.files / "imu-0.nc", *args, "--arm", ",".join(self.arm))["difference"]["filtered_rms_mgal"]
        # What is left is the turbulence between samples of 1 Hz.
        self.assertLess(arm, 0.05)
        none = run_json("gravimetry", self.files / "imu-0.nc", *args)["difference"]["filtered_rms_mgal"]
        self.assertGreater(none, arm)
        self.assertTrue(math.isfinite(none))

    def test_what_is_no_track_is_refused(self):
        for text, word in (("# columns: t[s],x[m],y[m],z[m]\n" + "1,2.7e6,2.3e6,5.3e6\n" * 9, "instants"),
                           ("# columns: t[gps],x[m],y[m],z[m]\n2025-03-21T10:00:00,2739765,2298933,5265121\n", "places within")):
            pathlib.Path(self.path("bad.csv")).write_text(text, encoding="ascii")
            self.assertIn(word, run("gravimetry", self.files / "imu-0.nc", "--track", self.path("bad.csv"), status=1).stderr)
        run("gravimetry", self.files / "imu-0.nc", "--track", self.path("true.csv"), "--arm", "1,2", status=2)
        run("gravimetry", self.files / "imu-0.nc", "--arm", "1,2,3", status=2)


if __name__ == "__main__":
    unittest.main()
