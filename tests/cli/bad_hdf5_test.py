#!/usr/bin/env python3
"""What cannot be read of HDF5 files of others is said, and costs no other specimen.

bad_hdf5_test.py COMMAND
"""

import subprocess
import sys
import unittest

import h5py
import numpy

from hdf5_curves import COLUMNS, COMMAND, CURVES, LOADS, Hdf5Curves, by_name


class BadFiles(Hdf5Curves):
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

        def unwritten(file):
            file["B/strain"] = strain
            file.create_dataset("B/stress", (120,), "f8", chunks=(10,))[:60] = stress[:60]
            file["B/stress"].attrs["units"] = "MPa"
        self.rejected(unwritten, "has values that were never written")

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

    def test_a_path_of_two_files_is_no_key(self):
        for lot in ("lot1.h5", "lot2.h5"):
            with self.file(lot) as file:
                self.loads(file)
        with self.file("info.h5") as file:
            file["info"] = numpy.array([(b"heat 0/A-0", 70.0, 50.0), (b"lot1:heat 0/A-2", 72.0, 52.0)],
                                       dtype=[("specimen", "S20"), ("S0", "f8"), ("L0", "f8")])
        key = 'table = { file = "info.h5", key = "specimen" }\n'
        _, fits = self.fit('files = "lot*.h5"\n' + LOADS + key, code=1)
        self.assertEqual([name for name, fit in fits.items() if fit[2] is not None],
                         ["lot1:heat 0/A-2"])

    def test_what_is_no_table_is_left_out(self):
        with self.file() as file:
            self.groups(file)
            file["image"] = numpy.zeros((40, 50))
            file["complex"] = numpy.zeros(120, dtype=complex)
            file["words/a"], file["words/b"] = [b"x", b"y"], [b"z"]
            file["large"] = numpy.zeros((0, 3))
            file.attrs["schema"] = "of others"
        self.expect_as_csv(self.fit('files = "curves.h5"\n' + COLUMNS)[1])

    def test_a_path_that_one_file_lacks_is_its_error(self):
        with self.file("curves.h5") as file:
            self.groups(file)
        with self.file("other.h5") as file:
            file["x/strain"], file["x/stress"] = CURVES["A-0"]
        said, fits = self.fit('files = ["curves.h5", "other.h5"]\npath = "A-*"\n' + COLUMNS, code=1)
        self.assertIn("other.h5: path = A-*: matches none of its tables: x", " ".join(said.split()))
        self.assertIsNone(fits.pop("other")[2])
        self.expect_as_csv(fits)

    def test_many_files_are_not_open_at_once(self):
        (name, (strain, stress)), *_ = CURVES.items()
        for i in range(40):
            with self.file(f"one-{i:02}.h5") as file:
                file["strain"], file["stress [MPa]"] = strain, stress
        (self.at / "fit.toml").write_text('[[target]]\nfiles = "one-*.h5"\n' + COLUMNS)
        said = subprocess.run(["sh", "-c", f"ulimit -n 24; '{COMMAND}' calibrate fit.toml -o x.h5"],
                              cwd=self.at, capture_output=True, text=True)
        self.assertEqual(said.returncode, 0, said.stderr + said.stdout)

    def test_damage_is_said_in_a_line(self):
        with self.file() as file:
            self.groups(file, fletcher32=True)
        content = bytearray((self.at / "curves.h5").read_bytes())
        at = content.find(CURVES["A-1"][1].tobytes()[:64])
        content[at + 100] ^= 1
        (self.at / "curves.h5").write_bytes(content)
        (self.at / "fit.toml").write_text('[[target]]\nfiles = "curves.h5"\n' + COLUMNS)
        done = subprocess.run([COMMAND, "calibrate", "fit.toml", "-o", "fit.h5", "--threads", "2"],
                              cwd=self.at, capture_output=True, text=True)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(done.stderr, "wrote fit.h5\n")
        self.assertEqual([name for name, fit in by_name(self.at / "fit.h5").items()
                          if fit[2] is None], ["curves:A-1"])

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
