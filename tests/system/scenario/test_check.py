# SPDX-License-Identifier: GPL-3.0-or-later
"""`orrery check` and `orrery simulate`: what they say of a scenario, and that what cannot be is refused with a sentence."""
import csv
import datetime
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import Folder, data, run, sample  # noqa: E402

FIXED = "antennas: [{name: A, position: [52, 17, 124]}]\n"


class Check(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.orbit = cls.path("day.nc")
        run("orbit", "-q", "-o", cls.orbit, "--sat", "G01-G09,R01-R06", sample("ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"))

    def scenario(self, text, navdata="navdata: {window: none}\n"):
        path = pathlib.Path(self.path("scenario.yaml"))
        path.write_text(f"title: A test\norbit: {{product: {self.orbit}}}\n{navdata}{text}", encoding="ascii")
        return path

    def test_it_tells_signals_and_views(self):
        out = run("check", self.scenario("signals: [G, 'R:L1OF']\n" + FIXED)).stdout
        self.assertIn("A test", out)
        self.assertRegex(out, r"G:L1CA +1575\.420 +1\.023e\+06 +BPSK\(1\) +C/A +1C")
        self.assertIn("R:L1OF", out)
        self.assertNotIn("R:L2OF", out)
        self.assertRegex(out, r"antenna 0, A, fixed: satellites in view")

    def test_a_scenario_without_signals_is_checked_too(self):
        self.assertIn("none: no signals are named", run("check", self.scenario("")).stdout)

    def refused(self, text, *words, command="check", options=()):
        err = run(command, self.scenario(text), *options, status=1).stderr
        for word in words:
            self.assertIn(word, err)

    def test_what_cannot_be_is_refused(self):
        self.refused("signals: ['G:L9']\n" + FIXED, "signals", "no signal 'G:L9'", "G:L1CA")
        self.refused("signals: [C]\n" + FIXED, "none of the scenario's satellites sends")
        self.refused("signals: [G]\n", "nothing receives them")
        self.refused("signals: [G]\nantennas: [{name: A}]\n", "antennas", "no trajectory")
        self.refused("signals: [G]\nantennas: [{position: [52, 17]}]\n", "scenario.yaml:5", "position")
        self.refused("signals: [G]\nantennas: [{position: [152, 17, 0]}]\n", "no place")
        self.refused("signals: [G]\nantennas: [{position: [52, 17, -900]}]\n", "scenario.yaml:5", "below ground")
        self.refused("signals: [G]\nantennas: [{name: a/b, position: [52, 17, 0]}]\n", "scenario.yaml:5", "no name for files")
        self.refused("signals: [G]\nantennas: [{name: A, position: [52, 17, 0]}, {name: A, position: [51, 17, 0]}]\n",
                     "both called 'A'")
        self.refused("signals: [G]\nantennas: [{up: 1}]\ntrajectory: {kind: survey, start: 2024-03-21T10:00:00, duration: 600, "
                     "lat: 52, lon: 17, height: 500}\n", "no time in common", "2024-03-21T10:00:00", "2025-03-2")
        self.assertIn("none of these satellites",
                      run("check", self.scenario("signals: [G]\nsatellites: {unhealthy: G40}\n" + FIXED)).stderr)
        self.refused("signals: [G]\nantennas: [{position: [52, 17, 0], type: X}]\n", "ANTEX")
        self.refused("signals: [G]\nmask: {elevation: 90}\n" + FIXED, "no antenna ever sees")
        self.refused("signals: [G]\nmask: {body: 5}\n" + FIXED, "nothing moves")
        self.refused("signals: [G]\nmask: {horizon: [{azimuth: 9, elevation: 0}, {azimuth: 9, elevation: 1}]}\n" + FIXED, "azimuth")
        self.refused("troposphere: {model: do229}\n", "troposphere", "signals")
        self.refused("signals: [G]\ntroposphere: {model: do229, humidity: 0.5}\n" + FIXED, "humidity")
        self.refused("signals: [G]\nantennas: [{position: [1, 2, 3], right: 1}]\n", "right")
        self.refused("signals: [G]\n" + FIXED, "the scenario's channels reach from", command="simulate",
                     options=("-o", self.path("run"), "--from", "2025-03-20T00:00:00"))
        self.refused("", "no signals", command="simulate", options=("-o", self.path("run")))

    def test_errors_name_line_and_key(self):
        """What the engine finds is told where the scenario says it: file, line, column, key."""
        day = "scenario.yaml:"
        self.refused("signals: [C]\n" + FIXED, day + "4:10: signals: none of the scenario's satellites")
        self.refused("signals: [G]\n", day + "4:10: signals: they are sent, but nothing receives them")
        self.refused("signals: [G]\nantennas:\n  - {name: B, position: [52, 17, 0]}\n  - {position: [52, 17, 0], type: X}\n",
                     day + "7:35: antennas[1].type: 'X' needs an ANTEX file")
        self.refused("signals: [G]\nmask: {elevation: 90}\n" + FIXED, day + "5:7: mask: no antenna ever sees")
        self.refused("signals: [G]\nantennas: [{position: [52, 17, -900]}]\n", day + "5:13: antennas[0].position: a height of -900 m")
        self.refused("signals: [G]\nchannel: {antex: nowhere.atx}\n" + FIXED, day + "5:18: channel.antex: ", "nowhere.atx: cannot open")
        self.refused("trajectory: {kind: analytic, start: 2024-01-01, duration: 60, lat: 50, lon: 20}\nsignals: [G]\n",
                     day + "5:10: signals: the scenario's parts have no time in common", "trajectory 2024-01-01T00:00:00")
        self.refused("ionosphere: {field: maps.inx}\n", day + "4:21: ionosphere.field: ", "maps.inx: cannot open")

    def nav(self, name, text):
        path = pathlib.Path(self.path(name))
        path.write_text(text, encoding="ascii")
        return path

    def test_orbits_of_records_and_of_a_longitude(self):
        """NavIC by RINEX records and SBAS by a longitude beside a product of others: served, or else told with its line."""
        sbas = f"{'     3.05           N: GNSS NAV DATA    S: SBAS':<60}RINEX VERSION / TYPE\n{'':<60}END OF HEADER\n"
        for minute in range(0, 1440, 2):
            sbas += f"S28 2025 03 21 {minute // 60:02d} {minute % 60:02d} 00" + "".join(f"{x:19.12E}" for x in (0, 0, minute * 60 + 432000)) + "\n"
            for row in ((5098.0, 0, 0, 0), (41854.8, 0, 0, 0), (0, 0, 0, 1)):
                sbas += "    " + "".join(f"{x:19.12E}" for x in row) + "\n"
        records = self.nav("sbas.rnx", sbas)
        path = pathlib.Path(self.path("scenario.yaml"))
        whole = (f"orbit:\n  product: {self.orbit}\n  nav: [{records}]\n  geo:\n    - {{sat: S23, longitude: 5}}\nnavdata: {{window: none}}\n"
                 "signals: [G, S]\n" + FIXED)
        path.write_text(whole, encoding="ascii")
        out = run("check", path).stdout
        self.assertIn("S:L1CA", out)
        run("simulate", path, "-q", "-o", self.path("geo"), "--from", "2025-03-21T12:00", "--to", "2025-03-21T12:00:01")
        rows = list(csv.DictReader(pathlib.Path(self.path("geo/A-channels.csv")).read_text(encoding="ascii").splitlines()))
        seen = {r["sat"] for r in rows}
        self.assertLessEqual({"S23", "S28", "G01"} & seen, seen)
        self.assertIn("S23", seen)  # at 5 E over a station at 17 E
        for text, words in ((whole.replace("sat: S23", "sat: G23"), "scenario.yaml:5:8: orbit.geo[0].sat: 'G23' is no SBAS satellite"),
                            (whole.replace("longitude: 5", "longitude: 500"), "scenario.yaml:5:29: orbit.geo[0].longitude: 500 is outside"),
                            (whole.replace(f"[{records}]", "[no.rnx]"), "scenario.yaml:3:9: orbit.nav[0]: "),
                            (whole.replace(f"  product: {self.orbit}\n  nav: [{records}]\n", ""), "scenario.yaml:2:"),
                            (whole.replace(f"[{records}]", f"[{self.orbit}]"), "day.nc")):
            path.write_text(text, encoding="ascii")
            self.assertIn(words, run("check", path, status=1).stderr)

    def test_powers_of_the_satellite_metadata(self):
        """Twice the transmit power is 3.01 dB more; the mean of a block (here: no file names blocks) keeps the signal's nominal power."""
        prns = "+SATELLITE/PRN\n G063 2011:197:00000 0000:000:00000 G01\n G061 2004:311:00000 0000:000:00000 G02\n-SATELLITE/PRN\n"
        powers_w = ("+SATELLITE/TX_POWER\n G063 2011:197:00000 0000:000:00000 200\n G061 2004:311:00000 0000:000:00000 100\n"
                    "-SATELLITE/TX_POWER\n%ENDSNX\n")
        meta = self.nav("meta.snx", "%=SNX 2.02\n" + prns + powers_w)
        base = "signals: ['G:L1CA']\nmask: {elevation: -10}\n"
        powers = []
        for satellites in ("satellites: {use: 'G01-G09'}\n", f"satellites: {{use: 'G01-G09', metadata: {meta}}}\n"):
            power = {}
            for hour in (2, 8, 14, 20):
                path = self.scenario(base + satellites + FIXED)
                out = self.path("power")
                done = run("simulate", path, "-o", out, "--from", f"2025-03-21T{hour:02d}:00", "--to", f"2025-03-21T{hour:02d}:00:01", "--force")
                for row in csv.DictReader(pathlib.Path(out, "A-channels.csv").read_text(encoding="ascii").splitlines()):
                    power[row["t_gps"], row["sat"]] = float(row["power_dbw"])
            powers.append(power)
        self.assertIn("satellites.metadata tells no transmit power of", done.stderr)
        change = {}
        for key, value in powers[0].items():
            change.setdefault(key[1], set()).add(round(powers[1][key] - value, 2))
        self.assertEqual(change.pop("G01"), {1.25})  # 200 W against the mean of 150 W
        self.assertEqual(change.pop("G02"), {-1.76})
        self.assertEqual(set().union(*change.values()), {0.0})
        # Where it names blocks, each is a mean of its own, and sends what the block sends: a IIF has L5, a IIR has not.
        blocks = "+SATELLITE/IDENTIFIER\n G063 2011-036A  37753 GPS-IIF         made\n G061 2004-045A  28474 GPS-IIR-B       made\n-SATELLITE/IDENTIFIER\n"
        meta = self.nav("blocks.snx", "%=SNX 2.02\n" + blocks + prns + powers_w)
        path = self.scenario(f"signals: ['G:L1CA', 'G:L5']\nmask: {{elevation: -10}}\nsatellites: {{use: 'G01,G02', metadata: {meta}}}\n" + FIXED)
        sent = set()
        for hour in (2, 8, 14, 20):
            run("simulate", path, "-o", out, "--from", f"2025-03-21T{hour:02d}:00", "--to", f"2025-03-21T{hour:02d}:00:01", "--force")
            rows = csv.DictReader(pathlib.Path(out, "A-channels.csv").read_text(encoding="ascii").splitlines())
            for row in rows:
                sent.add((row["sat"], row["signal"]))
                if row["signal"] == "L1CA":  # alone of their blocks: nominal, whatever they transmit
                    self.assertAlmostEqual(float(row["power_dbw"]), powers[0].get((row["t_gps"], row["sat"]), 0), places=2)
        self.assertEqual(sent, {("G01", "L1CA"), ("G01", "L5"), ("G02", "L1CA")})
        self.refused("signals: [G]\nsatellites: {metadata: none.snx}\n" + FIXED, "scenario.yaml:5:24: satellites.metadata: ", "none.snx")
        other = sample("ORR0TSTFIN_20250800000_01D_05M_ORB.SP3.gz")
        self.refused(f"signals: [G]\nsatellites: {{metadata: {other}}}\n" + FIXED, "scenario.yaml:5:24: satellites.metadata")

    def test_the_table_of_channels_sums_up(self):
        path = self.scenario("signals: [G, R]\ntroposphere: {model: stanag4294}\n" + FIXED)
        run("simulate", path, "-o", self.path("sum"), "--from", "2025-03-21T03:00:00", "--to", "2025-03-21T03:01:00",
            "--truth-step", "30s")
        text = pathlib.Path(self.path("sum/A-channels.csv")).read_text(encoding="ascii")
        rows = list(csv.DictReader(text.splitlines()))
        terms = [k for k in rows[0] if k.endswith("_m") and k not in ("code_m", "wind_up_m", "phase_bias_m")]
        for row in rows:
            # Each term is printed to 1e-9 m; the sum of doubles at 2e7 m holds 4e-9.
            self.assertAlmostEqual(float(row["code_m"]), sum(float(row[k]) for k in terms), delta=2.5e-8)

class Delays(Folder):
    """Real orbits, clocks and biases: what the message tells of a satellite's clock is what the channel has."""

    def test_message_and_channel_have_one_clock(self):
        orbit = self.path("day.nc")
        run("orbit", "-q", "-o", orbit, "--sat", "G01-G12", data("2024-035/COD0OPSFIN_20240350000_01D_05M_ORB.SP3.gz"))
        bias = data("2024-035/COD0OPSFIN_20240350000_01D_01D_OSB.BIA.gz")
        path = pathlib.Path(self.path("scenario.yaml"))
        path.write_text(f"orbit: {{product: {orbit}}}\nnavdata: {{bias: {bias}}}\nsignals: ['G:L1P', 'G:L2P']\n{FIXED}", encoding="ascii")
        run("simulate", path, "-o", self.path("run"), "--from", "2024-02-04T10:00:00", "--to", "2024-02-04T14:00:00", "--step", "30min",
            "--truth-step", "30min", "--no-imu")
        sets = {}
        text = pathlib.Path(self.path("run/broadcast.rnx")).read_text(encoding="ascii").splitlines()
        for i, line in enumerate(text):
            if line[:1] == "G" and line[1:3].isdigit() and line[3:8] == " 2024":
                field = [float(text[i + k][4 + 19 * j:23 + 19 * j].replace("D", "E")) for k, j in ((6, 2),)]
                toc = datetime.datetime(*map(int, line[4:23].split()))
                sets.setdefault(line[:3], []).append((toc, float(line[23:42].replace("D", "E")), float(line[42:61].replace("D", "E")), field[0]))
        worst, seen = 0.0, 0
        for row in csv.DictReader(pathlib.Path(self.path("run/A-channels.csv")).read_text(encoding="ascii").splitlines()):
            t = datetime.datetime.fromisoformat(row["t_gps"])
            toc, af0, af1, tgd = min(sets[row["sat"]], key=lambda x: abs(x[0] - t))
            factor = 1 if row["signal"] == "L1P" else (1575.42 / 1227.60) ** 2
            told = af0 + af1 * (t - toc).total_seconds() - factor * tgd
            played = -(float(row["satellite_clock_m"]) + float(row["group_delay_m"])) / 299792458.0
            worst, seen = max(worst, abs(told - played)), seen + 1
        self.assertGreater(seen, 40)
        print(f"{seen} channels: message and channel differ by {1e9 * worst:.2f} ns at most")
        # Half an LSB of af0 and of TGD (0.23 ns each, on L2 0.38), and what the clock is off a straight line (0.2 ns).
        self.assertLess(worst, 0.9e-9)


if __name__ == "__main__":
    unittest.main()
