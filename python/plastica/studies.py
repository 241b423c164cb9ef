"""What accuracy costs: sweeps, advice, checks; and beams for other engines."""

from __future__ import annotations

import json
import tempfile
import warnings as _warnings
from dataclasses import dataclass, field
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING, Any, Mapping, NamedTuple, Sequence

from . import _core, _toml
from ._write import from_bytes, to_bytes, write
from ._progress import Progress, reporter
from .errors import InputError, SceneWarning, refuse
from .model import _thread_count
from .response import Floats
from .scene import Scene

if TYPE_CHECKING:
    import pandas

__all__ = ["Advice", "Claim", "Sweep", "advise", "check", "export", "sweep"]


class Sweep:
    """A scene that was varied: what each case was, gave and cost."""

    def __init__(self, record: _core.SweepRecord) -> None:
        self._record = record

    @property
    def axes(self) -> list[str]:
        """Paths of the fields that were varied."""
        return self._record.axes

    @property
    def warnings(self) -> list[str]:
        """What a reader must not overlook of the cases."""
        return self._record.warnings

    @property
    def groups(self) -> list[dict[str, Any]]:
        """Where an axis refines, what its cases show, as ``to_json`` has it: ``label``, observed
        ``order``, and of the ``three_finest`` order, ``extrapolated`` value and grid convergence
        index ``gci``, …"""
        groups: list[dict[str, Any]] = json.loads(self.to_json())["groups"]
        return groups

    @property
    def curves(self) -> dict[int, tuple[Floats, Floats]]:
        """Where curves are compared: time [s] and value [SI] of each case, by its number."""
        return self._record.curves()

    def to_dataframe(self) -> pandas.DataFrame:
        """A row for each case: its values on the axes, ``status``, ``value``, ``reference``,
        ``error`` (over the reference [1]), ``segment_iterations``, ``seconds``, …"""
        import pandas

        return pandas.DataFrame(self._record.columns())

    def report(self) -> str:
        """What the command prints: with observed orders and grid convergence indices."""
        return self._record.report()

    def to_json(self) -> str:
        """What the command writes with ``--json``."""
        return self._record.json()

    def save(self, path: str | PathLike[str], *, overwrite: bool = False) -> None:
        """Writes the result file, which `plastica.load` and the command read."""
        write(self._record, path, overwrite)

    def __reduce__(self) -> tuple[Any, ...]:
        return _from_bytes, (to_bytes(self._record),)

    def __len__(self) -> int:
        return len(self._record.columns()["status"])

    def _repr_html_(self) -> str:
        return str(self.to_dataframe().to_html())

    def __repr__(self) -> str:
        return f"<Sweep: {len(self)} cases over {', '.join(self.axes)}>"


def _from_bytes(content: bytes) -> Sweep:
    return Sweep(from_bytes(content, _core.read_sweep))


