#!/usr/bin/env python3
"""What Python costs: a batch of one model, and fits of curves, beside the same in C++, in turn in one
run, one thread. Prints the medians and their ratio, C++ over Python: 1 is no cost at all.

    PYTHONPATH=build/release/python tests/benchmarks/python/throughput.py \\
      build/release/tests/benchmarks/python_throughput
"""

import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

import plastica

CASES, CURVES, TURNS = 5000, 1000, 7
DATA = Path(__file__).resolve().parents[3] / "data"
CURVE = DATA / "targets" / "al6061-t651-20c.csv"
FIT = f"""[[target]]
files = "{CURVE}"
strain = {{ column = "Strain" }}
stress = {{ column = "Stress" }}
"""


def seconds_of(work):
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def main():
    scene = plastica.Scene(
        material="S355", section={"shape": "rectangle", "width": 0.02, "height": 0.02},
        beam={"length": 1.0, "segments": 20}, rules={"yield_model": "elastic"},
        supports=[plastica.Support(kind="clamp", at="start")],
        loads=[plastica.Load(at="end", force=[0.0, -300.0, 0.0])],
        probes=[plastica.Probe(name="tip", kind="displacement", component="y")])
    model = plastica.prepare(scene, ["material.youngs_modulus"])
    values = 200e9 + 10e9 * np.arange(CASES)[:, np.newaxis] / CASES
    measured = plastica.fit(CURVE)[0].measured
    curves = {str(k): measured for k in range(CURVES)}
    times = {"batch": ([], []), "fits": ([], [])}
    with tempfile.TemporaryDirectory() as folder:
        paths = [Path(folder) / name for name in ("scene.toml", "fit.toml")]
        for path, text in zip(paths, (scene.to_toml(), FIT)):
            path.write_text(text)
        for _ in range(TURNS):
            done = subprocess.run([sys.argv[1], *map(str, paths), str(CASES), str(CURVES)],
                                  capture_output=True, text=True, check=True)
            theirs = [float(word) for word in done.stdout.split()]
            ours = [seconds_of(lambda: model.run_batch(values, threads=1)),
                    seconds_of(lambda: plastica.fit(curves, threads=1))]
            for k, (cpp, python) in enumerate(times.values()):
                cpp.append(theirs[k])
                python.append(ours[k])
    for (name, (cpp, python)), count in zip(times.items(), (CASES, CURVES)):
        a, b = statistics.median(cpp), statistics.median(python)
        print(f"{name}: {1e6 * a / count:.1f} us in C++, {1e6 * b / count:.1f} us from Python, "
              f"ratio {a / b:.3f}")


if __name__ == "__main__":
    main()
