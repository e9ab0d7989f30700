# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where ParaView has a reader of the same extension, a file that ours reads goes to ours, any other where it went."""

import gzip
import json
import os

import camaron
import camaron_testing
import gallery
import mesh_files
import TestClientServer
from camaron.common import formats, pipeline, reader_choice
from mesh_parts import producer
from paraview import servermanager, simple
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter
from window_testing import WINDOW, WindowTestCase, event, save_state

#: Files of every format that we read, each with the mesh that it is written of and what to set.
OURS = [
    *(file for file in TestClientServer.FILES if formats.own_readers(file[0])),
    *((f"m.{kind}", gallery.tetrahedra, {}) for kind in ("cas", "inp", "dat")),
]
#: Beginnings of files of other programs, and who read them before there was this plugin.
OTHERS = {
    "gmsh.msh": ("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", "FLUENTReader"),
    "abaqus.inp": ("*HEADING\n*NODE\n1, 0., 0., 0.\n*ELEMENT, TYPE=C3D4\n", "AVSucdSeriesReader"),
    "tecplot.dat": (
        'TITLE = "t"\nVARIABLES = "X", "Y"\nZONE I=2, F=POINT\n0 0\n1 1\n',
        "TecplotReader",
    ),
    "hdf5.cas": ("\x89HDF\r\n\x1a\n", "FLUENTReader"),
}
#: Names of readers before they had to come first.
FORMER = {"cas": "FluentMeshReader", "inp": "MAPDLReader", "ply": "PolygonPLYReader"}


def readers(path):
    """Names of those that can read a file, in the order in which ParaView lists them."""
    factory = servermanager.vtkSMProxyManager.GetProxyManager().GetReaderFactory()
    factory.UpdateAvailableReaders()
    found = factory.GetReaders(str(path), servermanager.ActiveConnection.Session)
    return [found.GetString(i) for i in range(1, found.GetNumberOfStrings(), 3)]


