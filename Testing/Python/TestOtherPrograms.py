# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Criteria against programs that others wrote: TetGen's statistics, VTK's Cell Quality and Cell Size."""

import re
import shutil
import subprocess
import unittest

import camaron_testing
import gallery
import numpy
from camaron.common import tables
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON,
    VTK_POLYHEDRON,
    VTK_PYRAMID,
    VTK_QUAD,
    VTK_TETRA,
    VTK_TRIANGLE,
)
from vtkmodules.vtkFiltersVerdict import vtkCellQuality, vtkCellSizeFilter

TETGEN = shutil.which("tetgen")
#: Points of healthy cells; the wedge is left out, whose order for Verdict depends on VTK's version.
CELLS = {
    VTK_TRIANGLE: [(0, 0, 0), (1, 0, 0), (0.5, 0.9, 0)],
    VTK_QUAD: [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)],
    VTK_TETRA: [(0, 0, 0), (1, 0, 0), (0.5, 0.9, 0), (0.5, 0.3, 0.8)],
    VTK_PYRAMID: [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 0.5, 0.7)],
    VTK_HEXAHEDRON: [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))],
}
COPIES = 20
#: Which cells Cell Quality has been told to give another answer for: it knows no such measure.
UNDEFINED = -12345.0


def evaluate(data, names):
    """Values of criteria of a data set, by name."""
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    return evaluate_source(source, names)


def evaluate_source(source, names):
    quality = simple.ElementQuality(Input=source, Criteria=names)
    quality.UpdatePipeline()
    data = camaron_testing.servermanager.Fetch(quality).GetCellData()
    return {name: vtk_to_numpy(data.GetArray(name)) for name in names}


