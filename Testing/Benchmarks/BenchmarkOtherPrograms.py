# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reading and evaluating 100,000 cells, beside meshio and Gmsh where Python finds them, in one run.

Usage: BenchmarkOtherPrograms [millions of cells]

They are Debian's packages python3-meshio and python3-gmsh.
"""

import importlib
import os
import subprocess
import sys
import tempfile

import numpy
from benchmark_records import CELLS_FOR_SLOW_PEERS, OURS, median, record, repeat
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from camaron.common import pipeline

pipeline.load_plugin()


def find(module):
    try:
        return importlib.import_module(module)
    except (ImportError, OSError) as error:  # of Python, or of a library that it loads
        print(f"{module} is not installed: {error}")
        return None


def compare(work, mesh, cells, ours, by, peer):
    for name, once in ((OURS, ours), (by, peer)):
        once(0)
        times = repeat(once)
        record(work, mesh, name, cells, times)
        print(f"{mesh:<24s} {work:<24s} {name:<16s} {1e9 * median(times) / cells:9.1f} ns/cell")


def read(path):
    source = simple.OpenDataFile(path)
    source.UpdatePipeline()
    return source


def update(algorithm):
    """Runs it again, without what proxies add to so few cells."""
    algorithm.Modified()
    algorithm.Update()


def compare_reading(meshio, make, cells, folder):
    for kind, suffix in (("triangles", "ply"), ("triangles", "off"), ("tetrahedra", "ele")):
        made, path = (os.path.join(folder, f"{kind}.{end}") for end in ("visf", suffix))
        subprocess.run([make, kind, str(cells), made], check=True)
        source = read(made)
        simple.SaveData(path, source)
        cells = source.GetDataInformation().GetNumberOfCells()
        ours = read(path).GetClientSideObject()
        compare(
            "open a file of 100,000 cells",
            f"{kind}, .{suffix}",
            cells,
            lambda _: update(ours),
            f"meshio {meshio.__version__}",
            lambda _: meshio.read(path),
        )


def compare_quality(gmsh, make, cells, folder):
    path = os.path.join(folder, "tetrahedra.visf")
    subprocess.run([make, "tetrahedra", str(cells), path], check=True)
    source = read(path)
    grid = servermanager.Fetch(source)
    cells = grid.GetNumberOfCells()
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.model.addDiscreteEntity(3, 1)
    points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
    tags = numpy.arange(1, cells + 1)
    gmsh.model.mesh.addNodes(3, 1, numpy.arange(1, len(points) + 1), points.ravel())
    connectivity = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    four_nodes = 4  # Gmsh's type of tetrahedra
    gmsh.model.mesh.addElementsByType(1, four_nodes, tags, connectivity + 1)

    quality = simple.ElementQuality(Input=source, Criteria=["TetRadiusRatio"])
    quality.UpdatePipeline()
    mesh = source.GetClientSideObject().GetOutputDataObject(0)

    def evaluate(_):
        mesh.GetPoints().Modified()  # so that values are not taken from the last time
        update(quality.GetClientSideObject())

    compare(
        "TetRadiusRatio of 100,000 cells",
        "tetrahedra",
        cells,
        evaluate,
        f"Gmsh {gmsh.__version__}, gamma",
        lambda _: gmsh.model.mesh.getElementQualities(tags, "gamma"),
    )
    gmsh.finalize()


def main():
    make, *numbers = sys.argv[1:]
    cells = int(1e6 * float(numbers[0])) if numbers else CELLS_FOR_SLOW_PEERS
    with tempfile.TemporaryDirectory() as folder:
        for module, run in (("meshio", compare_reading), ("gmsh", compare_quality)):
            found = find(module)
            if found:
                run(found, make, cells, folder)


main()
sys.stdout.flush()
os._exit(0)  # pvpython can hang while it closes
