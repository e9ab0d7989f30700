# ranks: 1 2
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Integers that double precision cannot tell apart are refused, or, where they are ids, never rounded."""

import re
import unittest

import camaron
import camaron_testing
import gallery
import mesh_parts
import numpy
from camaron import export
from camaron.common import pipeline, tables
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

IDS = vtkIdTypeArray  # beside the types of numpy
LIMITS = {
    numpy.int64: (2**53, -(2**53) - 9, 2**63 - 9, -(2**63)),
    numpy.uint64: (2**63 - 4, 2**64 - 9),
    IDS: (2**53,),
}
STEPS = [0, 1, 2, 3, 3, 5]
REFUSED = "the array 'snow' has integers beyond 2^53, which double precision cannot tell apart"

PVTU = """<VTKFile type="PUnstructuredGrid"><PUnstructuredGrid>
<PPoints><PDataArray type="Float64" NumberOfComponents="3"/></PPoints>
<PCellData {attributes}>{arrays}</PCellData>
<Piece Source="part0.vtu"/><Piece Source="part1.vtu"/>
</PUnstructuredGrid></VTKFile>"""


def make_array(name, values, kind):
    if kind is not IDS:
        array = numpy_to_vtk(numpy.array(values, kind), deep=1)
    else:
        array = vtkIdTypeArray()
        array.SetNumberOfValues(len(values))
        vtk_to_numpy(array)[:] = values
    array.SetName(name)
    return array


def all_limits():
    return [(kind, start) for kind, starts in LIMITS.items() for start in starts]


def some_limits():
    """The largest and the smallest of every type, for what takes long."""
    return [
        *dict.fromkeys(
            (kind, limit(starts)) for kind, starts in LIMITS.items() for limit in (min, max)
        )
    ]


class TestLongIntegers(camaron_testing.FormatTestCase):
    def make_mesh(self, values, kind, name="snow", global_ids=False):
        """A source of cubes with such an array, in two pieces."""
        points, cubes = gallery.lattice(len(values), 1, 1)
        grid = gallery.make_grid(points, [(VTK_HEXAHEDRON, cube) for cube in cubes])
        data = grid.GetCellData()
        (data.SetGlobalIds if global_ids else data.AddArray)(make_array(name, values, kind))
        folder = self.folder / str(len(list(self.folder.iterdir())))
        folder.mkdir()
        for part in range(2):
            writer = vtkXMLUnstructuredGridWriter()
            writer.SetFileName(str(folder / f"part{part}.vtu"))
            writer.SetInputData(mesh_parts.extract(grid, part * 4, (4, len(values))[part]))
            writer.Write()
        number = "UInt64" if kind is numpy.uint64 else "Int64"
        arrays = (
            f'<PDataArray type="{number}" Name="{name}" {"IdType='1'" if kind is IDS else ""}/>'
        )
        attributes = f'GlobalIds="{name}"' if global_ids else ""
        self.path = folder / "mesh.pvtu"
        self.path.write_text(PVTU.format(arrays=arrays, attributes=attributes))
        return simple.XMLPartitionedUnstructuredGridReader(FileName=[str(self.path)])

    def rows(self, source, port=0):
        with pipeline.Messages() as messages:
            rows = tables.fetch(source, port)
        self.assertEqual(messages.errors, [])
        self.warnings = messages.warnings
        return rows

    def of_cells(self, source, name, port=0):
        """Values of a cell array, of all ranks."""
        values = []
        for piece in camaron_testing.pieces(source, port):
            if piece.GetNumberOfCells():  # else it has no array either
                array = vtk_to_numpy(piece.GetCellData().GetArray(name))
                values += array[camaron_testing.own_cells(piece)].tolist()
        return values

    def selected(self, source, **properties):
        return numpy.flatnonzero(
            self.of_cells(simple.SelectElements(Input=source, **properties), "Selected")
        ).tolist()

    def between(self, source, low, high):
        return self.selected(
            source,
            Array="snow",
            Strategy="By criterion",
            Range="Custom",
            LowerLimit=str(low),
            UpperLimit=str(high),
            Side="Inside",
        )

    def assert_refused(self, source, message=REFUSED):
        with pipeline.Messages() as messages:
            source.UpdatePipeline()
        self.assertIn(message, messages.errors[0])

    def test_refused(self):
        """By everything that compares or counts values; a process without such integers refuses them, too."""
        for kind, start in some_limits():
            for values in ([start + step for step in STEPS], [1, 2, 3, 4, 5, start]):
                source = self.make_mesh(values, kind)
                quality = simple.ElementQuality(Input=source, Criteria=["Volume"])
                of_array = {"Input": quality, "Arrays": ["snow"]}
                of_groups = {
                    "Input": quality,
                    "Arrays": ["Volume"],
                    "GroupBy": "Cell array",
                    "GroupArray": "snow",
                }
                by_criterion = {"Array": "snow", "Range": "Custom", "LowerLimit": "5"}
                for refused in (
                    simple.QualityStatistics(**of_array),
                    simple.QualityStatistics(**of_groups),
                    simple.QualityStatistics(Input=quality, Arrays=["Volume"], WeightArray="snow"),
                    simple.CompareQuality(**of_array, Other=quality),
                    simple.CompareQuality(**of_groups, Other=quality),
                    simple.CorrelateQuality(**of_array, Field=["CELLS", "Volume"]),
                    simple.CorrelateQuality(
                        Input=quality, Arrays=["Volume"], Field=["CELLS", "snow"]
                    ),
                    simple.CheckQuality(Input=source, Rules=["Volume > 0 where snow = 3"]),
                    simple.SelectElements(
                        Input=source, Strategy="Failed rules", Rules="Volume > 0 where snow = 3"
                    ),
                    simple.SelectElements(Input=source, Strategy="By criterion", **by_criterion),
                    simple.SelectElements(
                        Input=source, Strategy="Worst N", Array="snow", WorstValues="Largest"
                    ),
                    simple.QualityRegions(Input=source, **by_criterion),
                ):
                    with self.subTest(values=values, filter=refused.GetXMLName()):
                        self.assert_refused(refused)

    def test_largest(self):
        """Up to the largest of these numbers they are told apart and shown with all digits."""
        for kind, start in ((numpy.int64, 2**53 - 6), (numpy.int64, 1 - 2**53), (IDS, 2**53 - 6)):
            source = self.make_mesh([start + step for step in STEPS], kind)
            statistics = simple.QualityStatistics(
                Input=source,
                Arrays=["snow"],
                WorstValues="Largest",
                NumberOfWorst=3,
                GroupBy="Cell array",
            )
            rows = self.rows(statistics)
            self.assertEqual(self.warnings, [])
            found = [rows[0][name] for name in ("ArgMin", "Min", "ArgMax", "Max", "Sum")]
            self.assertEqual(found, [0, start, 5, start + 5, float(6 * start + 14)])
            self.assertEqual(
                [row["Group"] for row in rows[1:]], [str(start + step) for step in (0, 1, 2, 3, 5)]
            )
            worst = [row["Id"] for row in self.rows(statistics, 2) if row["Group"] == "All"]
            self.assertEqual(worst, [5, 3, 4])
            self.assertEqual(self.between(source, start + 1, start + 3), [1, 2, 3, 4])

    def test_ids(self):
        """Global ids are never rounded, whatever VTK's type of ids can represent."""
        for kind, start in all_limits():
            if start < 0:  # VTK's ids are not negative
                continue
            source = self.make_mesh([start + i for i in range(6)], kind, "number", True)
            by = {"Strategy": "By id", "IdSpace": "Global id"}
            if start >= 2**63 - 4:  # beyond vtkIdType
                chosen = simple.SelectElements(Input=source, Ids="1", **by)
                self.assert_refused(chosen, "the cells have no global ids")
                continue
            for ids, expected in (
                (f"{start + 1}", [1]),
                (f"{start + 3}, {start}", [0, 3]),
                (f"{start + 1}-{start + 4}", [1, 2, 3, 4]),
                (f"{start - 9}", []),
            ):
                self.assertEqual(self.selected(source, Ids=ids, **by), expected, start)
            chosen = simple.SelectElements(Input=source, Ids=f"{start + 2}", **by)
            (row,) = export._rows(simple.SelectionTable(Input=chosen))
            self.assertEqual((row["Id"], row["number"]), (start + 2, start + 2))
            quality = simple.ElementQuality(Input=source, Criteria=["Volume"])
            statistics = simple.QualityStatistics(Input=quality, Arrays=["Volume"])
            (row,) = self.rows(statistics)
            self.assertEqual(row["IdSpace"], "Global id")
            found = [row["Id"] for row in self.rows(statistics, 2)]
            self.assertEqual(sorted(found), [start + i for i in range(6)])

    def test_reported_file(self):
        source = self.open(self.data("reports/integers_beyond_2_53.vtu"))
        self.assert_refused(simple.QualityStatistics(Input=source, Arrays=["snow"]))

    @unittest.skipIf(camaron_testing.rank_count() > 1, "one process writes these formats")
    def test_formats(self):
        """What is written is read again, or said to be rounded; nothing is cut to 32 bits."""
        exact, real, single = {"vtu", "vtk", "vtkhdf"}, {"exo", "ex2", "xmf", "ply"}, {"case"}
        for kind, start in some_limits():
            values = [start + step for step in STEPS]
            self.make_mesh(values, kind)
            for suffix in exact | real | single:
                new = self.path.parent / f"new.{suffix}"
                notes = camaron.convert(self.path, new)
                rounded = [note for note in notes if "rounded" in note and "snow" in note]
                self.assertEqual(len(rounded), suffix not in exact, suffix)
                source = pipeline.open_mesh(new).source
                found = []
                for leaf in camaron_testing.leaves(
                    source.GetClientSideObject().GetOutputDataObject(0)
                ):
                    data = leaf.GetCellData()
                    array = data.GetArray("snow") or data.GetArray("snow_c")
                    found += [array.GetValue(i) for i in range(array.GetNumberOfValues())]
                if suffix == "ply":  # of the faces
                    self.assertEqual(set(found), set(map(float, values)))
                elif suffix in exact:
                    self.assertEqual(found, values, suffix)
                else:
                    real_type = numpy.float32 if suffix in single else float
                    self.assertEqual(found, [float(real_type(value)) for value in values], suffix)

    def test_commands(self):
        self.make_mesh([2**53 + step for step in STEPS], numpy.int64)
        path, folder = self.path, self.path.parent
        by_snow = {"criteria": ["Volume"], "group_by": "snow"}
        step = "By criterion: Array=snow; LowerLimit=1; Side=Inside"
        for command in (
            lambda: camaron.inspect(path, folder / "report", **by_snow, with_pictures=False),
            lambda: camaron.check(path, ["Volume > 0 where snow = 1"]),
            lambda: camaron.compare(path, path, folder / "comparison", **by_snow),
            lambda: camaron.select(path, [step], [folder / "one.csv"]),
        ):
            with self.assertRaisesRegex(RuntimeError, re.escape(REFUSED)):
                command()


camaron_testing.main()