def make_box(path, size):
    """A box of the given size for TetGen."""
    places = [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    faces = [(4, 3, 2, 1), (5, 6, 7, 8), (1, 2, 6, 5), (2, 3, 7, 6), (3, 4, 8, 7), (4, 1, 5, 8)]
    lines = ["8 3 0 0"]
    for number, place in enumerate(places, 1):
        lines.append(f"{number} " + " ".join(str(s * x) for s, x in zip(size, place)))
    lines.append("6 0")
    for face in faces:
        lines += ["1 0", "4 " + " ".join(map(str, face))]
    path.write_text("\n".join([*lines, "0", "0", ""]))


class TestOtherPrograms(camaron_testing.TestCase):
    @unittest.skipUnless(TETGEN, "TetGen is not installed")
    def test_tetgen(self):
        """TetGen's own quality statistics, to the digits that it prints, and the bound it meshed for."""
        bound = 1.5
        make_box(self.folder / "box.poly", (1, 0.7, 0.4))
        run = subprocess.run(
            [TETGEN, f"-pq{bound}a0.0015V", "box.poly"],
            cwd=self.folder,
            capture_output=True,
            text=True,
            timeout=100,
        )
        self.assertIn("Mesh quality statistics", run.stdout, run.stderr)
        names = [
            "Volume",
            "MinEdgeLength",
            "MaxEdgeLength",
            "MaxFaceArea",
            "MinFaceAngle",
            "MaxFaceAngle",
            "MinDihedralAngle",
            "MaxDihedralAngle",
            "TetRadiusEdgeRatio",
        ]
        values = evaluate_source(self.open(self.folder / "box.1.ele"), names)
        self.assertGreater(len(values["Volume"]), 300)
        self.assertEqual(
            len(values["Volume"]), int(re.search(r"Mesh tetrahedra: (\d+)", run.stdout).group(1))
        )
        printed = {
            "Smallest volume": values["Volume"].min(),
            "Largest volume": values["Volume"].max(),
            "Shortest edge": values["MinEdgeLength"].min(),
            "Longest edge": values["MaxEdgeLength"].max(),
            "Smallest facangle": values["MinFaceAngle"].min(),
            "Largest facangle": values["MaxFaceAngle"].max(),
            "Smallest dihedral": values["MinDihedralAngle"].min(),
            "Largest dihedral": values["MaxDihedralAngle"].max(),
        }
        read = lambda label: float(re.search(re.escape(label) + r":\s+(\S+)", run.stdout).group(1))
        for label, ours in printed.items():
            self.assertAlmostEqual(ours / read(label), 1, delta=1e-4, msg=label)
        # TetGen's aspect ratio is the longest edge divided by the smallest height, that is 3 V / largest
        # face; but of the four heights version 1.5 looks at three.
        aspect = values["MaxEdgeLength"] * values["MaxFaceArea"] / (3 * values["Volume"])
        self.assertLessEqual(read("Smallest asp.ratio"), aspect.min() * (1 + 1e-4))
        self.assertLessEqual(read("Largest asp.ratio"), aspect.max() * (1 + 1e-4))
        self.assertGreater(read("Largest asp.ratio"), numpy.sort(aspect)[-5])
        # The faces of a box meet at right angles, so that TetGen keeps its promise everywhere, but for what version 1.6
        # does after it.
        ratios = values["TetRadiusEdgeRatio"]
        self.assertGreater((ratios <= bound * (1 + 1e-9)).mean(), 0.98)
        self.assertLess(ratios.max(), 1.1 * bound)
        self.assertAlmostEqual(values["Volume"].sum(), 1 * 0.7 * 0.4, delta=1e-12)

    def test_cell_quality(self):
        """All measures of VTK's Cell Quality, on valid cells; undefined where VTK has none."""
        random = numpy.random.default_rng(5)
        points, cells = [], []
        for kind, places in CELLS.items():
            for _ in range(COPIES):
                noise = random.uniform(-0.1, 0.1, (len(places), 3))
                if kind in (VTK_TRIANGLE, VTK_QUAD):
                    noise[:, 2] = 0
                cells.append((kind, range(len(points), len(points) + len(places))))
                points += [tuple(p) for p in numpy.array(places) + noise]
        grid = gallery.make_grid(points, cells)
        names = [name for name in tables.known_criteria() if name.startswith("Verdict")]
        # Those with the mean size are 0 in Cell Quality of VTK before 9.6; TestVerdict takes Mesh Quality.
        names = [name for name in names if "Size" not in name]
        ours = evaluate(grid, names)
        compared = 0
        for name in names:
            quality = vtkCellQuality()
            choose = getattr(quality, "SetQualityMeasureTo" + name[len("Verdict") :], None)
            if choose is None:
                continue  # in Mesh Quality, or in no filter
            choose()
            quality.SetUndefinedQuality(UNDEFINED)
            quality.SetUnsupportedGeometry(UNDEFINED)
            quality.SetInputData(grid)
            quality.Update()
            theirs = vtk_to_numpy(quality.GetOutput().GetCellData().GetArray("CellQuality"))
            for first in range(0, len(cells), COPIES):
                part = slice(first, first + COPIES)
                if (theirs[part] == UNDEFINED).all():
                    continue
                compared += 1
                numpy.testing.assert_allclose(
                    ours[name][part], theirs[part], rtol=1e-9, atol=1e-9, err_msg=name
                )
        self.assertGreater(compared, 60)

    def test_hull_of_cell_size(self):
        """VTK's Cell Size fills the notch of a polyhedron; Volume does not."""
        corners = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
        points = [(x, y, z) for z in (0, 1) for x, y in corners]
        faces = [tuple(range(5, -1, -1)), tuple(range(6, 12))]
        faces += [(i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6) for i in range(6)]
        grid = gallery.make_grid(points, [(VTK_POLYHEDRON, faces)])
        size = vtkCellSizeFilter()
        size.SetInputData(grid)
        size.Update()
        theirs = size.GetOutput().GetCellData().GetArray("Volume").GetValue(0)
        self.assertAlmostEqual(theirs, 3.5, delta=1e-9, msg="the convex hull")
        self.assertAlmostEqual(evaluate(grid, ["Volume"])["Volume"][0], 3, delta=1e-12)


if __name__ == "__main__":
    camaron_testing.main()
