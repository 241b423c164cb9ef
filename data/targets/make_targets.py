#!/usr/bin/env python3
"""Computes the shipped mean curves from measured ones.

    plastica export FITS.h5 --what curves -o curves.csv
    plastica export FITS.h5 -o specimens.csv
    make_targets.py curves.csv specimens.csv NAME [KEY=VALUE] [--knee PERCENT] [--end PERCENT]

Reads the corrected curves (toe and preload offset taken off, cut at the break) and the table of
specimens that `plastica export` writes. Below the knee the stresses of all specimens of the group
are averaged at equal strain. From there to the break they are averaged at equal fractions of the way
from the knee to each specimen's own break, so that the mean curve breaks at the mean break strain,
half way between the last row with a load and one more, of no load; with --end, or for specimens
without a break, at equal strain up to there. Written with four digits, 80 rows at most.
"""
import argparse
import csv


def interpolate(curve, strain):
    """Stress of a curve at a strain, straight between samples, from the origin."""
    below = (0.0, 0.0)
    for sample in curve:
        if sample[0] >= strain:
            width = sample[0] - below[0]
            fraction = (strain - below[0]) / width if width > 0.0 else 1.0
            return below[1] + fraction * (sample[1] - below[1])
        below = sample
    return below[1]


def read_curves(path):
    curves = {}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            if row["stress_measured [Pa]"]:
                sample = (float(row["strain [1]"]), float(row["stress_measured [Pa]"]))
                curves.setdefault(row["specimen"], []).append(sample)
    return curves


def read_breaks(path, group):
    key, _, value = (group or "=").partition("=")
    breaks = {}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            if row["status"] == "fitted" and (not key or row["group." + key] == value):
                text = row["break_strain [1]"]
                breaks[row["name"]] = float(text) if text else None
    return breaks


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("curves")
    parser.add_argument("specimens")
    parser.add_argument("name")
    parser.add_argument("group", nargs="?")
    parser.add_argument("--knee", type=float, default=1.0)
    parser.add_argument("--end", type=float)
    arguments = parser.parse_args()
    curves = read_curves(arguments.curves)
    breaks = read_breaks(arguments.specimens, arguments.group)
    names = sorted(breaks)
    knee = 0.01 * arguments.knee
    rows = []
    points = 30
    for i in range(points + 1):
        strain = knee * i / points
        rows.append((strain, [interpolate(curves[n], strain) for n in names]))
    points = 46
    broken = arguments.end is None and all(breaks[n] for n in names)
    mean_end = sum(breaks[n] for n in names) / len(names) if broken else 0.01 * arguments.end
    fractions = [i / points for i in range(1, points + 1)]
    if broken:  # half a step before the break, and half a step behind it
        fractions[-1] -= 0.5 / points
        gone = mean_end + 0.5 / points * (mean_end - knee)
    for fraction in fractions:
        strain = knee + fraction * (mean_end - knee)
        own = [knee + fraction * ((breaks[n] if broken else mean_end) - knee) for n in names]
        rows.append((strain, [interpolate(curves[n], s) for n, s in zip(names, own)]))
    with open(arguments.name + ".csv", "w") as out:
        out.write("Strain [%],Stress [MPa]\n")
        for strain, stresses in rows:
            mean = sum(stresses) / len(stresses)
            out.write(f"{100.0 * strain:.4g},{mean / 1e6:.4g}\n")
        if broken:
            out.write(f"{100.0 * gone:.4g},0\n")
    print(f"{arguments.name}: {len(names)} specimens, {len(rows) + broken} rows")


if __name__ == "__main__":
    main()
