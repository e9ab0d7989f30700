# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""In ParaView's window: the Mesh Inspector gives the numbers of NumPy, `camaron check` and itself after loading a state."""

import csv
import unittest
from pathlib import Path

import camaron
import camaron_testing
import gallery
import mesh_files
import numpy
from TestMeshInspector import (
    CARDS,
    COUNT,
    CTRL,
    PLOT,
    SHIFT,
    STEPS,
    card,
    double_click,
    open_card,
    start,
)
from TestMeshInspector import drag as drag_bars
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter
from window_testing import (
    WINDOW,
    WindowTestCase,
    apply,
    check,
    event,
    open_file,
    save_state,
    show_inspector,
)

#: Of a Gmsh mesh without the plugin that reads it: ParaView's reader of Fluent cases accepts any .msh.
GMSH = (
    "gmsh.msh is empty. If the file is a Gmsh mesh, load ParaView's plugin GmshIO with Tools > Manage Plugins, "
    "and open it with the Gmsh Reader."
)
#: Of an Exodus file with polyhedra, which ParaView's reader refuses.
EXODUS = (
    "poly.exo is empty. If the file has polyhedra, load ParaView's plugin LegacyExodusReader with "
    "Tools > Manage Plugins, and open it with the Legacy Exodus II Reader."
)

#: The first columns of a table of tetrahedra and others that is sorted by an angle.
COLUMNS = [f'"{name}"' for name in ("Id", "CellType", "X", "Y", "Z", "MinDihedralAngle")]

NAN, INFINITY = float("nan"), float("inf")


def write_row(path, values, names=("MinDihedralAngle",), texts=None):
    """A row of boxes with criteria of these values, and perhaps an array of texts after its name, which the ranks of a
    server divide."""
    image = vtkImageData()
    image.SetDimensions(len(values) + 1, 2, 2)
    for name in names:
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        image.GetCellData().AddArray(array)
    if texts:
        array = vtkStringArray()
        array.SetName(texts[0])
        for text in texts[1]:
            array.InsertNextValue(text)
        image.GetCellData().AddArray(array)
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(image)
    writer.Write()


def drag(first, last, modifiers=0):
    """A drag over the bars from one value to another."""
    return event(PLOT, "drag", f"{first},{last},bars,{modifiers}")


