#!/usr/bin/env python3
"""A batch whose curves do not fit into the memory that they may take.

large_batch_test.py COMMAND: curves of a batch of more than 4 MB stand on the disk while it runs.
What must hold: the result has the numbers of the files and of the same specimens fitted a few at a
time; the report is that of `show`; nothing is left beside the output; a disk that is too small is
said in one line, with exit code 3, and `--resume` goes on.
"""

import math
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

import h5py
import numpy

SPECIMENS = 60
ROWS = 6000
FIT = """[[target]]
files = "{files}"
strain = "e"
stress = {{ column = "s", unit = "MPa" }}
"""


def curve(k):
    """SYNTHETIC: a curve that hardens, with noise, and breaks; one is too coarse to be fitted."""
    random = numpy.random.default_rng(k)
    rows = 4 if k == 7 else ROWS
    strain = numpy.linspace(0.0, 0.06 + 1e-4 * k, rows)
    plastic = numpy.maximum(strain - 1.5e-3, 0.0)
    stress = numpy.minimum(2e5 * strain, 300.0 + 30.0 * (1.0 - numpy.exp(-40.0 * plastic)))
    stress += 0.5 * random.standard_normal(rows)
    stress[-1] = 0.0
    return strain, stress


class Batch:
    def __init__(self, command, folder):
        self.command = command
        self.folder = folder
        (folder / "curves").mkdir()
        for k in range(SPECIMENS):
            strain, stress = curve(k)
            rows = "\n".join(f"{e!r},{s!r}" for e, s in zip(strain.tolist(), stress.tolist()))
            (folder / "curves" / f"bar{k:02}.csv").write_text("e,s\n" + rows + "\n")

    def run(self, *arguments, limit=None, scratch=None):
        """@param limit  bytes that a file may have; a disk that is full, but for the words
        @param scratch  TMPDIR"""
        others = {name: value for name, value in os.environ.items() if name != "TMPDIR"}

        def limited():
            if limit is None:
                return
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

        return subprocess.run([self.command, *arguments], cwd=self.folder, capture_output=True,
                              text=True, check=False, preexec_fn=limited,
                              env=others if scratch is None else {**others, "TMPDIR": scratch})

    def fit(self, name, files, *options, **others):
        (self.folder / "fit.toml").write_text(FIT.format(files=files))
        return self.run("calibrate", "fit.toml", "-o", f"{name}.h5", *options, **others)

    def left(self):
        return sorted(p.name for p in self.folder.iterdir() if p.suffix not in (".toml", ".h5"))


def require(what, holds, shown=""):
    if not holds:
        sys.exit(f"{what}: not so\n{shown}")


def rows_of(file, path, i):
    offsets = file[path + "/offsets"][:]
    part = slice(int(offsets[i]), int(offsets[i + 1]))
    return file[path + "/strain"][part], file[path + "/stress"][part]


def check_raw(file):
    for i, name in enumerate(file["fits/name"].asstr()[:]):
        strain, stress = curve(int(name[3:]))
        read = rows_of(file, "curves/raw", i)
        require(f"the raw curve of {name} is that of its file",
                numpy.array_equal(read[0], strain) and numpy.allclose(read[1], 1e6 * stress, rtol=1e-15))


def check_part(whole, part):
    """Each dataset of the fits of a part, as the whole batch has it."""
    names = list(whole["fits/name"].asstr()[:])
    for i, name in enumerate(part["fits/name"].asstr()[:]):
        k = names.index(name)
        for kind in ("raw", "corrected", "fitted"):
            for a, b in zip(rows_of(part, f"curves/{kind}", i), rows_of(whole, f"curves/{kind}", k)):
                require(f"{kind} curve of {name}", numpy.array_equal(a, b))
        for table in ("fits", "characteristics", "parameters/yield_stress", "parameters/break_strain"):
            for column, values in part[table].items():
                if not isinstance(values, h5py.Dataset) or column == "row":
                    continue
                a, b = values[i], whole[table][column][k]
                same = a == b or (isinstance(a, float) and math.isnan(a) and math.isnan(b))
                require(f"{table}/{column} of {name}", same, f"{a} {b}")


def check_counts(batch):
    """What `show` only counts must be there, in a file without a digest too."""
    for column, spoil in (("raw/offsets", lambda data: data[:] + (numpy.arange(len(data)) > 3)),
                          ("fitted/strain", lambda data: data[:-1]),
                          ("corrected/stress", lambda data: None)):
        with h5py.File(batch.folder / "all.h5") as whole, \
                h5py.File(batch.folder / "spoiled.h5", "w") as spoiled:
            for name in whole:
                whole.copy(name, spoiled)
            for name, value in whole.attrs.items():
                spoiled.attrs[name] = value
            values = spoil(spoiled["curves"][column])
            del spoiled["curves"][column]
            if values is not None:
                spoiled["curves"][column] = values
        shown = batch.run("show", "spoiled.h5")
        require(f"{column} that is not as it should be is refused",
                shown.returncode == 2 and "/curves/" in shown.stderr.splitlines()[-1], shown.stderr)


def check(batch):
    done = batch.fit("all", "curves/*.csv")
    require("the batch is fitted, but for what is too coarse", done.returncode == 1, done.stderr)
    require("nothing is left", batch.left() == ["curves"], batch.left())
    shown = batch.run("show", "all.h5")
    require("show prints the report", shown.stdout == done.stdout, shown.stdout)
    for part in ("bar0[0-4]", "bar0[5-9]", "bar31"):
        require(part, batch.fit("part", f"curves/{part}.csv", "--force").returncode in (0, 1))
        with h5py.File(batch.folder / "all.h5") as whole, h5py.File(batch.folder / "part.h5") as few:
            check_raw(whole)
            check_part(whole, few)

    check_counts(batch)

    full = batch.fit("full", "curves/*.csv", "--quiet", limit=5_000_000)
    require("a disk that is too small for the curves is said",
            full.returncode == 3 and full.stderr.count("\n") == 1
            and "cannot take the curves of the run" in full.stderr,
            full.stderr)
    require("nothing is left", batch.left() == ["curves"], batch.left())
    # Room for the curves, not for a result of three laws.
    laws = ("--laws", "ideal,linear,voce", "--quiet")
    full = batch.fit("full", "curves/*.csv", *laws, limit=6_000_000)
    require("what was fitted is kept",
            full.returncode == 3 and "full.h5" in full.stderr
            and batch.left() == ["curves", "full.h5.journal"], full.stderr)
    none = batch.fit("full", "curves/*.csv", "--resume", *laws, scratch="none")
    require("a TMPDIR that is not there is said",
            none.returncode == 3 and none.stderr.startswith("plastica: none: cannot take the curves"),
            none.stderr)
    dry = batch.fit("dry", "curves/*.csv", "--dry-run", scratch="none")
    require("so it is in a dry run", dry.returncode == 3 and dry.stderr == none.stderr, dry.stderr)
    few = batch.fit("dry", "curves/bar0[0-4].csv", "--dry-run", scratch="none")
    require("a batch that fits into memory needs no folder", few.returncode == 0, few.stderr)
    again = batch.fit("full", "curves/*.csv", "--resume", *laws, scratch="curves")
    require("the run goes on", again.returncode == 1, again.stderr)
    batch.fit("whole", "curves/*.csv", *laws)
    same = batch.run("diff", "whole.h5", "full.h5")
    require("the results are the same", same.returncode == 0, same.stdout + same.stderr)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        check(Batch(sys.argv[1], pathlib.Path(name)))
