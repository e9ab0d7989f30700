# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Formats, criteria and surface on a pvserver of one and of two ranks, from a client."""

import tempfile
from pathlib import Path

import camaron_testing
import gallery
from camaron.common import formats, pipeline
from paraview import simple
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

CRITERIA = ["Volume", "MinDihedralAngle", "FaceCount"]
#: Files of every format, each with the mesh that it is written of and what to set.
FILES = [
    *(
        (f"m.{kind}", gallery.tetrahedra, {})
        for kind in ("visf", "m3d", "ts", "ele", "msh", "cdb", "msh.h5", "foam")
    ),
    *((f"m.{kind}", gallery.triangles, {}) for kind in ("tri", "off", "ply")),
    ("gocad.ts", gallery.triangles, {"Dialect": "GOCAD"}),
]


def measure(source):
    """Number of cells that no other rank has, and their volume or area."""
    own = simple.RemoveGhostInformation(Input=source)
    own.UpdatePipeline()
    total = simple.IntegrateVariables(Input=own)
    total.UpdatePipeline()
    (array,) = (name for name in ("Volume", "Area") if total.CellData[name])
    return own.GetDataInformation().GetNumberOfCells(), total.CellData[array].GetRange()[0]


class TestClientServer(camaron_testing.TestCase):
    def serve(self, ranks):
        """Starts a server that answers one client, and connects to it."""
        port = self.start_server(ranks)
        self.assertIsNotNone(simple.Connect("127.0.0.1", port))
        self.addCleanup(simple.Disconnect)
        library = camaron_testing.plugin_folder() / "Camaron.so"
        simple.LoadPlugin(str(library), remote=True, ns=vars(simple))

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        quality, cls.alone = cls.evaluate()
        cls.saved = cls.save(quality)

    @staticmethod
    def save(proxy):
        """What Save Data writes, as one file however many ranks there are."""
        with tempfile.TemporaryDirectory() as folder:
            target = Path(folder) / "saved.visf"
            simple.SaveData(str(target), proxy)
            return target.read_bytes()

    @staticmethod
    def evaluate():
        source = simple.OpenDataFile(str(camaron_testing.EXAMPLES / "voronoi-ball.visf"))
        quality = simple.ElementQuality(Input=source, Criteria=CRITERIA)
        quality.UpdatePipeline()
        found = {name: quality.CellData[name].GetRange() for name in CRITERIA}
        # Every rank has its share of the cells, and ghosts beside it.
        own = simple.RemoveGhostInformation(Input=quality)
        own.UpdatePipeline()
        found["cells"] = own.GetDataInformation().GetNumberOfCells()
        return quality, found

    def check(self, ranks):
        self.serve(ranks)
        quality, served = self.evaluate()
        self.assertEqual(served, self.alone)
        self.assertEqual(self.save(quality), self.saved)
        surface = simple.MeshSurface(Input=quality)
        surface.UpdatePipeline()
        self.assertGreater(surface.GetDataInformation().GetNumberOfCells(), 100)

    def check_formats(self):
        """All formats are written and read there, with the mesh on one rank or on all."""
        writers = {formats.own_writer(name) for name, *_ in FILES}
        self.assertEqual(writers, {f["writer"] for f in formats.own_formats()})
        for name, make, options in FILES:
            grid, path = make(), self.folder / f"{make.__name__}.vtu"
            writer = vtkXMLUnstructuredGridWriter()
            writer.SetFileName(str(path))
            writer.SetInputData(grid)
            writer.Write()
            source = self.open(path)
            cells, size = measure(source)
            self.assertEqual(cells, grid.GetNumberOfCells())
            for path in (self.folder / "first" / name, self.folder / "again" / name):
                path.parent.mkdir(exist_ok=True)
                simple.SaveData(str(path), source, **options)
                source = pipeline.open_mesh(path).source
                reader = source.SMProxy.GetXMLName()
                self.assertIn(reader, formats.own_readers(path) or ["OpenFOAMReader"])
                found_cells, found_size = measure(source)
                self.assertEqual(found_cells, cells, path.name)
                self.assertAlmostEqual(found_size, size, msg=path.name, delta=1e-6 * size)

    def test_one_rank(self):
        self.check(1)

    def test_two_ranks(self):
        self.check(2)
        self.check_formats()


if __name__ == "__main__":
    camaron_testing.main()
