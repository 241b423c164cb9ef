"""The rows of the comparison: data. A new row is a line or two in ROWS."""

import dataclasses
import math
import statistics

from comparison.ours import segments_in

# Steps of a segment that the limit takes for W1: 64 segments, 1 000 steps of 1 ms, off by 0.33 %.
LIMIT_STEPS = 64e3

# Seconds of performance tables measured elsewhere (W1, N = 64, error <= 0.5 %) over those of
# `limit_step` of order 2 at 1 ms there: engines that Debian does not package, carried over.
CARRIED = {"OpenSees 2-D": 0.27 / 1.3e-3, "dismech": 0.90 / 1.3e-3}


@dataclasses.dataclass(frozen=True)
class Ours:
    """A counter of a benchmark: program, regular expression of its name. Of several matches the
    least, among those whose counter `error` is at most `within`."""
    program: str
    name: str
    counter: str = "time"
    within: float = math.inf
    threads: int = 1

    def value(self, figures):
        runs = figures.ours.of(self.program, self.name, self.threads).values()
        found = [run[self.counter] for run in runs if run.get("error", 0.0) <= self.within]
        return min(found) if found else None


@dataclasses.dataclass(frozen=True)
class Slope:
    """Of log time over log N, by least squares over the matches."""
    program: str
    name: str
    counter: str  # per segment: the slope of the whole is 1 more

    def value(self, figures):
        runs = figures.ours.of(self.program, self.name)
        if len(runs) < 2:
            return None
        x = [math.log(segments_in(name)) for name in runs]
        y = [math.log(run[self.counter]) for run in runs.values()]
        return 1.0 + statistics.linear_regression(x, y).slope


class Shared:
    """A figure of the shared programs, as shared.Figures.of takes it, times `times`."""

    def __init__(self, *what, times=1.0):
        self.what, self.times = what, times

    def value(self, figures):
        value = figures.of(*self.what)
        return None if value is None else self.times * value


@dataclasses.dataclass(frozen=True)
class Row:
    group: str
    what: str
    figure: object
    against: str = ""
    other: object = None
    inverse: bool = False  # ratio = theirs / ours: times as fast
    want: str = ""
    unit: str = "s"
    brief: bool = False    # in docs/speed.md, too
    per: float = 1.0       # ours is divided by it: points, specimens

    def measure(self, figures):
        figure = self.figure.value(figures)
        figure = None if figure is None else figure / self.per
        other = self.other.value(figures) if self.other else None
        found = figure is not None and other is not None
        ratio = None if not found else other / figure if self.inverse else figure / other
        return {"group": self.group, "what": self.what, "figure": figure, "unit": self.unit,
                "against": self.against, "other": other, "ratio": ratio, "want": self.want,
                "brief": self.brief}


STEP, STATICS, W1, MANY, W2, W3, W4, COUPON, FITS, BENT, ORDER = GROUPS = [
    "A step of a chain in motion, per segment, N = 64",
    "A Newton iteration at rest, per segment, N = 64",
    "falling cantilever, one scenario, N = 64, within 0.5 %",
    "falling cantilever, a batch on one core, N = 64, within 0.5 %, per scenario",
    "static cantilever, N = 32, within 0.1 %",
    "cantilever bent and released, within 0.5 %",
    "a batch of falling cantilevers, N = 32 at 1 ms, per scenario",
    "A coupon's curve of 300 points",
    "Fits of 300-point curves",
    "Fits through a planar bend, 32 segments, 200 steps",
    "Order in N: slope of log time over log N",
]


def step(level, scheme, segments="64"):
    number = {"planar": 3, "spatial": 4}[level]
    name = f"step/level:{number}/scheme:{scheme}/segments:{segments}"
    return Ours("motion_benchmark", name, "per_segment_step")


def articulated(order, cases, segments="64", numbers=8):
    """The widest instruction set that the machine has."""
    name = f"step/order:{order}/isa:[0-9]/bytes:{numbers}/cases:{cases}/segments:{segments}"
    return Ours("lanes_benchmark", name, "per_segment_step")


def iteration(level):
    return Ours("chain_benchmark", f"{level}/64", "per_segment_iteration")


def iteration_in_lanes(level):
    """On the widest instruction set that the machine has."""
    return Ours("chain_benchmark", f"{level}_lanes/segments:64/isa:0", "per_segment_iteration")


def yielding(law, reach):
    return Ours("chain_benchmark", f"{law}/spatial_{reach}/64", "per_segment_iteration")


def paths(level, law, together):
    name = f"bent_batch/{level}_{law}/together:{int(together)}/.*"
    return Ours("path_benchmark", name, "per_scenario")


def w1(level):
    return Ours("workload_benchmark", f"w1/{level}/.*", within=0.005)


def w1_batch(level, scenes):
    """Of one model and many values, or of scenes of their own."""
    return Ours("workload_benchmark", f"w1_batch/{level}/.*/scenes:{int(scenes)}", "per_scenario",
                within=0.005)


def w2(level):
    return Ours("workload_benchmark", f"w2/{level}/segments:32/.*", within=0.001)


