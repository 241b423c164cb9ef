"""Fits through scenes: parameters from tests of beams."""

from __future__ import annotations

import tempfile
import warnings as _warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Mapping, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _core, _toml
from ._numbers import check_aligned, numbers
from ._progress import Progress, reporter
from .errors import InputError, SceneWarning, refuse
from .fit import Parameters, _Intervals, _laws, _parameters
from .fits import Fits
from .model import _thread_count
from .response import Floats
from .scene import Scene
from .studies import _file_of

__all__ = ["BeamTest", "fit_scenes"]


@dataclass(frozen=True, kw_only=True)
class BeamTest:
    """A measured curve of a beam, and the scene that it was measured in.

    Attributes
    ----------
    scene : Scene or mapping
    abscissa, ordinate : array_like
        What was measured [SI] (n_samples each).
    probe : str
        The scene's probe that the ordinate is compared with.
    against : str
        What the abscissa is: the name of another probe, along the scene's own path; or what the
        scene follows: ``"support[2]"`` (translation or rotation of the second one), ``"load[1]"``,
        ``"strain"`` (of a coupon); or ``"time"`` of a motion.
    abscissa_factor, ordinate_factor : float
        Measured over the scene's: -1 where the machine counts against its axis.
    noise : float
        Standard deviation of the ordinate [SI]; default: estimated from the residuals.
    weight : float
        Of the test's squares, beside those of others.
    trim : float or "off"
        At the break: the abscissa beyond which the beam is broken [SI]; default: found.
    """

    scene: Scene | Mapping[str, Any]
    abscissa: npt.ArrayLike
    ordinate: npt.ArrayLike
    probe: str
    against: str
    abscissa_factor: float = 1.0
    ordinate_factor: float = 1.0
    noise: float | None = None
    weight: float | None = None
    trim: float | str | None = None


Tests = Union[BeamTest, Sequence[BeamTest], Mapping[str, BeamTest]]


def fit_scenes(
    tests: Tests,
    parameters: Parameters,
    *,
    fixed: Mapping[str, float | str] | None = None,
    laws: Sequence[str] | str | None = None,
    shared: bool = True,
    segments: int | str | None = None,
    within: float | None = None,
    options: Mapping[str, Any] | None = None,
    profile: bool = False,
    bootstrap: int = 0,
    bootstrap_block: int = 1,
    bootstrap_specimens: int = 0,
    confidence: float | None = None,
    threads: int = 0,
    progress: Progress = None,
) -> Fits:
    """Fits parameters to tests of beams, through the scenes in which they were measured.

    Parameters
    ----------
    tests : BeamTest, or several of them
        A mapping gives each its name.
    parameters : mapping
        For each path of a number of the scene, ``"yield_stress"`` or ``"solver.damping_time"``, its
        bounds or a table, as of `fit`; a free one needs both bounds.
    fixed : mapping
        Values of parameters that are held [SI].
    laws : sequence of str
        Hardening laws that are fitted and compared.
    shared : bool
        Whether all tests share the parameters in one fit, called ``"fit"``, or each is a fit of its own,
        with its name.
    segments : int or "auto"
        Of all beams, in place of the scenes'; ``"auto"`` takes the fewest that move no value by more
        than `within`.
    within : float
        A fraction of the value [1].
    options : mapping
        Further keys of ``[fit]``: ``{"starts": 1, "objective": "path"}``.
    profile, bootstrap, bootstrap_block, bootstrap_specimens, confidence, threads, progress
        As of `fit`.

    Raises
    ------
    InputError
        For bad input.
    KeyboardInterrupt
        On Ctrl-C.

    Examples
    --------
    >>> test = plastica.BeamTest(scene=scene, abscissa=displacement, ordinate=force, probe="force",
    ...                          against="support[2]", ordinate_factor=-1)
    >>> plastica.fit_scenes(test, {"yield_stress": (1e8, 2e9)})[0].parameters["yield_stress"]
    """
    named = _named(tests)
    for key in options or {}:
        if key == "parameters":
            raise refuse(f"options.{key}", None, "is an argument of its own")
    intervals = _Intervals(profile, bootstrap, bootstrap_block, bootstrap_specimens).keys()
    table: dict[str, Any] = {**(options or {}), **intervals,
                             "parameters": _parameters(parameters, fixed)}
    given = {"laws": None if laws is None else _laws(laws), "segments": segments, "within": within,
             "confidence": confidence, "shared": None if shared else False}
    table.update({key: value for key, value in given.items() if value is not None})
    count, report = _thread_count(threads), reporter(progress, "fit", 1.0)
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        # Names of files are patterns: those of tests are given afterwards.
        tree = {"fit": _toml.plain(table),
                "target": [_target(name, test, folder, f"test_{k}")
                           for k, (name, test) in enumerate(named.items())]}
        path = folder / "fit.toml"
        path.write_text(_toml.write(tree), encoding="utf-8")
        try:
            asked = _core.SceneFits(str(path))
            asked.rename(list(named))
            for note in asked.notes:
                _warnings.warn(note, SceneWarning, stacklevel=2)
            return Fits(asked.run(str(folder / "journal"), count, report))
        except InputError as error:
            if error.file is not None and not error.file.startswith(place):
                raise
            # Files that nobody has written would only confuse.
            stem = Path(error.file).stem if error.file else ""
            number = stem.removeprefix("test_")
            known = stem != number and number.isdigit() and int(number) < len(named)
            field = f"{list(named)[int(number)]}: {error.field}" if known else error.field
            raise InputError(None, None, field, error.value, error.rule) from None


