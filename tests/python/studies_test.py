"""Sweeps, advice, checks and beams for engines: the same as the command's."""

import json
import pickle
import unittest
import xml.etree.ElementTree as ElementTree

import numpy as np

import plastica
from support import DATA, TestCase, cantilever, command


class Studies(TestCase):
    def write(self, scene, name="scene.toml"):
        path = self.folder / name
        path.write_text(scene.to_toml())
        return path

    def test_a_sweep_is_the_command_s(self):
        command("init", "sweep", "-d", self.folder)
        command("sweep", self.folder / "sweep.toml", "-o", self.folder / "a.h5", "--quiet",
                "--json", self.folder / "a.json")
        made = plastica.sweep(self.folder / "sweep.toml")
        theirs, ours = json.loads((self.folder / "a.json").read_text()), json.loads(made.to_json())
        for each in (theirs, ours):
            for case in each["cases"]:
                case.pop("seconds", None)
        self.assertEqual(theirs, ours)
        made.save(self.folder / "b.h5")
        self.assertEqual(plastica.load(self.folder / "b.h5").report(), made.report())
        self.assertEqual(len(made), len(theirs["cases"]))

    def test_errors_fall_with_the_square_of_the_segments(self):
        scene = cantilever()
        scene.loads[0].force = [0.0, -2000.0, 0.0]
        segments = [5, 10, 20, 40]
        table = plastica.sweep(scene, {"beam.segments": segments}, probe="tip",
                               against="theory:elastica").to_dataframe()
        self.assertEqual(list(table["beam.segments"]), segments)
        self.assertEqual(table["beam.segments"].dtype.kind, "i")
        order = -np.polyfit(np.log(segments), np.log(np.abs(table["error"])), 1)[0]
        self.assertAlmostEqual(order, 2.0, delta=0.02)

    def test_groups_have_observed_orders(self):
        made = plastica.sweep(cantilever(), {"beam.segments": [10, 20, 40]}, probe="tip",
                              against="finest")
        self.assertAlmostEqual(made.groups[0]["three_finest"]["order"], 2.0, delta=0.01)
        self.assertIn("finest", made.to_dataframe()["reason"][2])

    def test_axes_have_units_and_words(self):
        scene = cantilever()
        scene.loads[0].force = [0.0, -1.0, 0.0]  # as good as linear
        table = plastica.sweep(
            scene, {"beam.length": [1.0, 2.0], "rules.end_rule": ["half_joint", "equal"]},
            probe="tip", set={"beam.segments": 10}).to_dataframe()
        self.assertEqual(len(table), 4)
        self.assertEqual(set(table["rules.end_rule"]), {"half_joint", "equal"})
        ratio = table["value"][2] / table["value"][0]
        self.assertAlmostEqual(ratio, 8.0, delta=1e-3)  # the cube of the length

    def test_a_case_that_fails_is_a_row(self):
        scene = cantilever(section=plastica.Section(shape="round_tube", radius=0.02,
                                                    inner_radius=0.01))
        table = plastica.sweep(scene, {"section.inner_radius": [0.01, 0.03]},
                               probe="tip").to_dataframe()
        self.assertEqual(list(table["status"]), ["completed", "rejected"])
        self.assertIn("inner_radius", table["reason"][1])
        self.assertTrue(np.isnan(table["value"][1]))

    def test_sweep_s_mistakes_are_told(self):
        scene = cantilever()
        for call, words in (
            (lambda: plastica.sweep(scene, {"beam.segmnts": [5]}, probe="tip"), ("beam.segmnts",)),
            (lambda: plastica.sweep(scene, {"beam.segments": [5.5]}, probe="tip"), ("5.5",)),
            (lambda: plastica.sweep(scene, {"beam.segments": [5]}, probe="tipp"), ("tipp", "tip")),
            (lambda: plastica.sweep(scene, {"beam.segments": [5]}, probe="tip",
                                    against="theory:nonsense"), ("nonsense",)),
            (lambda: plastica.sweep(scene), ("axes",)),
            (lambda: plastica.sweep(self.folder / "none.toml"), ("none.toml",)),
        ):
            self.assertRefuses(call, *words)
        self.assertNotIn("tmp", str(self.assertRefuses(
            lambda: plastica.sweep(scene, {"beam.segmnts": [5]}, probe="tip"))))

    def test_a_probe_is_taken_as_it_is_said(self):
        scene = cantilever()
        scene.loads[0].history = plastica.turning_points([1.0, -0.5])
        axes = {"beam.segments": [8]}
        ends = [plastica.sweep(scene, axes, **how).to_dataframe()["value"][0] for how in (
            {"probe": "tip", "take": "min"}, {"error": {"probe": "tip"}, "take": "min"},
            {"error": {"probe": "tip", "take": "min"}})]
        least = plastica.simulate(scene.changed({"beam.segments": 8})).probes["tip"].min()
        self.assertEqual(ends, [least] * 3)
        self.assertRefuses(lambda: plastica.sweep(scene, axes, probe="tip", take="end",
                                                  error={"take": "min"}), "error.take", "argument")

    def test_optional_fields_may_be_unset(self):
        table = plastica.sweep(cantilever(), {"rules.hinge_length": [None, 0.03]},
                               probe="tip").to_dataframe()
        self.assertTrue(np.isnan(table["rules.hinge_length"][0]))

    def test_a_changed_scene_that_names_files_is_swept(self):
        scene = plastica.Scene.from_toml(DATA / "scenes" / "recorded_force.toml")
        probe = scene.probes[0].name
        axes = {"beam.segments": [5, 10]}
        of_file = plastica.sweep(scene, axes, probe=probe).to_dataframe()
        changed = plastica.sweep(scene.changed({"name": "other"}), axes, probe=probe).to_dataframe()
        self.assertEqual(list(of_file["value"]), list(changed["value"]))

    def test_a_sweep_is_pickled(self):
        made = plastica.sweep(cantilever(), {"beam.segments": [5, 10]}, probe="tip")
        again = pickle.loads(pickle.dumps(made))
        self.assertEqual(again.report(), made.report())

    def test_advice_is_within_what_was_asked_for(self):
        scene = cantilever()
        scene.loads[0].force = [0.0, -2000.0, 0.0]
        advice = plastica.advise(scene, within=0.01)
        self.assertTrue(advice.found)
        self.assertLess(advice.promised, 0.01)
        fine = cantilever(beam=plastica.Beam(length=1.0, segments=400), loads=scene.loads)
        tips = [plastica.simulate(each).probes["tip"][-1] for each in (advice.scene, fine)]
        self.assertLess(abs(tips[0] / tips[1] - 1.0), 0.01)
        self.assertEqual(plastica.advise(scene, within="1 %").values, advice.values)
        self.assertLess(len(repr(advice)), 2000)
        path = self.write(scene)
        said = command("advise", path, "--within", "1 %", "--quiet", "-o", self.folder / "b.toml")
        self.assertIn(f"{int(advice.values['beam.segments'])}", said)
        written = plastica.Scene.from_toml(self.folder / "b.toml")
        self.assertSameBits(plastica.simulate(written).probes["tip"],
                            plastica.simulate(advice.scene).probes["tip"])
        for call, words in (
            (lambda: plastica.advise(scene), ("within and budget",)),
            (lambda: plastica.advise(scene, within=1.0), ("within", "below 1")),
            (lambda: plastica.advise(scene, within=0.1, probes=["end"]), ("end",)),
            (lambda: plastica.advise(scene, within=0.1, max_runs=1), ("max_runs",)),
        ):
            self.assertRefuses(call, *words)

    def test_claims_are_checked(self):
        path = sorted((DATA / "checks").glob("*.toml"))[0]
        claims = plastica.check(path)
        junit = self.folder / "j.xml"
        command("check", path, "--quiet", "--junit", junit)
        names = [case.get("name") for case in ElementTree.parse(junit).iter("testcase")]
        self.assertEqual([claim.name for claim in claims], names)
        self.assertTrue(all(claim.holds for claim in claims))
        for claim in claims:
            self.assertEqual(len(claim.worst), min(claim.judged, 20))
            if claim.worst and claim.number is not None and claim.worst[0].of:
                self.assertEqual((claim.worst[0].number, "at " + claim.worst[0].of),
                                 (claim.number, claim.at))

    def test_a_beam_for_an_engine_is_the_command_s(self):
        scene = cantilever()
        scene.name = "scene"
        path = self.write(scene)
        command("simulate", path, "-o", self.folder / "a.h5", "--quiet")
        for to, ending in (("mjcf", "xml"), ("csv", "csv"), ("opensees", "tcl")):
            command("export", self.folder / "a.h5", "--what", "beam", "--to", to, "-o",
                    self.folder / f"a.{ending}")
            theirs = (self.folder / f"a.{ending}").read_text()
            self.assertEqual(plastica.export(scene, to), theirs)
        self.assertRefuses(lambda: plastica.export(scene, "mujoco"), "mujoco", "mjcf")
        self.assertRefuses(lambda: plastica.export(scene, "mjcf", up="w"), "up = w", "must be")
        self.assertRefuses(lambda: plastica.export(scene, "mjcf", gravity=-1.0), "gravity")
        self.assertEqual(plastica.export(scene, "mjcf", up="z", gravity="9.81 m/s^2"),
                         plastica.export(scene, "mjcf", up="z", gravity=9.81))


if __name__ == "__main__":
    unittest.main()