def w4(level, threads=0, scheme="articulated_midpoint", together=1):
    """CPU time of one thread, or wall time of so many."""
    wall = "/real_time" if threads else ""
    name = (f"w4/{level}/{scheme}/threads:{max(threads, 1)}/scenarios:[0-9]+/together:{together}"
            f"{wall}")
    return Ours("workload_benchmark", name, "per_scenario", threads=max(threads, 1))


def struck(level, scheme, together):
    return Ours("motion_benchmark", f"struck_batch/{level}_{scheme}/together:{int(together)}",
                "per_scenario")


def coupon(name):
    return Ours("coupon_benchmark", name)


def slopes(points, companions):
    """Of a point and its differences."""
    return Ours("scene_fit_benchmark", f"slopes/points:{points}/companions:{int(companions)}")


SCALAR, LANES, FLOATS = "scalar double", "AVX512 double x1", "AVX512 float x1"
EULER, MIDPOINT = 0, 1
FIT = Ours("fit_benchmark", "batch_of_fits/1", "per_fit")
FIT_BY_THREADS = [Ours("fit_benchmark", f"batch_of_fits/{n}/real_time", "per_fit", threads=n)
                  for n in (1, 2)]

ROWS = [
    Row(STEP, "planar, articulated Euler", articulated(1, 1), "limit_step, order 1",
        Shared("limit_step", 1, SCALAR), want="≤ 2", brief=True),
    Row(STEP, "planar, articulated midpoint", articulated(2, 1), "limit_step, order 2",
        Shared("limit_step", 2, SCALAR), want="≤ 2", brief=True),
    Row(STEP, "the same, 16 at once", articulated(2, 16), "limit_step, 8 lanes",
        Shared("limit_step", 2, LANES), want="≤ 2", brief=True),
    Row(STEP, "the same, 16 at once", articulated(2, 16), "alone", articulated(2, 1), True,
        want="≥ 5"),
    Row(STEP, "order 1, single precision, 16 at once", articulated(1, 16, numbers=4),
        "limit_step, 16 lanes", Shared("limit_step", 1, FLOATS), want="≤ 2"),
    Row(STEP, "planar, linearly implicit midpoint", step("planar", MIDPOINT),
        "limit_step, order 2", Shared("limit_step", 2, SCALAR), want="≤ 5"),
    Row(STEP, "spatial, linearly implicit midpoint", step("spatial", MIDPOINT), want="≤ 500 ns"),

    Row(STATICS, "planar", iteration("planar"),
        "limit, 3×3", Shared("limit", "unbatched double", 3), want="≤ 3", brief=True),
    Row(STATICS, "spatial", iteration("spatial"),
        "limit, 6×6", Shared("limit", "unbatched double", 6), want="≤ 4", brief=True),
    Row(STATICS, "planar, 8 lanes", iteration_in_lanes("planar"),
        "limit, 3×3, 8 lanes", Shared("limit", "batched double x1", 3), want="≤ 2.5"),
    Row(STATICS, "spatial, 8 lanes", iteration_in_lanes("spatial"),
        "limit, 6×6, 8 lanes", Shared("limit", "batched double x1", 6), want="≤ 4"),
    *(Row(STATICS, f"a batch of paths, {level}, {law}, a scenario", paths(level, law, True),
          "one by one", paths(level, law, False), True, want="≥ 4")
      for level in ("planar", "spatial") for law in ("elastic", "yielding")),
    *(Row(STATICS, f"spatial, one yield surface, {joints}", yielding("interaction", reach),
          "per axis", yielding("per_axis", reach), want="≤ 2")
      for joints, reach in (("no joint yields", "unyielded"),
                            ("all return from far beyond", "yielded"))),

    Row(W1, "planar", w1("planar"), "MuJoCo hinges",
        Shared("w1", "mujoco", "hinge_euler", 0.005), True, brief=True),
    Row(W1, "planar", w1("planar"), "Bullet revolute", Shared("w1", "bullet", "rev", 0.005), True),
    Row(W1, "planar", w1("planar"), "DART revolute", Shared("w1", "dart", "rev", 0.005), True),
    Row(W1, "planar", w1("planar"), "Simbody pins", Shared("w1", "simbody", "pin_see", 0.005), True),
    Row(W1, "planar", w1("planar"), "OpenSees 2-D, carried over",
        Shared("limit_step", 2, SCALAR, times=LIMIT_STEPS * CARRIED["OpenSees 2-D"]), True,
        want="≥ 100", brief=True),
    Row(W1, "spatial", w1("spatial"), "Bullet spherical",
        Shared("w1", "bullet", "sph", 0.005), True, brief=True),
    Row(W1, "spatial", w1("spatial"), "DART balls", Shared("w1", "dart", "ball", 0.005), True),
    Row(W1, "spatial", w1("spatial"), "dismech, carried over",
        Shared("limit_step", 2, SCALAR, times=LIMIT_STEPS * CARRIED["dismech"]), True, want="≥ 40",
        brief=True),

    *(Row(MANY, f"{level}, {what}", w1_batch(level, scenes), f"{peer}, carried over",
          Shared("limit_step", 2, SCALAR, times=LIMIT_STEPS * CARRIED[peer]), True,
          want=f"≥ {goal}",
          brief=not scenes)
      for level, peer, goal in (("planar", "OpenSees 2-D", 800), ("spatial", "dismech", 200))
      for what, scenes in (("one model", False), ("scenes of their own", True))),

    Row(W2, "planar", w2("planar"), "MuJoCo hinges", Shared("w2", "mujoco", "hinge_euler"), True,
        want="≥ 5", brief=True),
    Row(W2, "planar", w2("planar"), "DART revolute", Shared("w2", "dart", "rev"), True),
    Row(W2, "spatial", w2("spatial"), "DART balls", Shared("w2", "dart", "ball"), True,
        want="≥ 4", brief=True),
    Row(W3, "planar, fibres, graded segments", Ours("workload_benchmark", "w3/.*", within=0.005),
        want="≤ 0.2 ms", brief=True),

    Row(W4, "planar", w4("planar"), "limit_step, order 2, 8 lanes",
        Shared("limit_step", 2, LANES, times=32e3), brief=True),
    Row(W4, "planar", w4("planar"), "one by one", w4("planar", together=0), True, want="≥ 5",
        brief=True),
    Row(W4, "spatial", w4("spatial"), "one by one", w4("spatial", together=0), True, want="≥ 5",
        brief=True),
    *(Row(W4, f"{level}, linearly implicit midpoint", w4(level, scheme="linearly_implicit_midpoint"),
          "one by one", w4(level, scheme="linearly_implicit_midpoint", together=0), True,
          want="≥ 4", brief=level == "planar")
      for level in ("planar", "spatial")),
    *(Row(W4, f"{level}, struck, yielding, {scheme}", struck(level, short, True), "one by one",
          struck(level, short, False), True, want="≥ 4")
      for level in ("planar", "spatial")
      for scheme, short in (("linearly implicit midpoint", "implicit"),
                            ("generalized-alpha", "alpha"))),
    Row(W4, "planar, two threads", w4("planar", 2), "one", w4("planar", 1), True, want="≥ 1.95"),
    Row(W4, "spatial, two threads", w4("spatial", 2), "one", w4("spatial", 1), True,
        want="≥ 1.95"),
    Row(COUPON, "ideal plastic, a point", coupon("evaluate/ideal"), per=300),
    Row(COUPON, "linear hardening, a point", coupon("evaluate/linear"), per=300),
    Row(COUPON, "Voce and Chaboche, a point", coupon("evaluate/voce"), per=300, want="≤ 100 ns"),
    Row(COUPON, "ideal, with 2 derivatives", coupon("differentiate/ideal_two"), "without",
        coupon("evaluate/ideal"), want="≤ 2"),
    Row(COUPON, "linear, with 3 derivatives", coupon("differentiate/linear_three"), "without",
        coupon("evaluate/linear"), want="≤ 2", brief=True),
    Row(COUPON, "Voce, with 3 derivatives", coupon("differentiate/voce_three"), "without",
        coupon("evaluate/voce"), want="≤ 2"),

    Row(FITS, "E, σ_y, ε_break free, a fit", FIT, want="≤ 35 us", brief=True),
    Row(FITS, "the same, two threads", FIT_BY_THREADS[1], "one", FIT_BY_THREADS[0], True,
        want="≥ 1.95"),
    Row(FITS, "cost evaluations a fit", Ours("fit_benchmark", "batch_of_fits/1", "evaluations/fit"),
        unit=""),

    Row(BENT, "E, σ_y, ε_break free, a fit", Ours("scene_fit_benchmark", "scene_fit/lanes:1"),
        want="≤ 20 ms", brief=True),
    *(Row(BENT, f"a point and its slopes by {n} parameters", slopes(n + 1, True), "the point",
          slopes(1, False)) for n in (2, 7, 20)),
    *(Row(BENT, f"the same by {n}, runs of their own", slopes(n + 1, False), "the point",
          slopes(1, False)) for n in (2, 7, 20)),

    Row(ORDER, "planar step, N = 64 … 4 096",
        Slope("motion_benchmark", "step/level:3/scheme:1/segments:(64|256|1024|4096)",
              "per_segment_step"), unit="", want="≤ 1.05"),
    Row(ORDER, "planar articulated step, N = 256 … 65 536",
        Slope("lanes_benchmark",
              "step/order:2/isa:0/bytes:8/cases:1/segments:(256|1024|4096|16384|65536)",
              "per_segment_step"), unit=""),
    Row(ORDER, "planar iteration at rest, N = 64 … 4 096",
        Slope("chain_benchmark", "planar/(64|256|1024|4096)", "per_segment_iteration"),
        unit="", want="≤ 1.05"),
    Row(ORDER, "spatial iteration at rest, N = 64 … 4 096",
        Slope("chain_benchmark", "spatial/(64|256|1024|4096)", "per_segment_iteration"),
        unit="", want="≤ 1.05"),
]
