# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Mesh Inspection of blocks: arrays that only some have, and what the MultiBlock Inspector sets, are as on Surface."""

import camaron_testing
import rank_meshes
import TestClientServer
from inspection_testing import difference, make_view, picture, selected, turn
from mesh_parts import producer
from paraview import simple
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet,
    vtkMultiBlockDataSet,
    vtkPartitionedDataSetCollection,
)


def parts():
    """Sources of three adjacent meshes: one with all arrays, one with its ids alone, and a round surface."""
    wavelet = simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4])
    first = simple.PointAndCellIds(Input=simple.Tetrahedralize(Input=wavelet))
    moved = simple.Calculator(
        Input=first, CoordinateResults=1, Function="coords + 9*jHat", ResultArrayName="Unused"
    )
    second = simple.PassArrays(Input=moved, PointDataArrays=[], CellDataArrays=["CellIds"])
    third = simple.Sphere(Center=[9, 0, 0], Radius=4, ThetaResolution=20, PhiResolution=20)
    return first, second, third


# Scripts of sources that give each process of a server something else.
IN_PROCESSES = """
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_VOXEL, vtkUnstructuredGrid
from vtkmodules.vtkParallelCore import vtkMultiProcessController

controller = vtkMultiProcessController.GetGlobalController()
process, processes = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
"""
SLABS = (
    IN_PROCESSES
    + """
for block in range(3):
    slabs, points = vtkUnstructuredGrid(), vtkPoints()
    slab, height, own = vtkDoubleArray(), vtkDoubleArray(), vtkDoubleArray()
    for z in range(process, 9, processes):
        first = points.GetNumberOfPoints()
        for corner in range(50):
            x, y = corner % 5, corner // 5 % 5
            points.InsertNextPoint(block + x / 4, y / 4, (2 * z + corner // 25) / 8)
            height.InsertNextValue(10 * block + y)
        for cube in range(16):
            corner = first + cube % 4 + 5 * (cube // 4)
            corners = [corner + i for i in (0, 1, 5, 6, 25, 26, 30, 31)]
            slabs.InsertNextCell(VTK_VOXEL, 8, corners)
            slab.InsertNextValue(z)
            own.InsertNextValue(cube % 4)
    slabs.SetPoints(points)
    slab.SetName("Slab")
    slabs.GetCellData().AddArray(slab)
    own.SetName("Own%d" % block)
    slabs.GetCellData().AddArray(own)
    height.SetName("Height")
    slabs.GetPointData().AddArray(height)
    output.SetBlock(block, slabs)
"""
)
CUBES = (
    IN_PROCESSES
    + """
def cube(x):
    points = vtkPoints()
    for corner in range(8):
        points.InsertNextPoint(2 * x + corner % 2, corner // 2 % 2, corner // 4)
    grid = vtkUnstructuredGrid()
    grid.SetPoints(points)
    grid.InsertNextCell(VTK_VOXEL, 8, range(8))
    return grid
"""
)
EMPTY_BUT_FIRST = (
    CUBES
    + """
if process == 0:
    output.SetBlock(0, cube(0))
    output.SetBlock(1, cube(1))
"""
)
PIECES = (
    CUBES
    + """
owners = [0, 0, 0] if processes == 1 else [1, 2, 2]
pieces = [cube(x) for x in range(3) if owners[x] == process]
result = self.GetOutputDataObject(0)
result.SetNumberOfPartitions(len(pieces))
for i, piece in enumerate(pieces):
    result.SetPartition(i, piece)
"""
)


