"""What all tables of a scene have in common."""

from __future__ import annotations

import copy
import dataclasses
import difflib
from typing import Any, ClassVar, Mapping, TypeVar

from . import _core
from ._toml import plain
from .errors import InputError, refuse

T = TypeVar("T", bound="Table")


def _nearest(word: str, words: list[str]) -> str:
    near = difflib.get_close_matches(word, words, n=1)
    return f"; did you mean {near[0]}?" if near else f": one of {', '.join(words)}"


class Table:
    """A table of a scene: its attributes are the keys of files, None where one is not given.

    Numbers are in SI; a text may have a unit of its own, ``"355 MPa"``. A name that the table does
    not have is an `InputError` that says the nearest. In place of a table within it a mapping may
    be given, or the text that files have there: ``material="S355"``.
    """

    _tables: ClassVar[Mapping[str, type[Table]]] = {}
    """Attributes that are tables themselves."""
    _always: ClassVar[bool] = False
    """Whether these are there, if empty, where they are not given."""
    _lists: ClassVar[Mapping[str, tuple[str, type[Table]]]] = {}
    """Attributes that are lists of tables: the key of files, and their type."""
    _bare: ClassVar[str] = ""
    """The key that a text in place of the table stands for."""
    _hidden: ClassVar[frozenset[str]] = frozenset()
    """Attributes that are no keys."""
    __slots__ = ()

    @classmethod
    def _attributes(cls) -> list[str]:
        return [field.name for field in dataclasses.fields(cls)]

    @classmethod
    def _keys(cls) -> dict[str, str]:
        """Attributes by the keys of files; "from" is a word of Python."""
        names = (name for name in cls._attributes() if name not in cls._hidden)
        return {cls._lists[name][0] if name in cls._lists else name.rstrip("_"): name
                for name in names}

    @classmethod
    def _refuse(cls, name: str, value: Any, names: list[str]) -> InputError:
        return refuse(f"{cls.__name__}.{name}", value, "is no name there" + _nearest(name, names))

    @classmethod
    def _of(cls: type[T], value: Any) -> T:
        """A table from what may stand in its place."""
        if isinstance(value, cls):
            return value
        if isinstance(value, str) and cls._bare:
            return cls(**{cls._bare: value})
        if isinstance(value, Mapping):
            return cls.from_dict(value)
        raise refuse(cls.__name__, value, f"must be a {cls.__name__} or a dictionary")

    def __setattr__(self, name: str, value: Any) -> None:
        if name not in self._attributes():
            raise self._refuse(name, value, self._attributes())
        kind = self._tables.get(name)
        if kind is not None and (value is not None or self._always):
            value = kind() if value is None else kind._of(value)
        if name in self._lists:
            if not isinstance(value, (list, tuple)):
                raise refuse(f"{type(self).__name__}.{name}", value, "must be a list of tables")
            item = self._lists[name][1]
            value = [item._of(each) for each in value]
        object.__setattr__(self, name, value)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, type(self)) and self.to_dict() == other.to_dict()

    def __repr__(self) -> str:
        given = ((name, getattr(self, name)) for name in self._attributes()
                 if name not in self._hidden)
        said = ", ".join(f"{name}={value!r}" for name, value in given if not _is_nothing(value))
        return f"{type(self).__name__}({said})"

    def to_dict(self) -> dict[str, Any]:
        """The table as a dictionary with the keys of files, without what is not given."""
        result = {}
        for key, name in self._keys().items():
            value = getattr(self, name)
            if not _is_nothing(value):
                result[key] = _as_dict(value)
        return result

    @classmethod
    def from_dict(cls: type[T], table: Mapping[str, Any]) -> T:
        """A table from the keys and values of a file.

        Raises
        ------
        InputError
            For a key that there is not. Values are checked when the scene is run.
        """
        if not isinstance(table, Mapping):
            raise refuse(cls.__name__, table, "must be a dictionary")
        keys = cls._keys()
        given = {}
        for key, value in table.items():
            # A name that was changed is taken for one version.
            now = key if key in keys else _core.renamed_keys().get(key, key)
            if now not in keys:
                raise cls._refuse(key, value, list(keys))
            given[keys[now]] = copy.deepcopy(value)  # what is given stays its owner's
        return cls(**given)


def _is_nothing(value: Any) -> bool:
    if isinstance(value, Table):
        return not value.to_dict()
    return value is None or isinstance(value, list) and not value


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
            if name not in cls._attributes():
                raise cls._refuse(name, kwargs[name], cls._attributes())
        made(self, *args, **kwargs)

    __init__.__doc__ = made.__doc__
    setattr(__init__, "__wrapped__", made)
    setattr(cls, "__init__", __init__)
    return cls