def sweep(
    scene: Scene | Mapping[str, Any] | str | PathLike[str],
    axes: Mapping[str, Sequence[Any]] | None = None,
    *,
    probe: str | None = None,
    take: str | None = None,
    against: str | None = None,
    error: Mapping[str, Any] | None = None,
    set: Mapping[str, Any] | None = None,
    timed_runs: int = 0,
    threads: int = 0,
    progress: Progress = None,
) -> Sweep:
    """Varies a scene over axes and compares its cases.

    Parameters
    ----------
    scene : Scene, mapping or path
        The path of a sweep file (``[[axis]]``), which then says all else, or of a scene file.
    axes : mapping
        For each path of a field, ``"beam.segments"``, its values [SI]; all are crossed. None is an
        optional field that is not set.
    probe : str
        Name of the scene's probe that is compared.
    take : {"end", "min", "max", "size", "mean", "curve", "frequency"}
        What of it. Default: ``"end"``.
    against : str
        ``"finest"``, ``"richardson"``, ``"theory:elastica"``, ``"value:0.735 m"``,
        ``"reference:FILE"``. Default: nothing.
    error : mapping
        Further keys of ``[error]``, such as ``quantity`` in place of a probe.
    set : mapping
        Fields that all cases have otherwise than the scene.
    timed_runs : int
        How often each case is run more, to time it.
    threads : int
        0: as many as the machine has.
    progress : bool or callable

    Raises
    ------
    InputError
        For bad input. A case that cannot be run is a row with its status and reason.

    Examples
    --------
    >>> made = plastica.sweep(scene, {"beam.segments": [5, 10, 20, 40]}, probe="tip",
    ...                       against="theory:elastica")
    >>> made.to_dataframe()[["beam.segments", "error"]]
    """
    if axes is None:
        if not isinstance(scene, (str, PathLike)):
            raise refuse("axes", None, "is missing: what of the scene is varied?")
        asked = _core.Sweep(fspath(scene))
        return _run(asked, threads, progress)
    if not isinstance(scene, Scene):
        scene = Scene.from_toml(scene) if isinstance(scene, (str, PathLike)) else Scene.from_dict(scene)
    compared: dict[str, Any] = dict(error or {})
    for key, given in (("probe", probe), ("take", take), ("against", against)):
        if given is not None and key in compared:
            raise refuse(f"error.{key}", compared[key], "is an argument, too")
        if given is not None:
            compared[key] = given
    kind, _, path = str(compared.get("against", "")).partition(":")
    if kind == "reference":
        compared["against"] = f"{kind}:{Path(path).resolve()}"
    units = {field["path"]: field["unit"] for field in _core.fields()}
    with tempfile.TemporaryDirectory() as folder:
        tree: dict[str, Any] = {
            "scene": _file_of(scene, Path(folder)),
            "axis": [{"field": field,
                      "values": [_UNSET if each is None else
                                 _toml.give_unit(_toml.plain(each), units.get(field, ""))
                                 for each in values]}
                     for field, values in axes.items()],
        }
        if set:
            tree["set"] = {field: _toml.give_unit(_toml.plain(value), units.get(field, ""))
                           for field, value in set.items()}
        tree["error"] = _toml.plain(compared)
        if timed_runs:
            tree["cost"] = {"timed_runs": timed_runs}
        written = Path(folder) / "sweep.toml"
        written.write_text(_toml.write(tree), encoding="utf-8")
        try:
            return _run(_core.Sweep(str(written)), threads, progress)
        except InputError as error:
            if error.file is not None and not error.file.startswith(folder):
                raise
            # Lines of a file that nobody has written would only confuse.
            raise InputError(None, None, error.field, error.value, error.rule) from None


_UNSET = "unset"  # as sweep files have it


def _file_of(scene: Scene, folder: Path) -> str:
    """A file that says what the scene says: its own, whose folder has what it names, or one that is
    written into a folder."""
    if scene.source is not None and scene.is_its_file():
        path = Path(scene.source.place)
        if path.is_file() and path.read_text(encoding="utf-8") == scene.source.text:
            return str(path)
    place = Path.cwd() if scene.source is None else Path(scene.source.place).parent
    tree = _absolute(scene.to_dict(), place)
    path = folder / "scene.toml"
    path.write_text(_toml.write(_toml.with_units(tree)), encoding="utf-8")
    return str(path)


def _absolute(tree: Any, place: Path) -> Any:
    """The same with the paths of tables from the root on."""
    if isinstance(tree, list):
        return [_absolute(each, place) for each in tree]
    if not isinstance(tree, dict):
        return tree
    return {key: str(place / value) if key == "table" and isinstance(value, str)
            else _absolute(value, place) for key, value in tree.items()}


def _run(asked: _core.Sweep, threads: int, progress: Progress) -> Sweep:
    for note in asked.notes:
        _warnings.warn(note, SceneWarning, stacklevel=3)
    return Sweep(asked.run(_thread_count(threads), reporter(progress, "sweep", asked.cases)))


@dataclass(frozen=True)
class Advice:
    """How fine a scene must be."""

    found: bool
    """Whether the setting is within what was asked for."""
    end: str
    """``"found"``, or what ended the search."""
    scene: Scene
    """The scene with what is advised."""
    values: dict[str, Any]
    """What that changes, by the fields' paths [SI]."""
    promised: float
    """The error is at most this, of the worst quantity [1]."""
    verified: float
    """Difference from a run that is finer in every axis [1]."""
    expected_seconds: float
    """CPU time of a run [s]."""
    runs: int
    """How many runs that took."""
    warnings: list[str]
    _report: str = field(repr=False)
    _json: str = field(repr=False)

    def report(self) -> str:
        """What the command prints."""
        return self._report

    def to_json(self) -> str:
        """What the command writes with ``--json``."""
        return self._json


