"""Scenes: the beam, what holds and moves it, and how it is solved."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass, field
from os import PathLike, fspath
from pathlib import Path
from typing import Any, ClassVar, Mapping, Sequence, Union

from . import _toml
from ._table import Table, table
from .errors import InputError, refuse
from .fields import Beam, Material, Number, Rules, Section, Solver

__all__ = [
    "Cut", "Drive", "InitialMotion", "Load", "PointMass", "Probe", "Region", "Scene", "Support",
    "cycles", "turning_points",
]

Place = Union[str, float, Mapping[str, int]]
"""``"start"``, ``"end"``, a fraction of the length, or ``{"segment": 3}``: that one's outer end."""
Vector = Sequence[Number]
"""Numbers along, or about, x, y and z."""
Direction = Union[str, Sequence[float]]
"""``"x"``, ``"-y"``, or a vector."""
History = Union[str, Mapping[str, Any]]
"""How a load or motion goes in time: ``"ramp"``, ``"constant"``, what `cycles` or `turning_points`
give, ``{"time": […], "factor": […]}`` [s, 1], ``{"smooth_step": [from, to]}`` [s], ``{"period": …,
"cycles": …, "phase": …}`` [s, 1, rad], or columns of a file, ``{"table": "path.csv", "time": "Time",
"factor": "Force"}``."""


def turning_points(factors: Sequence[float]) -> dict[str, Any]:
    """A history from 0 over these factors, one each second."""
    return {"turning_points": list(factors)}


def cycles(count: int) -> dict[str, Any]:
    """A history from 0 over 1 and -1, so many times, and back to 0."""
    return {"cycles": count}


@table
@dataclass(slots=True, kw_only=True)
class Drive(Table):
    """What is done to a coupon, a beam under the same strain everywhere.

    Attributes
    ----------
    deformation : {"tension", "bending", "torsion"}
        Default: tension.
    strain : sequence of float or mapping
        Strain at each sample [1] (n_samples); or ``{"turning_points": […], "points_between": 50}``,
        or a column of a file, ``{"table": "path.csv", "column": "Strain"}``.
    """

    deformation: str | None = None
    strain: Sequence[Number] | Mapping[str, Any] | None = None


@table
@dataclass(slots=True, kw_only=True)
class Region(Table):
    """A part of the beam with a section or material of its own.

    Attributes
    ----------
    from_, to : place
        Where it begins and ends.
    section, to_section : Section
        What differs there; of a taper also what differs at its end.
    material : Material or str
        What differs there.
    """

    _tables: ClassVar[Mapping[str, type[Table]]] = {
        "section": Section, "to_section": Section, "material": Material,
    }

    from_: Place | None = None
    to: Place | None = None
    section: Section | str | Mapping[str, Any] | None = None
    to_section: Section | Mapping[str, Any] | None = None
    material: Material | str | Mapping[str, Any] | None = None


@table
@dataclass(slots=True, kw_only=True)
class Support(Table):
    """Holds the beam at a place, or along a length by springs.

    Attributes
    ----------
    kind : str
        ``"clamp"``, ``"pin"``, ``"roller"``, ``"elastic"``, ``"pillar"``, …
    at : place
    to : place
        End of a bed of springs that begins at `at`.
    from_ : place
        In place of `at`, beside `to`.
    hold : sequence of str
        Freedoms that are held, of ``"x"``, ``"y"``, ``"z"``, ``"rx"``, ``"ry"``, ``"rz"``.
    stiffness, rotational_stiffness : vector
        Of springs [N/m, N m/rad]; of a bed per length.
    normal : direction
    gap : float
        Of a pillar [m].
    restitution : float
        Of an impact on a pillar [1].
    translation, rotation : vector
        How far it moves [m, rad], times its history.
    history : history
    """

    kind: str | None = None
    at: Place | None = None
    to: Place | None = None
    from_: Place | None = None
    hold: Sequence[str] | None = None
    stiffness: Vector | None = None
    rotational_stiffness: Vector | None = None
    normal: Direction | None = None
    gap: Number = None
    restitution: float | None = None
    translation: Vector | None = None
    rotation: Vector | None = None
    history: History | None = None


