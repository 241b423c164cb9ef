#!/usr/bin/env python3
"""Fits whose numbers stay as they are, whatever happens to the code around them.

pinned_fits.py COMMAND TABLE SHARED DATA [--write]: runs fits of measured curves (SHARED/data) and
of the shipped bend test (DATA), and compares them with the table: values and costs to 1e-6,
standard errors to 1e-3. Without SHARED/data the bend test alone is fitted, but for
PLASTICA_REQUIRE_SHARED=1. With --write the table is made anew. A number of the table changes only
where the commit that changes it says why.
"""

import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile

VALUE_TOLERANCE = 1e-6
ERROR_TOLERANCE = 1e-3

CYCLIC = """
[[target]]
files   = "SHARED/s355j2-resspylab/example_1.csv"
strain  = { column = "e_true", unit = "1" }
stress  = { column = "Sigma_true", unit = "MPa" }
measure = "true"
"""
MODULUS_AND_YIELD = """
youngs_modulus = {}
yield_stress   = {}
"""
BILINEAR = """
[fit]
objective = "least-squares"

[fit.parameters]
youngs_modulus  = { value = "1.5 Pa", fixed = true }
yield_stress    = {}
tangent_modulus = {}

[material.hardening]
law = "linear"
"""
FITS = {
    "cyclic": "[fit]\nlaws = ['ideal', 'linear', 'voce', 'chaboche']\n[fit.parameters]"
              + MODULUS_AND_YIELD + CYCLIC,
    "al6061-t6": """
[[target]]
files  = "SHARED/al6061t6-matcal/cleaned_*.csv"
strain = { column = "engineering_strain", unit = "in/in" }
stress = { column = "engineering_stress", unit = "ksi" }
""",
    "al6061-t651": """
[[target]]
files  = "SHARED/al6061t651-aakash/test_ID_*.csv"
strain = { column = "Strain", unit = "1" }
stress = { column = "Stress_MPa", unit = "MPa" }
""",
    "s355": """
[[target]]
files  = "SHARED/s355-bam/Zx*.csv"
strain = { column = "Extensometer elongation" }
force  = { column = "Load" }
area   = { from = "S0_mm2", unit = "mm^2" }
table  = { file = "SHARED/s355-bam/published_values.csv", key = "specimen" }
""",
    "bilinear": BILINEAR + """
[[target]]
files  = ["SHARED/synthetic-bilinear/bilinear_lownoise.csv", "SHARED/synthetic-bilinear/linear.csv"]
strain = { column = "strain", unit = "1" }
stress = { column = "stress", unit = "Pa" }
plausible = { accept = true }
""",
    "200 specimens": BILINEAR,
    "200 specimens together": """
[fit]
starts = 1

[fit.parameters]
yield_stress    = { bounds = ["0.01 Pa", "1 Pa"] }
tangent_modulus = { bounds = ["0.01 Pa", "1 Pa"] }
""",
    "bend test": (pathlib.Path("fits") / "bend_test.toml"),
}
COUPON = """
[material]
youngs_modulus = "1.5 Pa"
yield_stress   = "0.15 Pa"

[material.hardening]
law             = "linear"
tangent_modulus = "0.1 Pa"

[drive]
strain = ["0 %", "100 %"]

[[probe]]
name = "stress"
kind = "stress"
"""


def prepare(name, folder, shared, data):
    """Writes the fit file of a name into a folder; gives its path."""
    fit = FITS[name]
    if isinstance(fit, pathlib.Path):
        return data / fit
    if name.startswith("200 specimens"):
        fit += specimens(name, folder, shared)
    path = folder / "fit.toml"
    path.write_text(fit.replace("SHARED", str(shared)))
    return path


def specimens(name, folder, shared):
    """A file for each of the 200 curves, and the targets of a fit file that has them."""
    together = name.endswith("together")
    with open(shared / "synthetic-bilinear" / "uq_200_samples.csv", newline="") as file:
        rows = list(csv.reader(file))
    targets = ""
    for column in range(1, len(rows[0])):
        curve = f"curve_{column:03}.csv"
        (folder / curve).write_text(
            "strain,stress\n" + "".join(f"{row[0]},{row[column]}\n" for row in rows[1:]))
        if together:
            targets += (f"[[target]]\nfiles = '{curve}'\nscene = 'coupon.toml'\n"
                        "abscissa = { drive = 'strain', column = 'strain', unit = '1' }\n"
                        "ordinate = { probe = 'stress', column = 'stress', unit = 'Pa' }\n")
    if together:
        (folder / "coupon.toml").write_text(COUPON)
        return targets
    return ("[[target]]\nfiles = 'curve_*.csv'\nstrain = { column = 'strain', unit = '1' }\n"
            "stress = { column = 'stress', unit = 'Pa' }\nplausible = { accept = true }\n")


