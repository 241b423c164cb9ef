#!/usr/bin/env python3
"""Result files of older versions are read as they were: the same report, but for what they do not
have.

older_files_test.py COMMAND DATA: fits curves, simulates scenes and runs a sweep of DATA, makes files
of older versions of the results, which had other columns or other names, and has the command show
both.
"""

import functools
import pathlib
import shutil
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


@functools.cache
def made(*arguments):
    """The file of a command that several tests ask for: run once."""
    folder = tempfile.TemporaryDirectory()
    run(folder.name, *arguments, "-o", "made.h5", "--quiet")
    return folder


def make(folder, *arguments):
    """Puts the file of a command into a folder as `fit.h5`."""
    shutil.copy(pathlib.Path(made(*arguments).name) / "made.h5", folder / "fit.h5")


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
          "last_intact_stress": "last_whole_stress", "free": "moved",
          "stated_noise": "given_noise", "remeshed": "divided"}


def give_old_names(file):
    """Gives datasets and groups the names of the last version. @return the present ones found"""
    found = []
    file.visit(lambda path: found.append(path) if path.split("/")[-1] in OLD_NAMES else None)
    for path in sorted(found, key=lambda path: -path.count("/")):
        folder, _, name = path.rpartition("/")
        file.move(path, f"{folder}/{OLD_NAMES[name]}")
    return {path.split("/")[-1] for path in found}


def give_old_roles(file):
    """Has each table of /parameters say once what all fits have of it, as it was before the last
    version; the objective of curves had another word."""
    for table in file["parameters"].values():
        if isinstance(table, h5py.Group):
            (table.attrs["role"],) = set(table["role"].asstr()[:]) - {""}
            del table["role"]
    options = file["options"]
    if "objective" in options:
        words = {"path": "strain-path"}
        objective = options["objective"].asstr()[()]
        del options["objective"]
        options["objective"] = words.get(objective, objective)
        del options["stated"]
    for name in ("objective", "stated_prior_squared"):
        if "outcome" in file["fits"]:  # through scenes
            del file["fits"][name]


def give_old_tables(file):
    """Has /parameters say which fits have theirs, as it did for curves until version 4."""
    give_old_roles(file)
    group = file["parameters"]
    tables = [table for table in group.values() if isinstance(table, h5py.Group)]
    group["present"] = numpy.any([table["row"][:] >= 0 for table in tables], axis=0).astype("u1")
    del group["path"]
    for table in tables:
        del table["row"]


def give_old_rows(file):
    """Makes one table of /parameters, as it was for fits through scenes until version 4."""
    give_old_roles(file)
    group = file["parameters"]
    paths = group["path"].asstr()[:]
    tables = {path: group[path.split(".")[-1]] for path in paths}
    fits = len(file["fits/name"])
    rows = sorted((fit, tables[path]["row"][fit], path) for fit in range(fits) for path in paths
                  if tables[path]["row"][fit] >= 0)
    units = [tables[path]["value"].attrs["units"] for _, _, path in rows]
    columns = {"fit": numpy.array([fit for fit, _, _ in rows], dtype="u8"),
               "path": numpy.array([path for _, _, path in rows], dtype=h5py.string_dtype()),
               "dimension": numpy.array(["stress" if unit == "Pa" else "strain" for unit in units],
                                        dtype=h5py.string_dtype()),
               "value_units": numpy.array(units, dtype=h5py.string_dtype())}
    for name in tables[paths[0]]:
        if name != "row":
            kind = tables[paths[0]][name].dtype
            columns[name] = numpy.array([tables[path][name][fit] for fit, _, path in rows],
                                        dtype=kind)
    del file["parameters"]
    for name, column in columns.items():
        file.create_dataset(f"parameters/{name}", data=column)


