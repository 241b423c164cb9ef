"""Scenes: the beam, what holds and moves it, and how it is solved."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass, field
from os import PathLike, fspath
from pathlib import Path
from typing import Any, Callable, ClassVar, Mapping, TypeVar

from . import _toml
from ._table import Table, table
from .errors import InputError, refuse
from .fields import Beam, Material, Rules, Section, Solver
from .items import (
    Cut,
    Drive,
    InitialMotion,
    Load,
    PointMass,
    Probe,
    Region,
    Support,
    Vector,
)

__all__ = ["Scene"]

T = TypeVar("T")

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
@dataclass(slots=True, kw_only=True, eq=False, repr=False)
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

    def changed(self, values: Mapping[str, Any]) -> Scene:
        """A copy with other values of fields, by their paths: ``{"beam.segments": 40}``; None is as a
        file leaves it.

        Raises
        ------
        InputError
            For a path that there is not.
        """
        tree = self.to_dict()
        for path, value in values.items():
            *tables, key = path.split(".")
            table = tree
            for name in tables:
                inner = table.setdefault(name, {})
                if not isinstance(inner, dict):  # "S355" stands for a table with a name
                    inner = table[name] = {"profile" if name == "section" else "name": inner}
                table = inner
            table[key] = value
        scene = Scene.from_dict(tree)
        scene.source = self.source
        return scene

    def is_its_file(self) -> bool:
        """Whether it was read from a file and is as it was there."""
        return self.source is not None and self.to_dict() == self.source.tree

    def read_by(self, reader: Callable[[str, str], T]) -> T:
        """Hands the scene to the engine: the text of its file, or of the scene as it is now, and the
        path from whose folder relative paths begin.

        Raises
        ------
        InputError
            As the engine does; without file and line where it is no file that was read.
        """
        if self.source is not None and self.is_its_file():
            return reader(self.source.text, self.source.path)
        try:
            return reader(self.to_toml(), "" if self.source is None else self.source.path)
        except InputError as error:
            mine = ("", None if self.source is None else self.source.path)
            if error.file is not None and error.file not in mine:
                raise  # of a table that the scene names
            raise InputError(None, None, error.field, error.value, error.rule) from None


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
