"""The cost of a fit as a function, for searches and samplers of the user's own."""

from __future__ import annotations

from typing import Any, Mapping, Sequence

import numpy.typing as npt

from . import _core
from ._numbers import numbers
from .errors import refuse
from .fit import Parameters, _asked, _Intervals
from .fields import Material, Section
from .response import Floats

__all__ = ["Problem", "problem"]


class Problem:
    """One specimen's curve and the model that is to follow it.

    The unknowns are the parameters of a fit but for a break strain, which is not searched: it
    follows from the others. Values are in SI; priors, the elastic slope's too, are not in it.
    """

    def __init__(self, curve: Any, asked: Mapping[str, Any], accept: bool) -> None:
        self._made_of = (curve, dict(asked), accept)
        fits = _asked(curve, asked, _Intervals(), None, accept)
        if not isinstance(fits, _core.CurveFits):
            raise refuse("curve", curve, "goes through scenes: must be a specimen's curve")
        self._core = fits.problem()

    def __reduce__(self) -> tuple[Any, ...]:
        return Problem, self._made_of

    @property
    def parameters(self) -> list[str]:
        """Paths of the unknowns (n)."""
        return self._core.parameters

    @property
    def start(self) -> Floats:
        """Where a fit begins [SI] (n)."""
        return self._core.start

    @property
    def bounds(self) -> tuple[Floats, Floats]:
        """Lower and upper bounds [SI] (n each), as `scipy.optimize.least_squares` takes them."""
        return self._core.lower, self._core.upper

    @property
    def strain(self) -> Floats:
        """Of the corrected curve [1] (n_samples)."""
        return self._core.strain

    @property
    def stress(self) -> Floats:
        """Of the corrected curve [Pa] (n_samples)."""
        return self._core.stress

    def model(self, x: npt.ArrayLike) -> Floats:
        """The model's stress at these strains [Pa] (n_samples).

        Raises
        ------
        InputError
            Where the model cannot be run: a sampler asks `cost` first, which is infinite there.
        """
        return self._core.model(numbers(x, "x"))

    def residuals(self, x: npt.ArrayLike) -> Floats:
        """sqrt(w_i) (model - measured), w_i the weights of the objective, whose sum is 1; and last
        that of the break term, 0 where the model yields as the specimen did [Pa] (n_samples + 1).
        Their squares add up to `cost`.

        Raises
        ------
        InputError
            Where the model cannot be run.
        """
        return self._core.residuals(numbers(x, "x"))

    def jacobian(self, x: npt.ArrayLike) -> Floats:
        """Derivatives of the residuals by the unknowns, exact [Pa/SI] (n_samples + 1, n)."""
        return self._core.jacobian(numbers(x, "x"))[0]

    def cost(self, x: npt.ArrayLike) -> float:
        """The sum of the squared residuals [Pa^2]; infinite where the model cannot be run."""
        return self._core.cost(numbers(x, "x"))

    def __repr__(self) -> str:
        return f"<Problem: {len(self.strain)} samples; {', '.join(self.parameters)}>"


def problem(
    curve: Any,
    *,
    parameters: Parameters | None = None,
    fixed: Mapping[str, float | str] | None = None,
    material: Material | str | Mapping[str, Any] | None = None,
    section: Section | Mapping[str, Any] | None = None,
    test: str | None = None,
    measure: str | None = None,
    loading: str | None = None,
    corrections: Mapping[str, Any] | None = None,
    characteristics: Mapping[str, Any] | None = None,
    columns: Mapping[str, str] | None = None,
    options: Mapping[str, Any] | None = None,
    accept: bool = False,
) -> Problem:
    """What `fit` searches, as a function; the arguments are those of `fit`, of one specimen.

    Raises
    ------
    InputError
        As `fit`, for several specimens, and for one that cannot be fitted.

    Examples
    --------
    >>> asked = plastica.problem((strain, stress), parameters=["youngs_modulus", "yield_stress"])
    >>> scipy.optimize.least_squares(asked.residuals, asked.start, asked.jacobian, asked.bounds,
    ...                              x_scale=asked.start)
    """
    return Problem(
        curve, {"parameters": parameters, "fixed": fixed, "material": material,
                "section": section, "test": test, "measure": measure, "loading": loading,
                "corrections": corrections, "characteristics": characteristics, "groups": None,
                "columns": columns, "group_by": (), "options": options, "confidence": None},
        accept)
