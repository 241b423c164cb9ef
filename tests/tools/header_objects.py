#!/usr/bin/env python3
"""The objects that show that headers stand alone, as far as a change can have undone that.

header_objects.py BUILD ALL BASE: prints targets of the build in BUILD, those of headers that differ
from the commit BASE or include one that does, in steps; those of all headers if ALL is `yes` or BASE
is no commit.
"""

import pathlib
import re
import subprocess
import sys

from public_headers import OURS, include_path

OBJECT = re.compile(r"^(\S*verify_interface_header_sets/(\S+\.hpp)\.cxx\.o): ", re.M)


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def changed_files(root, base):
    """What differs from a commit, new files included; None if there is no such commit."""
    git = ["git", "-C", str(root)]
    known = [*git, "rev-parse", "--quiet", "--verify", base + "^{commit}"]
    if subprocess.run(known, capture_output=True, check=False).returncode != 0:
        return None
    names = output(*git, "diff", "--name-only", "--diff-filter=d", base)
    return set((names + output(*git, "ls-files", "--others", "--exclude-standard")).split("\n"))


def touched(root, headers, changed):
    """Those of the headers that are changed or include one that is, in steps."""
    includes = {}
    left = list(headers)
    while left:
        path = left.pop()
        if path in includes:
            continue
        names = OURS.findall((root / path).read_text(encoding="utf-8"))
        includes[path] = [found for name in names if (found := include_path(root, name))]
        left += includes[path]
    reached = {path for path in includes if path in changed}
    while True:
        more = {path for path in includes.keys() - reached if reached.intersection(includes[path])}
        if not more:
            return [path for path in headers if path in reached]
        reached |= more


def main():
    build, everything, base = sys.argv[1:]
    root = pathlib.Path(__file__).resolve().parents[2]
    objects = {}
    for target, name in OBJECT.findall(output("ninja", "-C", build, "-t", "targets", "all")):
        objects[include_path(root, name)] = target
    if not objects:
        sys.exit(f"{build} has no headers to build alone")
    changed = None if everything == "yes" else changed_files(root, base)
    chosen = sorted(objects) if changed is None else touched(root, sorted(objects), changed)
    print("\n".join(objects[path] for path in chosen))


if __name__ == "__main__":
    main()
