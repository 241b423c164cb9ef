"""Curves in HDF5 files of others, and the same numbers in CSV files: what the tests of both share."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy

COMMAND = sys.argv[1]


def curve(yield_stress, samples=120):
    """Strain [1] and stress [MPa] of a specimen, with digits that a decimal cut would change."""
    noise = numpy.random.default_rng(int(yield_stress))
    strain = numpy.linspace(0, 0.02, samples) * (1 + 1e-9 * noise.normal(size=samples))
    return strain, numpy.minimum(200e3 * strain, yield_stress) + noise.normal(0, 0.3, samples)


CURVES = {f"A-{i}": curve(250 + 7 * i) for i in range(3)}
COLUMNS = 'strain = { column = "strain" }\nstress = { column = "stress" }\n'
LOADS = ('elongation = { column = "travel", unit = "mm" }\nforce = { column = "load" }\n'
         'gauge_length = { from = "L0", unit = "mm" }\narea = { from = "S0", unit = "mm^2" }\n')


def by_name(result):
    """Name -> (raw strain, raw stress, value of the yield stress) of each fit; None: rejected."""
    with h5py.File(result) as file:
        fits = {}
        names = [name.decode() for name in file["fits/name"][:]]
        raw = file["curves/raw"]
        offsets = raw["offsets"][:]
        statuses = file["fits/status"][:]
        values = file["parameters/yield_stress/value"][:]
        for row, name in enumerate(names):
            part = slice(offsets[row], offsets[row + 1])
            value = values[row] if statuses[row] == b"fitted" else None
            fits[name] = (raw["strain"][part], raw["stress"][part], value)
        return fits


class Hdf5Curves(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.at = pathlib.Path(self.folder.name)

    def command(self, *words, code=0):
        done = subprocess.run([COMMAND, *words], cwd=self.at, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, code, done.stderr + done.stdout)
        return done.stdout + done.stderr

    def fit(self, block, code=0):
        """Fits one [[target]]; returns what was said, and the fits by name."""
        (self.at / "fit.toml").write_text("[[target]]\n" + block)
        said = self.command("calibrate", "fit.toml", "-o", "fit.h5", "--force", code=code)
        return said, by_name(self.at / "fit.h5") if code != 2 else {}

    def file(self, name="curves.h5"):
        return h5py.File(self.at / name, "w")

    def groups(self, file, **options):
        for name, (strain, stress) in CURVES.items():
            group = file.create_group(name)
            group.create_dataset("strain", data=strain, **options)
            group.create_dataset("stress", data=stress, **options).attrs["units"] = "MPa"

    def expect_as_csv(self, fits, name_of="curves:{}".format):
        for name, (strain, stress) in CURVES.items():
            rows = "".join(f"{e!r},{s!r}\n" for e, s in zip(strain.tolist(), stress.tolist()))
            (self.at / f"{name}.csv").write_text("strain,stress [MPa]\n" + rows)
        _, wanted = self.fit('files = "A-*.csv"\n' + COLUMNS)
        self.assertEqual(set(fits), {name_of(name) for name in CURVES})
        for name, (strain, _, value) in wanted.items():
            found = fits[name_of(name)]
            self.assertEqual(found[0].tobytes(), CURVES[name][0].tobytes())
            self.assertEqual(found[0].tobytes(), strain.tobytes())
            self.assertEqual(found[1].tobytes(), wanted[name][1].tobytes())
            self.assertIsNotNone(value)
            self.assertEqual(found[2], value)

    def loads(self, file):
        for i, (name, (strain, stress)) in enumerate(CURVES.items()):
            group = file.create_group(f"heat {i % 2}/{name}")
            group["travel"] = strain * (50 + i)
            group["load"] = stress * (70 + i)
            group["load"].attrs["units"] = "N"
            group.attrs["S0"] = 70.0 + i
            group["L0"] = 50 + i
            group.attrs["list"] = [1, 2, 3]
        file["heat 0"].attrs["S0"] = 1.0  # the specimen's own is nearer
        file["heat 0"].attrs["heat"] = "H0"
        file["heat 1"].attrs["heat"] = "H1"
