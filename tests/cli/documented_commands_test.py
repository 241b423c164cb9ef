#!/usr/bin/env python3
"""Runs what README.md and the guides tell a reader to type, page by page, each in a folder of its
own that has nothing but the shipped data, in the order in which it stands.

documented_commands_test.py COMMAND [PAGE…]: the pages of the repository unless some are named.

  ```sh, ```python            is run: sh stops at the first line that fails, python stands by itself
  <!-- file: NAME -->         the block that follows is the file NAME
  <!-- not run: REASON -->    the block that follows is only shown
"""
import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMMAND = pathlib.Path(sys.argv[1]).resolve()
PAGES = sys.argv[2:] or [
    "README.md", "docs/laboratory.md", "docs/simulation-engineer.md", "docs/ci.md", "docs/hdf5.md",
    "docs/accuracy.md", "docs/python.md", "docs/reports.md", "docs/speed.md", "docs/extending.md"]
FEWEST_COMMANDS = 80
HAS_PACKAGE = importlib.util.find_spec("plastica") is not None
MOST_LEFT_OUT = 3

FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.M | re.S)
MARK = re.compile(r"<!-- (file|not run): (.+?) -->\n\Z")
RUNS = {"sh": ["bash", "-euo", "pipefail", "-c"], "python": [sys.executable, "-c"]}


class Page:
    """The blocks of a page in their order: line, language, text, and what their mark says."""

    def __init__(self, name):
        self.name = name
        text = (ROOT / name).read_text()
        self.blocks = []
        for match in FENCE.finditer(text):
            mark = MARK.search(text[:match.start()])
            kind, says = mark.groups() if mark else (None, None)
            line = text.count("\n", 0, match.start()) + 1
            self.blocks.append((line, match.group(1), match.group(2), kind, says))


def commands_in(text):
    """How many commands a block of sh has: lines that are no comment and continue none."""
    lines = re.sub(r"\\\n", " ", text).splitlines()
    return sum(bool(line.strip()) and not line.startswith("#") for line in lines)


class DocumentedCommands(unittest.TestCase):
    def follow(self, page, folder):
        """Does what the page says. @return how many blocks it leaves out"""
        left_out = 0
        path = os.pathsep.join([str(folder / "bin"), os.environ["PATH"]])
        for line, language, text, kind, says in page.blocks:
            if kind == "file":
                (folder / "here" / says).write_text(text)
            elif kind == "not run":
                left_out += 1
            elif "import plastica" in text and not HAS_PACKAGE:
                print(f"{page.name}:{line}: left out: the Python package is not built")
            elif language in RUNS:
                done = subprocess.run([*RUNS[language], text], cwd=folder / "here", text=True,
                                      stdin=subprocess.DEVNULL, capture_output=True,
                                      env={**os.environ, "PATH": path})
                self.assertEqual(done.returncode, 0, f"{page.name}:{line}:\n{text}\n{done.stderr}")
                self.count += commands_in(text) if language == "sh" else 1
        return left_out

    def test_every_page_can_be_followed(self):
        self.count = left_out = 0
        for name in PAGES:
            began = time.monotonic()
            with self.subTest(name), tempfile.TemporaryDirectory() as place:
                folder = pathlib.Path(place)
                (folder / "bin").mkdir()
                (folder / "bin/plastica").symlink_to(COMMAND)
                (folder / "here").mkdir()
                subprocess.run(["cp", "-r", ROOT / "data", folder / "here/data"], check=True)
                left_out += self.follow(Page(name), folder)
            print(f"{name}: {time.monotonic() - began:.1f} s")
        if len(sys.argv) == 2:
            self.assertGreaterEqual(self.count, FEWEST_COMMANDS)
            self.assertLessEqual(left_out, MOST_LEFT_OUT)
        print(f"{self.count} commands and scripts ran, {left_out} blocks are only shown")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
