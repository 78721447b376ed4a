#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`orrery inspect` as a script meets it: keys, types and exit statuses, for sound, damaged and foreign files."""
import gzip
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import zipfile

KEYS = {"kind": str, "version": (str, type(None)), "from": (str, type(None)), "to": (str, type(None)),
        "interval_s": (float, int, type(None)), "systems": list, "satellites": (int, type(None)),
        "epochs": (int, type(None)), "records": (int, type(None)), "gaps": (int, type(None)), "warnings": list}


def main():
    orrery, source = os.environ["ORRERY"], pathlib.Path(__file__).resolve().parents[3]
    golden = source / "tests/golden/ingest"

    def run(*args):
        return subprocess.run([orrery, "inspect", *map(str, args)], capture_output=True, text=True, timeout=60)

    def expect(ok, what):
        if not ok:
            sys.exit(f"inspect: {what}")

    done = run("--format", "json", golden / "c.sp3")
    report = json.loads(done.stdout)
    expect(done.returncode == 0 and done.stderr == "", done.stderr)
    for key, kind in KEYS.items():
        expect(key in report and isinstance(report[key], kind), f"key {key}: {report.get(key, 'not there')}")
    expect((report["kind"], report["version"]) == ("sp3", "c"), "kind and version")
    expect((report["from"], report["to"]) == ("2024-02-04T00:00:00", "2024-02-04T00:30:00"), "span")
    expect((report["satellites"], report["epochs"], report["interval_s"]) == (3, 3, 900), "counts")
    expect((report["systems"], report["gaps"], report["warnings"]) == (["G"], 0, []), "systems, gaps, warnings")

    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        text = (golden / "c.sp3").read_bytes()
        misnamed = folder / "misnamed.Z"  # gzip under another name, and cut: warnings, but read
        misnamed.write_bytes(gzip.compress(text[:-200]))
        done = run("--format", "json", misnamed)
        report = json.loads(done.stdout)
        expect(done.returncode == 0 and len(report["warnings"]) > 0, "a cut file has no warnings")
        expect(all(isinstance(w, str) for w in report["warnings"]), "warnings are no strings")
        done = run(misnamed)
        expect(done.returncode == 0 and "warning" in done.stderr and "SP3" in done.stdout, "human report")
        refused = {"empty": b"", "page.gz": b"<!DOCTYPE html><html>404</html>", "noise": bytes(range(256)) * 9,
                   "cut.gz": gzip.compress(text)[:-20], "letter": b"Dear reader,\nno data here.\n",
                   "esc": b"#dP\x1b[31mred\n"}
        for name, data in refused.items():
            path = folder / name
            path.write_bytes(data)
            done = run("--format", "json", path)
            expect(done.returncode == 1 and done.stdout == "", f"{name}: status {done.returncode}, stdout {done.stdout!r}")
            expect(done.stderr.startswith("orrery inspect: ") and str(path) in done.stderr, f"{name}: {done.stderr!r}")
            expect("\x1b" not in done.stderr, f"{name}: escape sequences reach the terminal")
        expect(run(folder).returncode == 1, "a folder")
        expect(run(folder / "nowhere").returncode == 1, "no such file")
        log = folder / "log.csv"
        log.write_text("t,lat,lon\n" + "".join(f"{k},{k / 7:.3f},,\n" for k in range(50)) + "51,1\n", encoding="utf-8")
        report = json.loads(run("--format", "json", log).stdout)
        expect((report["kind"], report["records"], len(report["warnings"])) == ("table", 51, 1), f"a table: {report}")
        archive = folder / "logs.zip"
        with zipfile.ZipFile(archive, "w") as z:
            z.writestr("a.txt", "1 2 3\n")
            z.writestr("b.txt", "4 5 6\n")
        report = json.loads(run("--format", "json", archive).stdout)
        expect((report["kind"], report["records"]) == ("zip", 2), f"an archive: {report}")
        archive.write_bytes(archive.read_bytes()[:-30])
        expect(run(archive).returncode == 1, "a cut archive")
        done = run(golden / "c.sp3", folder / "empty", golden / "d.sp3")
        expect(done.returncode == 1 and done.stdout.count("SP3 orbits") == 2, "one of three files is refused")
    expect(run().returncode == 2 and run("--nonsense", "x").returncode == 2, "usage error")
    print("inspect: keys, types and exit statuses are as documented")


if __name__ == "__main__":
    main()
