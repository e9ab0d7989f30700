# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Element Quality and Mesh Surface as people use them: proxies, arrays, blocks, traces and states."""

import math
import re
import runpy

import camaron_testing
import gallery
import mesh_parts
import numpy
from camaron.common import assessment, tables
from paraview import servermanager, simple, smtrace
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import (
    VTK_POLYGON,
    VTK_QUADRATIC_TETRA,
    VTK_TETRA,
    VTK_TRIANGLE,
    VTK_TRIANGLE_STRIP,
    vtkCellArray,
    vtkPolyData,
)
from vtkmodules.vtkFiltersCore import vtkMassProperties, vtkTriangleFilter

CORNERS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
MIDDLES = [(0.5, 0, 0), (0.5, 0.5, 0), (0, 0.5, 0), (0, 0, 0.5), (0.5, 0, 0.5), (0, 0.5, 0.5)]


def arrays(data):
    """Cell arrays by name, as lists."""
    cell_data = data.GetCellData()
    found = [cell_data.GetArray(i) for i in range(cell_data.GetNumberOfArrays())]
    return {a.GetName(): [a.GetTuple1(i) for i in range(a.GetNumberOfTuples())] for a in found}


class TestElementQuality(camaron_testing.TestCase):
    def setUp(self):
        super().setUp()
        simple.ResetSession()
        camaron_testing.pipeline.load_plugin()

    def evaluate(self, source, **properties):
        return arrays(self.fetch(simple.ElementQuality(Input=source, **properties)))

    def test_points_that_do_not_exist(self):
        """Ids of points beyond the mesh are an error of every filter, not a crash."""
        points = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
        good = [(10, [0, 1, 2, 4])] * 3
        faces = [4, 3, 0, 1, 2, 3, 0, 1, 4, 3, 1, 2, 99, 3, 0, 2, 4]
        for cell, bad in (((10, [0, 1, -1, 4]), -1), ((5, [0, 1, 8]), 8), ((42, faces), 99)):
            path = camaron_testing.write_vtk(self.folder / "bad.vtk", points, [*good, cell])
            source = simple.LegacyVTKReader(FileNames=[str(path)])
            for make in (
                simple.ElementQuality,
                simple.MeshElements,
                simple.MeshKernel,
                simple.MeshSurface,
                lambda Input: simple.SelectElements(Input=Input, Strategy="Boundary"),
            ):
                made = make(Input=source)
                with camaron_testing.pipeline.Messages() as messages:
                    made.UpdatePipeline()
                reason = f"cell 3 uses point {bad}, but the mesh has 8 points"
                self.assertTrue(
                    any(reason in error for error in messages.errors), (bad, messages.errors)
                )

    def test_meshes_that_could_not_be_read(self):
        """Filters are created and updated with the output of a reader after an error."""
        path = self.folder / "bad.visf"
        path.write_text("2")
        source = simple.VisfReader(FileNames=[str(path)])
        with camaron_testing.pipeline.Messages() as messages:
            source.UpdatePipeline()
            for make in (
                simple.ElementQuality,
                simple.MeshElements,
                simple.MeshKernel,
                simple.MeshSurface,
                simple.SelectElements,
                simple.QualityStatistics,
            ):
                made = make(Input=source)
                made.UpdatePipeline()
        self.assertIn("bad.visf:1: expected", messages.errors[0])

    def test_pieces_in_one_data_set(self):
        """A reader that appends several pieces of a file duplicates the points at their borders."""

        def mesh(points, cells, ids):
            grid = gallery.make_grid([points[i] for i in ids], cells)
            array = vtkIdTypeArray()
            array.SetName("GlobalPointIds")
            for number in ids:
                array.InsertNextValue(number)
            grid.GetPointData().SetGlobalIds(array)
            return grid

        def polyhedron(ids):
            sides = (
                (0, 3, 2, 1),
                (4, 5, 6, 7),
                (0, 1, 5, 4),
                (1, 2, 6, 5),
                (2, 3, 7, 6),
                (3, 0, 4, 7),
            )
            return [[ids[i] for i in side] for side in sides]

        lattice, cubes = gallery.lattice(3, 2, 1)
        criteria = ["IsBoundary", "RegionId", "PointRegionCount", "MaxNonOrthogonality"]
        nowhere = max(set(cubes[0]) & set(cubes[1]))  # a point of both pieces
        for kind, make, y in ((12, list, 0.3), (42, polyhedron, 0.3), (12, list, math.nan)):
            points = list(lattice)
            points[nowhere] = (points[nowhere][0], points[nowhere][1] + y, points[nowhere][2])
            whole = mesh(points, [(kind, make(cube)) for cube in cubes], range(len(points)))
            first = [0, 2, 3]  # of the cells; each piece has points of its own
            order = first + [i for i in range(len(cubes)) if i not in first]
            ids, cells = [], []
            for piece in (order[:3], order[3:]):
                own = sorted({point for cube in piece for point in cubes[cube]})
                for cube in piece:
                    numbers = [len(ids) + own.index(point) for point in cubes[cube]]
                    cells.append((kind, make(numbers)))
                ids += own
            self.assertGreater(len(ids), len(points))
            expected = self.evaluate(mesh_parts.producer(whole), Criteria=criteria)
            found = self.evaluate(mesh_parts.producer(mesh(points, cells, ids)), Criteria=criteria)
            for name in criteria:
                numpy.testing.assert_array_equal(
                    found[name], [expected[name][i] for i in order], f"{kind} {name}"
                )

    def test_defaults_show_something(self):
        """The first Apply evaluates criteria that no polygon or polyhedron lacks, and colors by one."""
        data = self.fetch(simple.ElementQuality(Input=simple.Sphere()))
        values = arrays(data)
        for name in ("EdgeLengthRatio", "EquiangleSkewness", "IsoperimetricQuotient"):
            self.assertFalse(any(map(math.isnan, values[name])), name)
        self.assertIn(data.GetCellData().GetScalars().GetName(), values)

    def test_colored_by_the_worst(self):
        """A criterion without values is never the color; of the others the one with most cells outside its range."""

        def color(source, **properties):
            scalars = (
                self.fetch(simple.ElementQuality(Input=source, **properties))
                .GetCellData()
                .GetScalars()
            )
            return scalars and scalars.GetName()

        ball = self.open(camaron_testing.EXAMPLES / "voronoi-ball.visf")
        self.assertEqual(color(ball, Criteria=["Area", "EdgeLengthRatio"]), "EdgeLengthRatio")
        for criteria in (["Volume", "Area"], ["Area", "BhatiaLawrence", "Volume"]):
            self.assertEqual(color(ball, Criteria=criteria), "Volume")
        self.assertIsNone(color(ball, Criteria=["Area"]))  # polygons alone have one
        self.assertIsNone(color(ball, Criteria=[]))
        names = list(tables.known_criteria())
        self.assertEqual(color(ball, Criteria=names), "MinTetQuality")

        # A needle beside a good tetrahedron, and cubes, none of which is outside of a range, in either unit.
        corners = [(0, 0, 0), (1, 0, 0), (0.5, 0.9, 0), (0.5, 0.3, 0.8), (0.5, 0.3, 1e-3)]
        cells = [(VTK_TETRA, (0, 1, 2, 3)), (VTK_TETRA, (0, 1, 2, 4))]
        needle = mesh_parts.producer(gallery.make_grid(corners, cells))
        for units in ("Degrees", "Radians"):
            limited = ["Volume", "MinDihedralAngle"]
            self.assertEqual(color(needle, Criteria=limited, AngleUnits=units), "MinDihedralAngle")
            flat = ["EdgeLengthRatio", "EquiangleSkewness"]
            self.assertEqual(
                color(simple.Wavelet(), Criteria=flat, AngleUnits=units), flat[1]
            )  # has a range

        # Cells with a volume come before the polygons between them.
        quarter = [(0, 0, 0), (1, 0, 0), (1, 1e-3, 0), (0, 1e-3, 1)]
        mixed = mesh_parts.producer(
            gallery.make_grid(quarter, [(VTK_TETRA, range(4)), (5, (0, 1, 2))] * 2)
        )
        self.assertEqual(color(mixed, Criteria=["Area", "Volume"]), "Volume")

    def test_color_is_the_worst_of_reports(self):
        mesh = self.open(camaron_testing.EXAMPLES / "flange.visf")
        for preset in ("General", "FEM tetrahedra", "VEM"):
            quality = simple.ElementQuality(Input=mesh, Preset=preset)
            rows = tables.read(simple.QualityStatistics(Input=quality, Preset=preset), preset)
            color = self.fetch(quality).GetCellData().GetScalars().GetName()
            self.assertEqual(color, assessment.worst_criterion(rows)["name"], preset)

    def test_only_what_is_ticked(self):
        values = self.evaluate(simple.Wavelet(), Criteria=["Volume", "MinDihedralAngle"])
        self.assertEqual(set(values), {"Volume", "MinDihedralAngle"})
        self.assertEqual(set(values["Volume"]), {1.0})
        self.assertAlmostEqual(values["MinDihedralAngle"][0], 90, 10)

    def test_nothing_is_ticked(self):
        """An empty list, also as an argument, which ParaView takes for one that was never set without help."""
        self.assertEqual(self.evaluate(simple.Wavelet(), Criteria=[]), {})

    def test_one_more_criterion(self):
        """It costs only itself: arrays of the same mesh stay, unless anything that they come from has changed."""
        grid = mesh_parts.make_mesh()
        source = mesh_parts.producer(grid)
        chosen = {"Criteria": ["Volume", "CellStatus", "RegionId"]}
        quality = simple.ElementQuality(Input=source, **chosen)

        def array(name):
            quality.UpdatePipeline()
            return quality.GetClientSideObject().GetOutputDataObject(0).GetCellData().GetArray(name)

        def change(**properties):
            chosen.update(properties)
            for name, value in properties.items():
                setattr(quality, name, value)
            volumes = array("Volume")
            found = arrays(quality.GetClientSideObject().GetOutputDataObject(0))
            expected = self.evaluate(source, **chosen)
            self.assertEqual(found.keys(), expected.keys())
            for name, values in expected.items():
                numpy.testing.assert_array_equal(found[name], values, name)
            return volumes

        first = change()
        more = ["Volume", "CellStatus", "RegionId", "MinDihedralAngle"]
        self.assertIs(change(Criteria=more), first)
        self.assertIs(change(WriteUndefinedMask=1), first)
        self.assertIs(change(Criteria=more[::-1]), first)
        self.assertIs(change(Criteria=["Volume", "MaxNonOrthogonality"]), first)
        self.assertIsNot(change(AngleUnits="Radians"), first)
        self.assertIsNot(change(DegeneracyTolerance=0.5), change(DegeneracyTolerance=0))

        # In place, by a script that tells nobody but the source.
        first = change(Criteria=more)
        largest = max(arrays(self.fetch(quality))["Volume"])
        vtk_to_numpy(grid.GetPoints().GetData())[:] *= 2
        source.GetClientSideObject().Modified()
        source.MarkModified(source)
        self.assertIsNot(change(), first)
        self.assertEqual(max(arrays(self.fetch(quality))["Volume"]), 8 * largest)
        vtk_to_numpy(array("Volume"))[:] = 7  # as careless scripts do with what they are given
        change(Criteria=["Volume"])

    def test_status_of_stars(self):
        """What CellStatus tells depends on whether IsStarShaped is ticked, before it or after it."""
        spiral = [
            (0, 0),
            (9, 0),
            (9, 9),
            (2, 9),
            (2, 4),
            (5, 4),
            (5, 6),
            (4, 6),
            (4, 8),
            (8, 8),
            (8, 1),
            (0, 1),
        ]
        points = [(x, y, 0) for x, y in spiral]
        source = mesh_parts.producer(
            gallery.make_grid(points, [(VTK_POLYGON, list(range(12)))], turns=False)
        )
        quality = simple.ElementQuality(Input=source)
        found = []
        for criteria in (
            ["CellStatus"],
            ["IsStarShaped"],
            ["CellStatus", "IsStarShaped"],
            ["CellStatus"],
        ):
            quality.Criteria = criteria
            found.append(arrays(self.fetch(quality)).get("CellStatus"))
        self.assertEqual(int(found[2][0]) - int(found[0][0]), 0x20000)
        self.assertEqual(found[3], found[0])

    def test_stopped(self):
        """Stopped while it evaluates or prepares to, it adds nothing; asked again, everything."""
        source = simple.OpenDataFile(str(camaron_testing.EXAMPLES / "voronoi-ball.visf"))
        for criteria in (
            ["Volume"],
            ["MaxNonOrthogonality", "RegionId", "MinSurfaceDihedralAngle"],
        ):
            quality = simple.ElementQuality(Input=source, Criteria=criteria)
            filter_ = quality.GetClientSideObject()
            observer = filter_.AddObserver("ProgressEvent", lambda *_: filter_.AbortExecuteOn())
            quality.UpdatePipeline()
            self.assertEqual(filter_.GetOutput().GetCellData().GetNumberOfArrays(), 0)
            filter_.RemoveObserver(observer)
            filter_.AbortExecuteOff()
            filter_.Modified()
            filter_.Update()
            self.assertEqual(sorted(arrays(filter_.GetOutput())), sorted(criteria))

    def test_values_of_every_cell(self):
        """Codes are integers, so that scripts can test their bits; arrays that may have undefined values are not."""
        points = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (1, 0.5, 0)]  # the quadrilateral is not convex
        cells = [(9, [0, 1, 2, 3]), (5, [0, 1, 2]), (3, [0, 1]), (1, [0])]
        path = camaron_testing.write_vtk(self.folder / "kinds.vtk", points, cells)
        source = simple.LegacyVTKReader(FileNames=[str(path)])
        names = ["CellStatus", "CellTypeId", "VertexCount"]
        data = self.fetch(simple.ElementQuality(Input=source, Criteria=names)).GetCellData()
        status, types, counts = (vtk_to_numpy(data.GetArray(name)) for name in names)
        self.assertEqual((status & 0x10).tolist(), [0x10, 0, 0, 0])
        self.assertEqual((status[1:].tolist(), types.tolist()), ([0, 0, 0], [9, 5, 3, 1]))
        self.assertEqual((types.dtype, counts.dtype), (numpy.int64, numpy.float64))
        self.assertEqual(numpy.isnan(counts).tolist(), [False, False, True, True])

    def test_defaults_of_proxy(self):
        """What the XML ticks is the preset Overview."""
        filter_ = simple.ElementQuality(Input=simple.Wavelet())
        names = filter_.SMProxy.GetProperty("Criteria")
        names.ResetToXMLDefaults()
        ticked = {names.GetElement(i) for i in range(0, names.GetNumberOfElements(), 2)}
        overview = self.evaluate(simple.Wavelet(), Preset="Overview")
        self.assertEqual(ticked, set(overview))

    def test_input_type_is_kept(self):
        for source, name in ((simple.Wavelet(), "vtkImageData"), (simple.Sphere(), "vtkPolyData")):
            data = self.fetch(simple.ElementQuality(Input=source))
            self.assertEqual(data.GetClassName(), name)

    def test_presets_of_the_panel_are_those_of_the_registry(self):
        """Every choice in the panel evaluates; the choices are those that the filter knows."""
        quality = simple.ElementQuality(Input=simple.Wavelet())
        domain = quality.GetProperty("Preset").SMProperty.FindDomain("vtkSMStringListDomain")
        names = [domain.GetString(i) for i in range(domain.GetNumberOfStrings())]
        self.assertEqual(names[0], "Ticked criteria")
        table = (camaron_testing.ROOT / "Core/Criteria/Presets.cxx").read_text()
        self.assertEqual(names[1:], re.findall(r'^    \{ "([^"]+)", "', table, re.MULTILINE))
        for name in names[1:]:
            quality.Preset = name
            self.assertGreater(len(arrays(self.fetch(quality))), 2, name)

    def test_units(self):
        for choice, unit, value in (("Degrees", "deg", 90), ("Radians", "rad", math.pi / 2)):
            quality = simple.ElementQuality(
                Input=simple.Wavelet(),
                AngleUnits=choice,
                Criteria=["MinDihedralAngle", "MinSolidAngle"],
            )
            cell_data = self.fetch(quality).GetCellData()
            angle = cell_data.GetArray("MinDihedralAngle")
            self.assertEqual(angle.GetInformation().Get(angle.UNITS_LABEL()), unit)
            self.assertAlmostEqual(angle.GetTuple1(0), value, 10)
            solid = cell_data.GetArray("MinSolidAngle")
            self.assertEqual(solid.GetInformation().Get(solid.UNITS_LABEL()), "sr")

    def test_undefined_mask(self):
        """1 if the criterion does not apply to the shape, 6 for a quadratic cell evaluated as the linear cell."""
        path = camaron_testing.write_vtk(
            self.folder / "mixed.vtk",
            CORNERS + MIDDLES,
            [(VTK_TETRA, range(4)), (VTK_QUADRATIC_TETRA, range(10)), (5, (0, 1, 2))],
        )
        values = self.evaluate(
            self.open(path), Criteria=["Volume", "Area", "Diameter"], WriteUndefinedMask=1
        )
        self.assertEqual(values["Volume_Undefined"], [0, 0, 1])
        self.assertEqual(values["Diameter_Undefined"], [0, 6, 0])
        self.assertEqual(values["Area_Undefined"], [1, 1, 0])
        self.assertTrue(math.isnan(values["Volume"][2]))

    def test_strips_become_triangles(self):
        strips = vtkPolyData()
        source = self.fetch(simple.Sphere())
        from vtkmodules.vtkFiltersCore import vtkStripper

        stripper = vtkStripper()
        stripper.SetInputData(source)
        stripper.Update()
        strips.ShallowCopy(stripper.GetOutput())
        producer = simple.TrivialProducer()
        producer.GetClientSideObject().SetOutput(strips)
        values = self.evaluate(producer, Criteria=["Area"])
        self.assertGreater(strips.GetNumberOfStrips(), 0)
        self.assertEqual(len(values["Area"]), source.GetNumberOfCells())
        direct = self.evaluate(simple.Sphere(), Criteria=["Area"])
        self.assertAlmostEqual(sum(values["Area"]), sum(direct["Area"]), 6)

    def test_strips_and_point_sets_of_a_grid(self):
        """A strip stands for its triangles, a convex point set for its hull; both keep the cell data."""
        cube = [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
        path = camaron_testing.write_vtk(
            self.folder / "odd.vtk", cube, [(6, (0, 1, 3, 2)), (41, range(8)), (12, range(8))]
        )
        criteria = ["Area", "Volume", "VertexCount", "CellTypeId"]
        values = self.evaluate(self.open(path), Criteria=criteria)
        self.assertEqual(values["Area"][:2], [0.5, 0.5])
        self.assertEqual(values["CellTypeId"], [5, 5, 41, 12])
        self.assertEqual(values["VertexCount"], [3, 3, 8, 8])
        self.assertAlmostEqual(values["Volume"][2], 1, 12)
        surface = self.fetch(simple.MeshSurface(Input=self.open(path)))
        self.assertEqual(
            surface.GetNumberOfPolys(), 1
        )  # the set and the hexahedron share all faces

    def test_strips_keep_global_ids(self):
        """Those of the other cells, and each triangle that of its strip."""
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (2, 0, 0)]
        cells = [(VTK_TRIANGLE_STRIP, [0, 1, 2, 3]), (VTK_TRIANGLE, [1, 4, 3])]
        grid = gallery.make_grid(points, cells, turns=False)
        surface = vtkPolyData()
        surface.SetPoints(grid.GetPoints())
        surface.SetStrips(vtkCellArray())
        surface.GetStrips().InsertNextCell(4, [0, 1, 2, 3])
        surface.SetPolys(vtkCellArray())
        surface.GetPolys().InsertNextCell(3, [1, 4, 3])
        for mesh, given, expected in (
            (grid, [70, 80], [70, 70, 80]),
            (surface, [80, 70], [80, 70, 70]),
        ):
            ids = vtkIdTypeArray()
            ids.SetName("Ids")
            for value in given:
                ids.InsertNextValue(value)
            mesh.GetCellData().SetGlobalIds(ids)
            producer = simple.TrivialProducer()
            producer.GetClientSideObject().SetOutput(mesh)
            output = self.fetch(
                simple.ElementQuality(Input=producer, Criteria=["Area"])
            ).GetCellData()
            self.assertEqual(vtk_to_numpy(output.GetGlobalIds()).tolist(), expected)

    def test_blocks(self):
        group = simple.GroupDatasets(Input=[simple.Sphere(), simple.Wavelet()])
        quality = simple.ElementQuality(Input=group, Criteria=["Area", "Volume"])
        quality.UpdatePipeline()
        volume = quality.CellData["Volume"]
        self.assertEqual(volume.GetRange(), (1.0, 1.0))
        surface = simple.MeshSurface(Input=quality)
        surface.UpdatePipeline()
        self.assertEqual(surface.GetDataInformation().GetNumberOfCells(), 96 + 2400)

    def test_unknown_preset_is_an_error(self):
        quality = simple.ElementQuality(Input=simple.Wavelet())
        with camaron_testing.pipeline.Messages() as messages:
            quality.Preset = "no such preset"
            quality.UpdatePipeline()
        self.assertTrue(any("no such preset" in text for text in messages.errors), messages.errors)

    def test_trace_replays(self):
        """Replaying the trace of a session creates the same arrays."""
        smtrace.start_trace(preamble="")
        simple.ElementQuality(
            Input=simple.Wavelet(), Criteria=["Volume", "MaxSolidAngle"], AngleUnits="Radians"
        )
        text = smtrace.stop_trace()
        self.assertIn("ElementQuality(", text)
        script = self.folder / "trace.py"
        script.write_text(text)
        simple.ResetSession()
        camaron_testing.pipeline.load_plugin()
        runpy.run_path(str(script))
        replayed = next(
            proxy
            for proxy in simple.GetSources().values()
            if proxy.GetXMLName() == "ElementQuality"
        )
        replayed.UpdatePipeline()
        self.assertEqual(set(arrays(self.fetch(replayed))), {"Volume", "MaxSolidAngle"})
        self.assertEqual(replayed.AngleUnits, "Radians")

    def test_state_loads_again(self):
        quality = simple.ElementQuality(
            Input=simple.Wavelet(), Criteria=["Diameter"], WriteUndefinedMask=1
        )
        quality.UpdatePipeline()
        state = self.folder / "state.pvsm"
        simple.SaveState(str(state))
        simple.ResetSession()
        camaron_testing.pipeline.load_plugin()
        simple.LoadState(str(state))
        loaded = next(
            proxy
            for proxy in simple.GetSources().values()
            if proxy.GetXMLName() == "ElementQuality"
        )
        loaded.UpdatePipeline()
        self.assertEqual(loaded.Criteria[:], ["Diameter"])
        self.assertEqual(set(arrays(self.fetch(loaded))), {"Diameter", "Diameter_Undefined"})

    def test_examples(self):
        """The example of Voronoi cells: every cell closed, and their volumes those of the surface."""
        source = self.open(camaron_testing.EXAMPLES / "voronoi-ball.visf")
        volumes = self.evaluate(source, Criteria=["Volume"])["Volume"]
        self.assertTrue(all(volume > 0 for volume in volumes))
        surface = self.fetch(simple.MeshSurface(Input=source))
        triangles = vtkTriangleFilter()
        triangles.SetInputData(surface)
        mass = vtkMassProperties()
        mass.SetInputConnection(triangles.GetOutputPort())
        self.assertAlmostEqual(sum(volumes) / mass.GetVolume(), 1, 5)


