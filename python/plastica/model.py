"""Models: a scene that is checked and laid out once, and run many times."""

from __future__ import annotations

import copy
import warnings as _warnings
from dataclasses import dataclass
from typing import Any, Callable, Mapping, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._numbers import is_pandas, numbers
from ._progress import Progress, reporter
from .errors import SceneWarning, refuse
from .response import Floats, Integers, Response, Simulation
from .scene import Scene

__all__ = ["Batch", "Model", "Sensitivity", "prepare", "simulate"]

Values = Union[Sequence[float], npt.ArrayLike, Mapping[str, float]]


def _prepared(scene: Scene | Mapping[str, Any], parameters: Sequence[str]) -> _core.PreparedScene:
    if not isinstance(scene, Scene):
        scene = Scene.from_dict(scene)
    if isinstance(parameters, str):
        raise refuse("parameters", parameters, "must be a list of paths")
    paths = list(parameters)
    return scene.read_by(lambda text, name: _core.PreparedScene(text, name, paths))


def simulate(scene: Scene | Mapping[str, Any], *, progress: Progress = None) -> Simulation:
    """Simulates a scene: what the beam does.

    Parameters
    ----------
    scene : Scene or mapping
        A mapping has the keys of files.
    progress : bool or callable
        True prints a line; a callable is given what is done and the whole (the time of a motion and
        its end [s]).

    Returns
    -------
    Simulation
        With how it ended as its status. What it leaves out is told as a `SceneWarning` each.

    Raises
    ------
    InputError
        If the scene is bad input.
    KeyboardInterrupt
        On Ctrl-C, within a step.
    """
    prepared = _prepared(scene, [])
    done = Simulation(prepared.simulate(reporter(progress, "simulate", prepared.duration)))
    for line in done.warnings:
        _warnings.warn(line, SceneWarning, stacklevel=2)
    return done


def prepare(scene: Scene | Mapping[str, Any], parameters: Sequence[str] = ()) -> Model:
    """Checks a scene and lays it out, once for many runs.

    Parameters
    ----------
    scene : Scene or mapping
    parameters : sequence of str
        Paths of the fields that each run sets, ``"material.yield_stress"``.

    Raises
    ------
    InputError
        If the scene is bad input, or a field cannot be a parameter.
    """
    return Model(scene, parameters)


@dataclass(frozen=True)
class Sensitivity:
    """A response of a coupon and its derivatives by the parameters."""

    response: Response
    stress: Floats
    """d stress / d parameter (n_samples, n_parameters)"""
    permanent_strain: Floats
    """d permanent strain / d parameter (n_parameters)"""


class Batch:
    """Numbers of many runs of one model, each an array by case (n_cases)."""

    def __init__(self, columns: _core.BatchColumns, names: Sequence[str]) -> None:
        self._columns = columns
        self._names = list(names)

    def __len__(self) -> int:
        return len(self._columns["status"])

    @property
    def status(self) -> npt.NDArray[np.str_]:
        """How each run ended (n_cases)."""
        words: npt.NDArray[np.str_] = np.array(_core.status_words())
        return words[self._columns["status"]]

    @property
    def probes(self) -> dict[str, Floats]:
        """Values of each probe by its name [SI] (n_cases, n_samples); NaN behind the last valid
        sample of a run that ended early."""
        return {name: self._columns["probes"][k] for k, name in enumerate(self._names)}

    @property
    def samples(self) -> Integers:
        """Samples that are valid (n_cases)."""
        return self._columns["samples"]

    @property
    def permanent_strain(self) -> Floats:
        """The break measure at each run's last sample [1] (n_cases)."""
        return self._columns["permanent_strain"]

    @property
    def newton_iterations(self) -> Integers:
        """Of all steps (n_cases)."""
        return self._columns["newton_iterations"]

    @property
    def energy_balance_error(self) -> Floats:
        """Of each run's energy balance [1] (n_cases)."""
        return self._columns["energy_balance_error"]

    @property
    def seconds(self) -> Floats:
        """CPU time of each run [s] (n_cases)."""
        return self._columns["seconds"]

    def __repr__(self) -> str:
        words, counts = np.unique(self.status, return_counts=True)
        said = ", ".join(f"{n} {word}" for word, n in zip(words, counts))
        return f"<Batch: {len(self)} cases: {said}>"


