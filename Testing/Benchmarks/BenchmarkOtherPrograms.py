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
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_QUADRATIC_TETRA, vtkCellArray, vtkUnstructuredGrid

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


def make_curved(grid):
    """Quadratic tetrahedra of linear ones, whose midside nodes are slightly beside the middle."""
    points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
    corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    ends = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))
    edges = numpy.sort(numpy.concatenate([corners[:, pair] for pair in ends]), axis=1)
    distinct, of_edge = numpy.unique(edges, axis=0, return_inverse=True)
    middles = points[distinct].mean(axis=1)
    lengths = numpy.linalg.norm(numpy.diff(points[distinct], axis=1)[:, 0], axis=1)
    middles += 0.02 * numpy.sin(40 * middles[:, [1, 2, 0]]) * lengths[:, None]
    nodes = len(points) + of_edge.reshape(len(ends), -1).T
    return numpy.concatenate([points, middles]), numpy.concatenate([corners, nodes], axis=1)


def compare_curved(gmsh, make, cells, folder):
    """Bounds of the Jacobian determinant, which both programs guarantee to 0.001 of the greatest value."""
    path = os.path.join(folder, "curved.visf")
    subprocess.run([make, "tetrahedra", str(cells), path], check=True)
    points, nodes = make_curved(servermanager.Fetch(read(path)))
    grid, array, lists = vtkUnstructuredGrid(), vtkPoints(), vtkCellArray()
    array.SetData(numpy_to_vtk(points, deep=True))
    lists.SetData(nodes.shape[1], numpy_to_vtkIdTypeArray(nodes.ravel(), deep=True))
    grid.SetPoints(array)
    grid.SetCells(VTK_QUADRATIC_TETRA, lists)
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(grid)
    quality = simple.ElementQuality(Input=source, Criteria=["MinJacobian"])
    quality.UpdatePipeline()

    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.model.addDiscreteEntity(3, 1)
    tags = numpy.arange(1, len(nodes) + 1)
    gmsh.model.mesh.addNodes(3, 1, numpy.arange(1, len(points) + 1), points.ravel())
    ten_nodes, order = 11, [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]  # Gmsh's type, and its last two nodes
    gmsh.model.mesh.addElementsByType(1, ten_nodes, tags, nodes[:, order].ravel() + 1)

    def evaluate(_):
        grid.GetPoints().Modified()
        update(quality.GetClientSideObject())

    compare(
        "MinJacobian of 100,000 cells",
        "quadratic tetrahedra",
        len(nodes),
        evaluate,
        f"Gmsh {gmsh.__version__}, minDetJac",
        lambda _: gmsh.model.mesh.getElementQualities(tags, "minDetJac"),
    )
    gmsh.finalize()


def main():
    make, *numbers = sys.argv[1:]
    cells = int(1e6 * float(numbers[0])) if numbers else CELLS_FOR_SLOW_PEERS
    with tempfile.TemporaryDirectory() as folder:
        for module, run in (
            ("meshio", compare_reading),
            ("gmsh", compare_quality),
            ("gmsh", compare_curved),
        ):
            found = find(module)
            if found:
                run(found, make, cells, folder)


main()
sys.stdout.flush()
os._exit(0)  # pvpython can hang while it closes
