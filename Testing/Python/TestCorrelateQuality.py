# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Correlate Quality against numpy: the same numbers on any number of ranks, with and without ghosts."""

import math

import camaron_testing
import mesh_parts
import numpy
from camaron.common import pipeline, tables
from paraview import simple
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_TETRA

GRID = mesh_parts.make_mesh()
WHOLE = {
    name: data.astype(float)
    for name, data in mesh_parts.make_values(GRID.GetNumberOfCells()).items()
}
POINTS = vtk_to_numpy(GRID.GetPoints().GetData())
EVERYWHERE = numpy.full(GRID.GetNumberOfCells(), True)
#: Cells for whose shapes the acceptable range of a criterion is, where these are not all.
JUDGED = {"EdgeLengthRatio": mesh_parts.are_of_type(VTK_TETRA)}
CELLS = [
    [GRID.GetCell(i).GetPointId(k) for k in range(GRID.GetCell(i).GetNumberOfPoints())]
    for i in range(GRID.GetNumberOfCells())
]
OPTIONS = ({}, {"ghost_layer": 40}, {"empty_rank": True}, {"global_ids": True})


def ranks(values):
    """From 1, equal values share the mean of theirs."""
    _, places, counts = numpy.unique(values, return_inverse=True, return_counts=True)
    return (numpy.cumsum(counts) - (counts - 1) / 2)[places]


def pearson(x, y):
    x, y = x - math.fsum(x) / len(x), y - math.fsum(y) / len(y)
    x, y = x / numpy.abs(x).max(), y / numpy.abs(y).max()
    return math.fsum(x * y) / math.sqrt(math.fsum(x * x) * math.fsum(y * y))


def expected(quality, field):
    """Number of pairs, Pearson of finite pairs, Spearman of all."""
    both = ~numpy.isnan(quality) & ~numpy.isnan(field)
    finite = numpy.isfinite(quality) & numpy.isfinite(field)
    spearman = pearson(ranks(quality[both]), ranks(field[both]))
    return both.sum(), pearson(quality[finite], field[finite]), spearman


