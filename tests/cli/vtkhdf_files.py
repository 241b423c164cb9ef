"""Files by VTK's specification, read without our code and without VTK's: for the tests of what the
command writes for ParaView.

SCRIPT COMMAND DATA
"""

import os
import subprocess
import sys
import tempfile
import unittest

import h5py

COMMAND, DATA = sys.argv[1:3]
ARCH = """
[beam]
length = "1 m"
section = { shape = "rectangle", width = "20 mm", height = "10 mm" }
material = "S355"
segments = 32
shape = "arc"
arc_angle = "40 deg"
arc_towards = ["0", "-1", "0"]

[rules]
yield_model = "elastic"
[solver]
steps = 60
control = "arc_length"
[[support]]
at = "start"
kind = "pin"
[[support]]
at = "end"
kind = "pin"
[[load]]
at = 0.5
force = ["0 N", "-10000 N", "0 N"]
history = "ramp"
[[probe]]
name = "mid"
kind = "displacement"
at = 0.5
component = "y"
"""
COUPON = """
[material]
name = "S355"
[drive]
deformation = "tension"
strain = ["0 %", "1 %"]
[[probe]]
kind = "stress"
"""
TOPOLOGIES = ("Vertices", "Lines", "Polygons", "Strips")


def run(*arguments, code=0):
    done = subprocess.run([COMMAND, *arguments], capture_output=True, text=True, check=False)
    if done.returncode != code:
        raise AssertionError(f"{arguments}: {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


class Step:
    """One step of a file, read as the specification has it: parts, then offsets of each array."""

    def __init__(self, root, number):
        steps = root["Steps"]
        part = steps["PartOffsets"][number]
        assert steps["NumberOfParts"][number] == 1
        count = root["NumberOfPoints"][part]
        first = steps["PointOffsets"][number]
        self.points = root["Points"][first : first + count]
        self.cells = {}
        for k, name in enumerate(TOPOLOGIES):
            group = root[name]
            cells = group["NumberOfCells"][part]
            begin = steps["CellOffsets"][number, k] + part
            offsets = group["Offsets"][begin : begin + cells + 1]
            shift = steps["ConnectivityIdOffsets"][number, k]
            corners = group["Connectivity"][shift : shift + group["NumberOfConnectivityIds"][part]]
            assert offsets[0] == 0 and offsets[-1] == len(corners)
            self.cells[name] = [corners[a:b] for a, b in zip(offsets, offsets[1:])]
        total = sum(len(cells) for cells in self.cells.values())
        self.point_data = {}
        self.cell_data = {}
        for kind, rows, found in (
            ("PointData", count, self.point_data),
            ("CellData", total, self.cell_data),
        ):
            for name, data in root[kind].items():
                begin = steps[kind + "Offsets"][name][number]
                found[name] = data[begin : begin + rows]
                assert len(found[name]) == rows, name


class Exported(unittest.TestCase):
    """With the result of a crash, and its export."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.result = cls.path("crash.h5")
        run("simulate", os.path.join(DATA, "scenes", "crash_bumper.toml"), "-o", cls.result)
        run("export", cls.result, "-o", cls.path("crash.vtkhdf"))
        cls.root = h5py.File(cls.path("crash.vtkhdf"))["VTKHDF"]

    @classmethod
    def tearDownClass(cls):
        cls.root.file.close()
        cls.folder.cleanup()

    @classmethod
    def path(cls, name):
        return os.path.join(cls.folder.name, name)
