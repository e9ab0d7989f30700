# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Second-order cells in filters, commands and reports: curved criteria, and those of the vertices."""

import camaron
import camaron_testing
import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_BEZIER_TRIANGLE,
    VTK_LAGRANGE_PYRAMID,
    VTK_QUADRATIC_EDGE,
    VTK_QUADRATIC_HEXAHEDRON,
    VTK_LAGRANGE_TETRAHEDRON,
    VTK_QUADRATIC_TETRA,
    VTK_TETRA,
    VTK_WEDGE,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

EDGES = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))
CORNERS = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
REASON = 6  # a linear cell


def tetrahedron(middle=None):
    """Nodes of a quadratic tetrahedron, that on its first edge at another place."""
    nodes = numpy.concatenate([CORNERS, [(CORNERS[a] + CORNERS[b]) / 2 for a, b in EDGES]])
    if middle is not None:
        nodes[4] = middle
    return nodes


def make_grid(cells):
    grid, points = vtkUnstructuredGrid(), vtkPoints()
    points.SetDataTypeToDouble()
    for cell_type, nodes in cells:
        ids = [points.InsertNextPoint(node) for node in nodes]
        grid.InsertNextCell(cell_type, len(ids), ids)
    grid.SetPoints(points)
    return grid


class TestCurvedCells(camaron_testing.TestCase):
    def write(self, cells, name="mesh.vtu", weights=None):
        grid = make_grid(cells)
        if weights:
            array = vtkDoubleArray()
            array.SetName("Weights")
            for weight in weights:
                array.InsertNextValue(weight)
            grid.GetPointData().SetRationalWeights(array)
        writer = vtkXMLUnstructuredGridWriter()
        path = self.folder / name
        writer.SetFileName(str(path))
        writer.SetInputData(grid)
        writer.Write()
        return path

    def evaluate(self, path, criteria):
        quality = simple.ElementQuality(
            Input=simple.OpenDataFile(str(path)), Criteria=criteria, WriteUndefinedMask=1
        )
        quality.UpdatePipeline()
        data = servermanager.Fetch(quality).GetCellData()
        names = [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]
        return {name: vtk_to_numpy(data.GetArray(name)) for name in names}

    def test_mask(self):
        """Values of the vertices have reason 6, and those that follow the curve are values."""
        path = self.write(
            [
                (VTK_TETRA, CORNERS),
                (VTK_QUADRATIC_TETRA, tetrahedron()),
                (VTK_QUADRATIC_TETRA, tetrahedron([0.5, 0.1, 0])),
                (VTK_QUADRATIC_TETRA, tetrahedron([0.2, 0, 0])),
            ]
        )
        found = self.evaluate(path, ["Volume", "MinJacobian", "MinDihedralAngle", "IsValid"])
        numpy.testing.assert_allclose(found["Volume"], [1 / 6, 1 / 6, 0.15, 1 / 6], rtol=1e-13)
        numpy.testing.assert_allclose(
            found["MinJacobian"], [1 / 6, 1 / 6, 0.1, -0.2 / 6], rtol=1e-13
        )
        self.assertEqual(len(set(found["MinDihedralAngle"])), 1)
        numpy.testing.assert_array_equal(found["IsValid"], [1, 1, 1, 0])
        numpy.testing.assert_array_equal(found["Volume_Undefined"], [0, 0, 0, 0])
        numpy.testing.assert_array_equal(found["IsValid_Undefined"], [0, 0, 0, 0])
        numpy.testing.assert_array_equal(
            found["MinDihedralAngle_Undefined"], [0, REASON, REASON, REASON]
        )

    def test_rational(self):
        """All criteria of a rational Bezier triangle are those of its vertices, and say so."""
        nodes = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.5, 0.2, 0], [0.5, 0.5, 0], [0, 0.5, 0]]
        cells = [(VTK_BEZIER_TRIANGLE, nodes)]
        plain = self.evaluate(self.write(cells, weights=[1] * 6), ["Area"])
        rational = self.evaluate(self.write(cells, "rational.vtu", [1, 1, 1, 0.5, 1, 1]), ["Area"])
        self.assertAlmostEqual(plain["Area"][0], 0.5 - 0.2 / 3, 13)
        self.assertEqual(plain["Area_Undefined"][0], 0)
        self.assertAlmostEqual(rational["Area"][0], 0.5, 13)
        self.assertEqual(rational["Area_Undefined"][0], REASON)

    def test_pyramid(self):
        """All criteria of a Lagrange pyramid are those of its vertices, and say so; a line has none."""
        corners = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0.5, 1]]
        middles = [[0.5, 0.5, 0.3 * i / 9] for i in range(9)]
        line = [[3, 0, 0], [4, 0, 0], [3.5, 0.2, 0]]
        path = self.write([(VTK_LAGRANGE_PYRAMID, corners + middles), (VTK_QUADRATIC_EDGE, line)])
        found = self.evaluate(path, ["Volume", "MinEdgeLength", "CellStatus"])
        self.assertAlmostEqual(found["Volume"][0], 1 / 3, 13)
        for name in ("Volume", "MinEdgeLength"):
            self.assertTrue(numpy.isnan(found[name][1]), name)
            self.assertEqual(found[name + "_Undefined"].tolist(), [REASON, 1], name)
        self.assertEqual(found["CellStatus"].tolist(), [0, 0])

    def test_degenerate_forms(self):
        """A quadratic wedge as a hexahedron, as in meshes from decks, is a wedge, and is valid."""
        bottom = numpy.array(
            [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.5, -0.1, 0], [0.5, 0.5, 0], [0, 0.5, 0]]
        )
        top = bottom + [0, 0, 1]
        upright = bottom[:3] + [0, 0, 0.5]
        points = numpy.concatenate([bottom, top, upright])
        hexahedron = [0, 1, 2, 2, 6, 7, 8, 8, 3, 4, 2, 5, 9, 10, 8, 11, 12, 13, 14, 14]
        grid = vtkUnstructuredGrid()
        grid.SetPoints(vtkPoints())
        for point in points:
            grid.GetPoints().InsertNextPoint(point)
        grid.InsertNextCell(VTK_QUADRATIC_HEXAHEDRON, 20, hexahedron)
        writer = vtkXMLUnstructuredGridWriter()
        path = self.folder / "wedge.vtu"
        writer.SetFileName(str(path))
        writer.SetInputData(grid)
        writer.Write()
        names = ["Volume", "JacobianRatio", "CellFamilyId", "IsValid", "MinEdgeLength"]
        found = self.evaluate(path, names)
        self.assertAlmostEqual(found["Volume"][0], 0.5 + 0.2 / 3, 7)  # of single precision
        self.assertAlmostEqual(found["JacobianRatio"][0], 1 / 1.4, 3)
        self.assertEqual([found[name][0] for name in names[2:]], [VTK_WEDGE, 1, 1])
        self.assertFalse(any(found[name + "_Undefined"].any() for name in names[:2]))

    def test_commands(self):
        """A folded cell fails in a check, and a report says what is of the vertices."""
        cells = [(VTK_TETRA, CORNERS + [3 * i, 0, 0]) for i in range(3)]
        cells += [(VTK_QUADRATIC_TETRA, tetrahedron([0.2, 0, 0]) + [0, 3, 0])]
        path = self.write(cells)
        (rule,) = camaron.check(path, ["JacobianRatio > 0"])["checks"]
        self.assertEqual((rule["failing"], rule["checked"]), (1, 4))
        found = camaron.check(path, preset="FEM second order")["checks"]
        self.assertEqual(
            {c["criterion"]: c["failing"] for c in found},
            {
                "JacobianRatio": 1,
                "MinInverseConditionNumber": 1,
                "MidsideNodeOffsetAlongEdge": 1,
                "MidsideNodeOffsetFromEdge": 0,
            },
        )
        summary = camaron.inspect(
            path,
            self.folder / "report",
            criteria=["Volume", "MinDihedralAngle"],
            with_pictures=False,
            with_mesh=False,
        )
        self.assertEqual(summary["mesh"]["higher_order"], 1)
        self.assertEqual([c["of_vertices"] for c in summary["criteria"]], [0, 1])
        note = "Evaluated only for the vertices of 1 higher-order cell: MinDihedralAngle."
        self.assertIn(note, summary["notes"])
        report = (self.folder / "report" / "report.html").read_text(encoding="utf-8")
        self.assertIn(note, report)
        self.assertEqual(report.count("of the vertices of higher-order cells"), 1)
        self.assertEqual(len(summary["notes"]), 1)
        corners = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0.5, 1]]
        pyramid = (VTK_LAGRANGE_PYRAMID, corners + [[0.5, 0.5, 0.1]] * 9)
        tetrahedra = [(VTK_LAGRANGE_TETRAHEDRON, tetrahedron([0.5, 0, 0]))] * 2
        options = {"with_pictures": False, "with_mesh": False}
        for cells, by_vertices in ((tetrahedra, 0), ([*tetrahedra, pyramid], 1)):
            found = camaron.inspect(
                self.write(cells),
                self.folder / "lagrange",
                criteria=["Volume", "MinDihedralAngle"],
                **options,
            )
            self.assertEqual(found["mesh"]["higher_order_by_vertices"], by_vertices)
            self.assertEqual(
                [c["of_vertices"] for c in found["criteria"]], [by_vertices, len(cells)]
            )
            self.assertEqual("degree above 4" in " ".join(found["notes"]), by_vertices > 0)

    def test_decks(self):
        """Real decks have no folded cell; a copy with a node moved over its corner has some."""
        folder = self.data("ansys_cdb")
        for name in (
            "archive_all_solid_cells.cdb",
            "archive_mixed_missing_midside.cdb",
            "archive_sector.cdb",
            "dev_mixed_blocked_Dexp.cdb",
        ):
            with self.subTest(name):
                (rule,) = camaron.check(folder / name, ["JacobianRatio > 0"])["checks"]
                self.assertGreater(rule["checked"], 0)
                self.assertEqual(rule["failing"], 0)
        healthy = simple.OpenDataFile(str(folder / "archive_mixed_missing_midside.cdb"))
        healthy.UpdatePipeline()
        grid = servermanager.Fetch(healthy)
        while not grid.IsA("vtkUnstructuredGrid"):
            grid = grid.GetBlock(0)
        cell = next(
            i for i in range(grid.GetNumberOfCells()) if grid.GetCellType(i) == VTK_QUADRATIC_TETRA
        )
        ids = grid.GetCell(cell).GetPointIds()
        a, b, middle = (numpy.array(grid.GetPoint(ids.GetId(i))) for i in (0, 1, 4))
        grid.GetPoints().SetPoint(ids.GetId(4), a + 0.1 * (b - a))
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetFileName(str(self.folder / "folded.vtu"))
        writer.SetInputData(grid)
        writer.Write()
        (rule,) = camaron.check(self.folder / "folded.vtu", ["JacobianRatio > 0"])["checks"]
        self.assertGreater(rule["failing"], 0)


if __name__ == "__main__":
    camaron_testing.main()
