#!/usr/bin/env python3
"""Reads a result with h5py alone, as docs/hdf5.md documents it.

read_result_test.py COMMAND PAGE: runs the command on curves of its own, of which one is bad.
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy

from documented import undocumented, undocumented_keys

COMMAND, PAGE = sys.argv[1:3]

COLUMNS = {
    "fits": "name status reason file test measure loading target_status target_reason samples seed "
            "cost misfit_rms misfit_fraction misfit_word break_strain_total free_parameters",
    "characteristics": "youngs_modulus youngs_modulus_standard_error modulus_window_low "
                       "modulus_window_high modulus_method proof_offset proof_stress reh rel rm "
                       "strain_at_rm break_strain break_strain_plastic largest_strain broke "
                       "last_intact_strain last_intact_stress first_broken_strain break_rule",
    "parameters/yield_stress": "row role value standard_error noise_error sampling_error misfit_error "
                               "degrees_of_freedom interval_low interval_high start lower upper "
                               "logarithmic at_lower at_upper identified judged verdict "
                               "verdict_number",
}
LISTS = {
    "stages": "algorithm outcome evaluations cost",
    "corrections": "kind applied amount amount_units text",
    "repairs": "kind count text",
    "groups": "key value",
    "properties": "key value",
    "warnings/target": "text",
    "warnings/fit": "text",
}
UNITS = {
    "fits/cost": "Pa^2", "fits/misfit_rms": "Pa", "fits/misfit_fraction": "1",
    "characteristics/youngs_modulus": "Pa", "characteristics/rm": "Pa",
    "characteristics/break_strain": "1", "parameters/yield_stress/value": "Pa",
    "parameters/break_strain/value": "1", "curves/raw/strain": "1", "curves/raw/stress": "Pa",
    "curves/corrected/stress": "Pa", "curves/fitted/stress": "Pa", "evaluations/cost": "Pa^2",
    "meta/seconds": "s",
}
FIT = """[[target]]
files = "*-curve.csv"
strain = "Strain"
stress = "Stress"
table = { file = "info.csv", key = "id" }
group = ["lot"]
"""
TABLE = "id,lot\nexample-curve,A\nbad-curve,B\n"


class ReadResult(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.place.name)
        subprocess.run([COMMAND, "init", "fit"], cwd=folder, check=True, capture_output=True)
        (folder / "bad-curve.csv").write_text("Strain (%),Stress (MPa)\n0,low\n1,high\n")
        (folder / "info.csv").write_text(TABLE)
        (folder / "own.toml").write_text(FIT)
        ran = subprocess.run([COMMAND, "calibrate", "own.toml", "-o", "fit.h5"], cwd=folder,
                             capture_output=True, text=True)
        assert ran.returncode == 1, ran.stderr
        cls.file = h5py.File(folder / "fit.h5")

    @classmethod
    def tearDownClass(cls):
        cls.file.close()
        cls.place.cleanup()

    def text(self, path):
        return list(self.file[path].asstr()[:])

    def test_says_what_it_is(self):
        self.assertEqual(self.file.attrs["schema"], "plastica/fits")
        self.assertEqual(self.file.attrs["version"], 11)

    def test_has_a_row_for_each_target_by_name(self):
        self.assertEqual(self.text("fits/name"), ["bad-curve", "example-curve"])
        self.assertEqual(self.text("fits/status"), ["rejected", "fitted"])
        self.assertIn("low", self.text("fits/target_reason")[0])
        for group, columns in COLUMNS.items():
            for column in columns.split():
                self.assertEqual(self.file[group][column].shape, (2,), f"{group}/{column}")

    def test_has_the_lists_with_the_row_of_their_target(self):
        for group, columns in LISTS.items():
            size = self.file[group]["fit"].shape
            for column in columns.split():
                self.assertEqual(self.file[group][column].shape, size, f"{group}/{column}")
        self.assertEqual(list(self.file["groups/fit"]), [0, 1])
        self.assertEqual(self.text("groups/key"), ["lot", "lot"])
        self.assertEqual(self.text("groups/value"), ["B", "A"])
        self.assertIn(1, self.file["stages/fit"])

    def test_names_the_units(self):
        for path, units in UNITS.items():
            self.assertEqual(self.file[path].attrs["units"], units, path)

    def test_has_the_parameters_of_what_was_fitted(self):
        self.assertEqual(self.text("parameters/path"), [
            "material.youngs_modulus", "material.yield_stress", "material.break_strain"])
        for row, name in enumerate(("youngs_modulus", "yield_stress", "break_strain")):
            self.assertEqual(list(self.file["parameters"][name]["row"]), [-1, row])
        for name, truth in (("youngs_modulus", 200e9), ("yield_stress", 350e6), ("break_strain", 0.02)):
            group = self.file["parameters"][name]
            self.assertEqual(group.attrs["path"], "material." + name)
            self.assertEqual(self.text(f"parameters/{name}/role"), ["", "free"])
            self.assertTrue(numpy.isnan(group["value"][0]))
            self.assertAlmostEqual(group["value"][1] / truth, 1.0, delta=0.01)
            self.assertGreater(group["standard_error"][1], 0.0)

    def test_says_what_each_number_of_a_parameter_is(self):
        group = self.file["parameters/yield_stress"]
        for name in COLUMNS["parameters/yield_stress"].split():
            if name != "judged":
                self.assertTrue(group[name].attrs["meaning"], name)

    def test_has_the_curves_by_their_offsets(self):
        for kind in ("raw", "corrected", "fitted"):
            curve = self.file["curves"][kind]
            offsets = list(curve["offsets"])
            self.assertEqual(offsets[:2], [0, 0], kind)
            self.assertEqual(curve["strain"].shape, (offsets[2],), kind)
            self.assertEqual(curve["stress"].shape, (offsets[2],), kind)
        self.assertGreater(self.file["curves/raw/offsets"][2], 100)
        stress = self.file["curves/fitted/stress"][:]
        self.assertAlmostEqual(numpy.max(stress) / 350e6, 1.0, delta=0.01)

    def test_has_every_evaluation(self):
        cost = self.file["evaluations/cost"][:]
        values = self.file["evaluations/values"][:]
        offsets = list(self.file["evaluations/offsets"])
        self.assertEqual(offsets, [0, 0, len(cost)])
        self.assertEqual(values.shape, (len(cost), 3))
        found = [self.file["parameters"][name]["value"][1]
                 for name in ("youngs_modulus", "yield_stress", "break_strain")]
        best = numpy.flatnonzero((values == found).all(axis=1))
        self.assertGreater(len(best), 0)
        # The last searches were weighed with the elastic slope.
        fits = self.file["fits"]
        off = (found[0] - fits["prior_modulus"][1]) / fits["prior_modulus_error"][1]
        prior = fits["prior_variance"][1] * off ** 2
        self.assertEqual(fits["weighed_modulus"][1], 1)
        self.assertGreater(prior, 0.0)
        self.assertAlmostEqual(cost[best[-1]] / (fits["cost"][1] + prior), 1.0, delta=1e-9)
        self.assertAlmostEqual(cost.min() / fits["cost"][1], 1.0, delta=1e-3)
        self.assertEqual(list(self.file["correlation/offsets"]), [0, 0, 9])

    def test_keeps_the_input_texts_whole(self):
        self.assertEqual(self.text("inputs/name"), ["own.toml", "info.csv"])
        self.assertEqual(self.text("inputs/text"), [FIT, TABLE])

    def test_says_what_the_fits_were_told(self):
        options = self.file["options"]
        for name in "noise break_weight algorithm seed confidence global_evaluations".split():
            self.assertIn(name, options)
        self.assertEqual(options["objective"].asstr()[()], "path")
        self.assertEqual(self.text("options/parameters/path")[1], "material.yield_stress")
        self.assertEqual(options["setup/material/poisson_ratio"].attrs["units"], "1")

    def test_keeps_under_meta_what_may_differ(self):
        meta = self.file["meta"]
        for name in "start_time seconds host threads instruction_set command_line resumptions".split():
            self.assertIn(name, meta)
        self.assertIn("plastica", meta["versions"])

    def test_has_nothing_that_is_not_documented(self):
        found = undocumented(self.file, PAGE)
        self.assertGreater(found.seen, 80)
        self.assertEqual(found.names, [])


SCENE = """[beam]
length = "1 m"
segments = 4
[rules]
yield_model = "per_axis"
[solver]
steps = 5
[[support]]
at = "start"
kind = "clamp"
[[load]]
at = "end"
force = ["0 N", "-100 N", "0 N"]
[[region]]
from = 0.5
to = "end"
material = "S355"
[[probe]]
name = "tip"
kind = "displacement"
at = "end"
"""
SHAPES = {
    "probes/values": (1, 6), "path/time": (6,), "path/frame_sample": (6,), "energy/elastic": (6,),
    "energy/kinetic": (6,), "joints/moment": (6, 5, 3), "joints/position": (6, 5, 3),
    "joints/plastic_strain": (6, 5), "segments/rotation": (6, 4, 3), "reactions/wrench": (6, 1, 6),
    "beam/ends": (5,), "beam/node": (5, 3), "beam/axes": (4, 3, 3), "events/time": (0,),
    "events/joints/strain": (0,), "events/joints/moment": (0, 3), "events/fragments/first": (0,),
    "initial_motions/velocity": (0, 3), "cuts/time": (0,), "regions/from": (1,),
    "regions/material/name": (1,), "regions/material/youngs_modulus": (1,),
    "beam/width": (4,), "beam/modulus": (5, 3), "supports/held": (1, 6), "loads/force": (1, 3),
    "drive/strain": (0,),
}
SCENE_UNITS = {
    "joints/moment": "N m", "joints/stress": "Pa", "energy/residual": "J", "path/time": "s",
    "beam/modulus": "m^3", "beam/strain_per_angle": "1/rad", "segments/rotation": "rad",
}


class ReadScene(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.place.name)
        (folder / "beam.toml").write_text(SCENE)
        subprocess.run([COMMAND, "simulate", "beam.toml", "-o", "beam.h5", "--json", "beam.json"],
                       cwd=folder, check=True, capture_output=True)
        cls.file = h5py.File(folder / "beam.h5")
        cls.summary = json.loads((folder / "beam.json").read_text())

    @classmethod
    def tearDownClass(cls):
        cls.file.close()
        cls.place.cleanup()

    def test_says_what_it_is(self):
        self.assertEqual(self.file.attrs["schema"], "plastica/scene")
        self.assertEqual(self.file.attrs["version"], 3)
        self.assertEqual(self.file["outcome/status"].asstr()[()], "completed")
        self.assertEqual(self.file["scene/level"].asstr()[()], "planar")

    def test_has_arrays_of_the_documented_shapes_and_units(self):
        for path, shape in SHAPES.items():
            self.assertEqual(self.file[path].shape, shape, path)
        for path, units in SCENE_UNITS.items():
            self.assertEqual(self.file[path].attrs["units"], units, path)
        self.assertEqual(list(self.file["probes/value_units"].asstr()), ["m"])
        self.assertEqual(list(self.file["segments"]), ["rotation"], "a path at rest has no velocity")

    def test_holds_what_a_cantilever_does(self):
        file = self.file
        tip = file["probes/values"][list(file["probes/name"].asstr()).index("tip")]
        self.assertEqual(tip[-1], file["joints/position"][-1, -1, 1] - file["beam/node"][-1, 1])
        moment = file["joints/moment"][-1, :, 0]
        arm = file["joints/position"][-1, -1, 2] - file["joints/position"][-1, :, 2]
        numpy.testing.assert_allclose(moment, 100.0 * arm, rtol=1e-8, atol=1e-8)
        stress = numpy.abs(moment) / file["beam/modulus"][:, 0]
        numpy.testing.assert_allclose(file["joints/stress"][-1], stress, rtol=1e-12)
        # Elastic: strain times Young's modulus is the stress.
        strain = file["joints/angle"][-1, :, 0] * file["beam/strain_per_angle"][:, 0]
        modulus = file["options/setup/material/youngs_modulus"][()]
        numpy.testing.assert_allclose(numpy.abs(strain) * modulus, stress, rtol=1e-8, atol=1e-3)
        energy = {name: file["energy"][name][-1] for name in file["energy"]}
        rest = energy["external"] - sum(value for name, value in energy.items()
                                        if name not in ("external", "residual"))
        self.assertAlmostEqual(energy["residual"], rest, delta=1e-12 * energy["external"])

    def test_keeps_the_scene_whole(self):
        self.assertEqual(list(self.file["inputs/text"].asstr()), [SCENE])

    def test_has_nothing_that_is_not_documented(self):
        found = undocumented(self.file, PAGE)
        self.assertGreater(found.seen, 70)
        self.assertEqual(found.names, [])
        self.assertEqual(undocumented_keys(self.summary, PAGE), [])


MOTION = """[beam]
length = "1 m"
segments = 4
[solver]
analysis = "dynamics"
time_step = "0.5 ms"
duration = "0.1 s"
steps = 40
frames = 4
[[support]]
at = "start"
kind = "clamp"
[[load]]
at = "end"
force = ["0 N", "-100 N", "0 N"]
history = "constant"
[[initial_motion]]
from = 0.5
velocity = ["0 m/s", "1 m/s", "0 m/s"]
[[cut]]
at = 0.75
time = "25 ms"
[[cut]]
at = 0.5
time = "75 ms"
[[probe]]
name = "tip"
kind = "displacement"
at = "end"
"""
MOTION_SHAPES = {
    "probes/values": (1, 41), "path/time": (41,), "path/frame_sample": (5,),
    "energy/kinetic": (41,), "joints/position": (5, 5, 3), "joints/plastic_strain": (5, 5),
    "segments/rotation": (5, 4, 3), "segments/velocity": (5, 4, 3), "segments/spin": (5, 4, 3),
    "reactions/wrench": (5, 1, 6), "events/time": (2,),
    "events/joints/joint": (2,), "events/joints/moment": (2, 3), "events/fragments/first": (5,),
    "initial_motions/velocity": (1, 3), "cuts/time": (2,),
}


class ReadMotion(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.place.name)
        (folder / "beam.toml").write_text(MOTION)
        subprocess.run([COMMAND, "simulate", "beam.toml", "-o", "beam.h5"], cwd=folder, check=True,
                       capture_output=True)
        cls.file = h5py.File(folder / "beam.h5")

    @classmethod
    def tearDownClass(cls):
        cls.file.close()
        cls.place.cleanup()

    def test_has_arrays_of_the_documented_shapes(self):
        for path, shape in MOTION_SHAPES.items():
            self.assertEqual(self.file[path].shape, shape, path)
        self.assertEqual(self.file["segments/velocity"].attrs["units"], "m/s")
        self.assertEqual(self.file["segments/spin"].attrs["units"], "rad/s")

    def test_keeps_frames_apart_from_samples(self):
        file = self.file
        frames = file["path/frame_sample"][:]
        self.assertEqual(list(frames), [0, 10, 20, 30, 40])
        numpy.testing.assert_allclose(file["path/time"][:][frames], [0, 0.025, 0.05, 0.075, 0.1])
        tip = file["probes/values"][0][frames]
        # Position 4 is the outer end of the last segment.
        moved = file["joints/position"][:, -1, 1] - file["beam/node"][-1, 1]
        numpy.testing.assert_allclose(tip, moved, rtol=1e-12, atol=1e-15)

    def test_tells_the_cuts_and_the_fragments_after_each(self):
        file = self.file
        numpy.testing.assert_allclose(file["events/time"][:], [0.025, 0.075])
        self.assertEqual(list(file["events/joints/cause"].asstr()), ["cut", "cut"])
        self.assertEqual(list(file["events/joints/joint"]), [3, 2])
        self.assertEqual(list(file["events/joints/cut"]), [1, 1])
        fragments = file["events/fragments"]
        table = list(zip(fragments["event"], fragments["first"], fragments["last"]))
        self.assertEqual(table, [(0, 0, 2), (0, 3, 3), (1, 0, 1), (1, 2, 2), (1, 3, 3)])

    def test_has_energies_that_are_balanced(self):
        energy = {name: values[:] for name, values in self.file["energy"].items()}
        rest = energy["external"] - sum(values for name, values in energy.items()
                                        if name not in ("external", "residual"))
        largest = max(numpy.max(numpy.abs(values)) for values in energy.values())
        numpy.testing.assert_allclose(energy["residual"], rest, atol=1e-12 * largest)
        self.assertLess(self.file["outcome/energy_balance_error"][()], 0.01)

    def test_has_nothing_that_is_not_documented(self):
        self.assertEqual(undocumented(self.file, PAGE).names, [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
