# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Integers of 64 bits that no double is are told apart in statistics and selections."""

import camaron_testing
import gallery
import mesh_parts
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON

LIMITS = {
    numpy.int64: (2**53, -(2**53) - 9, 2**62 - 3, 2**63 - 9, -(2**63) + 1),
    numpy.uint64: (2**53, 2**63 - 4, 2**64 - 9),
}
STEPS = [0, 1, 2, 3, 3, 5]


def make_mesh(values, kind):
    points, cubes = gallery.lattice(len(values), 1, 1)
    grid = gallery.make_grid(points, [(VTK_HEXAHEDRON, cube) for cube in cubes])
    array = numpy_to_vtk(numpy.array(values, kind), deep=1)
    array.SetName("snow")
    grid.GetCellData().AddArray(array)
    return mesh_parts.producer(grid)


class TestLongIntegers(camaron_testing.TestCase):
    def select(self, source, **properties):
        selected = simple.SelectElements(Input=source, Array="snow", **properties)
        marks = vtk_to_numpy(self.fetch(selected).GetCellData().GetArray("Selected"))
        return numpy.flatnonzero(marks).tolist()

    def between(self, source, low, high):
        return self.select(
            source,
            Strategy="By criterion",
            Range="Custom",
            LowerLimit=str(low),
            UpperLimit=str(high),
            Side="Inside",
        )

    def test_extremes(self):
        for kind, starts in LIMITS.items():
            for start in starts:
                for order in (STEPS, STEPS[::-1], [3, 5, 0, 3, 1, 2]):
                    values = [start + step for step in order]
                    source = make_mesh(values, kind)
                    table = self.fetch(simple.QualityStatistics(Input=source, Arrays=["snow"]))
                    found = [
                        table.GetColumnByName(name).GetValue(0)
                        for name in ("ArgMin", "ArgMax", "Sum", "Mean")
                    ]
                    expected = [order.index(0), order.index(5), float(sum(values))]
                    self.assertEqual(found[:3], expected, values)
                    self.assertEqual(found[3], sum(values) / 6, values)

    def test_worst(self):
        for kind, starts in LIMITS.items():
            for start in starts:
                source = make_mesh([start + step for step in STEPS], kind)
                for count, expected in ((1, [5]), (2, [3, 5]), (3, [3, 4, 5]), (5, [1, 2, 3, 4, 5])):
                    found = self.select(source, Strategy="Worst N", NumberOfWorst=count, WorstValues="Largest")
                    self.assertEqual(found, expected, start)
                found = self.select(source, Strategy="Worst N", NumberOfWorst=2, WorstValues="Smallest")
                self.assertEqual(found, [0, 1], start)

    def test_selection(self):
        for kind, starts in LIMITS.items():
            for start in starts:
                source = make_mesh([start + step for step in STEPS], kind)
                self.assertEqual(self.between(source, start + 1, start + 1), [1], start)
                self.assertEqual(self.between(source, start + 3, start + 4), [3, 4], start)
                self.assertEqual(self.between(source, start + 4, start + 4), [], start)
                self.assertEqual(self.between(source, start + 2, ""), [2, 3, 4, 5], start)
                self.assertEqual(self.between(source, "", start + 1), [0, 1], start)

    def test_reported_file(self):
        source = self.open(self.data("reports/integers_beyond_2_53.vtu"))
        table = self.fetch(simple.QualityStatistics(Input=source, Arrays=["snow"]))
        self.assertEqual(table.GetColumnByName("ArgMax").GetValue(0), 5)
        self.assertEqual(len(self.between(source, 2**53 + 1, 2**53 + 1)), 1)


camaron_testing.main()