def _named(tests: Tests) -> dict[str, BeamTest]:
    if isinstance(tests, BeamTest):
        return {"test": tests}
    if not isinstance(tests, Mapping):
        tests = {f"test_{k + 1}": test for k, test in enumerate(tests)}
    if not tests:
        raise refuse("tests", None, "has no test")
    for name, test in tests.items():
        if not name:
            raise refuse("tests", name, "must be a name")
        if not isinstance(test, BeamTest):
            raise refuse(f"tests.{name}", None, f"is a {type(test).__name__}: must be a BeamTest")
    return dict(tests)


def _column(name: str, what: str, values: npt.ArrayLike) -> Floats:
    column = numbers(values, f"{name}.{what}")
    if column.ndim != 1:
        raise refuse(f"{name}.{what}", None, "must be one row of numbers")
    return column


def _target(name: str, test: BeamTest, folder: Path, stem: str) -> dict[str, Any]:
    """A [[target]], whose scene and curve are written into the folder."""
    scene = test.scene if isinstance(test.scene, Scene) else Scene.from_dict(test.scene)
    own = folder / f"{stem}.scene"
    own.mkdir()
    units = scene.read_by(lambda text, path: _core.PreparedScene(text, path, [])).probe_units
    if test.probe not in units:
        raise refuse(f"{name}.probe", test.probe, f"is no probe of the scene; it has {', '.join(units)}")
    abscissa, ordinate = (_column(name, what, getattr(test, what))
                          for what in ("abscissa", "ordinate"))
    check_aligned(test.abscissa, test.ordinate, name)
    if len(abscissa) != len(ordinate):
        raise refuse(f"{name}.ordinate", None, f"has {len(ordinate)} numbers and the abscissa "
                     f"{len(abscissa)}: must be as many of both")
    unit, source = _abscissa(name, test, scene, units)
    header = f"abscissa [{unit}],ordinate [{units[test.probe]}]"
    rows = (",".join("" if np.isnan(each) else repr(float(each)) for each in row)
            for row in zip(abscissa, ordinate))
    (folder / f"{stem}.csv").write_text("\n".join([header, *rows]) + "\n", encoding="utf-8")
    target: dict[str, Any] = {
        "files": f"{stem}.csv", "scene": _file_of(scene, own),
        "abscissa": {**source, "column": "abscissa", "factor": float(test.abscissa_factor)},
        "ordinate": {"probe": test.probe, "column": "ordinate",
                     "factor": float(test.ordinate_factor)},
    }
    if test.noise is not None:
        target["noise"] = _toml.give_unit(_toml.plain(test.noise), units[test.probe])
    if test.weight is not None:
        target["weight"] = float(test.weight)
    if test.trim is not None:
        target["trim"] = _toml.give_unit(_toml.plain(test.trim), unit)
    return target


def _acts(vector: Any) -> bool:
    """Whether a vector of numbers, or of texts that begin with one, is there and not 0."""
    return vector is not None and any(float(str(each).split()[0]) != 0.0 for each in vector)


def _abscissa(name: str, test: BeamTest, scene: Scene,
              units: Mapping[str, str]) -> tuple[str, dict[str, Any]]:
    """Unit of the abscissa, and what says what it is."""
    against = test.against
    if against in units:
        return units[against], {"probe": against}
    if against == "time":
        return "s", {"time": True}
    if against == "strain":
        return "1", {"drive": against}
    driven = {f"support[{k + 1}]": "support.translation" if _acts(item.translation)
              else "support.rotation" for k, item in enumerate(scene.supports)}
    driven.update({f"load[{k + 1}]": "load.force" if _acts(item.force) else "load.moment"
                   for k, item in enumerate(scene.loads)})
    if against in driven:
        kind, _, key = driven[against].partition(".")
        return _core.item_units()[kind][key][0], {"drive": against}
    raise refuse(f"{name}.against", against, "is neither a probe of the scene nor \"time\", "
                 "\"strain\", or a support or load that it has, \"support[1]\"")
