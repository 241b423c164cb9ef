"""The limit programs and engines of --shared: builds them outside of the project and runs them."""

import bisect
import json
import math
import os
import re
import shutil
import statistics
import struct
import subprocess
import sys

FAST = ["g++", "-O3", "-march=native", "-w"]
WIDE = FAST + ["-mprefer-vector-width=512", "-ffp-contract=fast"]
BULLET = ["-DBT_USE_DOUBLE_PRECISION", "-I/usr/include/bullet"]
BULLET_LIBRARIES = ["-lBulletDynamics-float64", "-lBulletCollision-float64", "-lLinearMath-float64"]
PORTABLE = ["g++", "-O3", "-w", "-DNDEBUG"]

# Program: folder, source, compiler, libraries, Debian packages.
PROGRAMS = {
    "limit": ("limit", "limit.cc", WIDE, [], []),
    "limit_step": ("limit", "limit_step.cc", WIDE, [], []),
    "mujoco": ("peers", "mj.cc", FAST, ["-lmujoco"], ["libmujoco-dev"]),
    "bullet": ("peers", "bullet.cc", FAST + BULLET, BULLET_LIBRARIES, ["libbullet-dev"]),
    "dart": ("peers", "dart.cc", PORTABLE + ["-I/usr/include/eigen3"],
             ["-ldart", "-lassimp", "-lfcl", "-lccd"],
             ["libdart-dev", "libdart-external-ikfast-dev", "libdart-external-odelcpsolver-dev"]),
    "simbody": ("peers", "simb.cc", PORTABLE + ["-I/usr/include/simbody"],
                ["-lSimTKsimbody", "-lSimTKmath", "-lSimTKcommon"], ["libsimbody-dev"]),
    "ode": ("peers", "ode.cc", FAST, ["-lode"], ["libode-dev"]),
}

# Engine and joint: the settings (time step, damping) of which the cheapest within the error counts.
W1 = {
    ("mujoco", "hinge_euler"): [(1e-4, -0.5), (5e-5, -0.5), (1e-5, 0)],
    ("bullet", "rev"): [(1e-5, 0)],
    ("dart", "rev"): [(5e-5, 0), (2.5e-5, 0)],
    ("simbody", "pin_see"): [(1e-5, 0)],
    ("bullet", "sph"): [(1e-5, 0)],
    ("dart", "ball"): [(5e-5, 0), (2.5e-5, 0)],
}
W2 = {
    ("mujoco", "hinge_euler"): [(dt, d) for dt in (0.015, 0.02, 0.025, 0.03)
                                for d in (-1, -2, -3, -4, -5, -7)],
    ("dart", "rev"): [(dt, d) for dt in (0.02, 0.03, 0.05) for d in (0, -0.5, -1, -2, -5)],
    ("dart", "ball"): [(dt, d) for dt in (0.02, 0.03, 0.05) for d in (0, -0.5, -1, -2, -5)],
    ("simbody", "pin_emin"): [(1e-3, 1e-3), (1e-3, 1e-4)],
}
SAG = 0.022063903  # static, W1 [m]


def numbers_of(path):
    data = path.read_bytes()
    values = struct.unpack(f"<{len(data) // 8}d", data)
    return values[0::2], values[1::2]