class Model:
    """A scene that is checked and laid out: made by `prepare`, run any number of times, from any
    number of threads."""

    def __init__(self, scene: Scene | Mapping[str, Any], parameters: Sequence[str] = ()) -> None:
        self._prepared = _prepared(scene, parameters)
        # Of the scene as it is now: it may be changed.
        self._made_of = (copy.deepcopy(scene), list(parameters))

    @property
    def parameters(self) -> list[str]:
        """Paths of the fields that each run sets, in order."""
        return self._prepared.parameters

    @property
    def probe_names(self) -> list[str]:
        """In the order of the scene."""
        return self._prepared.probe_names

    @property
    def probe_units(self) -> dict[str, str]:
        """SI units by the probes' names."""
        return self._prepared.probe_units

    @property
    def level(self) -> str:
        """How much of the beam is modelled, and why."""
        return self._prepared.level_reason

    @property
    def warnings(self) -> list[str]:
        """What the scene asks for that its model does badly."""
        return self._prepared.warnings

    @property
    def riding(self) -> str:
        """How a batch runs a case: side by side with others, or one by one, and why."""
        return self._prepared.riding

    @property
    def bytes(self) -> int:
        """What a response takes."""
        return self._prepared.bytes

    def _row(self, values: Values) -> npt.NDArray[np.float64]:
        if is_pandas(values):
            column: Any = values
            values = dict(column)
        if not isinstance(values, Mapping):
            return numbers(values, "values")
        names = self.parameters
        for name in values:
            if name not in names:
                raise refuse(name, values[name], f"is no parameter of the model: {', '.join(names)}")
        missing = [name for name in names if name not in values]
        if missing:
            raise refuse(missing[0], None, "has no value")
        return numbers([values[name] for name in names], "values")

    def _by_name(self, table: Any) -> Any:
        """The columns of a table of pandas in the order of the parameters."""
        names = self.parameters
        for column in getattr(table, "columns", []):
            if column not in names:
                raise refuse("values", str(column), f"is no parameter: {', '.join(names)}")
        if [name for name in names if name not in getattr(table, "columns", [])]:
            raise refuse("values", None, f"must have a column for each of {', '.join(names)}")
        return table[names]

    def run(self, values: Values = (), *, progress: Progress = None) -> Response:
        """Runs the model.

        Parameters
        ----------
        values : sequence of float or mapping
            Of the parameters, in their order or by their paths [SI] (n_parameters). One that is out
            of its field's range makes the status ``"invalid-parameter"``.
        """
        return Response(
            self._prepared.run(
                self._row(values), reporter(progress, "run", self._prepared.duration)
            )
        )

    def run_batch(
        self, values: npt.ArrayLike, *, threads: int = 0, progress: Progress = None
    ) -> Batch:
        """Runs the model with many sets of values, in parallel, with no Python in between.

        Parameters
        ----------
        values : array_like
            [SI] (n_cases, n_parameters); a DataFrame goes by the names of its columns.
        threads : int
            0: as many as the machine has. Results have the same bits for any number.
        progress : bool or callable

        Raises
        ------
        InputError
            For an array of another shape.
        KeyboardInterrupt
            On Ctrl-C, within a step of each run under way.
        """
        if is_pandas(values):
            values = self._by_name(values)
        array = numbers(values, "values")
        cases = array.shape[0] if array.ndim else 0
        columns = self._prepared.run_batch(
            array, _thread_count(threads), reporter(progress, "run_batch", cases)
        )
        return Batch(columns, self.probe_names)

    def run_sensitivity(self, values: Values = ()) -> Sensitivity:
        """Runs the model of a coupon and differentiates it by the parameters, exactly.

        Raises
        ------
        InputError
            For a chain, and a coupon that may break.
        """
        view, stress, permanent = self._prepared.differentiate(self._row(values))
        return Sensitivity(Response(view), stress, permanent)

    def __reduce__(self) -> tuple[Callable[..., Model], tuple[Any, ...]]:
        return Model, self._made_of

    def __repr__(self) -> str:
        return f"<Model: {self.level}; parameters: {', '.join(self.parameters) or 'none'}>"


def _thread_count(threads: int) -> int:
    whole = isinstance(threads, (int, np.integer)) and not isinstance(threads, bool)
    if not whole or not 0 <= threads <= 65536:
        raise refuse("threads", threads, "must be a whole number, from 0 (all of the machine's) on")
    return int(threads)
