# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Mesh Kernel in ParaView: kernels of cells and of closed surfaces, the same on any number of ranks."""

import camaron_testing
import numpy
from camaron_testing import EXAMPLES
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON

RANKS = camaron_testing.rank_count()
CELLS = 800  # of the Voronoi ball

#: Makes on every rank its share of the polygons of a surface, or of some cells.
SOURCE = """
import math
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray
from vtkmodules.vtkParallelCore import vtkMultiProcessController

controller = vtkMultiProcessController.GetGlobalController()
rank = controller.GetLocalProcessId() if controller else 0
ranks = controller.GetNumberOfProcesses() if controller else 1


def l_prism():
    return prism([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)])


def u_prism():
    return prism([(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)])


def prism(ring):
    n = len(ring)
    points = [(x, y, z) for z in (0.0, 1.0) for x, y in ring]
    faces = [list(range(n))[::-1], list(range(n, 2 * n))]
    faces += [[i, (i + 1) % n, (i + 1) % n + n, i + n] for i in range(n)]
    return points, faces


def star():
    # Spikes all over a ball.
    rows, columns = 24, 48
    radius = lambda i, j: 1 + 0.1 * math.sin(1.7 * i) * math.cos(2.3 * j)
    points = [(0, 0, 1.0), (0, 0, -1.0)]
    for i in range(1, rows):
        for j in range(columns):
            a, b, r = math.pi * i / rows, 2 * math.pi * j / columns, radius(i, j)
            points.append((r * math.sin(a) * math.cos(b), r * math.sin(a) * math.sin(b), r * math.cos(a)))
    at = lambda i, j: 2 + (i - 1) * columns + j % columns
    faces = []
    for j in range(columns):
        faces += [[0, at(1, j), at(1, j + 1)], [1, at(rows - 1, j + 1), at(rows - 1, j)]]
        for i in range(1, rows - 1):
            faces += [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]]
    return points, faces


points, faces = {shape}()
if {turned}:
    faces = [face[::-1] if i % 3 else face for i, face in enumerate(faces)]
own = vtkPoints()
own.SetDataTypeToDouble()
cells = vtkCellArray()
faces = faces[: len(faces) - {missing}]
if {together}:
    faces = faces[::-1]
for i, face in enumerate(faces):
    if rank == (0 if {together} else i % ranks):
        cells.InsertNextCell(len(face), [own.InsertNextPoint(points[p]) for p in face])
self.GetPolyDataOutput().SetPoints(own)
self.GetPolyDataOutput().SetPolys(cells)
"""


def surface(shape, turned=False, missing=0, together=False):
    """The surface with some polygons reversed, without the last ones, or completely on the first rank."""
    script = SOURCE
    for name, value in (
        ("shape", shape),
        ("turned", turned),
        ("missing", missing),
        ("together", together),
    ):
        script = script.replace(f"{{{name}}}", str(value))
    return simple.ProgrammableSource(OutputDataSetType="vtkPolyData", Script=script)


