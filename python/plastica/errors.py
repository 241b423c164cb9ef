"""What is raised for bad input."""

from __future__ import annotations

from typing import Any

from . import _core

__all__ = ["InputError", "SceneWarning"]


class InputError(ValueError):
    """Bad input, in one line: ``FILE:LINE: FIELD = VALUE: RULE``.

    Attributes
    ----------
    file : str or None
        Path of the file in which it stands; None for what a program has set.
    line : int or None
        Line in that file, from 1 on.
    field : str or None
        Name of the field, column or argument, ``"material.yield_stress"``.
    value : str or None
        The value as it was given.
    rule : str
        What is allowed.
    """

    file: str | None
    line: int | None
    field: str | None
    value: str | None
    rule: str

    def __init__(
        self,
        file: str | None,
        line: int | None,
        field: str | None,
        value: str | None,
        rule: str,
    ) -> None:
        super().__init__(file, line, field, value, rule)
        self.file, self.line, self.field, self.value, self.rule = file, line, field, value, rule

    def __str__(self) -> str:
        place = self.file or ""
        if place and self.line is not None:
            place += f":{self.line}"
        said = " = ".join(part for part in (self.field, self.value) if part)
        return ": ".join(part for part in (place, said, self.rule) if part)


class SceneWarning(UserWarning):
    """What a reader must not overlook: what a result leaves out, or an old name in a file."""


def refuse(field: str, value: Any, rule: str) -> InputError:
    """An error of what a program has given."""
    return InputError(None, None, field, None if value is None else repr(value), rule)


_core.set_input_error(InputError)
