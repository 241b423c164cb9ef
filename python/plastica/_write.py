"""Results are written alike: to a file, and to the bytes of one for `pickle`."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from os import PathLike, fspath
from pathlib import Path
from typing import Protocol, TypeVar

from .errors import InputError

T = TypeVar("T")


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


def to_bytes(contents: Contents) -> bytes:
    """What a result file of these contents holds."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "result.h5"
        write(contents, path, overwrite=False)
        return path.read_bytes()


def from_bytes(content: bytes, read: Callable[[str], T]) -> T:
    """What `read` makes of a result file that holds this."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "result.h5"
        path.write_bytes(content)
        return read(str(path))
