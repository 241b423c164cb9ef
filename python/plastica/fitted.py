"""What one fit gives."""

from __future__ import annotations

import html
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from . import _core
from .errors import refuse
from .response import Floats

if TYPE_CHECKING:
    import pandas

    from .fits import Fits

__all__ = ["Fit", "Parameter"]


@dataclass(frozen=True)
class Parameter:
    """What a fit says of one parameter [SI]; NaN where there is nothing to be said."""

    name: str
    """``"yield_stress"``"""
    path: str
    """``"material.yield_stress"``"""
    unit: str
    role: str
    """``"free"``, ``"fixed"`` or ``"tied"``"""
    value: float
    error: float
    """Standard error, from noise, sampling and misfit."""
    interval: tuple[float, float]
    """Confidence interval, from all of these errors together."""
    verdict: str | None
    """How well the curves determine it: ``"identified"``, ``"weak"``, ``"at bound"``, …; None where
    nothing was judged."""
    noise_error: float
    sampling_error: float
    misfit_error: float
    start: float
    bounds: tuple[float, float]
    degrees_of_freedom: float
    """Of the noise in the error; infinite where it was stated."""

    @staticmethod
    def _of(one: _core.FittedParameter) -> Parameter:
        return Parameter(
            one.name, one.path, one.unit, one.role, one.value, one.error, one.interval, one.verdict,
            one.noise_error, one.sampling_error, one.misfit_error, one.start, one.bounds,
            one.degrees_of_freedom)