@table
@dataclass(slots=True, kw_only=True)
class Load(Table):
    """A force and a moment at a place, or along a length.

    Attributes
    ----------
    at, to : place
        With `to` it is spread from `at` to there, and per length.
    from_ : place
        In place of `at`, beside `to`.
    force, moment : vector
        [N, N m]; along a length [N/m, N m/m].
    follows : bool
        Whether it turns with the beam.
    history : history
        Default: ``"ramp"``.
    """

    at: Place | None = None
    to: Place | None = None
    from_: Place | None = None
    force: Vector | None = None
    moment: Vector | None = None
    follows: bool | None = None
    history: History | None = None


@table
@dataclass(slots=True, kw_only=True)
class PointMass(Table):
    """What moves and weighs besides the beam.

    Attributes
    ----------
    at : place
    mass : float
        [kg]
    inertia : vector
        About x, y and z [kg m^2].
    """

    at: Place | None = None
    mass: Number = None
    inertia: Vector | None = None


@table
@dataclass(slots=True, kw_only=True)
class InitialMotion(Table):
    """How segments move at time 0 of a motion.

    Attributes
    ----------
    from_, to : place
        The segments between; default: the whole beam.
    velocity : vector
        [m/s]
    spin : vector
        [rad/s], about the place `about` (default: 0.5).
    about : place
    """

    from_: Place | None = None
    to: Place | None = None
    velocity: Vector | None = None
    spin: Vector | None = None
    about: Place | None = None


@table
@dataclass(slots=True, kw_only=True)
class Cut(Table):
    """Cuts a beam in motion.

    Attributes
    ----------
    at : place
    time : float
        [s]
    """

    at: Place | None = None
    time: Number = None


@table
@dataclass(slots=True, kw_only=True)
class Probe(Table):
    """A number that is recorded at each sample.

    Attributes
    ----------
    kind : str
        ``"stress"`` of a coupon; ``"displacement"``, ``"reaction"``, ``"moment"``, ``"energy"``, …
    name : str
        Default: the kind.
    at : place
        Default: the end.
    component : {"x", "y", "z", "size"}
    energy : str
        Which one, of kind ``"energy"``.
    """

    kind: str | None = None
    name: str | None = None
    at: Place | None = None
    component: str | None = None
    energy: str | None = None


# Lists of tables: attribute, key of files, type.
_LISTS: Mapping[str, tuple[str, type[Table]]] = {
    "regions": ("region", Region),
    "supports": ("support", Support),
    "loads": ("load", Load),
    "masses": ("mass", PointMass),
    "initial_motions": ("initial_motion", InitialMotion),
    "cuts": ("cut", Cut),
    "probes": ("probe", Probe),
}
# Keys that are words of Python.
_RENAMED = {"from": "from_"}


