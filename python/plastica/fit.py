"""Fits: parameters from measured curves."""

from __future__ import annotations

import re
import tempfile
import warnings as _warnings
from dataclasses import dataclass
from os import PathLike, fspath
from pathlib import Path
from typing import Any, Iterator, Mapping, Sequence, Union

import numpy as np

from . import _core, _toml
from ._numbers import check_aligned, numbers
from ._progress import Progress, reporter
from ._table import Table
from .errors import InputError, SceneWarning, refuse
from .fields import Material, Section
from .fits import Fits
from .model import _thread_count

__all__ = ["fit"]

Path_ = Union[str, "PathLike[str]"]
Bounds = Union[tuple[Any, Any], list[Any]]
Parameters = Union[Sequence[str], Mapping[str, Union[None, Bounds, Mapping[str, Any]]]]

_COLUMNS = ("strain", "elongation", "gauge_length", "stress", "force", "area", "decimal", "sheet",
            "path", "table")


def fit(
    curves: Any,
    *,
    parameters: Parameters | None = None,
    fixed: Mapping[str, float | str] | None = None,
    laws: Sequence[str] | str | None = None,
    material: Material | str | Mapping[str, Any] | None = None,
    section: Section | Mapping[str, Any] | None = None,
    test: str | None = None,
    measure: str | None = None,
    loading: str | None = None,
    corrections: Mapping[str, Any] | None = None,
    characteristics: Mapping[str, Any] | None = None,
    groups: Mapping[str, Mapping[str, Any]] | None = None,
    columns: Mapping[str, str] | None = None,
    group_by: Sequence[str] = (),
    options: Mapping[str, Any] | None = None,
    profile: bool = False,
    bootstrap: int = 0,
    bootstrap_block: int = 1,
    bootstrap_specimens: int = 0,
    confidence: float | None = None,
    accept: bool = False,
    threads: int = 0,
    progress: Progress = None,
) -> Fits:
    """Fits parameters to measured curves, each specimen by itself and all in parallel.

    Parameters
    ----------
    curves
        - a pair ``(strain, stress)`` of arrays [1, Pa], or a DataFrame with columns of these names,
          which may have units, ``"Stress [MPa]"``;
        - a mapping from names of specimens to such pairs or DataFrames;
        - the path of a file of curves (CSV, .xlsx, HDF5), or several of these;
        - the path of a fit file, ``"fit.toml"``, which then says all but laws and intervals; its
          targets may be curves of beams, fitted through scenes.
    parameters : sequence of str, or mapping
        Names of material fields, ``"yield_stress"``. A mapping gives each None, its bounds
        ``(lower, upper)``, or a table as files have it: ``{"bounds": …, "start": …, "scale": …,
        "prior": {"mean": …, "standard_deviation": …}}`` or ``{"tie": name, "factor": …}``.
        Default: Young's modulus, yield stress and break strain.
    fixed : mapping
        Values of parameters that are held [SI].
    laws : sequence of str
        Hardening laws that are fitted and compared: ``"ideal"``, ``"linear"``, ``"voce"``,
        ``"chaboche"``, ``"multilinear"``.
    material, section
        Of the beam; what is not given is as a fit file leaves it.
    test : {"tension", "bending", "torsion"}
    measure : {"engineering", "true"}
    loading : {"monotonic", "cyclic"}
        Default: found out.
    corrections, characteristics : mapping
        As ``[target.corrections]`` and ``[target.characteristics]`` of a fit file.
    groups : mapping
        Of curves in arrays: for each specimen's name what groups it, ``{"lot": "A"}``.
    columns : mapping
        Of files of curves: which column is what, ``{"strain": "Strain", "stress": "Stress:MPa"}``,
        as the options of ``plastica calibrate``; ``"table": "FILE:KEY"``. Default: guessed.
    group_by : sequence of str
        Of files of curves: columns of the table that form groups.
    options : mapping
        Further keys of ``[fit]``: ``{"objective": "least-squares", "noise": 1e6, "seed": 3}``.
    profile : bool
        Find likelihood intervals of all parameters, too.
    bootstrap, bootstrap_block, bootstrap_specimens : int
        Resample so many times: residuals (in blocks), and specimens for the means of groups.
    confidence : float
        Of the intervals. Default: 0.95.
    accept : bool
        Fit curves that are those of no material, too.
    threads : int
        0: as many as the machine has. Results have the same bits for any number; a specimen's name
        decides the seed of its search.
    progress : bool or callable
        True prints a line; a callable is given the fraction done, and 1.

    Returns
    -------
    Fits
        A fit for each specimen (and law). A curve that cannot be fitted has its status and reason.

    Raises
    ------
    InputError
        For bad input: of options, and of curves that are no curves (of two lengths, or empty).
    KeyboardInterrupt
        On Ctrl-C.

    Examples
    --------
    >>> fits = plastica.fit({"a": (strain, stress)}, parameters=["youngs_modulus", "yield_stress"])
    >>> fits["a"].parameters["yield_stress"].value
    """
    asked = _asked(
        curves, {"parameters": parameters, "fixed": fixed, "material": material,
                 "section": section, "test": test, "measure": measure, "loading": loading,
                 "corrections": corrections, "characteristics": characteristics, "groups": groups,
                 "columns": columns, "group_by": group_by, "options": options,
                 "confidence": confidence},
        _Intervals(profile, bootstrap, bootstrap_block, bootstrap_specimens), laws, accept)
    report = reporter(progress, "fit", 1.0)
    count = _thread_count(threads)
    if isinstance(asked, _core.CurveFits):
        return Fits(asked.run(count, report))
    with tempfile.TemporaryDirectory() as folder:
        return Fits(asked.run(str(Path(folder) / "journal"), count, report))