class Fit:
    """The fit of one specimen's curve, or one through scenes."""

    def __init__(self, fits: Fits, index: int) -> None:
        self._fits, self._index = fits, index
        self._record = fits._contents.record(index)

    @property
    def name(self) -> str:
        """Of the specimen; of a fit that shares its parameters that of the fit."""
        return self._record.name

    @property
    def status(self) -> str:
        """``"fitted"``, ``"failed"`` or ``"rejected"``"""
        return self._record.status

    @property
    def reason(self) -> str:
        """Why it is not fitted."""
        if isinstance(self._record, _core.CurveFit) and self.status == "rejected":
            return self._record.target_reason or self._record.reason
        return self._record.reason

    @property
    def usable(self) -> bool:
        """Whether it is fitted and may be used at all: the misfit is below half of the largest
        value, and no more than one parameter is at a bound. How good it is, `warnings` and the
        verdicts say."""
        return self._record.usable

    @property
    def why_unusable(self) -> str:
        """A sentence; empty if it may be used, or is not fitted."""
        return self._record.why_unusable

    @property
    def law(self) -> str:
        """The hardening law that was fitted."""
        return self._record.law

    @property
    def parameters(self) -> dict[str, Parameter]:
        """By their names."""
        return {one.name: Parameter._of(one) for one in self._record.parameters}

    @property
    def warnings(self) -> list[str]:
        """What a reader must not overlook, of the curve and of its fit."""
        of_curve = self._record.target_warnings if isinstance(self._record, _core.CurveFit) else []
        return [*of_curve, *self._record.warnings]

    @property
    def held_out(self) -> float:
        """Where laws are compared: what fits without one part of the curves leave of that part, root
        mean square over the largest value [1]; else NaN."""
        return self._record.held_out

    @property
    def correlation(self) -> pandas.DataFrame:
        """Of the parameters that were searched."""
        import pandas

        names = self._record.correlated
        return pandas.DataFrame(self._record.correlation, index=names, columns=names)

    @property
    def profiles(self) -> dict[str, dict[str, Any]]:
        """Of each free parameter, where they were asked for: ``interval``, ``value``, ``rise``."""
        return self._record.profiles

    @property
    def bootstrap(self) -> dict[str, Any] | None:
        """Where it was asked for: ``values`` (n_made, n_free), ``error`` and ``interval`` by name."""
        return self._record.bootstrap

    @property
    def bootstrap_specimens(self) -> dict[str, Any] | None:
        """The same of resampled specimens."""
        return self._record.bootstrap_specimens

    @property
    def evaluations(self) -> int:
        """Of the cost, in all searches."""
        return self._record.evaluations

    def _curve(self) -> _core.CurveFit:
        if not isinstance(self._record, _core.CurveFit):
            raise refuse(self.name, None, "is fitted through scenes: its curves are in targets")
        return self._record

    @property
    def measured(self) -> tuple[Floats, Floats]:
        """Strain [1] and stress [Pa] as they were given (n_samples each)."""
        return self._curve().measured

    @property
    def corrected(self) -> tuple[Floats, Floats]:
        """Strain and stress as they were fitted: repaired, corrected, up to the break."""
        return self._curve().corrected

    @property
    def fitted(self) -> tuple[Floats, Floats]:
        """Strain and stress of the fitted model at the corrected samples, and where it breaks."""
        return self._curve().fitted

    @property
    def characteristics(self) -> dict[str, float | None]:
        """Of the curve after ISO 6892-1: ``youngs_modulus``, ``proof_stress``, ``rm``, … [SI]; None where it
        has none."""
        return self._curve().characteristics

    @property
    def repairs(self) -> list[str]:
        """What was mended and corrected in the curve."""
        return self._curve().repairs

    @property
    def group(self) -> dict[str, str]:
        return self._curve().group

    @property
    def misfit(self) -> float:
        """Root of the mean squared residual [Pa]; NaN without a fit."""
        return self._curve().misfit if self.status == "fitted" else float("nan")

    @property
    def misfit_word(self) -> str:
        """``"close"``, ``"fair"`` or ``"poor"``: how closely the law follows the curve."""
        return self._curve().misfit_word

    @property
    def runs_test_p(self) -> float:
        """Probability of so few runs of one sign, if the residuals were noise; NaN for fewer than 20
        samples."""
        return self._curve().runs_test_p

    @property
    def break_strain_total(self) -> float | None:
        """Total strain at which the fitted model breaks [1]."""
        return self._curve().break_strain_total

    @property
    def misfit_fraction(self) -> float:
        """The same over the largest measured stress [1]; of a fit through scenes that of the target
        with the largest. NaN without a fit."""
        if self.status != "fitted":
            return float("nan")
        if isinstance(self._record, _core.CurveFit):
            return self._record.misfit_fraction
        return max((one["misfit_fraction"] for one in self.targets.values()), default=float("nan"))

    @property
    def targets(self) -> dict[str, dict[str, Any]]:
        """Of a fit through scenes, by target: ``abscissa``, ``ordinate``, ``fitted``, … [SI]."""
        if isinstance(self._record, _core.CurveFit):
            raise refuse(self.name, None, "is the fit of a curve: see measured and fitted")
        return self._record.targets

    @property
    def segments(self) -> dict[str, dict[str, Any]] | None:
        """Of a fit through scenes: what the number of segments does to each parameter."""
        if isinstance(self._record, _core.CurveFit):
            return None
        return self._record.segments

    def report(self) -> str:
        """What ``plastica show`` prints of it."""
        return self._record.report()

    def to_dataframe(self) -> pandas.DataFrame:
        """A row for each parameter: value, error, interval [SI], unit, verdict."""
        import pandas

        rows = [{"parameter": one.name, "value": one.value, "error": one.error,
                 "low": one.interval[0], "high": one.interval[1], "unit": one.unit,
                 "verdict": one.verdict or one.role} for one in self.parameters.values()]
        return pandas.DataFrame(rows).set_index("parameter") if rows else pandas.DataFrame()

    def plot(self, axes: Any = None) -> Any:
        """Draws the curve, measured and fitted, with matplotlib. Returns the axes."""
        import matplotlib.pyplot as plt

        if axes is None:
            axes = plt.figure().add_subplot()
        if isinstance(self._record, _core.CurveFit):
            for (strain, stress), label, style in (
                (self.measured, "measured", {"color": "0.8", "linestyle": "", "marker": "."}),
                (self.corrected, "corrected", {"color": "0.5", "linewidth": 3.0}),
                (self.fitted, f"fitted, {self.law}", {"color": "C0"})):
                if len(strain) > 0:
                    axes.plot(100.0 * strain, 1e-6 * stress, label=label, **style)
            axes.set(xlabel="strain [%]", ylabel="stress [MPa]", title=self.name)
        else:
            for name, target in self.targets.items():
                line, = axes.plot(target["abscissa"], target["ordinate"], ".", alpha=0.5,
                                  label=f"{name}, measured")
                if "fitted" in target:
                    axes.plot(target["abscissa"], target["fitted"], color=line.get_color(),
                              label=f"{name}, fitted")
            axes.set_title(self.name)
            for side, set_label in (("abscissa", axes.set_xlabel), ("ordinate", axes.set_ylabel)):
                said = {f'{one[f"{side}_name"]} [{one[f"{side}_unit"]}]'
                        for one in self.targets.values()}
                set_label(", ".join(sorted(said)))
        axes.legend()
        return axes

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self._fits).__getitem__, (self._fits, self._index)

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td>{html.escape(one.name)}</td><td>{one.value:.6g}</td><td>{one.error:.2g}</td>"
            f"<td>{one.interval[0]:.6g} … {one.interval[1]:.6g}</td><td>{html.escape(one.unit)}</td>"
            f"<td>{html.escape(one.verdict or one.role)}</td></tr>"
            for one in self.parameters.values())
        notes = "".join(f"<li>{html.escape(line)}</li>" for line in self.warnings)
        said = html.escape(self.status + (f": {self.reason}" if self.reason else ""))
        return (f"<p><b>{html.escape(self.name)}</b>, {html.escape(self.law)}: {said}</p>"
                "<table><tr><th>parameter</th><th>value</th><th>error</th><th>interval</th>"
                f"<th>unit</th><th></th></tr>{rows}</table>"
                + (f"<ul>{notes}</ul>" if notes else ""))

    def __repr__(self) -> str:
        said = ", ".join(f"{one.name} {one.value:.6g} ± {one.error:.2g} {one.unit}"
                         for one in self.parameters.values())
        return f"<Fit {self.name}, {self.law}: {self.status}{': ' + said if said else ''}>"