class TestReaderChoice(camaron_testing.TestCase):
    serve = TestClientServer.TestClientServer.serve

    def write(self, name, make, options):
        """A file of ours."""
        grid = self.folder / "grid.vtu"
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetFileName(str(grid))
        writer.SetInputData(make())
        writer.Write()
        path = self.folder / name
        deck = path.suffix in (".inp", ".dat")  # extensions that nobody writes
        writer = formats.make_writer(formats.own_writer("m.cdb" if deck else path))
        source = writer.Input = simple.OpenDataFile(str(grid))
        writer.FileName = str(path)
        for key, value in options.items():
            setattr(writer, key, value)
        writer.UpdatePipeline()
        del writer
        simple.Delete(source)
        return path

    def check(self):
        for name, make, options in OURS:
            with self.subTest(name):
                path = self.write(name, make, options)
                (own,) = formats.own_readers(path)
                self.assertEqual(readers(path)[0], own)
                source = simple.OpenDataFile(str(path))
                self.assertEqual(source.GetXMLName(), own)
                cells, _ = TestClientServer.measure(source)
                self.assertEqual(cells, make().GetNumberOfCells())
        for name, (text, reader) in OTHERS.items():
            with self.subTest(name):
                path = self.folder / name
                path.write_text(text, encoding="latin-1", newline="")
                self.assertEqual(readers(path)[0], reader)
                self.assertFalse(set(readers(path)) & set(formats.own_readers(path)))

    def test_compressed(self):
        """What has the name of a compressed file of ours is ours, also if it is of something else, of which ParaView's
        reader of Fluent meshes may never end."""
        for f in (f for f in formats.own_formats() if f["reader"]):
            for content in (b"hello\n", b"$MeshFormat\n2.2 0 8\n", gzip.compress(b"hello")):
                for extension in f["extensions"]:
                    path = self.folder / f"odd.{extension}.gz"
                    path.write_bytes(gzip.compress(content)[:-3])
                    source = reader_choice.make_reader(path, [])
                    self.assertEqual(source.SMProxy.GetXMLName(), f["reader"], path.name)
                    with self.assertRaisesRegex(RuntimeError, rf"{path.name}:"):
                        camaron.check(path, ["Volume > 0"])
                    simple.Delete(source)

    def test_foreign(self):
        """Of files of our extensions that ParaView's readers take but cannot read, our readers say what they expect."""
        contents = {
            "lower.off": b"off\n4 1 0\n",
            "wide.off": "OFF\n4 1 0\n".encode("utf-16"),
            "header.off": b"OFF\n",
            "tecplot.dat": b"hello\n",
            "abaqus.inp": b"*HEADING\n*NODE\n1, 0, 0, 0\n",
        }
        for name, content in contents.items():
            (self.folder / name).write_bytes(content)
            with self.assertRaisesRegex(
                RuntimeError, rf"{name}(:\d)?: expected .* found "
            ) as caught:
                camaron.check(self.folder / name, ["Volume > 0"])
            self.assertIn("of ParaView: ", str(caught.exception))

    def test_extension_in_the_middle(self):
        """The last extension counts in commands; ParaView's reader of Fluent never ends with m.msh.vtu."""
        grid = self.folder / "grid.vtu"
        simple.SaveData(
            str(grid), simple.AppendDatasets(Input=simple.Wavelet(WholeExtent=[0, 2] * 3))
        )
        for kind in ("exo", "cgns", "foam", "msh", "cas.h5", "csv", "visf", "2"):
            path = self.folder / f"m.{kind}.vtu"
            path.write_bytes(grid.read_bytes())
            series = self.folder / f"m.{kind}.vtu.series"
            series.write_text(f'{{"file-series-version": "1.0", "files": ["{path.name}"]}}')
            for name in (path, series):
                with self.subTest(name.name):
                    self.assertEqual(camaron.check(name, ["Volume > 0"])["cells"], 8)
            path.write_text("no mesh")
            with self.assertRaisesRegex(RuntimeError, r"no reader of \*.vtu files accepts"):
                camaron.check(path, ["Volume > 0"])
            if formats.own_readers(f"m.{kind}") == []:
                with self.assertRaisesRegex(RuntimeError, r"no reader of \*.vtu files accepts"):
                    reader_choice.make_reader(series, [])
        with gzip.open(path, "wb") as file:
            file.write(grid.read_bytes())
        with self.assertRaisesRegex(RuntimeError, r"is compressed \(gzip\), which"):
            camaron.check(path, ["Volume > 0"])
        numbered = self.folder / "part.exo.4.1"  # as Exodus names pieces
        tetrahedra = simple.Tetrahedralize(Input=self.open(grid))
        simple.SaveData(str(self.folder / "part.exo"), tetrahedra)
        (self.folder / "part.exo").rename(numbered)
        self.assertEqual(camaron.check(numbered, ["Volume > 0"])["cells"], 48)
        for source in list(simple.GetSources().values()):
            simple.Delete(source)

    def test_without_server(self):
        self.check()

    def test_server(self):
        self.addCleanup(simple.Connect)  # for the tests after it
        self.serve(2)
        self.check()

    def test_relative_name(self):
        """A server that runs in another folder finds the file of a name in the client's folder."""
        source = simple.AppendDatasets(Input=simple.Wavelet(WholeExtent=[0, 2] * 3))
        simple.SaveData(str(self.folder / "a.b.vtu"), source)
        series = self.folder / "a.b.vtu.series"
        series.write_text('{"file-series-version": "1.0", "files": ["a.b.vtu"]}')
        self.addCleanup(simple.Connect)  # for the tests after it
        self.serve(1)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        for name in ("a.b.vtu", series.name):
            with self.subTest(name):
                self.assertEqual(camaron.check(name, ["Volume > 0"])["cells"], 8)

    def test_order(self):
        """No reader of ParaView's that has an extension of ours comes first by name."""
        try:
            simple.LoadDistributedPlugin("GmshIO", remote=False, ns=vars(simple))
        except RuntimeError:
            pass  # this ParaView was built without it
        known = formats.known_formats()
        own = {kind.lower(): f.reader for f in known if f.own and f.reader for kind in f.extensions}
        rivals = 0
        for f in known:
            for kind in {kind.lower() for kind in f.extensions} & set(own):
                if f.reader and not f.own:
                    self.assertLess(own[kind] + "sources", f.reader + "sources", kind)
                    rivals += 1
        self.assertGreater(rivals, 4)

    def test_polyhedra_of_exodus(self):
        """ParaView's default reader refuses them; commands choose its other one, and say so."""
        grid = gallery.polyhedra()
        cells = [gallery.faces(grid, i) for i in range(grid.GetNumberOfCells())]
        path = self.folder / "poly.exo"
        mesh_files.write_exodus(path, gallery.points_of(grid), cells)
        opened = pipeline.open_mesh(path)
        self.assertEqual(opened.source.GetXMLName(), "ExodusIIReader")
        self.assertEqual(
            opened.warnings,
            [
                "This is an Exodus file with polyhedra; ParaView's own reader ExodusIIReader reads it."
            ],
        )
        simple.Delete(opened.source)
        summary = camaron.inspect(
            path, self.folder / "report", criteria=["Volume"], with_pictures=False
        )
        visf = self.folder / "poly.visf"
        simple.SaveData(str(visf), producer(grid))
        expected = camaron.inspect(
            visf, self.folder / "expected", criteria=["Volume"], with_pictures=False
        )
        for name in ("count", "min", "max", "mean"):
            values = [found["criteria"][0][name] for found in (summary, expected)]
            self.assertAlmostEqual(*values, 5, name)  # Visf has single precision

    def test_series(self):
        """A list of files and a file that lists them."""
        for name, make in (("m.ply", gallery.triangles), ("m.msh", gallery.tetrahedra)):
            path = self.write(name, make, {})
            (own,) = formats.own_readers(path)
            series = path.with_name(f"{name}.series")
            files = [{"name": name, "time": time} for time in (2, 3)]
            series.write_text(json.dumps({"file-series-version": "1.0", "files": files}))
            for files, times in (([str(path)] * 2, [0, 1]), (str(series), [2, 3])):
                source = simple.OpenDataFile(files)
                source.UpdatePipeline()
                self.assertEqual((source.GetXMLName(), list(source.TimestepValues)), (own, times))

    def test_former_names(self):
        """States that have one open; the names are in no list of readers and in no menu."""
        for kind, former in FORMER.items():
            path = self.write(
                f"m.{kind}", gallery.triangles if kind == "ply" else gallery.tetrahedra, {}
            )
            (own,) = formats.own_readers(path)
            source = simple.OpenDataFile(str(path))
            source.UpdatePipeline()
            cells = source.GetDataInformation().GetNumberOfCells()
            state = self.folder / "old.pvsm"
            simple.SaveState(str(state))
            text = state.read_text()
            self.assertIn(f'type="{own}"', text)
            state.write_text(text.replace(f'type="{own}"', f'type="{former}"'))
            simple.Delete(source)
            simple.LoadState(str(state))
            (source,) = simple.GetSources().values()
            source.UpdatePipeline()
            self.assertEqual(source.GetXMLName(), former)
            self.assertEqual(source.GetDataInformation().GetNumberOfCells(), cells)
            self.assertTrue(servermanager.vtkSMReaderReloadHelper().SupportsReload(source.SMProxy))
            self.assertNotIn(former, readers(path))
            label = servermanager.ProxyManager().GetPrototypeProxy("sources", own).GetXMLLabel()
            self.assertEqual(source.GetXMLLabel(), label)
            simple.Delete(source)


class TestInWindow(WindowTestCase, TestReaderChoice):
    """The window asks which of several readers to take, and has ours as the answer."""

    test_without_server = test_server = test_relative_name = None
    test_order = test_series = test_former_names = None

    def test_dialog(self):
        path = self.write("m.msh", gallery.tetrahedra, {})
        state = self.folder / "state.pvsm"
        dialog = f"{WINDOW}/pqSelectReaderDialog"
        self.play(
            event(f"{WINDOW}/MainControlsToolbar/actionOpenData", "activate"),
            event(f"{WINDOW}/FileOpenDialog", "filesSelected", str(path)),
            event(f"{dialog}/okButton", "activate"),
            *save_state(state),
        )
        (own,) = formats.own_readers(path)
        self.assertIn(f'type="{own}"', state.read_text())


if __name__ == "__main__":
    camaron_testing.main()