class Figures:
    """Seconds by name, measured when first asked for; None where it cannot be measured here."""

    def __init__(self, folder, work, repetitions, core):
        self.folder, self.work, self.repetitions, self.core = folder, work, repetitions, core
        self.figures, self.built, self.missing = {}, {}, []
        self.ours = None
        if not folder.is_dir():
            self._miss(f"{folder} is absent: without limit programs and engines")

    def add(self, ours):
        self.ours = ours
        ours.missing = self.missing

    def of(self, kind, *what):
        key = " ".join([kind, *map(str, what)])
        if key not in self.figures:
            self.figures[key] = getattr(self, f"_{kind}")(*what) if self.folder.is_dir() else None
        return self.figures[key]

    def kept(self):
        """All that was measured, for --json."""
        return {"shared": self.figures,
                "ours": {" ".join(map(str, key)): runs for key, runs in self.ours.runs.items()}}

    def _limit(self, kernel, block):
        """ns per segment of the elimination, `limit`'s line `kernel B=block`."""
        lines = self._lines("limit", "64")
        wanted = re.compile(rf"{re.escape(kernel)}\s+B={block} .*?([\d.]+) ns/segment \(")
        return self._median_of(wanted, lines)

    def _limit_step(self, order, lanes):
        """ns per segment and step of the whole step, `limit_step`'s line `lanes`."""
        lines = self._lines("limit_step", "64", "1e-3", str(order))
        return self._median_of(re.compile(rf"{re.escape(lanes)}\s+order.*?([\d.]+) ns/segment-step"),
                               lines)

    def _median_of(self, wanted, texts):
        found = [float(wanted.search(text).group(1)) for text in texts or []]
        return 1e-9 * statistics.median(found) if found else None

    def _w1(self, engine, joint, within):
        """CPU seconds of a second of W1, N = 64, at the cheapest setting within the error."""
        return self._cheapest(engine, joint, W1[engine, joint], 1.0, within,
                              lambda run: (run["cpu"], run["error"]), 64)

    def _w2(self, engine, joint):
        """CPU seconds until W2's tip stays within 0.1 %, N = 32."""
        def settled(run):
            return (run["t01pct"] if run["t01pct"] > 0 else run["cpu"],
                    0.0 if run["t01pct"] > 0 or run["steps"] == 1 else 1.0)
        return self._cheapest(engine, joint, W2[engine, joint], 3.0, 0.5, settled, 32)

    def _cheapest(self, engine, joint, settings, seconds, within, judged, segments):
        best = None
        for step, damping in settings:
            run = self._engine(engine, segments, step, seconds, joint, damping)
            if run is None:
                return None
            cost, error = judged(run)
            if run["stable"] and error <= within and (best is None or cost < best[0]):
                best = (cost, step, damping)
        if best is None:
            self._miss(f"{engine} {joint}: no setting within {within:g}")
            return None
        again = [judged(self._engine(engine, segments, best[1], seconds, joint, best[2]))[0]
                 for _ in range(self.repetitions - 1)]
        return statistics.median([best[0], *again])

    def _engine(self, engine, segments, step, seconds, joint, damping):
        out = self.work / "history.bin"
        text = self._output(engine, str(segments), str(step), str(seconds), joint, str(out),
                            str(damping), load="2" if segments == 32 else "0")
        if text is None:
            return None
        run = json.loads(text.strip().split("\n")[-1])
        run["error"] = self._history_error(out) if segments == 64 else 0.0
        return run

    def _history_error(self, path):
        """Rms of the tip off the reference, which is linear between its times, over the sag."""
        times, tips = numbers_of(self.folder / "peers/w1_ref.bin")
        squares = []
        for time, tip in zip(*numbers_of(path)):
            if time <= times[-1]:
                i = min(max(bisect.bisect_right(times, time), 1), len(times) - 1)
                part = (time - times[i - 1]) / (times[i] - times[i - 1])
                squares.append((tips[i - 1] + part * (tips[i] - tips[i - 1]) - tip) ** 2)
        return math.sqrt(statistics.fmean(squares)) / SAG

    def _lines(self, program, *arguments):
        """The whole output of each repetition."""
        key = " ".join(["output", program, *arguments])
        if key not in self.built:
            texts = [self._output(program, *arguments) for _ in range(self.repetitions)]
            self.built[key] = None if None in texts else texts
        return self.built[key]

    def _output(self, program, *arguments, load="0"):
        path = self._build(program)
        if path is None:
            return None
        done = subprocess.run(["taskset", "-c", str(self.core), path, *arguments], cwd=self.work,
                              env={**os.environ, "ALPHA": load}, capture_output=True, text=True)
        if done.returncode != 0 or not done.stdout:
            self._miss(f"{program} {' '.join(arguments)}: exit code {done.returncode}")
            return None
        return done.stdout

    def _build(self, program):
        if program not in self.built:
            self.built[program] = self._compiled(program)
        return self.built[program]

    def _compiled(self, program):
        folder, source, compiler, libraries, packages = PROGRAMS[program]
        absent = [name for name in packages if not self._installed(name)]
        if absent:
            self._miss(f"{program}: needs {' '.join(absent)}")
            return None
        out = self.work / program
        if out.exists():
            return out
        print(f"building {program}", file=sys.stderr)
        done = subprocess.run([*compiler, self.folder / folder / source, "-o", out, *libraries],
                              capture_output=True, text=True)
        if done.returncode != 0:
            self._miss(f"{program} does not build: {done.stderr.strip()[-300:]}")
            return None
        return out

    @staticmethod
    def _installed(package):
        if shutil.which("dpkg-query") is None:
            return True  # the compiler will tell
        done = subprocess.run(["dpkg-query", "-W", "-f", "${Status}", package],
                              capture_output=True, text=True)
        return done.stdout == "install ok installed"

    def _miss(self, line):
        if line not in self.missing:
            self.missing.append(line)
            print(f"left out: {line}", file=sys.stderr)
