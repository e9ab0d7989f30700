# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""In ParaView's window: words and titles that the Mesh Inspector shows."""

import json
import unittest

import camaron
import camaron_testing
import gallery
import numpy
from camaron.inspection import pictures
from camaron.inspection.camera import Camera
from inspection_testing import read_picture
from paraview import servermanager, simple
from TestMeshInspector import CARDS, COUNT, CTRL, DOCK, PLOT, SHIFT, card, drag, open_card, start
from TestMeshInspectorNumbers import write_row
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, VTK_POLYHEDRON
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter
from window_testing import (
    DISPLAY,
    PANEL,
    VIEWPORT,
    WINDOW,
    WindowTestCase,
    apply,
    check,
    edit,
    event,
    open_file,
    save_state,
    show_inspector,
)

#: What a legend shows beside the colors.
LEGEND = (
    "Title",
    "ComponentTitle",
    "DrawNanAnnotation",
    "UseCustomLabels",
    "AddRangeLabels",
    "CustomLabels",
    "LabelFormat",
    "NanAnnotation",
)

#: Writes properties of the legend of the current criterion and of the bar chart.
TITLES = """
import json
from paraview import servermanager, simple
view = simple.GetActiveView()
legend = simple.GetScalarBar(simple.GetDisplayProperties(simple.GetActiveSource()).LookupTable, view)
manager = servermanager.ProxyManager()
sheet = [v for v in manager.GetProxiesInGroup("views").values() if v.GetXMLName() == "SpreadSheetView"][0]
charts = [v for v in manager.GetProxiesInGroup("views").values() if v.GetXMLName() == "XYBarChartView"]
with open(PATH, "w") as file:
    json.dump(
        {
            "views": sorted(v.GetXMLName() for v in manager.GetProxiesInGroup("views").values()),
            "rows": [r.Input.Port for r in sheet.Representations if r.Visibility],
            "active": view.GetXMLName(),
            "legend": [legend.GetPropertyValue(name) for name in LEGEND],
            "colors": [list(table.RGBPoints)[1:4] for table in (
                legend.LookupTable, simple.GetColorTransferFunction("MinDihedralAngle"),
                simple.GetColorTransferFunction("ArrayThatNobodyHas"))],
            "charts": [[c.ChartTitle, c.BottomAxisTitle, c.LeftAxisTitle, c.ShowLegend] for c in charts],
            "bars": [[p.GetElement(i) for i in range(p.GetNumberOfElements())] for p in
                     (r.SMProxy.GetProperty("SeriesVisibility") for r in charts[0].Representations)],
        },
        file,
        default=list,
    )
"""

#: Writes the color map of a criterion, and how the mesh is drawn.
COLORS = """
import json
from paraview import simple
display = simple.GetDisplayProperties(simple.GetActiveSource())
with open(PATH, "w") as file:
    points = display.LookupTable.RGBPoints
    look = [display.Ambient, display.Diffuse, *display.EdgeColor, display.EdgeOpacity]
    json.dump([list(points), look], file)
"""

#: Writes properties of the display that a brush leaves as they are.
DRAWN = """
from paraview import simple
display = simple.GetDisplayProperties(simple.GetActiveSource())
with open(PATH, "w") as file:
    file.write(f"{display.SelectionVisibility} {display.Emphasis}")
"""

#: Writes the normal of the plane that cuts the mesh.
NORMAL = """
import json
from paraview import simple
with open(PATH, "w") as file:
    json.dump(list(simple.GetDisplayProperties(simple.GetActiveSource()).CutShape.Normal), file)
"""

#: Changes the representation of the mesh.
CHANGE = """
from paraview import simple
simple.GetDisplayProperties(simple.GetActiveSource()).Representation = "TYPE"
"""

#: Opens a mesh as `camaron view` does.
VIEW = """
import os, runpy
os.environ["CAMARON_VIEW"] = MESH
runpy.run_path(SCRIPT)
"""

#: Writes the look of a mesh without a criterion.
EDGES = """
import json
from paraview import simple
display = simple.GetDisplayProperties(simple.GetActiveSource())
with open(PATH, "w") as file:
    edges = [*display.EdgeColor, display.EdgeOpacity]
    surface = [*display.DiffuseColor, *display.AmbientColor, display.Ambient, display.Diffuse]
    json.dump([edges, surface], file)
"""

#: Draws the surface alone with the edges of ParaView's default.
DRAW_SURFACE = """
from paraview import simple
display = simple.GetDisplayProperties(simple.GetActiveSource())
display.Representation, display.EdgeColor, display.EdgeOpacity = "Surface", [0, 0, 0.5], 1
"""