@dataclass(frozen=True)
class _Intervals:
    profile: bool = False
    bootstrap: int = 0
    block: int = 1
    specimens: int = 0

    def keys(self) -> dict[str, Any]:
        """As [fit] has them."""
        return {**({"profile": True} if self.profile else {}),
                **({"bootstrap": self.bootstrap} if self.bootstrap != 0 else {}),
                **({"bootstrap_block": self.block} if self.block != 1 else {}),
                **({"bootstrap_specimens": self.specimens} if self.specimens != 0 else {})}


def _asked(curves: Any, said: Mapping[str, Any], intervals: _Intervals,
           laws: Sequence[str] | str | None, accept: bool) -> _core.CurveFits | _core.SceneFits:
    """What is to be fitted, and how, for the engine."""
    asked: _core.CurveFits | _core.SceneFits
    if _is_path(curves) and fspath(curves).endswith(".toml"):
        for name, value in said.items():
            if value is not None and not (isinstance(value, (list, tuple)) and not value):
                raise refuse(name, None, f"is what the fit file says: {fspath(curves)}")
        asked = _of_fit_file(fspath(curves), accept)
        asked.set_intervals(intervals.profile, intervals.bootstrap, intervals.block,
                            intervals.specimens)
        if laws is not None:
            asked.set_laws(_laws(laws))
    else:
        text = _text(said, {**intervals.keys(), **({} if laws is None else {"laws": _laws(laws)})})
        if isinstance(curves, Iterator):
            curves = list(curves)
        is_files = _is_path(curves) or _is_list_of_paths(curves)
        for name in ("groups",) if is_files else ("columns", "group_by"):
            if said[name]:
                where = "curves in arrays" if is_files else "files of curves"
                raise refuse(name, None, f"is of {where}")
        asked = (_of_files(curves, text, said, accept) if is_files
                 else _core.CurveFits.of_curves(text, _curves(curves, said["groups"] or {}), accept))
    for note in asked.notes:
        _warnings.warn(note, SceneWarning, stacklevel=3)
    return asked


def _is_path(value: Any) -> bool:
    return isinstance(value, (str, PathLike))


def _is_list_of_paths(value: Any) -> bool:
    return isinstance(value, (list, tuple)) and len(value) > 0 and all(map(_is_path, value))


def _laws(laws: Sequence[str] | str) -> list[str]:
    return [laws] if isinstance(laws, str) else list(laws)


def _of_fit_file(path: str, accept: bool) -> _core.CurveFits | _core.SceneFits:
    return _core.SceneFits(path) if _core.names_scenes(path) else _core.CurveFits.of_file(path, accept)


def _of_files(curves: Any, text: str, said: Mapping[str, Any], accept: bool) -> _core.CurveFits:
    files = [curves] if _is_path(curves) else list(curves)
    columns = dict(said["columns"] or {})
    for key in columns:
        if key not in _COLUMNS:
            raise refuse(f"columns.{key}", columns[key], f"is none of {', '.join(_COLUMNS)}")
    columns.update({key: said[key] for key in ("test", "measure") if said[key]})
    paths = sorted(fspath(each) for each in files)
    try:
        return _core.CurveFits.of_bare_files(paths, columns, list(said["group_by"]), text, accept)
    except InputError as error:
        # The reader speaks of the command's options.
        field = (error.field or "").replace("--load", "--force").replace("-", "_")
        name = field.lstrip("_")
        if field.startswith("__"):
            field = f"columns.{name}" if name in _COLUMNS else name
        raise InputError(error.file, error.line, field or None, error.value, error.rule) from None


_MATERIAL = "material."


def _unit_of(name: str) -> str:
    """Unit of a parameter by its path or its last part; "" of one that there is not."""
    for field in _core.fields():
        path = field["path"]
        if path == name or path.startswith(_MATERIAL) and path.rpartition(".")[2] == name:
            return str(field["unit"])
    return ""


