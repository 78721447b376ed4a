# SPDX-License-Identifier: GPL-3.0-or-later
"""What README and docs tell a reader to type works as it stands there.

Fenced blocks marked `sh` run, page by page and in order, from a folder that looks like the checkout's root; `sh network` is not
run, and `sh long`, which takes long, with ORRERY_LONG alone. Every `ctest -R` names tests that exist, and every option of an `orrery` command that a page names is one of that command's.
"""
import os
import pathlib
import re
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from program import DATA, ORRERY, ROOT, Folder  # noqa: E402

PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]
BLOCK = re.compile(r"^```sh *(\w*)\n(.*?)^```$", re.M | re.S)


def spans(text):
    """Code of a page: fenced and indented lines, with continued lines joined, and what stands between backticks."""
    text = text.replace("\\\n", " ")
    yield from re.findall(r"^    (.*)$", text, re.M)
    for _, block in re.findall(r"^```(\w*)[^\n]*\n(.*?)^```$", text, re.M | re.S):
        yield from block.splitlines()
    yield from re.findall(r"`([^`\n]+)`", re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S))


class Documentation(Folder):
    def page_runs(self, page, script):
        folder = pathlib.Path(self.path(page.stem)) / "checkout"
        folder.mkdir(parents=True)
        for entry in ROOT.iterdir():
            if entry.name not in (".git", "build"):
                (folder / entry.name).symlink_to(entry)
        env = dict(os.environ, PATH=f"{pathlib.Path(ORRERY).parent}:{os.environ['PATH']}", ORRERY_DATA=str(DATA))
        done = subprocess.run(["bash", "-euo", "pipefail", "-c", script], cwd=folder, env=env, capture_output=True, text=True,
                              timeout=500, check=False, stdin=subprocess.DEVNULL)
        self.assertEqual(done.returncode, 0, f"{page.name}:\n{script}\n{done.stdout[-1500:]}\n{done.stderr[-1500:]}")

    def test_blocks_run(self):
        ran = 0
        for page in PAGES:
            left_out = ("network",) if os.environ.get("ORRERY_LONG") else ("network", "long")
            blocks = [body for how, body in BLOCK.findall(page.read_text(encoding="utf-8")) if how not in left_out]
            script = "\n".join(blocks)
            if "ORRERY_DATA" in script and not (DATA / "2024-035").is_dir():
                continue
            with self.subTest(page=page.name):
                if blocks:
                    self.page_runs(page, script)
                    ran += 1
        self.assertGreater(ran, 0)

    def names(self):
        """Of all tests of this build."""
        build = os.environ.get("ORRERY_BUILD", str(ROOT / "build/dev"))
        listed = subprocess.run(["ctest", "--test-dir", build, "-N"], capture_output=True, text=True, check=True).stdout
        names = re.findall(r"Test +#\d+: (\S+)", listed)
        self.assertTrue(names)
        return names

    def test_capabilities_have_tests(self):
        """README's table: every row names tests, and they exist."""
        names = self.names()
        table = re.search(r"^\| capability \|.*\n\|[-|]+\|\n((?:\|.*\n)+)", (ROOT / "README.md").read_text(encoding="utf-8"), re.M)
        rows = table.group(1).splitlines()
        self.assertGreater(len(rows), 15)
        for row in rows:
            capability, against, how = (cell.strip() for cell in row.strip("|").split("|"))
            with self.subTest(capability=capability):
                self.assertTrue(capability and against)
                patterns = re.findall(r"`([^`]+)`", how)
                self.assertTrue(patterns, "no test is named")
                for pattern in patterns:
                    self.assertTrue(any(re.search(pattern, n) for n in names), f"{pattern} names no test")

    def test_named_tests_exist(self):
        names = self.names()
        for page in PAGES:
            for code in spans(page.read_text(encoding="utf-8")):
                for call in re.findall(r"\bctest\b[^;&|]*?-R +('[^']*'|\S+)", code):
                    pattern = call.strip("'\"")
                    with self.subTest(page=page.name, call=code):
                        self.assertIn("--preset", code)
                        self.assertTrue(any(re.search(pattern, n) for n in names), f"{pattern} names no test")

    def test_quoted_lines_are_there(self):
        """Indented lines under a line of `FILE`, `FUNCTION`: stand in that function, in that order."""
        quoted = 0
        for page in PAGES:
            text = page.read_text(encoding="utf-8")
            for path, function, block in re.findall(r"^ *`(src/[\w/.]+)`, `(\w+)`:\n\n((?:        .*\n)+)", text, re.M):
                source = (ROOT / path).read_text(encoding="utf-8")
                body = re.search(rf"^[a-z][^\n;]*\b{function}\([^;{{]*\)\n{{.*?^}}", source, re.M | re.S)
                with self.subTest(page=page.name, path=path, function=function):
                    self.assertIsNotNone(body, f"{path} has no function {function}")
                    at = 0
                    for line in block.splitlines():
                        found = body[0].find(line.strip(), at)
                        self.assertGreaterEqual(found, 0, f"{function} has no line {line.strip()} there")
                        at = found + len(line.strip())
                        quoted += 1
        self.assertGreater(quoted, 15)

    def test_named_options_exist(self):
        helps = {}
        for page in PAGES:
            for code in spans(page.read_text(encoding="utf-8")):
                for name, rest in re.findall(r"(?:^|[\s(])orrery ([a-z][a-z-]*)((?:(?!\borrery )[^;&|#])*)", code):
                    if name not in helps:
                        done = subprocess.run([ORRERY, "help", name], capture_output=True, text=True, check=False)
                        helps[name] = done.stdout if done.returncode == 0 else None
                    with self.subTest(page=page.name, code=code):
                        self.assertIsNotNone(helps[name], f"'{name}' is no command of orrery")
                        for option in re.findall(r"(?<!\S)--[a-z][a-z-]*", rest):
                            self.assertRegex(helps[name], rf"(?<!\S){option}\b", f"orrery {name} has no {option}")


if __name__ == "__main__":
    unittest.main()
