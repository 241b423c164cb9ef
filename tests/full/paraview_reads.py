#!/usr/bin/env python3
"""ParaView reads what `plastica export` writes: a beam that breaks, its times, bounds and data, and a
picture of its pieces. Debian 12's ParaView is older than VTK's file with time steps, so it reads the
XDMF beside it.

paraview_reads.py COMMAND DATA PICTURE   started by python3: makes the files, and starts pvbatch
"""

import json
import os
import subprocess
import sys
import tempfile

VIEW = """
import json, sys
from paraview.simple import *
source, picture = sys.argv[1:3]
reader = OpenDataFile(source)
times = list(reader.TimestepValues)
UpdatePipeline(times[-1], reader)
facts = reader.GetDataInformation()
print("FACTS " + json.dumps({
    "times": times, "points": facts.GetNumberOfPoints(), "cells": facts.GetNumberOfCells(),
    "bounds": facts.GetBounds(),
    "ranges": {name: reader.CellData[name].GetRange() for name in reader.CellData.keys()},
    "moved": reader.PointData["displacement"].GetNumberOfComponents(),
    "speeds": reader.PointData["velocity"].GetRange(-1)}))
view = CreateView("RenderView")
view.ViewSize = [1200, 700]
view.UseColorPaletteForBackground = 0
view.Background = [1, 1, 1]
view.OrientationAxesVisibility = 0
shown = Show(reader, view)
shown.Representation = "Surface"
view.ViewTime = times[-1]
ColorBy(shown, ("CELLS", "fragment"))
shown.RescaleTransferFunctionToDataRange()
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [3, 1, -2], [0, -0.2, 0.7], [0, 1, 0]
ResetCamera(view)
Render(view)
SaveScreenshot(picture, view)
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.util.numpy_support import vtk_to_numpy
image = vtkPNGReader()
image.SetFileName(picture)
image.Update()
pixels = vtk_to_numpy(image.GetOutput().GetPointData().GetScalars())
print("DRAWN " + str(float((pixels.min(axis=1) < 250).mean())))
"""


def main():
    command, data, picture = sys.argv[1:4]
    import h5py  # of the system's Python

    with tempfile.TemporaryDirectory() as folder:
        result, shown = os.path.join(folder, "crash.h5"), os.path.join(folder, "crash.xdmf")
        scene = os.path.join(data, "scenes", "crash_bumper.toml")
        subprocess.run([command, "simulate", scene, "-o", result], check=True, stdout=subprocess.DEVNULL)
        subprocess.run([command, "export", result, "-o", shown], check=True)
        view = os.path.join(folder, "view.py")
        with open(view, "w", encoding="utf-8") as file:
            file.write(VIEW)
        done = subprocess.run(
            ["xvfb-run", "-a", "-s", "-screen 0 1280x800x24", "pvbatch", view, shown, picture],
            capture_output=True,
            text=True,
            timeout=300,
            check=False,
        )
        told = {line[:6]: line[6:] for line in done.stdout.splitlines()}
        if "FACTS " not in told or "DRAWN " not in told:
            sys.exit(f"pvbatch: {done.returncode}\n{done.stdout}{done.stderr}")
        facts, drawn = json.loads(told["FACTS "]), float(told["DRAWN "])
        with h5py.File(os.path.join(folder, "crash.vtkhdf")) as file:
            root = file["VTKHDF"]
            count = root["NumberOfPoints"][0]
            points = root["Points"][-count:]
            cells = root["Polygons/NumberOfCells"][0]
            strains = root["CellData/plastic_strain"][-cells:]
            speeds = (root["PointData/velocity"][-count:].astype(float) ** 2).sum(axis=1) ** 0.5
            times = list(root["Steps/Values"][:])
    faults = []
    expected = [x for k in range(3) for x in (points[:, k].min(), points[:, k].max())]
    if facts["times"] != times:
        faults.append(f"times {facts['times'][:3]}…")
    if (facts["points"], facts["cells"]) != (count, cells):
        faults.append(f"{facts['points']} points, {facts['cells']} cells")
    if any(abs(a - b) > 1e-6 for a, b in zip(facts["bounds"], expected)):
        faults.append(f"bounds {facts['bounds']}, not {expected}")
    if abs(facts["ranges"]["plastic_strain"][1] - strains.max()) > 1e-7:
        faults.append(f"strain up to {facts['ranges']['plastic_strain'][1]}, not {strains.max()}")
    if facts["ranges"]["fragment"][1] < 1 or facts["moved"] != 3:
        faults.append("no fragments, or no displacement")
    if abs(facts["speeds"][1] - speeds.max()) > 1e-5 * speeds.max():
        faults.append(f"speeds up to {facts['speeds'][1]}, not {speeds.max()}")
    if not 0.01 < drawn < 0.5:
        faults.append(f"the beam fills {drawn:.3g} of the picture")
    if faults:
        sys.exit("ParaView does not see what was written: " + "; ".join(faults))
    print(f"{facts['cells']} cells at {len(times)} times, {facts['ranges']['fragment'][1] + 1:.0f} fragments")


if __name__ == "__main__":
    main()
