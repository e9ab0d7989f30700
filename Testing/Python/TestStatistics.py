# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Quality Statistics against numpy, on all kinds of input."""

import math
from fractions import Fraction

import camaron_testing
import mesh_parts
import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON,
    VTK_TETRA,
    vtkImageData,
    vtkMultiBlockDataSet,
)

PERCENTS = [0, 1, 5, 25, 50, 75, 95, 99, 100]


def rows(table):
    """Rows of a vtkTable as dictionaries."""
    columns = [table.GetColumn(i) for i in range(table.GetNumberOfColumns())]
    return [
        {c.GetName(): c.GetValue(row) for c in columns} for row in range(table.GetNumberOfRows())
    ]


class TestStatistics(camaron_testing.TestCase):
    def tables(self, source, **properties):
        statistics = simple.QualityStatistics(Input=source, **properties)
        statistics.UpdatePipeline()
        return [rows(self.fetch(statistics, port)) for port in range(3)]

    def check_statistics(self, row, values, ids=None):
        """A row against numpy; sums and means to the last bit."""
        finite = values[numpy.isfinite(values)]
        ids = numpy.arange(len(values)) if ids is None else ids
        self.assertEqual(row["Count"], len(values))
        self.assertEqual(row["UndefinedCount"], numpy.isnan(values).sum())
        self.assertEqual(row["InfiniteCount"], numpy.isinf(values).sum())
        if len(finite) == 0:
            for name in ("Min", "Max", "Mean", "StdDev", "P50"):
                self.assertTrue(math.isnan(row[name]), name)
            self.assertEqual((row["ArgMin"], row["ArgMax"], row["Sum"]), (-1, -1, 0))
            return
        self.assertEqual(row["Min"], finite.min())
        self.assertEqual(row["Max"], finite.max())
        self.assertEqual(row["ArgMin"], ids[values == finite.min()].min())
        self.assertEqual(row["ArgMax"], ids[values == finite.max()].min())
        total = sum(map(Fraction, finite.tolist()))
        self.assertEqual(row["Mean"], float(total / len(finite)))
        try:
            self.assertEqual(row["Sum"], float(total))
        except OverflowError:
            self.assertTrue(math.isinf(row["Sum"]))
        mean = total / len(finite)
        variance = sum((Fraction(x) - mean) ** 2 for x in finite.tolist()) / (len(finite) - 1)
        # Through logarithms, as the variance of huge values is out of range.
        if variance > 0:
            root = math.isqrt(variance.numerator * 2**4400 // variance.denominator)
            expected = float(Fraction(root, 2**2200))
            self.assertAlmostEqual(row["StdDev"] / expected, 1, delta=1e-12)
        else:
            self.assertEqual(row["StdDev"], 0)
        self.check_higher_moments(row, [Fraction(x) for x in finite.tolist()])
        with numpy.errstate(over="ignore", invalid="ignore"):
            expected = numpy.percentile(finite, PERCENTS)
        for percent, value in zip(PERCENTS, expected):
            if math.isfinite(value):  # numpy overflows where the values are huge
                self.assertEqual(row[f"P{percent}"], value, f"{percent} %")

    def check_higher_moments(self, row, values):
        count, largest = len(values), max(abs(x) for x in values)
        if largest:
            root = math.sqrt(sum((x / largest) ** 2 for x in values) / count)
            self.assertAlmostEqual(row["RootMeanSquare"] / float(largest), root, delta=1e-14)
        if min(values) > 0:
            logarithms = math.fsum(map(math.log, values)) / count
            self.assertAlmostEqual(math.log(row["GeometricMean"]), logarithms, delta=1e-12)
        else:
            self.assertTrue(math.isnan(row["GeometricMean"]))
        values = [x / (largest or 1) for x in values]  # in the range of numbers
        mean = sum(values) / count
        m2, m3, m4 = (sum((x - mean) ** power for x in values) / count for power in (2, 3, 4))
        if m2 == 0:
            self.assertTrue(math.isnan(row["Skewness"]) and math.isnan(row["Kurtosis"]))
        else:
            skewness = math.copysign(math.sqrt(m3**2 / m2**3), m3)
            self.assertAlmostEqual(row["Skewness"], skewness, delta=1e-10 * (1 + abs(skewness)))
            kurtosis = float(m4 / m2**2 - 3)
            self.assertAlmostEqual(row["Kurtosis"], kurtosis, delta=1e-10 * (1 + abs(kurtosis)))

    def check_histogram(self, bins, values):
        """Rows of one array: counts by numpy on the same edges, and nothing lost."""
        finite = values[numpy.isfinite(values)]
        edges = [row["LowerEdge"] for row in bins] + [bins[-1]["UpperEdge"]]
        self.assertEqual(edges, sorted(edges))
        counts = [row["Count"] for row in bins]
        if len(bins) > 1:
            self.assertEqual(counts, numpy.histogram(finite, edges)[0].tolist())
        first = bins[0]
        self.assertEqual(first["Underflow"], (finite < edges[0]).sum())
        self.assertEqual(first["Overflow"], (finite > edges[-1]).sum())
        apart = (
            first["Underflow"]
            + first["Overflow"]
            + first["UndefinedCount"]
            + first["InfiniteCount"]
        )
        self.assertEqual(sum(counts) + apart, len(values))
        self.assertAlmostEqual(
            bins[-1]["CumulativePercent"], 100 * (first["Underflow"] + sum(counts)) / len(values)
        )

    def test_weights(self):
        """Means weighted by volume, and the bad fraction of the volume, with exact sums."""
        grid = mesh_parts.make_full_mesh()
        values = mesh_parts.make_values(grid.GetNumberOfCells())
        source = mesh_parts.producer(grid)
        table, _, _ = self.tables(source, WeightArray="Volume", Arrays=list(values))
        weights = [Fraction(w) for w in values["Volume"].tolist()]
        for row in table:
            data = values[row["Criterion"]].astype(float).tolist()
            known = [(w, x) for w, x in zip(weights, data) if not math.isnan(x)]
            total = sum(w for w, _ in known)
            self.assertAlmostEqual(row["Weight"], float(total), delta=1e-14 * float(total))
            finite = [(w, Fraction(x)) for w, x in known if math.isfinite(x)]
            if not finite:
                self.assertTrue(math.isnan(row["WeightedMean"]))
                continue
            mean = sum(w * x for w, x in finite) / sum(w for w, _ in finite)
            size = sum(w * abs(x) for w, x in finite) / sum(w for w, _ in finite)
            error = abs(Fraction(row["WeightedMean"]) - mean)
            self.assertLess(error, size * Fraction(1, 10**13), row["Criterion"])
            low, high = row["AcceptableLow"], row["AcceptableHigh"]
            if math.isnan(low):
                self.assertTrue(math.isnan(row["BadVolumeFraction"]))
            else:
                # The range of this one is for tetrahedra.
                of_tetrahedra = row["Criterion"] == "EdgeLengthRatio"
                judged = mesh_parts.are_of_type(VTK_TETRA) if of_tetrahedra else [True] * len(data)
                bad = sum(
                    w
                    for w, x, is_judged in zip(weights, data, judged)
                    if is_judged and (x < low or x > high)
                )
                self.assertAlmostEqual(row["BadVolumeFraction"], float(bad / total), delta=1e-14)
        bad = [row["BadVolumeFraction"] for row in table if row["Criterion"] == "EdgeLengthRatio"]
        self.assertTrue(0 < bad[0] < 1)

    def test_places_of_extremes(self):
        """The center of the very cell that ArgMin and ArgMax name."""
        grid = mesh_parts.make_full_mesh()
        table, _, _ = self.tables(mesh_parts.producer(grid), Arrays=["Volume", "AllUndefined"])
        for end in ("ArgMin", "ArgMax"):
            points = vtk_to_numpy(grid.GetCell(table[0][end]).GetPoints().GetData())
            place = [table[0][end + axis] for axis in "XYZ"]
            numpy.testing.assert_allclose(place, points.mean(axis=0), atol=1e-14)
            self.assertTrue(all(math.isnan(table[1][end + axis]) for axis in "XYZ"))

    def test_cumulative_curve(self):
        """Fractions of elements and of volume up to values of elements, by counting."""
        grid = mesh_parts.make_full_mesh()
        values = mesh_parts.make_values(grid.GetNumberOfCells())
        statistics = simple.QualityStatistics(
            Input=mesh_parts.producer(grid),
            Arrays=list(values),
            CurvePoints=21,
            WeightArray="Volume",
            GroupBy="Cell type",
        )
        curve = rows(self.fetch(statistics, 3))
        kinds = numpy.array([grid.GetCellType(i) for i in range(grid.GetNumberOfCells())])
        groups = {"All": kinds > 0, "Tetra": kinds == 10, "Hexahedron": kinds == 12}
        seen = 0
        for row in curve:
            if row["Group"] not in groups:
                continue
            seen += 1
            here = groups[row["Group"]]
            data = values[row["Criterion"]].astype(float)[here]
            weights, known = values["Volume"][here], ~numpy.isnan(data)
            self.assertIn(row["Value"], data)
            up_to = data <= row["Value"]
            self.assertEqual(row["Count"], up_to.sum())
            self.assertAlmostEqual(row["Percent"], 100 * up_to.sum() / known.sum(), delta=1e-12)
            self.assertAlmostEqual(row["Weight"] / math.fsum(weights[up_to]), 1, delta=1e-12)
            share = 100 * math.fsum(weights[up_to]) / math.fsum(weights[known])
            self.assertAlmostEqual(row["WeightPercent"], share, delta=1e-10)
        self.assertGreater(seen, 300)
        lengths = [r for r in curve if r["Criterion"] == "Volume" and r["Group"] == "All"]
        self.assertEqual((len(lengths), lengths[-1]["Percent"]), (21, 100))
        self.assertEqual(
            self.fetch(self.statistics(grid, Arrays=["Volume"]), 3).GetNumberOfRows(), 0
        )

    def statistics(self, grid, **properties):
        return simple.QualityStatistics(Input=mesh_parts.producer(grid), **properties)

    def test_only_selected(self):
        """As if the mesh had no other cells, except for ids; undefined values are not selected."""
        grid = mesh_parts.make_full_mesh()
        values = mesh_parts.make_values(grid.GetNumberOfCells())
        nowhere = numpy_to_vtk(numpy.isnan(values["EdgeLengthRatio"]).astype(int), deep=True)
        nowhere.SetName("Nowhere")
        grid.GetCellData().AddArray(nowhere)
        source = mesh_parts.producer(grid)
        picked = simple.SelectElements(
            Input=source, Strategy="By criterion", Array="EdgeLengthRatio", Range="Custom"
        )
        picked.LowerLimit, picked.UpperLimit, picked.Side = "0.2", "0.6", "Inside"
        here = (values["EdgeLengthRatio"] >= 0.2) & (values["EdgeLengthRatio"] <= 0.6)
        ids = numpy.arange(len(here))
        self.assertTrue(0 < here.sum() < len(here))
        table, bins, worst = self.tables(picked, OnlySelected=1, Arrays=["Volume"])
        self.check_statistics(table[0], values["Volume"][here], ids[here])
        self.check_histogram(bins, values["Volume"][here])
        self.assertTrue({row["Id"] for row in worst} <= set(ids[here].tolist()))
        _, whole, _ = self.tables(source, Arrays=["Volume"])
        _, part, _ = self.tables(
            picked, OnlySelected=1, Arrays=["Volume"], HistogramRange="All elements"
        )
        edges = lambda rows: [(row["LowerEdge"], row["UpperEdge"]) for row in rows]
        self.assertEqual(edges(part), edges(whole))
        self.assertNotEqual(edges(part), edges(bins))
        self.check_histogram(part, values["Volume"][here])
        for chosen in (
            {"HistogramRange": "All elements"},
            {"HistogramRange": "Custom", "CustomRange": [0.2, 0.6]},
        ):
            chosen["Arrays"] = ["EdgeLengthRatio"]
            _, expected, _ = self.tables(source, **chosen)
            _, empty, _ = self.tables(source, OnlySelected=1, SelectionArray="Nowhere", **chosen)
            self.assertEqual(edges(empty), edges(expected))
            self.assertEqual({row["Count"] for row in empty}, {0})
            self.assertGreater(empty[0]["UndefinedCount"], 0)
        mask = values["EdgeLengthRatio"]
        here = ~numpy.isnan(mask) & (mask != 0)
        table, _, _ = self.tables(
            source, OnlySelected=1, SelectionArray="EdgeLengthRatio", Arrays=["Volume"]
        )
        self.check_statistics(table[0], values["Volume"][here], ids[here])
        with camaron_testing.pipeline.Messages() as messages:
            self.tables(source, OnlySelected=1, Arrays=["Volume"])
        self.assertIn("needs a one-component array named 'Selected'", messages.errors[0])

    def test_no_moments(self):
        """Counts, extremes, mean, quantiles and histograms are the same without them; the rest is undefined."""
        grid = mesh_parts.make_full_mesh()
        source = mesh_parts.producer(grid)
        moments = ("StdDev", "Variance", "Skewness", "Kurtosis", "RootMeanSquare", "GeometricMean")
        places = [f"{end}{axis}" for end in ("ArgMin", "ArgMax") for axis in "XYZ"]
        missing = dict.fromkeys((*moments, *places), math.nan)
        missing.update(ArgMin=-1, ArgMax=-1)
        for group in ("None", "Cell type"):
            request = {"GroupBy": group, "Arrays": ["Volume", "FaceCount"]}
            whole, bins, _ = self.tables(source, **request)
            table, same, _ = self.tables(source, **request, Moments=0)
            self.assertEqual(same, bins)
            self.assertTrue(all(missing.keys() <= row.keys() for row in table))
            numpy.testing.assert_equal(table, [{**row, **missing} for row in whole])

    def test_points(self):
        """Arrays of points, without ghosts; groups by a point array, not by cell type."""
        grid = mesh_parts.make_mesh()
        count = grid.GetNumberOfPoints()
        random = numpy.random.default_rng(3)
        data = {"Field": random.standard_normal(count), "Zone": random.integers(0, 3, count)}
        ghosts = numpy.zeros(count, numpy.uint8)
        ghosts[::10] = 1
        for name, numbers in {**data, "vtkGhostType": ghosts}.items():
            array = numpy_to_vtk(numbers, deep=True)
            array.SetName(name)
            grid.GetPointData().AddArray(array)
        source = mesh_parts.producer(grid)
        properties = {"ElementType": "Points", "Arrays": ["Field"], "WorstValues": "Largest"}
        table, bins, worst = self.tables(
            source, GroupBy="Cell array", GroupArray="Zone", **properties
        )
        own = ghosts == 0
        ids = numpy.cumsum(own) - 1
        self.check_statistics(table[0], data["Field"][own], ids[own])
        for zone in range(3):
            here = own & (data["Zone"] == zone)
            self.check_statistics(table[1 + zone], data["Field"][here], ids[here])
        largest = numpy.flatnonzero(own)[data["Field"][own].argmax()]
        self.assertEqual([worst[0][axis] for axis in "XYZ"], list(grid.GetPoint(largest)))
        self.assertEqual((worst[0]["CellType"], worst[0]["Id"]), ("Point", ids[largest]))
        self.assertEqual({row["Size"] for row in worst}, {0})
        with camaron_testing.pipeline.Messages() as messages:
            self.tables(source, GroupBy="Cell type", **properties)
        self.assertIn("points cannot be grouped by 'Cell type'", messages.errors[0])

    def test_names_of_groups(self):
        """Of the values of Zone by ZoneIds and ZoneNames; two with one name keep their numbers, and one has none."""
        grid = mesh_parts.make_mesh()
        zones = numpy.arange(grid.GetNumberOfCells()) % 4
        for name, numbers, data in (
            ("Zone", zones, grid.GetCellData()),
            ("ZoneIds", numpy.array([7, 0, 1, 2]), grid.GetFieldData()),
        ):
            array = numpy_to_vtk(numbers, deep=True)
            array.SetName(name)
            data.AddArray(array)
        names = vtkStringArray()
        names.SetName("ZoneNames")
        for name in ("unused", "inlet", "rotor", "rotor"):
            names.InsertNextValue(name)
        grid.GetFieldData().AddArray(names)
        quality = simple.ElementQuality(Input=mesh_parts.producer(grid), Criteria=["Volume"])
        table, bins, _ = self.tables(quality, GroupBy="Cell array", GroupArray="Zone")
        groups = ["All", "inlet", "rotor (1)", "rotor (2)", "3"]
        self.assertEqual([row["Group"] for row in table], groups)
        self.assertEqual({row["Group"] for row in bins}, set(groups))

    def test_groups_of_texts(self):
        """One for each text, in their order; cells without one are in none."""
        grid = mesh_parts.make_mesh()
        names = vtkStringArray()
        names.SetName("Material")
        for cell in range(grid.GetNumberOfCells()):
            names.InsertNextValue(("rotor", "", "1", "All", "rotor")[cell % 5])
        grid.GetCellData().AddArray(names)
        quality = simple.ElementQuality(Input=mesh_parts.producer(grid), Criteria=["Volume"])
        volumes = vtk_to_numpy(self.fetch(quality).GetCellData().GetArray("Volume"))
        table, _, _ = self.tables(quality, GroupBy="Cell array", GroupArray="Material")
        groups = ["All", "1", "All (text)", "rotor"]
        self.assertEqual([row["Group"] for row in table], groups)
        places = numpy.arange(len(volumes)) % 5
        for row, here in zip(table[1:], (places == 2, places == 3, places % 4 == 0)):
            self.check_statistics(row, volumes[here], numpy.flatnonzero(here))
        other = mesh_parts.extract(grid, 0, 3)
        other.GetCellData().RemoveArray("Material")
        for values, message in (
            (
                numpy_to_vtk(numpy.arange(3), deep=True),
                "texts in some blocks and numbers in others",
            ),
            (vtkStringArray(), "'Material' has integers or texts that are not blank"),
        ):
            values.SetName("Material")
            values.SetNumberOfTuples(3)
            other.GetCellData().AddArray(values)
            blank = isinstance(values, vtkStringArray)
            blocks = [mesh_parts.producer(mesh) for mesh in ((other,) if blank else (grid, other))]
            with camaron_testing.pipeline.Messages() as messages:
                self.tables(
                    simple.ElementQuality(Input=simple.GroupDatasets(Input=blocks)),
                    GroupBy="Cell array",
                    GroupArray="Material",
                )
            self.assertIn(message, " ".join([*messages.errors, *messages.warnings]))
        many = vtkImageData()
        many.SetDimensions(1002, 2, 2)
        ids, values = vtkStringArray(), numpy_to_vtk(numpy.arange(1001.0), deep=True)
        ids.SetName("Name")
        values.SetName("Value")
        for cell in range(1001):
            ids.InsertNextValue(f"cell {cell}")
        many.GetCellData().AddArray(ids)
        many.GetCellData().AddArray(values)
        with camaron_testing.pipeline.Messages() as messages:
            self.tables(
                mesh_parts.producer(many), Arrays=["Value"], GroupBy="Cell array", GroupArray="Name"
            )
        self.assertIn("'Name' has more than 1000 different values", messages.errors[0])

    def test_labels_of_groups(self):
        """Each group has its own, with whatever names, and names belong to integers of any size."""
        huge = 2**53 - 3
        for ids, texts, expected in (
            ([0, 1, 2], ["a", "a", "a (0)"], ["a (0) (0)", "a (1)", "a (0)"]),
            ([0, 1, 2], ["All", "2", " "], ["All (0)", "2 (1)", "2"]),
            ([0, 0, 1], ["a", "b", "c"], ["0", "c", "2"]),
            ([huge + 1, huge, huge + 2], ["b", "a", "c"], ["a", "b", "c"]),
            ([0, 1], ["a", "b", "c"], ["0", "1", "2"]),
        ):
            grid = mesh_parts.extract(mesh_parts.make_mesh(), 0, 3)
            values = numpy.arange(3) + (huge if huge in ids else 0)
            names = vtkStringArray()
            names.SetName("XNames")
            for text in texts:
                names.InsertNextValue(text)
            grid.GetFieldData().AddArray(names)
            for name, numbers, data in (
                ("X", values, grid.GetCellData()),
                ("XIds", numpy.array(ids), grid.GetFieldData()),
            ):
                array = numpy_to_vtk(numbers, deep=True)
                array.SetName(name)
                data.AddArray(array)
            quality = simple.ElementQuality(Input=mesh_parts.producer(grid), Criteria=["Volume"])
            table, _, _ = self.tables(quality, GroupBy="Cell array", GroupArray="X")
            with self.subTest(ids=ids, texts=texts):
                self.assertEqual([row["Group"] for row in table], ["All", *expected])

    def test_faces_and_edges(self):
        """Measures of Mesh Elements have statistics without being named."""
        elements = simple.MeshElements(Input=mesh_parts.producer(mesh_parts.make_mesh()))
        elements.FaceArrays = ["OwnerCell", "NonOrthogonality", "Warpage"]
        elements.EdgeArrays = ["EdgeLength"]
        elements.UpdatePipeline()
        for port, names in ((0, ["NonOrthogonality", "Warpage"]), (1, ["EdgeLength"])):
            table, _, _ = self.tables(simple.servermanager.OutputPort(elements, port))
            self.assertEqual([row["Criterion"] for row in table], names)
            cells = self.fetch(elements, port)
            for row in table:
                data = vtk_to_numpy(cells.GetCellData().GetArray(row["Criterion"])).astype(float)
                self.check_statistics(row, data)
        # Faces have the range of MaxNonOrthogonality, a worst end, and no value at the boundary.
        faces = simple.servermanager.OutputPort(elements, 0)
        table, _, worst = self.tables(faces, Arrays=["NonOrthogonality"], NumberOfWorst=5)
        angles = vtk_to_numpy(self.fetch(elements, 0).GetCellData().GetArray("NonOrthogonality"))
        inner = numpy.sort(angles[~numpy.isnan(angles)])
        self.assertLess(inner.size, angles.size)
        self.assertEqual(table[0]["ApplicableCount"], inner.size)
        self.assertEqual(table[0]["JudgedCount"], inner.size)
        self.assertEqual(table[0]["AcceptableHigh"], 70)
        self.assertEqual(table[0]["AboveCount"], numpy.count_nonzero(inner > 70))
        self.assertEqual([row["Value"] for row in worst], list(inner[:-6:-1]))
        # The size of an edge is its length.
        worst = self.tables(
            simple.servermanager.OutputPort(elements, 1),
            WorstValues="Largest",
            NumberOfWorst=cells.GetNumberOfCells(),
        )[2]
        self.assertGreater(worst[0]["Value"], worst[-1]["Value"])
        for row in worst:
            self.assertAlmostEqual(row["Size"], row["Value"], delta=1e-14)

    def test_all_time_steps(self):
        """Rows of each step are those of the step alone; changing back leaves one step."""
        source = simple.TimeSource(Growing=1)
        source.UpdatePipelineInformation()
        times = list(source.TimestepValues)
        self.assertGreater(len(times), 3)
        properties = {"Arrays": ["Cell Value"], "CurvePoints": 5, "WorstValues": "Largest"}
        every = simple.QualityStatistics(Input=source, AllTimeSteps=1, **properties)
        one = simple.QualityStatistics(Input=source, **properties)
        every.UpdatePipeline(times[2])
        self.assertFalse(hasattr(every, "TimestepValues"))
        for port in range(4):
            found = rows(self.fetch(every, port))
            self.assertEqual(sorted({row["Time"] for row in found}), times)
            for time in times:
                one.UpdatePipeline(time)
                expected = rows(self.fetch(one, port))
                here = [
                    {k: v for k, v in r.items() if k != "Time"} for r in found if r["Time"] == time
                ]
                self.assertEqual(str(here), str(expected))
        every.UpdatePipeline(times[0])
        self.assertEqual(len(rows(self.fetch(every))), len(times))
        every.AllTimeSteps = 0
        every.UpdatePipeline(times[1])
        self.assertEqual(len(rows(self.fetch(every))), 1)

    def test_negative_and_missing_weights(self):
        grid = mesh_parts.extract(mesh_parts.make_mesh(), 0, 4)
        for name, data in (("W", [1.0, -3.0, math.nan, math.inf]), ("X", [1.0, 2.0, 3.0, 4.0])):
            mesh_parts.add_arrays(grid, {name: numpy.array(data)})
        (row,) = self.tables(mesh_parts.producer(grid), WeightArray="W", Arrays=["X"])[0]
        self.assertEqual((row["Weight"], row["WeightedMean"]), (4, 1.75))
        statistics = simple.QualityStatistics(
            Input=mesh_parts.producer(grid), Arrays=["X"], WeightArray="Y"
        )
        with camaron_testing.pipeline.Messages() as messages:
            statistics.UpdatePipeline()
        self.assertIn("the weights need a one-component array named 'Y'", messages.errors[0])

    def test_against_numpy(self):
        grid = mesh_parts.make_full_mesh()
        values = mesh_parts.make_values(grid.GetNumberOfCells())
        source = mesh_parts.producer(grid)
        for scale in ("Linear", "Logarithmic"):
            statistics, histogram, _ = self.tables(
                source, Arrays=list(values), HistogramScale=scale, NumberOfBins=20
            )
            self.assertEqual([row["Criterion"] for row in statistics], list(values))
            for row in statistics:
                name = row["Criterion"]
                numbers = values[name].astype(float)
                with self.subTest(array=name, scale=scale):
                    self.check_statistics(row, numbers)
                    bins = [row for row in histogram if row["Criterion"] == name]
                    finite = numbers[numpy.isfinite(numbers)]
                    if len(finite) and (scale == "Linear" or finite.max() > 0):
                        self.check_histogram(bins, numbers)
                    else:
                        # No bins, and one row that tells where the values are instead.
                        self.assertEqual([row["Bin"] for row in bins], [-1])
                        outside = (
                            "Count",
                            "Underflow",
                            "Overflow",
                            "UndefinedCount",
                            "InfiniteCount",
                        )
                        self.assertEqual(sum(bins[0][key] for key in outside), len(numbers))
        self.assertEqual(len([row for row in histogram if row["Criterion"] == "Constant"]), 1)

    def test_default_arrays_are_criteria(self):
        """Without a choice only arrays named like criteria count, in the order of their table."""
        source = mesh_parts.producer(mesh_parts.make_full_mesh())
        statistics, _, worst = self.tables(source)
        self.assertEqual(
            [row["Criterion"] for row in statistics],
            ["Volume", "FaceCount", "EquiangleSkewness", "EdgeLengthRatio"],
        )
        # FaceCount has no worse end; Volume has none either, but must be above zero.
        self.assertEqual(
            {row["Criterion"] for row in worst}, {"Volume", "EquiangleSkewness", "EdgeLengthRatio"}
        )

    def test_equal_quantiles_share_a_column(self):
        """Each percentage has one column, and invalid ones are rejected: the table keeps its shape."""
        source = mesh_parts.producer(mesh_parts.make_full_mesh())
        with camaron_testing.pipeline.Messages() as messages:
            statistics, _, _ = self.tables(
                source, Arrays=["Volume"], Quantiles=[50, 50, 33.3, 150, -5, 100]
            )
        self.assertEqual([c for c in statistics[0] if c.startswith("P")], ["P50", "P33.3", "P100"])
        self.assertEqual(statistics[0]["P100"], statistics[0]["Max"])
        self.assertTrue(any("must be 0 to 100" in text for text in messages.errors))

    def test_integers_have_bins_of_their_own(self):
        source = mesh_parts.producer(mesh_parts.make_full_mesh())
        _, histogram, _ = self.tables(source, Arrays=["FaceCount", "Material"])
        centers = [row["Center"] for row in histogram]
        self.assertEqual(centers, [*range(4, 9), *range(-3, 4)])

    def test_worst(self):
        """Exact order; ties by the smaller id; infinite values are the worst, undefined ones never."""
        grid = mesh_parts.make_full_mesh(global_ids=True)
        ids = numpy.array(
            [grid.GetCellData().GetGlobalIds().GetValue(i) for i in range(grid.GetNumberOfCells())]
        )
        values = mesh_parts.make_values(grid.GetNumberOfCells())
        source = mesh_parts.producer(grid)
        _, _, worst = self.tables(source, NumberOfWorst=60)
        for name, sign in (("EquiangleSkewness", -1), ("EdgeLengthRatio", 1)):
            numbers = values[name] + 0.0
            order = sorted(
                (i for i in range(len(ids)) if not math.isnan(numbers[i])),
                key=lambda i: (sign * numbers[i], ids[i]),
            )[:60]
            found = [row for row in worst if row["Criterion"] == name]
            self.assertEqual([row["Id"] for row in found], ids[order].tolist())
            self.assertEqual([row["Value"] for row in found], numbers[order].tolist())
            self.assertEqual([row["Rank"] for row in found], list(range(1, 61)))
            self.assertEqual(found[0]["IdSpace"], "Global id")
            bounds = grid.GetCell(order[0]).GetBounds()
            for axis, column in enumerate("XYZ"):
                self.assertTrue(bounds[2 * axis] <= found[0][column] <= bounds[2 * axis + 1])
            kinds = {12: "Hexahedron", 13: "Wedge", 10: "Tetra"}
            self.assertEqual(
                [row["CellType"] for row in found], [kinds[grid.GetCellType(i)] for i in order]
            )
            for row, i in zip(found, order):
                cell = grid.GetCell(i)
                points = [str(cell.GetPointId(k)) for k in range(cell.GetNumberOfPoints())]
                self.assertEqual(row["Vertices"], " ".join(points))
                bounds = numpy.reshape(cell.GetBounds(), (3, 2))
                self.assertAlmostEqual(
                    row["Size"], numpy.linalg.norm(bounds[:, 1] - bounds[:, 0]), delta=1e-14
                )

    def test_acceptable_ranges(self):
        grid = mesh_parts.make_full_mesh()
        values = mesh_parts.make_values(grid.GetNumberOfCells())
        source = mesh_parts.producer(grid)
        for preset in ("Default ranges", "FEM hexahedra"):
            statistics, histogram, _ = self.tables(source, Preset=preset)
            row = next(row for row in statistics if row["Criterion"] == "EdgeLengthRatio")
            low = row["AcceptableLow"]
            self.assertAlmostEqual(low, 1 / 1.3 if preset == "FEM hexahedra" else 1 / 3)
            self.assertEqual(row["AcceptableHigh"], math.inf)
            judged = mesh_parts.are_of_type(
                VTK_HEXAHEDRON if preset == "FEM hexahedra" else VTK_TETRA
            )
            below = (judged & (values["EdgeLengthRatio"] < low)).sum()
            self.assertGreater(below, 0)
            self.assertEqual((row["BelowCount"], row["AboveCount"]), (below, 0))
            self.assertEqual(row["JudgedCount"], judged.sum())
            undefined = numpy.isnan(values["EdgeLengthRatio"])
            self.assertEqual(row["JudgedUndefinedCount"], (judged & undefined).sum())
            self.assertAlmostEqual(row["OutOfRangePercent"], 100 * below / judged.sum())
            bins = [row for row in histogram if row["Criterion"] == "EdgeLengthRatio"]
            edges = [row["LowerEdge"] for row in bins] + [bins[-1]["UpperEdge"]]
            finite = values["EdgeLengthRatio"][judged & numpy.isfinite(values["EdgeLengthRatio"])]
            counts = numpy.histogram(finite, edges)[0].tolist()
            self.assertEqual([row["JudgedCount"] for row in bins], counts)
        row = next(row for row in statistics if row["Criterion"] == "EquiangleSkewness")
        infinite = numpy.isinf(values["EquiangleSkewness"][judged]).sum()
        above = (values["EquiangleSkewness"][judged] > row["AcceptableHigh"]).sum()
        self.assertGreater(infinite, 0)
        self.assertEqual(row["AboveCount"], above)

    def test_acceptable_range_in_radians(self):
        """Angles of an array in radians are compared with radians."""
        quality = simple.ElementQuality(Input=simple.Tetrahedralize(Input=simple.Wavelet()))
        quality.Criteria = ["MinDihedralAngle"]
        counts = []
        for units in ("Degrees", "Radians"):
            quality.AngleUnits = units
            (row,), _, _ = self.tables(quality, Preset="FEM tetrahedra")
            counts.append((row["Count"], row["BelowCount"]))
            self.assertEqual(row["Unit"], "deg" if units == "Degrees" else "rad")
            self.assertAlmostEqual(
                row["AcceptableLow"], 40 if units == "Degrees" else math.radians(40)
            )
        self.assertEqual(counts[0], counts[1])

    def test_reasons_of_undefined(self):
        """Cells for which a criterion has no meaning are not applicable, also from the mask array."""
        source = mesh_parts.producer(mesh_parts.make_mesh())
        quality = simple.ElementQuality(Input=source, WriteUndefinedMask=1)
        quality.Criteria = ["TetRadiusRatio"]
        (row,), _, _ = self.tables(quality)
        tetrahedra = sum(mesh_parts.make_mesh().GetCellType(i) == 10 for i in range(row["Count"]))
        self.assertEqual(row["ApplicableCount"], tetrahedra)
        self.assertEqual(row["UndefinedCount"], row["Count"] - tetrahedra)

    def test_ghosts_do_not_count(self):
        whole = mesh_parts.make_full_mesh()
        part = mesh_parts.extract(whole, 200, 400, ghost_layer=50)
        self.assertEqual(part.GetNumberOfCells(), 300)
        flags = part.GetCellData().GetArray("vtkGhostType")
        flags.SetValue(3, 32)  # hidden
        statistics, histogram, _ = self.tables(mesh_parts.producer(part), Arrays=["Volume"])
        values = mesh_parts.make_values(whole.GetNumberOfCells())["Volume"][200:400]
        self.assertEqual(statistics[0]["Count"], 199)
        self.check_statistics(
            statistics[0], numpy.delete(values, 3), numpy.delete(numpy.arange(200), 3)
        )
        self.check_histogram(histogram, numpy.delete(values, 3))

    def test_groups_by_cell_type(self):
        grid = mesh_parts.make_full_mesh()
        values = mesh_parts.make_values(grid.GetNumberOfCells())["Volume"]
        kinds = numpy.array([grid.GetCellType(i) for i in range(len(values))])
        ids = numpy.arange(len(values))
        statistics, histogram, _ = self.tables(
            mesh_parts.producer(grid), Arrays=["Volume"], GroupBy="Cell type"
        )
        self.assertEqual([r["Group"] for r in statistics], ["All", "Tetra", "Hexahedron", "Wedge"])
        for row, kind in zip(statistics[1:], (10, 12, 13)):
            self.check_statistics(row, values[kinds == kind], ids[kinds == kind])
            bins = [r for r in histogram if r["Group"] == row["Group"]]
            self.check_histogram(bins, values[kinds == kind])
        edges = {
            group: [r["LowerEdge"] for r in histogram if r["Group"] == group]
            for group in ("All", "Wedge")
        }
        self.assertEqual(edges["All"], edges["Wedge"])

    def test_groups_by_array(self):
        """A group for each whole number in an array of any type, in order; others have none."""
        grid = mesh_parts.make_full_mesh()
        values = mesh_parts.make_values(grid.GetNumberOfCells())
        ids = numpy.arange(len(values["Volume"]))
        for name in ("Material", "EdgeLengthRatio"):
            keys = values[name].astype(float)
            whole = [key for key in numpy.unique(keys) if key == numpy.floor(key)]
            statistics, _, worst = self.tables(
                mesh_parts.producer(grid), Arrays=["Volume"], GroupBy="Cell array", GroupArray=name
            )
            labels = [row["Group"] for row in statistics]
            self.assertEqual(labels, ["All", *(str(int(key)) for key in whole)])
            self.assertGreater(len(whole), 0)
            for row, key in zip(statistics[1:], whole):
                here = keys == key
                self.assertEqual(row["Count"], here.sum())
                if here.sum() > 1:
                    self.check_statistics(row, values["Volume"][here], ids[here])
                first = next(r for r in worst if r["Group"] == row["Group"])
                self.assertEqual(first["Value"], values["Volume"][here].min())
        with camaron_testing.pipeline.Messages() as messages:
            statistics, _, _ = self.tables(
                mesh_parts.producer(grid),
                Arrays=["Volume"],
                GroupBy="Cell array",
                GroupArray="None",
            )
        self.assertIn("named 'None'", " ".join(messages.warnings))
        self.assertEqual([row["Group"] for row in statistics], ["All"])

    def test_too_many_groups(self):
        """An array of measured values or of ids is no way to group; 1000 values are."""
        for cells, is_error in (((10, 10, 10), False), ((7, 11, 13), True)):
            image = simple.Wavelet(WholeExtent=[0, cells[0], 0, cells[1], 0, cells[2]])
            numbered = simple.PointAndCellIds(Input=image)
            statistics = simple.QualityStatistics(
                Input=numbered,
                Arrays=["CellIds"],
                GroupBy="Cell array",
                GroupArray="CellIds",
                NumberOfBins=1,
            )
            with camaron_testing.pipeline.Messages() as messages:
                statistics.UpdatePipeline()
            message = "'CellIds' has more than 1000 different values"
            self.assertEqual(any(message in text for text in messages.errors), is_error)
            self.assertEqual(self.fetch(statistics).GetNumberOfRows(), 0 if is_error else 1001)

    def test_undefined_as_worst(self):
        """Listed by id, without those for which the criterion has no meaning."""
        grid = mesh_parts.make_full_mesh()
        values = mesh_parts.make_values(grid.GetNumberOfCells())["EdgeLengthRatio"]
        missing = numpy.flatnonzero(numpy.isnan(values)).tolist()
        properties = {"Arrays": ["EdgeLengthRatio", "FaceCount"], "WorstValues": "Undefined"}
        _, _, worst = self.tables(mesh_parts.producer(grid), NumberOfWorst=1000, **properties)
        self.assertEqual([row["Id"] for row in worst], missing)
        self.assertTrue(all(math.isnan(row["Value"]) for row in worst))
        kinds = {12: "Hexahedron", 13: "Wedge", 10: "Tetra"}
        self.assertEqual(
            [row["CellType"] for row in worst], [kinds[grid.GetCellType(i)] for i in missing]
        )
        _, _, worst = self.tables(mesh_parts.producer(grid), NumberOfWorst=3, **properties)
        self.assertEqual([(row["Rank"], row["Id"]) for row in worst], [*enumerate(missing[:3], 1)])
        # Not applicable is not missing, whether the value tells or the mask.
        for mask in (0, 1):
            quality = simple.ElementQuality(
                Input=mesh_parts.producer(grid),
                Criteria=["TetRadiusRatio"],
                WriteUndefinedMask=mask,
            )
            _, _, worst = self.tables(quality, Arrays=["TetRadiusRatio"], WorstValues="Undefined")
            self.assertEqual(worst, [])

    def test_blocks(self):
        """A collection has the statistics of the whole and of each block; empty blocks have none."""
        values = mesh_parts.make_values(mesh_parts.make_mesh().GetNumberOfCells())
        third = len(values["Volume"]) // 3
        for parts in (1, 3):
            source = mesh_parts.producer(mesh_parts.make_collection(parts))
            statistics, _, worst = self.tables(
                source, Arrays=["Volume", "EquiangleSkewness"], GroupBy="Block"
            )
            self.assertEqual([r["Group"] for r in statistics], 2 * ["All", "first", "last"])
            ids = numpy.arange(len(values["Volume"]))
            self.check_statistics(statistics[0], values["Volume"])
            self.check_statistics(statistics[1], values["Volume"][:third])
            self.check_statistics(statistics[2], values["Volume"][third:], ids[third:])
            last = [row for row in worst if row["Group"] == "last"]
            self.assertEqual({row["Block"] for row in last}, {"last"})

    def test_multi_block(self):
        """Nested blocks, one without the array."""
        whole = mesh_parts.make_full_mesh()
        inner, outer = vtkMultiBlockDataSet(), vtkMultiBlockDataSet()
        bare = mesh_parts.extract(whole, 300, 350)
        bare.GetCellData().Initialize()
        inner.SetBlock(0, mesh_parts.extract(whole, 0, 100))
        inner.SetBlock(2, bare)
        outer.SetBlock(0, inner)
        outer.SetBlock(1, mesh_parts.extract(whole, 100, 300))
        outer.GetMetaData(0).Set(outer.NAME(), "rotor")
        inner.GetMetaData(0).Set(outer.NAME(), "blades")
        outer.GetMetaData(1).Set(outer.NAME(), "stator")
        statistics, _, _ = self.tables(
            mesh_parts.producer(outer), Arrays=["Volume"], GroupBy="Block"
        )
        self.assertEqual(
            [(r["Group"], r["Count"]) for r in statistics],
            [("All", 300), ("rotor/blades", 100), ("rotor/Block 4", 0), ("stator", 200)],
        )

    def test_adaptive(self):
        """Of boxes that are refined, and again under finer ones, each place counts once."""
        pulse = simple.AMRGaussianPulseSource()
        pulse.UpdatePipeline()
        bounds = pulse.GetDataInformation().GetBounds()
        domain = math.prod(high - low for low, high in zip(bounds[::2], bounds[1::2]))
        quality = simple.ElementQuality(Input=pulse, Criteria=["Volume"])
        ((row,), histogram, worst) = self.tables(quality)
        self.assertAlmostEqual(row["Sum"], domain, delta=1e-12 * domain)
        self.assertLess(row["Count"], pulse.GetDataInformation().GetNumberOfCells())
        self.assertEqual(worst[0]["Value"], row["Min"])
        seed = simple.SelectElements(
            Input=quality,
            Strategy="Worst N",
            Array="Volume",
            NumberOfWorst=7,
            WorstValues="Largest",
        )
        (chosen,), _, _ = self.tables(seed, OnlySelected=1)
        self.assertEqual(
            (chosen["Count"], chosen["Min"], chosen["Max"]), (7, row["Max"], row["Max"])
        )
        everything = simple.SelectElements(Input=quality, Strategy="All")
        everything.UpdatePipeline()
        everything.UpdatePropertyInformation()
        self.assertEqual(everything.GetPropertyValue("NumberOfSelectedElements"), row["Count"])
        surface = simple.MeshSurface(Input=pulse)
        surface.UpdatePipeline()
        self.assertGreater(surface.GetDataInformation().GetNumberOfCells(), 100)

    def test_images_and_surfaces(self):
        """Input need not be an unstructured grid."""
        for source in (simple.Wavelet(WholeExtent=[0, 4, 0, 4, 0, 4]), simple.Sphere()):
            quality = simple.ElementQuality(Input=source)
            statistics, _, _ = self.tables(quality)
            source.UpdatePipeline()
            cells = source.GetDataInformation().GetNumberOfCells()
            self.assertEqual([row["Count"] for row in statistics], 3 * [cells])

    def test_empty_input(self):
        """No cells: columns, but no rows."""
        nothing = simple.Threshold(Input=simple.Wavelet(), LowerThreshold=1e9, UpperThreshold=2e9)
        quality = simple.ElementQuality(Input=nothing)
        statistics = simple.QualityStatistics(Input=quality, GroupBy="Cell type")
        statistics.UpdatePipeline()
        for port in range(3):
            table = self.fetch(statistics, port)
            self.assertEqual(table.GetNumberOfRows(), 0)
            self.assertGreater(table.GetNumberOfColumns(), 10)

    def test_custom_bins(self):
        source = mesh_parts.producer(mesh_parts.make_full_mesh())
        values = mesh_parts.make_values(mesh_parts.make_mesh().GetNumberOfCells())
        _, histogram, _ = self.tables(
            source,
            Arrays=["EquiangleSkewness"],
            HistogramRange="Custom",
            CustomRange=[0.25, 0.75],
            NumberOfBins=10,
        )
        self.assertEqual(len(histogram), 10)
        self.assertEqual((histogram[0]["LowerEdge"], histogram[-1]["UpperEdge"]), (0.25, 0.75))
        self.check_histogram(histogram, values["EquiangleSkewness"])
        _, histogram, _ = self.tables(
            source, Arrays=["EquiangleSkewness"], HistogramRange="Acceptable"
        )
        self.assertEqual((histogram[0]["LowerEdge"], histogram[-1]["UpperEdge"]), (0, 0.9))

    def test_wrong_choices_are_errors(self):
        source = mesh_parts.producer(mesh_parts.make_full_mesh())
        for properties, reason in (
            ({"Preset": "Nonsense"}, "no preset named 'Nonsense'"),
            ({"GroupBy": "Color"}, "no way to group by 'Color'"),
            ({"HistogramScale": "Cubic"}, "not 'Cubic'"),
        ):
            filter_ = simple.QualityStatistics(Input=source)
            for name, value in properties.items():
                filter_.SMProxy.GetProperty(name).SetElement(0, value)
            filter_.SMProxy.UpdateVTKObjects()
            with camaron_testing.pipeline.Messages() as messages:
                filter_.UpdatePipeline()
            self.assertTrue(any(reason in error for error in messages.errors), messages.errors)
        for properties, reason in (
            ({"NumberOfWorst": -1}, "Number Of Worst must be 0 or more, not -1"),
            ({"NumberOfBins": 0}, "Number Of Bins must be 1 to 100000, not 0"),
            ({"CurvePoints": -5}, "Curve Points must be 0 to 100000, not -5"),
            ({"HistogramRange": "Custom", "CustomRange": [5, 3]}, "larger number, not from 5 to 3"),
            ({"HistogramRange": "Custom", "CustomRange": [0, math.nan]}, "not from 0 to nan"),
        ):
            with camaron_testing.pipeline.Messages() as messages:
                table, _, _ = self.tables(source, **properties)
            self.assertTrue(any(reason in error for error in messages.errors), messages.errors)
            self.assertEqual(table, [])
        with camaron_testing.pipeline.Messages() as messages:
            self.tables(source, Arrays=["Volume", "NotThere"])
        self.assertTrue(any("NotThere" in warning for warning in messages.warnings))

    def test_no_criteria(self):
        """A mesh without criteria causes a message, not just empty tables."""
        with camaron_testing.pipeline.Messages() as messages:
            rows, _, _ = self.tables(simple.Wavelet())
        self.assertEqual(rows, [])
        self.assertIn("Element Quality", " ".join(messages.warnings))


if __name__ == "__main__":
    camaron_testing.main()
