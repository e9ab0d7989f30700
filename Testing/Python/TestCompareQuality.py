# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compare Quality against numpy: the same numbers on any number of ranks, with and without ghosts."""

import math

import camaron_testing
import mesh_parts
import numpy
from camaron.common import pipeline, tables
from paraview import servermanager, simple
from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkStringArray

RATIO, SKEWNESS, SIZE = "EdgeLengthRatio", "EquiangleSkewness", "Volume"
WHOLE = mesh_parts.make_values(mesh_parts.make_mesh().GetNumberOfCells())


def changed(values):
    """What `change` makes of the values of EdgeLengthRatio."""
    return numpy.where(values > 0.5, values, 0.9 * values)


def change(source):
    # Not by Calculator, whose parsers of several threads get in each other's way now and then.
    return simple.PythonCalculator(
        Input=source,
        ArrayAssociation="Cell Data",
        ArrayName=RATIO,
        Expression=f"{RATIO}*(0.9 + 0.1*({RATIO} > 0.5))",
    )


def distance(a, b):
    """By definition: the largest difference of the fractions of values up to each value."""
    a, b = numpy.sort(a[~numpy.isnan(a)]), numpy.sort(b[~numpy.isnan(b)])
    places = numpy.unique(numpy.concatenate([a, b]))
    shares = [numpy.searchsorted(data, places, side="right") / len(data) for data in (a, b)]
    difference = numpy.abs(shares[0] - shares[1])
    return difference.max(), places[difference.argmax()]


