"""Numbers that users give, as arrays of the engine's."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from .errors import InputError, refuse


def is_pandas(values: Any) -> bool:
    """Whether it is a table or column of pandas, which have names."""
    return type(values).__module__.partition(".")[0] == "pandas"


def check_aligned(one: Any, other: Any, name: str) -> None:
    """Two columns of pandas go by their indices, which must be the same.

    Raises
    ------
    InputError
        If they are not: they would be taken by position.
    """
    if is_pandas(one) and is_pandas(other) and not one.index.equals(other.index):
        raise refuse(name, None, "has columns of two indices: align them, or give arrays")


def numbers(values: Any, name: str) -> npt.NDArray[np.float64]:
    """An array of real numbers; what is masked is NaN, as a measurement that is missing.

    Raises
    ------
    InputError
        For what is no array of real numbers.
    """
    try:
        if np.iscomplexobj(values):
            raise refuse(name, None, "has imaginary parts: must be real numbers")
        if isinstance(values, np.ma.MaskedArray):
            masked: Any = values.astype(np.float64)
            values = masked.filled(np.nan)
        return np.asarray(values, dtype=np.float64)
    except InputError:
        raise
    except (TypeError, ValueError) as error:
        raise refuse(name, None, f"is no array of numbers: {error}") from error
