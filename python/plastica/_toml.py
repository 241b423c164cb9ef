"""Dictionaries as the TOML of our files.

Numbers are in SI here; files give each its unit. `with_units` adds it, by the names of the keys,
from the engine's own tables. A number of a key that they do not know stays bare, and is refused on
reading where a unit is needed.
"""

from __future__ import annotations

import re
from functools import cache
from typing import Any, Mapping

import numpy as np

from . import _core
from .errors import refuse

_PURE = ("", "1")
# Lists and tables that are no fields of the engine's tables.
_OF_HISTORY = {"time": "s", "smooth_step": "s", "period": "s", "phase": "rad"}
_FURTHER = {
    "beam.joint_lengths": "m",
    "beam.points": "m",
    "gravity": "m/s^2",
    "gravity.acceleration": "m/s^2",
    "cut.time": "s",
    "fit.noise": "Pa",
    "target.characteristics.modulus": "Pa",
    "target.characteristics.window": "Pa",
}


@cache
def _units() -> dict[str, str]:
    units = {field["path"]: field["unit"] for field in _core.fields()}
    units.update(_FURTHER)
    for path, unit in list(units.items()):
        if path[-1].isdigit():
            units[path.rpartition("_")[0]] = unit  # the list of "plastic_strain_1" and its like
    for path, unit in list(units.items()):
        table, _, rest = path.partition(".")
        if table in ("material", "section"):
            units[f"beam.{path}"] = unit
            units[f"region.{path}"] = unit
        if table == "section":
            units[f"region.to_section.{rest}"] = unit
    return units


@cache
def _item_units() -> dict[str, dict[str, tuple[str, str]]]:
    return _core.item_units()


def _are_fractions(window: Any) -> bool:
    return isinstance(window, list) and all(
        isinstance(each, (int, float)) and each <= 1.0 for each in window)


def _unit_of(path: str, table: Mapping[str, Any]) -> str:
    """Unit of the numbers of a key in its table."""
    item, _, key = path.rpartition(".")
    if "table" in table:  # its keys name columns
        return ""
    if path.endswith("characteristics.window") and _are_fractions(table[key]):
        return ""  # of the proof stress
    if item in _item_units() and key in _item_units()[item]:
        return _item_units()[item][key]["to" in table]
    if path.endswith("history.factor") or ".history." not in f".{path}":
        return _units().get(path, "")
    return _OF_HISTORY.get(key, "")


def plain(value: Any) -> Any:
    """The same in Python's own types: arrays as lists, NumPy's numbers as Python's."""
    if isinstance(value, Mapping):
        return {str(key): plain(each) for key, each in value.items() if each is not None}
    if isinstance(value, np.ndarray):
        return plain(value.tolist())
    if isinstance(value, np.generic):
        return plain(value.item())
    if isinstance(value, (list, tuple)):
        return [plain(each) for each in value]
    return value


def with_units(value: Any, path: str = "") -> Any:
    """A tree of plain values, each number with the unit that files want."""
    if not isinstance(value, dict):
        return value
    result = {}
    for key, each in value.items():
        inner = f"{path}.{key}" if path else key
        if isinstance(each, dict):
            result[key] = with_units(each, inner)
        elif isinstance(each, list) and each and all(isinstance(item, dict) for item in each):
            result[key] = [with_units(item, inner) for item in each]
        else:
            result[key] = give_unit(each, _unit_of(inner, value))
    return result


def give_unit(value: Any, unit: str) -> Any:
    """A number, or each of a list, as a text with its unit; texts stay as they are."""
    if unit in _PURE:
        return value
    if isinstance(value, list):
        return [give_unit(each, unit) for each in value]
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return f"{value!r} {unit}"
    return value


_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+\Z")
_ESCAPES = {'"': '\\"', "\\": "\\\\", "\n": "\\n", "\t": "\\t", "\r": "\\r"}


def _text(value: str) -> str:
    quoted = "".join(
        _ESCAPES.get(c, c if c >= " " and c != "\x7f" else f"\\u{ord(c):04x}") for c in value
    )
    return f'"{quoted}"'


def _key(key: str) -> str:
    return key if _BARE_KEY.match(key) else _text(key)


def _inline(value: Any, path: str) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return repr(value)  # the shortest text that is this number; nan and inf are TOML's, too
    if isinstance(value, list):
        return "[" + ", ".join(_inline(each, path) for each in value) + "]"
    if isinstance(value, dict):
        inside = (f"{_key(key)} = {_inline(each, path)}" for key, each in value.items())
        return "{ " + ", ".join(inside) + " }" if value else "{}"
    raise refuse(path, value, f"is a {type(value).__name__}: must be a number, a text or a list")


def _is_tables(value: Any) -> bool:
    return isinstance(value, list) and bool(value) and all(isinstance(i, dict) for i in value)


def write(tree: Mapping[str, Any]) -> str:
    """A tree of plain values as TOML: keys of the top, then a table each."""
    lines = [
        f"{_key(key)} = {_inline(value, key)}"
        for key, value in tree.items()
        if not isinstance(value, dict) and not _is_tables(value)
    ]
    for key, value in tree.items():
        for table in value if _is_tables(value) else [value] if isinstance(value, dict) else []:
            lines.append("")
            lines.append(f"[{_key(key)}]" if isinstance(value, dict) else f"[[{_key(key)}]]")
            lines.extend(f"{_key(k)} = {_inline(v, f'{key}.{k}')}" for k, v in table.items())
    return "\n".join(lines).strip("\n") + "\n"
