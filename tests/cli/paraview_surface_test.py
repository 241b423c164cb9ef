#!/usr/bin/env python3
"""Velocities in files for ParaView, and results that carry their surface: `simulate --paraview`.

paraview_surface_test.py COMMAND DATA
"""

import os
import subprocess
import sys
import unittest

import h5py
import numpy

from vtkhdf_files import ARCH, COUPON, DATA, Exported, Step, run

FLIGHT = """
material = "S355"
[beam]
length = "1 m"
section = { shape = "rectangle", width = "20 mm", height = "30 mm" }
segments = 6

[rules]
yield_model = "elastic"
[solver]
analysis = "dynamics"
scheme = "energy_momentum"
time_step = "1 ms"
duration = "200 ms"
steps = 200
frames = 10
[[initial_motion]]
about = 0.5
velocity = ["0.2 m/s", "0.3 m/s", "0.1 m/s"]
spin = ["4 rad/s", "0 rad/s", "0 rad/s"]
[[probe]]
name = "vx"
kind = "velocity"
at = "end"
component = "x"
[[probe]]
name = "vy"
kind = "velocity"
at = "end"
component = "y"
[[probe]]
name = "vz"
kind = "velocity"
at = "end"
component = "z"
"""


class Velocities(Exported):
    def test_moves_points_with_their_segments(self):
        """A crash: the mean of a ring's corners is a point of the axis, whose velocity the result has."""
        with h5py.File(self.result) as result:
            velocity = result["segments/velocity"][:]
            spin = result["segments/spin"][:]
        self.assertEqual(velocity.shape, (41, 28, 3))
        fastest = abs(velocity).max()
        self.assertGreater(fastest, 8.0)
        self.assertEqual(self.root["PointData/velocity"].attrs["units"], "m/s")
        for number in range(len(velocity)):
            step = Step(self.root, number)
            moves = step.point_data["velocity"].reshape(28, 3, -1, 3)
            places = step.points.reshape(28, 3, -1, 3)
            numpy.testing.assert_allclose(
                moves[:, 0].mean(axis=1), velocity[number], rtol=0, atol=1e-6 * fastest
            )
            # From corner to corner of a ring: omega x r, in single precision.
            turning = numpy.cross(spin[number][:, None, None], places - places.mean(axis=2)[:, :, None])
            numpy.testing.assert_allclose(
                moves - moves.mean(axis=2)[:, :, None], turning, rtol=0, atol=2e-5 * fastest
            )
            # Segments end where the next one begins, and as it moves, but at a cut.
            joined = step.cell_data["fragment"][numpy.searchsorted(step.cell_data["segment"], range(28))]
            for s in range(27):
                if joined[s] == joined[s + 1]:
                    numpy.testing.assert_allclose(
                        moves[s, 2].mean(axis=0), velocity[number, s + 1], rtol=0, atol=1e-6 * fastest
                    )

    def test_moves_a_rigid_body_as_one(self):
        """v + omega x (p - c) for every point, and at the beam's end what a probe has."""
        scene = self.path("flight.toml")
        with open(scene, "w", encoding="utf-8") as file:
            file.write(FLIGHT)
        run("simulate", scene, "-o", self.path("flight.h5"))
        run("export", self.path("flight.h5"), "-o", self.path("flight.vtkhdf"))
        with h5py.File(self.path("flight.h5")) as result:
            samples = result["path/frame_sample"][:]
            times = result["path/time"][:][samples]
            probes = result["probes/values"][:, samples]
        with h5py.File(self.path("flight.vtkhdf")) as file:
            for number, time in enumerate(times):
                step = Step(file["VTKHDF"], number)
                center = numpy.array([0.0, 0.0, 0.5]) + time * numpy.array([0.2, 0.3, 0.1])
                exact = [0.2, 0.3, 0.1] + numpy.cross([4.0, 0.0, 0.0], step.points - center)
                numpy.testing.assert_allclose(step.point_data["velocity"], exact, rtol=0, atol=5e-6)
                end = step.point_data["velocity"][-4:].mean(axis=0)
                numpy.testing.assert_allclose(end, probes[:, number], rtol=0, atol=1e-6)


