"""What the tests of the Python package share."""

import os
import subprocess
import sys
import tempfile
import unittest
import warnings
from pathlib import Path

import numpy as np

import plastica

ROOT = Path(__file__).resolve().parents[2]
DATA = ROOT / "data"
COMMAND = os.environ["PLASTICA_COMMAND"]


def command(*arguments, code=0, folder=None):
    """Runs the command. @return what it prints"""
    done = subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True,
                          cwd=folder)
    assert done.returncode == code, done.stderr
    return done.stdout


def cantilever(**changed):
    """An elastic one with a force at its tip."""
    parts = {
        "material": plastica.Material(name="S355"),
        "section": plastica.Section(shape="rectangle", width=0.02, height=0.02),
        "beam": plastica.Beam(length=1.0, segments=20),
        "rules": plastica.Rules(yield_model="elastic"),
        "supports": [plastica.Support(kind="clamp", at="start")],
        "loads": [plastica.Load(at="end", force=[0.0, -300.0, 0.0])],
        "probes": [plastica.Probe(name="tip", kind="displacement", component="y")],
    }
    return plastica.Scene(**{**parts, **changed})


def hardening_curve(noise=0.0, seed=1):
    """A coupon of linear hardening. @return strain, stress"""
    scene = plastica.Scene(
        material=plastica.Material(youngs_modulus=200e9, yield_stress=300e6, hardening={
            "law": "linear", "tangent_modulus": 2e9}),
        drive=plastica.Drive(strain=np.linspace(0.0, 0.04, 301)))
    stress = plastica.simulate(scene).probes["stress"].copy()
    stress[1:] += noise * np.random.default_rng(seed).standard_normal(300)
    return np.linspace(0.0, 0.04, 301), stress


class TestCase(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = Path(place.name)
        quiet = warnings.catch_warnings()
        quiet.__enter__()
        self.addCleanup(quiet.__exit__, None, None, None)
        warnings.simplefilter("ignore", plastica.SceneWarning)

    def assertSameBits(self, one, other):
        one, other = np.asarray(one), np.asarray(other)
        self.assertEqual(one.shape, other.shape)
        self.assertEqual(one.dtype, other.dtype)
        self.assertEqual(one.tobytes(), other.tobytes())

    def assertRefuses(self, call, *words):
        """It raises InputError, whose line has these words."""
        with self.assertRaises(plastica.InputError) as raised:
            call()
        for word in words:
            self.assertIn(word, str(raised.exception))
        return raised.exception

    def assertSameFiles(self, reference, other, *options):
        done = subprocess.run(
            [sys.executable, "-B", ROOT / "tests" / "cli" / "compare_results.py", *options,
             reference, other], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
