#!/usr/bin/env python3
"""Result files of older versions are read as they were: the same report, but for what they do not
have.

older_files_test.py COMMAND DATA: fits curves, simulates scenes and runs a sweep of DATA, makes files
of older versions of the results, which had other columns or other names, and has the command show
both.
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy

COMMAND, DATA = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()


def run(folder, *arguments):
    done = subprocess.run([COMMAND, *arguments], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def copy_of(folder):
    """What `fit.h5` holds in a plain HDF5 file, which has no digest and may be changed."""
    copy = h5py.File(folder / "older.h5", "w")
    with h5py.File(folder / "fit.h5") as file:
        for name in file:
            file.copy(name, copy)
        for name, value in file.attrs.items():
            copy.attrs[name] = value
    return copy


OLD_NAMES = {"kinematic_fraction": "kinematic_share", "misfit_fraction": "misfit_share",
          "segment_fractions": "segment_shares", "targets": "parts",
          "runs_test_p": "runs_probability", "last_intact_strain": "last_whole_strain",
          "last_intact_stress": "last_whole_stress", "free": "moved"}


def give_old_names(file):
    """Gives datasets and groups the names of the last version. @return the present ones found"""
    found = []
    file.visit(lambda path: found.append(path) if path.split("/")[-1] in OLD_NAMES else None)
    for path in sorted(found, key=lambda path: -path.count("/")):
        folder, _, name = path.rpartition("/")
        file.move(path, f"{folder}/{OLD_NAMES[name]}")
    return {path.split("/")[-1] for path in found}


class OlderFiles(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.place.name)

    def tearDown(self):
        self.place.cleanup()

    def test_of_coupons(self):
        run(self.folder, "calibrate", str(DATA / "fits/demo.toml"), "-o", "fit.h5", "--quiet")
        now = run(self.folder, "show", "fit.h5", "--all")
        errors = {}
        with copy_of(self.folder) as file:
            file.attrs["version"] = 3
            for name, group in file["parameters"].items():
                if name == "present":
                    continue
                errors[name] = group["sampling_error"][:]
                for column in ("sampling_error", "misfit_error", "degrees_of_freedom"):
                    del group[column]
        self.assertEqual(run(self.folder, "show", "older.h5", "--all"), now)
        self.assertGreater(numpy.nanmax(errors["break_strain"]), 0.0)

    def test_through_scenes(self):
        run(self.folder, "calibrate", str(DATA / "fits/bend_test.toml"), "-o", "fit.h5", "--quiet")
        now = run(self.folder, "show", "fit.h5")
        with copy_of(self.folder) as file:
            file.attrs["version"] = 3
            group = file["parameters"]
            group["at_bound"] = group["at_lower"][:] | group["at_upper"][:]
            for column in ("logarithmic", "at_lower", "at_upper", "identified", "judged"):
                del group[column]
        self.assertEqual(run(self.folder, "show", "older.h5"), now)

    def check_names(self, scene_or_sweep, *renamed):
        """Shows a result the same when its datasets have the names that they had before."""
        command = "sweep" if "sweeps" in scene_or_sweep else "simulate"
        run(self.folder, command, str(DATA / scene_or_sweep), "-o", "fit.h5", "--quiet")
        now = run(self.folder, "show", "fit.h5")
        with copy_of(self.folder) as file:
            for name, before in renamed:
                file.move(name, before)
        self.assertEqual(run(self.folder, "show", "older.h5"), now)

    def test_of_scenes_with_old_names(self):
        self.check_names("scenes/report_fig06_bent.toml",
                         ("outcome/energy_balance_error", "outcome/ledger_error"),
                         ("options/setup/solver/largest_rotation",
                          "options/setup/solver/largest_turn"),
                         ("options/setup/solver/max_iterations",
                          "options/setup/solver/most_iterations"))

    def test_of_broken_beams_with_old_names(self):
        self.check_names("scenes/report_fig11_broken.toml",
                         ("events/fragments", "events/pieces"),
                         ("energy/numerical_dissipation", "energy/numerical"))

    def test_of_sweeps_with_old_names(self):
        self.check_names("sweeps/cantilever_deflection.toml",
                         ("cases/energy_balance_error", "cases/ledger_error"))

    def test_with_old_names(self):
        cyclic = str(DATA / "scenes/hardening_table.toml")
        for version, command, found in (
                (4, ("calibrate", str(DATA / "fits/demo.toml"), "--quiet"),
                 {"kinematic_fraction", "misfit_fraction", "runs_test_p", "last_intact_strain",
                  "last_intact_stress", "free"}),
                (4, ("calibrate", str(DATA / "fits/bend_test.toml"), "--quiet"),
                 {"misfit_fraction", "runs_test_p", "targets"}),
                (2, ("simulate", cyclic, "--quiet"),
                 {"kinematic_fraction", "segment_fractions"})):
            with self.subTest(command=command):
                run(self.folder, *command, "-o", "fit.h5", "--force")
                now = run(self.folder, "show", "fit.h5")
                with copy_of(self.folder) as file:
                    file.attrs["version"] = version
                    self.assertEqual(give_old_names(file), found)
                self.assertEqual(run(self.folder, "show", "older.h5"), now)

    def test_of_an_older_version_are_refused(self):
        run(self.folder, "calibrate", str(DATA / "fits/demo.toml"), "-o", "fit.h5", "--quiet")
        with copy_of(self.folder) as file:
            file.attrs["version"] = 2
        done = subprocess.run([COMMAND, "show", "older.h5"], cwd=self.folder, capture_output=True,
                              text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("older.h5: version = 2: must be 3 to 5, which this Plastica reads", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
