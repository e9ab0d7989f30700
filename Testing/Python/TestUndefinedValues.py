# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""All criteria on meshes of all formats, and on those of other programs: every undefined value has a correct reason."""

import camaron_testing
import numpy
from camaron.common import pipeline, tables
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataSet

OWN = ("Examples/*.visf", "Readers/*/Testing/Seeds/*")
MESHES = (".visf", ".msh", ".cas", ".m3d", ".cdb", ".ply", ".off", ".tri", ".ts", ".ele")
PATTERNS = (
    "ansys_fluent/*.cas",
    "ansys_fluent/*.msh",
    "m3d/*.m3d",
    "ansys_cdb/*.cdb",
    "ansys_cdb/*.dat",
)
#: Reasons, as the mask writes them.
VALUE, NOT_APPLICABLE, DEGENERATE, INVALID, NO_NEIGHBOR, MISSING, HIGHER_ORDER = range(7)
#: Bits of CellStatus that explain a quotient 0/0, and those that explain a cell without inside and outside.
COLLAPSED = 0x001 | 0x080 | 0x100 | 0x8000 | 0x10000 | 0x40000
NOT_STAR_SHAPED = 0x20000
OPEN = 0x001 | 0x1000 | 0x2000 | 0x4000


def blocks(data):
    if isinstance(data, vtkDataSet):
        return [data]
    items = []
    if isinstance(data, vtkCompositeDataSet):
        iterator = data.NewIterator()
        while not iterator.IsDoneWithTraversal():
            items.append(iterator.GetCurrentDataObject())
            iterator.GoToNextItem()
    return items


class TestUndefinedValues(camaron_testing.TestCase):
    def check(self, data, criteria):
        """Counts of defined and undefined values, after checking the reason of each undefined one."""
        values = lambda name: vtk_to_numpy(data.GetCellData().GetArray(name))
        status = values("CellStatus")
        is_2d_or_3d = ~numpy.isnan(values("VertexCount"))
        self.assertFalse(status[~is_2d_or_3d].any())
        at_boundary = values("IsBoundary") == 1
        is_open_surface = numpy.isin(values("RegionId"), values("RegionId")[at_boundary])
        found = nulls = 0
        for name, criterion in criteria.items():
            array, mask = values(name), values(f"{name}_Undefined")
            is_null = numpy.isnan(array) if array.dtype.kind == "f" else mask == NOT_APPLICABLE
            found += int((~is_null).sum())
            nulls += int(is_null.sum())
            self.assertTrue(numpy.isin(mask[~is_null], (VALUE, HIGHER_ORDER)).all(), name)
            unexplained = is_null & (mask != NOT_APPLICABLE)
            unexplained &= ~((mask == DEGENERATE) & (status & COLLAPSED != 0))
            unexplained &= ~((mask == INVALID) & (status & OPEN != 0))
            no_neighbor = (mask == NO_NEIGHBOR) & at_boundary
            if name.endswith("BoundaryNonOrthogonality"):
                no_neighbor = (mask == NO_NEIGHBOR) & ~at_boundary
            unexplained &= ~no_neighbor
            if name.endswith("SurfaceDihedralAngle"):
                unexplained &= ~((mask == INVALID) & is_open_surface)
            cells = numpy.flatnonzero(unexplained)
            self.assertEqual(
                len(cells),
                0,
                f"{name} of cells {cells[:5]}: {mask[cells[:5]]}, {status[cells[:5]]}",
            )
            if criterion["applies_to"] == "polygons and polyhedra":
                left_out = is_2d_or_3d & (mask == NOT_APPLICABLE) & (status & NOT_STAR_SHAPED == 0)
                self.assertFalse(left_out.any(), name)
            low, high = criterion["range"]
            slack = 1e-9
            healthy = ~is_null & (status & (COLLAPSED | OPEN) == 0)
            if low is not None and not name.startswith("Verdict"):
                self.assertTrue((array[healthy] >= low - slack * (1 + abs(low))).all(), name)
            if high is not None and not name.startswith("Verdict"):
                self.assertTrue((array[healthy] <= high + slack * (1 + abs(high))).all(), name)
        return found, nulls

    def test_every_undefined_value_is_explained(self):
        own = [path for pattern in OWN for path in sorted(camaron_testing.ROOT.glob(pattern))]
        self.assertGreater(len(own), 20)
        paths = [
            path for path in own if path.suffix in MESHES and path.stem[:4] != "bad-"
        ] + self.real(*PATTERNS)
        criteria = tables.known_criteria()
        checked = 0
        for path in paths:
            with self.subTest(path.name):
                source = pipeline.open_mesh(path).source
                quality = simple.ElementQuality(
                    Input=source, Criteria=list(criteria), WriteUndefinedMask=1
                )
                with pipeline.Messages() as messages:
                    data = servermanager.Fetch(quality)
                self.assertEqual(messages.errors, [])
                for block in blocks(data):
                    if block.GetNumberOfCells():
                        found, nulls = self.check(block, criteria)
                        cells = range(block.GetNumberOfCells())
                        if max(block.GetCell(cell).GetCellDimension() for cell in cells) > 1:
                            self.assertGreater(found, block.GetNumberOfCells())
                        checked += 1
                simple.Delete(quality)
                simple.Delete(source)
        self.assertGreater(checked, 10)


if __name__ == "__main__":
    camaron_testing.main()