class OlderFiles(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.place.name)

    def tearDown(self):
        self.place.cleanup()

    def test_of_coupons(self):
        make(self.folder, "calibrate", str(DATA / "fits/demo.toml"), "--no-modulus-prior")
        now = run(self.folder, "show", "fit.h5", "--all")
        errors = {}
        with copy_of(self.folder) as file:
            file.attrs["version"] = 3
            give_old_tables(file)
            for name, group in file["parameters"].items():
                if name == "present":
                    continue
                errors[name] = group["sampling_error"][:]
                for column in ("sampling_error", "misfit_error", "degrees_of_freedom"):
                    del group[column]
        self.assertEqual(run(self.folder, "show", "older.h5", "--all"), now)
        self.assertGreater(numpy.nanmax(errors["break_strain"]), 0.0)

    def test_of_coupons_before_priors(self):
        make(self.folder, "calibrate", str(DATA / "fits/demo.toml"))
        now = run(self.folder, "show", "fit.h5", "--all")
        with copy_of(self.folder) as file:
            file.attrs["version"] = 7
            give_old_roles(file)
            for name in ("stated_priors", "stated_prior_variance", "stated_prior_squared"):
                del file["fits"][name]
            for name in ("has_prior", "prior_mean", "prior_standard_deviation"):
                del file["options/parameters"][name]
        self.assertEqual(run(self.folder, "show", "older.h5", "--all"), now)

    def test_through_scenes(self):
        make(self.folder, "calibrate", str(DATA / "fits/bend_test.toml"))
        now = run(self.folder, "show", "fit.h5")
        with copy_of(self.folder) as file:
            file.attrs["version"] = 3
            give_old_rows(file)
            del file["repairs"]
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

    def test_of_sweeps_along_one_axis(self):
        """Version 2 took its references along the refined axis: its errors lack the others."""
        run(self.folder, "sweep", str(DATA / "sweeps/robot_arm.toml"), "-o", "fit.h5", "--quiet")
        self.assertIn("cheapest within 2 %",
                      run(self.folder, "recommend", "fit.h5", "--within", "2 %"))
        with copy_of(self.folder) as file:
            file.attrs["version"] = 2
            for name in ("cases/error_lacks", "cases/coarser_in", "cases/reference_error",
                         "cases/break_joint", "cases/break_place", "sweep/error_notes"):
                del file[name]
        alone = "error of beam.segments alone; that of solver.time_step is not in it"
        self.assertIn(alone + ": the file is of an older version; run the sweep again",
                      run(self.folder, "show", "older.h5"))
        done = subprocess.run([COMMAND, "recommend", "older.h5", "--within", "2 %"],
                              cwd=self.folder, capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout),
                         (1, f"nothing can be recommended: {alone}\n"))

    def test_with_old_names(self):
        cyclic = str(DATA / "scenes/hardening_table.toml")
        for version, command, change, found in (
                (4, ("calibrate", str(DATA / "fits/demo.toml"), "--no-modulus-prior"),
                 give_old_tables,
                 {"kinematic_fraction", "misfit_fraction", "runs_test_p", "last_intact_strain",
                  "last_intact_stress", "free"}),
                (4, ("calibrate", str(DATA / "fits/bend_test.toml")), give_old_rows,
                 {"misfit_fraction", "runs_test_p", "targets", "stated_noise", "remeshed"}),
                (2, ("simulate", cyclic), lambda file: None,
                 {"kinematic_fraction", "segment_fractions"})):
            with self.subTest(command=command):
                make(self.folder, *command)
                now = run(self.folder, "show", "fit.h5")
                with copy_of(self.folder) as file:
                    file.attrs["version"] = version
                    change(file)
                    self.assertEqual(give_old_names(file), found)
                self.assertEqual(run(self.folder, "show", "older.h5"), now)

    def test_of_joint_fits_that_do_not_say_which_table_a_target_stands_in(self):
        bar = (DATA / "scenes/bend_test.toml").read_text()
        (self.folder / "bend_test.toml").write_text(bar)
        (self.folder / "half.toml").write_text(bar)
        (self.folder / "bend_test.csv").write_text((DATA / "targets/bend_test.csv").read_text())
        fit = (DATA / "fits/bend_test.toml").read_text()
        fit = fit.replace("../scenes/", "").replace("../targets/", "")
        start = fit.index("[[target]]")
        other = fit[start:].replace("bend_test.toml", "half.toml")
        (self.folder / "fit.toml").write_text(fit + "\n" + other)
        run(self.folder, "calibrate", "fit.toml", "--quiet")
        with h5py.File(self.folder / "fit.h5") as file:
            second = file["targets/name"].asstr()[1]
            self.assertEqual(list(file["targets/table"][:]), [1, 2])
        beam = ("--what", "beam", "--target", second)
        now = run(self.folder, "export", "fit.h5", *beam)
        self.assertIn("as the fit has it for target", now)
        with copy_of(self.folder) as file:
            file.attrs["version"] = 8
            give_old_roles(file)
            del file["targets/table"]
        self.assertEqual(run(self.folder, "export", "older.h5", *beam), now)

    def test_of_an_older_version_are_refused(self):
        make(self.folder, "calibrate", str(DATA / "fits/demo.toml"))
        with copy_of(self.folder) as file:
            file.attrs["version"] = 2
        done = subprocess.run([COMMAND, "show", "older.h5"], cwd=self.folder, capture_output=True,
                              text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("older.h5: version = 2: must be 3 to 11, which this Plastica reads", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
