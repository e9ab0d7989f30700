# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""In ParaView's window: bad places, and flights in unusual scenes and to broken cells."""

import json
import unittest

import camaron_testing
from paraview import simple
from TestMeshInspector import COUNT, PICK, SCENE, card, open_card, start
from TestMeshInspectorElements import start as start_elements
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter
from window_testing import WINDOW, WindowTestCase, check, edit, event, show_inspector

#: Writes which cells are drawn.
CELLS_DRAWN = """
from paraview import simple
with open(PATH, "w") as file:
    file.write(f"{simple.GetDisplayProperties(simple.GetActiveSource()).CellsToDraw}")
"""

#: Writes how the mesh is cut.
CUT = """
from paraview import simple
display = simple.GetDisplayProperties(simple.GetActiveSource())
normal = [round(x) for x in display.CutShape.Normal]
with open(PATH, "w") as file:
    file.write(f"{display.CutBy} {display.CutShape.GetXMLName()} {normal} {display.CutKeeps}")
"""
#: Normals and sides after each button.
CUT_SIDES = [("[1, 0, 0]", "Outside"), ("[0, 1, 0]", "Outside"), ("[0, 1, 0]", "Inside")]

#: Opens a file of Fluent with both of its outputs in the view.
FLUENT = """
from paraview import simple
mesh = simple.FluentMeshReader(FileNames=[PATH])
view = simple.GetActiveViewOrCreate("RenderView")
for port in (0, 1):
    simple.Show(simple.OutputPort(mesh, port), view)
simple.SetActiveSource(mesh)
simple.Render()
"""

#: Writes what the view shows: the outputs of the reader, and the active source.
SHOWN = """
from paraview import simple
mesh = [source for source in simple.GetSources().values() if "Fluent" in source.GetXMLName()][0]
shown = [simple.OutputPort(mesh, 0), simple.OutputPort(mesh, 1), simple.GetActiveSource()]
with open(PATH, "w") as file:
    file.write(" ".join(str(simple.GetDisplayProperties(source).Visibility) for source in shown))
"""

#: Makes the mesh before the step of selection active.
BEFORE = """
from paraview import simple
simple.SetActiveSource(simple.GetActiveSource().Input)
"""

#: Splits the view; the new one, which shows nothing, is active.
SPLIT = """
from paraview import simple
simple.GetLayout().SplitHorizontal(0, 0.5)
simple.SetActiveView(None)
simple.SetActiveView(simple.CreateRenderView())
"""


def write_tetrahedra(path, points, cells):
    grid = vtkUnstructuredGrid()
    grid.SetPoints(vtkPoints())
    for point in points:
        grid.GetPoints().InsertNextPoint(point)
    for cell in cells:
        grid.InsertNextCell(VTK_TETRA, 4, cell)
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(grid)
    writer.Write()


