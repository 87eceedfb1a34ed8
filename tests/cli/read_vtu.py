"""What VTK's reader, ParaView's, finds in the frames that `mpmvv run --vtu` writes: read_vtu.py FOLDER PROGRAM PROBLEM.

Prints how many frames there are, particles in each, the last time, and the root mean square of the displacement error
at that time: by the positions and displacements that were read, and the displacements that `mpmvv solution` says.
"""
import json
import subprocess
import sys
import xml.etree.ElementTree

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

folder, program, problem = sys.argv[1:]
frames = []
for entry in xml.etree.ElementTree.parse(folder + "/particles.pvd").iter("DataSet"):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(folder + "/" + entry.get("file"))
    reader.Update()
    frames.append((float(entry.get("timestep")), reader.GetOutput()))

time, last = frames[-1]
fields = {last.GetPointData().GetArrayName(k) for k in range(last.GetPointData().GetNumberOfArrays())}
assert {"displacement", "velocity", "deformation_gradient", "mass"} <= fields, fields
x = vtk_to_numpy(last.GetPoints().GetData())
u = vtk_to_numpy(last.GetPointData().GetArray("displacement"))
total = 0
for position, displacement in zip(x, u):
    X = ",".join(repr(float(value)) for value in (position - displacement)[:2])
    answer = subprocess.run([program, "solution", "--problem", problem, "--at", X, "--time", repr(time), "--json"],
                            capture_output=True, check=True)
    exact = json.loads(answer.stdout)["u"]
    total += sum((displacement[k] - exact[k]) ** 2 for k in range(2))
print(json.dumps({"frames": len(frames), "particles": [grid.GetNumberOfPoints() for _, grid in frames],
                  "cells": last.GetNumberOfCells(), "time": time, "start": frames[0][0],
                  "l2": (total / len(x)) ** 0.5}))
