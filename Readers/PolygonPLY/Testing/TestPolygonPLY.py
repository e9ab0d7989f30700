# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""PLY files in ParaView: opening, saving with chosen arrays, series, on any number of ranks."""

import struct
from pathlib import Path

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkIOPLY import vtkPLYReader

import camaron_testing
import gallery
from camaron.common import formats, pipeline

ENCODINGS = ["ASCII", "Binary Little Endian", "Binary Big Endian"]


def strip(columns):
    """Points and faces: quadrilaterals with a triangle at the end."""
    points = [(i // 2, i % 2, 0.1 * i) for i in range(2 * columns + 2)]
    faces = [(2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1) for i in range(columns)] + [(0, 1, 2)]
    return points, faces


def surface(columns):
    """A file of a strip in big endian, with values of points and faces."""
    points, faces = strip(columns)
    header = f"""ply
format binary_big_endian 1.0
element vertex {len(points)}
property double x
property double y
property double z
property ushort number
element face {len(faces)}
property list uchar uint vertex_indices
property float area
end_header
"""
    body = b"".join(struct.pack(">dddH", *p, i) for i, p in enumerate(points))
    body += b"".join(struct.pack(f">B{len(f)}If", len(f), *f, 0.5 * i) for i, f in enumerate(faces))
    return header.encode() + body


class TestPolygonPLY(camaron_testing.FormatTestCase):
    def write(self, name, data):
        """A file that all ranks see."""
        path = self.folder / name
        path.write_bytes(data)
        return path

    def read(self, *paths):
        with pipeline.Messages() as messages:
            source = simple.PolygonPLYReader(FileNames=[str(p) for p in paths])
            source.UpdatePipeline()
        self.assertEqual(messages.errors, [])
        return source

    def information(self, source):
        """Number of cells, and the range of their values, without ghosts."""
        cleaned = simple.RemoveGhostInformation(Input=source)
        cleaned.UpdatePipeline(source.SMProxy.GetDataInformation(0).GetTime())
        cells = cleaned.GetDataInformation().GetNumberOfCells()
        values = cleaned.CellData.GetArray("area").GetRange()
        simple.Delete(cleaned)
        return cells, values

    def rows(self, path):
        """The numbers of a file in text."""
        body = path.read_text().split("end_header\n")[1]
        return [[float(word) for word in line.split()] for line in body.splitlines()]

    def save(self, path, source, **options):
        """Writes with our writer; ParaView chooses its own for surfaces."""
        writer = formats.make_writer("PolygonPLYWriter")
        writer.Input = source
        writer.FileName = str(path)
        for key, value in options.items():
            setattr(writer, key, value)
        with pipeline.Messages() as messages:
            writer.UpdatePipeline()
        self.assertEqual(messages.errors, [])

    def test_reader_of_paraview(self):
        """ParaView's own reader, which others use, too, finds normals, colors and texture."""
        if camaron_testing.rank_count() > 1:
            self.skipTest("one process is enough")
        random = numpy.random.default_rng(3)
        grid = gallery.polygons()
        points, cells = grid.GetPointData(), grid.GetCellData()
        size = grid.GetNumberOfPoints()
        arrays = {
            "Normals": random.random((size, 3)).astype("f4"),
            "TCoords": random.random((size, 2)).astype("f4"),
            "RGB": random.integers(0, 256, (size, 3)).astype("u1"),
        }
        colors = random.integers(0, 256, (grid.GetNumberOfCells(), 3)).astype("u1")
        for data, name, values in (
            *((points, name, values) for name, values in arrays.items()),
            (cells, "RGB", colors),
        ):
            array = numpy_to_vtk(values, deep=True)
            array.SetName(name)
            data.AddArray(array)
        source = simple.TrivialProducer()
        source.GetClientSideObject().SetOutput(grid)
        for encoding in ENCODINGS:
            path = self.folder / "p.ply"
            self.save(path, source, Encoding=encoding)
            reader = vtkPLYReader()
            reader.SetFileName(str(path))
            reader.Update()
            read = reader.GetOutput()
            for name, values in arrays.items():
                found = read.GetPointData().GetArray(name)
                self.assertIsNotNone(found, name)
                numpy.testing.assert_array_equal(vtk_to_numpy(found), values)
            numpy.testing.assert_array_equal(
                vtk_to_numpy(read.GetCellData().GetArray("RGB")), colors
            )

    def test_values(self):
        """The same cells and values on any number of ranks."""
        source = self.read(self.write("strip.ply", surface(50)))
        self.assertEqual(self.information(source), (51, (0, 25)))

    def test_save(self):
        """Every encoding, from any number of ranks; one file with everything."""
        source = self.read(self.write("strip.ply", surface(20)))
        for encoding in ENCODINGS:
            path = self.folder / f"saved-{ENCODINGS.index(encoding)}.ply"
            self.save(path, source, Encoding=encoding)
            self.assertEqual(self.information(self.read(path)), (21, (0, 10)), encoding)
        points, faces = strip(20)
        expected = [[*p, i] for i, p in enumerate(points)]
        expected += [[len(f), *f, 0.5 * i] for i, f in enumerate(faces)]
        self.assertEqual(self.rows(self.folder / "saved-0.ply"), expected)

    def test_save_data(self):
        """SaveData knows the extension."""
        source = self.read(self.write("strip.ply", surface(20)))
        path = self.folder / "saved.ply"
        simple.SaveData(str(path), source, Encoding="ASCII")
        self.assertEqual(self.information(self.read(path))[0], 21)

    def test_chosen_arrays(self):
        """Only the arrays that were chosen are written."""
        source = self.read(self.write("strip.ply", surface(5)))
        path = self.folder / "chosen.ply"
        self.save(path, source, ChooseArraysToWrite=1, PointDataArrays=[], CellDataArrays=["area"])
        header = path.read_bytes().split(b"end_header")[0].decode()
        self.assertIn("property float area", header)
        self.assertNotIn("number", header)
        again = self.read(path)
        self.assertIsNotNone(again.CellData.GetArray("area"))
        self.assertIsNone(again.PointData.GetArray("number"))

    def test_series(self):
        """Several files are time steps."""
        paths = [self.write(f"strip{i}.ply", surface(3 + i)) for i in range(3)]
        source = self.read(*paths)
        self.assertEqual(list(source.TimestepValues), [0, 1, 2])
        for i in range(3):
            source.UpdatePipeline(i)
            self.assertEqual(self.information(source)[0], 4 + i)

    def test_both_readers(self):
        """ParaView has a reader of its own, which comes second."""
        path = self.write("strip.ply", surface(3))
        source = simple.OpenDataFile(str(path))
        source.UpdatePipeline()
        if camaron_testing.rank_count() == 1:
            self.assertEqual(source.GetDataInformation().GetNumberOfPoints(), 8)
        self.assertEqual(source.GetXMLName(), "CamaronPolygonPLYReader")
        readers = simple.servermanager.vtkSMProxyManager.GetProxyManager().GetReaderFactory()
        session = simple.servermanager.ActiveConnection.Session
        found = readers.GetReaders(str(path), session)
        names = [found.GetString(i) for i in range(1, found.GetNumberOfStrings(), 3)]
        self.assertEqual(names, ["CamaronPolygonPLYReader", "PLYReader"])
        other = self.write("other.ply", b"plywood\n")
        found = readers.GetReaders(str(other), session)
        names = [found.GetString(i) for i in range(1, found.GetNumberOfStrings(), 3)]
        self.assertNotIn("CamaronPolygonPLYReader", names)

    def test_errors(self):
        """One message, and nothing to show."""
        path = self.write("cut.ply", surface(20)[:-9])
        with pipeline.Messages() as messages:
            source = simple.PolygonPLYReader(FileNames=[str(path)])
            source.UpdatePipeline()
        self.assertEqual(len(messages.errors), 1, messages.errors)
        self.assertIn("cut.ply: byte", messages.errors[0])
        self.assertEqual(source.GetDataInformation().GetNumberOfPoints(), 0)

    def test_collected_files(self):
        """Every file of the collection opens in ParaView."""
        folder = self.data("ply/camaron_ascii.ply").parent
        for path in sorted(Path(folder).glob("*.ply")):
            source = self.read(path)
            self.assertEqual(
                source.GetDataInformation().GetNumberOfPoints() == 0, "empty" in path.name, path
            )
            simple.Delete(source)


if __name__ == "__main__":
    camaron_testing.main()