class TestMeshInspectorNumbers(WindowTestCase):
    def test_other_array(self):
        """The histogram shows any cell array, stacks by texts, colors the mesh by it, and selects cells by it. What has no cells says why."""
        mesh, colored = self.folder / "row.vti", self.folder / "colored"
        gmsh = self.folder / "gmsh.msh"
        gmsh.write_text("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n")
        exodus, polyhedra = self.folder / "poly.exo", gallery.polyhedra()
        cells = [gallery.faces(polyhedra, i) for i in range(polyhedra.GetNumberOfCells())]
        mesh_files.write_exodus(exodus, gallery.points_of(polyhedra), cells)
        texts = ("rotor", "stator", "rotor", "rotor")
        write_row(mesh, numpy.array([20, 20.5, 21, 90]), ("Temperature",), ("Zone", texts))
        array = """
from paraview import simple
with open(PATH, "w") as file:
    file.write(simple.GetDisplayProperties(simple.GetActiveSource()).ColorArrayName[1])
"""
        self.play(
            *open_file(str(mesh)),
            apply(),
            show_inspector(),
            event(card("Histogram", "Criterion"), "set_string", "Temperature"),
            event(card("Histogram", "Group"), "set_string", "By Zone"),
            check(PLOT, "groupCounts", "rotor 3, stator 1"),
            drag(85, 95),
            check(PLOT, "brushedCount", "1"),
            check(card("Histogram", "Brush"), "text", "1 of 4 cells selected (25\u00a0%)"),
            check(card("Histogram", "CopyRule"), "enabled", "false"),
            *self.script("array", array.replace("PATH", repr(str(colored)))),
            *open_file(str(gmsh)),
            apply(),
            check(card("Mesh", "Counts"), "text", GMSH),
            *open_file(str(exodus)),
            apply(),
            check(card("Mesh", "Counts"), "text", EXODUS),
        )
        self.assertEqual(colored.read_text(), "Temperature")

    def test_outline(self):
        """Of two other meshes with the same name, the histogram outlines the one that was chosen, in its own bins."""
        meshes = {"a": (10.3, 20.1, 30.9), "b": (12.1, 33.1, 34.2), "c": (10.25, 20.5, 30.5, 40.25)}
        for name, values in meshes.items():
            (self.folder / name).mkdir()
            write_row(self.folder / name / "row.vti", numpy.array(values), ("Temperature",))
        outline = card("Histogram", "Outline")
        self.require_events()
        self.play(
            *[
                step
                for name in meshes
                for step in (*open_file(str(self.folder / name / "row.vti")), apply())
            ],
            show_inspector(),
            event(card("Histogram", "Criterion"), "set_string", "Temperature"),
            event(card("Histogram", "Bins"), "set_int", "2"),
            check(PLOT, "binCounts", "2 2"),
            check(PLOT, "outlineCounts", ""),
            event(outline, "menu", "1"),
            check(PLOT, "outlineCounts", "2 1"),
            event(outline, "menu", "2"),
            check(PLOT, "outlineCounts", "1 2"),
            event(outline, "menu", "0"),
            check(PLOT, "outlineCounts", ""),
        )

    def values(self):
        """Integers from 0 to 100, which the edges of the bins are too, and values of no bin."""
        repeated = numpy.repeat(numpy.arange(101.0), 1 + numpy.arange(101) % 7)
        return numpy.concatenate([repeated, [NAN] * 5, [INFINITY] * 3, [-INFINITY] * 2])

    def test_edges(self, options=()):
        """Values at the edges of bins, undefined and infinite ones: bars, selection and exported rows are the same."""
        values, mesh = self.values(), self.folder / "values.vti"
        write_row(mesh, values)
        tables = [self.folder / f"{name}.csv" for name in ("some", "all", "special")]
        export = lambda path: [
            event(card("Selection", "ExportTable"), "activate"),
            event(f"{CARDS}/Selection/ExportSelection", "filesSelected", str(path)),
        ]
        some = values[(values >= 20) & (values < 40)]
        more = values[(values >= 60) & (values <= 100)]
        self.require_events()
        self.play(
            *open_file(str(mesh)),
            apply(),
            show_inspector(),
            event(card("Histogram", "Criterion"), "set_string", "Minimum dihedral angle"),
            event(card("Histogram", "Bins"), "set_int", "20"),
            *open_card("Selection"),
            drag(21, 39),
            check(PLOT, "brushedCount", len(some)),
            *export(tables[0]),
            drag(61, 99, SHIFT),
            check(PLOT, "brushedCount", len(some) + len(more)),
            drag(-1000, 1000),
            check(PLOT, "brushedCount", len(values)),
            *export(tables[1]),
            drag(1, 99, CTRL),
            check(PLOT, "brushedCount", 10),
            *export(tables[2]),
            options=options,
        )
        for path, expected in zip(tables, (some, values, values[~numpy.isfinite(values)])):
            with open(path, newline="", encoding="utf-8") as file:
                found = [float(row["MinDihedralAngle"]) for row in csv.DictReader(file)]
            numpy.testing.assert_array_equal(numpy.sort(found), numpy.sort(expected))

    def test_edges_of_server(self):
        """The same on a server of three ranks."""
        self.test_edges(self.serve(3))

    def test_tables_of_server(self):
        """On a server of two ranks, all tables are as on one, but that ids are global ids: the current criterion after what says
        which cell it is, no column without values, worst first."""
        folders = [self.folder / name for name in ("alone", "served")]
        for folder, options in zip(folders, ((), self.serve())):
            self.play(
                *start(),
                *drag_bars(5, 2000),
                *open_card("Selection"),
                event(card("Selection", "ExportTable"), "activate"),
                event(f"{CARDS}/Selection/ExportSelection", "filesSelected", f"{folder}.csv"),
                *open_card("Report"),
                event(card("Report", "SaveTables"), "activate"),
                event(f"{CARDS}/Report/SaveTablesDialog", "filesSelected", folder),
                options=options,
            )
        selected = [Path(f"{folder}.csv").read_text().splitlines() for folder in folders]
        self.assertEqual(selected[0][0].split(",")[:6], COLUMNS)
        self.assertEqual(len(selected[0]), 4081)
        self.assertTrue(selected[1] == selected[0])
        for name in ("statistics.csv", "histogram.csv", "worst.csv"):
            with self.subTest(name):
                alone, served = ((folder / name).read_text() for folder in folders)
                served = served.replace('"Global id"', '"Index"')
                self.assertGreater(len(alone.splitlines()), 10)
                self.assertTrue(served == alone)

    def test_history(self):
        """An earlier brush, and a step after it, are selected again; also a step whose filter has changed."""
        counts = [self.folder / str(i) for i in range(6)]
        count = lambda i: self.script(f"count{i}", COUNT.replace("PATH", repr(str(counts[i]))))
        history = card("Selection", "History")
        self.require_events()
        self.play(
            *start(),
            *open_card("Selection"),
            drag(21, 24),
            *count(0),
            drag(30, 40),
            event(card("Selection", "Grow"), "activate"),
            *count(1),
            event(history, "menu", "2"),
            *count(2),
            check(card("Selection", "Steps"), "count", "1"),
            event(history, "menu", "0"),
            *count(3),
            check(card("Selection", "Steps"), "count", "2"),
            event(card("Selection", "Grow"), "activate"),
            *count(4),
            check(card("Selection", "Steps"), "count", "2"),
            event(history, "menu", "1"),
            *count(5),
        )
        counts = [int(path.read_text()) for path in counts]
        self.assertNotEqual(counts[0], counts[1])
        self.assertEqual(counts[2:4], counts[:2])
        self.assertGreater(counts[4], counts[1])
        self.assertEqual(counts[5], counts[1])

    def test_events(self):
        """Filters take long enough for the window to handle events meanwhile."""
        values, mesh = numpy.arange(400000.0), self.folder / "values.vti"
        write_row(mesh, values)
        counts = [self.folder / str(i) for i in range(2)]
        count = lambda i: self.script(f"count{i}", COUNT.replace("PATH", repr(str(counts[i]))))
        self.require_events()
        self.play(
            event(WINDOW, "events"),
            *open_file(str(mesh)),
            apply(),
            show_inspector(),
            event(card("Histogram", "Criterion"), "set_string", "Minimum dihedral angle"),
            *open_card("Selection"),
            drag(1000, 9000),
            check(card("Criteria", "Tree"), "selectedCounts", "16000"),
            *count(0),
            event(card("Selection", "Grow"), "activate"),
            check(card("Criteria", "Tree"), "selectedCounts", "16001"),
            *count(1),
        )
        self.assertEqual([int(path.read_text()) for path in counts], [16000, 16001])

    def test_limit(self):
        """The handle of a limit is dragged with the mouse; verdict and field follow."""
        self.require_events()
        self.play(
            *start(),
            check(PLOT, "acceptableLow", "20"),
            event(PLOT, "drag", "20,35,handles,0"),
            check(PLOT, "acceptableLow", "35"),
            check(card("Histogram", "Limits/Lower"), "text", "35"),
            event(card("Histogram", "CopyRule"), "activate"),
            event(card("Check", "Check"), "activate"),
            check(f"{CARDS}/Check", "counts", f"{self.failing('MinDihedralAngle >= 35')}/4080"),
        )

    def failing(self, rule):
        mesh = camaron_testing.EXAMPLES / "flange.visf"
        return camaron.check(mesh, [rule])["checks"][0]["failing"]

    def test_check(self):
        """Card and command judge each example alike, by all rules of a file and of a preset."""
        events = []
        for mesh in sorted(camaron_testing.EXAMPLES.glob("*.visf")):
            events += [*open_file(mesh.name), apply()]
            for rules in ("MinDihedralAngle >= 20\nMinInteriorAngle >= 60", 'preset "General"'):
                report = camaron.check(mesh, rules.splitlines())
                counts = [f'{rule["failing"]}/{rule["checked"]}' for rule in report["checks"]]
                events += [
                    event(card("Check", "Rules"), "set_string", rules),
                    event(card("Check", "Check"), "activate"),
                    check(f"{CARDS}/Check", "verdict", report["verdict"]),
                    check(f"{CARDS}/Check", "counts", " ".join(counts)),
                ]
        self.play(*start(), *open_card("Check"), *events)

    def test_loaded_state(self):
        """A state loaded in the window has the same criteria, histogram and selected cells, and goes back to the brush
        with which the steps began."""
        state, selected, loaded = (self.folder / n for n in ("s.pvsm", "selected", "loaded"))
        brushed, again = self.folder / "brushed", self.folder / "again"
        names, steps = card("Criteria", "Tree"), card("Selection", "Steps")
        self.require_events()
        self.play(
            *start(),
            drag(21, 24),
            *self.script("brushed", COUNT.replace("PATH", repr(str(brushed)))),
            *open_card("Selection"),
            event(card("Selection", "Grow"), "activate"),
            *self.script("count", COUNT.replace("PATH", repr(str(selected)))),
            *save_state(str(state)),
            *self.script("reset", "from paraview import simple\nsimple.ResetSession()"),
            check(PLOT, "binCounts", ""),
            check(names, "ticks", ""),
            event(f"{WINDOW}/menubar/menu_File", "activate", "actionFileLoadServerState"),
            event(f"{WINDOW}/FileLoadServerStateDialog", "filesSelected", str(state)),
            event("LoadStateOptionsDialog/widget/OKButton", "activate"),
            *self.script("loaded", STEPS.replace("PATH", repr(str(loaded)))),
            check(card("Histogram", "Criterion"), "currentText", "Minimum dihedral angle"),
            check(PLOT, "acceptableLow", "20"),
            check(steps, "count", "2"),
            *double_click(steps, 0),
            *self.script("again", COUNT.replace("PATH", repr(str(again)))),
            check(steps, "count", "1"),
        )
        self.assertGreater(int(selected.read_text()), 0)
        self.assertEqual(loaded.read_text(), selected.read_text())
        self.assertEqual(again.read_text(), brushed.read_text())


if __name__ == "__main__":
    unittest.main()