class TestCorrelateQuality(camaron_testing.TestCase):
    def correlate(self, source, field, **properties):
        correlation = simple.CorrelateQuality(Input=source, Field=field, **properties)
        correlation.UpdatePipeline()
        return correlation, {row["Criterion"]: row for row in tables.fetch(correlation)}

    def check_row(self, row, field, cells=EVERYWHERE):
        name = row["Criterion"]
        quality, field = WHOLE[name][cells], field[cells]
        count, linear, monotone = expected(quality, field)
        self.assertEqual(row["Count"], count)
        self.assertAlmostEqual(row["Pearson"], linear, delta=1e-12)
        self.assertAlmostEqual(row["Spearman"], monotone, delta=1e-12)
        low, high = row["AcceptableLow"], row["AcceptableHigh"]
        if math.isnan(low):
            return
        known = JUDGED.get(name, EVERYWHERE)[cells] & ~numpy.isnan(quality) & ~numpy.isnan(field)
        bad = known & ((quality < low) | (quality > high))
        good = known & ~bad
        self.assertEqual(row["OutsideCount"], bad.sum())
        if not bad.any() or not good.any():
            self.assertTrue(math.isnan(row["OutsideAbove"]))
            return
        pairs = numpy.sign(field[bad][:, None] - field[good][None, :])
        self.assertAlmostEqual(row["OutsideAbove"], (pairs.mean() + 1) / 2, delta=1e-12)
        for cells, name in ((bad, "Outside"), (good, "Inside")):
            mean = numpy.mean(field[cells])
            self.assertAlmostEqual(row["FieldMean" + name] / mean, 1, delta=1e-10)

    def test_fields_of_cells(self):
        """Ties, undefined and infinite values, and values of all magnitudes."""
        for options in OPTIONS:
            source = mesh_parts.split_source(**options)
            for field in ("Volume", "Single", "Material"):
                _, rows = self.correlate(source, ["CELLS", field])
                with self.subTest(field=field, **options):
                    self.assertEqual(
                        set(rows), {"EdgeLengthRatio", "EquiangleSkewness", "FaceCount", "Volume"}
                    )
                    for row in rows.values():
                        self.check_row(row, WHOLE[field])
            self.assertEqual(rows["FaceCount"]["Field"], "Material_Cells")
        _, rows = self.correlate(
            source, ["CELLS", "Volume"], Arrays=["Volume", "Constant", "AllUndefined"]
        )
        self.assertEqual((rows["Volume"]["Pearson"], rows["Volume"]["Spearman"]), (1, 1))
        for name in ("Constant", "AllUndefined"):
            self.assertTrue(
                math.isnan(rows[name]["Pearson"]) and math.isnan(rows[name]["Spearman"])
            )

    def test_groups(self):
        """Each group by itself, also where cells without a value differ between criteria."""
        material, field = WHOLE["Material"], WHOLE["Single"]
        for options in OPTIONS:
            correlation = simple.CorrelateQuality(
                Input=mesh_parts.split_source(**options),
                Field=["CELLS", "Single"],
                GroupBy="Cell array",
                GroupArray="Material",
            )
            correlation.UpdatePipeline()
            table = tables.fetch(correlation)
            if table:
                groups = [row["Group"] for row in table if row["Criterion"] == "Volume"]
                self.assertEqual(groups, ["All", *map(str, range(-3, 4))])
                self.assertEqual(len(table), 4 * len(groups))
            for row in table:
                group = row["Group"]
                cells = material == int(group) if group != "All" else EVERYWHERE
                with self.subTest(group=group, criterion=row["Criterion"], **options):
                    self.check_row(row, field, cells)

    def test_all_time_steps(self):
        """Rows of each step are those of the step alone."""
        source = simple.TimeSource(Growing=1)
        source.UpdatePipelineInformation()
        properties = {"Input": source, "Field": ["POINTS", "Point Value"], "Arrays": ["Cell Value"]}
        every = simple.CorrelateQuality(AllTimeSteps=1, **properties)
        one = simple.CorrelateQuality(**properties)
        every.UpdatePipeline()
        found = tables.fetch(every)
        for row, time in zip(found, source.TimestepValues):
            one.UpdatePipeline(time)
            self.assertEqual(row.pop("Time"), time)
            self.assertEqual(str(row), str(tables.fetch(one)[0]))

    def with_point_field(self, function, **options):
        return simple.Calculator(
            Input=mesh_parts.split_source(**options), ResultArrayName="T", Function=function
        )

    def check_cells(self, correlation, name, values):
        """The field on the cells that this rank has."""
        mesh = correlation.GetClientSideObject().GetOutputDataObject(1)
        data = dataset_adapter.WrapDataObject(mesh).CellData
        if mesh.GetNumberOfCells():
            expected_values = values[numpy.asarray(data["Number"])]
            numpy.testing.assert_allclose(data[name], expected_values, atol=1e-12, rtol=1e-12)

    def test_fields_of_points(self):
        """A cell has the mean of its points; of vectors the magnitude counts."""
        x, y, z = POINTS.T
        for function, values in (
            ("coordsX*coordsX + 3*coordsY - coordsZ*coordsX", x * x + 3 * y - z * x),
            ("coordsX*iHat + 2*coordsY*jHat", numpy.hypot(x, 2 * y)),
        ):
            means = numpy.array([values[cell].mean() for cell in CELLS])
            for options in OPTIONS:
                source = self.with_point_field(function, **options)
                correlation, rows = self.correlate(source, ["POINTS", "T"])
                with self.subTest(function=function, **options):
                    self.check_cells(correlation, "T_Cells", means)
                    for name in ("EdgeLengthRatio", "EquiangleSkewness"):
                        self.assertAlmostEqual(
                            rows[name]["Pearson"], expected(WHOLE[name], means)[1], delta=1e-12
                        )

    def test_independent_of_ranks(self):
        """Also where cells are shuffled between ranks, all bits are those of the whole mesh."""
        source = self.with_point_field("coordsX*coordsX + sin(coordsY)", global_ids=True)
        moved = simple.RedistributeDataSet(Input=source, GenerateGlobalCellIds=0)
        _, rows = self.correlate(source, ["POINTS", "T"])
        _, others = self.correlate(moved, ["POINTS", "T"])
        self.assertEqual(str(rows), str(others))

    def test_messages(self):
        with pipeline.Messages() as messages:
            simple.CorrelateQuality(
                Input=mesh_parts.split_source(), Field=["CELLS", "None"]
            ).UpdatePipeline()
        self.assertIn("no cell array named 'None'", messages.errors[0])


if __name__ == "__main__":
    camaron_testing.main()
