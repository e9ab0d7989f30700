# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Finite-volume criteria of polyhedra, beside OpenFOAM's checkMesh on the same mesh, in one run.

Usage: BenchmarkCheckMesh [millions of polyhedra]

checkMesh works on one thread, and says when it has read the mesh, as text. Its file has the faces
and their cells; we find them. Only evaluating is recorded.
"""

import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "Python"))

import openfoam_case
from benchmark_records import OURS, REPETITIONS, record
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


def repeat(what, cells, once):
    """Wall and processor times of evaluating. once() returns wall times of all, of reading and of evaluating, and the
    processor time of the last."""
    runs = sorted((once() for _ in range(REPETITIONS)), key=lambda run: run[2])
    whole, read, evaluate, _ = (1e9 * seconds / cells for seconds in runs[len(runs) // 2])
    print(
        f"  {what:<42s} {whole:8.0f} ns/cell, reading {read:8.0f}, evaluating {evaluate:8.0f}",
        flush=True,
    )
    return [run[2:] for run in runs]


def check(case, *options):
    """A run of checkMesh."""
    start = time.perf_counter()
    command = openfoam_case.check_mesh(case, *options)
    environment = openfoam_case.environment()
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment) as process:
        for line in process.stdout:
            if line.startswith("Mesh stats"):
                read = time.perf_counter()
    end = time.perf_counter()
    return end - start, read - start, end - read, end - read


def evaluate(path, criteria):
    """The same of ours."""
    start = time.perf_counter()
    source = simple.OpenDataFile(path)
    source.UpdatePipeline()
    read, processor = time.perf_counter(), time.process_time()
    quality = simple.ElementQuality(Input=source, Criteria=criteria)
    quality.UpdatePipeline()
    end = time.perf_counter()
    processor = time.process_time() - processor
    simple.Delete(quality)
    simple.Delete(source)
    return end - start, read - start, end - read, processor


def version():
    """What checkMesh says that it is, such as 1912."""
    text = subprocess.run(
        openfoam_case.check_mesh("/nonexistent"),
        capture_output=True,
        text=True,
        env=openfoam_case.environment(),
    ).stdout
    found = re.search(r"OPENFOAM=(\S+)", text)
    return found[1] if found else ""


def main():
    make, *numbers = sys.argv[1:]
    millions = float(numbers[0]) if numbers else 0.1
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
        by = f"checkMesh, one thread, OpenFOAM {version()}".strip()
        for work, criteria, options in (
            ("what checkMesh checks", USUAL, []),
            ("what checkMesh -allGeometry checks", ALL, ["-allGeometry", "-allTopology"]),
        ):
            what = f"Element Quality, {len(criteria)} criteria"
            ours = repeat(what, cells, lambda: evaluate(path, criteria))
            record(work, "polyhedra", OURS, cells, ours)
            what = " ".join(["checkMesh", *options])
            record(
                work, "polyhedra", by, cells, repeat(what, cells, lambda: check(folder, *options))
            )


main()
sys.stdout.flush()
os._exit(0)  # pvpython can hang while it closes
