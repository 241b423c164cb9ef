#!/usr/bin/env python3
"""Gives the command result files in which one thing is not as it should be.

damaged_results_test.py COMMAND [--sample N] [--seed S] [--requests N] [--kind KIND …]
                        [--only TEXT] [--log FILE] [--jobs N] [--sanitized]

Of each kind of result a small file is made with the command itself and mutated (mutate_result.py),
one thing at a time. Each copy is given to all commands that read such a file. They may read it
(exit code 0 or 1), refuse it (2) or lack what the machine does not have (3), with at most one line
that is an error; a signal, a second line, more than 20 s or 2 GB is a crash. Ends with the counts
of kind by mutation, and exit code 1 if anything crashed.
"""

import argparse
import collections
import multiprocessing
import os
import pathlib
import random
import resource
import shutil
import subprocess
import sys
import tempfile

import h5py

from mutate_result import mutations, paths, plain_copy
from small_results import SmallResults

SECONDS = 20
SECONDS_SANITIZED = 200
BYTES = 2 * 2**30
CODES = {0: "read", 1: "read", 2: "refused", 3: "machine"}
# What all files of a schema have alike is mutated in the first of them alone.
ALIKE = ("options/setup/", "regions/", "meta/", "inputs/")
OUTCOMES = ("refused", "read", "machine", "crashed")


def limited():
    resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))


def outcome_of(command, folder, sanitized):
    """One of OUTCOMES, and why."""
    environment = os.environ | {"OMP_NUM_THREADS": "1"}
    seconds = SECONDS_SANITIZED if sanitized else SECONDS
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, timeout=seconds,
                              preexec_fn=None if sanitized else limited, env=environment)
    except subprocess.TimeoutExpired:
        return "crashed", f"takes more than {seconds} s"
    errors = [line for line in done.stderr.decode(errors="replace").splitlines()
              if line.startswith("plastica: ") and "warning" not in line]
    if done.returncode not in CODES:
        return "crashed", f"exit code {done.returncode}: {done.stderr[-300:]}"
    if len(errors) > 1:
        return "crashed", f"{len(errors)} lines: {errors[0]}"
    return CODES[done.returncode], errors[0] if errors else ""


def arguments_for(request, name):
    """A request with its file: `sweep --resume` writes over it, pictures go beside it."""
    if request[0] == "sweep":
        return [[*request, "-o", name]]
    if request[0] == "plot":
        return [[request[0], name, *request[1:], "-o", to, "--force"] for to in ("-", "x.gp")]
    return [[request[0], name, *request[1:]]]


class Trial:
    """Runs mutants of the kinds in a folder of this process."""

    def __init__(self, command, results, sanitized, most):
        self.command = command
        self.most = most
        self.results = {kind: (file, requests) for kind, file, requests in results}
        self.sanitized = sanitized

    def __call__(self, task):
        kind, source, path, number = task
        file, requests = self.results[kind]
        if 0 < self.most < len(requests):
            some = random.Random(f"{path} {number}").sample(requests[1:], self.most - 1)
            requests = requests[:1] + some
        with tempfile.TemporaryDirectory(prefix="damaged-") as place:
            folder = pathlib.Path(place)
            for name in pathlib.Path(source).glob("*.toml"):
                shutil.copy(name, folder)
            for name in pathlib.Path(source).glob("*.csv"):
                shutil.copy(name, folder)
            shutil.copy(pathlib.Path(source, "plain-" + file), folder / "x.h5")
            with h5py.File(folder / "x.h5", "r+") as opened:
                name, apply = mutations(opened, path)[number]
                try:
                    apply(opened)
                except Exception as error:
                    return kind, name, path, "crashed", f"the mutation itself: {error}"
            outcome, why = self.run_all(folder, requests)
        return kind, name, path, outcome, why

    def run_all(self, folder, requests):
        """The first request tells what becomes of the file; whoever reads it must not crash."""
        first = None
        for request in requests:
            for arguments in arguments_for(request, "x.h5"):
                outcome, why = outcome_of([self.command, *arguments], folder, self.sanitized)
                if outcome == "crashed":
                    return outcome, f"{' '.join(arguments)}: {why}"
                first = first or (outcome, why)
                if outcome == "machine":
                    first = outcome, f"{' '.join(arguments)}: {why}"
            if first[0] == "refused" and request[0] == "show":
                return first  # all read with the same reader
        return first


def tasks_of(results, folder, options):
    tasks = []
    done = set()
    for kind, file, _ in results:
        if options.kind and kind not in options.kind:
            continue
        plain_copy(folder / file, folder / ("plain-" + file))
        with h5py.File(folder / ("plain-" + file), "r") as opened:
            for path in paths(opened):
                this = (opened.attrs["schema"], path)
                if this in done:
                    continue
                if path.startswith(ALIKE):
                    done.add(this)
                for number, (name, _) in enumerate(mutations(opened, path)):
                    if options.only in f"/{path.lstrip('/')} {name}":
                        tasks.append((kind, str(folder), path, number))
    if options.sample and options.sample < len(tasks):
        tasks = random.Random(options.seed).sample(tasks, options.sample)
    return tasks


def word_of(name):
    """What a mutation is counted under."""
    return "attribute" if name.startswith("@") else name.removeprefix("one ").removeprefix("all ")


def print_table(counts, kinds):
    print("| mutation |" + "".join(f" {kind} |" for kind in kinds))
    print("|---|" + "---|" * len(kinds))
    words = sorted({word for _, word in counts})
    for word in [*words, "together"]:
        row = []
        for kind in kinds:
            those = collections.Counter()
            for (of, which), count in counts.items():
                if of == kind and word in (which, "together"):
                    those += count
            row.append(" / ".join(str(those[outcome]) for outcome in OUTCOMES))
        print(f"| {word} |" + "".join(f" {cell} |" for cell in row))
    print("\nEach cell: " + " / ".join(OUTCOMES))


def parsed():
    parser = argparse.ArgumentParser()
    parser.add_argument("command", type=os.path.abspath)
    parser.add_argument("--sample", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--requests", type=int, default=0, help="so many of each mutant; 0: all")
    parser.add_argument("--kind", nargs="*", default=[])
    parser.add_argument("--only", default="", help="of what has this in its path or mutation")
    parser.add_argument("--log", help="a line for each mutant")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--sanitized", action="store_true", help="more time, any memory")
    return parser.parse_args()


def main():
    options = parsed()
    counts = collections.defaultdict(collections.Counter)
    bad = []
    with tempfile.TemporaryDirectory(prefix="small-results-") as place:
        folder = pathlib.Path(place)
        results = SmallResults(options.command, folder).all()
        trial = Trial(options.command, results, options.sanitized, options.requests)
        tasks = tasks_of(results, folder, options)
        print(f"{len(tasks)} mutants", flush=True)
        log = open(options.log, "w") if options.log else None
        with multiprocessing.Pool(options.jobs) as pool:
            for kind, name, path, outcome, why in pool.imap_unordered(trial, tasks):
                counts[kind, word_of(name)][outcome] += 1
                line = f"{kind}: /{path.lstrip('/')} {name}: {outcome}: {why}"
                if log:
                    print(line, file=log, flush=True)
                if outcome == "crashed":
                    bad.append(line)
    kinds = [kind for kind, _, _ in results if not options.kind or kind in options.kind]
    print_table(counts, kinds)
    print("\n".join(sorted(bad)))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
