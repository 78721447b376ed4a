# SPDX-License-Identifier: GPL-3.0-or-later
"""cmake --install into a folder: the program runs from there, its libraries build others' programs through pkg-config and
through find_package, manual pages are clean, bash completes from the command table."""
import os
import pathlib
import pty
import re
import select
import signal
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import ORRERY, ROOT, Folder, run, sample  # noqa: E402

BUILD = pathlib.Path(ORRERY).resolve().parent.parent

USER = r"""
#include <stdio.h>

#include "orbit/ephemeris/ephemeris.h"
#include "proto/client.h"

int main(int argc, char **argv)
{
    orr_diag diag = {0};
    orr_ephemeris *e = NULL;
    const orr_sat *list;
    if (argc != 2 || orr_ephemeris_load(argv[1], &e, &diag) != ORR_OK) {
        fprintf(stderr, "%s\n", diag.text);
        return 1;
    }
    printf("%zu satellites\n", orr_ephemeris_satellites(e, &list));
    orr_ephemeris_free(e);
    return 0;
}
"""

CLIENT = r"""
#include <stdio.h>
#include "proto/crc32.h"
int main(void) { printf("%08lx\n", (unsigned long)orr_crc32(0, (const unsigned char *)"123456789", 9)); return 0; }
"""

PROJECT = """
cmake_minimum_required(VERSION 3.25)
project(user LANGUAGES C CXX)
find_package(Orrery 0.1 REQUIRED)
add_executable(user user.c)
target_link_libraries(user PRIVATE Orrery::orbit Orrery::proto)
"""


def call(*args, **kwargs):
    done = subprocess.run([str(a) for a in args], capture_output=True, text=True, timeout=240, check=False, **kwargs)
    if done.returncode != 0:
        raise AssertionError(f"{args}: status {done.returncode}\n{done.stdout}\n{done.stderr}")
    return done.stdout


def commands():
    return [line.split()[0] for line in run("--help").stdout.splitlines()
            if line.startswith("  ") and not line.startswith("   ")]


