#!/usr/bin/env python3
"""`plastica diff` sees whatever of a result is changed, in results of each kind.

result_differences_test.py COMMAND
"""

import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy
from mutate_result import is_text
from small_results import SmallResults

COMMAND = pathlib.Path(sys.argv[1]).resolve()
# What says who made a result, not what it is.
LEFT_OUT = ("meta", "cases/id")


def datasets(file):
    found = []
    file.visititems(lambda name, item: found.append(name)
                    if isinstance(item, h5py.Dataset) and not name.startswith(LEFT_OUT) else None)
    return found


def rewritten(file, name, data, dtype):
    """A dataset with other values in place of the one that is there."""
    attributes = dict(file[name].attrs)
    del file[name]
    file.create_dataset(name, data=data, dtype=dtype)
    for key, value in attributes.items():
        file[name].attrs[key] = value


def by_one_bit(value):
    if isinstance(value, (bytes, str)):
        text = value.decode() if isinstance(value, bytes) else value
        return text + "x"
    if numpy.issubdtype(type(value), numpy.floating):
        return numpy.nextafter(value, 1e300) if math.isfinite(value) else type(value)(1.0)
    return type(value)(int(value) ^ 1)


class Differences(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.place.name)
        cls.made = SmallResults(COMMAND, cls.folder)
        cls.files = {kind: cls.folder / file for kind, file, _ in cls.made.all()}

    @classmethod
    def tearDownClass(cls):
        cls.place.cleanup()

    def diff(self, *arguments):
        return subprocess.run([COMMAND, "diff", *map(str, arguments)], cwd=self.folder,
                              capture_output=True, text=True)

    def changed(self, file, change):
        """A copy that h5py has made and changed, which has no digest any more."""
        copy = file.with_suffix(".changed.h5")
        with h5py.File(file) as source, h5py.File(copy, "w") as target:
            for name in source:
                source.copy(name, target)
            for key, value in source.attrs.items():
                target.attrs[key] = value
            change(target)
        return copy

    def test_results_are_equal_to_themselves_and_to_copies(self):
        for kind, file in self.files.items():
            with self.subTest(kind):
                done = self.diff(file, file)
                self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
                self.assertEqual(self.diff(file, self.changed(file, lambda _: None)).returncode, 0)

    def test_second_runs_are_equal_whatever_the_threads(self):
        self.made.run("simulate", "motion.toml", "-o", "again.h5", "--quiet")
        self.assertEqual(self.diff("motion.h5", "again.h5").returncode, 0)
        for threads in ("1", "2"):
            self.made.run("sweep", "timed.toml", "-o", f"sweep{threads}.h5", "--quiet", "--threads",
                          threads)
            self.made.run("calibrate", "fit.toml", "-o", f"fit{threads}.h5", "--quiet", "--threads",
                          threads)
        for kind in ("sweep", "fit"):
            done = self.diff(f"{kind}1.h5", f"{kind}2.h5")
            self.assertEqual(done.returncode, 0, done.stdout)
        self.assertEqual(self.diff("timed.h5", "sweep2.h5").returncode, 0)

    def test_one_bit_of_any_dataset_is_seen(self):
        for kind, file in self.files.items():
            with self.subTest(kind):
                names = []

                def change(target):
                    for name in datasets(target):
                        item = target[name]
                        if item.size == 0:
                            continue
                        names.append(name)
                        data = item[()]
                        middle = tuple(extent // 2 for extent in item.shape)
                        if item.shape == ():
                            data = by_one_bit(data)
                        else:
                            data[middle] = by_one_bit(data[middle])
                        rewritten(target, name, data, h5py.string_dtype() if is_text(item)
                                  else item.dtype)
                done = self.diff(file, self.changed(file, change), "--all")
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertGreater(len(names), 15)
                for name in names:
                    self.assertIn(f"\n  /{name}  ", "\n" + done.stdout)

    def test_other_extents_and_missing_datasets_are_seen(self):
        for kind, file in self.files.items():
            with self.subTest(kind):
                longer, missing = [], []

                def change(target):
                    for k, name in enumerate(datasets(target)):
                        item = target[name]
                        if k % 2 == 0:
                            missing.append(name)
                            del target[name]
                        elif item.shape != () and item.size > 0:
                            longer.append(name)
                            data = item[()]
                            rewritten(target, name, numpy.concatenate([data, data[:1]]),
                                      h5py.string_dtype() if is_text(item) else item.dtype)
                done = self.diff(file, self.changed(file, change), "--all")
                self.assertEqual(done.returncode, 1, done.stderr)
                for name in longer:
                    self.assertRegex("\n" + done.stdout, rf"\n  /{name}  extents .*, extents .*\n")
                for name in missing:
                    self.assertRegex("\n" + done.stdout, rf"\n  /{name}  .*, nothing\n")

    def test_attributes_are_seen_but_for_who_ran(self):
        def unit(target):
            target["fits/cost"].attrs["units"] = "kPa^2"
        file = self.files["fits"]
        done = self.diff(file, self.changed(file, unit))
        self.assertEqual(done.returncode, 1)
        self.assertIn('  /fits/cost @units  "Pa^2", "kPa^2"\n', done.stdout)

        def who(target):
            target.attrs["run"] = "0123456789abcdef"
            target["meta/seconds"][()] = 1e6
            target["meta/threads"][()] = 99
        self.assertEqual(self.diff(file, self.changed(file, who)).returncode, 0)
        sweep = self.files["sweep"]

        def ids(target):
            data = target["cases/id"][()]
            data[0] = "0123456789abcdef"
            rewritten(target, "cases/id", data, h5py.string_dtype())
        self.assertEqual(self.diff(sweep, self.changed(sweep, ids)).returncode, 0)

    def test_rows_have_their_names(self):
        def change(target):
            target["cases/value"][1] *= 1.001
        done = self.diff(self.files["sweep"], self.changed(self.files["sweep"], change))
        self.assertRegex(done.stdout, r"  /cases/value  beam\.segments = 2, "
                         r"rules\.hinge_length = nan, rules\.end_rule = equal  \S+, \S+: 0\.000999\n")

    def test_differences_are_within_or_not(self):
        file = self.files["path"]

        def slightly(target):
            values = target["probes/values"]
            values[0, -1] *= 1.0 + 1e-7
        copy = self.changed(file, slightly)
        self.assertEqual(self.diff(file, copy, "--within", "1e-6").returncode, 0)
        done = self.diff(file, copy, "--within", "1e-8")
        self.assertEqual(done.returncode, 1)
        self.assertIn("  /probes/values  tip [", done.stdout)
        self.assertEqual(self.diff(file, copy, "--ignore", "/probes").returncode, 0)
        self.assertEqual(self.diff(file, copy, "--quiet").stdout, "")

    def test_few_are_listed_unless_all_are_wanted(self):
        def change(target):
            target["probes/values"][...] += 1.0
        file = self.files["motion"]
        copy = self.changed(file, change)
        few = self.diff(file, copy).stdout.splitlines()
        every = self.diff(file, copy, "--all").stdout.splitlines()
        self.assertEqual(len(few), 22)
        self.assertIn("more: --all shows them", few[20])
        self.assertEqual(len(every), 1 + 2 * 11)

    def test_bad_input_is_refused(self):
        fits, sweep = self.files["fits"], self.files["sweep"]
        (self.folder / "text.h5").write_text("no result")
        for arguments, line in {
                (fits, sweep): f"plastica: {sweep}: schema = plastica/sweep: must be "
                               f"plastica/fits, as of {fits}\n",
                (fits, "text.h5"): "plastica: text.h5: is not an HDF5 file\n",
                (fits, "none.h5"): "plastica: none.h5: cannot be read: No such file or directory\n",
                (fits, fits, "--ignore", "/fit/cost"):
                    "plastica: --ignore = /fit/cost: is in neither file\n",
                (fits, fits, "--within", "1"): None,
                (fits, fits, "--within", "-1e-3"):
                    "plastica: --within = -1e-3: must be from 0 on and below 1\n",
                (fits, fits, "--within", "small"): None}.items():
            with self.subTest(arguments):
                done = self.diff(*arguments)
                self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
                self.assertEqual(done.stderr.count("\n"), 1)
                if line:
                    self.assertEqual(done.stderr, line)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
