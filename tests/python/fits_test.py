"""Fits: the same as the command's, of files and of arrays; SciPy finds the same optimum."""

import pickle
import unittest
import warnings

import numpy as np
import pandas

import plastica
from support import DATA, TestCase, command, hardening_curve

CURVE = DATA / "targets" / "al6061-t651-20c.csv"


class Fits(TestCase):
    def test_a_fit_file_s_result_is_the_command_s_bit_by_bit(self):
        command("calibrate", DATA / "fits" / "demo.toml", "-o", self.folder / "a.h5", "--quiet",
                "--json", self.folder / "a.json")
        fits = plastica.fit(DATA / "fits" / "demo.toml", threads=1)
        fits.save(self.folder / "b.h5")
        self.assertSameFiles(self.folder / "a.h5", self.folder / "b.h5")
        self.assertEqual(fits.to_json(), (self.folder / "a.json").read_text())
        self.assertEqual(fits.report(), command("show", self.folder / "a.h5"))

    def test_so_are_laws_and_intervals(self):
        options = ["--laws", "ideal,linear", "--profile", "--bootstrap", "20"]
        command("calibrate", CURVE, "-o", self.folder / "a.h5", "--quiet", *options)
        fits = plastica.fit(str(CURVE), laws=["ideal", "linear"], profile=True, bootstrap=20)
        fits.save(self.folder / "b.h5")
        # Python says in its text what the command has from its options.
        self.assertSameFiles(self.folder / "a.h5", self.folder / "b.h5", "--but", "/inputs")
        with self.assertRaises(KeyError):
            fits["al6061-t651-20c"]
        fit = fits["al6061-t651-20c", "linear"]
        profile = fit.profiles["yield_stress"]
        self.assertLess(profile["interval"][0], fit.parameters["yield_stress"].value)
        self.assertEqual(fit.bootstrap["values"].shape[1], len(fit.bootstrap["interval"]))

    def test_curves_in_arrays_are_those_of_the_file(self):
        of_file = plastica.fit(str(CURVE))[0]
        for curve in (of_file.measured, [*of_file.measured],
                      pandas.DataFrame({"Strain": of_file.measured[0],
                                        "Stress": of_file.measured[1]})):
            fits = plastica.fit({of_file.name: curve})
            for name, one in of_file.parameters.items():
                other = fits[of_file.name].parameters[name]
                self.assertEqual(one, other, name)
            self.assertSameBits(of_file.fitted[1], fits[0].fitted[1])

    def test_a_fit_finds_what_a_curve_was_made_of(self):
        noise = 1e6
        strain, stress = hardening_curve(noise)
        fit = plastica.fit(
            (strain, stress), parameters=["youngs_modulus", "yield_stress", "tangent_modulus"],
            material={"hardening": {"law": "linear"}},
            options={"objective": "least-squares", "noise": noise})[0]
        self.assertEqual(fit.status, "fitted")
        for name, truth in (("youngs_modulus", 200e9), ("yield_stress", 300e6),
                            ("tangent_modulus", 2e9)):
            one = fit.parameters[name]
            self.assertLess(abs(one.value - truth), 4.0 * one.error, name)
            self.assertLess(one.interval[0], one.value)

    def test_parameters_are_given_as_files_have_them(self):
        curve = hardening_curve(1e6)
        bounded = plastica.fit(curve, parameters={
            "youngs_modulus": (150e9, 250e9), "yield_stress": {"bounds": [1e8, "400 MPa"]}})[0]
        self.assertEqual(bounded.parameters["youngs_modulus"].bounds, (150e9, 250e9))
        self.assertEqual(bounded.parameters["yield_stress"].bounds, (1e8, 4e8))
        held = plastica.fit(curve, fixed={"youngs_modulus": 201e9})[0].parameters
        self.assertEqual((held["youngs_modulus"].role, held["youngs_modulus"].value),
                         ("fixed", 201e9))
        prior = plastica.fit(curve, parameters={"youngs_modulus": None, "yield_stress": {
            "prior": {"mean": 310e6, "standard_deviation": 1e3}}})[0]
        self.assertAlmostEqual(prior.parameters["yield_stress"].value, 310e6, delta=1e5)

    def test_a_curve_that_cannot_be_fitted_loses_no_other(self):
        strain, stress = hardening_curve(1e6)
        bad = {"none": ([0.0, 0.01], [0.0, 1e8]), "turned": (strain[::-1], stress[::-1]),
               "empty of numbers": (strain, np.full(301, np.nan)),
               "percent": (100.0 * strain, stress), "megapascal": (strain, 1e-6 * stress)}
        fits = plastica.fit({"good": (strain, stress), **bad})
        self.assertEqual(len(fits), 6)
        self.assertEqual(fits["good"].status, "fitted")
        for name in bad:
            self.assertEqual(fits[name].status, "rejected", name)
            self.assertGreater(len(fits[name].reason), 10, name)
        self.assertIn("rejected 5", fits.report())

    def test_mistakes_are_told(self):
        strain, stress = hardening_curve()
        curve = (strain, stress)
        for call, words in (
            (lambda: plastica.fit((strain, stress[:-1])), ("301 strains and 300 stresses",)),
            (lambda: plastica.fit(strain), ("must be a pair",)),
            (lambda: plastica.fit({"a": (strain, "text")}), ("a:", "numbers")),
            (lambda: plastica.fit({}), ("no curve",)),
            (lambda: plastica.fit((np.eye(3), np.eye(3))), ("one row",)),
            (lambda: plastica.fit(([], [])), ("no samples",)),
            (lambda: plastica.fit(curve, parameters=["yeild_stress"]), ("did you mean yield_stress",)),
            (lambda: plastica.fit(curve, parameters="yield_stress"), ("must be a list",)),
            (lambda: plastica.fit(curve, parameters={"yield_stress": 3e8}), ("fixed",)),
            (lambda: plastica.fit(curve, laws=["vocee"]), ("vocee", "voce")),
            (lambda: plastica.fit(curve, options={"seeed": 1}), ("did you mean seed",)),
            (lambda: plastica.fit(curve, test="tensoin"), ("tensoin", "tension")),
            (lambda: plastica.fit(curve, bootstrap=3), ("at least 20",)),
            (lambda: plastica.fit(curve, confidence=95), ("confidence",)),
            (lambda: plastica.fit(curve, columns={"strain": "a"}), ("columns",)),
            (lambda: plastica.fit(curve, groups={"b": {"lot": "1"}}), ("groups.b",)),
            (lambda: plastica.fit(CURVE, columns={"strein": "a"}), ("columns.strein",)),
            (lambda: plastica.fit(self.folder / "none.csv"), ("none.csv", "No such file")),
            (lambda: plastica.fit(self.folder / "none.toml"), ("none.toml",)),
            (lambda: plastica.fit(DATA / "fits" / "demo.toml", test="tension"), ("the fit file says",)),
            (lambda: plastica.fit(pandas.DataFrame({"a": [1.0]})), ("no column strain",)),
            (lambda: plastica.fit(curve, threads=1.5), ("threads",)),
        ):
            self.assertRefuses(call, *words)

    def test_columns_of_tables_have_units(self):
        frame = pandas.read_csv(CURVE)
        self.assertIn("[%]", frame.columns[0])
        of_file = plastica.fit(str(CURVE))[0]
        of_table = plastica.fit({of_file.name: frame})[of_file.name]
        for name, one in of_file.parameters.items():
            # Bits differ, as 0.01 x and x % do.
            self.assertAlmostEqual(of_table.parameters[name].value / one.value, 1.0, delta=1e-9)
        self.assertRefuses(lambda: plastica.fit(frame.rename(columns={
            frame.columns[1]: "Stress [V]"})), "Stress [V]", "not a unit of stress")

    def test_what_may_be_meant_otherwise_is_refused(self):
        strain, stress = hardening_curve(1e6)
        twice = pandas.DataFrame({"strain": strain, "Stress [MPa]": 2e-6 * stress, "stress": stress})
        self.assertRefuses(lambda: plastica.fit(twice), "2 columns stress")
        turned = pandas.Series(stress, index=range(301)[::-1])
        self.assertRefuses(lambda: plastica.fit((pandas.Series(strain), turned)), "two indices")
        fractions, texts = (plastica.fit((strain, stress), characteristics={"window": window})
                            for window in ([0.2, 0.6], ["20 %", "60 %"]))
        self.assertEqual(fractions[0].characteristics, texts[0].characteristics)
        stresses = plastica.fit((strain, stress), characteristics={"window": [50e6, 200e6]})[0]
        self.assertEqual(stresses.status, "fitted")

    def test_paths_may_come_one_after_the_other(self):
        fits = plastica.fit((DATA / "targets").glob("al6061-t651-2*.csv"))
        self.assertEqual(len(fits), 2)
        self.assertRefuses(lambda: plastica.fit({"a": str(CURVE)}), "is a path")
        self.assertRefuses(lambda: plastica.fit(CURVE, columns={"strain": "Dehnung"}),
                           "columns.strain", "Dehnung")

    def test_the_advised_law_is_there(self):
        curve = hardening_curve(1e6)
        fits = plastica.fit(curve, laws=["ideal", "linear"])
        self.assertEqual(fits.advised, "linear")
        self.assertIsNone(plastica.fit(curve).advised)

    def test_what_is_not_fitted_has_no_numbers(self):
        fit = plastica.fit(([0.0, 0.01], [0.0, 1e8]))[0]
        self.assertTrue(np.isnan(fit.misfit) and np.isnan(fit.misfit_fraction))
        self.assertFalse(fit.usable)

    def test_groups_have_means(self):
        strain, stress = hardening_curve(1e6)
        fits = plastica.fit(
            {f"{lot}{k}": hardening_curve(1e6, seed) for seed, (lot, k) in enumerate(
                [("a", 1), ("a", 2), ("b", 1)])},
            groups={"a1": {"lot": "A"}, "a2": {"lot": "A"}, "b1": {"lot": "B"}})
        self.assertIn("Group lot A: 2 specimens", fits.report())
        self.assertEqual(list(fits.to_dataframe()["lot"]), ["A", "A", "B"])
        turned = plastica.fit({"a": (strain[::-1], stress[::-1])}, groups={"a": {
            "status": "fitted", "name": "b"}}).to_dataframe()
        self.assertEqual((turned["status"][0], turned["name"][0]), ("rejected", "a"))
        self.assertEqual(turned["group status"][0], "fitted")

    def test_what_is_saved_is_loaded_and_pickled(self):
        fits = plastica.fit(str(CURVE))
        fits.save(self.folder / "a.h5")
        for again in (plastica.load(self.folder / "a.h5"), pickle.loads(pickle.dumps(fits))):
            self.assertEqual(again.report(), fits.report())
            self.assertEqual(again[0].parameters, fits[0].parameters)
            self.assertSameBits(again[0].fitted[1], fits[0].fitted[1])
        self.assertRefuses(lambda: fits.save(self.folder / "a.h5"), "exists")
        self.assertEqual(pickle.loads(pickle.dumps(fits[0])).parameters, fits[0].parameters)

    def test_notebooks_show_tables_with_names_as_text(self):
        strain, stress = hardening_curve(1e6)
        fits = plastica.fit({"<script>alert(1)</script>": (strain, stress)})
        for shown in (fits._repr_html_(), fits[0]._repr_html_()):
            self.assertNotIn("<script>", shown)
            self.assertIn("yield_stress", shown)
        self.assertIn("1 fitted", repr(fits))

    def test_pictures_are_drawn(self):
        import matplotlib
        matplotlib.use("Agg")
        axes = plastica.fit(str(CURVE))[0].plot()
        self.assertEqual(len(axes.get_lines()), 3)
        self.assertEqual(axes.get_xlabel(), "strain [%]")

    def test_threads_change_no_bit(self):
        curves = {f"s{k}": hardening_curve(1e6, k) for k in range(6)}
        one, two = plastica.fit(curves, threads=1), plastica.fit(curves, threads=2)
        for a, b in zip(one, two):
            self.assertEqual(repr(a.parameters), repr(b.parameters))  # NaN is NaN

    def test_notes_of_guesses_are_told(self):
        path = self.folder / "bare.csv"
        strain, stress = hardening_curve(1e6)
        # A force beside the stress, which is not taken.
        np.savetxt(path, np.column_stack([100.0 * strain, 1e-6 * stress]), delimiter=",",
                   header="Strain (%),Stress (MPa)", comments="")
        said = command("calibrate", path, "--dry-run", folder=self.folder)
        self.assertIn("bare", said)
        fit = plastica.fit(path)[0]
        self.assertEqual(fit.status, "fitted")
        old = self.folder / "old.toml"
        old.write_text(f"""[fit]
objective = "strain-path"
[[target]]
files = "{path}"
strain = {{ column = "Strain" }}
stress = {{ column = "Stress" }}
""")
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            plastica.fit(old)
        self.assertEqual([one.category for one in told], [plastica.SceneWarning])
        self.assertIn("strain-path is now path", str(told[0].message))

    def test_warnings_of_the_curve_are_there(self):
        strain = np.linspace(0.0, 1e-3, 50)
        fit = plastica.fit((strain, 2e11 * strain), accept=True)[0]
        self.assertTrue(any("elastic to its end" in line for line in fit.warnings), fit.warnings)

    def test_masked_samples_are_missing_and_imaginary_ones_refused(self):
        strain, stress = hardening_curve(1e6)
        spoiled = stress.copy()
        spoiled[100:120] = 9e9
        masked = np.ma.masked_greater(spoiled, 1e9)
        good = plastica.fit({"a": (strain, np.where(masked.mask, np.nan, stress))})["a"]
        fit = plastica.fit({"a": (strain, masked)})["a"]
        self.assertEqual(repr(fit.parameters), repr(good.parameters))
        self.assertRefuses(lambda: plastica.fit((strain, stress + 1j)), "imaginary")

    def test_a_lone_fit_is_had_from_all(self):
        fits = plastica.fit(hardening_curve(1e6))
        self.assertEqual(repr(fits.parameters), repr(fits[0].parameters))
        self.assertEqual(list(fits[0].to_dataframe().index), list(fits.parameters))
        two = plastica.fit({"a": hardening_curve(1e6), "b": hardening_curve(1e6, 2)})
        self.assertRefuses(lambda: two.parameters, "2 fits")

    def test_options_are_not_swallowed(self):
        demo = DATA / "fits" / "demo.toml"
        self.assertRefuses(lambda: plastica.fit(demo, bootstrap=-5), "bootstrap")
        self.assertRefuses(lambda: plastica.fit(demo, confidence=0.0), "the fit file says")
        curve = hardening_curve()
        self.assertRefuses(lambda: plastica.fit(curve, options={"parameters": {}}), "argument")
        for threads in (None, "a", 10**10, -1, True):
            self.assertRefuses(lambda t=threads: plastica.fit(curve, threads=t), "threads")


if __name__ == "__main__":
    unittest.main()