def advise(
    scene: Scene | Mapping[str, Any],
    *,
    within: float | str | None = None,
    budget: float | str | None = None,
    probes: Sequence[str] = (),
    max_runs: int = 100,
    max_work: float = 1e8,
    threads: int = 0,
    progress: Progress = None,
) -> Advice:
    """Chooses model, segments and time step of a scene for an error or a time.

    Errors are those of the worst quantity of the worst probe: its history (rms), its largest size and
    its last value, over their sizes.

    Parameters
    ----------
    scene : Scene or mapping
    within : float or str
        The cheapest within this error is looked for, 0.01 or ``"1 %"``; or
    budget : float or str
        the most accurate whose run takes no more CPU time, 2e-3 or ``"2 ms"`` [s].
    probes : sequence of str
        Names; default: all of the scene.
    max_runs : int
    max_work : float
        Segment-iterations that all runs together may cost.

    Raises
    ------
    InputError
        For a coupon, a probe that is not there, a scene that cannot be run.
    """
    if (within is None) == (budget is None):
        raise refuse("advise", None, "needs one of within and budget")
    error, seconds = _number(within, "pure number", "within"), _number(budget, "time", "budget")
    for name, number in (("within", error), ("budget", seconds)):
        if number is not None and not 0.0 < number < (1.0 if name == "within" else float("inf")):
            raise refuse(name, number, "must be above 0" + (" and below 1" if name == "within" else ""))
    if max_runs < 4:
        raise refuse("max_runs", max_runs, "must be at least 4")
    if not max_work > 0.0:
        raise refuse("max_work", max_work, "must be above 0")
    if not isinstance(scene, Scene):
        scene = Scene.from_dict(scene)
    count, report = _thread_count(threads), reporter(progress, "advise: runs", max_runs)
    said = scene.read_by(lambda text, name: _core.advise(
        text, name, error or 0.0, seconds or 0.0, list(probes), max_runs, max_work, count, report))
    values = dict(said["values"])
    if said["segment_lengths"]:
        values.update({"beam.segment_lengths": said["segment_lengths"], "beam.segments": None})
    return Advice(said["found"], said["end"], scene.changed(values), said["values"],
                  said["promised"], said["verified"], said["expected_seconds"], said["runs"],
                  said["warnings"], said["report"], said["json"])


def _number(value: float | str | None, dimension: str, name: str) -> float | None:
    return _core.quantity(value, dimension, name) if isinstance(value, str) else value


class JudgedNumber(NamedTuple):
    """One of the numbers that a claim is judged by."""

    of: str
    """Whose: ``"beam.segments = 5"``, a fit, a point of a scan."""
    number: float | None
    """[SI]; None: see `remark`."""
    remark: str


@dataclass(frozen=True)
class Claim:
    """A claim of a check file, and whether it holds."""

    name: str
    holds: bool
    number: float | None
    """The worst that was found [SI]; None: see `reason`."""
    found: str
    """What was found that is no number."""
    reason: str
    at: str
    """Whose it is: ``"at beam.segments = 5"``."""
    warnings: list[str]
    beside: str
    """What else is to be said of it."""
    judged: int
    """How many numbers it was judged by; where it counts: cases, or fits of no use."""
    worst: list[JudgedNumber]
    """The worst of these first: at most twenty."""


def check(path: str | PathLike[str], *, threads: int = 0, progress: Progress = None) -> list[Claim]:
    """Checks the claims of a check file on sweeps, scenes and fits.

    Raises
    ------
    InputError
        For a bad file. A claim that does not hold is no error: see `Claim.holds`.
    """
    file = _core.CheckFile(fspath(path))
    for note in file.notes:
        _warnings.warn(note, SceneWarning, stacklevel=2)
    verdicts = file.run(_thread_count(threads), reporter(progress, "check", file.cases))
    return [Claim(worst=[JudgedNumber(*one) for one in verdict.pop("worst")], **verdict)
            for verdict in verdicts]


def export(
    scene: Scene | Mapping[str, Any],
    to: str,
    *,
    up: str = "",
    gravity: float | str | None = None,
    damping_time: float | str | None = None,
    contacts: str = "none",
) -> str:
    """The beam of a scene as the text that another engine reads.

    Parameters
    ----------
    scene : Scene or mapping
    to : {"csv", "mjcf", "agx", "bullet", "chrono", "opensees"}
    up : str
        The axis that points up, ``"y"``; default: as in the scene.
    gravity : float or str
        [m/s^2]; default: the scene's.
    damping_time : float or str
        Damping of the joints over their stiffness [s].
    contacts : {"none", "others", "all"}
        What the segments touch (mjcf).

    Returns
    -------
    str
        What of the scene the engine cannot take, and where numbers come from, its comments say.
    """
    if not isinstance(scene, Scene):
        scene = Scene.from_dict(scene)
    pull = _number(gravity, "acceleration", "gravity")
    damping = _number(damping_time, "time", "damping_time")
    try:
        return scene.read_by(
            lambda text, name: _core.export_beam(text, name, to, up, pull, damping, contacts))
    except InputError as error:
        # The engine speaks of the command's options.
        name = {"--gravity": "gravity", "--damping": "damping_time", "--up": "up"}.get(
            error.field or "", error.field)
        raise InputError(error.file, error.line, name, error.value, error.rule) from None