@table
@dataclass(slots=True, kw_only=True)
class Scene(Table):
    """All that a simulation needs to know: the same as a scene file.

    A scene has a `drive` (a coupon) or `supports` and `loads`. Numbers are in SI; a text may have a
    unit of its own, ``length="400 mm"``. What is not given is as a file leaves it.

    Examples
    --------
    >>> scene = Scene(
    ...     material=Material(name="S355"),
    ...     section=Section(shape="rectangle", width=0.02, height=0.02),
    ...     beam=Beam(length=1.0, segments=20),
    ...     supports=[Support(kind="clamp", at="start")],
    ...     loads=[Load(at="end", force=[0, -300, 0])],
    ...     probes=[Probe(name="tip", kind="displacement", component="y")])
    >>> simulate(scene).probes["tip"]
    """

    _tables: ClassVar[Mapping[str, type[Table]]] = {
        "material": Material, "section": Section, "beam": Beam, "rules": Rules, "solver": Solver,
        "drive": Drive,
    }

    name: str | None = None
    material: Material | str | Mapping[str, Any] | None = None
    section: Section | str | Mapping[str, Any] | None = None
    beam: Beam | Mapping[str, Any] | None = None
    rules: Rules | Mapping[str, Any] | None = None
    solver: Solver | Mapping[str, Any] | None = None
    drive: Drive | Mapping[str, Any] | None = None
    gravity: Vector | Mapping[str, Any] | None = None
    regions: list[Region] = field(default_factory=list)
    supports: list[Support] = field(default_factory=list)
    loads: list[Load] = field(default_factory=list)
    masses: list[PointMass] = field(default_factory=list)
    initial_motions: list[InitialMotion] = field(default_factory=list)
    cuts: list[Cut] = field(default_factory=list)
    probes: list[Probe] = field(default_factory=list)
    source: Source | None = field(default=None, repr=False, compare=False)
    """The file that it was read from."""

    def to_dict(self) -> dict[str, Any]:
        """The scene as a dictionary with the keys of files (``"support"``, ``"load"``), in SI."""
        result: dict[str, Any] = {}
        for name in self._keys():
            value = getattr(self, name)
            if name == "source" or value is None or isinstance(value, list) and not value:
                continue
            key = _LISTS[name][0] if name in _LISTS else name
            result[key] = _files_keys(_as_dicts(value))
        return result

    @classmethod
    def from_dict(cls, table: Mapping[str, Any]) -> Scene:
        """A scene from the keys and values of a file.

        Raises
        ------
        InputError
            For a key that there is not. Values are checked when the scene is run.
        """
        if not isinstance(table, Mapping):
            raise refuse("Scene", table, "must be a dictionary")
        given: dict[str, Any] = {}
        names = {key: (name, kind) for name, (key, kind) in _LISTS.items()}
        for key, value in table.items():
            if key in names:
                name, kind = names[key]
                if not isinstance(value, (list, tuple)):
                    raise refuse(key, value, "must be a list of tables")
                given[name] = [_from_item(kind, item) for item in value]
            elif key not in cls._keys() or key in _LISTS or key == "source":
                raise cls._refuse(key, value)
            else:
                inner = cls._tables.get(key)
                is_table = inner is not None and isinstance(value, Mapping)
                given[key] = inner.from_dict(value) if inner and is_table else value
        return cls(**given)

    def to_toml(self) -> str:
        """The scene as the text of a scene file, which the command takes."""
        return _toml.write(_toml.with_units(self.to_dict()))

    @classmethod
    def from_toml(cls, path: str | PathLike[str]) -> Scene:
        """Reads a scene file.

        Raises
        ------
        InputError
            For a file that cannot be read, is not TOML, or has a key that there is not.
        """
        name = fspath(path)
        try:
            text = Path(name).read_text(encoding="utf-8")
            tree = tomllib.loads(text)
        except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
            rule = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
            raise InputError(name, None, None, None, rule) from error
        scene = cls.from_dict(tree)
        scene.source = Source(name, text, scene.to_dict())
        return scene

    def text_and_name(self) -> tuple[str, str]:
        """What the engine reads: the file as it is, or the text of a scene that was changed; and
        what it is called in errors, from whose folder relative paths begin."""
        if self.source is None:
            return self.to_toml(), ""
        if self.to_dict() == self.source.tree:
            return self.source.text, self.source.path
        return self.to_toml(), str(Path(self.source.path).with_suffix(""))


@dataclass(frozen=True, slots=True)
class Source:
    """A scene file, as it was read."""

    path: str
    text: str
    tree: dict[str, Any]


def _as_dicts(value: Any) -> Any:
    if isinstance(value, Table):
        return value.to_dict()
    if isinstance(value, list):
        return [_as_dicts(each) for each in value]
    return _toml.plain(value)


def _files_keys(value: Any) -> Any:
    if isinstance(value, list):
        return [_files_keys(each) for each in value]
    if not isinstance(value, dict):
        return value
    renamed = {new: old for old, new in _RENAMED.items()}
    return {renamed.get(key, key): each for key, each in value.items()}


def _from_item(kind: type[Table], item: Any) -> Table:
    if isinstance(item, kind):
        return item
    if not isinstance(item, Mapping):
        raise refuse(kind.__name__, item, "must be a table")
    return kind.from_dict({_RENAMED.get(key, key): value for key, value in item.items()})
