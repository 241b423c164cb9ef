#!/usr/bin/env python3
"""Curves in HDF5 files of others, written by h5py in whatever layout, are fitted as the same numbers
in CSV files are, bit by bit.

curves_of_hdf5_test.py COMMAND
"""

import sys
import unittest

import h5py
import numpy

from hdf5_curves import COLUMNS, CURVES, LOADS, Hdf5Curves, by_name


class Layouts(Hdf5Curves):
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
                file[name].attrs["units"] = ["s", "", "MPa", "", ""]
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

    def test_tables_of_few_wide_rows(self):
        with self.file() as file:
            self.loads(file)
        fields = [("note", "S40"), ("S0", "f8"), ("specimen", "i8"), ("L0", "f4"), ("end", "S200")]
        rows = [(b"N", 70.0 + i, 100000 + i, 50.0 + i, b"x") for i in range(3)]
        with self.file("curves.h5") as file:
            for i, (strain, stress) in enumerate(CURVES.values()):
                group = file.create_group(str(100000 + i))
                group["travel"], group["load"] = strain * (50 + i), stress * (70 + i)
                group["load"].attrs["units"] = "N"
        with self.file("info.h5") as file:
            file["info"] = numpy.array(rows, dtype=fields)
        key = 'table = { file = "info.h5", key = "specimen" }\ngroup = ["note"]\n'
        said, fits = self.fit('files = "curves.h5"\n' + LOADS + key)
        self.assertIn("Group note N: 3 specimens", said)
        for i, (_, stress) in enumerate(CURVES.values()):
            raw = fits[f"curves:{100000 + i}"]
            self.assertTrue(numpy.allclose(raw[1], 1e6 * stress, rtol=1e-14, atol=1e-6))

    def test_values_stand_in_any_shape(self):
        with self.file() as file:
            for i, (name, (strain, stress)) in enumerate(CURVES.items()):
                group = file.create_group(name)
                group["travel"] = strain.reshape(-1, 1) * 50
                group["load"] = stress.reshape(1, -1) * 70
                group["load"].attrs["units"] = "[N]"
                group["S0"] = [[70]]
                group.attrs["L0 [mm]"] = numpy.array([50.0])
                group.attrs["comment"] = h5py.Empty("S1")
                group.attrs["heat"] = 100000
        file = h5py.File(self.at / "curves.h5", "a")
        file.attrs["L0"], file.attrs["long"] = 1.0, "x" * 60000
        file.close()
        said, fits = self.fit('files = "curves.h5"\ngroup = ["heat"]\n' +
                              LOADS.replace(', unit = "mm" }\narea', ' }\narea'))
        self.assertIn("Group heat 100000: 3 specimens", said)
        for name, (strain, stress) in CURVES.items():
            raw = fits[f"curves:{name}"]
            self.assertTrue(numpy.allclose(raw[0], strain, rtol=1e-14, atol=0))
            self.assertTrue(numpy.allclose(raw[1], 1e6 * stress, rtol=1e-14, atol=1e-6))

    def test_rows_are_no_comments_and_no_units(self):
        with self.file() as file:
            for name, (strain, stress) in CURVES.items():
                group = file.create_group(name)
                group["a note"] = [b"MPa"] + [b"#x"] * (len(strain) - 1)
                group["strain"] = strain
                group["stress"] = stress
                group["stress"].attrs["units"] = "MPa"
                group.attrs["heat"] = "N"
        said, fits = self.fit('files = "curves.h5"\ngroup = ["heat"]\n' + COLUMNS)
        self.assertIn("Group heat N: 3 specimens", said)
        self.expect_as_csv(fits)

    def test_missing_numbers_are_missing_rows(self):
        with self.file() as file:
            strain, stress = CURVES["A-0"]
            file["strain"], file["stress [MPa]"] = strain, stress
            file["stress [MPa]"][[5, 50]] = numpy.nan
        said, fits = self.fit('files = "curves.h5"\n' + COLUMNS)
        self.assertIn("2 samples     rows dropped that lack one of the two numbers", said)
        self.assertIsNotNone(fits["curves"][2])

    def test_packed_numbers_are_what_they_stand_for(self):
        """As netCDF-4 and loggers store them."""
        strain, stress = CURVES["A-0"]
        packed = numpy.round(stress / 0.05).astype("i2")
        packed[[7, 60]] = -32768
        with self.file() as file:
            file["A/strain"] = strain
            file["A/stress [MPa]"] = packed
            file["A/stress [MPa]"].attrs.update(scale_factor=0.05, add_offset=0.0,
                                                _FillValue=numpy.int16(-32768))
            file["B"] = numpy.column_stack([strain, stress]) / 4
            file["B"].attrs.update(columns=["strain", "stress"], units=["1", "MPa"], scale_factor=4)
            file["C/strain"] = strain / 2 - 0.5
            file["C/strain"].attrs.update(scale_factor=[2.0], add_offset=1.0)
            file["C/stress [MPa]"] = stress
            # An attribute of another type, as h5py writes a plain number, beside what nobody reads.
            file["D/strain"] = strain
            holes = stress.astype("f4")
            holes[[3, 90]] = -9999.9
            holes[40] = 1e9
            file["D/stress [MPa]"] = holes
            file["D/stress [MPa]"].attrs.update(missing_value=[-9999.9, -1e30], valid_max=1e4)
            file["D/temperature"] = numpy.zeros(len(strain))
            file["D/temperature"].attrs["missing_value"] = [1.0, 2.0]
            # Bytes above 127, as netCDF's third version stores them.
            file["E/strain"] = strain
            file["E/stress [MPa]"] = numpy.round(stress).astype("u1").astype("i1")
            file["E/stress [MPa]"].attrs.update(_Unsigned="true", missing_value=1e9)  # none has that
        said, fits = self.fit('files = "curves.h5"\n' + COLUMNS)
        for case, rows in (("A", 2), ("D", 3)):
            self.assertIn(f"{rows} samples     rows dropped that lack one of the two numbers",
                          self.command("show", "fit.h5", "--case", f"curves:{case}"))
        self.assertEqual(set(numpy.flatnonzero(numpy.isnan(fits["curves:D"][1]))), {3, 40, 90})
        self.assertTrue(numpy.array_equal(fits["curves:E"][0], strain))
        self.assertTrue(numpy.allclose(fits["curves:E"][1],
                                       1e6 * numpy.round(stress).astype("u1"), rtol=1e-12))
        raw = fits["curves:A"]
        self.assertTrue(numpy.isnan(raw[1][[7, 60]]).all())
        there = ~numpy.isnan(raw[1])
        self.assertTrue(numpy.allclose(raw[1][there], 0.05e6 * packed[there], rtol=1e-12))
        self.assertTrue(numpy.array_equal(fits["curves:B"][0], strain))
        self.assertTrue(numpy.allclose(fits["curves:C"][0], strain, rtol=0, atol=1e-15))
        with self.file() as file:
            file["strain"], file["stress [MPa]"] = strain, stress
            file["strain"].attrs["scale_factor"] = "two"
        self.assertIn("/strain/scale_factor: must be one number",
                      self.fit('files = "curves.h5"\n' + COLUMNS, code=1)[0])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