#: Adds what tells cells without a value or a range apart to a file.
MARKS = """
import json
from paraview import simple
display = simple.GetDisplayProperties(simple.GetActiveSource())
table = display.LookupTable
legend = simple.GetScalarBar(table, simple.GetActiveView())
with open(PATH, "a") as file:
    colors = [list(table.NanColor), list(table.BelowRangeColor)]
    marks = [display.MarkCellsNotJudged, table.UseBelowRangeColor, legend.DrawNanAnnotation]
    file.write(json.dumps([*marks, legend.NanAnnotation, colors]) + "\\n")
"""

#: Adds to a file where the legend is in the view, and whether it has labels of its own.
PLACES = """
import json
from paraview import simple
view = simple.GetActiveView()
legend = simple.GetScalarBar(simple.GetDisplayProperties(simple.GetActiveSource()).LookupTable, view)
with open(PATH, "a") as file:
    pixels = [x * size for x, size in zip(legend.Position, view.ViewSize)]
    labels = [legend.UseCustomLabels, legend.AddRangeLabels]
    palette = simple.GetSettingsProxy("ColorPalette").Background
    behind = list(legend.BackgroundColor)
    isReadable = legend.DrawBackground and behind == [*palette, 0.75]
    file.write(json.dumps([view.ViewSize[0], *pixels, labels, isReadable]) + "\\n")
"""

#: Another palette of the window.
PALETTE = """
from paraview import simple
simple.LoadPalette("WhiteBackground")
simple.Render()
"""

#: Takes away what is behind the legend.
CLEAR_LEGEND = """
from paraview import simple
view = simple.GetActiveView()
legend = simple.GetScalarBar(simple.GetDisplayProperties(simple.GetActiveSource()).LookupTable, view)
legend.DrawBackground = 0
"""

#: Moves the legend as the mouse does.
MOVE_LEGEND = """
from paraview import simple
view = simple.GetActiveView()
legend = simple.GetScalarBar(simple.GetDisplayProperties(simple.GetActiveSource()).LookupTable, view)
legend.WindowLocation, legend.Position = "Any Location", [0.5, 0.5]
"""

#: Changes the color map.
RESCALE = """
from paraview import simple
simple.GetDisplayProperties(simple.GetActiveSource()).LookupTable.RescaleTransferFunction(0, 10)
simple.Render()
"""

#: Adds the light of the mesh to a file.
LIGHTS = """
from paraview import simple
display = simple.GetDisplayProperties(simple.GetActiveSource())
with open(PATH, "a") as file:
    file.write(f"{display.Ambient} {display.Diffuse} {display.ColorArrayName[1]}\\n")
"""

#: Gives the mesh ParaView's light, which it has in older states.
USUAL_LIGHT = """
from paraview import simple
display = simple.GetDisplayProperties(simple.GetActiveSource())
display.Ambient, display.Diffuse = 0, 1
"""

#: Loads a state.
LOAD = """
from paraview import simple
simple.LoadState(PATH)
simple.SetActiveSource([d.Input for d in simple.GetActiveView().Representations if d.Visibility][0])
"""

#: Chooses the light of the mesh.
LIGHT = """
from paraview import simple
simple.GetDisplayProperties(simple.GetActiveSource()).Ambient = 0.1
"""


#: Shows the next time step.
NEXT = """
from paraview import simple
simple.GetAnimationScene().GoToNext()
"""

#: Writes the direction of the camera.
CAMERA = """
import json
from paraview import simple
camera = simple.GetActiveCamera()
with open(PATH, "w") as file:
    camera.OrthogonalizeViewUp()
    json.dump([camera.GetDirectionOfProjection(), camera.GetViewUp()], file)
"""

#: Selects a cell.
SELECT = """
from paraview import selection, simple
selection.SelectIDs(IDs=[-1, CELL], FieldType="CELL", Source=simple.GetActiveSource())
"""

#: Saves what the view shows.
SAVE_PICTURE = """
from paraview import simple
simple.SaveScreenshot(PATH, simple.GetActiveView(), ImageResolution=[300, 300])
"""

#: Ends the window as the system does when there is no memory left.
KILL = """
import os, signal
os.kill(os.getpid(), signal.SIGKILL)
"""

#: Looks at the mesh along Z, without perspective, and saves nothing but the mesh.
SAVE_FRONT = """
from paraview import simple
view = simple.GetActiveView()
view.OrientationAxesVisibility, view.CameraParallelProjection = 0, 1
for bar in [r for r in view.Representations if r.GetXMLName() == "ScalarBarWidgetRepresentation"]:
    bar.Visibility = 0
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [20, 20, 900], [20, 20, 0], [0, 1, 0]
view.CameraParallelScale = 21
simple.SaveScreenshot(PATH, view, ImageResolution=[420, 420])
"""

#: In the Properties panel, of the shape that cuts the mesh.
SHAPE = f"{DISPLAY}/CutShape/ProxySelectionWidget/frame/ChosenProxyWidget"
PLANE, SPHERE = f"{SHAPE}/InteractivePlane", f"{SHAPE}/InteractiveSphere"