class TestMeshSurface(camaron_testing.TestCase):
    def test_same_as_extract_surface(self):
        """As many polygons as ParaView's own surface of the same hexahedra, with the cells' data."""
        wavelet = simple.Wavelet()
        grid = simple.AppendDatasets(Input=wavelet)
        theirs = self.fetch(simple.ExtractSurface(Input=grid))
        ours = self.fetch(simple.MeshSurface(Input=grid))
        self.assertEqual(ours.GetNumberOfCells(), theirs.GetNumberOfCells())
        self.assertEqual(ours.GetNumberOfPoints(), theirs.GetNumberOfPoints())
        self.assertIsNotNone(ours.GetCellData().GetArray("vtkOriginalCellIds"))
        self.assertEqual(
            ours.GetPointData().GetArray("RTData").GetRange(),
            theirs.GetPointData().GetArray("RTData").GetRange(),
        )

    def test_points_and_lines_stay(self):
        path = camaron_testing.write_vtk(
            self.folder / "mixed.vtk", CORNERS, [(1, (0,)), (3, (0, 1)), (VTK_TETRA, range(4))]
        )
        surface = self.fetch(simple.MeshSurface(Input=self.open(path)))
        self.assertEqual(
            (surface.GetNumberOfVerts(), surface.GetNumberOfLines(), surface.GetNumberOfPolys()),
            (1, 1, 4),
        )
        ids = surface.GetCellData().GetArray("vtkOriginalCellIds")
        self.assertEqual([ids.GetValue(i) for i in range(6)], [0, 1, 2, 2, 2, 2])


if __name__ == "__main__":
    camaron_testing.main()
