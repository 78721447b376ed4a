# SPDX-License-Identifier: GPL-3.0-or-later
"""`orrery orbit --gravity-model`: a low orbit in a field of the user's, from files in GeographicLib's format made here."""
import pathlib
import struct
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import Folder, data, run, run_json  # noqa: E402

STELLA = "odd/sp3/nsgf.orb.stella.v00.sp3.gz"
EGM96 = "gravity/egm96-21x21.txt"
HOURS = ("--exclude", "2023-12-08T06:00/2024-01-01")


def coefficients(path):
    c, s = {}, {}
    for line in pathlib.Path(path).read_text(encoding="ascii").splitlines():
        n, m, x, y = line.split()[:4]
        c[int(n), int(m)], s[int(n), int(m)] = float(x), float(y)
    return c, s


def write_model(folder, name, c, s, degree):
    """Metadata, and columns by order: cosines, then sines without those of order 0."""
    (folder / f"{name}.egm").write_text(
        "EGMF-1\nName orrtest\nPublisher test\nReleaseDate 2024-01-01\nDataVersion 1\nModelRadius 6378136.3\n"
        "ModelMass 3986004.415e8\nAngularVelocity 7.292115e-5\nReferenceRadius 6378137\n"
        "ReferenceMass 3.986004418e14\nFlattening 1/298.257223563\nHeightOffset 0\n"
        "CorrectionMultiplier 1\nNormalization full\nID ORRTEST1\n", encoding="ascii")
    out = b"ORRTEST1" + struct.pack("<ii", degree, degree)
    for m in range(degree + 1):
        for n in range(m, degree + 1):
            out += struct.pack("<d", 0 if n == 0 else c.get((n, m), 0.0))
    for m in range(1, degree + 1):
        for n in range(m, degree + 1):
            out += struct.pack("<d", s.get((n, m), 0.0))
    (folder / f"{name}.egm.cof").write_bytes(out + struct.pack("<ii", -1, -1))


class GravityModel(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.sp3 = data(STELLA)
        c, s = coefficients(data(EGM96))
        write_model(cls.folder, "same", c, s, 21)
        write_model(cls.folder, "poor", c, s, 12)
        cls.built_in = cls.orbit("built-in")

    @classmethod
    def orbit(cls, name, *more):
        """Root mean square of the distance from positions that were left out, mm, and positions every half hour."""
        product = cls.path(f"{name}.nc")
        run("orbit", "-q", "-o", product, "--nodes", "360", *HOURS, *more, cls.sp3)
        places = run_json("compare", "--format", "json", product, cls.sp3)["systems"]["L"]
        rows = run("states", product, "--step", "1800").stdout.splitlines()[1:]
        return places["inner"]["rms_mm"], [[float(x) for x in r.split(",")[2:5]] for r in rows]

    def model(self, name, *more):
        return self.orbit(name, "--gravity-model", name, "--gravity-folder", str(self.folder), *more)

    def test_the_same_field_gives_the_same_orbit(self):
        rms, states = self.model("same")
        self.assertAlmostEqual(rms, self.built_in[0], delta=1e-2)
        self.assertLess(rms, 60)
        self.assertGreater(len(states), 10)
        for a, b in zip(states, self.built_in[1], strict=True):
            for x, y in zip(a, b, strict=True):
                self.assertAlmostEqual(x, y, delta=1e-5)

    def test_a_poorer_field_is_felt(self):
        self.assertGreater(self.model("poor")[0], 2 * self.built_in[0])
        self.assertGreater(self.model("same", "--gravity", "8")[0], 2 * self.built_in[0])

    def test_what_is_not_there_is_told(self):
        out = self.path("none.nc")
        missing = run("orbit", "-o", out, "--gravity-model", "nowhere", "--gravity-folder", str(self.folder), self.sp3,
                      status=1)
        self.assertIn("nowhere", missing.stderr)
        beyond = run("orbit", "-o", out, "--gravity", "60", self.sp3, status=2)
        self.assertIn("--gravity-model", beyond.stderr)
        self.assertFalse(pathlib.Path(out).exists())


if __name__ == "__main__":
    unittest.main()
