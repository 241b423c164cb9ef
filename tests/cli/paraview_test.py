#!/usr/bin/env python3
"""`plastica export --to vtkhdf` and xdmf: files by VTK's specification, read without our code and
without VTK's, with the numbers that the result has.

paraview_test.py COMMAND DATA
"""

import os
import sys
import unittest
import xml.etree.ElementTree as ElementTree

import h5py
import numpy

from vtkhdf_files import ARCH, COUPON, Exported, Step, TOPOLOGIES, run


class Paraview(Exported):
    def test_has_the_attributes_and_types_of_the_specification(self):
        kind = self.root.attrs.get_id("Type").get_type()
        self.assertFalse(kind.is_variable_str(), "VTK reads a text of fixed length alone")
        self.assertEqual(kind.get_cset(), 0, "ASCII")
        self.assertEqual(self.root.attrs["Type"], b"PolyData")
        self.assertEqual(list(self.root.attrs["Version"]), [2, 0])
        steps = self.root["Steps"]
        self.assertEqual(steps.attrs["NSteps"], len(steps["Values"]))
        for name in TOPOLOGIES:
            for part in ("NumberOfCells", "NumberOfConnectivityIds", "Connectivity", "Offsets"):
                self.assertEqual(self.root[name][part].dtype.kind, "i")

    def test_shows_every_frame_of_the_result(self):
        with h5py.File(self.result) as result:
            times = result["path/time"][:][result["path/frame_sample"][:]]
            position = result["joints/position"][:]
            strain = result["joints/plastic_strain"][:]
            moment = result["joints/moment"][:]
            nodes = result["beam/node"][:]
        steps = self.root["Steps"]
        numpy.testing.assert_array_equal(steps["Values"][:], times)
        first = None
        for number in range(len(times)):
            step = Step(self.root, number)
            quads = numpy.array(step.cells["Polygons"])
            self.assertEqual(quads.shape[1], 4)
            self.assertEqual(sorted(set(quads.ravel())), list(range(len(step.points))))
            joint = step.cell_data["joint"]
            numpy.testing.assert_allclose(step.cell_data["plastic_strain"], strain[number][joint], 1e-6)
            numpy.testing.assert_allclose(
                step.cell_data["moment"], moment[number][joint], rtol=1e-6, atol=1e-3
            )
            # The beam's start: the mean of the corners of the first ring.
            ring = step.cells["Polygons"][0]
            segment = step.cell_data["segment"]
            count = len(step.points) // (segment.max() + 1) // 3
            numpy.testing.assert_allclose(
                step.points[:count].mean(axis=0), position[number][0], atol=1e-6
            )
            moved = step.points - step.point_data["displacement"]
            if first is None:
                first = moved
                numpy.testing.assert_allclose(moved[:count].mean(axis=0), nodes[0], atol=1e-6)
            numpy.testing.assert_allclose(moved, first, atol=2e-6)
            self.assertTrue(ring.min() >= 0)
        self.assertEqual(Step(self.root, 0).cell_data["fragment"].max(), 0)
        self.assertGreater(step.cell_data["fragment"].max(), 0, "it breaks")

    def test_xdmf_names_the_same_numbers(self):
        said = run("export", self.result, "-o", self.path("old.xdmf"))
        self.assertIn("old.vtkhdf, beside it", said)
        grids = ElementTree.parse(self.path("old.xdmf")).findall("./Domain/Grid/Grid")
        with h5py.File(self.path("old.vtkhdf")) as file:
            root = file["VTKHDF"]
            self.assertEqual(len(grids), root["Steps"].attrs["NSteps"])
            for number in (0, len(grids) - 1):
                grid = grids[number]
                step = Step(root, number)
                self.assertEqual(float(grid.find("Time").get("Value")), root["Steps/Values"][number])
                numpy.testing.assert_array_equal(
                    self.numbers(file, grid.find("Geometry/DataItem")), step.points
                )
                numpy.testing.assert_array_equal(
                    self.numbers(file, grid.find("Topology/DataItem")).reshape(-1, 4),
                    numpy.array(step.cells["Polygons"]),
                )
                named = {a.get("Name"): a for a in grid.findall("Attribute")}
                of_all = {**step.cell_data, **step.point_data}
                self.assertEqual(set(named), set(of_all))
                for name, data in of_all.items():
                    found = self.numbers(file, named[name].find("DataItem"))
                    numpy.testing.assert_array_equal(found, data)

    def numbers(self, file, item):
        """What an item of HDF5 selects: "FILE:/DATASET|first:stride:count:shape"."""
        where = item.text.split(":", 1)[1]
        shape = [int(n) for n in item.get("Dimensions").split()]
        if "|" not in where:
            data = file[where][:]
        else:
            where, selected = where.split("|")
            first, stride, count, whole = [
                [int(n) for n in part.split()] for part in selected.split(":")
            ]
            self.assertEqual(list(file[where].shape), whole)
            self.assertTrue(all(s == 1 for s in stride))
            data = file[where][tuple(slice(f, f + c) for f, c in zip(first, count))]
        self.assertEqual(list(data.shape), shape)
        kinds = {"Int": "i", "Float": "f"}
        self.assertEqual(data.dtype.kind, kinds[item.get("NumberType")])
        self.assertEqual(data.dtype.itemsize, int(item.get("Precision")))
        return data

    def test_numbers_steps_whose_times_fall(self):
        """A flat arch that snaps through: its load, which is the time, falls and rises again."""
        scene = self.path("arch.toml")
        with open(scene, "w", encoding="utf-8") as file:
            file.write(ARCH)
        run("simulate", scene, "-o", self.path("arch.h5"))
        said = run("export", self.path("arch.h5"), "-o", self.path("arch.xdmf"))
        self.assertIn("the steps are numbered", said)
        with h5py.File(self.path("arch.h5")) as result:
            times = result["path/time"][:][result["path/frame_sample"][:]]
        self.assertTrue((numpy.diff(times) < 0).any())
        with h5py.File(self.path("arch.vtkhdf")) as file:
            steps = list(file["VTKHDF/Steps/Values"][:])
            for group in ("PointData", "Steps/PointDataOffsets"):
                self.assertEqual(list(file["VTKHDF"][group]), ["displacement"], "it is at rest")
        self.assertEqual(steps, list(range(len(times))))
        grids = ElementTree.parse(self.path("arch.xdmf")).findall("./Domain/Grid/Grid/Time")
        self.assertEqual([float(grid.get("Value")) for grid in grids], steps)

    def test_two_texts_of_one_stem_do_not_share_their_numbers(self):
        for name in ("run.1", "run.2"):
            run("export", self.result, "--to", "xdmf", "-o", self.path(name))
            self.assertTrue(os.path.exists(self.path(name + ".vtkhdf")))

    def test_refuses_what_has_no_beam_and_what_is_no_file(self):
        coupon = self.path("coupon.toml")
        with open(coupon, "w", encoding="utf-8") as file:
            file.write(COUPON)
        run("simulate", coupon, "-o", self.path("coupon.h5"))
        cases = (
            (("export", self.path("coupon.h5"), "-o", self.path("c.vtkhdf")), "a coupon has no beam to show"),
            (("export", self.result, "--to", "vtkhdf"), "must be a file"),
            *(
                (("export", self.result, "--to", "xdmf", "-o", self.path(name)), "no colon")
                for name in ("a:b.xdmf", "a|b.xdmf", "a\\b.xdmf", " a.xdmf")
            ),
            (("export", self.result, "--time", "1 ms", "-o", self.path("t.vtkhdf")), "--time"),
            (("export", self.result, "--what", "joints", "-o", self.path("w.vtkhdf")), "--what"),
            (("export", self.result, "-o", self.path("crash.vtkhdf")), "--force"),
            (("export", self.result, "--to", "xdmf", "-o", self.path("a.csv")), "must not end in"),
        )
        for arguments, words in cases:
            said = run(*arguments, code=2)
            self.assertIn(words, said)
            self.assertEqual(said.count("\n"), 1, said)
        for left in ("c.vtkhdf", "t.vtkhdf", "w.vtkhdf", "a.csv"):
            self.assertFalse(os.path.exists(self.path(left)))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