class TestCompareQuality(camaron_testing.TestCase):
    def compare(self, a, b, **properties):
        # Ranges of one's own are for all cells.
        ranges = self.folder / "ranges.txt"
        ranges.write_text(f"{RATIO} 0.3333 *\n{SKEWNESS} * 0.9\n")
        properties.setdefault("RangesFile", str(ranges))
        comparison = simple.CompareQuality(Input=a, Other=b, **properties)
        comparison.UpdatePipeline()
        rows = {row["Criterion"]: row for row in tables.fetch(comparison)}
        return comparison, rows, tables.fetch(comparison, 1)

    def check_row(self, row, a, b):
        for mesh, values in (("A", a), ("B", b)):
            finite = values[numpy.isfinite(values)]
            self.assertEqual(row["Count" + mesh], len(values))
            self.assertEqual(row["UndefinedCount" + mesh], numpy.isnan(values).sum())
            self.assertEqual(row["InfiniteCount" + mesh], numpy.isinf(values).sum())
            self.assertEqual(row["Min" + mesh], finite.min())
            self.assertEqual(row["P95" + mesh], numpy.percentile(finite, 95))
            mean = math.fsum(finite) / len(finite)
            self.assertAlmostEqual(row["Mean" + mesh] / mean, 1, delta=1e-14)
            bad = (values < row["AcceptableLow"]) | (values > row["AcceptableHigh"])
            self.assertEqual(row["OutOfRangeCount" + mesh], bad.sum())
        for name in ("Count", "UndefinedCount", "Min", "Mean", "P50", "OutOfRangePercent"):
            self.assertEqual(row[name + "Difference"], row[name + "B"] - row[name + "A"])
        expected, where = distance(a, b)
        self.assertAlmostEqual(row["Distance"], expected, delta=1e-15)
        if expected:
            self.assertEqual(row["DistanceValue"], where)

    def test_same_cells(self):
        """Cells are matched one by one; ghosts have differences but do not count."""
        a, b = WHOLE[RATIO], changed(WHOLE[RATIO])
        for options in ({}, {"ghost_layer": 40}, {"empty_rank": True}, {"global_ids": True}):
            source = mesh_parts.split_source(**options)
            comparison, rows, _ = self.compare(source, change(source))
            with self.subTest(**options):
                self.assertEqual(set(rows), {SIZE, RATIO, SKEWNESS, "FaceCount"})
                self.check_row(rows[RATIO], a, b)
                row = rows[RATIO]
                self.assertEqual(row["SameCells"], 1)
                self.assertEqual(row["ComparedCount"], (~numpy.isnan(a)).sum())
                self.assertEqual(row["WorsenedCount"], (b < a).sum())
                self.assertEqual(row["UnchangedCount"], (a == b).sum())
                self.assertEqual(row["ImprovedCount"], 0)
                self.assertEqual(rows[SIZE]["Distance"], 0)
                self.assertEqual(rows[SIZE]["UnchangedCount"], len(a))
                self.check_deltas(comparison)

    def check_deltas(self, comparison):
        """Of the cells that this rank has."""
        mesh = comparison.GetClientSideObject().GetOutputDataObject(2)
        data = dataset_adapter.WrapDataObject(mesh).CellData
        if mesh.GetNumberOfCells():
            cells = numpy.asarray(data["Number"])
            expected = changed(WHOLE[RATIO]) - WHOLE[RATIO]
            numpy.testing.assert_array_equal(data[RATIO + "_Delta"], expected[cells])
            infinite = WHOLE[SKEWNESS][cells]
            numpy.testing.assert_array_equal(data[SKEWNESS + "_Delta"], 0 * numpy.isinf(infinite))

    def test_other_cells(self):
        """Without the same cells there are distributions only; B is passed on as it is."""
        source = mesh_parts.split_source(ghost_layer=30)
        part = simple.Threshold(Input=source, Scalars=["CELLS", "Number"])
        part.LowerThreshold, part.UpperThreshold = 100, 500
        comparison, rows, histogram = self.compare(
            source, part, Arrays=[RATIO, SKEWNESS, SIZE, "Single"], NumberOfBins=13
        )
        for name in (RATIO, SKEWNESS, SIZE):
            self.check_row(rows[name], WHOLE[name], WHOLE[name][100:501])
        self.assertEqual({row["SameCells"] for row in rows.values()}, {0})
        self.assertEqual(rows[RATIO]["ComparedCount"], 0)
        arrays = servermanager.OutputPort(comparison, 2).GetDataInformation()
        names = arrays.GetCellDataInformation()
        self.assertIsNotNone(names.GetArrayInformation(RATIO))
        self.assertIsNone(names.GetArrayInformation(RATIO + "_Delta"))
        for name in (RATIO, SKEWNESS, "Single"):
            bins = [row for row in histogram if row["Criterion"] == name]
            self.assertEqual(len(bins), 13)
            edges = [row["LowerEdge"] for row in bins] + [bins[-1]["UpperEdge"]]
            for mesh, values in (("A", WHOLE[name]), ("B", WHOLE[name][100:501])):
                values = values.astype(float)
                counts = numpy.histogram(values[numpy.isfinite(values)], edges)[0]
                self.assertEqual([row["Count" + mesh] for row in bins], counts.tolist())
                known = (~numpy.isnan(values)).sum()
                self.assertEqual(
                    [row["Fraction" + mesh] for row in bins], (counts / known).tolist()
                )

    def test_redistributed(self):
        """The same mesh elsewhere has the same distributions."""
        source = mesh_parts.split_source(global_ids=True)
        moved = simple.RedistributeDataSet(Input=source, GenerateGlobalCellIds=0)
        _, rows, histogram = self.compare(source, change(moved))
        self.check_row(rows[RATIO], WHOLE[RATIO], changed(WHOLE[RATIO]))
        self.assertEqual(rows[SIZE]["Distance"], 0)
        for row in histogram:
            if row["Criterion"] == SIZE:
                self.assertEqual(row["CountA"], row["CountB"])

    def test_blocks(self):
        """Blocks are matched by their place; the sizes of all blocks count together."""

        def blocks(first, second):
            return simple.GroupDatasets(
                Input=[first, second], OutputType="vtkPartitionedDataSetCollection"
            )

        source = mesh_parts.split_source()
        _, rows, _ = self.compare(blocks(source, source), blocks(source, change(source)))
        a = numpy.concatenate([WHOLE[RATIO], WHOLE[RATIO]])
        b = numpy.concatenate([WHOLE[RATIO], changed(WHOLE[RATIO])])
        self.check_row(rows[RATIO], a, b)
        self.assertEqual(rows[RATIO]["WorsenedCount"], (b < a).sum())
        _, rows, _ = self.compare(blocks(source, source), source)
        self.check_row(rows[RATIO], a, WHOLE[RATIO])
        self.assertEqual(rows[RATIO]["SameCells"], 0)

    def test_groups(self):
        """Groups of both meshes, each cell in its group there; the same bins for all."""
        material = WHOLE["Material"]
        for options in ({}, {"ghost_layer": 40}, {"empty_rank": True}):
            source = mesh_parts.split_source(**options)
            other = simple.Calculator(
                Input=change(source),
                AttributeType="Cell Data",
                ResultArrayName="Material",
                ReplaceInvalidResults=0,
                Function="if(Material > 0, Material + 1, Material)",
            )
            comparison, _, histogram = self.compare(
                source, other, Arrays=[RATIO], GroupBy="Cell array", GroupArray="Material"
            )
            table = tables.fetch(comparison)
            moved = numpy.where(material > 0, material + 1, material)
            a, b = WHOLE[RATIO], changed(WHOLE[RATIO])
            if table:
                self.assertEqual([row["Group"] for row in table], ["All", *map(str, range(-3, 5))])
                self.check_row(table[0], a, b)
            for row in table[1:]:
                with self.subTest(group=row["Group"], **options):
                    ours, theirs = material == int(row["Group"]), moved == int(row["Group"])
                    if ours.any() and theirs.any():
                        self.check_row(row, a[ours], b[theirs])
                    self.assertEqual((row["CountA"], row["CountB"]), (ours.sum(), theirs.sum()))
                    self.assertEqual(row["WorsenedCount"], (b < a)[theirs].sum())
                    bins = [r for r in histogram if r["Group"] == row["Group"]]
                    self.assertEqual(len(bins), 50)
                    self.assertEqual(
                        [r["LowerEdge"] for r in bins], [r["LowerEdge"] for r in histogram[:50]]
                    )
                    counts = numpy.array([r["CountA"] for r in bins])
                    self.assertEqual(counts.sum(), (~numpy.isnan(a[ours])).sum())

    def test_groups_by_name(self):
        """Blocks, texts and zones of both meshes correspond by name, whatever their numbers."""
        sizes = {"All": 5, "1": 3, "y": 7, "z": 4}
        whole = mesh_parts.make_full_mesh()

        def mesh(names):
            known = vtkStringArray()
            known.SetName("ZoneNames")
            for name in names:
                known.InsertNextValue(name)
            blocks = []
            for number, name in enumerate(names):
                block = mesh_parts.extract(whole, 0, sizes[name])
                texts = vtkStringArray()
                texts.SetName("Part")
                for _ in range(sizes[name]):
                    texts.InsertNextValue(name)
                ids = numpy_to_vtk(numpy.arange(10, 10 + len(names)), deep=True)
                ids.SetName("ZoneIds")
                zone = numpy_to_vtk(numpy.full(sizes[name], 10 + number), deep=True)
                zone.SetName("Zone")
                block.GetFieldData().AddArray(known)
                block.GetFieldData().AddArray(ids)
                block.GetCellData().AddArray(texts)
                block.GetCellData().AddArray(zone)
                blocks.append(mesh_parts.producer(block))
            return simple.GroupDatasets(Input=blocks, BlockNames=list(names))

        by_text = {"GroupBy": "Cell array", "GroupArray": "Part"}
        by_zone = {"GroupBy": "Cell array", "GroupArray": "Zone"}
        for names, options, expected in (
            (("1y", "yz1"), {"GroupBy": "Block"}, {"1": (3, 3), "y": (7, 7), "z": (0, 4)}),
            (("1y", "yz1"), by_text, {"1": (3, 3), "y": (7, 7), "z": (0, 4)}),
            (("1y", "yz1"), by_zone, {"1": (3, 3), "y": (7, 7), "z": (0, 4)}),
            (("yy", "y"), {"GroupBy": "Block"}, {"y (1)": (7, 0), "y (2)": (7, 0), "y": (0, 7)}),
            (
                (["All", "y"], ["1", "All"]),
                by_text,
                {"All (text)": (5, 5), "1": (0, 3), "y": (7, 0)},
            ),
            ((["All", "y"], ["All"]), {"GroupBy": "Block"}, {"All (1)": (5, 5), "y": (7, 0)}),
        ):
            comparison, _, _ = self.compare(*map(mesh, names), Arrays=[SIZE], **options)
            table = tables.fetch(comparison)
            if not table:
                self.assertGreater(camaron_testing.rank_count(), 1)
                continue  # only rank 0 has rows
            found = [(r["Group"], r["CountA"], r["CountB"]) for r in table[1:]]
            with self.subTest(names=names, **options):
                self.assertEqual(
                    sorted(found), sorted((n, *counts) for n, counts in expected.items())
                )

    def test_all_time_steps(self):
        """Rows of each step are those of the step alone; the mesh is that of the last one."""
        moving = simple.TimeSource(Growing=1)
        moving.UpdatePipelineInformation()
        times = list(moving.TimestepValues)
        numbered = simple.PointAndCellIds(Input=simple.Wavelet())
        still = simple.Calculator(
            Input=numbered,
            AttributeType="Cell Data",
            ResultArrayName="Cell Value",
            Function="sin(CellIds)",
        )
        for pair in ((moving, still), (still, moving), (moving, moving)):
            properties = {"Input": pair[0], "Other": pair[1], "Arrays": ["Cell Value"]}
            every = simple.CompareQuality(AllTimeSteps=1, **properties)
            one = simple.CompareQuality(**properties)
            every.UpdatePipeline(times[2])
            self.assertFalse(hasattr(every, "TimestepValues"))
            for port in range(2):
                found = tables.fetch(every, port)
                for time in times if found else []:
                    one.UpdatePipeline(time)
                    expected = tables.fetch(one, port)
                    here = [
                        {k: v for k, v in row.items() if k != "Time"}
                        for row in found
                        if row["Time"] == time
                    ]
                    self.assertEqual(str(here), str(expected))
            one.UpdatePipeline(times[-1])
            counts = [
                simple.OutputPort(f, 2).GetDataInformation().GetNumberOfCells()
                for f in (every, one)
            ]
            self.assertEqual(counts[0], counts[1])

    def test_moved_points(self):
        """The points may be elsewhere: smoothing is what people compare."""
        tetrahedra = simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[0, 6, 0, 6, 0, 6]))
        stretched = simple.Transform(Input=tetrahedra)
        stretched.Transform.Scale = [1, 1, 3]
        criteria = ["EdgeLengthRatio", "Volume", "MinDihedralAngle"]
        qualities = [simple.ElementQuality(Input=s) for s in (tetrahedra, stretched)]
        for quality in qualities:
            quality.Criteria = criteria
        _, rows, _ = self.compare(*qualities)
        self.assertEqual({row["SameCells"] for row in rows.values()}, {1})
        self.assertAlmostEqual(rows["Volume"]["MeanB"] / rows["Volume"]["MeanA"], 3, delta=1e-12)
        cells = rows["MinDihedralAngle"]["CountA"]
        self.assertEqual(rows["MinDihedralAngle"]["WorsenedCount"], cells)
        self.assertEqual(rows["Volume"]["ImprovedCount"], 0)
        self.assertEqual(rows["Volume"]["UnchangedCount"], 0)
        self.assertEqual(rows["Volume"]["Distance"], 1)

    def test_messages(self):
        source = mesh_parts.split_source()
        with pipeline.Messages() as messages:
            self.compare(source, source, Arrays=["Volume", "NotThere"])
        if pipeline.servermanager.vtkProcessModule.GetProcessModule().GetPartitionId() == 0:
            self.assertIn("NotThere", messages.warnings[0])
        comparison = simple.CompareQuality(Input=source, Other=source)
        comparison.SMProxy.GetProperty("HistogramScale").SetElement(0, "Cubic")
        comparison.SMProxy.UpdateVTKObjects()
        with pipeline.Messages() as messages:
            comparison.UpdatePipeline()
        self.assertIn("not 'Cubic'", messages.errors[0])
        for properties, reason in (
            ({"Tolerance": math.nan}, "Tolerance must be 0 to 1, not nan"),
            ({"NumberOfBins": 0}, "Number Of Bins must be 1 to 100000, not 0"),
        ):
            with pipeline.Messages() as messages:
                simple.CompareQuality(Input=source, Other=source, **properties).UpdatePipeline()
            self.assertIn(reason, messages.errors[0])


if __name__ == "__main__":
    camaron_testing.main()
