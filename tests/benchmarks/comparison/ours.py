"""What our Google Benchmark programs measure."""

import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

SECONDS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}


class Figures:
    """Runs each program once for each filter that a row asks for, and keeps what came out."""

    def __init__(self, build, repetitions, core):
        self.folder = build / "tests/benchmarks"
        self.repetitions, self.core = repetitions, core
        self.runs = {}
        self.missing = []

    def of(self, program, pattern, threads=1):
        """Benchmarks of a program whose names match: {name: {counter: median}}. Times in seconds:
        `time` is CPU time, with several threads wall time."""
        key = (program, pattern, threads)
        if key not in self.runs:
            self.runs[key] = self._run(program, pattern, threads)
        return self.runs[key]

    def _run(self, program, pattern, threads):
        path = self.folder / program
        if not path.exists():
            self._miss(f"{program} is not built")
            return {}
        print(f"running {program} {pattern}", file=sys.stderr)
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "out.json"
            cores = ",".join(str((self.core + i) % os.cpu_count()) for i in range(threads))
            done = subprocess.run(
                ["taskset", "-c", cores, path, f"--benchmark_filter=^{pattern}$",
                 f"--benchmark_repetitions={self.repetitions}", "--benchmark_min_time=0.05",
                 f"--benchmark_out={out}", "--benchmark_out_format=json"],
                capture_output=True, text=True)
            text = out.read_text() if out.exists() else ""
        if done.returncode != 0 or not text:
            self._miss(f"{program} {pattern}: {done.stderr.strip()[-200:] or 'nothing measured'}")
            return {}
        gathered = {}
        for run in json.loads(text)["benchmarks"]:
            if run.get("error_occurred"):
                self._miss(f"{program} {pattern}: {run['error_message']}")
            elif run["run_type"] == "iteration":
                gathered.setdefault(run["run_name"], []).append(self._counters(run, threads))
        return {name: {counter: statistics.median(one[counter] for one in all_of)
                       for counter in all_of[0]}
                for name, all_of in gathered.items()}

    @staticmethod
    def _counters(run, threads):
        numbers = {key: value for key, value in run.items() if isinstance(value, (int, float))}
        which = "cpu_time" if threads == 1 else "real_time"
        numbers["time"] = run[which] * SECONDS[run["time_unit"]]
        return numbers

    def _miss(self, line):
        if line not in self.missing:
            self.missing.append(line)
            print(f"left out: {line}", file=sys.stderr)


def segments_in(name):
    """The number of segments in a benchmark's name: `segments:64`, or the last number."""
    found = re.search(r"segments:(\d+)", name) or re.search(r"/(\d+)$", name)
    return int(found.group(1))
