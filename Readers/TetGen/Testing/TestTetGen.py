# ranks: 1 3
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""TetGen files in ParaView: opening any of them, saving, series, errors, on any number of ranks."""

from pathlib import Path

from paraview import simple

import camaron_testing


def strip(cells):
    """Files of a strip of tetrahedra, each with its first three vertices as a face."""
    nodes = [f"{cells + 3} 3 1 1"]
    for i in range(cells + 3):
        step = i // 3
        x, y, z = step + (i % 3 == 0), step + (i % 3 == 1), step + (i % 3 == 2)
        nodes.append(f"{i + 1} {x} {y} {z} {0.5 * i} {i % 2}")
    elements = [f"{cells} 4 1"]
    neighbors = [f"{cells} 4"]
    faces = [f"{cells} 1"]
    for i in range(cells):
        elements.append(f"{i + 1} {i + 1} {i + 2} {i + 3} {i + 4} {i % 3}")
        neighbors.append(f"{i + 1} {i + 2 if i + 1 < cells else -1} -1 -1 {i or -1}")
        faces.append(f"{i + 1} {i + 1} {i + 2} {i + 3} {i % 5}")
    return {"node": nodes, "ele": elements, "neigh": neighbors, "face": faces}


class TestTetGen(camaron_testing.FormatTestCase):
    def save(self, name, cells):
        """Writes the files of a strip; returns their path without extension."""
        for extension, lines in strip(cells).items():
            (self.folder / f"{name}.{extension}").write_text("\n".join(lines) + "\n")
        return str(self.folder / name)

    def test_any_file_opens_the_mesh(self):
        base = self.save("strip.1", 50)
        for extension in ("ele", "node", "neigh", "face"):
            source = self.open(f"{base}.{extension}")
            self.assertEqual(type(source).__name__, "TetGenReader")
            self.assertEqual(self.cells(source), 50)
            arrays = source.CellData.keys()
            self.assertEqual("Region" in arrays, extension != "face")
            self.assertEqual("Neighbors" in arrays, extension == "neigh")
            self.assertEqual("BoundaryMarker" in arrays, extension == "face")
            self.assertIn("attr_0", source.PointData.keys())
            self.assertEqual(source.PointData["attr_0"].GetRange(), (0.0, 26.0))

    def test_every_rank_has_its_share_of_arrays(self):
        source = self.open(self.save("strip", 60) + ".neigh")
        for region in range(3):
            part = simple.Threshold(Input=source, Scalars=["CELLS", "Region"])
            part.LowerThreshold = part.UpperThreshold = region
            self.assertEqual(self.cells(part), 20)

    def test_series(self):
        names = [self.save(f"step.{i}", 10 + i) + ".ele" for i in range(3)]
        source = simple.OpenDataFile(names)
        self.assertEqual(list(source.TimestepValues), [0, 1, 2])
        for time in (2, 0, 1):
            source.UpdatePipeline(time)
            self.assertEqual(self.cells(source), 10 + time)

    def test_save_and_open(self):
        base = self.save("strip", 60)
        source = self.open(f"{base}.ele")
        for first in (0, 1):
            target = self.folder / f"saved{first}.node"
            simple.SaveData(str(target), source, FirstId=first)
            # Seams between ranks are gone: as many of everything as in the original.
            nodes = target.read_text().splitlines()
            elements = target.with_suffix(".ele").read_text().splitlines()
            self.assertEqual((nodes[0], elements[0]), ("63 3 1 1", "60 4 1"))
            self.assertEqual(nodes[1].split(), [str(first), "1", "0", "0", "0", "0"])
            last = [str(i + first) for i in (59, 59, 60, 61, 62)] + ["2"]
            self.assertEqual(elements[60].split(), last)
            again = self.open(target)
            self.assertEqual(self.cells(again), 60)
            self.assertIn("Region", again.CellData.keys())

    def test_save_surface(self):
        target = str(self.folder / "sphere.ele")
        simple.SaveData(target, simple.Sphere())
        self.assertEqual(self.cells(self.open(target)), 96)

    def test_a_missing_file_is_named(self):
        base = Path(self.save("orphan", 5))
        base.with_name("orphan.node").unlink()
        source = simple.OpenDataFile(str(base) + ".ele")
        self.assertIsNotNone(source)
        source.UpdatePipeline()
        self.assertEqual(source.GetDataInformation().GetNumberOfPoints(), 0)

    def test_collected_files(self):
        for name, cells in (
            ("camaron_gen4096.1.ele", 27098),
            ("foam_beam.1.face", 1617),
            ("polylla2d_pikachu.1.neigh", 531),
            ("tetgen_example.1.edge", 165),
            ("tetgen_example.poly", 24),
            ("tetgen_o2_zero.1.ele", 795),
            ("tetgen_slit-1.smesh", 13),
        ):
            source = self.open(self.data("tetgen/" + name))
            self.assertEqual(type(source).__name__, "TetGenReader")
            self.assertEqual(self.cells(source), cells, name)


if __name__ == "__main__":
    camaron_testing.main()
