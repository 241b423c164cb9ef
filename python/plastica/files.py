"""Result files."""

from __future__ import annotations

from os import PathLike, fspath

from . import _core, fits
from .errors import InputError
from .fits import Fits
from .response import Simulation
from .studies import Sweep

__all__ = ["load"]


def load(path: str | PathLike[str]) -> Simulation | Fits | Sweep:
    """Reads a result file that `save` or the command has written.

    Returns
    -------
    Simulation, Fits or Sweep
        By what the file holds.

    Raises
    ------
    InputError
        For a file that is none, is damaged, or of a kind that Python has no type for.
    """
    name = fspath(path)
    schema = _core.schema_of(name)
    if schema == "plastica/scene":
        return Simulation(_core.read_scene(name))
    if schema in ("plastica/fits", "plastica/scene-fits"):
        return fits.read(name)
    if schema == "plastica/sweep":
        return Sweep(_core.read_sweep(name))
    raise InputError(name, None, "schema", schema, "is of a kind that Python does not read yet")
