"""What the fits of a run give."""

from __future__ import annotations

from os import PathLike, fspath
from typing import TYPE_CHECKING, Any, Iterator, Union, overload

import numpy as np

from . import _core
from ._write import from_bytes, to_bytes, write
from .errors import refuse
from .fitted import Fit, Parameter

if TYPE_CHECKING:
    import pandas

__all__ = ["Fits"]

_Contents = Union[_core.CurveFitContents, _core.SceneFitContents]


class Fits:
    """Fits of a run: a sequence, in the order of their names, that also takes a name.

    Where laws are compared each specimen has a fit of each law; ``fits["a"]`` is ambiguous then, and
    ``fits["a", "voce"]`` one of them.
    """

    def __init__(self, contents: _Contents) -> None:
        self._contents = contents
        self._fits = [Fit(self, k) for k in range(len(contents))]

    def __len__(self) -> int:
        return len(self._fits)

    def __iter__(self) -> Iterator[Fit]:
        return iter(self._fits)

    @overload
    def __getitem__(self, key: int | str | tuple[str, str]) -> Fit: ...
    @overload
    def __getitem__(self, key: slice) -> list[Fit]: ...
    def __getitem__(self, key: int | str | tuple[str, str] | slice) -> Fit | list[Fit]:
        if isinstance(key, (int, slice, np.integer)):
            return self._fits[key]
        name, law = key if isinstance(key, tuple) else (key, None)
        found = [one for one in self._fits if one.name == name and law in (None, one.law)]
        if len(found) == 1:
            return found[0]
        if not found:
            raise KeyError(f"{name!r}{f' with law {law!r}' if law else ''}: no fit has that name; "
                           f"there are {', '.join(self.names[:8])}")
        laws = ", ".join(one.law for one in found)
        raise KeyError(f"{name!r} has several fits: name the law, too: {laws}")

    @property
    def names(self) -> list[str]:
        """Of the specimens, each once."""
        return list(dict.fromkeys(one.name for one in self._fits))

    @property
    def parameters(self) -> dict[str, Parameter]:
        """Those of a single fit.

        Raises
        ------
        InputError
            Of several fits: ``fits["a"].parameters`` are those of one, `to_dataframe` has all.
        """
        if len(self) != 1:
            raise refuse("parameters", None, f"are those of one of {len(self)} fits: "
                         "fits[NAME].parameters, or to_dataframe() for all")
        return self._fits[0].parameters

    def plot(self, axes: Any = None) -> Any:
        """Draws the curves of all fits into one picture, with matplotlib. Returns the axes."""
        for one in self._fits:
            axes = one.plot(axes)
        if len(self) > 1:
            axes.set_title("")
        return axes

    @property
    def confidence(self) -> float:
        """Of the intervals."""
        return self._contents.confidence

    @property
    def advised(self) -> str | None:
        """Where laws are compared: the law that is advised for all specimens; None if none is."""
        return self._contents.advised

    def report(self, *, all: bool = False) -> str:
        """What the command prints; with `all` the whole report of each fit."""
        return self._contents.report(all)

    def to_json(self) -> str:
        """What the command writes with ``--json``."""
        return self._contents.json()

    def to_dataframe(self) -> pandas.DataFrame:
        """A row for each fit: name, law, status, and value and error of each parameter [SI]."""
        import pandas

        rows = []
        for one in self._fits:
            row: dict[str, Any] = {"name": one.name, "law": one.law, "status": one.status,
                                   "usable": one.usable}
            for parameter in one.parameters.values():
                row[parameter.name] = parameter.value
                row[f"{parameter.name}_error"] = parameter.error
                row[f"{parameter.name}_low"], row[f"{parameter.name}_high"] = parameter.interval
                row[f"{parameter.name}_verdict"] = parameter.verdict or parameter.role
            row["misfit_fraction"] = one.misfit_fraction
            if isinstance(one._record, _core.CurveFit):
                row.update({key if key not in row else f"group {key}": value
                            for key, value in one.group.items()})
            rows.append(row)
        return pandas.DataFrame(rows)

    def save(self, path: str | PathLike[str], *, overwrite: bool = False) -> None:
        """Writes the result file, which `plastica.load` and the command read.

        Raises
        ------
        InputError
            If the file is there and is not to be overwritten, or its folder is not.
        """
        write(self._contents, path, overwrite)

    def __reduce__(self) -> tuple[Any, ...]:
        return _from_bytes, (to_bytes(self._contents),)

    def _repr_html_(self) -> str:
        return str(self.to_dataframe().to_html(float_format="{:.6g}".format))

    def __repr__(self) -> str:
        words = [one.status for one in self._fits]
        counts = ", ".join(f"{words.count(word)} {word}" for word in dict.fromkeys(words))
        return f"<Fits: {len(self)}: {counts}>"


def _from_bytes(content: bytes) -> Fits:
    return from_bytes(content, read)


def read(path: str) -> Fits:
    """Reads a result file of fits, of either kind."""
    if _core.schema_of(path) == "plastica/scene-fits":
        return Fits(_core.read_scene_fits(path))
    return Fits(_core.read_curve_fits(path))
