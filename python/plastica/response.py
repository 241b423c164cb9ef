"""What a run gives."""

from __future__ import annotations

from os import PathLike, fspath
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, cast

import numpy as np
import numpy.typing as npt

from . import _core
from ._write import from_bytes, to_bytes, write

if TYPE_CHECKING:
    import pandas

__all__ = ["Response", "Simulation"]

Floats = npt.NDArray[np.float64]
Integers = npt.NDArray[np.integer[Any]]


class Response:
    """What a run gives, as arrays that look into the engine's memory and cannot be written to.

    A chain of N segments has N + 1 joints: joint 0 at the start, joint N at the end. `time` and all
    probes are by sample (n_samples); shapes of the beam are by frame (n_frames), the samples
    `frame_sample`.
    """

    def __init__(self, view: _core.ResponseView) -> None:
        self._view = view

    @property
    def status(self) -> str:
        """How the run ended: ``"completed"``, ``"broken"``, ``"limit-load"``, …"""
        return self._view.status

    @property
    def usable(self) -> bool:
        """Whether the status is one of those that may be used."""
        return self._view.usable

    @property
    def samples(self) -> int:
        """Samples that are valid."""
        return self._view.samples

    @property
    def probes(self) -> dict[str, Floats]:
        """Values of each probe by its name [SI] (n_samples)."""
        return self._view.probes

    @property
    def strain(self) -> Floats:
        """Of a coupon: strain at each sample [1] (n_samples); else empty."""
        return self._view.strain

    @property
    def time(self) -> Floats:
        """Of a chain [s] (n_samples)."""
        return self._view.time

    @property
    def factor(self) -> Floats:
        """Of the first load or motion that changes [1] (n_samples)."""
        return self._view.factor

    @property
    def energies(self) -> dict[str, Floats]:
        """Of a chain, by name: elastic, kinetic, plastic, external, residual, … [J] (n_samples)."""
        return self._view.energies

    @property
    def frame_sample(self) -> Integers:
        """Samples of which the shape is kept (n_frames)."""
        return self._view.frame_sample

    @property
    def position(self) -> Floats:
        """Of the joints, world axes [m] (n_frames, N + 1, 3)."""
        return self._view.position

    @property
    def rotation(self) -> Floats:
        """Of the segments from the undeformed beam, a rotation vector [rad] (n_frames, N, 3)."""
        return self._view.rotation

    @property
    def velocity(self) -> Floats:
        """Of the inner end of each segment, world axes [m/s] (n_frames, N, 3); of a path at rest
        (0, N, 3)."""
        return self._view.velocity

    @property
    def spin(self) -> Floats:
        """Angular velocity of each segment, world axes [rad/s] (n_frames, N, 3); of a path at rest
        (0, N, 3)."""
        return self._view.spin

    @property
    def moment(self) -> Floats:
        """About x, y, z of each joint [N m] (n_frames, N + 1, 3)."""
        return self._view.moment

    @property
    def force(self) -> Floats:
        """Shear along x and y, axial along z, of each joint [N] (n_frames, N + 1, 3)."""
        return self._view.force

    @property
    def angle(self) -> Floats:
        """Of each joint from the undeformed state [rad] (n_frames, N + 1, 3)."""
        return self._view.angle

    @property
    def plastic_angle(self) -> Floats:
        """Of each joint [rad] (n_frames, N + 1, 3)."""
        return self._view.plastic_angle

    @property
    def plastic_strain(self) -> Floats:
        """The break measure of each joint [1] (n_frames, N + 1)."""
        return self._view.plastic_strain

    @property
    def stress(self) -> Floats:
        """Largest of bending over each joint's section [Pa] (n_frames, N + 1)."""
        return self._view.stress

    @property
    def reaction(self) -> Floats:
        """Force [N] and moment [N m] of each support on the beam (n_frames, n_supports, 6)."""
        return self._view.reaction

    @property
    def permanent_strain(self) -> float:
        """The break measure at the last sample [1]."""
        return self._view.permanent_strain

    @property
    def event(self) -> _core.BreakEvent | None:
        """The break of a coupon."""
        return self._view.event

    @property
    def events(self) -> list[_core.ChainBreak]:
        """The breaks and cuts of a chain, in the order of time."""
        return self._view.events

    @property
    def limit(self) -> dict[str, Any] | None:
        """Where a path ended at a limit load: ``below``, ``above`` [1] and its ``mode``."""
        return self._view.limit

    @property
    def critical(self) -> dict[str, Any] | None:
        """Bifurcations that a path has passed."""
        return self._view.critical

    @property
    def buckling(self) -> dict[str, Any] | None:
        """Buckling factors and modes, where ``solver.buckling`` asks for them."""
        return self._view.buckling

    @property
    def vibration(self) -> dict[str, Any] | None:
        """Natural frequencies and modes, where ``solver.frequencies`` asks for them."""
        return self._view.vibration

    @property
    def steps(self) -> int:
        """Steps that were taken, recorded or not."""
        return self._view.steps

    @property
    def newton_iterations(self) -> int:
        """Of all steps, those that failed included."""
        return self._view.newton_iterations

    @property
    def cutbacks(self) -> int:
        """Steps that were tried again shorter."""
        return self._view.cutbacks

    @property
    def energy_balance_error(self) -> float:
        """Of the energy balance, over its largest entry [1]."""
        return self._view.energy_balance_error

    @property
    def momentum_error(self) -> float:
        """Of the momentum of fragments that nothing holds, in motion [1]."""
        return self._view.momentum_error

    @property
    def seconds(self) -> float:
        """Time that the run took [s]."""
        return self._view.seconds

    def to_dataframe(self) -> pandas.DataFrame:
        """The probes, a column each, by time [s] of a chain or strain [1] of a coupon."""
        import pandas

        index = (
            pandas.Index(self.time, name="time")
            if len(self.time) > 0
            else pandas.Index(self.strain, name="strain")
        )
        return pandas.DataFrame(dict(self.probes), index=index)

    def __reduce__(self) -> tuple[Any, ...]:
        names = [name for name, of in vars(_core.ResponseView).items() if isinstance(of, property)]
        return _from_values, ({name: getattr(self._view, name) for name in names},)

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self.status}, {self.samples} samples>"