class TestMeshKernel(camaron_testing.TestCase):
    def update(self, kernel):
        with camaron_testing.pipeline.Messages() as messages:
            kernel.UpdatePipeline()
        return messages

    def bounds_of(self, kernel):
        return kernel.GetDataInformation().GetBounds()

    def values(self, kernel, name):
        pieces = [piece.GetCellData().GetArray(name) for piece in camaron_testing.pieces(kernel)]
        return numpy.concatenate([vtk_to_numpy(array) for array in pieces if array])

    def test_whole_surface(self):
        """The kernel of an L is the square at its corner, a third of it; polygons may have either orientation."""
        for turned in (False, True):
            kernel = simple.MeshKernel(Input=surface("l_prism", turned))
            self.assertEqual(self.update(kernel).errors, [])
            self.assertEqual(self.bounds_of(kernel), (0.0, 1.0, 0.0, 1.0, 0.0, 1.0))
            self.assertAlmostEqual(self.values(kernel, "KernelRatio")[0], 1 / 3, places=12)
            pieces = camaron_testing.pieces(kernel)
            self.assertEqual(
                [piece.GetNumberOfCells() for piece in pieces], [1] + [0] * (RANKS - 1)
            )
            self.assertEqual(pieces[0].GetCellType(0), VTK_POLYHEDRON)
            self.assertEqual(pieces[0].GetNumberOfPoints(), 8)
            self.assertEqual(pieces[0].GetCell(0).GetNumberOfFaces(), 6)

    def test_same_on_any_number_of_ranks(self):
        """Identical to the result of one rank, also if polygons are reversed."""
        grids = []
        for together in (False, True):
            kernel = simple.MeshKernel(Input=surface("star", together=together))
            self.assertEqual(self.update(kernel).errors, [])
            grids.append(camaron_testing.pieces(kernel)[0])
            ratio = self.values(kernel, "KernelRatio")[0]
            self.assertGreater(ratio, 0)
            self.assertLess(ratio, 1)
        points, expected = (vtk_to_numpy(grid.GetPoints().GetData()) for grid in grids)
        numpy.testing.assert_array_equal(points, expected)
        faces, expected = (
            vtk_to_numpy(grid.GetPolyhedronFaces().GetConnectivityArray()) for grid in grids
        )
        numpy.testing.assert_array_equal(faces, expected)

    def test_empty_kernel(self):
        """No point sees all of a U: no cell, and a warning."""
        kernel = simple.MeshKernel(Input=surface("u_prism"))
        messages = self.update(kernel)
        self.assertEqual(messages.errors, [])
        self.assertIn("kernel is empty", " ".join(messages.warnings))
        self.assertEqual(kernel.GetDataInformation().GetNumberOfCells(), 0)

    def test_open_surface(self):
        """An error where it is asked for as a whole; else the polygons are cells."""
        source = surface("l_prism", missing=1)
        kernel = simple.MeshKernel(Input=source, KernelOf="Whole Surface")
        self.assertIn("do not enclose a volume", " ".join(self.update(kernel).errors))
        kernel = simple.MeshKernel(Input=source)
        self.assertEqual(self.update(kernel).errors, [])
        self.assertEqual(kernel.GetDataInformation().GetNumberOfCells(), 7)
        # Two L-shaped hexagons, and squares.
        ratios = sorted(self.values(kernel, "KernelRatio"))
        numpy.testing.assert_allclose(ratios, [1 / 3] * 2 + [1] * 5, atol=1e-12)

    def test_each_cell(self):
        """Volumes of the kernels are KernelRatio times those of the cells."""
        mesh = simple.OpenDataFile(str(EXAMPLES / "voronoi-ball.visf"))
        quality = simple.ElementQuality(Input=mesh, Criteria=["KernelRatio", "Volume"])
        kernel = simple.MeshKernel(Input=quality)
        self.assertEqual(self.update(kernel).errors, [])
        after = simple.ElementQuality(Input=kernel, Criteria=["Volume", "IsWatertight"])
        self.update(after)
        owned = simple.RemoveGhostInformation(Input=quality)
        self.update(owned)
        before, volumes = self.values(owned, "Volume"), self.values(after, "Volume")
        self.assertEqual(len(before), CELLS)
        self.assertEqual(set(self.values(after, "IsWatertight")), {1})
        numpy.testing.assert_allclose(
            volumes, before * self.values(after, "KernelRatio"), rtol=1e-6
        )
        numpy.testing.assert_array_equal(
            self.values(after, "KernelRatio"), self.values(owned, "KernelRatio")
        )

    def test_chosen_cells(self):
        """Only the cells of an array; an array that is not there is an error."""
        mesh = simple.OpenDataFile(str(EXAMPLES / "voronoi-ball.visf"))
        quality = simple.ElementQuality(Input=mesh, Criteria=["EdgeLengthRatio"])
        select = simple.SelectElements(
            Input=quality, Array="EdgeLengthRatio", Strategy="Worst N", NumberOfWorst=5
        )
        kernel = simple.MeshKernel(Input=select, ChosenBy="Selected")
        self.assertEqual(self.update(kernel).errors, [])
        self.assertEqual(kernel.GetDataInformation().GetNumberOfCells(), 5)
        kernel = simple.MeshKernel(Input=mesh)
        kernel.ChosenBy = "Nothing"
        self.assertIn("no cell array Nothing", " ".join(self.update(kernel).errors))

    @camaron_testing.unittest.skipIf(RANKS > 1, "what concerns two cells concerns no ranks")
    def test_options(self):
        """Cells without a kernel are those without a KernelRatio above 0 in Element Quality, with the same options."""
        points = [(x, y, z) for z in (0, 0.01) for y in (0, 1) for x in (0, 1)]
        faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
        turned = [faces[0][::-1], *faces[1:]]
        stream = lambda cell: (42, [6, *(number for face in cell for number in (4, *face))])
        path = camaron_testing.write_vtk(
            self.folder / "thin.vtk", points, [stream(faces), stream(turned)]
        )
        source = simple.LegacyVTKReader(FileNames=[str(path)])
        for options, without in (
            ({}, []),
            ({"TrustFaceOrientation": 1}, [1]),
            ({"DegeneracyTolerance": 0.1}, [0, 1]),
        ):
            kernels = self.fetch(simple.MeshKernel(Input=source, **options))
            found = kernels.GetFieldData().GetArray("CellsWithoutKernel")
            self.assertEqual(
                vtk_to_numpy(found).tolist() if found.GetNumberOfTuples() else [], without
            )
            quality = self.fetch(
                simple.ElementQuality(Input=source, Criteria=["KernelRatio"], **options)
            )
            ratios = vtk_to_numpy(quality.GetCellData().GetArray("KernelRatio"))
            self.assertEqual(numpy.flatnonzero(~(ratios > 0)).tolist(), without)
            self.assertFalse(kernels.GetCellData().HasArray("SourceBlock"))
        # In two blocks cells of the same number are told apart.
        blocks = simple.GroupDatasets(Input=[source, source])
        kernels = self.fetch(simple.MeshKernel(Input=blocks, TrustFaceOrientation=1))
        values = lambda data, name: vtk_to_numpy(data.GetArray(name)).tolist()
        cells, fields = kernels.GetCellData(), kernels.GetFieldData()
        self.assertEqual(values(cells, "SourceCell"), [0, 0])
        self.assertEqual(values(fields, "CellsWithoutKernel"), [1, 1])
        self.assertEqual(values(cells, "SourceBlock"), values(fields, "BlocksWithoutKernel"))
        self.assertEqual(len(set(values(cells, "SourceBlock"))), 2)

    @camaron_testing.unittest.skipIf(
        RANKS > 1, "the filter is stopped by the process that it is in"
    )
    def test_stopped(self):
        """Aborted before the end, the output is empty; updated again, it is complete."""
        mesh = simple.OpenDataFile(str(EXAMPLES / "voronoi-ball.visf"))
        for source, cells in ((mesh, CELLS), (surface("star"), 1)):
            kernel = simple.MeshKernel(Input=source)
            filter_ = kernel.GetClientSideObject()
            reports = []

            def stop(*_):
                reports.append(filter_.GetProgress())
                if len(reports) == 3:
                    filter_.AbortExecuteOn()

            observer = filter_.AddObserver("ProgressEvent", stop)
            self.assertEqual(self.update(kernel).errors, [])
            self.assertLess(reports[2], 1)
            self.assertEqual(filter_.GetOutput().GetNumberOfCells(), 0)
            filter_.RemoveObserver(observer)
            filter_.AbortExecuteOff()
            filter_.Modified()
            filter_.Update()
            self.assertGreaterEqual(filter_.GetOutput().GetNumberOfCells(), 1)
            self.assertLessEqual(filter_.GetOutput().GetNumberOfCells(), cells)

    def test_defaults(self):
        kernel = simple.MeshKernel(Input=surface("l_prism"))
        self.assertEqual(kernel.KernelOf, "Automatic")
        self.assertEqual(kernel.ChosenBy, "All cells")


if __name__ == "__main__":
    camaron_testing.main()
