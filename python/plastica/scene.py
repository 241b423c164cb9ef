"""Scenes: the beam, what holds and moves it, and how it is solved."""

from __future__ import annotations

import copy
import tomllib
import warnings
from dataclasses import dataclass, field
from os import PathLike, fspath
from pathlib import Path
from typing import Any, Callable, ClassVar, Mapping, TypeVar

from . import _core, _toml
from ._table import Table, table
from .errors import InputError, SceneWarning, refuse
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


def _move_out_of_beam(tree: dict[str, Any], part: str) -> None:
    """A material or section that stands in the beam's table becomes a table of its own."""
    said = tree.get("beam", {}).pop(part, None) if part in ("material", "section") else None
    if said is not None:
        bare = Scene._tables[part]._bare
        tree[part] = {bare: said} if isinstance(said, str) else said


@table
@dataclass(slots=True, kw_only=True, eq=False, repr=False)
class Scene(Table):
    """All that a simulation needs to know: the same as a scene file.

    A scene has a `drive` (a coupon) or `supports` and `loads`. Numbers are in SI; a text may have a
    unit of its own, ``length="400 mm"``. What is not given is as a file leaves it. Its tables are
    always there: ``scene.solver.steps = 40``.

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
    _always: ClassVar[bool] = True
    _lists: ClassVar[Mapping[str, tuple[str, type[Table]]]] = {
        "regions": ("region", Region),
        "supports": ("support", Support),
        "loads": ("load", Load),
        "masses": ("mass", PointMass),
        "initial_motions": ("initial_motion", InitialMotion),
        "cuts": ("cut", Cut),
        "probes": ("probe", Probe),
    }
    _hidden: ClassVar[frozenset[str]] = frozenset({"source"})

    name: str | None = None
    material: Material = field(default_factory=Material)
    section: Section = field(default_factory=Section)
    beam: Beam = field(default_factory=Beam)
    rules: Rules = field(default_factory=Rules)
    solver: Solver = field(default_factory=Solver)
    drive: Drive = field(default_factory=Drive)
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
        text, notes = _core.read_scene_file(name)
        for note in notes:
            warnings.warn(note, SceneWarning, stacklevel=2)
        scene = cls.from_dict(tomllib.loads(text))
        scene.source = Source(name, str(Path(name).resolve()), text, scene.to_dict())
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
            if tables:
                _move_out_of_beam(tree, tables[0])
            table = tree
            for name in tables:
                inner = table.setdefault(name, {})
                if not isinstance(inner, dict):
                    raise refuse(path, value, f"is no path of a field: {name} is no table")
                table = inner
            table[key] = copy.deepcopy(value)
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
        if self.source is None:
            return self._read_anew(reader, "")
        if not self.is_its_file():
            return self._read_anew(reader, self.source.place)
        try:
            return reader(self.source.text, self.source.place)
        except InputError as error:
            file = self.source.path if error.file == self.source.place else error.file
            raise InputError(file, error.line, error.field, error.value, error.rule) from None

    def _read_anew(self, reader: Callable[[str, str], T], place: str) -> T:
        """By a text that stands in no file."""
        try:
            return reader(self.to_toml(), place)
        except InputError as error:
            if error.file not in (None, "", place):
                raise  # of a table that the scene names
            raise InputError(None, None, error.field, error.value, error.rule) from None


@dataclass(frozen=True, slots=True)
class Source:
    """A scene file, as it was read."""

    path: str
    """As it was given."""
    place: str
    """From the root on: the process may go to another folder."""
    text: str
    tree: dict[str, Any]
