#!/usr/bin/env python3
"""write_fields.py EXTENSION OUT.py: the tables of a scene as dataclasses, from the engine's own table
of fields, so that a new field is in Python as soon as it is in the engine."""

import importlib.util
import sys
from pathlib import Path

HEAD = '''"""The tables of a scene that have fields: made from the engine's table, not to be edited.

Numbers are in SI, or texts with a unit, ``"355 MPa"``; None is the default that stands in the doc.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, ClassVar, Literal, Mapping, Sequence, Union

import numpy as np
import numpy.typing as npt

from ._table import Table, table

__all__ = [{names}]

Number = Union[float, str, None]
"""A number in SI, a text with a unit, or nothing. A strain of 1 and more needs its unit, since it may be
meant in percent."""
Numbers = Union[Sequence[Number], npt.NDArray[np.floating[Any]]]
"""Several of them."""
'''

# The tables, each behind those that it holds; with keys of files that are no fields.
TABLES = {
    "material.hardening": ("Hardening", "The hardening law of a material.", {}),
    "material.rate": ("Rate", "How the yield stress rises with the strain rate.", {}),
    "material": ("Material", "What the beam is made of.", {
        "name": ("str | None", "a named material, which the other fields change"),
    }),
    "section": ("Section", "The beam's section.", {
        "profile": ("str | None", 'a rolled profile, "IPE 200", in place of shape and dimensions'),
    }),
    "beam": ("Beam", "The beam's axis and its segments.", {
        "section": ("Section | None", "in place of the scene's"),
        "material": ("Material | None", "in place of the scene's"),
        "arc_towards": ("str | Numbers | None", "of an arc: direction of its centre"),
        "points": ("Sequence[Numbers] | npt.NDArray[np.floating[Any]] | None", "of a polyline [m]"),
        "segment_lengths": ("Numbers | None",
                            'texts with a unit, or fractions of the length [1]'),
        "joint_lengths": ("Numbers | None", "length that each joint stands for [m]"),
    }),
    "rules": ("Rules", "By which rules a chain stands for the beam.", {}),
    "solver": ("Solver", "How the scene is solved.", {
        "control_at": ("str | float | Mapping[str, int] | None", "the point that is watched"),
        "control_motion": ("Numbers | None",
                           'of control = "displacement": how far that point is taken, x, y, z [m]'),
    }),
}

# What a text in place of the table stands for.
BARE = {"material": "name", "section": "profile"}


def hint(field):
    if field["kind"] == "choice":
        words = ", ".join(f'"{word}"' for word in field["choices"])
        return f"Literal[{words}] | None"
    return "int | None" if field["kind"] == "integer" else "Number"


def doc(field):
    unit = f' [{field["unit"]}]' if field["unit"] else ""
    rule = f'; {field["rule"]}' if field["rule"] else ""
    return f'{field["doc"]}{unit}{rule}. Default: {field["default"]}.'


def wrapped(text, indent, width=99):
    lines, line = [], ""
    for word in text.split():
        if line and len(indent) + len(line) + 1 + len(word) > width:
            lines.append(indent + line)
            line = word
        else:
            line = f"{line} {word}" if line else word
    return "\n".join([*lines, indent + line])


def write_table(prefix, fields, tables):
    name, about, further = TABLES[prefix]
    own = [f for f in fields if f["path"].rpartition(".")[0] == prefix]
    entries = [(f["path"].rpartition(".")[2], hint(f), doc(f)) for f in own]
    inner = {}
    for other, (other_name, other_about, _) in TABLES.items():
        if other.startswith(prefix + "."):
            inner[other.rpartition(".")[2]] = other_name
            entries.append((other.rpartition(".")[2], other_name, other_about))
    # "plastic_strain_1" and its like have a list, too.
    for key in dict.fromkeys(k.rpartition("_")[0] for k, _, _ in entries if k[-1].isdigit()):
        entries.append((key, "Numbers | None", f"The numbers {key}_1, {key}_2, … in a row."))
    for key, (type_hint, text) in further.items():
        entries.append((key, type_hint, text[0].upper() + text[1:] + "."))
    for key in ("section", "material"):
        if prefix == "beam":
            inner[key] = key.capitalize()
    lines = ["", "", "@table", "@dataclass(slots=True, kw_only=True, eq=False, repr=False)", f"class {name}(Table):",
             f'    """{about}', "", "    Attributes", "    ----------"]
    for key, type_hint, text in entries:
        kind = type_hint.replace(" | None", "").replace("Number", "float or str")
        lines.append(wrapped(f"{key} : {kind}", "    "))
        lines.append(wrapped(text, "        "))
    lines.append('    """')
    if inner:
        held = ", ".join(f'"{key}": {value}' for key, value in inner.items())
        lines += ["", f"    _tables: ClassVar[Mapping[str, type[Table]]] = {{{held}}}"]
        if prefix != "beam":
            lines.append("    _always: ClassVar[bool] = True")
    if prefix in BARE:
        lines += ["", f'    _bare: ClassVar[str] = "{BARE[prefix]}"']
    lines.append("")
    for key, type_hint, _ in entries:
        always = key in inner and prefix != "beam"
        lines.append(f"    {key}: {type_hint} = "
                     + (f"field(default_factory={type_hint})" if always else "None"))
    tables.append("\n".join(lines))


def main():
    extension, out = sys.argv[1:]
    spec = importlib.util.spec_from_file_location("_core", extension)
    core = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(core)
    fields = core.fields()
    tables = []
    for prefix in TABLES:
        write_table(prefix, fields, tables)
    names = ", ".join(f'"{name}"' for name, _, _ in TABLES.values())
    Path(out).write_text(HEAD.replace("{names}", f'{names}, "Number", "Numbers"') + "".join(tables) + "\n")


if __name__ == "__main__":
    main()
