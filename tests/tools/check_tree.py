#!/usr/bin/env python3
"""The rules of the tree that no compiler knows; prints each breach, exits 1 if there is one.

check_tree.py [ROOT]: reads the files that git tracks, and the new ones that it does not ignore.
"""

import pathlib
import re
import subprocess
import sys

from dead_links import check_links
from public_headers import check_public_headers

LONGEST_FILE = 400
LONGEST_OF = {"calibrate": 350, "sweeps": 350, "cli": 350}  # folders that are kept shorter
LONGEST_README = 250  # the rest stands in docs/

# Includes only go upward in this list.
LAYERS = [
    "plastica/base", "plastica/model", "plastica/law", "plastica/coupon", "plastica/chain",
    "plastica/lanes", "plastica/solve", "plastica/run", "plastica/theory", "plastica/io", "plastica/report",
    "calibrate", "sweeps", "cli", "python",
]

# What belongs in one place: name, pattern, and whether the place is a file or a folder.
SINGLE_PLACES = [
    ("#pragma omp", re.compile(r"^[ \t]*#[ \t]*pragma\s+omp\b", re.M), "file"),
    ("<nlopt.hpp>", re.compile(r'^[ \t]*#[ \t]*include\s*[<"]nlopt\.h(pp)?[>"]', re.M), "file"),
    ("<hdf5.h>", re.compile(r'^[ \t]*#[ \t]*include\s*[<"](hdf5(_hl)?|H5\w*)\.h[>"]', re.M), "folder"),
    ("<udunits2.h>", re.compile(r'^[ \t]*#[ \t]*include\s*[<"]udunits2\.h[>"]', re.M), "file"),
]

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include\s*"([^"]+)"', re.M)
LEFT_TO_DO = re.compile(r"\b(TO" r"DO|FIX" r"ME|XX" r"X)\b")
CONFLICT = re.compile(r"^(<{7}|>{7}) ", re.M)
MACHINE_PATH = re.compile(r"(?<![\w.}*-])/(home|root|Users|w[o]rk)/")
SOURCE = {".cpp", ".hpp"}
# What commands write where they are run: beside the clone's folders it was left behind.
LEFT_BEHIND = {".csv", ".h5", ".log", ".png", ".svg", ".toml", ".xml"}
COUNTED = SOURCE | {".py", ".cmake"}


def layer_of(path):
    """Index in LAYERS of a repository path or an include path; None outside of the layers."""
    path = path.removeprefix("lib/")
    for index, layer in enumerate(LAYERS):
        if path.startswith(layer + "/"):
            return index
    return None


def line_at(text, offset):
    return text.count("\n", 0, offset) + 1


def check_length(path, text):
    lines = text.count("\n")
    longest = LONGEST_OF.get(path.parts[0], LONGEST_FILE)
    if (path.suffix in COUNTED or path.name == "CMakeLists.txt") and lines > longest:
        yield f"{path}: {lines} lines, more than {longest}"
    if str(path) == "README.md" and lines > LONGEST_README:
        yield f"{path}: {lines} lines, more than {LONGEST_README}"


def check_words(path, text):
    for pattern, what in (
        (LEFT_TO_DO, "is left to do"),
        (MACHINE_PATH, "is a machine's path"),
        (CONFLICT, "is of a merge that was not ended"),
    ):
        for match in pattern.finditer(text):
            yield f"{path}:{line_at(text, match.start())}: '{match.group().strip()}' {what}"


def check_includes(path, text):
    mine = layer_of(str(path))
    for match in INCLUDE.finditer(text):
        name, place = match.group(1), f"{path}:{line_at(text, match.start())}"
        theirs = layer_of(name)
        if theirs is None:
            if not name.startswith("tests/"):
                yield f'{place}: "{name}" is not a path from one of the roots'
            elif mine is not None:
                yield f'{place}: "{name}" is a file of the tests'
        elif mine is not None and theirs > mine:
            yield f'{place}: {LAYERS[mine]} must not include "{name}", which is below it'


def check_pragma_once(path, text):
    if path.suffix == ".hpp" and not re.search(r"^#pragma once$", text, re.M):
        yield f"{path}: has no #pragma once"


def check_single_places(sources):
    for name, pattern, kind in SINGLE_PLACES:
        users = [path for path, text in sources.items() if pattern.search(text)]
        places = {path if kind == "file" else path.parent for path in users}
        if len(places) > 1:
            yield f"{name} belongs in one {kind}, and is in {', '.join(sorted(map(str, users)))}"
        if kind == "file":
            yield from (f"{path}: {name} belongs in a .cpp" for path in users if path.suffix != ".cpp")


def tracked_files(root):
    command = ["git", "-C", root, "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    names = subprocess.run(command, check=True, capture_output=True, text=True).stdout.split("\0")
    return [pathlib.Path(name) for name in sorted(set(names)) if (root / name).is_file()]


def breaches(root):
    """All breaches in the repository at ROOT, as lines of text."""
    found, sources, pages = [], {}, {}
    files = tracked_files(root)
    for path in files:
        if str(path) != "pyproject.toml" and path.parent == pathlib.Path(".") \
                and path.suffix in LEFT_BEHIND:
            found.append(f"{path}: a command has left it here")
        try:
            text = (root / path).read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue  # data in another encoding, as laboratories write it
        found += check_length(path, text)
        found += check_words(path, text)
        if path.suffix == ".md":
            pages[path] = text
        if path.suffix in SOURCE:
            found += check_includes(path, text)
            found += check_pragma_once(path, text)
            if layer_of(str(path)) is not None:
                sources[path] = text
    found += check_single_places(sources)
    found += check_public_headers(root)
    return found + list(check_links(pages, files))


def main():
    default = pathlib.Path(__file__).resolve().parents[2]
    found = breaches(pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else default)
    print("\n".join(found) if found else "the tree keeps its rules")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
