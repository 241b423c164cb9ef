"""What a scene has several of: supports, loads, masses, regions, probes and the like."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar, Mapping, Sequence, Union


from ._table import Table, table
from .fields import Material, Number, Numbers, Section

__all__ = [
    "Cut", "Drive", "InitialMotion", "Load", "PointMass", "Probe", "Region", "Support", "Vector",
    "cycles", "turning_points",
]

Place = Union[str, float, Mapping[str, int]]
"""``"start"``, ``"end"``, a fraction of the length, or ``{"segment": 3}``: that one's outer end."""
Vector = Numbers
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
@dataclass(slots=True, kw_only=True, eq=False, repr=False)
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
    strain: Vector | Mapping[str, Any] | None = None


@table
@dataclass(slots=True, kw_only=True, eq=False, repr=False)
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
    section: Section | None = None
    to_section: Section | None = None
    material: Material | None = None


@table
@dataclass(slots=True, kw_only=True, eq=False, repr=False)
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
@dataclass(slots=True, kw_only=True, eq=False, repr=False)
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
@dataclass(slots=True, kw_only=True, eq=False, repr=False)
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
@dataclass(slots=True, kw_only=True, eq=False, repr=False)
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
@dataclass(slots=True, kw_only=True, eq=False, repr=False)
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
@dataclass(slots=True, kw_only=True, eq=False, repr=False)
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
