"""Result files are written alike."""

from __future__ import annotations

from os import PathLike, fspath
from typing import Protocol

from .errors import InputError


class Contents(Protocol):
    def write(self, path: str, overwrite: bool) -> None: ...


def write(contents: Contents, path: str | PathLike[str], overwrite: bool) -> None:
    """Writes a result file.

    Raises
    ------
    InputError
        If the file is there and is not to be overwritten, or its folder is not.
    OSError
        If it cannot be written.
    """
    try:
        contents.write(fspath(path), overwrite)
    except InputError as error:
        # The engine speaks of the command's option.
        rule = error.rule.replace("use --force", "say overwrite=True")
        raise InputError(error.file, error.line, error.field, error.value, rule) from None
