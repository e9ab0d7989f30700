# ranks: 1 2
# SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every format in which camaron.convert writes a mesh can be read again."""

import os
import subprocess

import camaron_testing
from camaron import convert
from camaron.common import formats, pipeline
from paraview import simple
from vtkmodules.vtkCommonDataModel import (
    vtkMultiBlockDataSet,
    vtkPartitionedDataSet,
    vtkPartitionedDataSetCollection,
)
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter, vtkImageDataToPointSet
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkIOParallelXML import (
    vtkXMLPartitionedDataSetCollectionWriter,
    vtkXMLPartitionedDataSetWriter,
)
from vtkmodules.vtkIOXML import vtkXMLDataSetWriter, vtkXMLMultiBlockDataWriter

#: Formats that ParaView does not read as a mesh, or not at all.
NOT_READ = {".csv", ".geo", ".json", ".tsv", ".txt"}
#: Formats of other data: images of one slice, tables, trees, and a crash that convert prevents.
OF_OTHER_DATA = {".gen", ".htg", ".jpg", ".phtg", ".png", ".pvtr", ".pvtt", ".vthb", ".vtr", ".vtt"}
#: Formats of surfaces, for which the boundary of a volume is written.
SURFACES = {".obj", ".off", ".ply", ".pvtp", ".stl", ".tri", ".vtp"}
#: What is said of a mesh that a format does not store.
REFUSED = "cannot store|expected a 2D mesh|can be read|needs MPI|has none|one process only"
#: Formats that need MPI.
PARALLEL = {".cgns"}
#: Formats that ranks write together.
OF_RANKS = {
    ".cdb",
    ".m3d",
    ".msh",
    ".node",
    ".off",
    ".ply",
    ".pvd",
    ".pvti",
    ".pvtp",
    ".pvts",
    ".pvtu",
    ".stl",
    ".tri",
}
OF_RANKS |= {".ts", ".visf", ".vtm", ".vtpc", ".vtpd"}

IN_PVPYTHON = """
from camaron import convert
convert("SOURCE", "TARGET")
"""


class TestAllFormats(camaron_testing.TestCase):
    def make_sources(self):
        """Volumes, triangles, an image, a structured grid, and blocks, with the number of cells of each."""
        image = vtkRTAnalyticSource()
        image.SetWholeExtent(0, 3, 0, 3, 0, 3)
        structured = vtkImageDataToPointSet()
        structured.SetInputConnection(image.GetOutputPort())
        volume = vtkAppendFilter()
        volume.AddInputConnection(image.GetOutputPort())
        sphere = vtkSphereSource()
        tetrahedra = vtkDataSetTriangleFilter()
        tetrahedra.SetInputConnection(image.GetOutputPort())
        made = {
            "v.vtu": volume,
            "tets.vtu": tetrahedra,
            "t.vtp": sphere,
            "i.vti": image,
            "s.vts": structured,
        }
        for name, source in made.items():
            writer = vtkXMLDataSetWriter()
            writer.SetInputConnection(source.GetOutputPort())
            writer.SetFileName(str(self.folder / name))
            writer.Write()
        blocks, pieces, collection = (
            vtkMultiBlockDataSet(),
            vtkPartitionedDataSet(),
            vtkPartitionedDataSetCollection(),
        )
        for i, source in enumerate((volume, tetrahedra)):
            blocks.SetBlock(i, source.GetOutput())
            pieces.SetPartition(i, source.GetOutput())
        collection.SetPartitionedDataSet(0, pieces)
        composite = []
        for name, data, writer in (
            ("b.vtm", blocks, vtkXMLMultiBlockDataWriter()),
            ("p.vtpd", pieces, vtkXMLPartitionedDataSetWriter()),
            ("c.vtpc", collection, vtkXMLPartitionedDataSetCollectionWriter()),
        ):
            composite.append(self.folder / name)
            if hasattr(writer, "SetController"):
                writer.SetController(None)
            writer.SetInputDataObject(data)
            writer.SetFileName(str(composite[-1]))
            writer.Write()
        cells = {name: source.GetOutput().GetNumberOfCells() for name, source in made.items()}
        flange = camaron_testing.EXAMPLES / "flange.visf"
        both = cells["v.vtu"] + cells["tets.vtu"]
        return {
            flange: 4080,
            **{self.folder / name: count for name, count in cells.items()},
            **dict.fromkeys(composite, both),
        }

    def check(self, source, target, cells):
        """That a file has the cells, or those of the boundary, or that it is not empty."""
        suffix = target.suffix
        if suffix in NOT_READ:
            self.assertGreater(target.stat().st_size, 0, target)
            return
        opened = pipeline.open_mesh(target)
        real = pipeline.without_ghosts(opened.source)
        real.UpdatePipeline()
        counted = pipeline.data_information(real).GetNumberOfCells()
        simple.Delete(real)
        if real is not opened.source:
            simple.Delete(opened.source)
        self.assertGreater(counted, 0, target)
        if suffix not in SURFACES:
            self.assertEqual(counted, cells, target)

    def test_formats(self):
        pipeline.load_plugin()
        sources = self.make_sources()
        written, alone = set(), set()
        for suffix in sorted(formats.written_extensions()):
            for source, cells in sources.items():
                target = self.folder / f"{source.stem}-{suffix[1:]}{suffix}"
                try:
                    convert(source, target)
                except (RuntimeError, ValueError) as error:
                    if suffix not in OF_OTHER_DATA:
                        self.assertRegex(str(error), REFUSED)
                    self.assertFalse(target.exists())
                    if "one process only" in str(error):
                        alone.add(suffix)
                    continue
                self.check(source, target, cells)
                written.add(suffix)
                break
        left = formats.written_extensions() - OF_OTHER_DATA - written - alone
        if pipeline.rank_count() == 1:
            self.assertEqual((left, alone), (PARALLEL, set()))
        else:
            self.assertEqual(left, set())
            self.assertLessEqual(OF_RANKS, written)

    def test_parallel_format(self):
        """The writer of CGNS works where there is MPI."""
        source, target = camaron_testing.EXAMPLES / "flange.visf", self.folder / "alone.cgns"
        script = self.folder / "script.py"
        script.write_text(IN_PVPYTHON.replace("SOURCE", str(source)).replace("TARGET", str(target)))
        subprocess.run(
            [os.environ["PVPYTHON"], str(script)],
            env=camaron_testing.environment_alone(),
            check=True,
            timeout=120,
        )
        self.check(source, target, 4080)


if __name__ == "__main__":
    camaron_testing.main()
