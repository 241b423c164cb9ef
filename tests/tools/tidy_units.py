#!/usr/bin/env python3
"""What clang-tidy is to read for some sources: several of one folder at once, as the unity build
compiles them. Most of its time goes into headers, once for each file that it reads.

tidy_units.py BUILD OUT FILE…: prints the files to read, one a line, and writes their compile
commands to OUT/compile_commands.json: units of sources that BUILD, configured with
CMAKE_UNITY_BUILD, compiles as one, written to OUT, and sources by themselves. With --alone it prints
instead the sources that stand in a unit: each has to compile by itself as well, and some checks look
at the file alone that is compiled.
"""

import json
import pathlib
import re
import shlex
import shutil
import sys

INCLUDED = re.compile(r'^#include "(.+\.cpp)"$', re.M)


def compiled_by(commands):
    """For each source its command in the build, and which sources are compiled as one with it."""
    found = {}
    for entry in commands:
        file = pathlib.Path(entry["file"])
        together = [entry["file"]]
        if file.parent.name == "Unity":
            together = INCLUDED.findall(file.read_text(encoding="utf-8"))
        for source in together:
            found.setdefault(source, (entry, together))
    return found


def units_of(sources, commands):
    """Lists of sources to be read as one, each with the command of its build."""
    found = compiled_by(commands)
    units = {}
    for source in sources:
        if source not in found:
            sys.exit(f"{source} is compiled by nothing")
        entry, together = found[source]
        units.setdefault(entry["file"], (entry, together, []))[2].append(source)
    return [(entry, sorted(of_unit, key=together.index)) for entry, together, of_unit in
            units.values()]


def arguments_for(entry, file):
    """The command of an entry with another source."""
    return [file if argument == entry["file"] else argument
            for argument in shlex.split(entry["command"])]


def write_unit(root, out, number, sources):
    """A source that includes others, where the rules of their folder hold."""
    folder = pathlib.Path(sources[0]).relative_to(root).parent
    place = out / folder
    place.mkdir(parents=True, exist_ok=True)
    for above in [folder, *folder.parents][:-1]:
        if (root / above / ".clang-tidy").exists():
            shutil.copy(root / above / ".clang-tidy", out / above)
    unit = place / f"unit_{number}.cpp"
    unit.write_text("".join(f'#include "{source}"  // NOLINT(bugprone-suspicious-include)\n'
                            for source in sources), encoding="utf-8")
    return str(unit)


def main():
    alone = sys.argv[1] == "--alone"
    build, out, *files = sys.argv[2:] if alone else sys.argv[1:]
    root = pathlib.Path(__file__).resolve().parents[2]
    out = pathlib.Path(out).resolve()
    sources = [str(root / file) for file in files]
    commands = json.loads((pathlib.Path(build) / "compile_commands.json").read_text("utf-8"))
    units = units_of(sources, commands)
    if alone:
        for _, of_unit in units:
            if len(of_unit) > 1:
                print("\n".join(of_unit))
        return
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    written = []
    for number, (entry, of_unit) in enumerate(units):
        file = write_unit(root, out, number, of_unit) if len(of_unit) > 1 else of_unit[0]
        written += [{"directory": entry["directory"], "file": each,
                     "arguments": arguments_for(entry, each)} for each in {file, *of_unit}]
        print(file)
    (out / "compile_commands.json").write_text(json.dumps(written, indent=1), encoding="utf-8")


if __name__ == "__main__":
    main()
