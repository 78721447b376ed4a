# SPDX-License-Identifier: GPL-3.0-or-later
"""Calling the program from tests: where it is, where samples and real data are, and a folder to work in."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
ORRERY = os.environ.get("ORRERY", str(ROOT / "build/dev/bin/orrery"))
DATA = pathlib.Path(os.environ.get("ORRERY_DATA") or ROOT / "../shared/data")


def sample(name):
    return str(ROOT / "samples" / name)


def data(name):
    """A real file; the test is skipped, and says so, where the data are not."""
    path = DATA / name
    if not path.exists():
        raise unittest.SkipTest(f"{name} is not here (set ORRERY_DATA)")
    return str(path)


def run(*args, status=0, timeout=240, **kwargs):
    """Runs orrery; the exit status must be as told, or the test fails with what the program said."""
    done = subprocess.run([ORRERY, *map(str, args)], capture_output=True, text=True, timeout=timeout, check=False, **kwargs)
    if done.returncode != status:
        raise AssertionError(f"orrery {' '.join(map(str, args))}: status {done.returncode}, not {status}\n{done.stderr}")
    return done


def run_json(*args, **kwargs):
    return json.loads(run(*args, **kwargs).stdout)


def dump(path):
    """Variables and numeric global attributes of a NetCDF file as nested lists, through ncdump."""
    text = subprocess.run(["ncdump", "-p", "9,17", path], capture_output=True, text=True, check=True).stdout
    head, body = text.split("\ndata:\n")
    dims = {k: int(v) for k, v in re.findall(r"^\t(\w+) = (\d+) ;", head, re.M)}
    shapes = {k: [dims[d.strip()] for d in v.split(",")] for k, v in re.findall(r"^\t\w+ (\w+)\(([^)]*)\) ;", head, re.M)}
    out = {k: float(v) for k, v in re.findall(r"^\t\t:(\w+) = (-?[\d.e+-]+)L* ;", head, re.M)}
    for name, values in re.findall(r"^ (\w+) =(.*?) ;$", body, re.M | re.S):
        if '"' in values:
            out[name] = re.findall(r'"([^"]*)"', values)
            continue
        items = [v.strip() for v in values.split(",")]
        flat = [float(v) if re.search(r"[.enN]", v) else int(v) for v in items]
        for n in reversed(shapes[name][1:]):
            flat = [flat[i:i + n] for i in range(0, len(flat), n)]
        out[name] = flat
    return out


class Folder(unittest.TestCase):
    """A test case with a folder of its own, `self.path(name)`, removed afterwards."""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="orrery-test-"))

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    @classmethod
    def path(cls, name):
        return str(cls.folder / name)

    def left(self):
        """Names of what is in the folder."""
        return sorted(p.name for p in self.folder.iterdir())


def ultra(text, observed_until):
    """An SP3 of which what is later than HH:MM is flagged as a prediction: orbit in column 80, clock in column 76."""
    out, later = [], False
    for line in text.splitlines():
        if line.startswith("*"):
            later = later or f"{int(line[14:16]):02}:{int(line[17:19]):02}" > observed_until
        if line.startswith("P") and later:
            line = f"{line[:75]:75}P   P"
        out.append(line)
    return "\n".join(out) + "\n"
