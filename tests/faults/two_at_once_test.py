#!/usr/bin/env python3
"""Two processes of each command with one output, at the same time.

two_at_once_test.py COMMAND [--tries N]: N times each, with and without --force. What must hold: each
process ends with code 0, or with one line that says why it did not write (in use, there already,
appeared since); one at least ends with 0; the output is whole and that of a lone run; and nothing
else is left beside it but what an error line names.
"""

import argparse
import collections
import os
import pathlib
import subprocess
import sys
import tempfile

from small_results import LIMIT, SWEEP


def commands():
    """(name, arguments before the output, the output's name, how it is named)"""
    yield "simulate", ["simulate", "limit.toml", "--quiet"], "out.h5", "-o"
    yield "calibrate", ["calibrate", "fit.toml", "--quiet"], "out.h5", "-o"
    yield "sweep", ["sweep", "own.toml", "--quiet"], "out.h5", "-o"
    yield "plot", ["plot", "scene.h5"], "out.gp", "-o"
    yield "picture", ["plot", "scene.h5"], "out.svg", "-o"
    yield "export", ["export", "scene.h5", "--to", "json"], "out.json", "-o"
    yield "recommend", ["recommend", "swept.h5", "--within", "50 %"], "out.toml", "-o"
    yield "check", ["check", "check.toml", "--quiet"], "out.xml", "--junit"
    yield "stability", ["stability", "limit.toml", "--vary", "scale.loads", "--quiet"], "out.csv", "-o"


def content(path, command):
    """What a file says, without what may differ between two runs of the same."""
    if path.suffix == ".h5":
        return subprocess.run([command, "show", path.name], cwd=path.parent, capture_output=True,
                              check=True).stdout
    if path.suffix == ".csv":  # the cost of a point is measured in seconds
        return [line.split(b",")[0] for line in path.read_bytes().splitlines()]
    if path.suffix == ".xml":
        return path.read_bytes().count(b"<testcase")
    return path.read_bytes()


class Commands:
    def __init__(self, command, folder):
        self.command = command
        self.folder = folder
        for kind in ("fit", "check"):
            self.run("init", kind)
        (folder / "limit.toml").write_text(LIMIT)
        self.run("simulate", "limit.toml", "-o", "scene.h5", "--quiet")
        # A recommendation is of one problem: of one hinge length.
        sweep = SWEEP.replace('["unset", "30 mm"]', '["unset"]') + 'against = "theory:elastica"\n'
        (folder / "own.toml").write_text(sweep)
        self.run("sweep", "own.toml", "-o", "swept.h5", "--quiet")

    def run(self, *arguments):
        subprocess.run([self.command, *arguments], cwd=self.folder, capture_output=True, check=True)

    def pair(self, arguments):
        """Both at once. @return their codes and what they said"""
        both = [subprocess.Popen([self.command, *arguments], cwd=self.folder,
                                 stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
                for _ in range(2)]
        said = [one.communicate(timeout=120)[1] for one in both]
        return [one.returncode for one in both], said


def complaint(codes, said, there, expected, allowed):
    if not any(code == 0 for code in codes):
        return f"none wrote: {codes} {said}"
    for code, text in zip(codes, said):
        if code < 0:
            return f"signal {-code}"
        if code != 0 and (code not in (2, 3) or text.count("\n") != 1):
            return f"code {code}: {text}"
    kept = {name for name in there if any(name in text for text in said)}
    left = there - allowed - kept
    if left:
        return f"left behind: {left}"
    return "" if expected else "the output is not that of a lone run"


def try_one(commands, arguments, output, option, force, folder):
    path = folder / output
    path.unlink(missing_ok=True)
    before = {entry.name for entry in folder.iterdir()}
    commands.run(*arguments, option, output)
    lone = content(path, commands.command)
    path.unlink()
    codes, said = commands.pair([*arguments, option, output, *(["--force"] if force else [])])
    there = {entry.name for entry in folder.iterdir()}
    same = path.exists() and content(path, commands.command) == lone
    bad = complaint(codes, said, there, same, before | {output})
    for name in there - before:
        (folder / name).unlink()
    return "both" if codes == [0, 0] else "one", bad


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("command", type=os.path.abspath)
    parser.add_argument("--tries", type=int, default=100)
    options = parser.parse_args()
    bad = []
    print("| command | force | both wrote | one wrote |\n|---|---|---|---|")
    with tempfile.TemporaryDirectory(prefix="two-at-once-") as place:
        folder = pathlib.Path(place)
        made = Commands(options.command, folder)
        for name, arguments, output, option in commands():
            for force in (False, True):
                counts = collections.Counter()
                for _ in range(options.tries):
                    outcome, why = try_one(made, arguments, output, option, force, folder)
                    counts[outcome] += 1
                    if why:
                        bad.append(f"{name}{' --force' if force else ''}: {why}")
                print(f"| {name} | {'yes' if force else 'no'} | {counts['both']} | {counts['one']} |",
                      flush=True)
    print("\n".join(bad))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