#: Fails unless the cut of a mesh has handles.
HANDLES = """
shown = [r for r in simple.GetActiveView().Representations if r.Visibility]
assert any(r.CutHandles for r in shown if hasattr(r, "CutHandles"))
"""


class TestMeshInspectorLook(WindowTestCase):
    def picture(self, path):
        return self.script(path.stem, SAVE_PICTURE.replace("PATH", repr(str(path))))

    def test_shining(self):
        """The first view of a solid is isometric. A selected cell inside shines through the others, until the selection is
        cleared. The first flight marks its cell."""
        direction, before, during, after, flown = (
            self.folder / name for name in ("camera.json", "0.png", "1.png", "2.png", "3.png")
        )
        centers = simple.CellCenters(
            Input=self.open(camaron_testing.EXAMPLES / "voronoi-ball.visf")
        )
        places = vtk_to_numpy(self.fetch(centers).GetPoints().GetData())
        middle = int(numpy.argmin(numpy.linalg.norm(places, axis=1)))
        self.play(
            *open_file("voronoi-ball.visf"),
            apply(),
            *self.script("camera", CAMERA.replace("PATH", repr(str(direction)))),
            show_inspector(),
            *self.picture(before),
            *self.script("select", SELECT.replace("CELL]", f"{middle}]")),
            *self.picture(during),
            *open_card("Selection"),
            event(card("Selection", "ClearSelection"), "activate"),
            *self.picture(after),
            event(card("Criteria", "Preset"), "set_string", "General"),
            event(card("Criteria", "Evaluate"), "activate"),
            event(card("Worst", "Next"), "activate"),
            *self.picture(flown),
        )
        self.assertTrue(numpy.allclose(json.loads(direction.read_text())[0], [-(3**-0.5)] * 3))
        changed = (read_picture(before) != read_picture(during)).any(axis=2)
        self.assertGreater(changed.sum(), 50)
        self.assertLess(changed.mean(), 0.1)
        self.assertTrue((read_picture(before) == read_picture(after)).all())
        red, green, blue = numpy.moveaxis(read_picture(flown), 2, 0)
        self.assertGreater(((red > 200) & (green > 180) & (blue < 100)).sum(), 50, "yellow mark")

    def test_edges(self):
        """`camaron view` shows a mesh of a format of ParaView as the window shows ours, and reports do. Mesh Inspection has its edges
        wherever it is chosen."""
        mesh = self.folder / "ball.vtu"
        simple.SaveData(str(mesh), self.open(camaron_testing.EXAMPLES / "voronoi-ball.visf"))
        camera, viewed, blue, chosen, second = (self.folder / f"{i}.json" for i in range(5))
        program = camaron_testing.ROOT / "Scripts" / "camaron" / "view.py"
        view = VIEW.replace("MESH", repr(str(mesh))).replace("SCRIPT", repr(str(program)))

        def write(path, text):
            return self.script(path.stem, text.replace("PATH", repr(str(path))))

        self.play(
            *self.script("view", view),
            *write(camera, CAMERA),
            *write(viewed, EDGES),
            *self.script("surface", DRAW_SURFACE),
            *write(blue, EDGES),
            *self.script("inspection", CHANGE.replace("TYPE", "Mesh Inspection")),
            *write(chosen, EDGES),
            *open_file("flange.visf"),
            apply(),
            *write(second, EDGES),
        )
        seen, up = json.loads(camera.read_text())
        self.assertTrue(numpy.allclose(seen, [-(3**-0.5)] * 3))
        of_report = Camera([0, 1, 0, 2, 0, 3])
        self.assertTrue(numpy.allclose([of_report.towards, of_report.up], [[-x for x in seen], up]))
        look = servermanager.misc.QualityColors()
        edges = [*look.EdgeColor, look.EdgeOpacity]
        surface = [*look.MeshColor, *look.MeshColor, look.Ambient, look.Diffuse]
        self.assertEqual(json.loads(blue.read_text())[0], [0, 0, 0.5, 1])
        for path in (viewed, second):
            self.assertEqual(json.loads(path.read_text()), [edges, surface], path.name)
        self.assertEqual(json.loads(chosen.read_text())[0], edges)
        self.assertLess(max(edges[:3]), 0.4)

    def test_place(self):
        """The panel is a tab beside Properties until the window is wide, then beside the view: there, one sees the
        criteria, the histogram and the six worst cells of a mesh at once."""
        self.require_events()
        self.play(
            event(WINDOW, "resize", "1190,980"),
            event(DOCK, "unseen"),
            *start(),
            event(PANEL, "unseen"),
            event(WINDOW, "resize", "1600,980"),
            event(PANEL, "seen"),
            event(card("Criteria", "Tree"), "seen"),
            event(card("Histogram", "Plot"), "seen"),
            event(card("Worst", "Cells"), "seen", 6),
        )

    def test_place_after_kill(self):
        """A window that was killed, before ParaView kept its layout, leaves the panel's first place to the next one. A place
        that ParaView keeps stays."""
        self.require_events()
        # As `camaron view`, without ParaView's welcome.
        start_as = {"settings": self.folder / "settings", "environment": {"CAMARON_VIEW": ""}}
        wide = event(WINDOW, "resize", "1600,980")
        with self.assertRaisesRegex(AssertionError, "ended with -9"):
            self.play(*start(), wide, *self.script("kill", KILL), **start_as)
        for _ in range(2):
            self.play(
                *start(),
                wide,
                event(PANEL, "seen"),
                event(card("Worst", "Cells"), "seen", 6),
                **start_as,
            )

    def test_large_brush(self):
        """A brush over very many cells paints them itself, which ParaView would take seconds for: its own properties stay,
        and nothing is left after Clear. Its panel Find Data lists them once one sees it."""
        self.require_events()
        mesh, properties = self.folder / "large.vtu", self.folder / "properties.txt"
        wavelet = simple.Wavelet(WholeExtent=[0, 47] * 3)
        moved = simple.Calculator(Input=simple.AppendDatasets(Input=wavelet))
        moved.Function = "coords + 0.2 * sin(7 * coordsX) * (iHat + jHat)"
        moved.CoordinateResults = 1
        simple.SaveData(str(mesh), moved)
        pictures = [
            self.folder / f"{name}.png"
            for name in ("plain", "brushed", "cleared", "back", "behind")
        ]
        find = f"{WINDOW}/findDataDock"
        rows = "findDataScrollArea/scrollArea/qt_scrollarea_viewport/findDataWidget/informationContainer/spreadsheet"
        self.play(
            *start(str(mesh)),
            *self.script("inspection", CHANGE.replace("TYPE", "Mesh Inspection")),
            *self.picture(pictures[0]),
            *drag(5, 2000),
            check(PLOT, "brushedCount", "103823"),
            *self.picture(pictures[1]),
            event(f"{WINDOW}/propertiesDock", "raise"),
            *self.picture(pictures[4]),
            show_inspector(),
            *self.script("properties", DRAWN.replace("PATH", repr(str(properties)))),
            *open_card("Selection"),
            event(find, "raise"),
            event(f"{find}/{rows}", "seen", 3),
            event(card("Selection", "ClearSelection"), "activate"),
            *self.picture(pictures[2]),
            *drag(5, 2000),
            *self.script("surface", CHANGE.replace("TYPE", "Surface")),
            event(card("Selection", "ClearSelection"), "activate"),
            *self.script("again", CHANGE.replace("TYPE", "Mesh Inspection")),
            *self.picture(pictures[3]),
            alone=True,  # with Find Data
        )
        # Without the legend, which follows the size of the view: Find Data changes that.
        plain, brushed, cleared, back, behind = (read_picture(path)[:, :200] for path in pictures)
        reddish = (brushed - plain)[..., 0] - (brushed - plain)[..., 1]
        self.assertGreater((reddish > 60).mean(), 0.1)
        self.assertFalse((brushed == [255, 0, 255]).all(axis=2).any(), "outlined by ParaView")
        self.assertTrue((brushed == behind).all(), "the panel is behind Properties")
        self.assertTrue((plain == cleared).all())
        self.assertTrue((plain == back).all())
        self.assertEqual(properties.read_text(), "1 'None'")

    def test_combined_brushes(self):
        """Brushes over two criteria, added and removed: a large mesh shows the cells that are selected, also while the panel
        paints them itself. The history has them all."""
        self.require_events()
        random = numpy.random.default_rng(1)
        angles, volumes = (random.integers(0, 101, 40 * 40 * 160).astype(float) for _ in range(2))
        names, sizes = ("MinDihedralAngle", "Volume"), (40, 40, 160)
        mesh, counted = self.folder / "combined.vtu", self.folder / "counted"
        image = simple.Wavelet(WholeExtent=[x for size in sizes for x in (0, size)])
        image.UpdatePipeline()
        grid = servermanager.Fetch(simple.AppendDatasets(Input=image))
        for name, values in zip(names, (angles, volumes)):
            array = numpy_to_vtk(values, deep=True)
            array.SetName(name)
            grid.GetCellData().AddArray(array)
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetFileName(str(mesh))
        writer.SetInputData(grid)
        writer.Write()
        brushes = [
            (names[0], 1, 99, CTRL, lambda a, v, s: s),
            (names[0], 11, 59, 0, lambda a, v, s: (a >= 10) & (a < 60)),
            (names[0], 71, 89, SHIFT, lambda a, v, s: s | (a >= 70) & (a < 90)),
            (names[0], 31, 39, CTRL, lambda a, v, s: s & ~((a >= 30) & (a < 40))),
            (names[1], 51, 99, SHIFT, lambda a, v, s: s | (v >= 50)),
            (names[1], 61, 69, CTRL, lambda a, v, s: s & ~((v >= 60) & (v < 70))),
        ]
        criteria = dict(zip(names, ("Minimum dihedral angle", "Volume")))
        events, expected, now = [], [], numpy.zeros(angles.size, bool)
        pictures = [self.folder / f"front{i}.png" for i in range(len(brushes) + 1)]
        front = lambda path: self.script(path.stem, SAVE_FRONT.replace("PATH", repr(str(path))))
        for (name, first, last, keys, select), path in zip(brushes, pictures):
            now = select(angles, volumes, now)
            expected.append(now)
            events += [
                event(card("Histogram", "Criterion"), "set_string", criteria[name]),
                event(card("Histogram", "Bins"), "set_int", 20),
                event(PLOT, "drag", f"{first},{last},bars,{keys}"),
                *front(path),
            ]
        self.play(
            *open_file(str(mesh)),
            apply(),
            show_inspector(),
            *self.script("inspection", CHANGE.replace("TYPE", "Mesh Inspection")),
            *events,
            *self.script("count", COUNT.replace("PATH", repr(str(counted)))),
            *open_card("Selection"),
            event(card("Selection", "ClearSelection"), "activate"),
            *front(pictures[-1]),
        )
        self.assertEqual(int(counted.read_text()), expected[-1].sum())
        centers_of = lambda path: read_picture(path)[15::10, 15::10][:40, :40]
        cleared = centers_of(pictures[-1])  # colored by the last criterion
        for path, cells in zip(pictures[4:], expected[4:]):
            others = ~cells.reshape(160, 40, 40)[-1]
            self.assertTrue((centers_of(path)[others] == cleared[others]).all(), "as the legend")
        for path, cells in zip(pictures, [*expected, expected[-1] & False]):
            centers = centers_of(path)
            accented = numpy.delete(centers, 1, 2).min(axis=2) - centers[..., 1] > 40  # magenta
            with self.subTest(path.name):
                numpy.testing.assert_array_equal(accented, cells.reshape(160, 40, 40)[-1])

    def test_cut_handles(self):
        """A cut has handles in the view on request: by the button, by undo, in traces and states, and for the next shape.
        Handles, Properties panel and card move it, and all of them follow, also to what is undone; a tilted plane keeps its
        normal."""
        self.require_events()
        pictures = [self.folder / f"{i}.png" for i in range(6)]
        normal, state, trace = (self.folder / f for f in ("normal.json", "cut.pvsm", "trace.py"))
        handles = card("View", "Handles")
        slider, number = card("View", "CutPosition"), card("View", "CutPositionValue")
        self.play(
            *start(),
            *open_card("View"),
            check(handles, "enabled", "false"),
            event(card("View", "CutBy"), "set_string", "Exactly"),
            check(handles, "checked", "false"),
            event(f"{WINDOW}/centralwidget", "picture", pictures[0]),
            *self.traced(trace, event(handles, "activate")),
            event(f"{WINDOW}/centralwidget", "picture", pictures[1]),
            event(handles, "activate"),
            event(f"{WINDOW}/centralwidget", "picture", pictures[2]),
            edit("Undo"),
            check(handles, "checked", "true"),
            event(f"{WINDOW}/centralwidget", "picture", pictures[5]),
            event(card("View", "CutShape"), "set_string", "Sphere"),
            check(f"{SPHERE}/show3DWidget", "checked", "true"),
            event(f"{SPHERE}/show3DWidget", "activate"),
            check(handles, "checked", "false"),
            event(handles, "activate"),
            check(f"{SPHERE}/show3DWidget", "checked", "true"),
            *save_state(str(state)),
            event(card("View", "CutX"), "activate"),
            event(f"{PLANE}/originX", "set_string", "0.7"),
            check(number, "text", "0.7"),
            check(slider, "value", "150"),
            event(number, "picture", pictures[3]),
            event(VIEWPORT, "mousePress", "(0.6,0.5,1,1,0)"),
            event(VIEWPORT, "mouseMove", "(0.65,0.5,1,0,0)"),
            event(VIEWPORT, "mouseMove", "(0.7,0.5,1,0,0)"),
            event(number, "picture", pictures[4]),
            event(VIEWPORT, "mouseRelease", "(0.7,0.5,1,0,0)"),
            event(slider, "set_int", "50"),
            event(slider, "set_int", "100"),
            check(f"{PLANE}/originX", "text", "0"),
            edit("Undo"),
            check(slider, "value", "50"),
            check(number, "text", "-0.7"),
            edit("Redo"),
            check(number, "text", "0"),
            event(f"{PLANE}/normalY", "set_string", "1"),
            event(slider, "set_int", "20"),
            check(slider, "value", "20"),
            *self.script("normal", NORMAL.replace("PATH", repr(str(normal)))),
            display=True,
        )
        self.assertEqual(json.loads(normal.read_text()), [1, 1, 0])
        before, moved = map(read_picture, pictures[3:5])
        self.assertTrue((before != moved).any(), "the number follows the handle")
        first, shown, hidden = map(read_picture, pictures[:3])
        self.assertGreater((shown != hidden).any(axis=2).sum(), 500)
        self.assertTrue((first == hidden).all())
        self.assertTrue((shown == read_picture(pictures[5])).all())
        self.assertIn("CutHandles = 1", trace.read_text())
        self.replay_state(state, HANDLES)

    def test_light(self):
        """Mesh Inspection has the light of reports, with and without an array. On Surface, a mesh has it if the panel has
        colored it by an array, and ParaView's in one color, also after undo. States keep their light.
        """
        lights, state = self.folder / "lights", self.folder / "light.pvsm"
        look = lambda name: self.script(name, LIGHTS.replace("PATH", repr(str(lights))))
        draw = lambda name: self.script(name, CHANGE.replace("TYPE", name))
        solid, array = (
            event(f"{WINDOW}/variableToolbar/displayColor/Variables", "set_string", name)
            for name in ("Solid Color", "MinDihedralAngle")
        )
        self.play(
            *start(),
            *look("array"),
            event(f"{WINDOW}/propertiesDock", "raise"),
            solid,
            *look("solid"),
            *draw("Surface"),
            *look("surface"),
            array,
            *look("again"),
            solid,
            edit("Undo"),
            *look("undone"),
            solid,
            *look("reset"),
            *draw("Mesh Inspection"),
            *look("inspected"),
            *self.script("old", USUAL_LIGHT),
            *save_state(str(state)),
            event(WINDOW, "fresh"),
            *self.script("load", LOAD.replace("PATH", repr(str(state)))),
            event(f"{WINDOW}/propertiesDock", "raise"),
            *look("loaded"),
        )
        look = servermanager.misc.QualityColors()
        even, usual = f"{look.Ambient} {look.Diffuse} ", "0.0 1.0 "
        array = "MinDihedralAngle"
        self.assertEqual(
            lights.read_text().splitlines(),
            [even + array, even, usual, even + array, even + array, usual, even, usual],
        )

    def test_legend(self):
        """The bar of the legend is at the same distance from the right end of the view, whatever the criterion and the
        size of the view, unless somebody moves it. Its labels are those of the colors, until these are changed. On a mesh
        that fills the view it is readable, in any palette, unless somebody takes away what is behind it.
        """
        self.require_events()
        places = self.folder / "places"
        look = lambda name: self.script(name, PLACES.replace("PATH", repr(str(places))))
        choose = lambda label: event(card("Histogram", "Criterion"), "set_string", label)
        low, high = "Minimum dihedral angle", "Maximum dihedral angle"
        self.play(
            event(WINDOW, "resize", "1500,900"),
            *start(),
            *look("low"),
            choose("Volume"),
            *look("volume"),
            event(WINDOW, "resize", "1300,900"),
            show_inspector(),
            *self.script("palette", PALETTE),
            *look("small"),
            choose(high),
            *self.script("move", MOVE_LEGEND),
            choose(low),
            choose(high),
            *look("moved"),
            choose(low),
            *self.script("clear", CLEAR_LEGEND),
            *self.script("rescale", RESCALE),
            *look("rescaled"),
        )
        found = [json.loads(line) for line in places.read_text().splitlines()]
        distances = [size - x for size, x, *_ in found]
        self.assertNotEqual(found[0][0], found[2][0])
        for i in (1, 2, 4):
            self.assertAlmostEqual(distances[i], distances[0], places=3)
        self.assertGreater(distances[0], 100)
        self.assertAlmostEqual(found[3][1], 0.5 * found[3][0], places=3)
        self.assertEqual([place[3] for place in found], [[1, 0]] * 4 + [[0, 1]])
        self.assertEqual([bool(place[4]) for place in found], [True] * 4 + [False])

    def test_titles(self):
        """Legend and chart name criterion and unit, legends of reports as those of the window. All tables are in one view, all charts in another; the mesh's view
        stays active, and the verdicts stay. The color map of Mesh Inspection is its own."""
        titles, tables = self.folder / "titles.json", self.folder / "new"
        self.play(
            *start(),
            *open_card("Check"),
            event(card("Check", "Rules"), "set_string", "MinDihedralAngle >= 20"),
            event(card("Check", "Check"), "activate"),
            *open_card("Report"),
            event(card("Report", "Chart"), "activate"),
            event(card("Report", "Statistics"), "activate"),
            event(card("Report", "WorstTable"), "activate"),
            event(card("Report", "Chart"), "activate"),
            event(card("Report", "Statistics"), "activate"),
            event(card("Report", "WorstTable"), "activate"),
            check(f"{CARDS}/Check", "verdict", "fail"),
            event(card("Report", "SaveTables"), "activate"),
            event(f"{CARDS}/Report/SaveTablesDialog", "filesSelected", tables),
            *self.script(
                "titles", TITLES.replace("PATH", repr(str(titles))).replace("LEGEND", repr(LEGEND))
            ),
        )
        self.assertIn("MinDihedralAngle", (tables / "worst.csv").read_text())
        found = json.loads(titles.read_text())
        title = "Minimum dihedral angle (°)"
        self.assertEqual(found["legend"][:5], [title, "", 1, 1, 0])
        self.assertIn(20, found["legend"][5])
        report = camaron.inspect(
            camaron_testing.EXAMPLES / "flange.visf",
            self.folder / "report",
            criteria=["MinDihedralAngle"],
            with_pictures=False,
            with_mesh=False,
        )
        scene = pictures.Scene()
        self.addCleanup(scene.close)
        scene.color(scene.show(simple.Sphere()), report["criteria"][0])
        of_report = [scene.bar.GetPropertyValue(name) for name in LEGEND]
        self.assertEqual(json.loads(json.dumps(of_report, default=list)), found["legend"])
        own, shared, usual = found["colors"]
        self.assertEqual(shared, usual)
        self.assertNotEqual(own, usual)
        self.assertEqual(found["charts"], [["flange.visf", title, "Cells", 0]])
        # All columns are listed, or a state that is loaded shows those that are not.
        self.assertEqual([sorted(shown[1::2]) for shown in found["bars"]], [["0"] * 11 + ["1"]])
        self.assertEqual(found["rows"], [2])
        self.assertEqual(found["active"], "RenderView")
        self.assertEqual(found["views"], ["RenderView", "SpreadSheetView", "XYBarChartView"])

    def test_constant(self):
        """Values that rounding alone tells apart, of cells that no range judges, are pale."""
        cases = (90, 10)
        colors = {value: self.folder / f"{value}.json" for value in cases}
        events = []
        for value, path in colors.items():
            mesh = self.folder / f"{value}.vti"
            values = value * (1 + 1e-9 * numpy.arange(4))
            write_row(mesh, values, ("MinDihedralAngle", "Volume"))
            events += [
                *open_file(str(mesh)),
                apply(),
                *(self.script("light", LIGHT) if value == cases[-1] else []),
                show_inspector(),
                event(card("Histogram", "Criterion"), "set_string", "Volume"),
                event(card("Histogram", "Criterion"), "set_string", "Minimum dihedral angle"),
                *self.script(f"colors{value}", COLORS.replace("PATH", repr(str(path)))),
            ]
        self.play(*events)
        look = servermanager.misc.QualityColors()
        for value in cases:
            found, drawn = json.loads(colors[value].read_text())
            self.assertAlmostEqual(found[-4], value, places=5)
            self.assertGreater(min(found[-3:]), 0.9)
            light = [0.1, 1.0] if value == cases[-1] else [look.Ambient, look.Diffuse]
            self.assertEqual(drawn, [*light, *look.EdgeColor, look.EdgeOpacity])

    def test_not_judged(self):
        """Cells that the range is not for have a color and a word in the legend, beside those without a value."""
        mesh, marks = self.folder / "mixed.vtu", self.folder / "marks"
        grid = gallery.mixed()
        number = grid.GetNumberOfCells()
        angles = numpy.linspace(1, 60, number)
        undefined = numpy.where(numpy.arange(number) < 3, float("nan"), angles)
        values = {"MinDihedralAngle": undefined, "MaxDihedralAngle": angles, "Volume": angles}
        for name, of_cells in values.items():
            array = numpy_to_vtk(of_cells, deep=True)
            array.SetName(name)
            grid.GetCellData().AddArray(array)
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetFileName(str(mesh))
        writer.SetInputData(grid)
        writer.Write()
        look = lambda name: self.script(name, MARKS.replace("PATH", repr(str(marks))))
        choose = lambda label: event(card("Histogram", "Criterion"), "set_string", label)
        self.play(
            *open_file(str(mesh)),
            apply(),
            *self.script("inspect", CHANGE.replace("TYPE", "Mesh Inspection")),
            show_inspector(),
            choose("Volume"),
            choose("Minimum dihedral angle"),
            *look("both"),
            choose("Volume"),
            edit("Undo"),
            *look("undone"),
            choose("Volume"),
            *look("neither"),
            choose("Maximum dihedral angle"),
            *look("one"),
        )
        both, undone, neither, one = map(json.loads, marks.read_text().splitlines())
        self.assertEqual(both[:4], [1, 1, 1, "not judged \u2013\nundefined \u2013\n "])
        self.assertNotEqual(*both[4])
        self.assertEqual(neither[:3], [0, 0, 0])
        self.assertEqual(undone, both)
        self.assertEqual(one[:4], [1, 0, 1, "not judged"])
        self.assertEqual(one[4][0], both[4][1])

    def test_series(self):
        """The legend has the range of the values of each time step, and a criterion without values the color of undefined
        ones."""
        steps = [[30, 40, 50], [1, 40, 160], [float("nan")] * 3]
        files = [self.folder / f"step{i}.vti" for i in range(len(steps))]
        for path, values in zip(files, steps):
            write_row(path, numpy.array(values, dtype=float), ("MinDihedralAngle", "Volume"))
        series = self.folder / "series.pvd"
        sets = "".join(f'<DataSet timestep="{i}" file="{f.name}"/>' for i, f in enumerate(files))
        series.write_text(f'<VTKFile type="Collection"><Collection>{sets}</Collection></VTKFile>')
        found = [self.folder / f"{i}.json" for i in range(len(steps))]
        events = [*open_file(str(series)), apply(), show_inspector()]
        events += [event(card("Histogram", "Criterion"), "set_string", "Volume")]
        events += [event(card("Histogram", "Criterion"), "set_string", "Minimum dihedral angle")]
        for i, path in enumerate(found):
            events += self.script(path.stem, COLORS.replace("PATH", repr(str(path))))
            if i + 1 < len(steps):
                events += self.script(f"next{i}", NEXT)
        self.play(*events)
        points = [json.loads(path.read_text())[0] for path in found]
        self.assertEqual([(p[0], p[-4]) for p in points], [(30, 50), (1, 160), (0, 1)])

    def test_work(self):
        """While criteria are evaluated, Worst says so, not that one should evaluate."""
        self.require_events()
        summary = card("Worst", "Summary")
        self.play(
            *open_file("flange.visf"),
            apply(),
            show_inspector(),
            check(summary, "text", "Evaluate a criterion to see its worst cells."),
            event(WINDOW, "resize", "1600,980"),
            event(summary, "seen"),
            event(summary, "watch"),
            event(WINDOW, "events"),
            event(card("Criteria", "Preset"), "set_string", "General"),
            event(card("Criteria", "Evaluate"), "activate"),
            event(summary, "painted", "Evaluating..."),
            check(card("Histogram", "Criterion"), "enabled", "true"),
        )

    def test_words(self):
        """Cell types and defects are words; the element's card says what is where. The space bar unfolds a card, and on
        a rule selects the cells that fail it. Presets for other shapes than those of the cells are gray, and those for
        cells of second order where all are linear.
        """
        title, space, down = f"{CARDS}/Check/Title", "32", "16777237"
        bricks, curved = self.folder / "bricks.vtu", self.folder / "curved.vtu"
        points, cubes = gallery.lattice(2, 1, 1)
        hexahedra = gallery.make_grid(points, [(VTK_HEXAHEDRON, cube) for cube in cubes])
        cells = [(VTK_POLYHEDRON, gallery.faces(hexahedra, cell)) for cell in range(2)]
        polyhedra = gallery.make_grid(points, cells)
        for path, grid in ((bricks, polyhedra), (curved, gallery.quadratic(hexahedra))):
            writer = vtkXMLUnstructuredGridWriter()
            writer.SetFileName(str(path))
            writer.SetInputData(grid)
            writer.Write()
        others = "FEM tetrahedra, Surface"
        table = card("Check", "Verdicts")
        self.play(
            *start(),
            check(
                card("Mesh", "Types"),
                "text",
                "3264\u00a0tetrahedra, 528\u00a0hexahedra, 192\u00a0wedges, 96\u00a0pyramids",
            ),
            check(card("Criteria", "Preset"), "grayed", "FEM second order, Surface"),
            check(f"{CARDS}/Check", "open", "false"),
            event(title, "key", space),
            check(f"{CARDS}/Check", "open", "true"),
            event(card("Check", "Rules"), "set_string", "MinDihedralAngle >= 25"),
            event(card("Check", "Check"), "activate"),
            event(table, "key", down),
            event(table, "key", space),
            *open_card("Selection"),
            check(
                card("Selection", "Summary"),
                "text",
                "<b>246</b> of 4080 cells selected (6.03\u00a0%)",
            ),
            check(card("Criteria", "Tree"), "selectedCounts", "246"),
            *open_card("Element"),
            event(card("Worst", "Next"), "activate"),
            check(
                card("Element", "Summary"),
                "text",
                "Cell 1776: tetrahedron at -0.56, 0.1841, 0.6396",
            ),
            *open_file("voronoi-ball.visf"),
            apply(),
            show_inspector(),
            check(
                card("Criteria", "Preset"),
                "grayed",
                "FEM hexahedra, FEM second order, FEM tetrahedra, Surface",
            ),
            *open_file(str(bricks)),
            apply(),
            show_inspector(),
            check(card("Criteria", "Preset"), "grayed", f"FEM second order, {others}"),
            *open_file(str(curved)),
            apply(),
            show_inspector(),
            check(card("Criteria", "Preset"), "grayed", others),
        )


if __name__ == "__main__":
    unittest.main()
