"""Fits through scenes: of a fit file as the command's, of arrays the same."""

import dataclasses
import unittest

import numpy as np
import pandas

import plastica
from support import DATA, TestCase, cantilever, command


class BeamFits(TestCase):
    def test_a_fit_through_a_scene_is_the_command_s(self):
        command("calibrate", DATA / "fits" / "bend_test.toml", "-o", self.folder / "a.h5", "--quiet")
        fits = plastica.fit(DATA / "fits" / "bend_test.toml")
        fits.save(self.folder / "b.h5")
        self.assertSameFiles(self.folder / "a.h5", self.folder / "b.h5")
        fit = fits[0]
        target = next(iter(fit.targets.values()))
        self.assertEqual(target["fitted"].shape, target["ordinate"].shape)
        self.assertIn("yield_stress", fit.segments)
        self.assertRefuses(lambda: fit.measured, "through scenes")

    def test_a_beam_test_in_arrays_is_that_of_the_fit_file(self):
        table = pandas.read_csv(DATA / "targets" / "bend_test.csv")
        scene = plastica.Scene.from_toml(DATA / "scenes" / "bend_test.toml")
        test = plastica.BeamTest(
            scene=scene.changed({"beam.segments": 32}), abscissa=1e-3 * table.iloc[:, 0],
            ordinate=table.iloc[:, 1], probe="force", against="support[2]", ordinate_factor=-1)
        parameters = {"youngs_modulus": (50e9, 500e9), "yield_stress": (100e6, 2e9),
                      "break_strain": (1e-4, "100 %")}
        ours = plastica.fit_scenes({"bend_test": test}, parameters)[0]
        theirs = plastica.fit(DATA / "fits" / "bend_test.toml")[0]
        for name, one in theirs.parameters.items():
            # 1e-3 x and x mm differ in the last bit.
            self.assertAlmostEqual(ours.parameters[name].value / one.value, 1.0, delta=1e-6)
        for change, words in (
            ({"ordinate": [1.0]}, ("as many",)),
            ({"probe": "forze"}, ("test.probe", "force")),
            ({"against": "support[9]"}, ("test.against", "support[9]")),
            ({"abscissa": [[1.0]]}, ("one row",)),
        ):
            wrong = dataclasses.replace(test, **change)
            error = self.assertRefuses(lambda w=wrong: plastica.fit_scenes(w, parameters), *words)
            self.assertIsNone(error.file)
        self.assertRefuses(lambda: plastica.fit_scenes(test, {"yeild_stress": (1e8, 2e9)}),
                           "yield_stress")
        self.assertRefuses(lambda: plastica.fit_scenes(test, ["yield_stress"]), "bound")
        self.assertRefuses(lambda: plastica.fit_scenes({}, parameters), "no test")
        self.assertRefuses(lambda: plastica.fit_scenes({"": test}, parameters), "name")
        self.assertRefuses(lambda: plastica.fit_scenes(test, parameters,
                                                       options={"parameters": {}}), "argument")

    def test_names_of_beam_tests_are_no_patterns(self):
        scene = cantilever(
            supports=[plastica.Support(kind="clamp", at="start"), plastica.Support(
                kind="roller", at="end", hold=["y"], translation=[0.0, -0.01, 0.0],
                rotation=[0.0, 0.0, 0.0])],
            loads=[], beam=plastica.Beam(length=1.0, segments=6),
            probes=[plastica.Probe(name="force", kind="reaction", component="y")])
        done = plastica.simulate(scene)
        way, force = 0.01 * done.factor, -done.probes["force"]

        def made(factor):
            return plastica.BeamTest(scene=scene, abscissa=way, ordinate=factor * force,
                                     probe="force", against="support[2]", ordinate_factor=-1)
        tests = {"{A,B}": made(1.3), "A": made(1.0), "B*": made(1.0), "a/b[1]": made(1.0)}
        how = {"options": {"starts": 1, "screen": 0, "segments_error": False}}
        shared = plastica.fit_scenes(tests, {"youngs_modulus": (1e11, 4e11)}, **how)
        self.assertEqual(list(shared[0].targets), list(tests))
        self.assertTrue(np.array_equal(shared[0].targets["{A,B}"]["ordinate"], 1.3 * force))
        alone = plastica.fit_scenes(tests, {"youngs_modulus": (1e11, 4e11)}, shared=False, **how)
        self.assertEqual(sorted(alone.names), sorted(tests))
        for name, factor in (("{A,B}", 1.3), ("A", 1.0), ("B*", 1.0)):
            self.assertAlmostEqual(
                alone[name].parameters["youngs_modulus"].value / 210e9, factor, delta=1e-6)

    def test_a_beam_test_follows_a_load_or_a_turn(self):
        scene = cantilever(
            supports=[plastica.Support(kind="clamp", at="start"), plastica.Support(
                kind="roller", at="end", hold=["rx"], translation=[0.0, 0.0, 0.0],
                rotation=[0.01, 0.0, 0.0])], loads=[], beam=plastica.Beam(length=1.0, segments=6),
            probes=[plastica.Probe(name="moment", kind="reaction_moment", component="x")])
        turned = plastica.simulate(scene)
        pushed = cantilever(loads=[plastica.Load(at="end", force=[0, 0, 0],
                                                 moment=[20.0, 0.0, 0.0])])
        moved = plastica.simulate(pushed)
        tests = {
            "turn": plastica.BeamTest(scene=scene, abscissa=0.01 * turned.factor,
                                      ordinate=turned.probes["moment"], probe="moment",
                                      against="support[2]"),
            "push": plastica.BeamTest(scene=pushed, abscissa=20.0 * moved.factor,
                                      ordinate=moved.probes["tip"], probe="tip",
                                      against="load[1]")}
        for name, test in tests.items():
            fit = plastica.fit_scenes({name: test}, {"youngs_modulus": {
                "bounds": (1e11, 4e11), "start": 1.5e11}}, options={
                    "starts": 1, "segments_error": False})[0]
            self.assertAlmostEqual(fit.parameters["youngs_modulus"].value / 210e9, 1.0, delta=1e-6)


if __name__ == "__main__":
    unittest.main()
