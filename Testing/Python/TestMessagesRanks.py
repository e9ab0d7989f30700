# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Messages of readers and filters on any rank are in the notes once, as with one rank."""

from unittest import mock

import camaron_testing
from camaron import check, compare, convert, inspect
from camaron.common import formats, pipeline, reader_choice
from paraview import simple
from vtkmodules.vtkCommonCore import vtkOutputWindow

BALL = camaron_testing.EXAMPLES / "voronoi-ball.visf"
OPEN = "7 cells not closed (an edge has one face or more than two), the first is cell 793"

PIECE = """<VTKFile type="UnstructuredGrid" version="0.1">
<UnstructuredGrid><Piece NumberOfPoints="0" NumberOfCells="0"><Points><DataArray type="Float32"
NumberOfComponents="3" format="ascii"></DataArray></Points><Cells><DataArray type="Int32" Name="connectivity"
format="ascii"></DataArray><DataArray type="Int32" Name="offsets" format="ascii"></DataArray><DataArray
type="UInt8" Name="types" format="ascii"></DataArray></Cells></Piece></UnstructuredGrid></VTKFile>
"""
PIECES = """<VTKFile type="PUnstructuredGrid" version="0.1"><PUnstructuredGrid GhostLevel="0"><PPoints>
<PDataArray type="Float32" NumberOfComponents="3"/></PPoints>
<Piece Source="there.vtu"/><Piece Source="{}.vtu"/></PUnstructuredGrid></VTKFile>
"""


class TestMessagesRanks(camaron_testing.TestCase):
    def make_open_ball(self):
        """The last seven cells, which the last rank reads, lack a face each."""
        points, faces, cells = camaron_testing.read_visf(BALL)
        cells = cells[:-7] + [cell[1:] for cell in cells[-7:]]
        rows = lambda lists: [" ".join(map(str, [len(row), *row])) for row in lists]
        lines = ["2 2", len(points), *(" ".join(map(repr, map(float, p))) for p in points)]
        lines += [len(faces), *rows(faces), 0, len(cells), *rows(cells)]
        path = self.folder / "open.visf"
        path.write_text("\n".join(map(str, lines)) + "\n")
        return path

    def find(self, notes):
        return [note for note in notes if "not closed" in note]

    def test_warnings_of_the_last_rank(self):
        """Seven cells are seven, however many ranks have some of them."""
        path = self.make_open_ball()
        expected = [f"open.visf: {OPEN}"]
        self.assertEqual(self.find(pipeline.open_mesh(path).warnings), expected)
        summary = inspect(path, self.folder / "report", criteria=["Volume"], with_pictures=False)
        self.assertEqual(self.find(summary["notes"]), expected)
        result = check(path, ["Volume > 0"])
        self.assertEqual(self.find(result["notes"]), expected)
        notes = compare(BALL, path, self.folder / "comparison", criteria=["Volume"])["notes"]
        self.assertEqual(self.find(notes), [f"open.visf: {expected[0]}"])
        self.assertEqual(self.find(convert(path, self.folder / "target.visf")), expected)

    def test_seeds(self):
        """Readers of all formats report on several ranks what they report on one."""
        tried = 0
        for own in (f for f in formats.own_formats() if f["reader"]):
            folder = camaron_testing.ROOT / "Readers" / own["name"] / "Testing" / "Seeds"
            for path in sorted(folder.iterdir()):
                if path.name.startswith("bad-") or own["reader"] not in formats.own_readers(path):
                    continue
                with pipeline.Messages() as together:
                    source = reader_choice._make(own["reader"], path)
                    source.UpdatePipeline()
                reader = source.GetClientSideObject().GetReader()
                with pipeline.Messages() as alone:
                    reader.Modified()
                    reader.UpdatePiece(0, 1, 0)
                self.assertEqual(together.errors, alone.errors, path.name)
                self.assertEqual(together.warnings, alone.warnings, path.name)
                tried += 1
                simple.Delete(source)
        self.assertGreater(tried, 30)

    def test_readers_of_paraview(self):
        """An error of another rank than the first is one."""
        (self.folder / "there.vtu").write_text(PIECE)
        path = self.folder / "whole.pvtu"
        path.write_text(PIECES.format("missing"))
        with pipeline.Messages() as messages:
            simple.OpenDataFile(str(path)).UpdatePipeline()
        self.assertRegex(" ".join(messages.errors), "piece 1 cannot be read")
        with self.assertRaisesRegex(RuntimeError, "whole.pvtu: missing.vtu: there is no such file"):
            pipeline.open_mesh(path)
        path.write_text(PIECES.format("there"))
        with pipeline.Messages() as messages:
            simple.OpenDataFile(str(path)).UpdatePipeline()
        self.assertEqual(messages.errors, [])

    def test_texts(self):
        """Each message by itself, also in the messages around, and the loss of the server without any."""
        before = vtkOutputWindow.GetInstance()
        with pipeline.Messages() as around:
            with pipeline.Messages() as messages:
                for message in (b"first", b"\xff", b"third"):
                    vtkOutputWindow.GetInstance().DisplayErrorText(message)
                vtkOutputWindow.GetInstance().DisplayGenericWarningText("a warning")
                self.assertEqual(messages.errors, ["first", pipeline.NOT_UTF8, "third"])
                vtkOutputWindow.GetInstance().DisplayErrorText("fourth")
            with mock.patch.object(pipeline, "is_connected", return_value=False):
                self.assertEqual(pipeline.Messages().errors, [pipeline.LOST])
        for found in (messages, around):
            self.assertEqual(found.errors, ["first", pipeline.NOT_UTF8, "third", "fourth"])
            self.assertEqual(found.warnings, ["a warning"])
        self.assertIs(vtkOutputWindow.GetInstance(), before)


if __name__ == "__main__":
    camaron_testing.main()
