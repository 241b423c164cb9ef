"""Runs commands in several processes under mpirun: results are those of one process, bit by bit, and
nothing is lost when processes are killed.

usage: mpi_test.py PLASTICA MPIRUN
"""

import math
import os
import random
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PLASTICA, MPIRUN = sys.argv[1:3]

# As root and with more processes than processors, where these tests may run.
ENVIRONMENT = dict(
    os.environ,
    OMPI_ALLOW_RUN_AS_ROOT="1",
    OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
    OMPI_MCA_rmaps_base_oversubscribe="1",
    OMPI_MCA_btl_vader_single_copy_mechanism="none",
)


def curve(yield_stress, seed, step=0.01):
    """A tension test of a steel that yields at once and breaks at 2 % of plastic strain, rough by
    1 MPa; of 2 000 MPa per % of strain."""
    lines = ["Strain (%),Stress (MPa)"]
    draw = random.Random(seed)
    breaks_at = 2 + yield_stress / 2000
    for i in range(int(breaks_at / step) + 3):
        strain = step * i
        stress = min(2000 * strain, yield_stress) + draw.uniform(-1, 1) if strain < breaks_at else 0
        lines.append(f"{strain:.4f},{stress:.2f}")
    return "\n".join(lines) + "\n"


FIT = """[fit]
algorithm = "crs"
stop = { global_evaluations = 2000, parameter_tolerance = 0, cost_tolerance = 0 }

[[target]]
files = "curve-*.csv"
strain = { column = "Strain", unit = "%" }
stress = { column = "Stress", unit = "MPa" }
"""

BAR = """[beam]
length = "400 mm"
segments = 6
section = { shape = "rectangle", width = "20 mm", height = "20 mm" }
[material]
name = "S355"
hardening = { law = "linear", tangent_modulus = "10 GPa" }
[[support]]
at = "start"
kind = "clamp"
[[support]]
at = "end"
kind = "roller"
hold = ["y"]
translation = ["0 mm", "-60 mm", "0 mm"]
[[probe]]
name = "force"
kind = "reaction"
at = "end"
component = "y"
"""

BARS = """fit.shared = false
fit.starts = 1
fit.evaluations = 30
fit.laws = ["ideal", "linear"]
fit.parameters.yield_stress = { bounds = ["20 MPa", "20 GPa"] }
[[target]]
files = "bar-*.csv"
scene = "bar.toml"
abscissa = { drive = "support[2]", column = "Displacement" }
ordinate = { probe = "force", column = "Force", factor = -1 }
"""