@camaron_testing.require_display()
class TestInspectionBlocks(camaron_testing.TestCase):
    serve = TestClientServer.TestClientServer.serve

    def tree(self):
        """A list of the blocks A, B and C, of which C is a list of an empty block and one more."""
        first, second, third = (self.fetch(part) for part in parts())
        inner = vtkMultiBlockDataSet()
        inner.SetNumberOfBlocks(2)
        inner.SetBlock(1, second)
        blocks = vtkMultiBlockDataSet()
        for i, block in enumerate((first, third, inner)):
            blocks.SetBlock(i, block)
            blocks.GetMetaData(i).Set(vtkCompositeDataSet.NAME(), "ABC"[i])
        return producer(blocks)

    def collection(self):
        """Two blocks, the first of which has two pieces."""
        first, second, third = (self.fetch(part) for part in parts())
        blocks = vtkPartitionedDataSetCollection()
        blocks.SetPartition(0, 0, first)
        blocks.SetPartition(0, 1, second)
        blocks.SetPartition(1, 0, third)
        return producer(blocks)

    def compare(self, view, source, color=None, tolerance=0.004, **properties):
        """The picture, which is that of Surface."""
        pictures = []
        for representation in ("Surface", "Mesh Inspection"):
            display = simple.Show(source, view)
            display.SetRepresentationType(representation)
            display.DrawEdges = 0
            if color or display.ColorArrayName[1]:
                simple.ColorBy(display, color)
                display.SetScalarBarVisibility(view, False)
            for name, value in properties.items():
                setattr(display, name, value)
            turn(view)
            pictures.append(picture(view))
        self.assertLess(difference(*pictures), tolerance, (color, properties))
        self.assertGreater(difference(pictures[0], pictures[0] * 0 + 255), 0.1)
        return pictures[1]

    def test_arrays_of_some_blocks(self):
        """They color the blocks that have them; the others have the solid color, or the color of NaN."""
        view = make_view()
        self.addCleanup(simple.ResetSession)
        for source in (self.tree(), self.collection()):
            simple.HideAll(view)
            simple.UpdatePipeline(proxy=source)
            self.compare(view, source)
            for color in (("POINTS", "RTData"), ("CELLS", "CellIds"), ("POINTS", "PointIds")):
                solid = self.compare(view, source, color, UseNanColorForMissingArrays=0)
                null = self.compare(view, source, color, UseNanColorForMissingArrays=1)
                self.assertGreater(difference(solid, null), 0.05)
            self.compare(view, source, ("FIELD", "vtkBlockColors"))

    def test_looks_of_blocks(self):
        """Hidden, colored and translucent blocks; hidden ones are not selected, and cannot be cut open."""
        view = make_view()
        self.addCleanup(simple.ResetSession)
        source = self.tree()
        simple.UpdatePipeline(proxy=source)
        whole = self.compare(view, source)
        names = {"A": "/Root/A", "B": "/Root/B", "C": "/Root/C"}
        colors = [names["A"], "1", "0", "0", names["C"], "0", "0.5", "0"]
        for properties in (
            {"BlockColors": colors},
            {"BlockOpacities": [names["B"], "0.3"]},
            {"BlockSelectors": [names["A"], names["C"]]},
        ):
            self.assertGreater(difference(whole, self.compare(view, source, **properties)), 0.02)
        found = {}
        display = simple.GetDisplayProperties(source, view)
        for representation in ("Surface", "Mesh Inspection"):
            display.SetRepresentationType(representation)
            display.BlockOpacities = []
            found[representation] = selected(view, source, "cells")
        self.assertGreater(len(found["Surface"]), 100)
        self.assertEqual({block for block, _, _ in found["Surface"]}, {1, 5})
        self.assertEqual(*found.values())
        # With all of the other blocks cut away, nothing is left.
        display.CutBy, display.CutShape = "Centroid", "Box"
        display.CutShape.Position, display.CutShape.Length = [-9, -9, -9], [14, 30, 18]
        self.assertEqual(difference(whole * 0 + 255, picture(view)), 0)
        display.BlockSelectors = ["/"]
        self.assertGreater(difference(whole * 0 + 255, picture(view)), 0.02)
        # The cut face of a red block, which fills the view, is red.
        display.BlockColors, display.DisableLighting = ["/", "1", "0", "0"], 1
        display.CutBy, display.CutShape, display.CutKeeps = "Exactly", "Sphere", "Inside"
        display.CutShape.Center, display.CutShape.Radius = [0, 0, 0], 3
        simple.ResetCamera(view)
        image = picture(view)
        red = (image[:, :, 0] > 200) & (image[:, :, 1:].max(axis=2) < 50)
        self.assertGreater(red.sum(), 1000)
        self.assertGreater(red.sum(), 0.95 * (image.min(axis=2) < 128).sum())

    def test_pieces_of_a_block(self):
        """Faces between pieces are not on the outside, be they partitions or in one data set with global ids."""
        partitions = vtkPartitionedDataSetCollection()
        for i in range(3):
            partitions.SetPartition(0, i, rank_meshes.make_part("mixed", i, 3))
        view = make_view()
        self.addCleanup(simple.ResetSession)
        pictures = []
        for mesh in (
            rank_meshes.make_part("mixed", 0, 1),
            partitions,
            rank_meshes.make_part("mixed", 0, 1, global_ids=True, appended=3),
        ):
            simple.HideAll(view)
            display = simple.Show(producer(mesh), view, "UnstructuredGridRepresentation")
            display.SetRepresentationType("Mesh Inspection")
            display.DrawEdges, display.Opacity = 0, 0.3
            turn(view)
            pictures.append(picture(view))
        self.assertGreater(difference(pictures[0], pictures[0] * 0 + 255), 0.1)
        for image in pictures[1:]:
            self.assertLess(difference(pictures[0], image, 2), 0.002)

    def test_servers(self):
        """Of three processes: what is drawn there, and here from what is sent over, is what is drawn alone."""
        slabs, uneven = self.draw_slabs(), self.draw_uneven()
        self.serve(3)
        self.check_pictures(slabs, self.draw_slabs())
        for threshold in (0, 100000):
            with self.subTest(threshold=threshold):
                self.check_pictures(uneven, self.draw_uneven(threshold))
                self.compare_parts(threshold)
        simple.Disconnect()

    def check_pictures(self, alone, shared):
        for name, image in alone.items():
            with self.subTest(name):
                self.assertLess(difference(image, shared[name]), 0.01)
                self.assertGreater(difference(image, image * 0 + 255), 0.05)

    def compare_parts(self, threshold):
        """Blocks as on Surface."""
        blocks = simple.GroupDatasets(Input=list(parts()))
        blocks.BlockNames = ["A", "B", "C"]
        simple.UpdatePipeline(proxy=blocks)
        view = make_view()
        view.RemoteRenderThreshold = threshold
        self.compare(view, blocks, ("POINTS", "RTData"))
        self.compare(view, blocks, None, BlockColors=["/Root/A", "1", "0", "0"])
        self.compare(view, blocks, None, BlockSelectors=["/Root/B", "/Root/C"])
        self.compare(view, blocks, None, 0.02, BlockOpacities=["/Root/C", "0.3"])
        simple.Delete(view)

    def draw_uneven(self, threshold=0):
        """Pictures of two blocks that only one process has, and of one block of which one has no, one, and two pieces."""
        found = {}
        scripts = {"vtkMultiblockDataSet": EMPTY_BUT_FIRST, "vtkPartitionedDataSet": PIECES}
        for kind, script in scripts.items():
            source = simple.ProgrammableSource(OutputDataSetType=kind, Script=script)
            view = make_view()
            view.RemoteRenderThreshold = threshold
            display = simple.Show(source, view)
            display.SetRepresentationType("Mesh Inspection")
            turn(view)
            found[kind, "solid"] = picture(view)
            simple.ColorBy(display, ("FIELD", "vtkBlockColors"))
            display.SetScalarBarVisibility(view, False)
            found[kind, "blocks"] = picture(view)
            display.Opacity = 0.5
            if kind == "vtkMultiblockDataSet":
                display.BlockSelectors = ["/Root/Block0"]
            found[kind, "clear"] = picture(view)
            simple.Delete(view)
        return found

    def draw_slabs(self):
        """Touching blocks whose slabs are distributed over the processes have the same depth order as on one process."""
        slabs = simple.ProgrammableSource(OutputDataSetType="vtkMultiblockDataSet", Script=SLABS)
        view = make_view()
        view.RemoteRenderThreshold = 0
        display = simple.Show(slabs, view, "UnstructuredGridRepresentation")
        display.SetRepresentationType("Mesh Inspection")
        display.DrawEdges = 0
        turn(view)
        found = {}

        def draw(name, color, **properties):
            simple.ColorBy(display, color)
            display.SetScalarBarVisibility(view, False)
            for key, value in properties.items():
                setattr(display, key, value)
            found[name] = picture(view)

        draw("cells", ("CELLS", "Slab"), Opacity=0.4)
        draw("points", ("POINTS", "Height"))
        draw("solid where there is no array", ("CELLS", "Own1"), UseNanColorForMissingArrays=0)
        draw("blocks", ("FIELD", "vtkBlockColors"))
        draw("one hidden", ("CELLS", "Slab"), BlockSelectors=["/Root/Block0", "/Root/Block2"])
        clear = ["/Root/Block2", "0.3"]
        draw("one clear", ("CELLS", "Slab"), BlockSelectors=["/"], Opacity=1, BlockOpacities=clear)
        display.CutBy, display.CutShape = "Centroid", "Sphere"
        draw("glass", ("CELLS", "Slab"), BlockOpacities=[], GlassShell=1)
        return found


if __name__ == "__main__":
    camaron_testing.main()
