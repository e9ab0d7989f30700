# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Commands read no ghost cells, which would be most of a mesh whose cells have no spatial order; ParaView still does."""

import camaron_testing
import numpy
from camaron import inspect
from camaron.common import pipeline
from camaron.common.evaluation import Evaluation
from paraview import simple

SIZE = 12  # cubes in a row


def write_tetrahedra(path):
    """Tetrahedra of cubes, in an order that has nothing to do with their place."""
    number = lambda x, y, z: x + (SIZE + 1) * (y + (SIZE + 1) * z)
    grid = numpy.mgrid[0 : SIZE + 1, 0 : SIZE + 1, 0 : SIZE + 1].reshape(3, -1)[::-1].T
    cells = []
    for x, y, z in numpy.ndindex(SIZE, SIZE, SIZE):
        for i, j in ((1, 3), (3, 2), (2, 6), (6, 4), (4, 5), (5, 1)):
            corner = lambda n: number(x + (n & 1), y + (n >> 1 & 1), z + (n >> 2))
            cells.append((10, [corner(0), corner(i), corner(j), corner(7)]))
    order = numpy.random.default_rng(1).permutation(len(cells))
    return camaron_testing.write_vtk(path, grid.tolist(), [cells[i] for i in order])


class TestGhostRequests(camaron_testing.TestCase):
    def setUp(self):
        super().setUp()
        vtk = write_tetrahedra(self.folder / "mesh.vtk")
        self.mesh = self.folder / "mesh.visf"
        simple.SaveData(str(self.mesh), proxy=self.open(vtk))
        self.cells = 6 * SIZE**3

    def count(self, source):
        return pipeline.data_information(source).GetNumberOfCells()

    def test_evaluation(self):
        """No cell is read twice, also where neighbors are asked for; afterwards ParaView asks again."""
        with Evaluation(self.mesh) as evaluated:
            self.assertEqual(self.count(evaluated.opened.source), self.cells)
            evaluated.quality.Criteria = ["Volume", "MaxNonOrthogonality"]
            evaluated.quality.UpdatePipeline()
            self.assertEqual(self.count(evaluated.quality), self.cells)
            self.assertEqual(self.count(evaluated.opened.source), self.cells)
        source = self.open(self.mesh)
        if pipeline.rank_count() > 1:
            self.assertGreater(self.count(source), self.cells)

    def test_same_report(self):
        """The reported memory is that of the mesh without ghosts."""
        summary = inspect(
            self.mesh, self.folder / "report", criteria=["MaxNonOrthogonality"], with_pictures=False
        )
        self.assertEqual(summary["mesh"]["cells"], self.cells)
        self.assertEqual(summary["mesh"]["boundary_faces"], 12 * SIZE**2)
        self.assertAlmostEqual(summary["mesh"]["volume"], SIZE**3)
        # Ids and coordinates of the mesh, and what each further piece has of points once more.
        self.assertLess(summary["mesh"]["memory"], 650_000 + 80_000 * pipeline.rank_count())


camaron_testing.main()