class Simulation(Response):
    """A scene that was simulated: its response, and what a result file holds besides."""

    def __init__(self, record: _core.SceneRecord) -> None:
        super().__init__(record.response)
        self._record = record

    @property
    def name(self) -> str:
        """Of the scene."""
        return self._record.name

    @property
    def level(self) -> str:
        """How much of the beam was modelled, and why: ``"planar: …"``."""
        return self._record.level_reason

    @property
    def warnings(self) -> list[str]:
        """What a reader must not overlook, a line each."""
        return self._record.warnings

    def report(self) -> str:
        """What the command prints."""
        return self._record.report()

    def to_json(self) -> str:
        """What the command writes with ``--json``."""
        return self._record.json()

    def save(self, path: str | PathLike[str], *, overwrite: bool = False) -> None:
        """Writes the result file, which `plastica.load` and the command read.

        Raises
        ------
        InputError
            If the file is there and is not to be overwritten, or its folder is not.
        OSError
            If it cannot be written.
        """
        write(self._record, path, overwrite)

    def __reduce__(self) -> tuple[Any, ...]:
        return _from_bytes, (to_bytes(self._record),)


def _from_values(values: dict[str, Any]) -> Response:
    """A response that stands for one of the engine's, with the same arrays."""
    def hold(value: Any) -> None:
        if isinstance(value, np.ndarray):
            value.flags.writeable = False
        for each in value.values() if isinstance(value, dict) else ():
            hold(each)
    hold(values)
    return Response(cast(_core.ResponseView, SimpleNamespace(**values)))


def _from_bytes(content: bytes) -> Simulation:
    return Simulation(from_bytes(content, _core.read_scene))
