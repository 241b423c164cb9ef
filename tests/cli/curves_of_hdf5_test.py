#!/usr/bin/env python3
"""Curves in HDF5 files of others, written by h5py in whatever layout, are fitted as the same numbers
in CSV files are, bit by bit; and what cannot be read is said.

curves_of_hdf5_test.py COMMAND
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy

COMMAND = sys.argv[1]


def curve(yield_stress, samples=120):
    """Strain [1] and stress [MPa] of a specimen, with digits that a decimal cut would change."""
    noise = numpy.random.default_rng(int(yield_stress))
    strain = numpy.linspace(0, 0.02, samples) * (1 + 1e-9 * noise.normal(size=samples))
    return strain, numpy.minimum(200e3 * strain, yield_stress) + noise.normal(0, 0.3, samples)


CURVES = {f"A-{i}": curve(250 + 7 * i) for i in range(3)}
COLUMNS = 'strain = { column = "strain" }\nstress = { column = "stress" }\n'
LOADS = ('elongation = { column = "travel", unit = "mm" }\nforce = { column = "load" }\n'
         'gauge_length = { from = "L0", unit = "mm" }\narea = { from = "S0", unit = "mm^2" }\n')


def by_name(result):
    """Name -> (raw strain, raw stress, value of the yield stress) of each fit; None: rejected."""
    with h5py.File(result) as file:
        fits = {}
        names = [name.decode() for name in file["fits/name"][:]]
        raw = file["curves/raw"]
        offsets = raw["offsets"][:]
        statuses = file["fits/status"][:]
        values = file["parameters/yield_stress/value"][:]
        for row, name in enumerate(names):
            part = slice(offsets[row], offsets[row + 1])
            value = values[row] if statuses[row] == b"fitted" else None
            fits[name] = (raw["strain"][part], raw["stress"][part], value)
        return fits


class Hdf5Curves(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.at = pathlib.Path(self.folder.name)

    def command(self, *words, code=0):
        done = subprocess.run([COMMAND, *words], cwd=self.at, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, code, done.stderr + done.stdout)
        return done.stdout + done.stderr

    def fit(self, block, code=0):
        """Fits one [[target]]; returns what was said, and the fits by name."""
        (self.at / "fit.toml").write_text("[[target]]\n" + block)
        said = self.command("calibrate", "fit.toml", "-o", "fit.h5", "--force", code=code)
        return said, by_name(self.at / "fit.h5") if code != 2 else {}

    def file(self, name="curves.h5"):
        return h5py.File(self.at / name, "w")

    def groups(self, file, **options):
        for name, (strain, stress) in CURVES.items():
            group = file.create_group(name)
            group.create_dataset("strain", data=strain, **options)
            group.create_dataset("stress", data=stress, **options).attrs["units"] = "MPa"

    def expect_as_csv(self, fits, name_of="curves:{}".format):
        for name, (strain, stress) in CURVES.items():
            rows = "".join(f"{e!r},{s!r}\n" for e, s in zip(strain.tolist(), stress.tolist()))
            (self.at / f"{name}.csv").write_text("strain,stress [MPa]\n" + rows)
        _, wanted = self.fit('files = "A-*.csv"\n' + COLUMNS)
        self.assertEqual(set(fits), {name_of(name) for name in CURVES})
        for name, (strain, _, value) in wanted.items():
            found = fits[name_of(name)]
            self.assertEqual(found[0].tobytes(), CURVES[name][0].tobytes())
            self.assertEqual(found[0].tobytes(), strain.tobytes())
            self.assertEqual(found[1].tobytes(), wanted[name][1].tobytes())
            self.assertIsNotNone(value)
            self.assertEqual(found[2], value)

    def test_a_group_for_each_specimen(self):
        for options in ({}, {"compression": "gzip", "shuffle": True, "fletcher32": True},
                        {"chunks": (7,), "maxshape": (None,)}, {"dtype": ">f8"}):
            with self.subTest(options):
                with self.file() as file:
                    self.groups(file, **options)
                self.expect_as_csv(self.fit('files = "curves.h5"\n' + COLUMNS)[1])

    def test_records(self):
        with self.file() as file:
            for name, (strain, stress) in CURVES.items():
                records = numpy.zeros(len(strain), dtype=[
                    ("time", "i4"), ("note", "S5"), ("stress [MPa]", "<f8"), ("strain", ">f8"),
                    ("pair", "f8", (2,))])
                records["strain"], records["stress [MPa]"] = strain, stress
                records["note"] = b"a\tb\"c"
                file[name] = records
        self.expect_as_csv(self.fit('files = "curves.h5"\n' + COLUMNS)[1])

    def test_two_dimensions(self):
        with self.file() as file:
            for name, columns in CURVES.items():
                table = file.create_dataset(name, data=numpy.column_stack(columns))
                table.attrs["columns"] = ["strain", "stress"]
                table.attrs["units"] = ["1", "MPa"]
        self.expect_as_csv(self.fit('files = "curves.h5"\n' + COLUMNS)[1])
        with self.file() as file:  # without names, by number
            for name, columns in CURVES.items():
                file[name] = numpy.column_stack(columns)
        self.expect_as_csv(self.fit('files = "curves.h5"\nstrain = "1"\n'
                                    'stress = { column = 2, unit = "MPa" }\n')[1])

    def test_one_table_that_is_split(self):
        with self.file() as file:
            file["specimen"] = [name.encode() for name in CURVES for _ in CURVES[name][0]]
            file["strain"] = numpy.concatenate([strain for strain, _ in CURVES.values()])
            file["stress"] = numpy.concatenate([stress for _, stress in CURVES.values()])
            file["stress"].attrs["unit"] = b"MPa"
        self.expect_as_csv(self.fit('files = "curves.h5"\nsplit = "specimen"\n' + COLUMNS)[1])

    def test_bare_file(self):
        with self.file() as file:
            self.groups(file)
        self.command("calibrate", "curves.h5", "-o", "fit.h5")
        self.expect_as_csv(by_name(self.at / "fit.h5"))
        self.assertIn("of its table A-0", self.command("inspect", "curves.h5"))

    def test_smaller_numbers_are_what_they_are(self):
        with self.file() as file:
            strain, stress = CURVES["A-0"]
            file["A/strain"], file["A/stress [MPa]"] = strain.astype("f4"), stress.astype("f2")
        _, fits = self.fit('files = "curves.h5"\n' + COLUMNS)
        raw = fits["curves:A"]
        self.assertTrue(numpy.array_equal(raw[0], strain.astype("f4").astype("f8")))
        self.assertTrue(numpy.allclose(raw[1], 1e6 * stress.astype("f2").astype("f8"), rtol=1e-15))

    def loads(self, file):
        for i, (name, (strain, stress)) in enumerate(CURVES.items()):
            group = file.create_group(f"heat {i % 2}/{name}")
            group["travel"] = strain * (50 + i)
            group["load"] = stress * (70 + i)
            group["load"].attrs["units"] = "N"
            group.attrs["S0"] = 70.0 + i
            group["L0"] = 50 + i
            group.attrs["list"] = [1, 2, 3]
        file["heat 0"].attrs["S0"] = 1.0  # the specimen's own is nearer
        file["heat 0"].attrs["heat"] = "H0"
        file["heat 1"].attrs["heat"] = "H1"

    def test_attributes_are_values_of_specimens(self):
        with self.file() as file:
            self.loads(file)
        said, fits = self.fit('files = "curves.h5"\ngroup = ["heat"]\n' + LOADS)
        self.assertIn("Group heat H0: 2 specimens", said)
        for i, (name, (strain, stress)) in enumerate(CURVES.items()):
            raw = fits[f"curves:heat {i % 2}/{name}"]
            self.assertTrue(numpy.allclose(raw[0], strain, rtol=1e-14, atol=0))
            self.assertTrue(numpy.allclose(raw[1], 1e6 * stress, rtol=1e-14, atol=1e-6))
        self.command("calibrate", "curves.h5", "--elongation", "travel:mm", "--load", "load",
                     "--gauge-length", "L0:mm", "--area", "S0:mm^2", "-o", "bare.h5")
        for name, fit in by_name(self.at / "bare.h5").items():
            self.assertEqual(fit[2], fits[name][2])

    def test_a_table_beside_the_curves(self):
        with self.file() as file:
            self.loads(file)
        info = numpy.array([(name, 70.0 + i, 50.0 + i) for i, name in enumerate(CURVES)],
                           dtype=[("specimen", "S8"), ("S0", "f8"), ("L0", "f8")])
        with self.file("info.h5") as file:
            file["of specimens/table"] = info
            file["other"] = numpy.zeros((2, 2))
        key = 'table = { file = "info.h5", key = "specimen", path = "of*" }\n'
        _, fits = self.fit('files = "curves.h5"\n' + LOADS + key)
        for i, (name, (_, stress)) in enumerate(CURVES.items()):
            raw = fits[f"curves:heat {i % 2}/{name}"]
            self.assertTrue(numpy.allclose(raw[1], 1e6 * stress, rtol=1e-14, atol=1e-6))
        # A last name that two specimens have is the key of neither.
        with h5py.File(self.at / "curves.h5", "a") as file:
            file.copy("heat 0/A-0", "heat 1/A-0")
        said, fits = self.fit('files = "curves.h5"\n' + LOADS + key, code=1)
        self.assertEqual([name for name, fit in fits.items() if fit[2] is None],
                         ["curves:heat 0/A-0", "curves:heat 1/A-0"])
        self.assertIn("has no row in the table", said)

    def test_paths_choose(self):
        with self.file() as file:
            self.loads(file)
        for path in ("heat 0/*", "*A-[", "/heat 0/A-2"):
            found = [f"curves:heat 0/{name}" for name in ("A-0", "A-2")]
            code = 2 if "[" in path else 0
            said, fits = self.fit(f'files = "curves.h5"\npath = "{path}"\n' + LOADS, code=code)
            if code:
                self.assertIn('path = *A-[: matches none of its tables: heat 0/A-0, ', said)
            else:
                self.assertEqual(list(fits), found if path.endswith("*") else found[1:])

    def rejected(self, file_of, why, block=COLUMNS):
        """One table that cannot be read, beside three that can."""
        with self.file() as file:
            self.groups(file)
            file_of(file)
        said, fits = self.fit('files = "curves.h5"\n' + block, code=1)
        self.assertIn(why, " ".join(said.split()))
        self.assertEqual(fits.pop("curves:B")[2], None)
        self.expect_as_csv(fits)

    def test_bad_tables_are_rejected_alone(self):
        strain, stress = CURVES["A-0"]

        def unlike(file):
            file["B/strain"], file["B/stress"] = strain, stress[1:]
        self.rejected(unlike, "B: has columns of unlike lengths: strain 120, stress 119")

        def two_units(file):
            file["B/strain"], file["B/stress [kPa]"] = strain, stress
            file["B/stress [kPa]"].attrs["units"] = "MPa"
        self.rejected(two_units, "is in kPa by its name and in MPa by its attribute")

        def without_unit(file):
            file["B/strain"], file["B/stress"] = strain, stress
        self.rejected(without_unit, "stress")

        def other_filter(file):
            file["B/strain"] = strain
            file.create_dataset("B/stress", data=stress, compression="lzf")
        self.rejected(other_filter, "is stored with another filter than deflate, shuffle")

        def infinite(file):
            file["B/strain"], file["B/stress"] = strain, numpy.where(strain > 0.01, numpy.inf, stress)
            file["B/stress"].attrs["units"] = "MPa"
        self.rejected(infinite, "is not a number")

        def elsewhere(file):
            with self.file("other.h5") as other:
                other["stress"] = stress
            layout = h5py.VirtualLayout(shape=stress.shape, dtype="f8")
            layout[:] = h5py.VirtualSource(self.at / "other.h5", "stress", shape=stress.shape)
            file["B/strain"] = strain
            file.create_virtual_dataset("B/stress", layout)
        self.rejected(elsewhere, "has its values in another file, which is not followed")

    def test_missing_numbers_are_missing_rows(self):
        with self.file() as file:
            strain, stress = CURVES["A-0"]
            file["strain"], file["stress [MPa]"] = strain, stress
            file["stress [MPa]"][[5, 50]] = numpy.nan
        said, fits = self.fit('files = "curves.h5"\n' + COLUMNS)
        self.assertIn("2 samples     rows dropped that lack one of the two numbers", said)
        self.assertIsNotNone(fits["curves"][2])

    def test_links_are_not_followed_and_end(self):
        with self.file() as file:
            self.groups(file)
            file["soft"] = h5py.SoftLink("/A-0")
            file["far"] = h5py.ExternalLink("other.h5", "/A-0")
            file["A-0/back"] = file["/"]
        self.expect_as_csv(self.fit('files = "curves.h5"\n' + COLUMNS)[1])

    def test_tables_that_are_unlike_need_blocks(self):
        with self.file() as file:
            self.groups(file)
            file["B/strain"], file["B/stress"] = CURVES["A-0"]
            file["B/stress"].attrs["units"] = "Pa"
            file["C/time"], file["C/temperature"] = CURVES["A-0"]
        said = self.command("calibrate", "curves.h5", "-o", "fit.h5", code=2)
        self.assertIn("the tables A-0 and B have unlike columns", said)

    def test_files_without_curves_are_refused(self):
        with self.file() as file:
            file["x"] = [1.0, 2.0]
        self.assertIn("holds no table", self.command("calibrate", "curves.h5", "-o", "x.h5", code=2))
        with self.file() as file:
            self.groups(file)
        whole = (self.at / "curves.h5").read_bytes()
        (self.at / "curves.h5").write_bytes(whole[:len(whole) // 2])
        said = self.command("calibrate", "curves.h5", "-o", "x.h5", code=2)
        self.assertIn("curves.h5: is damaged: ", said)
        (self.at / "curves.h5").write_bytes(whole)
        self.command("calibrate", "curves.h5", "-o", "result.h5")
        said, _ = self.fit('files = "result.h5"\n' + COLUMNS, code=1)
        self.assertIn("is a result file, no file of measured curves", " ".join(said.split()))
        self.assertIn("sheet = x: is of workbooks",
                      self.command("calibrate", "curves.h5", "--sheet", "x", "-o", "x.h5", code=2))
        (self.at / "A.csv").write_text("strain,stress [MPa]\n0,0\n")
        self.assertIn("path = x: is of HDF5 files",
                      self.command("calibrate", "A.csv", "--path", "x", "-o", "x.h5", code=2))
        self.assertFalse((self.at / "x.h5").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
