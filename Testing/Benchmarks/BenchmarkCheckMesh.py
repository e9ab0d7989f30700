# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Finite-volume criteria of polyhedra, beside OpenFOAM's checkMesh on the same mesh, in one run.

Usage: BenchmarkCheckMesh [millions of polyhedra]

checkMesh works on one thread, and says when it has read the mesh, as text. Its file has the faces
and their cells; we find them.
"""

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "Python"))

import openfoam_case
from paraview import simple
from vtkmodules.vtkCommonCore import vtkSMPTools

from camaron.common import pipeline

pipeline.load_plugin()

#: What checkMesh looks at without options, and with -allGeometry.
USUAL = [
    "Volume",
    "CellAspectRatio",
    "MaxNonOrthogonality",
    "MaxFaceSkewness",
    "Openness",
    "MinFacePyramidVolume",
]
ALL = [
    *USUAL,
    "MinEdgeLength",
    "MinFaceWeight",
    "MinVolumeRatio",
    "CellDeterminant",
    "MinFaceFlatness",
    "MaxFaceConcavity",
]


def report(what, cells, start, read, end):
    whole, reading, evaluating = (1e9 * t / cells for t in (end - start, read - start, end - read))
    print(
        f"  {what:<42s} {end - start:7.2f} s {whole:8.0f} ns/cell,"
        f" reading {reading:8.0f}, evaluating {evaluating:8.0f}",
        flush=True,
    )


def check(case, cells, *options):
    """A run of checkMesh."""
    start = time.perf_counter()
    command = openfoam_case.check_mesh(case, *options)
    environment = openfoam_case.environment()
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment) as process:
        for line in process.stdout:
            if line.startswith("Mesh stats"):
                read = time.perf_counter()
    report(" ".join(["checkMesh", *options]), cells, start, read, time.perf_counter())


def evaluate(path, cells, criteria):
    """The same of ours."""
    start = time.perf_counter()
    source = simple.OpenDataFile(path)
    source.UpdatePipeline()
    read = time.perf_counter()
    quality = simple.ElementQuality(Input=source, Criteria=criteria)
    quality.UpdatePipeline()
    report(f"Element Quality, {len(criteria)} criteria", cells, start, read, time.perf_counter())
    simple.Delete(quality)
    simple.Delete(source)


def main():
    make, *numbers = sys.argv[1:]
    millions = float(numbers[0]) if numbers else 0.2
    if not openfoam_case.PROGRAM:
        print("OpenFOAM's checkMesh is not installed")
        return
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "polyhedra.visf")
        subprocess.run([make, "polyhedra", str(int(1e6 * millions)), path], check=True)
        source = simple.OpenDataFile(path)
        openfoam_case.write(Path(folder), source)
        cells = source.GetDataInformation().GetNumberOfCells()
        simple.Delete(source)
        print(
            f"{cells} polyhedra; SMP backend {vtkSMPTools.GetBackend()},"
            f" {vtkSMPTools.GetEstimatedNumberOfThreads()} threads"
        )
        for criteria, options in ((USUAL, []), (ALL, ["-allGeometry", "-allTopology"])):
            evaluate(path, cells, criteria)
            check(folder, cells, *options)


main()
sys.stdout.flush()
os._exit(0)  # pvpython can hang while it closes
