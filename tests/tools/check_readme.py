#!/usr/bin/env python3
"""Holds README.md and docs/*.md to what the program does: the examples in them are the ones that
tests build and run, and the reports are those that the command prints. A block stands in a page
between `<!-- NAME -->` and `<!-- /NAME -->`; which page that is, is found out.

    check_readme.py COMMAND          checks
    check_readme.py COMMAND --write  writes what comes out into the pages
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
CONSUMER = ROOT / "tests/consumer"
# Written by tests/benchmarks/compare.
WRITTEN_ELSEWHERE = {"speed"}


def marked(name):
    return re.compile(rf"(<!-- {name} -->\n)(.*?)(<!-- /{name} -->)", re.DOTALL)


def fenced(language, text):
    return f"```{language}\n{text.rstrip()}\n```\n"


def first_group(report):
    """A sweep's report up to the end of its first table."""
    return "\n\n".join(report.split("\n\n")[:2])


def chapters(report, *titles):
    """The head of a report, and those of its chapters that have these titles."""
    head, *rest = report.split("\n\n")
    return "\n\n".join([head] + [each for each in rest if each.split("\n")[0].startswith(titles)])


def until(report, title):
    """A report up to a chapter, without this."""
    return report[:report.index(f"\n{title}")]


def without_time(report):
    """A check's report without the seconds of its last line."""
    return re.sub(r", [\d.e-]+ s$", "", report.rstrip())


def without_comment(text):
    """A file without the comment at its top."""
    return re.sub(r"\A(#.*\n)+\n", "", text)


def one_joint(text):
    """The lines of joint 1 in a beam for OpenSees."""
    return re.search(r"# joint_1\n.*?\n(?=# joint_2)", text, re.DOTALL).group(0)


def build_of(program):
    """How the user's project of the tests finds the library and builds one of its programs."""
    lines = (CONSUMER / "CMakeLists.txt").read_text().splitlines()
    return "\n".join(line for line in lines
                     if line.startswith("find_package") or f"({program} " in line)


def printed_by(program):
    """What that program is tested to print."""
    text = (CONSUMER / "check.cmake").read_text()
    return re.search(rf'prints\({program}\s+"(.*?)"\)', text, re.DOTALL).group(1).replace("\\n", "\n")


class Command:
    """Runs the command in a folder that has the shipped data, as a clone has them."""

    def __init__(self, command, folder):
        self.command = command
        self.folder = folder
        shutil.copytree(ROOT / "data", folder / "data")
        shutil.copytree(ROOT / "tests/reference", folder / "tests/reference")

    def __call__(self, *arguments):
        done = subprocess.run([self.command, *arguments], cwd=self.folder, capture_output=True,
                              text=True)
        if done.returncode != 0:
            sys.exit(f"{' '.join(arguments)}: exit code {done.returncode}: {done.stderr}")
        return done.stdout


def blocks(run):
    """What each block has to be, by its name."""
    shutil.copy(run.folder / "data/targets/al6061-t651-20c.csv", run.folder / "specimen.csv")
    fit = run("calibrate", "specimen.csv", "-o", "specimen.h5")
    laws = run("calibrate", "specimen.csv", "--laws", "ideal,linear,voce", "-o", "laws.h5")
    sure = run("calibrate", "specimen.csv", "--profile", "--bootstrap", "400", "-o", "sure.h5")
    batch = run("calibrate", "data/fits/demo.toml", "-o", "demo.h5")
    through = run("calibrate", "data/fits/bend_test.toml", "-o", "bend_test.h5")
    scene = run("simulate", "data/scenes/report_fig06_bent.toml", "-o", "bent.h5")
    crash = run("simulate", "data/scenes/crash_bumper.toml", "-o", "crash.h5")
    beam = run("export", "bent.h5", "--to", "opensees", "--segments", "4")
    sweep = run("sweep", "data/sweeps/cantilever_deflection.toml", "-o", "sweep.h5")
    arm = run("advise", "data/scenes/robot_arm.toml", "--within", "1 %", "--for", "mujoco")
    checked = run("check", "data/checks/motion.toml")
    reports = {
        "fit-report": chapters(fit, "Characteristics", "Parameters", "Warnings"),
        "laws-report": laws.split("\n\nspecimen: ")[0],
        "intervals-report": re.search(r"Intervals of .*?\n\n", sure, re.DOTALL).group(0),
        "batch-report": batch.split("\n\n")[0],
        "scene-fit-report": through,
        "scene-report": until(scene, "Joints"),
        "motion-report": chapters(crash, "Breaks", "Fragments", "Energies"),
        "sweep-report": first_group(sweep),
        "mujoco-advice": arm,
        "check-report": without_time(checked),
        "breaking-prints": printed_by("breaking"),
    }
    expected = {name: fenced("text", text) for name, text in reports.items()}
    for name, program in (("beam-example", "beam"), ("breaking-example", "breaking"),
                          ("coupon-example", "main")):
        expected[name] = fenced("cpp", (CONSUMER / f"{program}.cpp").read_text())
    expected["beam-prints"] = f"It prints `{printed_by('beam').rstrip()}`.\n"
    expected["cmake-example"] = fenced("cmake", build_of("beam"))
    expected["export-example"] = fenced("tcl", one_joint(beam))
    expected["scene-fit-example"] = fenced("toml", without_comment(
        (ROOT / "data/fits/bend_test.toml").read_text()))
    return expected


def refreshed(text, expected, seen):
    """A page with the blocks as they have to be, and the names of those that were not."""
    stale = []
    for name in re.findall(r"^<!-- /([\w-]+) -->$", text, re.MULTILINE):
        seen.add(name)
        if name in WRITTEN_ELSEWHERE:
            continue
        block = expected.get(name)
        if block is None or not marked(name).search(text):
            sys.exit(f"<!-- {name} --> is no block that can be written")
        if marked(name).search(text).group(2) != block:
            stale.append(name)
            text = marked(name).sub(lambda match: match.group(1) + block + match.group(3), text)
    return text, stale


def main():
    command = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as folder:
        expected = blocks(Command(command, pathlib.Path(folder)))
    outdated, seen = [], set()
    for path in [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]:
        text, stale = refreshed(path.read_text(), expected, seen)
        if stale and "--write" in sys.argv[2:]:
            path.write_text(text)
        elif stale:
            outdated.append(f"{path.relative_to(ROOT)}: {', '.join(stale)}")
    for name in sorted(set(expected) - seen):
        outdated.append(f"no page shows {name}")
    if outdated:
        sys.exit("\n".join(outdated) + "\nis stale; tests/tools/check_readme.py COMMAND --write")


if __name__ == "__main__":
    main()
