"""Ctrl-C and progress: long work is stopped soon, and says how far it is."""

import os
import signal
import subprocess
import sys
import threading
import time
import unittest

import numpy as np

import plastica
from support import DATA, TestCase, cantilever

LONG = {
    "run_batch": """
model = plastica.prepare(cantilever(beam=plastica.Beam(length=1.0, segments=2000)),
                         ["material.youngs_modulus"])
model.run_batch(np.full((200_000, 1), 2e11))
""",
    "simulate": """
scene = plastica.Scene.from_toml(DATA / "scenes" / "falling_cantilever.toml")
scene.solver.time_step = 1e-7
plastica.simulate(scene)
""",
    "fit": """
from support import hardening_curve
plastica.fit({str(k): hardening_curve(1e6, k) for k in range(300)}, bootstrap=4000)
""",
    "sweep": """
plastica.sweep(cantilever(), {"beam.segments": list(range(2, 4000))}, probe="tip")
""",
}
HEAD = """
import sys, warnings
sys.path.insert(0, {folder!r})
import numpy as np
import plastica
from support import DATA, cantilever
warnings.simplefilter("ignore")
print("begun", flush=True)
try:
{work}
    print("ended", flush=True)
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


class Interrupts(TestCase):
    def test_ctrl_c_ends_long_work_soon(self):
        folder = os.path.dirname(os.path.abspath(__file__))
        for name, work in LONG.items():
            with self.subTest(name):
                text = HEAD.format(folder=folder, work="".join(
                    f"    {line}\n" for line in work.strip().splitlines()))
                run = subprocess.Popen([sys.executable, "-B", "-c", text], stdout=subprocess.PIPE,
                                       text=True)
                self.assertEqual(run.stdout.readline(), "begun\n")
                time.sleep(1.0)
                run.send_signal(signal.SIGINT)
                said, _ = run.communicate(timeout=60)
                self.assertEqual(said, "interrupted\n")

    def test_progress_rises_to_the_end(self):
        told = []
        model = plastica.prepare(cantilever(), ["material.youngs_modulus"])
        model.run_batch(np.full((20_000, 1), 2e11), progress=lambda done, of: told.append((done, of)))
        self.assertEqual(told[-1], (20_000, 20_000))
        self.assertEqual([done for done, _ in told], sorted(done for done, _ in told))

    def test_what_progress_raises_stops_the_work(self):
        class Enough(Exception):
            pass

        def tell(done, of):
            raise Enough
        scene = plastica.Scene.from_toml(DATA / "scenes" / "falling_cantilever.toml")
        scene.solver.time_step = 1e-7
        with self.assertRaises(Enough):
            plastica.simulate(scene, progress=tell)

    def test_other_threads_run_meanwhile(self):
        scene = plastica.Scene.from_toml(DATA / "scenes" / "falling_cantilever.toml")
        scene.solver.time_step = 2e-6
        counted = [0]
        ended = threading.Event()

        def count():
            while not ended.is_set():
                counted[0] += 1
                time.sleep(0.001)
        other = threading.Thread(target=count)
        other.start()
        plastica.simulate(scene)
        ended.set()
        other.join()
        self.assertGreater(counted[0], 20)  # it takes half a second; with the lock held it is one


if __name__ == "__main__":
    unittest.main()