class Installed(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.prefix = cls.folder / "prefix"
        call("cmake", "--install", BUILD, "--prefix", cls.prefix)
        cls.product = cls.path("day.nc")
        call(cls.prefix / "bin/orrery", "orbit", "-q", "-o", cls.product, sample("ORR0TSTFIN_20250800000_01D_15M_ORB.SP3.gz"))
        cls.user = cls.folder / "user.c"
        cls.user.write_text(USER)

    def found(self, pattern):
        """The one file of that name below the prefix."""
        files = list(self.prefix.rglob(pattern))
        self.assertEqual(len(files), 1, pattern)
        return files[0]

    def test_no_private_header_is_installed(self):
        self.assertTrue(list(self.prefix.rglob("ephemeris.h")))
        self.assertEqual(list(self.prefix.rglob("*_private.h")), [])

    def test_pkg_config(self):
        env = dict(os.environ, PKG_CONFIG_PATH=str(self.found("orrery.pc").parent))
        flags = call("pkg-config", "--cflags", "--libs", "orrery", "orrery-client", env=env).split()
        call("cc", "-std=c17", self.user, "-o", self.folder / "by-pkg-config", *flags)
        self.assertEqual(call(self.folder / "by-pkg-config", self.product), "80 satellites\n")

    def test_client_needs_libc_alone(self):
        env = dict(os.environ, PKG_CONFIG_PATH=str(self.found("orrery-client.pc").parent))
        flags = call("pkg-config", "--cflags", "--libs", "orrery-client", env=env).split()
        (self.folder / "client.c").write_text(CLIENT)
        call("cc", "-std=c17", self.folder / "client.c", "-o", self.folder / "client", *flags)
        self.assertEqual(call(self.folder / "client"), "cbf43926\n")

    def test_find_package(self):
        project = self.folder / "project"
        project.mkdir()
        (project / "CMakeLists.txt").write_text(PROJECT)
        (project / "user.c").write_text(USER)
        call("cmake", "-S", project, "-B", project / "build", "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        call("cmake", "--build", project / "build")
        self.assertEqual(call(project / "build/user", self.product), "80 satellites\n")

    def test_python_client_and_dissector(self):
        package = self.prefix / "share/orrery/python"
        done = subprocess.run([sys.executable, "-B", "-c", "import orrery; print(orrery.__file__)"], capture_output=True, text=True,
                              check=True, env=dict(os.environ, PYTHONPATH=str(package)))
        self.assertEqual(done.stdout.strip(), str(package / "orrery/__init__.py"))
        self.assertTrue((package / "orrery/py.typed").exists())
        self.assertTrue((self.prefix / "share/orrery/wireshark/orrery.lua").exists())

    def test_manual_pages(self):
        pages = sorted(p.name for p in (self.prefix / "share/man/man1").iterdir())
        self.assertEqual(pages, sorted(["orrery.1"] + [f"orrery-{name}.1" for name in commands()]))
        for name in pages:
            with self.subTest(page=name):
                done = subprocess.run(["groff", "-man", "-ww", "-K", "utf8", "-T", "utf8", self.prefix / "share/man/man1" / name],
                                      capture_output=True, text=True, timeout=60, check=False)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertIn("NAME", re.sub(".\b", "", done.stdout))  # bold is overstruck
        text = (self.prefix / "share/man/man1/orrery-orbit.1").read_text()
        self.assertIn(r"\fB\-\-output\fR \fIFILE\fR", text)

    def complete(self, *words):
        """What bash offers for the last word."""
        script = ('source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); '
                  'function=$(complete -p orrery | sed "s/.*-F \\([^ ]*\\).*/\\1/"); $function; printf "%s\\n" "${COMPREPLY[@]}"')
        file = self.prefix / "share/bash-completion/completions/orrery"
        return call("bash", "-c", script, "bash", file, "orrery", *words, cwd=self.folder).split()

    def test_bash_completion(self):
        self.assertEqual(self.complete("ecl"), ["eclipses"])
        self.assertLessEqual(set(commands()), set(self.complete("")))
        self.assertEqual(self.complete("help", "gravi"), ["gravimetry"])
        self.assertEqual(self.complete("states", "--form"), ["--format"])
        self.assertEqual(sorted(self.complete("states", "x.nc", "--format", "")), ["clk", "csv", "json", "netcdf", "oem", "orbex", "sp3"])
        self.assertEqual(self.complete("states", "day"), ["day.nc"])
        self.assertEqual(self.complete("states", "-o", "user"), ["user.c"])
        self.assertEqual(self.complete("states", "--from", "2"), [])
        self.assertIn("--quiet", self.complete("orbit", "--"))

    def zsh(self, keys, wanted):
        """What an interactive zsh shows after these keys, as soon as `wanted` is in it."""
        child, fd = pty.fork()
        if child == 0:
            os.environ.update(TERM="dumb", LC_ALL="C")
            os.chdir(self.folder)
            os.execvp("zsh", ["zsh", "-f", "-i"])

        def until(pattern):
            shown, end = "", time.monotonic() + 60
            while time.monotonic() < end:
                if select.select([fd], [], [], 0.2)[0]:
                    shown += os.read(fd, 4096).decode(errors="replace")
                    if re.search(pattern, shown, re.S):
                        return shown
            return shown

        try:
            os.write(fd, f"fpath=({self.prefix}/share/zsh/site-functions $fpath); autoload -Uz compinit && compinit -u -D; "
                         "echo re''ady\n".encode())
            self.assertIn("ready\r", until("ready\r"))
            os.write(fd, keys.encode())
            return until(wanted)
        finally:
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
            os.close(fd)

    def test_zsh_completion(self):
        for keys, wanted in (("orrery ecl\t", "orrery eclipses"), ("orrery states x.nc --form\t", "--format"),
                             ("orrery states x.nc --format \t\t", "clk +csv +json +netcdf +oem +orbex +sp3"), ("orrery help gravi\t", "help gravimetry"),
                             ("orrery states da\t", "states day.nc")):
            with self.subTest(keys=keys):
                self.assertRegex(self.zsh(keys, wanted), wanted)

    def test_version(self):
        lines = run("--version", "--verbose").stdout.splitlines()
        self.assertEqual([line.split()[0] for line in lines], ["orrery", "built", "compiler", "libraries"])
        in_git = (ROOT / ".git").exists()
        self.assertRegex(lines[1], r"^built from commit [0-9a-f]{12}(-dirty)?$" if in_git else r"^built from release \d")
        self.assertRegex(lines[3], r"GSL \d.*NetCDF \d")
        self.assertEqual(run("--version", "-v").stdout.splitlines(), lines)
        self.assertIn("--verbose", run("--version", "--json", status=2).stderr)

    def test_benchmarks_without_tests(self):
        """./demo configures without tests; the target bench is there all the same."""
        build = self.folder / "without-tests"
        call("cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DORR_TESTS=OFF")
        call("ninja", "-C", build, "-n", "bench")


if __name__ == "__main__":
    unittest.main()
