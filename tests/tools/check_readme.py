#!/usr/bin/env python3
"""Holds the README to what the program does: its examples are the ones that tests build and run,
and the report that it shows is the one that the command prints.

    check_readme.py COMMAND          checks
    check_readme.py COMMAND --write  writes what comes out into the README
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def marked(name):
    return re.compile(rf"(<!-- {name} -->\n)(.*?)(<!-- /{name} -->)", re.DOTALL)


def fenced(language, text):
    return f"```{language}\n{text.rstrip()}\n```\n"


def run(command, *arguments, folder):
    done = subprocess.run([command, *arguments], cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(arguments)}: exit code {done.returncode}: {done.stderr}")
    return done.stdout


def first_group(report):
    """A sweep's report up to the end of its first table."""
    return "\n\n".join(report.split("\n\n")[:2])


def without_time(report):
    """A check's report without the seconds of its last line."""
    return re.sub(r", [\d.e-]+ s$", "", report.rstrip())


def without_comment(text):
    """A file without the comment at its top."""
    return re.sub(r"\A(#.*\n)+\n", "", text)


def one_joint(text):
    """The lines of joint 1 in a beam for OpenSees."""
    return re.search(r"# joint_1\n.*?\n(?=# joint_2)", text, re.DOTALL).group(0)


def main():
    command = str(pathlib.Path(sys.argv[1]).resolve())
    write = "--write" in sys.argv[2:]
    path = ROOT / "README.md"
    text = path.read_text()
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(ROOT / "data", pathlib.Path(folder) / "data")
        report = run(command, "calibrate", "data/fits/demo.toml", "-o", "demo.h5", folder=folder)
        through = run(command, "calibrate", "data/fits/bend_test.toml", "-o", "bend.h5",
                      folder=folder)
        scene = run(command, "simulate", "data/scenes/report_fig06_bent.toml", "-o", "bent.h5",
                    folder=folder)
        beam = run(command, "export", "bent.h5", "--to", "opensees", "--segments", "4",
                   folder=folder)
        shutil.copytree(ROOT / "tests/reference", pathlib.Path(folder) / "tests/reference")
        sweep = run(command, "sweep", "data/sweeps/cantilever_deflection.toml", "-o", "sweep.h5",
                    folder=folder)
        chosen = run(command, "recommend", "sweep.h5", "--within", "0.1 %", folder=folder)
        checked = run(command, "check", "data/checks/motion.toml", folder=folder)
        expected = {
            "sweep-report": fenced("text", first_group(sweep)),
            "recommend-report": fenced("text", chosen),
            "check-report": fenced("text", without_time(checked)),
            "export-example": fenced("tcl", one_joint(beam)),
            "scene-fit-example": fenced("toml", without_comment(
                (ROOT / "data/fits/bend_test.toml").read_text())),
            "scene-fit-report": fenced("text", through),
            "scene-report": fenced("text", scene),
            "demo-report": fenced("text", report),
            "library-example": fenced("cpp", (ROOT / "tests/consumer/main.cpp").read_text()),
            "breaking-example": fenced("cpp", (ROOT / "tests/consumer/breaking.cpp").read_text()),
            "beam-example": fenced("cpp", (ROOT / "tests/consumer/beam.cpp").read_text()),
        }
        example = marked("fit-example").search(text).group(2)
        toml = re.search(r"```toml\n(.*?)```", example, re.DOTALL).group(1)
        (pathlib.Path(folder) / "data/fits/example.toml").write_text(toml)
        run(command, "calibrate", "data/fits/example.toml", "-o", "example.h5", folder=folder)

    stale = []
    for name, block in expected.items():
        if marked(name).search(text).group(2) != block:
            stale.append(name)
            text = marked(name).sub(lambda match: match.group(1) + block + match.group(3), text)
    if write:
        path.write_text(text)
    elif stale:
        sys.exit(f"README.md is stale: {', '.join(stale)}; tests/tools/check_readme.py --write")


if __name__ == "__main__":
    main()
