# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Select Elements: every strategy against numpy, and ParaView's active selection."""

import math

import camaron_testing
import gallery
import mesh_parts
import numpy
from camaron.active_selection import set_active_selection
from camaron.common import tables
from paraview import simple, smstate
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON,
    VTK_POLYHEDRON,
    VTK_QUAD,
    VTK_TETRA,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersExtraction import vtkExtractSelection


class TestSelect(camaron_testing.TestCase):
    def setUp(self):
        super().setUp()
        self.grid = mesh_parts.make_full_mesh(global_ids=True)
        self.count = self.grid.GetNumberOfCells()
        self.values = mesh_parts.make_values(self.count)
        self.ids = vtk_to_numpy(self.grid.GetCellData().GetGlobalIds())
        self.source = mesh_parts.producer(self.grid)

    def select(self, source=None, **properties):
        """A filter that has run, and the numbers of the cells that it selects."""
        select = simple.SelectElements(Input=source or self.source, **properties)
        with camaron_testing.pipeline.Messages() as self.messages:
            select.UpdatePipeline()
        select.UpdatePropertyInformation()
        output = self.fetch(select)
        marks = output.GetCellData().GetArray("Selected")
        self.assertEqual(marks.GetClassName(), "vtkUnsignedCharArray")
        marks = vtk_to_numpy(marks)
        self.assertTrue(set(marks) <= {0, 1})
        cells = numpy.flatnonzero(marks).tolist()
        self.assertEqual(select.GetPropertyValue("NumberOfSelectedElements"), len(cells))
        return select, cells

    def cells(self, condition):
        return numpy.flatnonzero(condition).tolist()

    def assert_error(self, reason, **properties):
        select = simple.SelectElements(Input=self.source, **properties)
        with camaron_testing.pipeline.Messages() as messages:
            select.UpdatePipeline()
        self.assertIn(reason, messages.errors[0])

    def test_case_of_specification(self):
        """1 to 10, NaN and Inf: five inside [3, 7], six outside with the infinite one, NaN fails only."""
        values = numpy.array([*range(1, 11), math.nan, math.inf], float)
        grid = mesh_parts.extract(mesh_parts.make_mesh(), 0, 12)
        array = numpy_to_vtk(values, deep=True)
        array.SetName("X")
        grid.GetCellData().AddArray(array)
        source = mesh_parts.producer(grid)
        limits = {"Array": "X", "Range": "Custom", "LowerLimit": "3", "UpperLimit": "7"}
        sides = {"Inside": [2, 3, 4, 5, 6], "Outside": [0, 1, 7, 8, 9, 11]}
        sides["Failing"] = sorted([*sides["Outside"], 10])
        for side, expected in sides.items():
            self.assertEqual(self.select(source, Side=side, **limits)[1], expected)

    def test_failing(self):
        """As many as Check Quality counts, with undefined values of the shapes to which a criterion applies."""
        criteria = ("MinDihedralAngle", "Volume", "MaxNonOrthogonality", "MinFaceAngle")
        quality = simple.ElementQuality(Input=self.source, Criteria=criteria)
        for name in criteria:
            check = simple.CheckQuality(Input=self.source, Preset="None", Rules=f"{name} 20 60")
            with self.subTest(name), camaron_testing.pipeline.Messages():
                limits = {"Range": "Custom", "LowerLimit": "20", "UpperLimit": "60"}
                _, cells = self.select(quality, Array=name, Side="Failing", **limits)
                self.assertEqual(len(cells), tables.fetch(check)[0]["Failing"])
                self.assertGreater(len(cells), 0)

    def test_failed_rules(self):
        """The cells that Check Quality lists, of all shapes, arrays and reasons; of any of several rules."""
        rules = (
            "MinDihedralAngle 20 60",
            "Volume > 0.1 where Material = 2",
            "MaxNonOrthogonality <= 10 of hexahedra tolerate 90%",
            "MinDihedralAngle >= 45",
            "MinDihedralAngle >= 46 of tetrahedra undefined passes",
            "EquiangleSkewness < 0.2 of tetrahedra",
        )
        flat = vtkUnstructuredGrid()
        flat.DeepCopy(self.grid)
        corners = vtkIdList()
        flat.GetCellPoints(7, corners)
        for i in range(corners.GetNumberOfIds()):
            flat.GetPoints().SetPoint(corners.GetId(i), 0, 0, 0)
        source = mesh_parts.producer(flat)
        of_all, numbers = set(), {int(number): i for i, number in enumerate(self.ids)}
        for rule in rules:
            check = simple.CheckQuality(
                Input=source, Preset="None", Rules=rule, NumberOfWorst=self.count
            )
            with self.subTest(rule):
                listed = {numbers[row["Id"]] for row in tables.fetch(check, 1)}
                _, cells = self.select(source, Strategy="Failed rules", Rules=rule)
                self.assertEqual(cells, sorted(listed))
                self.assertEqual(self.messages.errors, [])
                self.assertGreater(len(cells), 0)
                if "MinDihedralAngle" in rule:
                    self.assertEqual(7 in cells, "undefined passes" not in rule)
                of_all |= listed
        _, cells = self.select(source, Strategy="Failed rules", Rules="\n".join(rules))
        self.assertEqual(cells, sorted(of_all))
        self.assertIn(7, cells)
        some, cells = self.select(Strategy="By id", Ids="0-200")
        refined = {"Strategy": "Failed rules", "Rules": rules[0], "Combination": "Refine"}
        _, both = self.select(some, **refined)
        self.assertEqual(
            both, sorted(set(cells) & set(self.select(Strategy="Failed rules", Rules=rules[0])[1]))
        )
        self.check_options(source)
        self.assert_error("rules:1: expected", Strategy="Failed rules", Rules="Volum > 0")
        self.assert_error("at least one criterion with a range", Strategy="Failed rules")
        self.assert_error(
            "no cell array Zone", Strategy="Failed rules", Rules="Volume > 0 where Zone = 1"
        )

    def check_options(self, source):
        """Rules select what Check Quality counts with the same options: the defaults, and others."""
        points, cubes = gallery.lattice(1, 1, 1)
        cube = gallery.make_grid(points, [(VTK_HEXAHEDRON, cubes[0])])
        inward = [face[::-1] for face in gallery.faces(cube, 0)]
        inverted = gallery.make_grid(points, [(VTK_POLYHEDRON, inward)], turns=False)
        arrow = gallery.make_grid(
            [(0, 0, 0), (2, -1, 0), (1, 0, 0), (2, 1, 0)], [(VTK_QUAD, (0, 1, 2, 3))]
        )
        parts = [mesh_parts.extract(self.grid, *part) for part in ((0, 500), (500, self.count))]
        cases = (
            (source, "MinDihedralAngle >= 20", {"DegeneracyTolerance": 0.4}),
            (mesh_parts.producer(inverted), "Volume > 0", {"TrustFaceOrientation": 1}),
            (mesh_parts.producer(arrow), "IsConvex >= 1", {"ConvexityTolerance": 180}),
            (
                mesh_parts.producer(gallery.polyhedra()),
                "CellStatus <= 0",
                {"PlanarityTolerance": 0},
            ),
            (
                simple.GroupDatasets(Input=[mesh_parts.producer(part) for part in parts]),
                "MaxNonOrthogonality <= 10",
                {"ConnectBlocks": 1},
            ),
        )
        for mesh, rule, options in cases:
            counts = []
            for chosen in ({}, options):
                check = simple.CheckQuality(Input=mesh, Preset="None", Rules=rule, **chosen)
                select = simple.SelectElements(
                    Input=mesh, Strategy="Failed rules", Rules=rule, **chosen
                )
                with self.subTest(rule, chosen=chosen):
                    select.UpdatePipeline()
                    select.UpdatePropertyInformation()
                    counts.append(tables.fetch(check)[0]["Failing"])
                    self.assertEqual(
                        select.GetPropertyValue("NumberOfSelectedElements"), counts[-1]
                    )
            self.assertNotEqual(*counts, rule)

    def test_by_criterion(self):
        """Default: outside of the acceptable range of the criterion or of a preset."""
        values = self.values["EdgeLengthRatio"]
        for preset, low, kind in (
            ("Default ranges", 1 / 3, VTK_TETRA),
            ("FEM hexahedra", 1 / 1.3, VTK_HEXAHEDRON),
        ):
            judged = mesh_parts.are_of_type(kind)  # the shapes that the range is for
            _, cells = self.select(Array="EdgeLengthRatio", Preset=preset)
            self.assertEqual(cells, self.cells(judged & (values < low)))
            _, cells = self.select(Array="EdgeLengthRatio", Preset=preset, Side="Inside")
            self.assertEqual(cells, self.cells(judged & (values >= low)))
        _, cells = self.select(Array="EquiangleSkewness")
        self.assertEqual(cells, self.cells(self.values["EquiangleSkewness"] > 0.9))
        self.assertTrue(numpy.isinf(self.values["EquiangleSkewness"][cells]).any())

    def test_open_ranges(self):
        values = self.values["AnyBits"]
        for low, high in (("", "0"), ("-1e-3", ""), ("", ""), (" 1 ", "1e300")):
            lowest = float(low) if low else -math.inf
            highest = float(high) if high else math.inf
            inside = (values >= lowest) & (values <= highest)
            limits = {"Array": "AnyBits", "Range": "Custom", "LowerLimit": low, "UpperLimit": high}
            self.assertEqual(self.select(Side="Inside", **limits)[1], self.cells(inside))
            outside = (values < lowest) | (values > highest)
            self.assertEqual(self.select(Side="Outside", **limits)[1], self.cells(outside))

    def test_undefined(self):
        for name in ("EdgeLengthRatio", "AllUndefined", "Volume", "AnyBits"):
            _, cells = self.select(Strategy="Undefined", Array=name)
            self.assertEqual(cells, self.cells(numpy.isnan(self.values[name])), name)

    def test_worst(self):
        """Exactly N; ties by the smaller global id; infinite values may be the worst."""
        for name, sign, ends in (
            ("EquiangleSkewness", -1, ("By criterion", "Largest")),
            ("EdgeLengthRatio", 1, ("By criterion", "Smallest")),
            ("Volume", -1, ("Largest",)),
            ("FaceCount", 1, ("Smallest",)),
            ("AnyBits", 1, ("Smallest",)),
            ("Material", -1, ("Largest",)),
        ):
            values = self.values[name].astype(float)
            order = sorted(
                (i for i in range(self.count) if not math.isnan(values[i])),
                key=lambda i: (sign * values[i] + 0.0, self.ids[i]),
            )
            for end in ends:
                for number in (0, 1, 17, 300, 5000):
                    _, cells = self.select(
                        Strategy="Worst N", Array=name, WorstValues=end, NumberOfWorst=number
                    )
                    self.assertEqual(cells, sorted(order[:number]), f"{name} {number}")
                self.assertIn("there are only", self.messages.warnings[0])

    def test_too_few_for_worst(self):
        for count, words in ((2, "are only 2 cells"), (1, "is only 1 cell"), (0, "is no cell")):
            grid = mesh_parts.extract(mesh_parts.make_mesh(), 0, 3)
            values = numpy.full(3, math.nan)
            values[:count] = 1
            mesh_parts.add_arrays(grid, {"X": values})
            select = simple.SelectElements(
                Input=mesh_parts.producer(grid), Strategy="Worst N", WorstValues="Largest"
            )
            with camaron_testing.pipeline.Messages() as messages:
                select.UpdatePipeline()
            self.assertIn(f"there {words} with a value", messages.warnings[0])

    def test_worst_percentage(self):
        """Percentage of the elements with a value, rounded down."""
        values = self.values["EdgeLengthRatio"]
        order = sorted(
            (i for i in range(self.count) if not math.isnan(values[i])),
            key=lambda i: (values[i], self.ids[i]),
        )
        for percent in (0, 0.05, 1, 29, 100):
            _, cells = self.select(
                Strategy="Worst percentage", Array="EdgeLengthRatio", WorstPercentage=percent
            )
            wanted = int(percent * len(order) / 100 + 1e-9)
            self.assertEqual(cells, sorted(order[:wanted]), percent)

    def test_cell_type(self):
        """By VTK's type, or by topology: of polyhedra the linear cell that each is."""
        types = numpy.array([self.grid.GetCellType(i) for i in range(self.count)])
        for names, kinds in (("Tetra", [10]), ("wedge; 12", [12, 13]), ("Polyhedron", [])):
            _, cells = self.select(Strategy="Cell type", CellTypes=names)
            self.assertEqual(cells, self.cells(numpy.isin(types, kinds)), names)
        tetrahedron = (42, [4, 3, 0, 1, 2, 3, 0, 1, 3, 3, 1, 2, 3, 3, 0, 2, 3])
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
        path = camaron_testing.write_vtk(
            self.folder / "a.vtk", points, [(10, [0, 1, 2, 3]), tetrahedron, (3, [0, 1])]
        )
        source = simple.LegacyVTKReader(FileNames=[str(path)])
        for names, by_type, by_topology in (
            ("Tetra", [0], [0, 1]),
            ("Polyhedron", [1], []),
            ("Line, Tetra", [0, 2], [0, 1, 2]),
        ):
            properties = {"Strategy": "Cell type", "CellTypes": names}
            self.assertEqual(self.select(source, **properties)[1], by_type)
            self.assertEqual(self.select(source, ByTopology=True, **properties)[1], by_topology)
        self.assert_error("found 'Cube'", Strategy="Cell type", CellTypes="Tetra Cube")
        self.assert_error("Cell Types is empty", Strategy="Cell type")

    def test_status(self):
        status = numpy.array([0, 0x8000, 0x80, 0x8080, 1, 0x80000, 0, math.nan], float)
        grid = mesh_parts.extract(mesh_parts.make_mesh(), 0, len(status))
        array = numpy_to_vtk(status, deep=True)
        array.SetName("CellStatus")
        grid.GetCellData().AddArray(array)
        source = mesh_parts.producer(grid)
        for names, expected in (
            ("", [1, 2, 3, 4, 5]),
            ("InvertedOrZeroVolume", [1, 3]),
            ("OpenCell, DegenerateFaces", [2, 3, 5]),
            ("NotStarShaped", []),
        ):
            _, cells = self.select(source, Strategy="Status", StatusBits=names)
            self.assertEqual(cells, expected, names)
        self.assert_error("add it with Element Quality", Strategy="Status")
        self.assert_error("found 'Wrong'", Strategy="Status", StatusBits="OpenCell Wrong")

    def test_table_of_status_bits(self):
        """Criteria Table lists the bits of CellStatus: as its description does, with the names that
        StatusBits takes, and as IsValid counts them."""
        table = simple.CriteriaTable()
        defects = tables.fetch(table, 4)
        notes = {row["Name"]: row for row in tables.fetch(table, 0)}
        described = notes["CellStatus"]["Description"]
        numbers = [int(word) for word in described.replace(",", " ").split() if word.isdigit()]
        self.assertEqual([row["Bit"] for row in defects], numbers)
        for row in defects:
            self.assertIn(f"{row['Bit']} {row['Description']}", described)
        usable = [str(row["Bit"]) for row in defects if not row["Invalid"]]
        formula = notes["IsValid"]["Formula"]
        self.assertIn(f"no bits other than {', '.join(usable[:-1])} and {usable[-1]}", formula)
        grid = mesh_parts.extract(mesh_parts.make_mesh(), 0, len(defects))
        array = numpy_to_vtk(numpy.array([row["Bit"] for row in defects]), deep=True)
        array.SetName("CellStatus")
        grid.GetCellData().AddArray(array)
        source = mesh_parts.producer(grid)
        for cell, row in enumerate(defects):
            found = self.select(source, Strategy="Status", StatusBits=row["Name"])[1]
            self.assertEqual(found, [cell], row["Name"])

    def test_by_id(self):
        select, cells = self.select(Strategy="By id", Ids="3, 10-20, 40")
        self.assertEqual(cells, [3, *range(10, 21), 40])
        self.assertEqual(select.GetPropertyValue("Report"), "")
        self.assertEqual(self.messages.warnings, [])
        select, cells = self.select(
            Strategy="By id", Ids=f"7 7-9;{self.count - 1}-{self.count + 1}"
        )
        self.assertEqual(cells, [7, 8, 9, self.count - 1])
        self.assertEqual(select.GetPropertyValue("Report"), "2 of 6 ids do not exist")
        self.assertIn("2 of 6 ids do not exist", self.messages.warnings[0])
        # More ids than 64 bits can count.
        select, cells = self.select(Strategy="By id", Ids=f"{-(2**63)}-{2**63 - 1}")
        self.assertEqual(cells, list(range(self.count)))
        missing = 2**64 - 1 - len(cells)
        self.assertEqual(select.GetPropertyValue("Report"), f"At least {missing} ids do not exist")
        self.assertEqual(self.select(Strategy="By id")[1], [])

    def test_by_global_id(self):
        select, cells = self.select(Strategy="By id", IdSpace="Global id", Ids="100-110")
        self.assertEqual(sorted(self.ids[cells]), [100, 103, 106, 109])
        self.assertEqual(select.GetPropertyValue("Report"), "7 of 11 ids do not exist")

    def test_by_pedigree_id(self):
        numbers = numpy_to_vtk(numpy.arange(self.count, dtype=numpy.int32)[::-1].copy(), deep=True)
        numbers.SetName("FileId")
        self.grid.GetCellData().SetPedigreeIds(numbers)
        source = mesh_parts.producer(self.grid)
        _, cells = self.select(source, Strategy="By id", IdSpace="Pedigree id", Ids="0-2")
        self.assertEqual(cells, [self.count - 3, self.count - 2, self.count - 1])

    def test_errors(self):
        """Each causes one error that says what to do."""
        self.assert_error("Ids: expected a number, found 'four'", Strategy="By id", Ids="3, four")
        self.assert_error("Ids: expected a number, found '--5'", Strategy="By id", Ids="--5")
        self.assert_error("9-3 is a descending range", Strategy="By id", Ids="9-3")
        self.assert_error(
            "found '99999999999999999999", Strategy="By id", Ids="99999999999999999999"
        )
        self.assert_error(
            "no numeric pedigree ids", Strategy="By id", Ids="1", IdSpace="Pedigree id"
        )
        self.assert_error("no acceptable range is known for 'FaceCount'", Array="FaceCount")
        self.assert_error(
            "large values of 'FaceCount' are worse", Strategy="Worst N", Array="FaceCount"
        )
        custom = {"Array": "Volume", "Range": "Custom"}
        self.assert_error("expected a number, found '1,5'", LowerLimit="1,5", **custom)
        self.assert_error("expected a number, found 'nan'", UpperLimit="nan", **custom)
        self.assert_error("Lower Limit is above", LowerLimit="2", UpperLimit="1", **custom)
        values = {"Array": "EdgeLengthRatio"}
        worst = {"Strategy": "Worst N", **values}
        self.assert_error("Number Of Worst must be 0 or more, not -1", NumberOfWorst=-1, **worst)
        share = {"Strategy": "Worst percentage", **values}
        self.assert_error("Worst Percentage must be 0 to 100, not -2", WorstPercentage=-2, **share)
        self.assert_error(
            "Worst Percentage must be 0 to 100, not nan", WorstPercentage=math.nan, **share
        )
        failed = {"Strategy": "Failed criteria", "NumberOfFailures": 0}
        self.assert_error("Number Of Failures must be 1 or more, not 0", **failed)
        self.assert_error(
            "Number Of Layers must be 0 or more", Strategy="Expand", NumberOfLayers=-1
        )
        self.assert_error("Feature Angle must be 0 or more", Strategy="Expand", FeatureAngle=-1)
        self.assert_error(
            "Component Number must be 1 or more, not 0", Strategy="Component", ComponentNumber=0
        )
        for name, value, reason in (
            ("Strategy", "By luck", "no strategy named 'By luck'"),
            ("Array", "Nonsense", "named 'Nonsense'"),
            ("Side", "Left", "not 'Left'"),
        ):
            select = simple.SelectElements(Input=self.source, Array="EdgeLengthRatio")
            select.SMProxy.GetProperty(name).SetElement(0, value)
            select.SMProxy.UpdateVTKObjects()
            with camaron_testing.pipeline.Messages() as messages:
                select.UpdatePipeline()
            self.assertTrue(any(reason in error for error in messages.errors), messages.errors)

    def test_ghosts_are_not_selected(self):
        part = mesh_parts.extract(self.grid, 200, 400, ghost_layer=50)
        source = mesh_parts.producer(part)
        limits = {"Array": "Constant", "Range": "Custom", "Side": "Inside"}
        self.assertEqual(self.select(source, **limits)[1], list(range(200)))
        _, cells = self.select(
            source, Strategy="Worst N", Array="Constant", WorstValues="Largest", NumberOfWorst=999
        )
        self.assertEqual(cells, list(range(200)))
        select, cells = self.select(source, Strategy="By id", Ids="0-300")
        self.assertEqual(cells, list(range(200)))

    def test_composite(self):
        """Structure and names stay, every block has the mask, indices run through the blocks."""
        for parts in (1, 3):
            source = mesh_parts.producer(mesh_parts.make_collection(parts))
            third = self.count // 3
            select = simple.SelectElements(
                Input=source, Strategy="By id", Ids=f"5,{third + 2},{self.count - 1}"
            )
            select.UpdatePipeline()
            # Fetch makes something else of collections.
            output = select.GetClientSideObject().GetOutputDataObject(0)
            self.assertEqual(output.GetClassName(), "vtkPartitionedDataSetCollection")
            names = [output.GetMetaData(i).Get(output.NAME()) for i in range(3)]
            self.assertEqual(names, ["first", "none", "last"])
            selected, first = [], 0
            for block in (0, 2):
                for part in range(parts):
                    data = output.GetPartition(block, part).GetCellData()
                    marks = vtk_to_numpy(data.GetArray("Selected"))
                    selected += (first + numpy.flatnonzero(marks)).tolist()
                    first += len(marks)
            self.assertEqual(selected, [5, third + 2, self.count - 1])
            self.assert_selection_agrees(output, self.fetch(select, 1), 3)

    def test_selection_output(self):
        """The second output names the same cells."""
        select, cells = self.select(Strategy="Worst N", Array="EdgeLengthRatio", NumberOfWorst=25)
        self.assert_selection_agrees(self.fetch(select), self.fetch(select, 1), 25)

    def assert_selection_agrees(self, data, chosen, count):
        extract = vtkExtractSelection()
        extract.SetInputData(0, data)
        extract.SetInputData(1, chosen)
        extract.Update()
        output = extract.GetOutputDataObject(0)
        leaves = [output]
        if output.IsA("vtkCompositeDataSet"):
            iterator = output.NewIterator()
            leaves = []
            while not iterator.IsDoneWithTraversal():
                leaves.append(iterator.GetCurrentDataObject())
                iterator.GoToNextItem()
        marks = [
            vtk_to_numpy(leaf.GetCellData().GetArray("Selected"))
            for leaf in leaves
            if leaf.GetNumberOfCells()
        ]
        self.assertEqual(numpy.concatenate(marks).tolist(), [1] * count)

    def test_active_selection(self):
        """Extract Selection takes the active selection, which follows the filter."""
        select, cells = self.select(Array="EdgeLengthRatio")
        set_active_selection(select)
        self.assertIsNotNone(select.GetSelectionInput(0))
        extract = simple.ExtractSelection(Input=select)
        extract.UpdatePipeline()
        self.assertEqual(extract.GetDataInformation().GetNumberOfCells(), len(cells))
        select.Strategy = "Worst N"
        select.NumberOfWorst = 33
        extract.UpdatePipeline()
        self.assertEqual(extract.GetDataInformation().GetNumberOfCells(), 33)
        with self.assertRaisesRegex(ValueError, "Selected"):
            set_active_selection(self.source)

    def test_states(self):
        """States of both kinds bring the filter back as it was."""
        for kind in ("python", "xml"):
            simple.ResetSession()
            properties = {
                "Strategy": "By criterion",
                "Array": "EdgeLengthRatio",
                "Side": "Inside",
                "Range": "Custom",
                "LowerLimit": "0.9",
            }
            quality = simple.ElementQuality(Input=simple.Tetrahedralize(Input=simple.Wavelet()))
            select = simple.SelectElements(registrationName="chosen", Input=quality, **properties)
            select.UpdatePipeline()
            select.UpdatePropertyInformation()
            count = select.GetPropertyValue("NumberOfSelectedElements")
            self.assertGreater(count, 0)
            if kind == "python":
                state = smstate.get_state()
                simple.ResetSession()
                exec(compile(state, "state", "exec"), {})
            else:
                file = str(self.folder / "state.pvsm")
                simple.SaveState(file)
                simple.ResetSession()
                simple.LoadState(file)
            select = simple.FindSource("chosen")
            select.UpdatePipeline()
            select.UpdatePropertyInformation()
            for name, value in properties.items():
                self.assertEqual(select.GetPropertyValue(name), value)
            self.assertEqual(select.GetPropertyValue("NumberOfSelectedElements"), count)


if __name__ == "__main__":
    camaron_testing.main()