class TestMeshInspectorFlights(WindowTestCase):
    def scene(self, path):
        text = "import json\n" + SCENE.replace("PATH", repr(str(path)))
        return self.script(f"scene_{path.stem}", text)

    def test_places(self):
        """The button selects the cells of the listed places, not of others. Selecting and showing them, once or again, is
        one step of selection, and one of undo."""
        selected = self.folder / "selected"
        mesh = self.open(camaron_testing.EXAMPLES / "flange.visf")
        quality = simple.ElementQuality(Input=mesh, Preset="General")
        places = self.fetch(simple.QualityRegions(Input=quality, Array="MinDihedralAngle"))
        counts = places.GetColumnByName("Count")
        first = str(counts.GetVariantValue(0).ToInt())
        every = str(sum(counts.GetVariantValue(i).ToInt() for i in range(places.GetNumberOfRows())))
        self.assertNotEqual(first, every)
        self.play(
            *start(),
            *open_card("Selection"),
            *open_card("View"),
            event(card("Worst", "Rows"), "set_string", "Bad places"),
            event(card("Worst", "Number"), "set_int", "1"),
            event(card("Worst", "SelectListed"), "activate"),
            *self.script("count", COUNT.replace("PATH", repr(str(selected)))),
            event(card("Worst", "Number"), "set_int", "20"),
            event(card("Worst", "ShowListed"), "activate"),
            check(card("Criteria", "Tree"), "selectedCounts", every),
            check(card("Selection", "Steps"), "count", "1"),
            check(card("View", "OnlySelected"), "checked", "true"),
            edit("Undo"),
            check(card("Criteria", "Tree"), "selectedCounts", first),
            check(card("Selection", "Steps"), "count", "1"),
            check(card("View", "OnlySelected"), "checked", "false"),
        )
        self.assertEqual(selected.read_text(), first)

    def test_open(self):
        """The mesh closes without the button, and a flight that opens meshes opens it again. Back closes it also if a
        step of selection draws it meanwhile, and the one before that step."""
        scenes = [self.folder / f"{i}.json" for i in range(7)]
        self.play(
            *start(),
            *self.scene(scenes[0]),
            event(card("Worst", "Next"), "activate"),
            *self.scene(scenes[1]),
            event(card("Worst", "OpenMesh"), "activate"),
            *self.scene(scenes[2]),
            event(card("Worst", "OpenMesh"), "activate"),
            *self.scene(scenes[3]),
            *open_card("Selection"),
            event(card("Selection", "SelectWorst"), "activate"),
            *self.scene(scenes[4]),
            event(card("Worst", "Back"), "activate"),
            *self.scene(scenes[5]),
            *self.script("before", BEFORE),
            *self.scene(scenes[6]),
        )
        drawn = [json.loads(path.read_text())["drawn"] for path in scenes]
        self.assertNotEqual(drawn[1], drawn[0])
        self.assertEqual(drawn[2], drawn[0])
        self.assertEqual(drawn[3], drawn[1])
        self.assertNotEqual(drawn[4], drawn[0])
        self.assertEqual(drawn[5], drawn[0])
        self.assertEqual(drawn[6], drawn[0])

    def test_undo(self):
        """One undo goes back a flight, to cells or to faces: the mesh closes, the camera returns, and the mark is that of the
        flight before. Redo goes there again, and undo of Back, too."""
        flights = [event(card("Worst", "Next"), "activate")] * 2
        back, undo, redo = event(card("Worst", "Back"), "activate"), edit("Undo"), edit("Redo")
        ways = (  # each ends where the first or the second flight does, or where both begin
            (0, []),
            (1, flights[:1]),
            (2, flights),
            (1, [*flights, undo]),
            (0, [*flights, undo, undo]),
            (2, [*flights, undo, undo, redo, redo]),
            (0, [*flights, back]),
            (2, [*flights, back, undo]),
        )
        faces = start_elements("Faces", [4], "Non-orthogonality")
        for begin, tried in ((start(), ways), (faces, ways[:5])):
            places = {}
            for number, (place, way) in enumerate(tried):
                path = self.folder / f"{number}.json"
                self.play(*begin, *way, *self.scene(path))
                scene = json.loads(path.read_text())
                self.assertEqual(scene, places.setdefault(place, scene), number)
            self.assertEqual([places[i]["marked"] for i in range(3)], [0, 1, 1])
            self.assertNotEqual(places[0]["drawn"], places[1]["drawn"])
            self.assertEqual(len({tuple(scene["camera"]) for scene in places.values()}), 3)

    def test_neighbor(self):
        """A click on a neighbor in Element flies to it and marks it; undo goes back. So does the id of a cell."""
        before, there, by_id, after = (self.folder / f"{i}.json" for i in range(4))
        neighbors = card("Element", "Neighbors")
        click = [
            event(neighbors, "mousePress", "1,1,0,69,6"),
            event(neighbors, "mouseRelease", "1,0,0,69,6"),
        ]
        begin = [
            *start(),
            *open_card("Element"),
            *self.script("pick", PICK),
        ]
        self.play(*begin, *self.scene(before))
        self.play(*begin, *click, *self.scene(there), check(card("Element", "Id"), "text", "4"))
        self.play(*begin, *click, edit("Undo"), *self.scene(after))
        typed = [
            event(card("Element", "Id"), "set_string", "4"),
            event(card("Element", "Id"), "key", "16777220"),
        ]
        self.play(*start(), *open_card("Element"), *typed, *self.scene(by_id))
        scenes = [json.loads(path.read_text()) for path in (before, there, by_id, after)]
        self.assertEqual([scene["marked"] for scene in scenes], [0, 1, 1, 0])
        self.assertEqual(scenes[3], scenes[0])
        self.assertNotEqual(scenes[1]["camera"], scenes[0]["camera"])
        self.assertEqual(scenes[2], scenes[1])

    def test_all_at_once(self):
        """What is listed is selected and drawn alone, also after an opened row; Back shows the whole mesh again."""
        scenes = [self.folder / f"{i}.json" for i in range(5)]
        drawn, selected = [self.folder / name for name in ("drawn", "again")], self.folder / "count"
        self.play(
            *start(),
            event(card("Worst", "Number"), "set_int", "10"),
            check(
                card("Worst", "Summary"),
                "text",
                "By Minimum dihedral angle. Gray: not judged, the acceptable range is for tetrahedra",
            ),
            *self.scene(scenes[0]),
            event(card("Worst", "ShowListed"), "activate"),
            *self.script("count", COUNT.replace("PATH", repr(str(selected)))),
            *self.script("drawn", CELLS_DRAWN.replace("PATH", repr(str(drawn[0])))),
            *self.scene(scenes[1]),
            event(card("Worst", "Next"), "activate"),
            *self.scene(scenes[2]),
            event(card("Worst", "ShowListed"), "activate"),
            *self.scene(scenes[3]),
            event(card("Worst", "Back"), "activate"),
            *self.script("again", CELLS_DRAWN.replace("PATH", repr(str(drawn[1])))),
            *self.scene(scenes[4]),
        )
        whole, listed, opened, again, back = [json.loads(path.read_text()) for path in scenes]
        self.assertEqual(selected.read_text(), "10")
        self.assertEqual([path.read_text() for path in drawn], ["'Selected'", "'All'"])
        self.assertEqual(listed["drawn"][:2], ["'No cut'", 1])
        self.assertEqual((opened["drawn"][0], opened["marked"]), ("'Centroid'", 1))
        self.assertEqual((again["drawn"], again["marked"]), (listed["drawn"], 0))
        self.assertNotEqual(listed["camera"], whole["camera"])
        self.assertEqual(back, whole)

    def test_axes(self):
        """A button cuts along an axis, and another one keeps the other side."""
        cuts = [self.folder / name for name in ("x", "y", "other")]
        self.play(
            *start(),
            *open_card("View"),
            event(card("View", "CutX"), "activate"),
            *self.script("cut0", CUT.replace("PATH", repr(str(cuts[0])))),
            event(card("View", "CutY"), "activate"),
            *self.script("cut1", CUT.replace("PATH", repr(str(cuts[1])))),
            event(card("View", "Flip"), "activate"),
            *self.script("cut2", CUT.replace("PATH", repr(str(cuts[2])))),
        )
        self.assertEqual(
            [path.read_text() for path in cuts],
            [f"'Exactly' Plane {n} '{side}'" for n, side in CUT_SIDES],
        )

    def test_nan(self):
        """The camera does not follow a cell to a point that is not a number."""
        broken = self.folder / "broken.vtu"
        points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [float("nan"), 1, 1]]
        write_tetrahedra(broken, points, [[0, 1, 2, 3], [1, 2, 3, 4]])
        before, after = self.folder / "before.json", self.folder / "after.json"
        self.play(
            *start(str(broken)),
            event(card("Histogram", "Criterion"), "set_string", "Valid"),
            *open_card("Element"),
            *self.scene(before),
            event(card("Worst", "Next"), "activate"),
            check(card("Element", "Summary"), "text", "Cell 1: tetrahedron at NaN, 0.5, 0.5"),
            *self.scene(after),
        )
        self.assertEqual(json.loads(after.read_text()), json.loads(before.read_text()))

    def test_other_outputs(self):
        """Boundaries of a reader do not hide the mesh that was evaluated."""
        shown = self.folder / "shown"
        seeds = camaron_testing.ROOT / "Readers" / "FluentMesh" / "Testing" / "Seeds"
        mesh = min(seeds.glob("[!b]*.msh"))
        self.play(
            *self.script("open", FLUENT.replace("PATH", repr(str(mesh)))),
            show_inspector(),
            event(card("Criteria", "Preset"), "set_string", "General"),
            event(card("Criteria", "Evaluate"), "activate"),
            *self.script("shown", SHOWN.replace("PATH", repr(str(shown)))),
        )
        self.assertEqual(shown.read_text(), "0 0 1")

    def test_two_views(self):
        """The view that shows the mesh flies, though another one is active; it comes back."""
        before, there, after = (self.folder / f"{name}.json" for name in "abc")
        back = "simple.SetActiveView(simple.GetRenderViews()[0])\n"
        look = lambda path: self.script(
            f"scene_{path.stem}",
            "import json\nfrom paraview import simple\n"
            + back
            + SCENE.replace("PATH", repr(str(path)))
            + "simple.SetActiveView(simple.GetRenderViews()[-1])\n",
        )
        self.play(
            *start(),
            *self.script("split", SPLIT),
            *look(before),
            event(card("Worst", "Next"), "activate"),
            *look(there),
            event(card("Worst", "Back"), "activate"),
            *look(after),
        )
        before, there, after = (json.loads(path.read_text()) for path in (before, there, after))
        self.assertNotEqual(there["camera"], before["camera"])
        self.assertEqual(there["marked"], 1)
        self.assertEqual(after, before)


if __name__ == "__main__":
    unittest.main()
