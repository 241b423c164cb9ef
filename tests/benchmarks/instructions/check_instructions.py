#!/usr/bin/env python3
"""Holds the instructions of each kernel, per point, segment and step, or segment and iteration, to
the counts in expected.json, within 2 %; and the order in which they grow with the number of segments
to 1.005 at most. Does not depend on the machine, but on the compiler: under another one than that
of the file nothing is checked, and a line says so.

    check_instructions.py PROGRAM COMPILER          checks
    check_instructions.py PROGRAM COMPILER --write  writes the counts
"""
import json
import math
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile

EXPECTED = pathlib.Path(__file__).with_name("expected.json")
TOLERANCE = 0.02
LARGEST_ORDER = 1.005
# In full: callgrind does not dump for a pattern that another option has matched.
MEASURED = "plastica::(anonymous namespace)::measured(std::function<void ()> const&)"
# A string instruction counts once a byte, and from which size on the C library uses these depends on
# the processor: it shall never.
ENVIRONMENT = dict(os.environ, GLIBC_TUNABLES=":".join(
    f"glibc.cpu.x86_rep_{kind}_threshold=4294967295" for kind in ("movsb", "stosb")))
SKIPPED = 77  # what ctest takes for a skipped test


def counted(program):
    """Instructions of each kernel over its units, in one run under callgrind."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            ["valgrind", "--tool=callgrind", "--toggle-collect=*measured(*",
             f"--dump-after={MEASURED}", f"--callgrind-out-file={folder}/counts", program],
            capture_output=True, text=True, env=ENVIRONMENT)
        if done.returncode != 0:
            sys.exit(f"{program} under valgrind: exit code {done.returncode}\n{done.stderr}")
        kernels = [line.split() for line in done.stdout.splitlines()]
        counts = {}
        for number, (name, units) in enumerate(kernels, start=1):
            part = pathlib.Path(folder, f"counts.{number}").read_text()
            total = int(re.search(r"^(?:totals|summary): (\d+)", part, re.MULTILINE).group(1))
            counts[name] = round(total / float(units), 1)
    return counts


def taken_apart(counts):
    """Counts of kernels of one size, and the orders of those of several, by least squares."""
    sizes = {}
    for name, count in counts.items():
        kernel, at, segments = name.partition("@")
        if at:
            sizes.setdefault(kernel, []).append((math.log(int(segments)), math.log(count)))
    orders = {kernel: 1.0 + statistics.linear_regression(*zip(*points)).slope
              for kernel, points in sizes.items()}
    return {name: count for name, count in counts.items() if "@" not in name}, orders


def main():
    program, compiler = sys.argv[1], sys.argv[2]
    known = json.loads(EXPECTED.read_text()) if EXPECTED.exists() else {}
    if shutil.which("valgrind") is None:
        print("skipped: valgrind is not installed")
        return SKIPPED
    if "--write" in sys.argv[3:]:
        counts, _ = taken_apart(counted(program))
        EXPECTED.write_text(json.dumps({"compiler": compiler, "instructions": counts},
                                       indent=1) + "\n")
        return 0
    if known["compiler"] != compiler:
        print(f"skipped: the counts are those of {known['compiler']}, not of {compiler}")
        return SKIPPED
    counts, orders = taken_apart(counted(program))
    expected = known["instructions"]
    wrong = slow = 0
    for name in sorted(counts.keys() | expected.keys()):
        found, was = counts.get(name), expected.get(name)
        holds = found is not None and was is not None and abs(found - was) <= TOLERANCE * was
        wrong += not holds
        print(f"{name}: {found}, expected {was}{'' if holds else ' <- off by more than 2 %'}")
    for name, order in orders.items():
        holds = order <= LARGEST_ORDER
        slow += not holds
        print(f"{name}: order {order:.4f}{'' if holds else f' <- above {LARGEST_ORDER}'}")
    if wrong:
        print(f"if this is meant: {sys.argv[0]} PROGRAM COMPILER --write")
    return 1 if wrong or slow else 0


if __name__ == "__main__":
    sys.exit(main())
