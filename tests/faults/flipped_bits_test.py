#!/usr/bin/env python3
"""Result files with one bit flipped, given to the command: each has to be refused.

flipped_bits_test.py COMMAND [--flips N]: N flips of each kind of result, in all of it alike, each
given to `show` or another command that reads it. Refused is exit code 2, one line, nothing else
said. Prints a table and exits with 1 if a file was read, or ended the command by a signal.
"""

import argparse
import collections
import multiprocessing
import os
import pathlib
import random
import subprocess
import sys
import tempfile

from small_results import SmallResults


class Trial:
    def __init__(self, command, folder):
        self.command = command
        self.folder = folder

    def __call__(self, task):
        kind, file, request, bit = task
        data = bytearray((self.folder / file).read_bytes())
        data[bit // 8] ^= 1 << bit % 8
        with tempfile.TemporaryDirectory(dir=self.folder) as place:
            path = pathlib.Path(place) / "flipped.h5"
            path.write_bytes(data)
            done = subprocess.run([self.command, request[0], str(path), *request[1:]], cwd=place,
                                  capture_output=True, timeout=60)
        lines = done.stderr.count(b"\n")
        if done.returncode < 0:
            return kind, "crashed", bit, request
        if done.returncode == 2 and lines == 1 and not done.stdout:
            return kind, "refused", bit, request
        return kind, "read", bit, request


def tasks_of(results, folder, flips, seed):
    draw = random.Random(seed)
    for kind, file, requests in results:
        bits = 8 * (folder / file).stat().st_size
        reading = [request for request in requests if request[0] in ("show", "plot", "export")]
        for _ in range(flips):
            yield kind, file, draw.choice(reading), draw.randrange(bits)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("command", type=os.path.abspath)
    parser.add_argument("--flips", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    counts = collections.defaultdict(collections.Counter)
    bad = []
    with tempfile.TemporaryDirectory(prefix="flipped-bits-") as place:
        folder = pathlib.Path(place)
        results = SmallResults(options.command, folder).all()
        tasks = list(tasks_of(results, folder, options.flips, options.seed))
        with multiprocessing.Pool(2) as pool:
            outcomes = pool.imap_unordered(Trial(options.command, folder), tasks)
            for kind, outcome, bit, request in outcomes:
                counts[kind][outcome] += 1
                if outcome != "refused":
                    bad.append(f"{kind}, bit {bit}, {' '.join(request)}: {outcome}")
    print("| kind | refused | read | crashed |\n|---|---|---|---|")
    for kind, found in counts.items():
        print(f"| {kind} | {found['refused']} | {found['read']} | {found['crashed']} |")
    print("\n".join(bad))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
