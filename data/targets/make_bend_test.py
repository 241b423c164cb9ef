#!/usr/bin/env python3
"""Makes bend_test.csv: a bar that the library bends until it breaks, measured with noise.

    make_bend_test.py PLASTICA [OUTPUT]

PLASTICA is the command. The specimen is data/scenes/bend_test.toml with 1280 segments, 800 steps,
and E = 205 GPa, a yield stress of 380 MPa and a break strain of 2 %. Its force is read every 0.5 mm
of the end's displacement and gets normal noise with a standard deviation of 5 N, from the generator
random.Random(2026).random() by Box and Muller's formula; rows have 0.1 N. The last row, of no
force, says that the bar broke before it.
"""
import csv
import math
import pathlib
import random
import subprocess
import sys
import tempfile

NOISE = 5.0  # [N]
EVERY = 0.5  # [mm]
CHANGES = {
    "segments = 20": "segments = 1280",
    "steps = 80": "steps = 800\nframes = 1",
    'name = "S355"': 'name = "S355"\nyoungs_modulus = "205 GPa"\nyield_stress = "380 MPa"\n'
                     'break_strain = "2 %"',
}


def simulated(plastica, scene, folder):
    """Way [mm] and force [N] of the specimen up to its break, both positive."""
    text = scene.read_text(encoding="utf-8")
    for old, new in CHANGES.items():
        if text.count(old) != 1:
            sys.exit(f"{scene}: '{old}' must be there once")
        text = text.replace(old, new)
    (folder / "specimen.toml").write_text(text, encoding="utf-8")
    result, table = folder / "specimen.h5", folder / "specimen.csv"
    subprocess.run([plastica, "simulate", folder / "specimen.toml", "-o", result, "--quiet"],
                   check=True, stdout=subprocess.DEVNULL)
    subprocess.run([plastica, "export", result, "--what", "probes", "-o", table], check=True)
    with open(table, newline="", encoding="utf-8") as file:
        return [(-1e3 * float(row["displacement [m]"]), -float(row["force [N]"]))
                for row in csv.DictReader(file)]


def normal(generator):
    size = math.sqrt(-2.0 * math.log(1.0 - generator.random()))
    return size * math.cos(2.0 * math.pi * generator.random())


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    here = pathlib.Path(__file__).resolve().parent
    output = pathlib.Path(sys.argv[2]) if len(sys.argv) == 3 else here / "bend_test.csv"
    with tempfile.TemporaryDirectory() as folder:
        curve = simulated(sys.argv[1], here.parent / "scenes" / "bend_test.toml",
                          pathlib.Path(folder))
    generator = random.Random(2026)
    rows, below, displacement = [], curve[0], 0.0
    for above in curve[1:]:
        while displacement <= above[0]:
            fraction = (displacement - below[0]) / (above[0] - below[0])
            force = below[1] + fraction * (above[1] - below[1]) + NOISE * normal(generator)
            rows.append(f"{way:.1f},{force:.1f}")
            displacement += EVERY
        below = above
    rows.append(f"{way:.1f},0")
    output.write_text("Displacement (mm),Force (N)\n" + "\n".join(rows) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