def rows_of(name, command, shared, data):
    """What came of a fit: (fit, target, law, quantity, value, error), one row each."""
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        fit = prepare(name, folder, shared, data)
        run = subprocess.run(
            [command, "calibrate", str(fit), "-o", "fit.h5", "--json", "fit.json", "--quiet"],
            cwd=folder, capture_output=True, text=True, check=False)
        if run.returncode not in (0, 1) or not (folder / "fit.json").exists():
            raise SystemExit(f"{name}: exit code {run.returncode}: {run.stderr}")
        result = json.loads((folder / "fit.json").read_text())
    rows = []
    for fit in result["fits"]:
        numbers = {"cost": (cost_of(fit), None)}
        for parameter, p in fit["parameters"].items():
            numbers[parameter] = (p["value"], p["standard_error"])
        for parameter, p in ((fit.get("segments") or {}).get("parameters") or {}).items():
            numbers[parameter + " extrapolated"] = (p["extrapolated"], p["error"])
        rows += [(name, fit["name"], fit["law"], quantity, *number)
                 for quantity, number in numbers.items()]
    return summary_of(rows) if name == "200 specimens" else rows


def cost_of(fit):
    if "cost" in fit:
        return fit["cost"]
    return sum(target["cost"] for target in fit["targets"])


def summary_of(rows):
    """Mean, and root mean square as its error, of each number over all targets."""
    quantities = {}
    for name, _, law, quantity, value, error in rows:
        quantities.setdefault((name, "mean", law, quantity), []).append(
            (value, 0.0 if error is None else error))
    return [(*key, sum(value for value, _ in numbers) / len(numbers),
             (sum(error * error for _, error in numbers) / len(numbers))**0.5)
            for key, numbers in quantities.items()]


def text_of(number):
    return "" if number is None else f"{number:.9g}"


def differs(now, pinned, tolerance):
    if pinned == "" or now is None:
        return pinned != text_of(now)
    return abs(now - float(pinned)) > tolerance * abs(float(pinned))


def write(table, rows):
    """A line for each fit, two columns for each quantity: its value and the standard error."""
    quantities = list(dict.fromkeys(row[3] for row in rows))
    lines = {}
    for *fit, quantity, value, error in rows:
        lines.setdefault(tuple(fit), {})[quantity] = (text_of(value), text_of(error))
    with open(table, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["fit", "target", "law"]
                        + [name for q in quantities for name in (q, q + " error")])
        for fit, numbers in lines.items():
            writer.writerow([*fit, *(text for q in quantities
                                     for text in numbers.get(q, ("-", "-")))])


def read(table):
    """The numbers of a table: texts of value and error by (fit, target, law, quantity)."""
    pinned = {}
    with open(table, newline="") as file:
        header, *lines = csv.reader(file)
    for line in lines:
        for k in range(3, len(header), 2):
            if line[k] != "-":
                pinned[(*line[:3], header[k])] = (line[k], line[k + 1])
    return pinned


def main():
    command, table, shared, data = sys.argv[1:5]
    table, shared = pathlib.Path(table), pathlib.Path(shared) / "data"
    names = list(FITS)
    if not shared.exists():
        if os.environ.get("PLASTICA_REQUIRE_SHARED") == "1":
            raise SystemExit(f"{shared} is absent")
        names = ["bend test"]
        print(f"{shared} is absent: the bend test alone is fitted")
    rows = [row for name in names
            for row in rows_of(name, str(pathlib.Path(command).resolve()), shared.resolve(),
                               pathlib.Path(data).resolve())]
    if "--write" in sys.argv:
        write(table, rows)
        return 0
    pinned = {key: number for key, number in read(table).items() if key[0] in names}
    wrong = 0
    for row in rows:
        value, error = pinned.pop(row[:4], (None, None))
        if value is None:
            print(f"{', '.join(row[:4])}: is not in {table.name}")
        elif differs(row[4], value, VALUE_TOLERANCE) or differs(row[5], error, ERROR_TOLERANCE):
            print(f"{', '.join(row[:4])}: {text_of(row[4])} ± {text_of(row[5])}, was {value} ± "
                  f"{error}")
        else:
            continue
        wrong += 1
    for key in pinned:
        print(f"{', '.join(key)}: is gone")
    print(f"{len(rows)} numbers, {wrong} of them not as they were, {len(pinned)} gone")
    return 1 if wrong or pinned else 0


if __name__ == "__main__":
    sys.exit(main())
