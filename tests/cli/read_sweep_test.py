#!/usr/bin/env python3
"""Reads the result of a sweep with h5py alone, as docs/hdf5.md documents it.

read_sweep_test.py COMMAND PAGE
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy

from documented import undocumented

COMMAND, PAGE = sys.argv[1:3]

SWEEP = """scene = "cantilever.toml"

[[axis]]
field = "beam.segments"
values = [4, 8, 16]

[[axis]]
field = "rules.hinge_length"
values = ["unset", "30 mm"]

[[axis]]
field = "rules.end_rule"
values = ["half_joint", "equal"]

[error]
probe = "tip"
"""
AGAINST = 'against = "theory:elastica"\n'
CURVE = 'take = "curve"\nagainst = "finest"\n'
CASE_UNITS = {
    "position": None, "status": None, "reason": None, "level": None, "value": "m",
    "standard_error": "m", "reference": "m", "error": "1", "error_reason": None,
    "error_lacks": None, "coarser_in": None, "reference_error": "1", "break_joint": None,
    "break_place": "1", "segments": "1",
    "iterations": "1", "cutbacks": "1", "segment_iterations": "1", "energy_balance_error": "1",
    "last_time": "s", "last_value": "m", "axes/beam.segments": "1", "axes/rules.hinge_length": "m",
    "axes/rules.end_rule": None,
}


class ReadSweep(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.place.name)
        subprocess.run([COMMAND, "init", "sweep"], cwd=folder, check=True, capture_output=True)
        cls.files = []
        for name, error in (("number", AGAINST), ("curve", CURVE)):
            (folder / f"{name}.toml").write_text(SWEEP + error)
            subprocess.run([COMMAND, "sweep", f"{name}.toml"], cwd=folder, check=True,
                           capture_output=True)
            cls.files.append(h5py.File(folder / f"{name}.h5"))
        cls.file = cls.files[0]

    @classmethod
    def tearDownClass(cls):
        for file in cls.files:
            file.close()
        cls.place.cleanup()

    def test_says_what_it_is(self):
        self.assertEqual(self.file.attrs["schema"], "plastica/sweep")
        self.assertEqual(self.file.attrs["version"], 3)
        head = self.file["sweep"].attrs
        self.assertEqual([head[key] for key in ("name", "quantity_kind", "take", "unit", "dimension",
                                                "against", "refined_axis")],
                         ["number", "probe", "end", "m", "length", "theory:elastica", 0])
        self.assertNotIn("error_scale", head)

    def test_has_a_row_for_each_case(self):
        cases = self.file["cases"]
        self.assertEqual(len(set(cases["id"].asstr())), 12)
        for path, units in CASE_UNITS.items():
            self.assertEqual(len(cases[path]), 12, path)
            self.assertEqual(cases[path].attrs.get("units"), units, path)

    def test_has_the_axes_with_the_last_one_fastest(self):
        file = self.file
        self.assertEqual([file[f"axes/{a}"].attrs["field"] for a in range(3)],
                         ["beam.segments", "rules.hinge_length", "rules.end_rule"])
        position = file["cases/position"][:]
        self.assertEqual([list(row) for row in position[:3]], [[0, 0, 0], [0, 0, 1], [0, 1, 0]])
        segments = file["axes/0/values"][:][position[:, 0]]
        self.assertEqual(list(file["cases/axes/beam.segments"]), list(segments))
        self.assertTrue(numpy.isnan(file["cases/axes/rules.hinge_length"][0]))
        self.assertEqual(list(file["cases/axes/rules.end_rule"].asstr()[:2]), ["half_joint", "equal"])

    def test_has_errors_over_the_reference(self):
        cases = {name: self.file["cases"][name][:] for name in ("value", "reference", "error")}
        numpy.testing.assert_allclose(
            cases["error"], (cases["value"] - cases["reference"]) / abs(cases["reference"]),
            rtol=1e-12)

    def test_has_groups_whose_order_can_be_seen(self):
        groups = self.file["groups"]
        labels = list(groups["label"].asstr())
        self.assertEqual(len(labels), 4)
        for g, order in ((0, 2.0), (1, 1.0)):
            rows = slice(*groups["cases/offsets"][g:g + 2])
            error = abs(self.file["cases/error"][:][groups["cases/values"][rows]])
            fitted = numpy.polyfit(numpy.log(groups["size/values"][rows]), numpy.log(error), 1)[0]
            self.assertAlmostEqual(fitted, order, delta=0.1, msg=labels[g])

    def test_has_the_curves_by_their_offsets(self):
        curves = self.files[1]["curves"]
        offsets = list(curves["value/offsets"])
        self.assertEqual(offsets, list(range(0, 13 * 21, 21)))
        self.assertEqual(list(curves["time/offsets"]), offsets)
        last = self.files[1]["cases/last_value"][:]
        numpy.testing.assert_array_equal(curves["value/values"][:][20::21], last)
        self.assertNotIn("curves", self.file)

    def test_has_nothing_that_is_not_documented(self):
        for file in self.files:
            self.assertEqual(undocumented(file, PAGE).names, [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
