"""What all tables of a scene have in common."""

from __future__ import annotations

import dataclasses
import difflib
from typing import Any, ClassVar, Mapping, TypeVar

from ._toml import plain
from .errors import InputError, refuse

T = TypeVar("T", bound="Table")


def _nearest(word: str, words: list[str]) -> str:
    near = difflib.get_close_matches(word, words, n=1)
    return f"; did you mean {near[0]}?" if near else f": one of {', '.join(words)}"


class Table:
    """A table of a scene: its attributes are the keys of files, None where one is not given.

    Numbers are in SI; a text may have a unit of its own, ``"355 MPa"``. A name that the table does
    not have is an `InputError` that says the nearest.
    """

    _tables: ClassVar[Mapping[str, type[Table]]] = {}
    """Keys that are tables themselves."""
    __slots__ = ()

    @classmethod
    def _keys(cls) -> list[str]:
        return [field.name for field in dataclasses.fields(cls)]

    @classmethod
    def _refuse(cls, name: str, value: Any) -> InputError:
        return refuse(f"{cls.__name__}.{name}", value, "is no name there" + _nearest(name, cls._keys()))

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and self.to_dict() == other.to_dict()  # type: ignore[attr-defined]

    def __repr__(self) -> str:
        given = ((name, getattr(self, name)) for name in self._keys())
        said = ", ".join(f"{name}={value!r}" for name, value in given
                         if value is not None and value != [] and name != "source")
        return f"{type(self).__name__}({said})"

    def __setattr__(self, name: str, value: Any) -> None:
        if name not in self._keys() and not name.startswith("_"):
            raise self._refuse(name, value)
        object.__setattr__(self, name, value)

    def to_dict(self) -> dict[str, Any]:
        """The table as a dictionary, as TOML has it, without what is not given."""
        result = {}
        for name in self._keys():
            value = getattr(self, name)
            if value is None or isinstance(value, list) and not value:
                continue
            result[name] = _as_dict(value)
        return result

    @classmethod
    def from_dict(cls: type[T], table: Mapping[str, Any]) -> T:
        """A table from the keys and values of a file.

        Raises
        ------
        InputError
            For a key that there is not.
        """
        if not isinstance(table, Mapping):
            raise refuse(cls.__name__, table, "must be a dictionary")
        given: dict[str, Any] = {}
        for key, value in table.items():
            if key not in cls._keys():
                raise cls._refuse(key, value)
            inner = cls._tables.get(key)
            given[key] = inner.from_dict(value) if inner and isinstance(value, Mapping) else value
        return cls(**given)


def _as_dict(value: Any) -> Any:
    if isinstance(value, Table):
        return value.to_dict()
    if isinstance(value, (list, tuple)):
        return [_as_dict(each) for each in value]
    return plain(value)


def table(cls: type[T]) -> type[T]:
    """Makes the constructor of a dataclass say which name it does not know."""
    made = cls.__init__

    def __init__(self: Any, *args: Any, **kwargs: Any) -> None:
        for name in kwargs:
            if name not in cls._keys():
                raise cls._refuse(name, kwargs[name])
        made(self, *args, **kwargs)

    __init__.__doc__ = made.__doc__
    setattr(__init__, "__wrapped__", made)
    setattr(cls, "__init__", __init__)
    return cls
