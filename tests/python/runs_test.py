"""Runs: the same bits as the command's, one by one and as a batch."""

import gc
import multiprocessing
import pickle
import threading
import unittest

import h5py
import numpy as np
import pandas

import plastica
from support import DATA, TestCase, cantilever, command


def tip_of_case(value):
    model = plastica.prepare(cantilever(), ["material.youngs_modulus"])
    return model.run_batch(np.full((8, 1), value)).probes["tip"][:, -1].tobytes()


def fits_of_files(path):
    """All that uses OpenMP by itself: reading several files, fitting, writing, reading again."""
    files = [DATA / "targets" / name for name in ("al6061-t6.csv", "s355.csv")]
    plastica.fit(files).save(path)
    plastica.problem(files[0])
    return repr(plastica.load(path).to_dataframe().to_dict())


class Runs(TestCase):
    def test_a_result_is_the_command_s(self):
        for name in ("three_point_bend", "falling_cantilever", "breaking_cantilever"):
            with self.subTest(name):
                path = DATA / "scenes" / f"{name}.toml"
                command("simulate", path, "-o", self.folder / f"{name}.h5", "--quiet")
                done = plastica.simulate(plastica.Scene.from_toml(path))
                done.save(self.folder / f"{name}-python.h5")
                with h5py.File(self.folder / f"{name}.h5") as theirs, \
                        h5py.File(self.folder / f"{name}-python.h5") as ours:
                    self.assertSameBits(theirs["probes/values"][()], ours["probes/values"][()])
                    for k, probe in enumerate(done.probes):
                        self.assertSameBits(theirs["probes/values"][k], done.probes[probe])
                    def same(path_of, item):
                        if isinstance(item, h5py.Dataset) and not path_of.startswith("meta"):
                            self.assertEqual(np.asarray(item[()]).tobytes()
                                             if item.dtype.kind != "O" else list(np.ravel(item[()])),
                                             np.asarray(ours[path_of][()]).tobytes()
                                             if item.dtype.kind != "O"
                                             else list(np.ravel(ours[path_of][()])), path_of)
                    theirs.visititems(same)

    def test_the_tip_is_that_of_the_closed_form(self):
        scene = cantilever()
        scene.loads[0].force = [0.0, -1.0, 0.0]
        scene.beam.segments = 200
        tip = plastica.simulate(scene).probes["tip"][-1]
        inertia = 0.02**4 / 12.0
        self.assertAlmostEqual(tip, -1.0 / (3.0 * 210e9 * inertia), delta=1e-4 * abs(tip))

    def test_shapes_are_as_documented(self):
        scene = cantilever(solver=plastica.Solver(steps=8, frames=3))
        done = plastica.simulate(scene)
        self.assertEqual(done.time.shape, (9,))
        frames = len(done.frame_sample)
        for name, shape in (("position", (frames, 21, 3)), ("rotation", (frames, 20, 3)),
                            ("moment", (frames, 21, 3)), ("stress", (frames, 21)),
                            ("plastic_strain", (frames, 21)), ("reaction", (frames, 1, 6))):
            self.assertEqual(getattr(done, name).shape, shape, name)
        for name in ("velocity", "spin"):
            self.assertEqual(getattr(done, name).shape, (0, 20, 3), "a path at rest has none")
        self.assertEqual(done.energies["elastic"].shape, (9,))
        # The clamp carries the force and its moment about it.
        self.assertAlmostEqual(done.reaction[-1, 0, 1], 300.0, delta=1e-6)
        self.assertAlmostEqual(abs(done.moment[-1, 0, 0]), 300.0 * done.position[-1, -1, 2],
                               delta=1e-4)

    def test_frames_of_a_motion_have_velocities(self):
        solver = plastica.Solver(analysis="dynamics", duration=0.002, time_step=1e-4, steps=4)
        done = plastica.simulate(cantilever(solver=solver))
        for name in ("velocity", "spin"):
            self.assertEqual(getattr(done, name).shape, (5, 20, 3))
        # A segment's inner end moves as the one before it turns: v + omega x r.
        arms = np.diff(done.position[-1], axis=0)[:-1]
        ends = done.velocity[-1, :-1] + np.cross(done.spin[-1, :-1], arms)
        fastest = abs(done.velocity).max()
        self.assertGreater(fastest, 1e-3)
        np.testing.assert_allclose(ends, done.velocity[-1, 1:], rtol=0, atol=1e-2 * fastest)

    def test_arrays_outlive_their_response_and_cannot_be_written_to(self):
        tip = plastica.simulate(cantilever()).probes["tip"]
        energy = plastica.simulate(cantilever()).energies["elastic"]
        before = tip.copy(), energy.copy()
        gc.collect()
        waste = [plastica.simulate(cantilever()) for _ in range(4)]
        self.assertSameBits(tip, before[0])
        self.assertSameBits(np.ascontiguousarray(energy), before[1])
        with self.assertRaises(ValueError):
            tip[0] = 1.0
        self.assertFalse(tip.flags.owndata)
        del waste

    def test_a_batch_has_the_bits_of_lone_runs(self):
        for rules in ("elastic", "per_axis", "fibre"):
            cap = None if rules == "fibre" else "fully_plastic"
            scene = cantilever(rules=plastica.Rules(yield_model=rules, yield_cap=cap))
            scene.loads[0].force = [0.0, -600.0, 0.0]
            model = plastica.prepare(scene, ["material.youngs_modulus", "material.yield_stress"])
            values = np.column_stack([np.linspace(190e9, 210e9, 20), np.linspace(2e8, 6e8, 20)])
            made = model.run_batch(values, threads=2)
            self.assertSameBits(made.probes["tip"], model.run_batch(values, threads=1).probes["tip"])
            for i, row in enumerate(values):
                alone = model.run(row)
                self.assertEqual(alone.status, made.status[i])
                self.assertEqual(alone.samples, made.samples[i])
                self.assertSameBits(alone.probes["tip"], made.probes["tip"][i, : alone.samples])
                self.assertTrue(np.isnan(made.probes["tip"][i, alone.samples :]).all())

    def test_a_case_that_cannot_run_is_a_row(self):
        model = plastica.prepare(cantilever(), ["material.youngs_modulus"])
        made = model.run_batch([[200e9], [-1.0], [float("nan")], [210e9]])
        self.assertEqual(list(made.status),
                         ["completed", "invalid-parameter", "invalid-parameter", "completed"])
        self.assertTrue(np.isnan(made.probes["tip"][1:3]).all())
        self.assertEqual(list(made.samples[1:3]), [0, 0])
        for numbers in (made.permanent_strain, made.energy_balance_error):
            self.assertEqual(list(np.isnan(numbers)), [False, True, True, False])

    def test_values_go_by_name(self):
        model = plastica.prepare(cantilever(), ["material.youngs_modulus", "material.yield_stress"])
        self.assertSameBits(
            model.run({"material.yield_stress": 3e8, "material.youngs_modulus": 2e11}).probes["tip"],
            model.run([2e11, 3e8]).probes["tip"])
        self.assertRefuses(lambda: model.run({"material.yield_stress": 3e8}), "youngs_modulus")
        self.assertRefuses(lambda: model.run({"yield": 3e8}), "is no parameter")

    def test_tables_go_by_the_names_of_their_columns(self):
        model = plastica.prepare(cantilever(rules=plastica.Rules(yield_model="per_axis")),
                                 ["material.youngs_modulus", "material.yield_stress"])
        table = pandas.DataFrame({"material.yield_stress": [3e8, 4e8],
                                  "material.youngs_modulus": [2.0e11, 2.1e11]})
        wanted = model.run_batch([[2.0e11, 3e8], [2.1e11, 4e8]]).probes["tip"]
        self.assertSameBits(model.run_batch(table).probes["tip"], wanted)
        self.assertSameBits(model.run(table.iloc[1]).probes["tip"], wanted[1])
        self.assertRefuses(lambda: model.run_batch(table[["material.yield_stress"]]), "column")
        self.assertRefuses(lambda: model.run_batch(table.assign(more=1.0)), "more")

    def test_wrong_shapes_are_told(self):
        model = plastica.prepare(cantilever(), ["material.youngs_modulus"])
        self.assertRefuses(lambda: model.run([1.0, 2.0]), "values", "1 numbers")
        self.assertRefuses(lambda: model.run_batch([2e11]), "values", "row for each case")
        self.assertRefuses(lambda: model.run_batch([[2e11, 1.0]]), "1 columns")
        self.assertRefuses(lambda: model.run_batch([[2e11]], threads=-1), "threads")
        with self.assertRaises((TypeError, ValueError)):
            model.run_batch([["stiff"]])
        self.assertEqual(len(model.run_batch(np.zeros((0, 1)))), 0)

    def test_parameters_that_are_none_are_told(self):
        self.assertRefuses(lambda: plastica.prepare(cantilever(), ["material.stiffness"]))
        self.assertRefuses(lambda: plastica.prepare(cantilever(), "material.youngs_modulus"), "list")
        self.assertRefuses(lambda: plastica.prepare(cantilever(), ["beam.segments"]))

    def test_derivatives_are_those_of_differences(self):
        scene = plastica.Scene(
            material=plastica.Material(youngs_modulus=200e9, yield_stress=250e6, hardening={
                "law": "linear", "tangent_modulus": 5e9}),
            drive=plastica.Drive(strain=np.linspace(0.0, 0.02, 41)))
        names = ["material.youngs_modulus", "material.yield_stress",
                 "material.hardening.tangent_modulus"]
        model = plastica.prepare(scene, names)
        x = np.array([200e9, 250e6, 5e9])
        made = model.run_sensitivity(x)
        self.assertSameBits(made.response.probes["stress"], model.run(x).probes["stress"])
        for k in range(3):
            step = np.zeros(3)
            step[k] = 1e-6 * x[k]
            slope = (model.run(x + step).probes["stress"] - model.run(x - step).probes["stress"]) / (
                2.0 * step[k])
            # Differences of numbers with 16 digits at a step of 1e-6 have 10 of them.
            scale = np.abs(made.stress[:, k]).max()
            np.testing.assert_allclose(made.stress[:, k], slope, atol=1e-8 * scale)
        self.assertRefuses(
            lambda: plastica.prepare(cantilever(), ["material.youngs_modulus"]).run_sensitivity([2e11]))

    def test_what_is_saved_is_loaded_and_pickled(self):
        done = plastica.simulate(cantilever())
        done.save(self.folder / "a.h5")
        for again in (plastica.load(self.folder / "a.h5"), pickle.loads(pickle.dumps(done))):
            self.assertSameBits(again.position, done.position)
            self.assertSameBits(again.probes["tip"], done.probes["tip"])
            self.assertEqual(again.report(), done.report())
        self.assertRefuses(lambda: done.save(self.folder / "a.h5"), "a.h5", "overwrite=True")
        self.assertRefuses(lambda: done.save(self.folder / "no" / "a.h5"))
        done.save(self.folder / "a.h5", overwrite=True)
        self.assertRefuses(lambda: plastica.load(DATA / "targets" / "s355.csv"), "s355.csv")

    def test_a_model_is_pickled(self):
        scene = cantilever()
        model = plastica.prepare(scene, ["material.youngs_modulus"])
        scene.beam.segments = 3  # of another model
        again = pickle.loads(pickle.dumps(model))
        self.assertSameBits(again.run([2e11]).probes["tip"], model.run([2e11]).probes["tip"])
        self.assertEqual(again.run([2e11]).position.shape, (21, 21, 3))

    def test_responses_are_pickled(self):
        broken = plastica.prepare(
            plastica.Scene.from_toml(DATA / "scenes" / "breaking_cantilever.toml")).run()
        again = pickle.loads(pickle.dumps(broken))
        self.assertSameBits(again.position, broken.position)
        self.assertSameBits(again.energies["plastic"], broken.energies["plastic"])
        self.assertEqual(again.status, broken.status)
        self.assertEqual(again.events[0].joints[0].moment, broken.events[0].joints[0].moment)
        self.assertEqual(again.events[0].fragments, broken.events[0].fragments)
        for array in (again.time, again.position, *again.probes.values(), again.energies["elastic"]):
            self.assertFalse(array.flags.writeable)

    def test_a_run_that_was_not_begun_has_no_samples(self):
        done = plastica.prepare(cantilever(), ["material.youngs_modulus"]).run([-1.0])
        self.assertEqual((done.status, done.samples), ("invalid-parameter", 0))
        self.assertEqual((len(done.time), done.position.shape[0]), (0, 0))
        self.assertEqual(len(done.to_dataframe()), 0)

    def test_threads_share_a_model(self):
        model = plastica.prepare(cantilever(), ["material.youngs_modulus"])
        expected = [model.run([v]).probes["tip"].tobytes() for v in (2.0e11, 2.1e11, 2.2e11)]
        wrong = []

        def work(k):
            for _ in range(20):
                if model.run([2.0e11 + k * 1e10]).probes["tip"].tobytes() != expected[k]:
                    wrong.append(k)
        threads = [threading.Thread(target=work, args=(k,)) for k in range(3)]
        for each in threads:
            each.start()
        for each in threads:
            each.join()
        self.assertEqual(wrong, [])

    def test_processes_that_are_forked_fit_files_and_save(self):
        here = fits_of_files(str(self.folder / "here.h5"))
        with multiprocessing.get_context("fork").Pool(2) as pool:
            paths = [str(self.folder / f"{k}.h5") for k in range(2)]
            there = pool.map_async(fits_of_files, paths).get(timeout=120)
        self.assertEqual([here, here], there)

    def test_processes_that_are_forked_run_batches(self):
        # OpenMP's threads of this process are gone in its children.
        here = [tip_of_case(v) for v in (2.0e11, 2.1e11)]
        with multiprocessing.get_context("fork").Pool(2) as pool:
            there = pool.map_async(tip_of_case, [2.0e11, 2.1e11]).get(timeout=60)
        self.assertEqual(here, there)

    def test_warnings_are_told(self):
        import warnings
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            done = plastica.simulate(cantilever(beam=plastica.Beam(length=0.1, segments=20)))
        self.assertEqual([str(one.message) for one in told], done.warnings)
        self.assertGreater(len(done.warnings), 0)

    def test_a_run_that_does_not_complete_says_so(self):
        scene = plastica.Scene.from_toml(DATA / "scenes" / "limit_load_cantilever.toml")
        done = plastica.simulate(scene)
        self.assertEqual(done.status, "limit-load")
        self.assertLess(done.limit["below"], done.limit["above"])
        self.assertTrue(done.usable)
        loose = cantilever(supports=[plastica.Support(kind="pin", at="start")])
        self.assertRefuses(lambda: plastica.simulate(loose), "free to rotate")

    def test_breaks_are_there(self):
        done = plastica.simulate(plastica.Scene.from_toml(DATA / "scenes" / "breaking_cantilever.toml"))
        self.assertEqual(done.status, "broken")
        self.assertEqual(done.events[0].joints[0].joint, 0)
        self.assertGreater(done.events[0].joints[0].strain, 0.09)


if __name__ == "__main__":
    unittest.main()