class Surface(Exported):
    def test_result_carries_its_surface(self):
        """`simulate --paraview`: the group of an export, beside a result that is not changed by it."""
        whole = self.path("whole.vtkhdf")
        scene = os.path.join(DATA, "scenes", "crash_bumper.toml")
        said = run("simulate", scene, "-o", whole, "--paraview", "--quiet")
        self.assertEqual(said, "")
        with h5py.File(whole) as file:
            names = []
            self.root.visititems(lambda name, item: names.append(name))
            found = []
            file["VTKHDF"].visititems(lambda name, item: found.append(name))
            self.assertEqual(sorted(found), sorted(names))
            self.assertIn("PointData/velocity", names)
            for name in names:
                ours, theirs = file["VTKHDF"][name], self.root[name]
                self.assertEqual(dict(ours.attrs), dict(theirs.attrs))
                if isinstance(theirs, h5py.Dataset):
                    self.assertEqual(ours.dtype, theirs.dtype)
                    numpy.testing.assert_array_equal(ours[()], theirs[()])
            self.assertEqual(file["VTKHDF"].attrs["Type"], b"PolyData")
            self.assertEqual(file.attrs["schema"], "plastica/scene")
        script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "compare_results.py")
        for but, code in (("/VTKHDF", 0), ("/nothing", 1)):
            done = subprocess.run([sys.executable, "-B", script, "--but", but, self.result, whole],
                                  capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, code, done.stdout)
        for pair in ((self.result, whole), (whole, self.result)):
            self.assertIn("equal; ", run("diff", *pair))
        for arguments in (("show",), ("plot", "--what", "shape"), ("export", "--what", "joints")):
            self.assertEqual(run(arguments[0], whole, *arguments[1:]).replace(whole, ""),
                             run(arguments[0], self.result, *arguments[1:]).replace(self.result, ""))
        run("report", whole, "-o", self.path("whole.html"))
        run("export", whole, "-o", self.path("again.vtkhdf"))
        with open(self.path("again.vtkhdf"), "rb") as ours, open(self.path("crash.vtkhdf"), "rb") as theirs:
            self.assertEqual(ours.read(), theirs.read())

    def test_surface_of_a_path_numbers_its_steps(self):
        scene = self.path("arch.toml")
        with open(scene, "w", encoding="utf-8") as file:
            file.write(ARCH)
        said = run("simulate", scene, "-o", self.path("surface.h5"), "--paraview", "--quiet")
        self.assertIn("the steps are numbered", said)
        with h5py.File(self.path("surface.h5")) as file:
            steps = file["VTKHDF/Steps/Values"][:]
            self.assertEqual(len(steps), len(file["path/frame_sample"]))
            numpy.testing.assert_array_equal(steps, range(len(steps)))

    def test_run_that_ends_before_its_first_frame_has_no_surface(self):
        """A beam that its supports hold twice along its axis, and that is to move there."""
        scene = self.path("held.toml")
        clamps = "".join(f"[[support]]\nat = {at}\nkind = 'clamp'\n" for at in (0.0, 0.25, 0.5, 1.0))
        with open(scene, "w", encoding="utf-8") as file:
            file.write(FLIGHT.replace("segments = 6", "segments = 4").replace('"0.1 m/s"', '"3 m/s"'))
            file.write(clamps)
        said = run("simulate", scene, "-o", self.path("held.h5"), "--paraview", "--quiet", code=1)
        self.assertIn("note: the run ended before the first frame: the result has nothing for ParaView\n", said)
        self.assertIn("plastica: held-twice: ", said)
        with h5py.File(self.path("held.h5")) as file:
            self.assertEqual(len(file["path/frame_sample"]), 0)
            self.assertNotIn("VTKHDF", file)
            self.assertEqual(list(file["segments"]), ["rotation"])
        self.assertIn("held-twice", run("show", self.path("held.h5")))

    def test_refuses_a_surface_before_any_work(self):
        crash = os.path.join(DATA, "scenes", "crash_bumper.toml")
        coupon = self.path("coupon2.toml")
        with open(coupon, "w", encoding="utf-8") as file:
            file.write(COUPON)
        goes = "--paraview: goes with a result file: -o FILE.h5 or -o FILE.vtkhdf\n"
        cases = (
            ((coupon, "-o", self.path("n.h5"), "--paraview"), "--paraview: needs a beam: a coupon has none to show\n"),
            ((crash, "--paraview"), goes),
            ((crash, "-o", self.path("n.csv"), "--paraview"), goes),
            ((crash, "-o", "-", "--paraview"), goes),
            (
                (crash, "-o", self.path("n.vtkhdf")),
                f"--output = {self.path('n.vtkhdf')}: must end in .h5 or .csv, or be -; with --paraview .vtkhdf does, too\n",
            ),
        )
        for arguments, words in cases:
            said = run("simulate", *arguments, code=2)
            self.assertTrue(said.endswith(words), said)
            self.assertEqual(said.count("\n"), 1, said)
        for left in ("n.h5", "n.csv", "n.vtkhdf"):
            self.assertFalse(os.path.exists(self.path(left)))
        self.assertFalse(os.path.exists(self.path("n.h5.lock")))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
