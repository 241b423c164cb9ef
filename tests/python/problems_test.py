"""The cost of a fit as a function: its derivatives, and SciPy's optimum, which is ours."""

import pickle
import unittest

import numpy as np
from scipy.optimize import least_squares

import plastica
from support import DATA, TestCase, hardening_curve

CURVE = DATA / "targets" / "al6061-t651-20c.csv"


class Problems(TestCase):
    def test_scipy_finds_the_same_optimum(self):
        strain, stress = hardening_curve(1e6)
        how = {"parameters": ["youngs_modulus", "yield_stress", "tangent_modulus"],
               "material": {"hardening": {"law": "linear"}}, "options": {"modulus_prior": False}}
        asked = plastica.problem((strain, stress), **how)
        self.assertEqual([path.rpartition(".")[2] for path in asked.parameters], how["parameters"])
        found = least_squares(asked.residuals, asked.start, asked.jacobian, asked.bounds,
                              x_scale=asked.start, xtol=1e-14, ftol=1e-15, gtol=1e-15)
        fit = plastica.fit((strain, stress), **how)[0]
        values = np.array([fit.parameters[name].value for name in how["parameters"]])
        # The cost is flat at its least: half of its 16 digits are those of the values.
        np.testing.assert_allclose(found.x, values, rtol=1e-7)
        self.assertAlmostEqual(asked.cost(values), 2.0 * found.cost, delta=1e-9 * found.cost)

    def test_the_jacobian_is_that_of_differences(self):
        strain, stress = plastica.fit(str(CURVE))[0].measured
        asked = plastica.problem((strain, stress), options={"modulus_prior": False})
        for x in (asked.start, 0.7 * asked.start, np.array([1.0, 20.0]) * asked.start):
            exact = asked.jacobian(x)
            self.assertEqual(exact.shape, (len(asked.strain) + 1, 2))
            for k in range(2):
                step = np.zeros(2)
                step[k] = 1e-6 * x[k]
                slope = (asked.residuals(x + step) - asked.residuals(x - step)) / (2.0 * step[k])
                scale = np.abs(exact[:, k]).max()
                np.testing.assert_allclose(exact[:, k], slope, atol=1e-7 * scale + 1e-30)
        residuals = asked.residuals(asked.start)
        self.assertAlmostEqual(asked.cost(asked.start), np.sum(residuals**2),
                               delta=1e-12 * np.sum(residuals**2))
        off = asked.model(asked.start) - asked.stress
        weights = np.divide(residuals[:-1], off, where=off != 0.0, out=np.zeros(len(off))) ** 2
        self.assertAlmostEqual(weights.sum(), 1.0, delta=0.02)  # samples that are met have none
        # Of the path: half of what lies on both sides.
        steps = np.abs(np.diff(asked.strain))
        path = 0.5 * (np.r_[steps, 0.0] + np.r_[0.0, steps]) / steps.sum()
        np.testing.assert_allclose(weights[off != 0.0], path[off != 0.0], rtol=1e-9)

    def test_a_problem_s_mistakes_are_told(self):
        curve = hardening_curve()
        self.assertRefuses(lambda: plastica.problem({"a": curve, "b": curve}), "one specimen")
        asked = plastica.problem(curve)
        self.assertRefuses(lambda: asked.residuals([1.0]), "x", "2 numbers")
        self.assertRefuses(lambda: asked.residuals([-1.0, 1.0]), "cannot be run")
        self.assertEqual(asked.cost([-1.0, 1.0]), float("inf"))
        self.assertRefuses(lambda: plastica.problem(curve, parameters={
            "youngs_modulus": None,
            "yield_stress": {"prior": {"mean": 3e8, "standard_deviation": 1e6}}}), "prior")
        self.assertRefuses(lambda: plastica.problem(DATA / "fits" / "bend_test.toml"), "scenes")

    def test_a_problem_is_pickled(self):
        asked = plastica.problem(hardening_curve(1e6))
        again = pickle.loads(pickle.dumps(asked))
        self.assertSameBits(again.residuals(asked.start), asked.residuals(asked.start))


if __name__ == "__main__":
    unittest.main()
