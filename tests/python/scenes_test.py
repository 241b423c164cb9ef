"""Scenes as objects: the same as files, and mistakes are told."""

import os
import pickle
import shutil
import unittest
import warnings

import numpy as np

import plastica
from support import DATA, TestCase, cantilever

# Those that take more than a second are left to the tests of the command.
SCENES = sorted(path for path in (DATA / "scenes").glob("*.toml")
                if "report" not in path.name and "crash" not in path.name)


class Scenes(TestCase):
    def test_a_file_is_the_same_scene_from_its_dictionary(self):
        for path in SCENES:
            with self.subTest(path.name):
                scene = plastica.Scene.from_toml(path)
                self.assertEqual(plastica.Scene.from_dict(scene.to_dict()).to_dict(),
                                 scene.to_dict())
                for table in path.parent.glob("*.csv"):  # that scenes name
                    shutil.copy(table, self.folder)
                written = self.folder / path.name
                written.write_text(scene.to_toml())
                self.assertEqual(plastica.Scene.from_toml(written).to_dict(), scene.to_dict())

    def test_what_is_written_runs_to_the_same_bits(self):
        for name in ("bend_and_release", "three_point_bend", "tapered_cantilever", "robot_arm",
                     "elastic_foundation", "tip_mass", "bathe_bolourchi_45", "hardening_table"):
            with self.subTest(name):
                scene = plastica.Scene.from_toml(DATA / "scenes" / f"{name}.toml")
                again = plastica.Scene.from_dict(scene.to_dict())
                self.assertIsNone(again.source)
                one, other = plastica.simulate(scene), plastica.simulate(again)
                self.assertEqual(one.status, other.status)
                self.assertSameBits(one.time, other.time)
                for probe in one.probes:
                    self.assertSameBits(one.probes[probe], other.probes[probe])
                self.assertSameBits(one.position, other.position)

    def test_numbers_in_si_are_those_with_units(self):
        bare = cantilever()
        bare.material = plastica.Material(youngs_modulus=205e9, density=7850.0)
        said = cantilever()
        said.material = plastica.Material(youngs_modulus="205 GPa", density="7.85 g/cm^3")
        said.section = plastica.Section(shape="rectangle", width="20 mm", height="2 cm")
        said.loads[0].force = ["0 N", "-0.3 kN", "0 N"]
        self.assertSameBits(plastica.simulate(bare).probes["tip"],
                            plastica.simulate(said).probes["tip"])

    def test_every_number_of_an_item_has_its_unit(self):
        scene = cantilever(
            supports=[
                plastica.Support(kind="clamp", at="start"),
                plastica.Support(kind="elastic", at=0.25, to=0.75, stiffness=[0.0, 2e3, 0.0]),
                plastica.Support(kind="elastic", at="end", stiffness=[1e3, 2e3, 3e3],
                                 rotational_stiffness=[1.0, 2.0, 3.0]),
                plastica.Support(kind="pillar", at=0.5, normal="y", gap=0.1)],
            loads=[plastica.Load(at="end", force=[0, -1, 0], moment=[0.5, 0, 0],
                                 history={"time": [0.0, 1.0], "factor": [0, 1]}),
                   plastica.Load(at=0.25, to=0.5, force=[0.0, -2.0, 0.0])],
            masses=[plastica.PointMass(at="end", mass=0.1, inertia=[1e-4, 1e-4, 1e-4])],
            gravity=[0.0, -9.81, 0.0])
        self.assertEqual(plastica.simulate(scene).status, "completed")
        motion = cantilever(
            supports=[], loads=[], cuts=[plastica.Cut(at=0.5, time=0.01)],
            initial_motions=[plastica.InitialMotion(velocity=[0, 1, 0], spin=[0, 0, 2.0])],
            solver=plastica.Solver(analysis="dynamics", duration=0.02, time_step=1e-3))
        self.assertEqual(plastica.simulate(motion).status, "broken")

    def test_arrays_and_numbers_of_numpy_are_taken(self):
        scene = cantilever()
        scene.loads[0].force = np.array([0.0, -300.0, 0.0])
        scene.beam.length = np.float64(1.0)
        scene.beam.segments = np.int64(20)
        scene.solver = plastica.Solver(steps=np.int32(20))
        self.assertSameBits(plastica.simulate(scene).probes["tip"],
                            plastica.simulate(cantilever()).probes["tip"])

    def test_a_dictionary_is_a_scene(self):
        self.assertSameBits(plastica.simulate(cantilever().to_dict()).probes["tip"],
                            plastica.simulate(cantilever()).probes["tip"])

    def test_relative_paths_begin_at_the_file(self):
        scene = plastica.Scene.from_toml(DATA / "scenes" / "recorded_force.toml")
        before = plastica.simulate(scene)
        scene.name = "another"  # the text is written anew
        after = plastica.simulate(scene)
        for probe in before.probes:
            self.assertSameBits(before.probes[probe], after.probes[probe])

    def test_a_scene_is_changed_by_paths(self):
        scene = cantilever(material="S355")
        other = scene.changed({"beam.segments": 40, "material.yield_stress": 3e8,
                               "solver.steps": 4, "rules.yield_model": None})
        self.assertEqual((scene.beam.segments, scene.material), (20, plastica.Material(name="S355")))
        self.assertEqual(other.material, plastica.Material(name="S355", yield_stress=3e8))
        self.assertEqual((other.beam.segments, other.solver.steps), (40, 4))
        self.assertIsNone(other.rules.yield_model)
        self.assertRefuses(lambda: scene.changed({"beam.segmants": 4}), "did you mean segments?")
        inside = plastica.Scene.from_toml(DATA / "scenes" / "cantilever.toml")  # [beam] has them
        softer = inside.changed({"material.youngs_modulus": 70e9, "section.width": 0.04})
        self.assertEqual(softer.material, plastica.Material(name="S355", youngs_modulus=70e9))
        self.assertEqual((softer.section.width, softer.section.height), (0.04, "20 mm"))
        self.assertEqual(plastica.simulate(softer).status, "completed")
        kept = plastica.Scene.from_toml(DATA / "scenes" / "recorded_force.toml")
        self.assertEqual(plastica.simulate(kept.changed({"solver.steps": 5})).samples, 6)

    def test_what_is_not_given_is_not_shown(self):
        self.assertEqual(repr(plastica.Beam(length=1.0, segments=3)),
                         "Beam(length=1.0, segments=3)")
        scene = cantilever(drive=None)
        self.assertNotIn("None", repr(scene))
        arrays = plastica.Drive(strain=np.linspace(0.0, 0.1, 3))
        self.assertEqual(arrays, plastica.Drive(strain=[0.0, 0.05, 0.1]))

    def test_a_changed_scene_s_mistake_names_no_file(self):
        scene = plastica.Scene.from_toml(DATA / "scenes" / "cantilever.toml")
        scene.beam.length = -1.0
        error = self.assertRefuses(lambda: plastica.simulate(scene), "beam.length")
        self.assertEqual((error.file, error.line), (None, None))

    def test_scenes_are_pickled(self):
        scene = pickle.loads(pickle.dumps(cantilever()))
        self.assertEqual(scene, cantilever())

    def test_names_that_are_not_there_are_told(self):
        self.assertRefuses(lambda: plastica.Material(yeild_stress=3.0),
                           "Material.yeild_stress", "did you mean yield_stress?")
        scene = cantilever()

        def assign():
            scene.beam.segmants = 3
        self.assertRefuses(assign, "Beam.segmants", "did you mean segments?")
        self.assertRefuses(lambda: plastica.Scene.from_dict({"beem": {}}), "did you mean beam?")
        self.assertRefuses(lambda: plastica.Scene.from_dict({"load": {"at": "end"}}), "list")

    def test_mistakes_of_values_are_told(self):
        for change, words in (
            (lambda s: setattr(s.material, "yield_stress", "355 MPS"),
             ("material.yield_stress", "355 MPS", "is not a unit of stress")),
            (lambda s: setattr(s.material, "youngs_modulus", float("nan")),
             ("material.youngs_modulus", "finite")),
            (lambda s: setattr(s.material, "youngs_modulus", -1.0),
             ("material.youngs_modulus", "must be")),
            (lambda s: setattr(s.beam, "segments", 2.5), ("beam.segments", "2.5")),
            (lambda s: setattr(s.loads[0], "force", [1.0, 2.0]), ("load", "force")),
            (lambda s: setattr(s.rules, "yield_model", "elastik"), ("rules.yield_model", "elastik")),
            (lambda s: setattr(s.supports[0], "kind", object()), ("kind", "must be")),
        ):
            scene = cantilever()
            change(scene)
            error = self.assertRefuses(lambda s=scene: plastica.simulate(s), *words)
            self.assertIsNone(error.file)

    def test_a_file_s_mistake_names_its_line(self):
        path = self.folder / "scene.toml"
        path.write_text(cantilever().to_toml().replace("1.0 m", "1.0 mm^2"))
        error = self.assertRefuses(lambda: plastica.simulate(plastica.Scene.from_toml(path)),
                                   "beam.length", "mm^2")
        self.assertEqual(error.file, str(path))
        self.assertEqual(path.read_text().splitlines()[error.line - 1], 'length = "1.0 mm^2"')

    def test_what_is_no_file_is_told(self):
        self.assertRefuses(lambda: plastica.Scene.from_toml(self.folder / "none.toml"),
                           "none.toml", "No such file")
        bad = self.folder / "bad.toml"
        bad.write_text("beam = [")
        self.assertRefuses(lambda: plastica.Scene.from_toml(bad), "bad.toml")

    def test_hostile_texts_stay_texts(self):
        scene = cantilever()
        scene.name = 'a "b" \\ \n\t é </script>'
        scene.probes[0].name = "tip ] = [ # "
        done = plastica.simulate(scene)
        self.assertEqual(list(done.probes), ["tip ] = [ # "])
        self.assertEqual(done.name, scene.name)
        written = self.folder / "hostile.toml"
        written.write_text(scene.to_toml())
        again = plastica.Scene.from_toml(written)
        self.assertEqual((again.name, again.probes[0].name), (scene.name, scene.probes[0].name))

    def test_old_names_are_taken_and_told(self):
        path = self.folder / "old.toml"
        path.write_text(cantilever().to_toml() + "\n[solver]\nmost_iterations = 30\n")
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            scene = plastica.Scene.from_toml(path)
        self.assertIn("most_iterations is now max_iterations", str(told[0].message))
        self.assertEqual(scene.solver.max_iterations, 30)

    def test_unknown_keys_of_a_file_name_their_line(self):
        path = self.folder / "wrong.toml"
        path.write_text(cantilever().to_toml().replace("segments", "segmants"))
        error = self.assertRefuses(lambda: plastica.Scene.from_toml(path), "segmants", "segments")
        self.assertEqual((error.file, path.read_text().splitlines()[error.line - 1]),
                         (str(path), "segmants = 20"))

    def test_what_is_given_is_not_changed_or_shared(self):
        tree = {"load": [{"at": "end", "force": [0.0, -1.0, 0.0]}]}
        one, other = plastica.Scene.from_dict(tree), plastica.Scene.from_dict(tree)
        one.loads[0].force[1] = -5.0
        self.assertEqual((other.loads[0].force[1], tree["load"][0]["force"][1]), (-1.0, -1.0))
        material, gravity = {"youngs_modulus": 1e11}, [0.0, -9.81, 0.0]
        made = cantilever().changed({"material": material, "material.density": 100.0,
                                     "gravity": gravity})
        gravity[1] = 5.0
        self.assertEqual((material, made.gravity), ({"youngs_modulus": 1e11}, [0.0, -9.81, 0.0]))

    def test_a_scene_stays_that_of_its_folder(self):
        for k in (1, 2):
            folder = self.folder / str(k)
            folder.mkdir()
            (folder / "h.csv").write_text(f"t [s],f [1]\n0,0\n1,{k}\n")
            scene = cantilever()
            scene.loads[0].history = {"table": "h.csv", "time": 1, "factor": 2}
            (folder / "s.toml").write_text(scene.to_toml())
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(self.folder / "1")
        scene = plastica.Scene.from_toml("s.toml")
        tips = []
        for folder in (self.folder / "1", self.folder / "2"):
            os.chdir(folder)
            for each in (scene, scene.changed({"name": "other"})):
                tips.append(plastica.simulate(each).probes["tip"][-1])
        self.assertEqual(tips, [tips[0]] * 4)

    def test_paths_that_are_none_are_refused(self):
        scene = cantilever(name="a")
        for path in ("name.x", "load.force", "loads.force"):
            self.assertRefuses(lambda p=path: scene.changed({p: 1}), path.partition(".")[0])


if __name__ == "__main__":
    unittest.main()
