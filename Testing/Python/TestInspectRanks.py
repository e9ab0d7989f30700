# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""camaron.inspect distributes the mesh and has the numbers of the whole one."""

import os

import camaron_testing
import numpy
from camaron import inspect
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkFiltersGeneral import vtkImageDataToPointSet
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkIOXML import vtkXMLDataSetWriter, vtkXMLMultiBlockDataWriter

BALL = camaron_testing.EXAMPLES / "voronoi-ball.visf"


class TestInspectRanks(camaron_testing.TestCase):
    def test_numbers(self):
        """Counts, extremes, quantiles, bins and worst cells are those that the file implies."""
        points, faces, cells = camaron_testing.read_visf(BALL)
        ratios = []
        for cell in cells:
            edges = {
                frozenset(edge): numpy.linalg.norm(points[edge[0]] - points[edge[1]])
                for f in cell
                for edge in zip(faces[f], faces[f][1:] + faces[f][:1])
            }
            ratios.append(min(edges.values()) / max(edges.values()))
        summary = inspect(
            BALL, self.folder / "report", with_pictures=bool(os.environ.get("DISPLAY"))
        )
        by_name = {c["name"]: c for c in summary["criteria"]}
        ratio = by_name["EdgeLengthRatio"]
        self.assertEqual((ratio["count"], ratio["undefined"]), (len(cells), 0))
        for percent, value in ratio["quantiles"].items():
            self.assertAlmostEqual(value, numpy.percentile(ratios, float(percent)), places=9)
        self.assertAlmostEqual(ratio["mean"], numpy.mean(ratios), places=9)
        # Bins by the filter's own edges: an edge is a value of the data, rounded otherwise here.
        edges = numpy.array(ratio["histogram"]["edges"])
        edges[[0, -1]] += [-1e-9, 1e-9]
        self.assertEqual(ratio["histogram"]["counts"], numpy.histogram(ratios, edges)[0].tolist())
        self.assertEqual(
            [w["id"] for w in ratio["worst"]], numpy.argsort(ratios, kind="stable")[:10].tolist()
        )
        self.assertEqual(by_name["FaceCount"]["sum"], sum(len(cell) for cell in cells))

    def test_facts(self):
        """The mesh is counted once, however it is cut into pieces."""
        points, _, cells = camaron_testing.read_visf(BALL)
        mesh = inspect(BALL, self.folder / "report", criteria=["Volume"], with_pictures=False)[
            "mesh"
        ]
        uses = numpy.bincount([f for cell in cells for f in cell])
        self.assertEqual((mesh["points"], mesh["cells"]), (len(points), len(cells)))
        self.assertEqual(mesh["cell_types"], [{"name": "polyhedra", "count": len(cells)}])
        self.assertEqual(mesh["boundary_faces"], int((uses == 1).sum()))

    def test_written_mesh(self):
        """The mesh with the arrays is whole and can be read again."""
        summary = inspect(BALL, self.folder / "report", criteria=["Volume"], with_pictures=False)
        written = self.open(self.folder / "report" / summary["files"]["mesh"])
        data = written.GetDataInformation()
        self.assertEqual(data.GetNumberOfCells(), 800)
        low, high = written.CellData["Volume"].GetRange()
        volume = summary["criteria"][0]
        self.assertEqual((low, high), (volume["min"], volume["max"]))

    def test_structured_data(self):
        """An image is counted once, and written without ghost cells, as is a structured grid."""
        image = vtkRTAnalyticSource()
        image.SetWholeExtent(0, 6, 0, 3, 0, 2)
        grid = vtkImageDataToPointSet()
        grid.SetInputConnection(image.GetOutputPort())
        for source, name in (image, "i.vti"), (grid, "s.vts"):
            writer = vtkXMLDataSetWriter()
            writer.SetInputConnection(source.GetOutputPort())
            writer.SetFileName(str(self.folder / name))
            writer.Write()
            summary = inspect(self.folder / name, self.folder / name[0], with_pictures=False)
            self.assertEqual((summary["mesh"]["points"], summary["mesh"]["cells"]), (84, 36))
            written = summary["files"]["mesh"]
            again = inspect(self.folder / name[0] / written, self.folder / "a", with_mesh=False)
            self.assertEqual((again["mesh"]["points"], again["mesh"]["cells"]), (84, 36))
        blocks = vtkMultiBlockDataSet()
        for i, source in enumerate((image, grid)):
            blocks.SetBlock(i, source.GetOutput())
        writer = vtkXMLMultiBlockDataWriter()
        writer.SetInputData(blocks)
        writer.SetFileName(str(self.folder / "b.vtm"))
        writer.Write()
        both = inspect(self.folder / "b.vtm", self.folder / "b", with_pictures=False)["mesh"]
        self.assertEqual((both["points"], both["cells"], both["blocks"]), (168, 72, 2))


if __name__ == "__main__":
    camaron_testing.main()