class Team(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w") as file:
            file.write(text)

    def write_fits(self, count, step=0.01):
        for i in range(count):
            self.write(f"curve-{i}.csv", curve(250 + i, i, step))
        self.write("fit.toml", FIT)

    def journals(self):
        return sorted(name for name in os.listdir(self.folder) if ".journal" in name)

    def run_alone(self, *words):
        return subprocess.run(
            [PLASTICA, *words], cwd=self.folder, capture_output=True, text=True, timeout=120
        )

    def start(self, size, *words):
        return subprocess.Popen(
            [MPIRUN, "-np", str(size), PLASTICA, *words],
            cwd=self.folder,
            env=ENVIRONMENT,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def run_team(self, size, *words):
        with self.start(size, *words) as process:
            out, err = process.communicate(timeout=240)
        return subprocess.CompletedProcess(process.args, process.returncode, out, err)

    def own_lines(self, text):
        """Without what mpirun says where a process ends with another code than 0."""
        return [line for line in text.splitlines() if line.startswith("plastica: ")]

    def expect_same(self, one, other):
        compare = os.path.join(os.path.dirname(__file__), "compare_results.py")
        compared = subprocess.run(
            [sys.executable, "-B", compare, self.path(one), self.path(other)],
            capture_output=True,
            text=True,
        )
        self.assertEqual(compared.returncode, 0, compared.stdout + compared.stderr)

    def test_fits_of_curves_are_those_of_one_process(self):
        self.write_fits(9)
        self.write("curve-4.csv", "")
        alone = self.run_alone("calibrate", "fit.toml", "-o", "one.h5")
        self.assertEqual(alone.returncode, 1)
        for size in (1, 2, 4, 8):
            output = f"team-{size}.h5"
            team = self.run_team(size, "calibrate", "fit.toml", "-o", output)
            self.assertEqual(team.returncode, 1, team.stderr)
            # For a lone process mpirun makes a terminal, which gets colours.
            self.assertEqual(re.sub("\x1b\\[[0-9]*m", "", team.stdout), alone.stdout)
            self.expect_same("one.h5", output)
            self.assertEqual(self.journals(), [])

    def test_a_sweep_is_that_of_one_process(self):
        self.assertEqual(self.run_alone("init", "sweep").returncode, 0)
        self.assertEqual(self.run_alone("sweep", "sweep.toml", "-o", "one.h5").returncode, 0)
        for size in (2, 4):
            output = f"team-{size}.h5"
            team = self.run_team(size, "sweep", "sweep.toml", "-o", output)
            self.assertEqual(team.returncode, 0, team.stderr)
            self.expect_same("one.h5", output)
        self.assertEqual(self.journals(), [])

    def points(self, name):
        """The points of a scan, without what each took."""
        with open(self.path(name)) as file:
            return [line.rsplit(",", 1)[0] for line in file]

    def test_a_scan_is_that_of_one_process(self):
        """Which points a map has depends on where the scan of each field ended."""
        self.assertEqual(self.run_alone("init", "sweep").returncode, 0)
        words = ("stability", "cantilever.toml", "--vary", "beam.segments,scale.loads",
                 "--reach", "100", "--max-work", "4", "--map")
        alone = self.run_alone(*words, "one.gp", "-o", "one.csv")
        self.assertEqual(alone.returncode, 0, alone.stderr)
        for size in (2, 5):
            team = self.run_team(size, *words, f"{size}.gp", "-o", f"{size}.csv")
            self.assertEqual(team.returncode, 0, team.stderr)
            self.assertEqual(team.stdout, alone.stdout)
            self.assertEqual(self.points(f"{size}.csv"), self.points("one.csv"))
            with open(self.path("one.gp")) as one, open(self.path(f"{size}.gp")) as other:
                self.assertEqual(one.read(), other.read())
        self.assertEqual(self.journals(), [])

        lone = self.run_team(2, *words, "-")
        self.assertEqual(lone.returncode, 2, lone.stderr)
        self.assertEqual(self.own_lines(lone.stderr), [
            "plastica: --output: is where processes keep what they have finished: give -o FILE"
        ])

    def test_a_scan_whose_process_was_killed_goes_on(self):
        self.assertEqual(self.run_alone("init", "sweep").returncode, 0)
        words = ("stability", "cantilever.toml", "--vary", "beam.segments,scale.loads",
                 "--threads", "1", "--max-work", "8")
        team = self.start(3, *words, "-o", "out.csv")
        victim = self.process_of(team, 1, "out.csv")
        self.assertIsNotNone(victim, team.poll())
        os.kill(victim, signal.SIGKILL)
        out, err = team.communicate(timeout=120)
        kept = [line for line in self.own_lines(err) if "what is finished is kept" in line]
        self.assertEqual(len(kept), 1, err)
        self.assertFalse(os.path.exists(self.path("out.csv")))
        last = self.run_alone(*words, "-o", "out.csv", "--resume")
        self.assertEqual(last.returncode, 0, last.stderr)
        self.assertEqual(self.run_alone(*words, "-o", "one.csv").returncode, 0)
        self.assertEqual(self.points("out.csv"), self.points("one.csv"))
        self.assertEqual(self.journals(), [])

    def test_killed_processes_lose_nothing(self):
        self.write_fits(300, 0.005)
        words = ("calibrate", "fit.toml", "-o", "out.h5", "--threads", "1")
        alone = self.run_alone("calibrate", "fit.toml", "-o", "one.h5", "--quiet")
        self.assertEqual(alone.returncode, 0, alone.stderr)
        draw = random.Random(7)
        killed = 0
        for size in (3, 2, 4):
            team = self.start(size, *words, "--resume")
            victim = self.process_of(team, draw.randrange(size))
            if victim is not None:
                time.sleep(draw.uniform(0.02, 0.2))
                try:
                    os.kill(victim, signal.SIGKILL)
                    killed += 1
                except ProcessLookupError:
                    pass
            out, err = team.communicate(timeout=120)
            if os.path.exists(self.path("out.h5")):
                break
            kept = [line for line in self.own_lines(err) if "what is finished is kept" in line]
            self.assertEqual(len(kept), 1, err)
            self.assertFalse(os.path.exists(self.path("out.h5")))
        self.assertGreater(killed, 0)
        if not os.path.exists(self.path("out.h5")):
            last = self.run_alone(*words, "--resume")
            self.assertEqual(last.returncode, 0, last.stderr)
            self.assertRegex(last.stderr, r"\d+ fits resumed from the journal")
        self.assertEqual(self.journals(), [])
        self.expect_same("one.h5", "out.h5")

    def process_of(self, team, rank, output="out.h5"):
        """The process of a rank, once each has a journal, so that the run is under way."""
        begun = time.time()
        end = time.monotonic() + 60
        while time.monotonic() < end and team.poll() is None:
            for process in self.children(team.pid):
                environment = self.environment_of(process)
                if f"OMPI_COMM_WORLD_RANK={rank}" not in environment:
                    continue
                name = self.path(output + ".journal" + (f".{rank}" if rank else ""))
                # Not that of an earlier run.
                if os.path.exists(name) and os.path.getmtime(name) > begun:
                    return process
            time.sleep(0.01)
        return None

    @staticmethod
    def children(parent):
        found = []
        for name in os.listdir("/proc"):
            if not name.isdigit():
                continue
            try:
                with open(f"/proc/{name}/stat") as file:
                    if file.read().rsplit(")", 1)[1].split()[1] == str(parent):
                        found.append(int(name))
            except OSError:
                continue
        return found

    @staticmethod
    def environment_of(process):
        try:
            with open(f"/proc/{process}/environ") as file:
                return file.read().split("\0")
        except OSError:
            return []

    def test_bad_input_gets_one_line(self):
        self.write_fits(2)
        self.write("fit.toml", FIT.replace("algorithm", "algoritm"))
        alone = self.run_alone("calibrate", "fit.toml", "-o", "out.h5")
        team = self.run_team(3, "calibrate", "fit.toml", "-o", "out.h5")
        self.assertEqual(alone.returncode, 2)
        self.assertEqual(team.returncode, 2, team.stderr)
        self.assertEqual(self.own_lines(team.stderr), alone.stderr.splitlines())

        self.write("fit.toml", FIT)
        self.write("out.h5", "mine")
        team = self.run_team(3, "calibrate", "fit.toml", "-o", "out.h5")
        self.assertEqual(team.returncode, 2, team.stderr)
        self.assertEqual(len(self.own_lines(team.stderr)), 1, team.stderr)
        self.assertIn("exists already", team.stderr)
        self.assertEqual(self.journals(), [])

    def test_a_complete_output_is_found(self):
        self.write_fits(3)
        words = ("calibrate", "fit.toml", "-o", "out.h5", "--resume")
        self.assertEqual(self.run_team(2, *words).returncode, 0)
        again = self.run_team(2, *words)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual(again.stderr.count("is complete: nothing is left to do"), 1)

    def test_a_signal_ends_the_run_after_the_fits_under_way(self):
        self.write_fits(120, 0.005)
        words = ("calibrate", "fit.toml", "-o", "out.h5", "--threads", "1")
        team = self.start(2, *words)
        process = self.process_of(team, 1)
        self.assertIsNotNone(process, team.poll())
        os.kill(process, signal.SIGTERM)  # of one: the others hear of it
        out, err = team.communicate(timeout=60)
        self.assertEqual(team.returncode, 130, err)
        self.assertEqual(self.own_lines(err), [
            "plastica: interrupted; what is finished is kept: --resume goes on"
        ])
        last = self.run_team(3, *words, "--resume", "--quiet")
        self.assertEqual(last.returncode, 0, last.stderr)
        self.assertEqual(self.run_alone("calibrate", "fit.toml", "-o", "one.h5").returncode, 0)
        self.expect_same("one.h5", "out.h5")

    def test_dry_run_speaks_once(self):
        self.write_fits(2)
        alone = self.run_alone("calibrate", "fit.toml", "--dry-run")
        team = self.run_team(3, "calibrate", "fit.toml", "--dry-run")
        self.assertEqual(team.returncode, 0, team.stderr)
        self.assertEqual(team.stdout, alone.stdout)

    def test_fits_through_scenes_with_laws_are_those_of_one_process(self):
        """Which law is advised depends on all fits; that one alone gets other numbers of segments."""
        self.write("bar.toml", BAR)
        for k in range(5):
            lines = ["Displacement (mm),Force (N)"]
            for displacement in range(3, 61, 3):
                force = (2300 + 40 * k) * math.tanh(displacement / 18) + displacement
                lines.append(f"{displacement},{force:.9g}")
            self.write(f"bar-{k}.csv", "\n".join(lines) + "\n")
        self.write("fit.toml", BARS)
        alone = self.run_alone("calibrate", "fit.toml", "-o", "one.h5")
        self.assertIn(alone.returncode, (0, 1), alone.stderr)
        team = self.run_team(3, "calibrate", "fit.toml", "-o", "team.h5")
        self.assertEqual(team.returncode, alone.returncode, team.stderr)
        self.expect_same("one.h5", "team.h5")
        self.assertEqual(self.journals(), [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
