# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Select Elements selects the same cells on any number of ranks."""

import math

import camaron_testing
import mesh_parts
import numpy
from camaron.active_selection import set_active_selection
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_TETRA

WHOLE = mesh_parts.make_full_mesh(global_ids=True)
VALUES = mesh_parts.make_values(WHOLE.GetNumberOfCells())
IDS = vtk_to_numpy(WHOLE.GetCellData().GetGlobalIds())


def worst(name, sign, count, ids):
    order = [i for i in range(len(ids)) if not math.isnan(VALUES[name][i])]
    return sorted(sorted(order, key=lambda i: (sign * float(VALUES[name][i]), ids[i]))[:count])


class TestRanks(camaron_testing.TestCase):
    def check(self, source, expected, **properties):
        select = simple.SelectElements(Input=source, **properties)
        with camaron_testing.pipeline.Messages():
            select.UpdatePipeline()
        select.UpdatePropertyInformation()
        selected = []
        for piece in camaron_testing.pieces(select):
            output, own = piece.GetCellData(), camaron_testing.own_cells(piece)
            if output.GetArray("Number"):  # a rank without cells has none
                numbers = vtk_to_numpy(output.GetArray("Number"))
                marks = vtk_to_numpy(output.GetArray("Selected")) == 1
                selected += numbers[marks & own].tolist()
                # Ghosts are marked as their originals are, so that what is drawn of the others has walls there.
                self.assertEqual(
                    set(numbers[marks & ~own]), set(numbers[~own]) & set(expected), properties
                )
        self.assertEqual(sorted(selected), sorted(expected), properties)
        self.assertEqual(select.GetPropertyValue("NumberOfSelectedElements"), len(expected))
        return select

    def check_strategies(self, ids, **options):
        source = mesh_parts.split_source(**options)
        values = VALUES["EdgeLengthRatio"]
        judged = mesh_parts.are_of_type(VTK_TETRA)  # the shape that the acceptable range is for
        self.check(source, numpy.flatnonzero(judged & (values < 1 / 3)), Array="EdgeLengthRatio")
        self.check(
            source,
            numpy.flatnonzero(numpy.isnan(values)),
            Array="EdgeLengthRatio",
            Strategy="Undefined",
        )
        for count in (1, 40, 500):
            self.check(
                source,
                worst("EdgeLengthRatio", 1, count, ids),
                Array="EdgeLengthRatio",
                Strategy="Worst N",
                NumberOfWorst=count,
            )
            self.check(
                source,
                worst("Material", -1, count, ids),
                Array="Material",
                Strategy="Worst N",
                NumberOfWorst=count,
                WorstValues="Largest",
            )

    def test_shapes_on_empty_rank(self):
        """A rank without cells gets the bounds of the mesh from the others."""
        source = mesh_parts.split_source(empty_rank=True)
        everything = numpy.arange(WHOLE.GetNumberOfCells())
        self.check(source, everything, Strategy="Half-spaces", Planes=[0, 0, 1000, 0, 0, 1])
        self.check(source, [], Strategy="Half-spaces", Planes=[0, 0, -1000, 0, 0, 1])

    def test_pieces(self):
        self.check_strategies(numpy.arange(len(IDS)))

    def test_global_ids_and_ghosts(self):
        self.check_strategies(IDS, global_ids=True)
        self.check_strategies(IDS, global_ids=True, ghost_layer=40)
        self.check_strategies(numpy.arange(len(IDS)), ghost_layer=40)

    def test_empty_rank(self):
        self.check_strategies(numpy.arange(len(IDS)), empty_rank=True)

    def test_ids(self):
        for options in ({}, {"ghost_layer": 30}, {"empty_rank": True}):
            source = mesh_parts.split_source(global_ids=True, **options)
            last = len(IDS) - 1
            select = self.check(
                source, [0, 7, 8, 9, last], Strategy="By id", Ids=f"0, 7-9, {last}-{last + 3}"
            )
            self.assertEqual(select.GetPropertyValue("Report"), "3 of 8 ids do not exist")
            expected = numpy.flatnonzero((IDS >= 100) & (IDS <= 130))
            self.check(source, expected, Strategy="By id", IdSpace="Global id", Ids="100-130")

    def test_failed_rules(self):
        """The cells that Check Quality lists."""
        rule = "MaxNonOrthogonality <= 10 of hexahedra"
        for options in ({}, {"ghost_layer": 40}, {"empty_rank": True}):
            source = mesh_parts.split_source(global_ids=True, **options)
            check = simple.CheckQuality(
                Input=source, Preset="None", Rules=rule, NumberOfWorst=len(IDS)
            )
            rows = camaron_testing.pieces(check, 1)[0].GetColumnByName("Id")
            expected = numpy.flatnonzero(numpy.isin(IDS, vtk_to_numpy(rows)))
            self.assertGreater(len(expected), 0)
            self.check(source, expected, Strategy="Failed rules", Rules=rule)

    def test_sorted_table(self):
        """The first rank has the rows of all, worst first, undefined ones last, without columns that have no value."""
        source = mesh_parts.split_source(global_ids=True)
        all_cells = simple.SelectElements(Input=source, Strategy="All", Array="EdgeLengthRatio")
        values = VALUES["EdgeLengthRatio"]
        for sign, descending in ((1, 0), (-1, 1)):
            table = simple.SelectionTable(
                Input=all_cells, SortBy="EdgeLengthRatio", Descending=descending
            )
            table.UpdatePipeline()
            pieces = camaron_testing.pieces(table)
            self.assertEqual([rows.GetNumberOfRows() for rows in pieces[1:]], [0] * len(pieces[1:]))
            ids = vtk_to_numpy(pieces[0].GetColumnByName("Id"))
            order = sorted(
                range(len(IDS)),
                key=lambda i: (
                    math.isnan(values[i]),
                    0 if math.isnan(values[i]) else sign * values[i],
                    IDS[i],
                ),
            )
            self.assertEqual(ids.tolist(), IDS[order].tolist())
            names = [pieces[0].GetColumnName(i) for i in range(pieces[0].GetNumberOfColumns())]
            self.assertEqual(names[:6], ["Id", "CellType", "X", "Y", "Z", "EdgeLengthRatio"])

    def test_errors_on_all_ranks(self):
        """An error must not leave some ranks waiting for others."""
        source = mesh_parts.split_source(empty_rank=True)
        for properties in (
            {"Strategy": "By id", "IdSpace": "Global id", "Ids": "1"},
            {"Strategy": "Worst N", "Array": "FaceCount"},
            {"Strategy": "By criterion", "Array": "Material"},
        ):
            select = simple.SelectElements(Input=source, **properties)
            with camaron_testing.pipeline.Messages() as messages:
                select.UpdatePipeline()
            self.assertIn("The selection cannot be computed", messages.errors[0])

    def test_default_array(self):
        """The first one by name, also on a rank without any, and where the client has not seen the mesh."""
        everything = range(len(IDS))
        for options in ({}, {"empty_rank": True}, {"ghost_layer": 40}):
            source = mesh_parts.split_source(**options)
            select = self.check(source, everything, Strategy="Undefined")
            self.assertEqual(select.Array, "")
            self.check(source, everything, Strategy="Undefined", Array="AllUndefined")

    def test_active_selection(self):
        source = mesh_parts.split_source(ghost_layer=40)
        expected = worst("EdgeLengthRatio", 1, 55, numpy.arange(len(IDS)))
        select = self.check(
            source, expected, Array="EdgeLengthRatio", Strategy="Worst N", NumberOfWorst=55
        )
        set_active_selection(select)
        extract = simple.ExtractSelection(Input=select)
        own = simple.RemoveGhostInformation(Input=extract)
        own.UpdatePipeline()
        self.assertEqual(own.GetDataInformation().GetNumberOfCells(), 55)


if __name__ == "__main__":
    camaron_testing.main()