def _parameters(parameters: Parameters | None, fixed: Mapping[str, Any] | None) -> dict[str, Any]:
    if isinstance(parameters, str):
        raise refuse("parameters", parameters, "must be a list of names")
    result: dict[str, Any] = {}
    if parameters is None:
        parameters = [] if not fixed else [
            name for name in ("youngs_modulus", "yield_stress", "break_strain") if name not in fixed]
    for name in parameters:
        given = parameters[name] if isinstance(parameters, Mapping) else None
        if given is None:
            given = {}
        elif not isinstance(given, Mapping):
            if not isinstance(given, (list, tuple, np.ndarray)):
                raise refuse(f"parameters.{name}", given, "must be bounds (lower, upper) or a table; "
                             "a value that is held goes into fixed")
            given = {"bounds": list(given)}
        result[name] = _parameter(_toml.plain(given), _unit_of(name))
    for name, value in (fixed or {}).items():
        if name in result:
            raise refuse(f"fixed.{name}", value, "is among the parameters, too")
        result[name] = _parameter({"value": _toml.plain(value), "fixed": True}, _unit_of(name))
    return result


def _parameter(table: dict[str, Any], unit: str) -> dict[str, Any]:
    """A parameter's table with units; infinite bounds are those that the fit finds."""
    result: dict[str, Any] = {}
    for key, value in table.items():
        if key in ("bounds", "start", "value"):
            result[key] = _toml.give_unit(_auto(value) if key == "bounds" else value, unit)
        elif key == "prior" and isinstance(value, dict):
            result[key] = {name: _toml.give_unit(each, unit) for name, each in value.items()}
        else:
            result[key] = value
    return result


def _auto(bounds: Any) -> Any:
    if not isinstance(bounds, list):
        return bounds
    return ["auto" if each is None or each in (float("inf"), -float("inf")) else each
            for each in bounds]


def _text(said: Mapping[str, Any], intervals: Mapping[str, Any]) -> str:
    """What a fit file would say besides its targets."""
    for key in said["options"] or {}:
        if key == "parameters" or key in intervals:
            raise refuse(f"options.{key}", None, "is an argument of its own")
    table = {**(said["options"] or {}), **intervals,
             "parameters": _parameters(said["parameters"], said["fixed"])}
    if said["confidence"] is not None:
        table["confidence"] = said["confidence"]
    tree: dict[str, Any] = {"fit": _toml.with_units(_toml.plain(table), "fit")}
    for key in ("material", "section"):
        value = said[key]
        if value is not None:
            given = value.to_dict() if isinstance(value, Table) else _toml.plain(value)
            tree[key] = _toml.with_units(given, key)
    target = ("test", "measure", "loading", "corrections", "characteristics")
    defaults = _toml.with_units(_toml.plain({key: said[key] for key in target}), "target")
    if defaults:
        tree["target_defaults"] = defaults
    return _toml.write(tree)


_Given = tuple[str, Any, Any, list[tuple[str, str]]]


def _curves(curves: Any, groups: Mapping[str, Mapping[str, Any]]) -> list[_Given]:
    if not isinstance(curves, Mapping) or _is_frame(curves):
        curves = {"specimen": curves}
    if not curves:
        raise refuse("curves", None, "has no curve")
    for name in groups:
        if name not in curves:
            raise refuse(f"groups.{name}", None, "is the name of no curve")
    result = []
    for name, curve in curves.items():
        strain, stress = _pair(str(name), curve)
        group = [(str(key), str(value)) for key, value in groups.get(name, {}).items()]
        result.append((str(name), strain, stress, group))
    return result


def _is_frame(value: Any) -> bool:
    return hasattr(value, "columns") and hasattr(value, "iloc")


_HEADER = re.compile(r"(.*?)\s*(?:\[(.*)\]|\((.*)\))?\s*\Z")


def _column(name: str, frame: Any, wanted: str) -> Any:
    """A column of a table by its name, in SI by the unit in its header."""
    headers = [(column, _HEADER.match(str(column).strip())) for column in frame.columns]
    found = [(column, words[2] or words[3]) for column, words in headers
             if words is not None and words[1].lower() == wanted]
    if len(found) != 1:
        there = ", ".join(str(column) for column in frame.columns)
        raise refuse(name, None, f"has {len(found) or 'no'} column{'s' if found else ''} {wanted}: {there}")
    column, unit = found[0]
    if unit is None:
        return frame[column]
    scale, offset = _core.unit_conversion(unit, wanted, str(column))
    return scale * numbers(frame[column], name) + offset


def _pair(name: str, curve: Any) -> tuple[Any, Any]:
    if _is_frame(curve):
        curve = (_column(name, curve, "strain"), _column(name, curve, "stress"))
    if _is_path(curve):
        raise refuse(name, curve, "is a path: give paths without names, in a list")
    if not isinstance(curve, (tuple, list)) or len(curve) != 2:
        raise refuse(name, None, "must be a pair (strain, stress) of arrays, or a DataFrame")
    check_aligned(curve[0], curve[1], name)
    return numbers(curve[0], name), numbers(curve[1], name)
